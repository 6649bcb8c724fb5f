//! Surface coordinates and directions that several primitives share.
//!
//! `u` grows once around the axis, from the x axis counter-clockwise as seen from +y; `v` grows upwards. The two
//! directions and the outward normal are right-handed. On flat caps `u` and `v` are x and z, mapped linearly from
//! `[-r, r]` to `[0, 1]`.

use crate::scalar::{Real, Ring, Scalar, UnitScalar, largest};
use crate::vector::{UnitVec3, Vec3};
use core::cmp::Ordering;

/// The angle about the y axis, in turns; zero on the axis.
pub(super) fn azimuth<S: Scalar>(point: Vec3<S>) -> S::Unit {
    S::turns(-point.z.real(), point.x.real())
}

/// `part / whole` clamped to `[0, 1]`; zero if `whole` is zero.
pub(crate) fn fraction<S: Scalar>(part: S::Real, whole: S::Real) -> S::Unit {
    if whole.is_zero() {
        return S::Unit::ZERO;
    }
    let fraction = S::unit_round(part / whole);
    // If the products of sizes overflow, this is NaN, for which the comparison is false.
    if fraction > S::Unit::ONE {
        S::Unit::ONE
    } else if fraction > S::Unit::ZERO {
        fraction
    } else {
        S::Unit::ZERO
    }
}

/// (x, z) of a cap of this radius.
pub(super) fn planar<S: Scalar>(point: Vec3<S>, radius: S::Real) -> (S::Unit, S::Unit) {
    if radius.is_zero() {
        return (S::Unit::ZERO, S::Unit::ZERO);
    }
    (across(point.x, radius), across(point.z, radius))
}

/// A coordinate mapped linearly from `[-half, half]` to `[0, 1]`.
pub(super) fn across<S: Scalar>(component: S, half: S::Real) -> S::Unit {
    // (x / r + 1) / 2 rather than (x + r) / 2r: twice the largest radius overflows.
    let one = S::Real::ONE;
    fraction::<S>((component.real() / half + one).scaled(-1), one)
}

/// The number moved to the nearest of `[-half, half]`, since rounding may have moved it beyond an edge.
pub(super) fn clamped<S: Scalar>(component: S, half: S) -> S {
    let component = if component > half { half } else { component };
    if component < -half { -half } else { component }
}

/// The fractional part, for infinite surfaces: the coordinate repeats every unit of length.
pub(crate) fn repeating<S: Scalar>(value: S) -> S::Unit {
    // Exact for every number type.
    S::fraction(value)
}

/// The directions in which the planar coordinates grow.
pub(super) fn planar_tangents<S: Scalar>() -> (UnitVec3<S>, UnitVec3<S>) {
    (UnitVec3::X, UnitVec3::Z)
}

/// The directions around the y axis and, perpendicular to it in the surface, upwards.
#[inline(always)]
pub(super) fn tangents_around<S: Scalar>(point: Vec3<S>, normal: UnitVec3<S>) -> (UnitVec3<S>, UnitVec3<S>) {
    let u = around(point);
    (u, UnitVec3::from_real(normal.cross(u)).unwrap_or(UnitVec3::Y))
}

/// The direction around the y axis, counter-clockwise as seen from +y; -z for a point on the axis.
pub(super) fn around<S: Scalar>(point: Vec3<S>) -> UnitVec3<S> {
    UnitVec3::new_or(Vec3::new(point.z, S::ZERO, S::ZERO.minus(point.x)), -UnitVec3::Z)
}

/// The direction away from the y axis; +x for a point on the axis.
pub(super) fn outwards<S: Scalar>(point: Vec3<S>) -> UnitVec3<S> {
    UnitVec3::new_or(Vec3 { y: S::ZERO, ..point }, UnitVec3::X)
}

/// The point with its height clamped to `[0, height]`, since rounding may have moved it beyond a rim.
pub(super) fn between<S: Scalar>(point: Vec3<S>, height: S) -> Vec3<S> {
    let y = if point.y > height { height } else { point.y };
    Vec3 { y: if y > S::ZERO { y } else { S::ZERO }, ..point }
}

/// The point, moved to the distance `radius` from the y axis if its own compares with that as `is` says: to the circle
/// around a disc if it is greater, or to that around a hole if it is less.
pub(crate) fn at_circle<S: Scalar>(point: Vec3<S>, radius: S, is: Ordering) -> Vec3<S> {
    // Scaled so that no square overflows.
    let e = S::binary_exponent(largest([point.x, point.z, radius]));
    let [x, z, r] = [point.x, point.z, radius].map(|c| c.real().scaled(-e));
    if (x * x + z * z).partial_cmp(&(r * r)) == Some(is) { at_distance(point, |c| radius.along(c)) } else { point }
}

/// The point moved to a given distance from the y axis; `along` multiplies that distance by a component of a direction.
pub(crate) fn at_distance<S: Scalar>(point: Vec3<S>, along: impl Fn(S::Unit) -> S) -> Vec3<S> {
    let outwards = outwards(point);
    Vec3 { x: along(outwards.x()), z: along(outwards.z()), ..point }
}
