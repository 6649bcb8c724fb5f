//! A hard case: a ray that breaks the usual formulas, with its exact answer.
//!
//! Numbers stand as people write them; the answer is that of the written numbers, in decimals, and was computed apart
//! from this repository, with 400 digits. A number type rounds what is written, and then has an exact answer of its
//! own.

pub mod boxes;
pub mod check;
pub mod corners;
pub mod flat;
pub mod grazing;
pub mod listed;
pub mod parallel;
pub mod placed;
pub mod sizes;
pub mod slopes;
pub mod sweeps;

use crate::exact_types::Exact;
use crate::oracle::{ConeExtent, CylinderExtent, Dyadic, Solid};
use raylet::{Crossing, Part, Primitive, Vec3};

/// All written cases, by the name of their class.
pub const fn classes() -> [(&'static str, &'static [Case]); 9] {
    [
        ("listed", &listed::LISTED),
        ("sizes", &sizes::SIZES),
        ("grazing", &grazing::GRAZING),
        ("parallel", &parallel::PARALLEL),
        ("corners", &corners::CORNERS),
        ("slopes", &slopes::SLOPES),
        ("flat", &flat::FLAT),
        ("placed", &placed::PLACED),
        ("boxes", &boxes::BOXES),
    ]
}

/// A primitive by its sizes, canonical pose as in the crate.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A sphere of this radius.
    Ball(f64),
    /// An infinite cylinder of this radius.
    Tube(f64),
    /// An open cylinder: radius and height.
    Pipe(f64, f64),
    /// A capped cylinder: radius and height.
    Can(f64, f64),
    /// A capsule: radius and height.
    Pill(f64, f64),
    /// A double cone of this slope.
    DoubleCone(f64),
    /// One infinite nappe of this slope.
    Nappe(f64),
    /// An open cone: slope and height.
    Horn(f64, f64),
    /// A capped cone: slope and height.
    Cone(f64, f64),
    /// A capped frustum: radius at the base, radius at the top, height.
    Frustum(f64, f64, f64),
    /// An open frustum: radius at the base, radius at the top, height.
    Skirt(f64, f64, f64),
    /// The plane.
    Plane,
    /// A disc of this radius.
    Disc(f64),
    /// A cuboid of these half extents.
    Box([f64; 3]),
    /// A rectangle of these half extents.
    Rectangle([f64; 2]),
    /// A triangle.
    Triangle([[f64; 3]; 3]),
}

/// The height of a solid whose axis is given by its far end: see [`Axis::To`].
pub const TO_THE_END: f64 = 0.0;

/// Where the primitive's axis points in the world.
#[derive(Clone, Copy, Debug)]
pub enum Axis {
    X,
    Y,
    Z,
    /// To this point, which is the top of the solid.
    To([f64; 3]),
}

/// What the default tier does not promise of a case in one number type; tight, and checked to be needed. The exact tier
/// has no such limits.
#[derive(Clone, Copy, Debug)]
pub enum Limit {
    /// The greatest error of `t` in units in the last place: what was measured, and at most a tenth more.
    Units(f64),
    /// The answer itself is decided by a rounding (a rim, a seam, grazing): what is given instead.
    Gives(&'static str),
}

/// A hit as written: `t` in decimals.
pub type Written = (Crossing, Part, &'static str);

pub const fn enter(part: Part, t: &'static str) -> Written {
    (Crossing::Enter, part, t)
}

pub const fn exit(part: Part, t: &'static str) -> Written {
    (Crossing::Exit, part, t)
}

pub const fn touch(part: Part, t: &'static str) -> Written {
    (Crossing::Touch, part, t)
}

/// A ray, a solid, and the exact answer for the numbers as written.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    pub name: &'static str,
    /// What goes wrong elsewhere.
    pub breaks: &'static str,
    pub kind: Kind,
    pub base: [f64; 3],
    pub axis: Axis,
    pub origin: [f64; 3],
    /// Any length; `t` is distance.
    pub towards: [f64; 3],
    /// The hits of the whole line. The ray's own are those with `t >= 0`.
    pub hits: &'static [Written],
    /// The ray (not the line) starts inside.
    pub starts_inside: bool,
    /// Where the line lies in the surface; an end that is missing is infinite.
    pub lies: Option<[Option<&'static str>; 2]>,
    /// Hits farther than this come of rounding the inputs to `f64`, and are not those of the written numbers.
    pub horizon: f64,
    /// Limits of the default tier, by the name of the number type.
    pub limits: &'static [(&'static str, Limit)],
}

/// A case to be completed by the methods below; a miss unless said otherwise.
pub const fn case(name: &'static str, breaks: &'static str) -> Case {
    Case {
        name,
        breaks,
        kind: Kind::Plane,
        base: [0.0; 3],
        axis: Axis::Y,
        origin: [0.0; 3],
        towards: [0.0; 3],
        hits: &[],
        starts_inside: false,
        lies: None,
        horizon: f64::INFINITY,
        limits: &[],
    }
}

impl Case {
    pub const fn on(self, kind: Kind) -> Self {
        Self { kind, ..self }
    }

    pub const fn at(self, base: [f64; 3], axis: Axis) -> Self {
        Self { base, axis, ..self }
    }

    pub const fn ray(self, origin: [f64; 3], towards: [f64; 3]) -> Self {
        Self { origin, towards, ..self }
    }

    pub const fn hits(self, hits: &'static [Written]) -> Self {
        Self { hits, ..self }
    }

    pub const fn inside(self) -> Self {
        Self { starts_inside: true, ..self }
    }

