//! The textbook's formulas (`shared::textbook`) at the solids of the oracle, and all their hits.

use super::exact_types::Exact;
use super::oracle::{ConeExtent, CylinderExtent, Dyadic, Revolved, RoundCone, RoundedCuboid, Solid};
use super::placed::{Placed, Placement};
use raylet::scalar::UnitScalar;
use raylet::{Frame, Ray};
pub use shared::textbook::{Extent, Form, Formula, Number, Place, Plain, PlainRay, Quadric, Side};

/// The range of `t` in which hits are told.
#[derive(Clone, Copy)]
pub struct Reach<N> {
    start: N,
    /// `None`: as far as the number type reaches.
    end: Option<N>,
}

impl<N: Number> Reach<N> {
    pub fn of<S: Plain<Number = N>>(ray: &Ray<S>) -> Self {
        let (start, end) = (ray.range().start(), ray.range().end());
        Self { start: start.plain(), end: (end < S::BUDGET.distance).then(|| end.plain()) }
    }

    fn holds(self, t: N) -> bool {
        t >= self.start && self.end.is_none_or(|end| t <= end)
    }
}

/// Where a solid stands.
pub fn place<S: Plain + Exact>(placed: &Placed<S>) -> Place<S::Number> {
    let of = |frame: &Frame<S>| Place::of(frame);
    match &placed.placement {
        Placement::Frame(frame) => of(frame),
        Placement::Stretched(frame, factors) => Place { stretch: Some(factors.map(S::plain)), ..of(frame) },
        Placement::Matrix(affine) => {
            let position = affine.position().to_array().map(S::plain);
            Place { axes: affine.inverse().map(inverse_row::<S>), stretch: None, position }
        }
    }
}

/// A row of an inverse in the number type; what is beyond the type is its largest number.
fn inverse_row<S: Plain>((row, exponent): ([S::Unit; 3], i32)) -> [S::Number; 3] {
    row.map(|component| {
        let value = component.to_f64() * 2.0_f64.powi(exponent);
        let largest = S::BUDGET.distance;
        S::from_f64(value).unwrap_or(if value < 0.0 { -largest } else { largest }).plain()
    })
}

/// The form of a solid whose sizes are values of the scalar.
pub fn form<S: Plain>(solid: &Solid) -> Form<S::Number> {
    let n = |value: &Dyadic| S::from_f64(value.to_f64()).expect("sizes of subjects are the scalar's own").plain();
    match solid {
        Solid::Sphere { radius } => Form::Sphere { radius: n(radius) },
        Solid::Cylinder { radius, extent } => Form::Side(match extent {
            CylinderExtent::Capped(height) => Side::cylinder(n(radius), n(height)),
            CylinderExtent::Infinite => side(n(radius), None, Extent::Everywhere),
            CylinderExtent::Open(height) => side(n(radius), None, Extent::To(n(height))),
        }),
        Solid::Cone { slope, extent } => {
            let open = |extent| side(S::Number::ZERO, Some(n(slope)), extent);
            Form::Side(match extent {
                ConeExtent::Capped(height) => Side::cone(n(slope), n(height)),
                ConeExtent::Double => open(Extent::Everywhere),
                ConeExtent::Nappe => open(Extent::Upwards),
                ConeExtent::Open(height) => open(Extent::To(n(height))),
            })
        }
        Solid::Frustum { base_radius, top_radius, height, capped } => {
            let (base, top, height) = (n(base_radius), n(top_radius), n(height));
            let caps = [(S::Number::ZERO, base), (height, top)].map(|cap| capped.then_some(cap));
            Form::Side(Side { caps, ..side(base, Some((top - base) / height), Extent::To(height)) })
        }
        Solid::Capsule { radius, height } => Form::Capsule { radius: n(radius), height: n(height) },
        Solid::Revolved(Revolved { a, b, r, low, high, capped }) => {
            Form::Revolved(Quadric { coefficients: [a, b, r].map(n), heights: [low, high].map(n), capped: *capped })
        }
        Solid::RoundCone(RoundCone { base_radius, top_radius, height }) => {
            Form::RoundCone { radii: [base_radius, top_radius].map(n), height: n(height) }
        }
        Solid::Tube { inner, outer, height } => Form::Tube { radii: [inner, outer].map(n), height: n(height) },
        Solid::Torus { major, minor } => Form::Torus { radii: [major, minor].map(n) },
        Solid::Plane => Form::Plane,
        Solid::Disc { radius } => Form::Disc { radius: n(radius) },
        Solid::Annulus { inner, outer } => Form::Annulus { radii: [inner, outer].map(n) },
        Solid::Cuboid { half } => Form::Cuboid { half: half.each_ref().map(n) },
        Solid::RoundedCuboid(RoundedCuboid { half, radius }) => {
            Form::RoundedCuboid { half: half.each_ref().map(n), radius: n(radius) }
        }
        Solid::HalfSpaces(of) => {
            let mut faces = [[[S::Number::ZERO; 3]; 2]; 8];
            assert!(of.faces.len() <= faces.len(), "the textbook's solids have at most {} faces", faces.len());
            for (of, face) in faces.iter_mut().zip(&of.faces) {
                *of = [&face.normal, &face.point].map(|v| v.each_ref().map(n));
            }
            Form::HalfSpaces { faces }
        }
        Solid::Rectangle { half } => Form::Rectangle { half: half.each_ref().map(n) },
        Solid::Triangle { vertices } => Form::Triangle { vertices: vertices.each_ref().map(|v| v.each_ref().map(n)) },
    }
}

/// A side without caps.
fn side<N: Number>(base: N, slope: Option<N>, extent: Extent<N>) -> Side<N> {
    Side { base, slope, extent, caps: [None; 2] }
}

/// All `t` in the range, sorted.
pub fn hits<N: Number>(form: &Form<N>, place: Option<&Place<N>>, ray: &PlainRay<N>, reach: Reach<N>) -> Vec<N> {
    let mut all = vec![];
    let local = place.map_or(*ray, |place| place.local(ray));
    form.meet(&local, N::root, &mut |t: N| {
        if reach.holds(t) {
            all.push(t);
        }
    });
    all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    all
}
