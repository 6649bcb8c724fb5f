//! `Stable` in `f32` beside `Exact`: solids of any size and shape, placed anyhow, and rays with very small components,
//! that start next to the surface or depart from it. (The workloads of the oracle have solids of chosen sizes, whose
//! sums and differences are often exact.)

use raylet::tier::{Exact, Stable};
use raylet::{
    Affine, Capsule, Cone, Crossing, Cuboid, Cylinder, Frame, Hit, Hits, Leaving, Primitive, Range, Ray, Rectangle,
    Shape, SizeError, Sphere, Triangle, UnitVec3, Vec3,
};
use support::amount::times;
use support::laws::ranges_next_to;
use support::random::{Random, add, dot, scale};

/// The units in the last place of `t` that `Stable` may be off; the test prints the most that it finds.
const UNITS: f64 = 16.0;

/// Between `1 / most` and `most`, its logarithm evenly spread.
fn ratio(random: &mut Random, most: f64) -> f64 {
    random.between(-most.log2(), most.log2()).exp2()
}

fn solid(random: &mut Random, size: f64) -> Result<Primitive<f32>, SizeError> {
    let mut any = || (size * ratio(random, 8.0)) as f32;
    let (a, b, c) = (any(), any(), any());
    let slope = ratio(random, 8.0) as f32;
    let kind = random.below(11);
    if kind == 9 {
        let mut vertex =
            || Vec3::from(random.direction().map(|component| (component * size * ratio(random, 8.0)) as f32));
        if let Ok(triangle) = Triangle::new(vertex(), vertex(), vertex()) {
            return Ok(triangle.into());
        }
    }
    Ok(match kind {
        0 => Sphere::new(a)?.into(),
        1 => Cylinder::infinite(a)?.into(),
        2 => Cylinder::capped(a, b)?.into(),
        3 => Capsule::new(a, b)?.into(),
        4 => Cone::nappe(slope)?.into(),
        7 => Cuboid::new(a, b, c)?.into(),
        8 => Rectangle::new(a, b)?.into(),
        5 => Cone::frustum(a, b, c)?.into(),
        10 => Cone::capped(slope, a)?.into(),
        _ => Cone::double(slope)?.into(),
    })
}

/// A vector of which some components are up to `2^90` times smaller than the others.
fn uneven(random: &mut Random) -> [f64; 3] {
    let small = random.pick(&[0.0, 4.0, 20.0, 60.0, 90.0]);
    random.direction().map(|component| {
        if random.below(2) == 0 { component * (-random.between(0.0, small + 1e-9)).exp2() } else { component }
    })
}

/// The shape, placed, and where it stands; `None` if the matrix has no inverse that fits.
fn placed(random: &mut Random, shape: Shape<f32>, size: f64) -> Option<(Shape<f32>, [f64; 3])> {
    let position = random.direction().map(|component| component * size * ratio(random, 4096.0));
    let at = Vec3::from_f64(position).ok()?;
    let unit = |v: [f64; 3]| UnitVec3::from_f64(v).ok();
    Some(match random.below(4) {
        0 => (shape, [0.0; 3]),
        1 => (shape.placed(Frame::at(at).ok()?), position),
        2 => (shape.placed(Frame::looking(at, unit(random.direction())?, unit(random.direction())?).ok()?), position),
        _ => {
            let flat = random.pick(&[1.0, 1e-2, 1e-4]);
            let mut axis = |long: f64| Vec3::from_f64(scale(random.direction(), long)).ok();
            (shape.placed(Affine::new(at, [axis(1.0)?, axis(flat)?, axis(0.6)?]).ok()?), position)
        }
    })
}

/// A shape, a ray at it, and about how large the shape is. The ray comes from afar, or from next to its surface, or
/// departing from there.
fn drawn(random: &mut Random) -> Option<(Shape<f32>, Ray<f32>, f64)> {
    let spread = random.pick(&[1.0, 8.0, 30.0, 60.0]);
    let size = random.between(-spread, spread).exp2();
    let shape = Shape::new(solid(random, size).ok()?);
    let (shape, position) = placed(random, shape, size)?;
    let direction = UnitVec3::<f32>::from_f64(uneven(random)).ok()?;
    let target = random.direction().map(|component| component * size * 2.0);
    let back = scale(direction.to_f64(), -size * random.between(-2.0, 10.0).exp2());
    let from = add(target, back).map(|component| if random.below(8) == 0 { 0.0 } else { component });
    let ray = Ray::new(Vec3::from_f64(add(from, position)).ok()?, direction).ok()?.with_range(Range::line());
    let kind = random.below(4);
    if kind < 2 {
        return Some((shape, ray, size));
    }
    let hit = shape.nearest_at::<Exact>(&ray)?;
    let surface = shape.surface(&ray, &hit);
    let (point, normal) = (surface.point(), surface.normal().to_f64());
    if kind == 2 {
        // Anyhow, or nearly along a generator.
        let near = scale(random.direction(), size * (-random.between(1.0, 30.0)).exp2());
        let origin = Vec3::from_f64(add(point.to_f64(), near)).ok()?;
        let off = scale(random.direction(), (-random.between(4.0, 24.0)).exp2());
        let generator = UnitVec3::from_f64(add(surface.tangents().1.to_f64(), off)).ok()?;
        let direction = if random.below(2) == 0 { direction } else { generator };
        return Some((shape, Ray::new(origin, direction).ok()?.with_range(Range::line()), size));
    }
    // At any angle, or nearly along the surface.
    let along = random.direction();
    let left = if random.below(2) == 0 { 1.0 } else { (-random.between(0.0, 16.0)).exp2() };
    let along = add(along, scale(normal, (left - 1.0) * dot(along, normal)));
    let direction = UnitVec3::from_f64(along).ok()?;
    let leaving = if dot(direction.to_f64(), normal) > 0.0 { Leaving::Outwards } else { Leaving::Inwards };
    Some((shape, Ray::new(point, direction).ok()?.departing(surface.departure(0, leaving)), size))
}

