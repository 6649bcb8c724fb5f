//! Floor 5: what every primitive knows of itself.

use crate::arithmetic::Arithmetic;
use crate::figure::Figure;
use crate::line::Line;
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::{Plain, PlainLine, Scalar, found};
use crate::span::Meeting;
use crate::vector::{UnitVec3, Vec3};

/// What every primitive knows of itself, in its own frame.
pub trait Geometry<S: Scalar>: Copy {
    /// A distance from the origin within which the primitive lies; its characteristic size if it is unbounded.
    fn reach(&self) -> S;
    /// True if a point that is several reaches from the origin is far from the surface too; for what is unbounded.
    fn is_far(&self, _: Vec3<S>) -> bool {
        true
    }
    /// The primitive with all lengths multiplied by `2^e`, for an exponent from [`Scalar::binary_exponent`].
    #[must_use]
    fn scaled(&self, e: i32) -> Self;
    /// Where the line meets it.
    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S>;
    /// Where the line meets it, if the short way tells.
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>>;
    /// Whether the half-line `t >= 0` hits it, if the short way tells; agrees with [`Geometry::meet_plainly`].
    #[inline(always)]
    fn meets_ahead_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<()> {
        let meeting = found!(self.meet_plainly::<T>(line));
        if meeting.nearest(Range::FORWARD, |_| true).is_some() { Plain::Found(()) } else { Plain::Miss }
    }
    /// Whether the half-line `t >= 0` hits it, where the signs of the coefficients say so without a root or a division;
    /// the line departs from nowhere. What is said here must agree with [`Geometry::meet`].
    fn verdict<T: Arithmetic<S>>(&self, _: &Line<S>) -> Option<bool> {
        None
    }
    /// The primitive as the exact solver sees it.
    fn figure(&self) -> Figure<S>;
    /// True if the point belongs to the closed set.
    fn contains(&self, point: Vec3<S>) -> bool;
    /// The smallest box, as its lower and upper corner; infinite where the primitive is.
    fn bounds(&self) -> (Vec3<S>, Vec3<S>);
    /// The point of the part that is nearest, or nearly so, to a point close to it.
    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S>;
    /// The outward unit normal at a point of the part.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S>;
    /// Surface coordinates at a point of the part, each in `[0, 1]`.
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit);
    /// The directions in which `u` and `v` grow at a point of the part.
    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>);
}

/// An axis-aligned box; components may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bounds<S> {
    /// The corner with the smallest coordinates.
    pub low: Vec3<S>,
    /// The corner with the largest coordinates.
    pub high: Vec3<S>,
}
