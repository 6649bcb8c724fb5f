//! Rays, their ranges, and where they depart from.

use crate::number::{Estimate, difference, dot};
use crate::part::Part;
use crate::scalar::{FromScalar, Scalar, ValueError, with_fault};
use crate::vector::{UnitVec3, Vec3};
use core::fmt;

/// A closed range of `t`. Hits outside it are not reported.
#[derive(Clone, Copy, Debug, PartialEq)]
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

    /// From `start` as far as the number type reaches.
    ///
    /// # Errors
    ///
    /// [`RayError::RangeEnd`] if `start` is not finite or beyond the largest distance.
    ///
    /// ```
    /// # use raylet::{Range, Ray, Sphere, UnitVec3, Vec3};
    /// let beam = Ray::new(Vec3::new(-3.0_f32, 0.0, 0.0), UnitVec3::X)?.with_range(Range::from(2.5)?);
    /// assert_eq!(Sphere::new(1.0)?.nearest(&beam).map(|hit| hit.t), Some(4.0));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn from(start: S) -> Result<Self, RayError> {
        match start {
            _ if !start.is_finite() => Err(RayError::RangeEnd(ValueError::NotFinite)),
            _ if start > S::BUDGET.distance => Err(RayError::RangeEnd(ValueError::BeyondBudget)),
            _ => Ok(Self { start, end: S::BUDGET.distance }),
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
/// The rounded origin of a ray that starts at a hit may lie on either side of the surface. With a departure the solver
/// takes it to lie exactly *on* the surface. A ray that leaves a convex solid outwards then never meets that solid
/// again, and one that leaves inwards always meets its far side. In the equation `a t^2 + 2 k t + c = 0` of the quadric
/// that the ray departs from, `c` is zero and the other root is `-2k/a`.
/// [`Surface::departure`](crate::Surface::departure) makes one from a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Departure {
    /// The index of the object in its scene. The queries of a primitive or a shape ignore it: they assume that every
    /// ray with a departure departs from that shape.
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
    /// The ray's whole line in another type.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    pub(crate) fn in_type<R: crate::scalar::Including<S>>(&self) -> Ray<R> {
        Ray {
            origin: self.origin.in_type(),
            direction: self.direction.in_type(),
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
        Ok(Self::from_within(origin.checked().map_err(RayError::Origin)?, direction))
    }

    /// The ray from an origin that is known to be within the budget.
    #[inline(always)]
    pub(crate) const fn from_within(origin: Vec3<S>, direction: UnitVec3<S>) -> Self {
        Self { origin, direction, range: Range::FORWARD, departure: None }
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
        // In the computing number: the difference of two points within the budget may be too large for a fixed type.
        let ([ox, oy, oz], [tx, ty, tz]) = (origin.real(), target.real());
        let direction =
            UnitVec3::from_real([tx - ox, ty - oy, tz - oz]).ok_or(RayError::Direction(ValueError::NoDirection))?;
        Self::new(origin, direction)
    }

    /// The segment from `a` to `b`: the ray from `a` towards `b`, whose range ends at `b`.
    ///
    /// The end is the `t` of the point of the ray's line, as its direction is stored, that is closest to `b`, rounded
    /// to nearest. Whether a surface through `b` is hit depends on that rounding.
    ///
    /// # Errors
    ///
    /// As [`Ray::towards`]; [`RayError::RangeEnd`] if `b` is farther from `a` than the largest distance of a fixed
    /// type.
    ///
    /// ```
    /// # use raylet::{Ray, Sphere, Vec3};
    /// let ball = Sphere::new(1.0_f32)?;
    /// let from = Vec3::new(-5.0, 0.0, 0.0);
    /// assert!(!ball.occludes(&Ray::segment(from, Vec3::new(-2.0, 0.0, 0.0))?));
    /// assert!(ball.occludes(&Ray::segment(from, Vec3::new(-1.0, 0.0, 0.0))?));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn segment(a: Vec3<S>, b: Vec3<S>) -> Result<Self, RayError> {
        let ray = Self::towards(a, b)?;
        let [from, to] = [a, b].map(|point| point.to_array().map(<S::Robust as FromScalar<S>>::scalar));
        let direction = ray.direction.to_array().map(<S::Robust as FromScalar<S>>::unit);
        // Divided by the square of the direction's length, which is 1 except for rounding.
        let end = S::from_robust(dot(difference(to, from), direction).over(dot(direction, direction)));
        if end.is_finite() && end <= S::BUDGET.distance {
            Ok(ray.with_range(Range { start: S::ZERO, end }))
        } else {
            Err(RayError::RangeEnd(ValueError::BeyondBudget))
        }
    }

    /// The ray from `origin` along a vector of any length, with the vector's length: see [`Along`].
    ///
    /// # Errors
    ///
    /// [`RayError::Origin`] as for [`Ray::new`]; [`RayError::Direction`] if the vector is zero, not finite or beyond
    /// the budget.
    pub fn along(origin: Vec3<S>, vector: Vec3<S>) -> Result<Along<S>, RayError> {
        let vector = vector.checked().map_err(RayError::Direction)?;
        let direction = UnitVec3::new(vector).map_err(RayError::Direction)?;
        Ok(Along { ray: Self::new(origin, direction)?, length: vector.length() })
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

/// A ray along a vector, made by [`Ray::along`], and the vector's length.
///
/// The `t` of the ray's hits is distance, as always (rule 4 of the contract); [`Along::in_lengths`] gives it in lengths
/// of the vector.
///
/// ```
/// # use raylet::{Ray, Sphere, Vec3};
/// // What moves by (8, 0, 0) in a second meets the ball after half a second, 4 away.
/// let path = Ray::along(Vec3::new(-5.0_f32, 0.0, 0.0), Vec3::new(8.0, 0.0, 0.0))?;
/// let hit = Sphere::new(1.0)?.nearest(&path.ray()).expect("it is ahead");
/// assert_eq!((hit.t, path.in_lengths(hit.t)), (4.0, 0.5));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along<S: Scalar> {
    ray: Ray<S>,
    length: S,
}

