//! Vectors and turns of `glam`, solids of `raylet`; `mint` stands between them.

use glam::{Quat, Vec3 as GlamVec3};
use raylet::{Cylinder, Frame, Ray, Shape, UnitVec3, Vec3};
use std::error::Error;
use std::f32::consts::FRAC_PI_2;

fn vector(v: GlamVec3) -> Vec3<f32> {
    mint::Vector3::from(v).into()
}

pub fn main() -> Result<(), Box<dyn Error>> {
    // A can that lies along x, four units ahead.
    let (position, turn) = (GlamVec3::new(-1.0, 0.0, 4.0), Quat::from_rotation_z(-FRAC_PI_2));
    let frame = Frame::from_quaternion(vector(position), turn.to_array())?;
    let can = Shape::new(Cylinder::capped(0.5, 2.0)?).placed(frame);

    let (eye, forward) = (GlamVec3::ZERO, GlamVec3::Z);
    let ray = Ray::new(vector(eye), UnitVec3::new(vector(forward))?)?;
    let hit = can.nearest(&ray).ok_or("it looks straight at it")?;
    let surface = can.surface(&ray, &hit);
    let point = GlamVec3::from(mint::Vector3::from(surface.point()));
    let normal = GlamVec3::from(mint::Vector3::from(surface.normal()));
    assert!(point.distance(eye + hit.t * forward) < 1e-6 && normal.distance(-forward) < 1e-6);
    println!("hit at {point}, which faces {normal}");
    Ok(())
}
