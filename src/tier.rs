//! Accuracy tiers, chosen by type.
//!
//! | tier | numbers | what it does | promise |
//! |---|---|---|---|
//! | [`Fast`] | all | closest approach and moments, nothing compensated | error grows with distance and towards grazing |
//! | [`Stable`], the default | all | moments, roots without cancellation, compensated coefficients where they cancel | about half a unit in the last place in the middle, at most 16 away from grazing |
//! | [`Exact`] | `f32`, `FixedI32<F>` | every decision by a certain sign | hit, miss, touch, part and order are those of exact arithmetic; `t` within one unit |
//!
//! What was measured is in `docs/accuracy.md`.

use crate::query::Solve;
use crate::scalar::Scalar;

pub use crate::exact::Certain;
pub use crate::exact::{Effort, Exact};

mod sealed {
    pub trait Sealed {}
}

/// Whether a tier's fast path answers where its rounding may decide.
pub trait Guards: 'static {
    /// True if the fast path leaves such rays to the robust number.
    const GUARDED: bool;
}

/// An accuracy tier for a number type: what it costs is decided when the code is compiled. Sealed.
pub trait Tier<S: Scalar>: Copy + sealed::Sealed + Solve<S> + 'static {}

/// The cheapest tier that is not the textbook: closest approach for the sphere, moments for the rest, in the scalar's own
/// width (fixed point: lengths on a common grid of 28 to 30 bits, or of 56 to 60), and nothing compensated.
///
/// Of a sphere it takes the direction for exactly unit, which costs `t` an error of about a unit in the last place of the
/// direction. Error grows with distance and towards grazing; rays nearly parallel to a cone's generator, and
/// starts near a surface, are as wrong as plain subtraction makes them. What was measured is in `docs/accuracy.md`.
///
/// ```
/// use raylet::{Ray, Sphere, UnitVec3, Vec3, tier::Fast};
/// let ray = Ray::new(Vec3::new(0.0_f32, 0.5, 4.0), -UnitVec3::Z)?;
/// let hit = Sphere::new(1.0)?.nearest_at::<Fast>(&ray);
/// assert_eq!(hit.map(|hit| hit.t), Some(3.1339746));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fast;

impl sealed::Sealed for Fast {}
impl Guards for Fast {
    const GUARDED: bool = false;
}
impl<S: Scalar> Tier<S> for Fast {}

/// The default tier: moments instead of differences of squares, roots without cancellation, compensated
/// coefficients where they cancel; in the scalar's own computing number.
///
/// The usual ray is answered by the plain formulas, where a comparison for each difference says that nothing cancels; the others by
/// the solver.
///
/// Promise for floats: about half a unit in the last place in the middle, and at most 16 away from grazing at any distance to
/// 10,000 (measured: 13); at most 31 however closely a ray grazes, to 10^-7. Not for starts on the surface of a round solid, whose
/// `t` is next to nothing. For fixed point: at most one unit, but within 10^-4 of a generator of a cone, where `t` is as
/// ill-conditioned as it is long (measured: 2.1 in `I16F16`), or of the axis of a cylinder (1.12). What was measured is in
/// `docs/accuracy.md`.
///
/// What is decided within one unit of a rim or a seam, or of the range's start, is decided by rounding: two ends that
/// round to the same `t` at a rim are reported as a touch, and a hit at a capsule's seam may be given to either part.
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
