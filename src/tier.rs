//! Accuracy tiers, chosen by type.
//!
//! A tier is a list of numbers to compute in. A query is computed in the first. If that number does not know a sign,
//! because rounding may have decided it, the query is repeated in the next. The last number of `Fast` and `Stable` is
//! the *robust number*, with a mantissa of 64 bits for 32-bit types and 128 bits for 64-bit types; it takes the sign of
//! the rounded value. A ray *grazes to `g`* if it passes within `g` times the radius of touching the surface, or if the
//! sine of its angle to the solid's axis, a generator or a plane is at most `g`. A *grazing ray* is one that grazes to
//! 10^-2.
//!
//! | tier | numbers | what it does | promise for `t`, in units in the last place |
//! |---|---|---|---|
//! | [`Plain`] | all | the equations once, in plain numbers, without guards | hits and misses of rays from nearby that do not graze; the error of `t` grows with distance and towards grazing |
//! | [`Fast`] | all | the same with a guard on the difference that decides; the robust number where it is small | the error grows with distance and towards grazing |
//! | [`Stable`], the default | all | numbers with a bound of their error, then wider ones, then the robust number | floats: about half a unit in the median, at most 16 except for grazing rays, at most 31 down to rays that graze to 10^-7; fixed point: at most 1 unit |
//! | [`Exact`] | `f32`, `FixedI32<F>` | every decision by a sign that is certain | hit, miss, touch, part and order are those of exact arithmetic; `t` within one unit |
//!
//! Each tier gives the right hits for more rays than the one above it in the table, and in most cases costs more.
//!
//! The promises hold for placed solids too. A frame's position and axes are taken as stored, and the transformation
//! into the frame is part of the computation. Stored axes are perpendicular only to their last bits; a sphere in a
//! frame is nevertheless an exact sphere. Of affine maps the promises hold where the largest factor by which they
//! stretch is at most 1,000 times the smallest; those of [`Exact`] always.
//!
//! Measured errors are in [docs/accuracy.md](https://github.com/raylet-rs/raylet/blob/main/docs/accuracy.md).

use crate::grid::Guards;
use crate::query::Solve;
use crate::scalar::Scalar;

pub use crate::exact::{Exact, Precision};

mod sealed {
    pub trait Sealed {}
}

/// An accuracy tier for a number type. Sealed.
pub trait Tier<S: Scalar>: Copy + sealed::Sealed + Solve<S> + 'static {}

/// The cheapest tier.
///
/// It evaluates the equations once, in the scalar's own numbers. It does not test whether rounding may have decided,
/// and computes nothing again: in floats a program that calls only this tier contains no wider number and takes the
/// least flash. (In fixed point it takes no less time or flash than [`Fast`].)
///
/// No hit is lost or invented if the chord is at least a hundredth of the solid's size and the ray starts within 10
/// sizes (of a stretched solid also within 10^5 times its size along the axis along which it is narrowest), except
/// within 64 units in the last place of a rim, or 16 of a start on the surface, where the direction is within 10^-5 of
/// that of a cone's generator, and where the line passes a torus within 10^-4 of its minor radius of touching it. Of a
/// solid that is not convex the gap between two chords counts as a chord does. The same holds for a line that has no
/// chord, since it meets the surface once or not at all, unless the ray grazes (see [`tier`](self)). A ray that departs
/// inwards, within 10^-7 of the surface, may meet it again where it started; so may one that departs outwards from a
/// solid that is not convex. Nothing else is promised: with growing distance and towards grazing, `t` loses digits, and
/// then hits are lost or invented. Where the square of a size or a distance is infinite (`f32`: from 1e19 on), or for
/// cones and triangles its fourth power (from 4e9 on), an end may be missing.
/// Measured errors are in [docs/accuracy.md](https://github.com/raylet-rs/raylet/blob/main/docs/accuracy.md).
///
/// ```
/// use raylet::{Cone, Ray, UnitVec3, Vec3, tier::Plain};
/// let ray = Ray::new(Vec3::new(0.0_f32, 1.5, 4.0), -UnitVec3::Z)?;
/// let hit = Cone::capped(0.5, 2.0)?.nearest_at::<Plain>(&ray);
/// assert_eq!(hit.map(|hit| hit.t), Some(3.25));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Plain;

impl sealed::Sealed for Plain {}
impl<S: Scalar> Tier<S> for Plain {}

/// The tier between [`Plain`] and [`Stable`].
///
/// It computes as [`Plain`] does, with one guard: the discriminant must not be small relative to its terms, nor the
/// angle to a plane, nor the volume that decides on which side of a triangle's edge a ray passes. Where it is, the
/// robust number decides. Through an [`Affine`](crate::Affine) map, and for a ray that departs, it computes with a
/// bound of the error as [`Stable`] does, since such a guard is not enough there. In fixed point lengths are on a
/// common grid of 28 to 30 bits (of 56 to 60 bits for 64-bit types), and the robust number decides where that has no
/// room.
///
/// No hit is lost or invented if the chord is at least a hundredth of the solid's size and the ray starts within 100
/// sizes, except within 16 units in the last place of a rim, or of a start on the surface. Of a solid that is not
/// convex the gap between two chords counts as a chord does. The same holds for a line that has no chord, since it
/// meets the surface once or not at all, unless the ray grazes (see [`tier`](self)).
///
/// ```
/// use raylet::{Ray, Sphere, UnitVec3, Vec3, tier::Fast};
/// let ray = Ray::new(Vec3::new(0.0_f32, 0.5, 4.0), -UnitVec3::Z)?;
/// let hit = Sphere::new(1.0)?.nearest_at::<Fast>(&ray);
/// assert_eq!(hit.map(|hit| hit.t), Some(3.1339746));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fast;

impl sealed::Sealed for Fast {}
impl Guards for Fast {
    const GUARDED: bool = false;
}
impl<S: Scalar> Tier<S> for Fast {}

/// The default tier.
///
/// Floats compute in numbers with a bound of their error. Where a sign or a `t` is not certain enough, the line is
/// transformed again in double-words; where that is not enough, the robust number decides by the signs of its rounded
/// values. Fixed point computes on a grid of integers, with a guard at each difference that may cancel.
///
/// Error of `t` for floats: about half a unit in the last place in the median, at most 16 units except for grazing rays
/// (see [`tier`](self)), and at most 31 units down to rays that graze to 10^-7. For fixed point: at most one unit. For
/// a hit within a thousandth of the solid's size of the ray's start these are units of the size. Measured errors are in
/// [docs/accuracy.md](https://github.com/raylet-rs/raylet/blob/main/docs/accuracy.md).
///
/// Within one unit of a rim or a seam (in space, or in the `t` of its plane), of touching, or of the range's start,
/// rounding may decide the hit, its part or its crossing. In fixed point the promise does not hold for a ray within
/// some 10^-11 of a generator of a turned cone: `t` may then be 20 units off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stable;

impl sealed::Sealed for Stable {}
impl Guards for Stable {
    const GUARDED: bool = true;
}
impl<S: Scalar> Tier<S> for Stable {}

impl sealed::Sealed for Exact {}
impl Tier<f32> for Exact {}
#[cfg(feature = "fixed")]
impl<F: fixed::types::extra::LeEqU32 + Send + Sync + 'static> Tier<fixed::FixedI32<F>> for Exact {}
