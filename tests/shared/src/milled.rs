//! A part that is turned, drilled and milled: a combination of eight solids, many of whose faces coincide.

use raylet::shape::combination::Op;
use raylet::{Camera, Cuboid, Cylinder, Frame, Plane, Scalar, Shape, UnitVec3, Vec3};

/// The kinds of its solids, and of what it stands on.
pub type Few = (Cuboid<f32>, Cylinder<f32>, Plane<f32>, Frame<f32>);

/// Its solids.
pub type Leaves<S> = [Shape<S, Few>; 8];

/// A plate and a boss, less all others.
pub const OPERATIONS: [Op; 15] = {
    // Two leaves and the union of both; then a leaf and the difference, six times.
    let mut operations = [Op::Leaf; 15];
    operations[2] = Op::Union;
    let mut place = 4;
    while place < operations.len() {
        operations[place] = Op::Difference;
        place += 2;
    }
    operations
};

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).unwrap_or(S::ZERO)
}

fn point<S: Scalar>([x, y, z]: [f64; 3]) -> Vec3<S> {
    Vec3::new(number(x), number(y), number(z))
}

fn cylinder<S: Scalar>(radius: f64, height: f64, base: [f64; 3]) -> Option<Shape<S, Few>> {
    let solid = Cylinder::capped(number(radius), number(height)).ok()?;
    Some(Shape::of(solid).placed(Frame::at(point(base)).ok()?))
}

fn cuboid<S: Scalar>([x, y, z]: [f64; 3], frame: Frame<S>) -> Option<Shape<S, Few>> {
    Some(Shape::of(Cuboid::new(number(x), number(y), number(z)).ok()?).placed(frame))
}

/// Plate; boss, which stands on it; bore, exactly as deep as both; counterbore, from the top of the boss; slot, from
/// the top of the plate to its edge; a corner that is cut off; two holes.
pub fn leaves<S: Scalar>() -> Option<Leaves<S>> {
    let at = |position| Frame::at(point(position)).ok();
    let corner = Frame::turned_about(point([2.0, 0.375, 1.25]), UnitVec3::Y, number(45.0)).ok()?;
    Some([
        cuboid([2.0, 0.375, 1.25], at([0.0, 0.375, 0.0])?)?,
        cylinder(0.75, 0.75, [-1.0, 0.75, 0.0])?,
        cylinder(0.375, 1.5, [-1.0, 0.0, 0.0])?,
        cylinder(0.5625, 0.375, [-1.0, 1.125, 0.0])?,
        cuboid([0.875, 0.1875, 0.3125], at([1.125, 0.5625, 0.0])?)?,
        cuboid([0.5, 0.5, 0.5], corner)?,
        cylinder(0.1875, 0.75, [1.5, 0.0, -0.875])?,
        cylinder(0.1875, 0.75, [0.5, 0.0, 0.875])?,
    ])
}

/// The camera that shows it.
pub fn camera<S: Scalar>() -> Option<Camera<S>> {
    Camera::new(point([2.5, 4.5, 6.5]), point([0.0, 0.4, 0.0]), point([0.0, 1.0, 0.0]), number(34.0)).ok()
}