impl<S: Scalar> Along<S> {
    /// From a stored length, which must be that of a vector with a direction.
    #[cfg(feature = "serde")]
    pub(crate) fn from_stored(ray: Ray<S>, length: S) -> Result<Self, RayError> {
        // The comparison is false for NaN.
        if length >= S::BUDGET.smallest_size && length.is_finite() {
            Ok(Self { ray, length })
        } else {
            Err(RayError::Direction(ValueError::of_size(length, S::BUDGET.smallest_size)))
        }
    }

    /// The ray, with the range `[0, MAX]`.
    #[inline]
    pub const fn ray(&self) -> Ray<S> {
        self.ray
    }

    /// The length of the vector, rounded to the number type.
    #[inline]
    pub const fn length(&self) -> S {
        self.length
    }

    /// The distance `t` in lengths of the vector: `t / length`, rounded to nearest; [`Scalar::INFINITY`] with its sign
    /// beyond the number type.
    pub fn in_lengths(&self, t: S) -> S {
        S::round(t.real() / self.length.real())
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

impl RayError {
    /// The message.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Origin(error) => with_fault!("a coordinate of the ray's origin ", error),
            Self::Target(error) => with_fault!("a coordinate of the ray's target ", error),
            Self::Direction(ValueError::NoDirection | ValueError::Zero) => {
                "the ray has no direction: the vector is zero, or origin and target are the same point"
            }
            Self::Direction(error) => with_fault!("the vector of the ray's direction ", error),
            Self::RangeEnd(error) => with_fault!("an end of the ray's range ", error),
            Self::Range => "the ray's range is empty: its start lies above its end",
        }
    }
}

impl fmt::Display for RayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for RayError {}
