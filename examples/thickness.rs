//! Thickness: how much wall a beam passes in a pipe, from the pairs in which crossings come.

use raylet::{Crossing, Cylinder, Hits, Range, Ray, UnitVec3, Vec3};

/// The length of the line inside of a solid.
fn inside(hits: &Hits<f64>) -> f64 {
    let signed = |crossing| if crossing == Crossing::Exit { 1.0 } else { -1.0 };
    hits.iter().filter(|hit| hit.crossing != Crossing::Touch).map(|hit| signed(hit.crossing) * hit.t).sum()
}

pub fn main() -> Result<(), raylet::Error> {
    // Outer radius 30 mm, wall 2 mm; the beam is moved across the pipe.
    let (outer, inner) = (Cylinder::infinite(30.0)?, Cylinder::infinite(28.0)?);
    for across in [0.0, 10.0, 20.0, 27.0, 28.0, 29.0, 29.99, 30.0, 31.0] {
        // A whole line: crossings pair up wherever it starts.
        let beam = Ray::new(Vec3::new(-50.0, 0.0, across), UnitVec3::X)?.with_range(Range::line());
        let wall = inside(&outer.hits(&beam)) - inside(&inner.hits(&beam));
        println!("{across:6.2} mm beside the axis: {wall:7.3} mm of wall");
        let half_chord = |radius: f64| (radius * radius - across * across).max(0.0).sqrt();
        assert!((wall - 2.0 * (half_chord(30.0) - half_chord(28.0))).abs() < 1e-9);
    }
    Ok(())
}
