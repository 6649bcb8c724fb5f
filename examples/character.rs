//! A ball that is pushed through a room and slides along what it touches.

use raylet::thick::{self, ThickRay};
use raylet::{Cuboid, Frame, Plane, Ray, Shape, Stable, UnitVec3, Vec3};

pub(crate) type S = f32;

pub(crate) const RADIUS: S = 0.25;

/// Moves a ball by a step as far as the shapes let it, sliding along what it touches: up to three times, as in a
/// corner.
pub(crate) fn moved(from: Vec3<S>, step: Vec3<S>, room: &[Shape<S>]) -> Result<Vec3<S>, raylet::Error> {
    let (mut at, mut left) = (from, step);
    for _ in 0..3 {
        let Ok(along) = UnitVec3::new(left) else { break };
        let length = left.length();
        let ball = ThickRay::new(Ray::new(at, along)?, RADIUS)?;
        let contact = thick::first::<S, Stable, _>(&ball, room)?.map(|(_, contact)| contact);
        let Some(contact) = contact.filter(|contact| contact.t < length) else {
            return Ok(ball.ray().at(length));
        };
        at = ball.ray().at(contact.t);
        // What is left of the step, without the part that leads into the wall.
        let rest = along.real().map(|component| component * (length - contact.t));
        let n = contact.normal.real();
        let into = (rest[0] * n[0] + rest[1] * n[1] + rest[2] * n[2]).min(0.0);
        left = Vec3::new(rest[0] - into * n[0], rest[1] - into * n[1], rest[2] - into * n[2]);
        // A rest that is only rounding leads nowhere.
        if left.length() < 1e-6 {
            break;
        }
    }
    Ok(at)
}

pub fn main() -> Result<(), raylet::Error> {
    let block = |x: S, z: S| -> Result<Shape<S>, raylet::Error> {
        Ok(Shape::new(Cuboid::new(1.0, 1.0, 1.0)?).placed(Frame::at(Vec3::new(x, 1.0, z))?))
    };
    // A floor, and two blocks that leave a gap of 0.6 m: the ball of 0.5 m fits through it.
    let room = [Shape::new(Plane::new()), block(3.0, -1.3)?, block(3.0, 1.3)?];
    let mut at = Vec3::new(0.0, 0.5, 0.2);
    for second in 0..8 {
        // It is pushed towards x, and it falls.
        at = moved(at, Vec3::new(0.8, -0.2, 0.0), &room)?;
        let [x, y, z] = at.to_array();
        println!("after {} s: {x:.3} {y:.3} {z:.3}", second + 1);
    }
    // It lies on the floor, was turned aside by the edge of the second block, and has passed the gap.
    let [x, y, z] = at.to_array();
    assert!(x > 4.5 && (y - RADIUS).abs() < 1e-5 && z.abs() < 0.0501, "{x} {y} {z}");
    Ok(())
}
