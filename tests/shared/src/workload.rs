//! What users do: solids as they are placed, rays from near and from far, departing rays, a range sensor.
//!
//! Every query is a solid and a ray of its own, from seeded numbers that all number types hold.

use crate::borrowed::{self, Borrowed};
use crate::digest::Random;
use crate::range_sensor::{self, SOLIDS, ZONES};
use crate::subject::{eighths, triangle};
use raylet::tier::Stable;
use raylet::{
    Affine, Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Frame, Leaving, Plane, Primitive, Ray, Rectangle, Revolved,
    RoundCone, RoundedCuboid, Scalar, Shape, Sphere, Torus, Tube, UnitVec3, Vec3,
};

/// Queries of a workload.
pub const QUERIES: usize = 100;

/// The solids, all about as large as the unit ball.
pub const SOLIDS_BY_NAME: [&str; 21] = [
    "sphere",
    "cylinder, capped",
    "capsule",
    "cone, double",
    "cone, nappe",
    "cone, capped",
    "frustum",
    "plane",
    "disc",
    "triangle",
    "cuboid",
    "rectangle",
    "paraboloid",
    "hyperboloid",
    "tube",
    "annulus",
    "round cone",
    "rounded cuboid",
    "prism",
    "polyhedron",
    "torus",
];

/// How a solid is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placed {
    /// In its canonical pose.
    World,
    /// By a frame that only moves it.
    Moved,
    /// By a frame that turns it too.
    Turned,
    /// By a matrix that stretches and shears it.
    Stretched,
}

/// Every placement.
pub const PLACEMENTS: [Placed; 4] = [Placed::World, Placed::Moved, Placed::Turned, Placed::Stretched];

impl Placed {
    /// In a table.
    pub const fn name(self) -> &'static str {
        match self {
            Self::World => "in the world",
            Self::Moved => "moved",
            Self::Turned => "turned",
            Self::Stretched => "stretched",
        }
    }
}

/// Where the rays begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rays {
    /// 2 to 6 sizes away.
    Near,
    /// 20 to 1,000 sizes away, more of them near.
    Far,
    /// On the solid itself, which they leave.
    Departing,
}

/// Every kind of rays.
pub const RAYS: [Rays; 3] = [Rays::Near, Rays::Far, Rays::Departing];

impl Rays {
    /// In a table.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Near => "near",
            Self::Far => "far",
            Self::Departing => "departing",
        }
    }
}

/// A solid and a ray.
#[derive(Clone, Copy, Debug)]
pub struct Query<S: Scalar> {
    /// The solid, as it is placed.
    pub shape: Shape<S>,
    /// The ray.
    pub ray: Ray<S>,
}

fn primitive<S: Borrowed>(name: &str) -> Option<Primitive<S>> {
    let n = eighths::<S>;
    Some(match name {
        "sphere" => Sphere::new(n(8)).ok()?.into(),
        "cylinder, capped" => Cylinder::capped(n(8), n(12)).ok()?.into(),
        "capsule" => Capsule::new(n(6), n(12)).ok()?.into(),
        "cone, double" => Cone::double(n(6)).ok()?.into(),
        "cone, nappe" => Cone::nappe(n(6)).ok()?.into(),
        "cone, capped" => Cone::capped(n(6), n(12)).ok()?.into(),
        "frustum" => Cone::frustum(n(10), n(5), n(12)).ok()?.into(),
        "plane" => Plane::new().into(),
        "disc" => Disc::new(n(8)).ok()?.into(),
        "triangle" => triangle()?.into(),
        "cuboid" => Cuboid::new(n(8), n(6), n(7)).ok()?.into(),
        "rectangle" => Rectangle::new(n(8), n(7)).ok()?.into(),
        "paraboloid" => Revolved::paraboloid(n(3), n(12)).ok()?.into(),
        "hyperboloid" => Revolved::hyperboloid(n(5), n(6), [n(-6), n(8)]).ok()?.into(),
        "round cone" => RoundCone::new(n(7), n(4), n(10)).ok()?.into(),
        "rounded cuboid" => RoundedCuboid::new(n(6), n(4), n(5), n(2)).ok()?.into(),
        "prism" => borrowed::prism(n(12))?.into(),
        "polyhedron" => borrowed::polyhedron::<S>()?.into(),
        "tube" => Tube::new(n(6), n(8), n(12)).ok()?.into(),
        "torus" => Torus::new(n(6), n(2)).ok()?.into(),
        "annulus" => Annulus::new(n(4), n(8)).ok()?.into(),
        _ => return None,
    })
}

