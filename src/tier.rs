//! Accuracy tiers, chosen by type.
//!
//! | tier | numbers | what it does | promise |
//! |---|---|---|---|
//! | [`Fast`] | all | the fast path in the type's own width; the robust number where that cannot tell | error grows with distance and towards grazing, most of all for spheres |
//! | [`Stable`], the default | all | the fast path with guards; where one fails, the robust number | about half a unit in the last place in the middle, at most 16 away from grazing and 31 at any ray that grazes to 10^-7; at most 1 unit in fixed point |
//! | [`Exact`] | `f32`, `FixedI32<F>` | every decision by a certain sign | hit, miss, touch, part and order are those of exact arithmetic; `t` within one unit |
//!
//! The promises hold for solids as they are placed: a frame's position and axes are taken as stored, and the way into the frame is part of the
//! computation. A ball under a frame has no axes.
//!
//! What was measured is in `docs/accuracy.md`.

use crate::fast::Guards;
use crate::query::Solve;
use crate::scalar::Scalar;

pub use crate::exact::Certain;
pub use crate::exact::{Effort, Exact};

mod sealed {
    pub trait Sealed {}
}

/// An accuracy tier for a number type: what it costs is decided when the code is compiled. Sealed.
pub trait Tier<S: Scalar>: Copy + sealed::Sealed + Solve<S> + 'static {}

/// The cheapest tier that is not the textbook: closest approach for the sphere, moments for the rest, in the scalar's own
/// width (fixed point: lengths on a common grid of 28 to 30 bits, or of 56 to 60). Where the fast path of the other solids is unsure, the
/// robust number decides.
///
/// Of a sphere it takes the direction for exactly unit, which costs `t` an error of about a unit in the last place of the
/// direction, and takes its word however far away and however closely the ray grazes. What was measured is in `docs/accuracy.md`.
///
/// No hit is lost or invented where the chord is at least a hundredth of the solid's size and the start within 100 sizes, but within 16 units
/// of a rim or of a start on the surface.
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

/// The default tier: a fast path with a guard at each difference that may cancel; where a guard fails, the solver in a number of 64 bits (of
/// 128 for 64-bit types), whose signs are taken at their word.
///
/// For floats: about half a unit in the last place in the middle, at most 16 away from grazing, and at most 31 however closely a ray grazes, to
/// 10^-7. For fixed point: at most one unit. What was measured is in `docs/accuracy.md`.
///
/// What is decided within one unit of a rim or a seam, of touching, or of the range's start, is decided by rounding.
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
