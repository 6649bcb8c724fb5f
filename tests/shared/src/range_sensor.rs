//! What a range sensor sees: 8 by 8 zones, level, over a yard with forty solids 1 to 200 of their sizes away.
//!
//! The sensor is a metre above the ground and looks along -z. Everything stands upright, as things do, but for some
//! cans that have fallen over and two signs. One row of zones is exactly level: it meets posts and drums perpendicular
//! to their axes, and sees the caps from their edges.

use raylet::{Capsule, Cone, Cylinder, Frame, Primitive, Ray, Scalar, Shape, Sphere, Triangle, UnitVec3, Vec3};

/// Zones along each side.
pub const ZONES: u16 = 8;

/// Solids.
pub const SOLIDS: usize = 40;

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).unwrap_or(S::ZERO)
}

fn point<S: Scalar>([x, y, z]: [f64; 3]) -> Vec3<S> {
    Vec3::new(number(x), number(y), number(z))
}

/// A solid on the ground; from the 33rd on, one that lies or leans.
fn primitive<S: Scalar>(index: usize) -> Option<Primitive<S>> {
    // Sizes from .4 to 1.
    let size = 0.4 + 0.1 * (index % 7) as f64;
    let [half, whole, high] = [size / 2.0, size, 4.0 * size].map(number::<S>);
    Some(match index {
        // Posts.
        0..12 => Cylinder::capped(half, high).ok()?.into(),
        // Drums.
        12..18 | 34..38 => Cylinder::capped(half, whole).ok()?.into(),
        // Balls.
        18..24 => Sphere::new(half).ok()?.into(),
        // Bollards.
        24..28 => Capsule::new(half, whole).ok()?.into(),
        // Traffic cones and buckets: these stand on their wide side.
        28..32 => Cone::frustum(half, number(size / 8.0), whole).ok()?.into(),
        32..34 => Cone::frustum(number(size / 3.0), half, whole).ok()?.into(),
        // Signs.
        38..40 => {
            Triangle::new(point([-size, 0.0, 0.0]), point([size, 0.0, 0.0]), point([0.0, size, 0.0])).ok()?.into()
        }
        _ => return None,
    })
}

/// A solid of the yard, by its index.
pub fn solid<S: Scalar>(index: usize) -> Option<Shape<S>> {
    let shape = Shape::new(primitive(index)?);
    // Farther with every third one, from 1 to 200 of the largest sizes; to the left and to the right of the middle.
    let away =
        1.0 + 199.0 * (index * 7 % SOLIDS) as f64 / SOLIDS as f64 * ((index * 7 % SOLIDS) as f64 / SOLIDS as f64);
    let aside = (index * 11 % 9) as f64 / 9.0 - 0.5;
    let foot = if matches!(index, 18..24) { 1.0 } else { 0.25 * (index % 3) as f64 };
    let position = point([aside * 0.7 * away, foot, -away]);
    let frame = match index {
        // Lying, in any direction along the ground.
        34..38 => {
            let forward = UnitVec3::new(point([1.0, 0.0, 0.375 * (index as f64 - 36.0) + 0.125])).ok()?;
            Frame::looking(position, forward, UnitVec3::X).or_else(|_| Frame::looking(position, forward, UnitVec3::Z))
        }
        // Turned away, and leaning.
        38..40 => Frame::looking(position, UnitVec3::new(point([0.25, 0.125, 1.0])).ok()?, UnitVec3::Y),
        _ => Frame::at(position),
    };
    Some(shape.placed(frame.ok()?))
}

/// The ray of a zone.
pub fn ray<S: Scalar>(column: u16, row: u16) -> Option<Ray<S>> {
    let [x, y] = [column, row].map(|zone| (i32::from(zone) - i32::from(ZONES / 2)) as f64 * 0.09375);
    // A few degrees to the side, so that no post stands exactly in the middle.
    Ray::towards(point([0.0, 1.0, 0.0]), point([x + 0.03125, 1.0 + y, -1.0])).ok()
}