    pub const fn lies(self, from: Option<&'static str>, to: Option<&'static str>) -> Self {
        Self { lies: Some([from, to]), ..self }
    }

    pub const fn f64_adds_beyond(self, horizon: f64) -> Self {
        Self { horizon, ..self }
    }

    pub const fn stable(self, limits: &'static [(&'static str, Limit)]) -> Self {
        Self { limits, ..self }
    }

    /// True if the primitive stands in its canonical pose, and needs no placement.
    pub fn is_unplaced(&self) -> bool {
        self.base == [0.0; 3] && matches!(self.axis, Axis::Y)
    }
}

/// `2^exponent`, subnormal ones included.
pub const fn two_to(exponent: i32) -> f64 {
    // No power is const; halving and doubling are exact.
    let mut value = 1.0;
    let mut left = exponent;
    while left != 0 {
        (value, left) = if left > 0 { (value * 2.0, left - 1) } else { (value / 2.0, left + 1) };
    }
    value
}

/// The crate's primitive and the oracle's solid, of the same bits; `None` where the type cannot hold a size. `end` is
/// the height of a solid that reaches to a given end.
pub fn build<S: Exact>(kind: Kind, end: Option<S>) -> Option<(Primitive<S>, Solid)> {
    let size = |value: f64| S::from_f64(value).ok().map(|size| (size, size.exact()));
    let height = |value: f64| end.map_or_else(|| size(value), |end| Some((end, end.exact())));
    Some(match kind {
        Kind::Ball(r) => {
            let (r, radius) = size(r)?;
            (raylet::Sphere::new(r).ok()?.into(), Solid::Sphere { radius })
        }
        Kind::Tube(r) => {
            let (r, radius) = size(r)?;
            let solid = Solid::Cylinder { radius, extent: CylinderExtent::Infinite };
            (raylet::Cylinder::infinite(r).ok()?.into(), solid)
        }
        Kind::Pipe(r, h) => {
            let ((r, radius), (h, height)) = (size(r)?, height(h)?);
            let solid = Solid::Cylinder { radius, extent: CylinderExtent::Open(height) };
            (raylet::Cylinder::open(r, h).ok()?.into(), solid)
        }
        Kind::Can(r, h) => {
            let ((r, radius), (h, height)) = (size(r)?, height(h)?);
            let solid = Solid::Cylinder { radius, extent: CylinderExtent::Capped(height) };
            (raylet::Cylinder::capped(r, h).ok()?.into(), solid)
        }
        Kind::Pill(r, h) => {
            let ((r, radius), (h, height)) = (size(r)?, height(h)?);
            (raylet::Capsule::new(r, h).ok()?.into(), Solid::Capsule { radius, height })
        }
        Kind::DoubleCone(m) => {
            let (m, slope) = size(m)?;
            (raylet::Cone::double(m).ok()?.into(), Solid::Cone { slope, extent: ConeExtent::Double })
        }
        Kind::Nappe(m) => {
            let (m, slope) = size(m)?;
            (raylet::Cone::nappe(m).ok()?.into(), Solid::Cone { slope, extent: ConeExtent::Nappe })
        }
        Kind::Horn(m, h) => {
            let ((m, slope), (h, height)) = (size(m)?, height(h)?);
            (raylet::Cone::open(m, h).ok()?.into(), Solid::Cone { slope, extent: ConeExtent::Open(height) })
        }
        Kind::Cone(m, h) => {
            let ((m, slope), (h, height)) = (size(m)?, height(h)?);
            (raylet::Cone::capped(m, h).ok()?.into(), Solid::Cone { slope, extent: ConeExtent::Capped(height) })
        }
        Kind::Frustum(base, top, h) => {
            let ((r0, base_radius), (r1, top_radius), (h, height)) = (size(base)?, size(top)?, height(h)?);
            let solid = Solid::Frustum { base_radius, top_radius, height, capped: true };
            (raylet::Cone::frustum(r0, r1, h).ok()?.into(), solid)
        }
        Kind::Skirt(base, top, h) => {
            let ((r0, base_radius), (r1, top_radius), (h, height)) = (size(base)?, size(top)?, height(h)?);
            let solid = Solid::Frustum { base_radius, top_radius, height, capped: false };
            (raylet::Cone::frustum_open(r0, r1, h).ok()?.into(), solid)
        }
        Kind::Plane => (raylet::Plane::new().into(), Solid::Plane),
        Kind::Disc(r) => {
            let (r, radius) = size(r)?;
            (raylet::Disc::new(r).ok()?.into(), Solid::Disc { radius })
        }
        Kind::Box([x, y, z]) => {
            let [x, y, z] = [size(x)?, size(y)?, size(z)?];
            (raylet::Cuboid::new(x.0, y.0, z.0).ok()?.into(), Solid::Cuboid { half: [x.1, y.1, z.1] })
        }
        Kind::Rectangle([x, z]) => {
            let [x, z] = [size(x)?, size(z)?];
            (raylet::Rectangle::new(x.0, z.0).ok()?.into(), Solid::Rectangle { half: [x.1, z.1] })
        }
        Kind::Triangle(corners) => {
            let [a, b, c] = corners.map(|corner| Vec3::<S>::from_f64(corner).ok());
            let corners = [a?, b?, c?];
            let [a, b, c] = corners;
            let vertices: [[Dyadic; 3]; 3] = corners.map(|corner| corner.to_array().map(S::exact));
            (raylet::Triangle::new(a, b, c).ok()?.into(), Solid::Triangle { vertices })
        }
    })
}