/// The solid, placed somewhere; and where.
fn place<S: Scalar>(shape: Shape<S>, placed: Placed, random: &mut Random) -> Option<(Shape<S>, Vec3<S>)> {
    let position = random.point(8);
    Some(match placed {
        Placed::World => (shape, Vec3::ZERO),
        Placed::Moved => (shape.placed(Frame::at(position).ok()?), position),
        Placed::Turned => {
            let (forward, up) = (UnitVec3::new(random.point(1)).ok()?, UnitVec3::new(random.point(1)).ok()?);
            (shape.placed(Frame::looking(position, forward, up).ok()?), position)
        }
        Placed::Stretched => {
            let axes = [[1.5, 0.0, 0.0], [0.0, 0.625, 0.0], [0.0, 0.0, 1.25]].map(|[x, y, z]| {
                let [dx, dy, dz] = random.point::<S>(1).to_array().map(|c| c.to_f64() / 4.0);
                Vec3::from_f64([x + dx, y + dy, z + dz]).ok()
            });
            let [x, y, z] = axes;
            (shape.placed(Affine::new(position, [x?, y?, z?]).ok()?), position)
        }
    })
}

/// A ray that begins so far away and leads close to `target`.
fn towards<S: Scalar>(target: Vec3<S>, rays: Rays, random: &mut Random) -> Option<Ray<S>> {
    let to_f64 = |v: Vec3<S>| v.to_array().map(Scalar::to_f64);
    let from = to_f64(random.point(1));
    // Of points of a cube those that lie outside of the unit ball are directions, and have lengths from 1 to 1.7.
    if from.iter().map(|c| c * c).sum::<f64>() < 1.0 {
        return None;
    }
    let [part, _, _] = to_f64(random.point(1)).map(f64::abs);
    let away = match rays {
        Rays::Near | Rays::Departing => 2.0 + 2.0 * part,
        Rays::Far => 20.0 + 560.0 * part * part * part,
    };
    let ([x, y, z], [tx, ty, tz]) = (to_f64(target), to_f64(random.point(1)));
    let [fx, fy, fz] = from.map(|c| c * away);
    let target = Vec3::from_f64([x + tx, y + ty, z + tz]).ok()?;
    Ray::towards(Vec3::from_f64([x + fx, y + fy, z + fz]).ok()?, target).ok()
}

/// A ray that leaves the solid where another one meets it, to either side.
fn departing<S: Scalar>(shape: &Shape<S>, arriving: &Ray<S>, random: &mut Random) -> Option<Ray<S>> {
    let hit = shape.nearest_at::<Stable>(arriving)?;
    let surface = shape.surface(arriving, &hit);
    let direction = UnitVec3::new(random.point(1)).ok()?;
    let (d, n) = (direction.to_array(), surface.normal().to_array());
    let along: f64 = d
        .into_iter()
        .zip(n)
        .map(|(d, n)| raylet::scalar::UnitScalar::to_f64(d) * raylet::scalar::UnitScalar::to_f64(n))
        .sum();
    let leaving = if along > 0.0 { Leaving::Outwards } else { Leaving::Inwards };
    Some(Ray::new(surface.point(), direction).ok()?.departing(surface.departure(0, leaving)))
}

/// The query of this index; always the same.
pub fn query<S: Borrowed>(solid: &str, placed: Placed, rays: Rays, index: usize) -> Option<Query<S>> {
    // The seeds of neighbours must differ in many bits.
    let mut random = Random((index as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let shape = Shape::new(primitive(solid)?);
    // Some draws give nothing: a frame without directions, a ray that does not arrive.
    for _ in 0..1_000 {
        let Some((shape, target)) = place(shape, placed, &mut random) else { continue };
        let Some(ray) = towards(target, rays, &mut random) else { continue };
        if rays != Rays::Departing {
            return Some(Query { shape, ray });
        }
        if let Some(ray) = departing(&shape, &ray, &mut random) {
            return Some(Query { shape, ray });
        }
    }
    None
}

/// Queries of the range sensor: each zone tests each solid.
pub const SENSED: usize = SOLIDS * ZONES as usize * ZONES as usize;

/// Of the range sensor's tests every so many is measured: no divisor of the number of solids or of zones.
pub const SENSED_EVERY: usize = 27;

/// The query of this index of the range sensor.
pub fn sensed<S: Scalar>(index: usize) -> Option<Query<S>> {
    let (zone, solid) = (index / SOLIDS, index % SOLIDS);
    let ray = range_sensor::ray((zone % ZONES as usize) as u16, (zone / ZONES as usize) as u16)?;
    Some(Query { shape: range_sensor::solid(solid)?, ray })
}
