//! Rays, their ranges, and where they depart from.

use crate::part::Part;
use crate::scalar::Scalar;
use crate::vector::{UnitVec3, Vec3};
use core::fmt;

/// A closed range of `t`. Hits outside it are not reported.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Range<S> {
    start: S,
    end: S,
}

impl<S: Scalar> Range<S> {
    /// From the origin to the largest `t` of the number type: `[0, MAX]`. The default of every ray.
    pub const FORWARD: Self = Self { start: S::ZERO, end: S::BUDGET.distance };

    /// The closed range `[start, end]`.
    ///
    /// # Errors
    ///
    /// [`RayError::Range`] if an end is not finite or `start > end`.
    #[inline]
    pub fn new(start: S, end: S) -> Result<Self, RayError> {
        if start.is_finite() && end.is_finite() && start <= end {
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

/// The surface that a secondary ray starts on, so that it needs no epsilon to avoid hitting that surface at once.
///
/// The rounded origin of a ray that starts at a hit may lie on either side of the surface. With a departure the solver takes it
/// to lie exactly *on* the surface. A ray that leaves a convex solid outwards then never meets that solid again, and one that leaves
/// inwards always meets its far side. In the equation `a t^2 + 2 k t + c = 0` of the quadric that the ray departs from, `c` is zero and the other
/// root is `-2k/a`. [`Surface::departure`](crate::Surface::departure) makes one from a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Departure {
    /// The index of the object in its scene. The queries of a primitive or a shape ignore it: they take every ray with a departure to
    /// depart from that shape.
    pub object: u32,
    /// The part of the surface.
    pub part: Part,
    /// The side to which the ray leaves.
    pub leaving: Leaving,
}

/// A ray: origin, direction, range of `t`, and the surface that it departs from, if any.
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
        if !origin.is_within_budget() {
            return Err(RayError::Origin);
        }
        Ok(Self { origin, direction, range: Range::FORWARD, departure: None })
    }

    /// The ray from `origin` towards the point `target`.
    ///
    /// # Errors
    ///
    /// [`RayError::Origin`] as for [`Ray::new`]; [`RayError::Direction`] if the two points coincide or `target` is
    /// not within the budget.
    pub fn towards(origin: Vec3<S>, target: Vec3<S>) -> Result<Self, RayError> {
        if !origin.is_within_budget() {
            return Err(RayError::Origin);
        }
        if !target.is_within_budget() {
            return Err(RayError::Direction);
        }
        // In the computing number: the difference of two points within the budget may be too large for a fixed type.
        let ([ox, oy, oz], [tx, ty, tz]) = (origin.real(), target.real());
        let direction = UnitVec3::from_real([tx - ox, ty - oy, tz - oz]).ok_or(RayError::Direction)?;
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

    /// The same ray without a departure.
    #[inline]
    #[must_use]
    pub const fn without_departure(self) -> Self {
        Self { departure: None, ..self }
    }

    /// The origin: the point at `t = 0`.
    #[inline(always)]
    pub const fn origin(&self) -> Vec3<S> {
        self.origin
    }

    /// The direction.
    #[inline(always)]
    pub const fn direction(&self) -> UnitVec3<S> {
        self.direction
    }

    /// The range of `t`.
    #[inline(always)]
    pub const fn range(&self) -> Range<S> {
        self.range
    }

    /// The surface that the ray departs from; `None` for a ray without departure.
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
    Origin,
    /// The direction is zero or not finite.
    Direction,
    /// An end of the range is not finite, or its start lies above its end.
    Range,
}

impl fmt::Display for RayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Origin => "the ray's origin is not finite or beyond the number type's budget: move it closer",
            Self::Direction => "the ray's direction is zero or not finite: give a vector with a length",
            Self::Range => "the ray's range is empty or not finite: its start must not lie above its end",
        })
    }
}

impl core::error::Error for RayError {}
