//! A program as users write one: nearest hits, occlusion and surfaces of placed solids, in four number types and
//! fourteen combinations with tiers. `.ci/compiling` measures how long it takes to compile.

use fixed::types::{I16F16, I32F32};
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{Capsule, Cone, Cylinder, Frame, Plane, Ray, Scalar, Shape, Sphere, UnitVec3, Vec3};
use std::error::Error;

fn point<S: Scalar>(x: f64, y: f64, z: f64) -> Result<Vec3<S>, raylet::Error> {
    Ok(Vec3::from_f64([x, y, z])?)
}

fn yard<S: Scalar>() -> Result<[Shape<S>; 5], raylet::Error> {
    let n = |value: f64| S::from_f64(value).unwrap_or(S::ZERO);
    let leaning = Frame::looking(point(0.0, 0.5, 4.0)?, UnitVec3::new(point(0.25, 0.5, 1.0)?)?, UnitVec3::Y)?;
    Ok([
        Shape::new(Sphere::new(n(0.5))?).placed(Frame::at(point(1.0, 0.5, 3.0)?)?),
        Shape::new(Cylinder::capped(n(0.5), n(1.0))?).placed(leaning),
        Shape::new(Cone::frustum(n(0.5), n(0.25), n(1.0))?).placed(leaning),
        Shape::new(Capsule::new(n(0.25), n(1.0))?).placed(leaning),
        Shape::new(Plane::new()),
    ])
}

fn seen<S: Scalar, T: Tier<S>>() -> Result<f64, raylet::Error> {
    let ray = Ray::towards(point(0.0, 1.0, -2.0)?, point::<S>(0.1, 0.75, 4.0)?)?;
    let (mut nearest, mut sum) = (S::INFINITY, 0.0);
    for shape in yard::<S>()? {
        if let Some(hit) = shape.nearest_at::<T>(&ray).filter(|hit| hit.t < nearest) {
            nearest = hit.t;
            sum += shape.surface(&ray, &hit).normal().to_f64()[1];
        }
        sum += f64::from(u8::from(shape.occludes_at::<T>(&ray)));
    }
    Ok(nearest.to_f64() + sum)
}

fn rounding<S: Scalar>(number: &str) -> Result<(), raylet::Error> {
    println!("{number} {} {} {}", seen::<S, Plain>()?, seen::<S, Fast>()?, seen::<S, Stable>()?);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    rounding::<f32>("f32")?;
    println!("f32 {}", seen::<f32, Exact>()?);
    rounding::<f64>("f64")?;
    rounding::<I16F16>("I16F16")?;
    println!("I16F16 {}", seen::<I16F16, Exact>()?);
    rounding::<I32F32>("I32F32")?;
    Ok(())
}
