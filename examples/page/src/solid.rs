//! The solids of the page.

use raylet::{Capsule, Cone, Cuboid, Cylinder, Error, Frame, Scalar, Shape, Sphere, UnitVec3, Vec3};

/// The primitives and placements that are compiled in.
pub type Kinds = (Sphere<f32>, Cylinder<f32>, Cone<f32>, Capsule<f32>, Cuboid<f32>, Frame<f32>);

/// A solid by its number on the page, its sizes, where its base is, and where its y axis points.
///
/// # Errors
///
/// What the number type does not hold, or the library refuses.
pub fn placed<S: Scalar>(
    solid: u32,
    sizes: [f64; 3],
    base: [f64; 3],
    axis: [f64; 3],
) -> Result<(Shape<S, Kinds>, Frame<S>), Error> {
    let [a, b, c] = Vec3::<S>::from_f64(sizes)?.to_array();
    let shape = match solid {
        0 => Shape::of(Sphere::new(a)?),
        1 => Shape::of(Cylinder::capped(a, b)?),
        2 => Shape::of(Cylinder::open(a, b)?),
        3 => Shape::of(Cone::capped(a, b)?),
        4 => Shape::of(Cone::double(a)?),
        5 => Shape::of(Cone::frustum(a, b, c)?),
        6 => Shape::of(Capsule::new(a, b)?),
        _ => Shape::of(Cuboid::new(a, b, c)?),
    };
    let frame = Frame::from_base_and_axis(Vec3::from_f64(base)?, UnitVec3::new(Vec3::from_f64(axis)?)?)?;
    Ok((shape.placed(frame), frame))
}