/// Whether there is a touch, or a chord shorter than a millionth of the solid or than some units of `t`: rounding may
/// decide it.
fn touches(hits: &Hits<f32>, size: f64) -> bool {
    let is_short = |pair: &[Hit<f32>]| {
        let least = (size * 1e-6).max(f64::from(pair[1].t.abs() * f32::EPSILON) * 4.0);
        f64::from(pair[1].t) - f64::from(pair[0].t) <= least
    };
    hits.iter().any(|hit| hit.crossing == Crossing::Touch) || hits.windows(2).any(is_short)
}

/// How many units `Stable` is off at a solid of this size; infinitely many if its hits are others. `None` if there is
/// no hit, or if rounding may decide one.
pub(crate) fn off(shape: &Shape<f32>, ray: &Ray<f32>, size: f64) -> Option<f64> {
    let (stable, exact) = (shape.hits_at::<Stable>(ray), shape.hits_at::<Exact>(ray));
    if touches(&stable, size) || touches(&exact, size) || (stable.is_empty() && exact.is_empty()) {
        return None;
    }
    if stable.len() != exact.len() {
        return Some(f64::INFINITY);
    }
    let units = |[t, exact]: [f32; 2]| {
        (f64::from(t) - f64::from(exact)).abs() / f64::from((exact.abs() * f32::EPSILON).max(f32::from_bits(1)))
    };
    Some(stable.iter().zip(&exact).map(|(a, b)| units([a.t, b.t])).fold(0.0, f64::max))
}

/// The nearest hit, which may need the entry alone, is the first of all hits, to the bit; and occlusion agrees with it.
///
/// So they are in ranges that end or start next to a hit, where a few units of `t` decide.
fn assert_nearest_is_first(shape: &Shape<f32>, ray: &Ray<f32>) {
    let mut ranges = vec![Range::FORWARD];
    ranges.extend(shape.hits_at::<Stable>(ray).iter().flat_map(|hit| ranges_next_to(hit.t)));
    for range in ranges {
        let ray = ray.with_range(range);
        let (hits, nearest) = (shape.hits_at::<Stable>(&ray), shape.nearest_at::<Stable>(&ray));
        assert_eq!(nearest, hits.first().copied(), "{ray:?} at {shape:?}: {hits:?}");
        assert_eq!(shape.occludes_at::<Stable>(&ray), nearest.is_some(), "{ray:?} at {shape:?}");
    }
}

#[test]
fn solids_of_any_size_are_met_as_promised() {
    let mut random = Random(15);
    let (mut judged, mut departing, mut rays, mut worst) = (0, 0, 0, 0.0);
    while judged < times(40_000) {
        let Some((shape, ray, size)) = drawn(&mut random) else { continue };
        rays += 1;
        assert_nearest_is_first(&shape, &ray);
        let Some(units) = off(&shape, &ray, size) else { continue };
        assert!(units <= UNITS, "{units} units: {ray:?} at {shape:?}");
        worst = f64::max(worst, units);
        judged += 1;
        departing += u64::from(ray.departure().is_some());
    }
    println!("{judged} of {rays} rays, {departing} of them departing: at most {worst:.2} units off");
    assert!(judged * 3 > rays && departing * 20 > judged, "{judged} of {rays}, {departing} departing");
}

/// 105 units: the low words of a compensated sum were taken to be exact, although the terms of the sum were a thousand
/// times larger than its value.
#[test]
fn rays_from_next_to_a_flat_stretched_rectangle() {
    let mut random = Random(3);
    let mut judged = 0;
    while judged < times(20_000) {
        let mut axis = |long: f64| Vec3::from_f64(scale(random.direction(), long)).unwrap();
        let axes = [axis(1.0), axis(1e-4), axis(0.6)];
        let Ok(affine) = Affine::new(Vec3::ZERO, axes) else { continue };
        let shape = Shape::new(Rectangle::new(2.0_f32, 3.0).unwrap()).placed(affine);
        let ray = Ray::new(
            Vec3::from_f64(scale(random.direction(), 4.0)).unwrap(),
            UnitVec3::from_f64(random.direction()).unwrap(),
        );
        let ray = ray.unwrap().with_range(Range::line());
        let Some(hit) = shape.nearest_at::<Exact>(&ray) else { continue };
        let near = scale(random.direction(), (-random.between(1.0, 30.0)).exp2());
        let origin = Vec3::from_f64(add(shape.surface(&ray, &hit).point().to_f64(), near)).unwrap();
        let ray = Ray::new(origin, ray.direction()).unwrap().with_range(Range::line());
        let Some(units) = off(&shape, &ray, 1.0) else { continue };
        assert!(units <= UNITS, "{units} units: {ray:?} at {shape:?}");
        judged += 1;
    }
}
