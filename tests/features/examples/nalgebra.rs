//! Isometries of `nalgebra`, solids of `raylet`; `mint` stands between them.

use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use raylet::{Cone, Frame, FrameError, Ray, Shape, UnitVec3, Vec3};
use std::error::Error;
use std::f64::consts::PI;

fn vector(v: Vector3<f64>) -> Vec3<f64> {
    let v: mint::Vector3<f64> = v.into();
    v.into()
}

fn point(p: Point3<f64>) -> Vec3<f64> {
    let p: mint::Point3<f64> = p.into();
    p.into()
}

/// The same placement.
fn frame(pose: &Isometry3<f64>) -> Result<Frame<f64>, FrameError> {
    let turn = pose.rotation.coords;
    Frame::from_quaternion(vector(pose.translation.vector), [turn.x, turn.y, turn.z, turn.w])
}

pub fn main() -> Result<(), Box<dyn Error>> {
    // A cone that stands on its base: raylet's has its apex at the origin, and opens upwards.
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI);
    let pose = Isometry3::from_parts(Vector3::new(0.0, 2.0, 0.0).into(), turn);
    let cone = Shape::new(Cone::capped(0.5, 2.0)?).placed(frame(&pose)?);

    let ray = Ray::new(point(Point3::new(5.0, 1.0, 0.0)), UnitVec3::new(vector(-Vector3::x()))?)?;
    let hit = cone.nearest(&ray).ok_or("it looks straight at it")?;
    let normal = Vector3::from(mint::Vector3::from(cone.surface(&ray, &hit).normal()));
    // Half way up the radius is a half, and the side rises twice as far as it goes in.
    assert!((hit.t - 4.5).abs() < 1e-12 && (normal - Vector3::new(2.0, 1.0, 0.0).normalize()).norm() < 1e-12);
    println!("hit after {}, where the normal is {:.3?}", hit.t, normal.as_slice());
    Ok(())
}
