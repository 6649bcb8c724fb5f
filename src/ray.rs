//! Rays, their ranges, and where they depart from.

use crate::part::Part;
use crate::scalar::{Scalar, ValueError};
use crate::vector::{UnitVec3, Vec3};
use core::fmt;

/// A closed range of `t`; what lies outside is not reported.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Range<S> {
    start: S,
    end: S,
}

impl<S: Scalar> Range<S> {
    /// From the origin as far as the number type reaches: `[0, MAX]`. The default of every ray.
    pub const FORWARD: Self = Self { start: S::ZERO, end: S::BUDGET.distance };

    /// The closed range `[start, end]`.
    ///
    /// # Errors
    ///
    /// [`RayError::RangeEnd`] if an end is not finite, [`RayError::Range`] if `start > end`.
    #[inline]
    pub fn new(start: S, end: S) -> Result<Self, RayError> {
        if !(start.is_finite() && end.is_finite()) {
            Err(RayError::RangeEnd(ValueError::NotFinite))
        } else if start <= end {
            Ok(Self { start, end })
        } else {
            Err(RayError::Range)
        }
    }

    /// The whole line, in both directions.
    pub fn line() -> Self {
        Self { start: -S::BUDGET.distance, end: S::BUDGET.distance }
    }

    /// The lower end.
    #[inline(always)]
    pub const fn start(self) -> S {
        self.start
    }

    /// The upper end.
    #[inline(always)]
    pub const fn end(self) -> S {
        self.end
    }

    /// True if `t` lies in the range, its ends included.
    #[inline(always)]
    pub fn contains(self, t: S) -> bool {
        self.start <= t && t <= self.end
    }
}

/// Towards which side of a surface a ray departs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Leaving {
    /// Along the outward normal: reflected outside, or refracted out.
    Outwards,
    /// Against the outward normal: refracted in, or reflected inside.
    Inwards,
}

/// Where a ray departs from: the reason that no epsilon is needed.
///
/// A ray that starts at a hit starts *on* that surface, whatever the rounding of its origin says: on a convex solid a
/// ray leaving outwards cannot meet that solid again, and one leaving inwards must meet its far end; on the quadric
/// that it left, the constant term is exactly zero and the other root is `-2k/a`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Departure {
    /// The object in its scene. A primitive or a shape asked alone takes every departure for its own.
    pub object: u32,
    /// The part of the surface.
    pub part: Part,
    /// The side to which the ray leaves.
    pub leaving: Leaving,
}

/// A half-line (or a piece of a line): origin, direction, range of `t`, and where it departs from.
///
/// `t` is distance, since a direction is a unit vector by type.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ray<S: Scalar> {
    origin: Vec3<S>,
    direction: UnitVec3<S>,
    range: Range<S>,
    departure: Option<Departure>,
}

impl<S: Scalar> Ray<S> {
    /// The ray's whole line in doubles.
    #[inline(always)]
    pub(crate) fn in_doubles(&self) -> Ray<f64> {
        Ray {
            origin: self.origin.in_doubles(),
            direction: self.direction.in_doubles(),
            range: Range::line(),
            departure: self.departure,
        }
    }

    /// The ray from `origin` towards `direction`, with the range `[0, MAX]`.
    ///
    /// # Errors
    ///
    /// [`RayError::Origin`] if a coordinate is not finite or beyond the number type's
    /// [`Budget`](crate::scalar::Budget).
    ///
    /// ```
    /// # use raylet::{Ray, UnitVec3, Vec3};
    /// let ray = Ray::new(Vec3::new(0.0_f32, 0.0, 5.0), -UnitVec3::Z)?;
    /// assert_eq!(ray.at(2.0), Vec3::new(0.0, 0.0, 3.0));
    /// # Ok::<(), raylet::RayError>(())
    /// ```
    #[inline]
    pub fn new(origin: Vec3<S>, direction: UnitVec3<S>) -> Result<Self, RayError> {
        let origin = origin.checked().map_err(RayError::Origin)?;
        Ok(Self { origin, direction, range: Range::FORWARD, departure: None })
    }

    /// The ray from `origin` towards the point `target`.
    ///
    /// # Errors
    ///
    /// [`RayError::Origin`] as for [`Ray::new`]; [`RayError::Target`] if `target` is not within the budget;
    /// [`RayError::Direction`] if the two points are equal.
    pub fn towards(origin: Vec3<S>, target: Vec3<S>) -> Result<Self, RayError> {
        let origin = origin.checked().map_err(RayError::Origin)?;
        let target = target.checked().map_err(RayError::Target)?;
        // In the computing number: across the whole budget the difference is more than a fixed type holds.
        let ([ox, oy, oz], [tx, ty, tz]) = (origin.real(), target.real());
        let direction =
            UnitVec3::from_real([tx - ox, ty - oy, tz - oz]).ok_or(RayError::Direction(ValueError::Zero))?;
        Self::new(origin, direction)
    }

    /// The same ray with another range of `t`.
    #[inline]
    #[must_use]
    pub const fn with_range(self, range: Range<S>) -> Self {
        Self { range, ..self }
    }

    /// The same ray, departing from a surface; see [`Departure`].
    #[inline]
    #[must_use]
    pub const fn departing(self, departure: Departure) -> Self {
        Self { departure: Some(departure), ..self }
    }

    /// The same ray, departing from nowhere.
    #[inline]
    #[must_use]
    pub const fn without_departure(self) -> Self {
        Self { departure: None, ..self }
    }

    /// Where `t` is zero.
    #[inline(always)]
    pub const fn origin(&self) -> Vec3<S> {
        self.origin
    }

    /// The direction in which `t` grows.
    #[inline(always)]
    pub const fn direction(&self) -> UnitVec3<S> {
        self.direction
    }

    /// The range of `t`.
    #[inline(always)]
    pub const fn range(&self) -> Range<S> {
        self.range
    }

    /// Where the ray departs from.
    #[inline(always)]
    pub const fn departure(&self) -> Option<Departure> {
        self.departure
    }

    /// The point at `t`.
    #[inline]
    pub fn at(&self, t: S) -> Vec3<S> {
        S::advance(self.origin.to_array(), self.direction.to_array(), t).into()
    }
}

/// Why a ray cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RayError {
    /// A coordinate of the origin is not finite or beyond the budget.
    Origin(ValueError),
    /// A coordinate of the target is not finite or beyond the budget.
    Target(ValueError),
    /// The vector that gives the direction is zero, not finite or beyond the budget.
    Direction(ValueError),
    /// An end of the range is not finite.
    RangeEnd(ValueError),
    /// The range's start lies above its end.
    Range,
}

impl fmt::Display for RayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Origin(error) => write!(f, "a coordinate of the ray's origin {error}"),
            Self::Target(error) => write!(f, "a coordinate of the ray's target {error}"),
            Self::Direction(ValueError::Zero) => {
                f.write_str("the ray has no direction: the vector is zero, or origin and target are the same point")
            }
            Self::Direction(error) => write!(f, "the vector of the ray's direction {error}"),
            Self::RangeEnd(error) => write!(f, "an end of the ray's range {error}"),
            Self::Range => f.write_str("the ray's range is empty: its start lies above its end"),
        }
    }
}

impl core::error::Error for RayError {}
