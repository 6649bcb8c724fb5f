//! Floor 3: a ray as a primitive sees it.
//!
//! A placement turns a ray into a [`Line`] in the primitive's own frame and keeps, in [`Local`], what leads back to
//! the ray's `t`. On the way the origin is moved close to the solid where the number type would otherwise lose the
//! solid in the rounding of far coordinates, and everything is brought near 1 by a power of two, so that no square
//! overflows. Both are exact, or rounded once.

use crate::part::Part;
use crate::ray::{Leaving, Ray};
use crate::scalar::certain::FromScalar;
use crate::scalar::{PlainLine, Real, Scalar, largest};
use crate::vector::Vec3;
use core::cmp::Ordering;

/// An infinite line in the frame of a primitive, and the part that it departs from at `t = 0`.
#[derive(Clone, Copy, Debug)]
pub struct Line<S: Scalar> {
    /// To be read as `2^-finer` times itself: of a fixed-point line, seen through a placement, more bits than those of the
    /// type are known.
    pub(crate) origin: [S; 3],
    /// What the origin's rounding left over, where it has been moved.
    pub(crate) rest: [S; 3],
    pub(crate) finer: i32,
    pub(crate) direction: [S::Unit; 3],
    /// The length by which the direction was divided, where a `t` must be divided by it before it is rounded.
    pub(crate) stretch: Option<S::Real>,
    pub(crate) departure: Option<(Part, Leaving)>,
}

impl<S: Scalar> Line<S> {
    /// The line's departure, if it departs from this part.
    #[inline]
    pub(crate) fn departs_from(&self, part: Part) -> Option<Leaving> {
        self.departure.and_then(|(from, leaving)| (from == part).then_some(leaving))
    }

    /// The exact value of a coordinate of the origin.
    #[inline(always)]
    pub(crate) fn coordinate(&self, i: usize) -> S::Real {
        let value = self.origin[i].real();
        if S::RELATIVE { value } else { value.times_power_of_two(-self.finer) }
    }

    /// How the height of the origin compares with a bound.
    #[inline]
    pub(crate) fn compare_height(&self, bound: S) -> Option<Ordering> {
        if self.finer == 0 { self.origin[1].partial_cmp(&bound) } else { self.coordinate(1).partial_cmp(&bound.real()) }
    }

    /// True if the origin is so far above the bound (below it, if `below`) that the `t` of a crossing behind it does not
    /// round to zero.
    #[inline]
    pub(crate) fn is_clear_of(&self, bound: S, below: bool) -> bool {
        if self.finer == 0 && self.stretch.is_none() {
            return if below { self.origin[1] < bound } else { self.origin[1] > bound };
        }
        let above = self.coordinate(1) - bound.real();
        let unit = S::BUDGET.smallest_size.real();
        let unit = self.stretch.map_or(unit, |stretch| unit * stretch);
        (if below { -above } else { above }) > unit
    }

    /// The height of the point at `t`, rounded.
    #[inline]
    pub(crate) fn height_at(&self, t: S) -> S {
        if self.finer == 0 && self.stretch.is_none() {
            let [_, y, _] = S::advance(self.origin, self.direction, t);
            return y.plus(self.rest[1]);
        }
        let along = self.stretch.map_or(t.real(), |stretch| t.real() * stretch);
        S::round(self.coordinate(1) + along * S::unit_real(self.direction[1]))
    }
}

/// The way from the world to a primitive's frame.
pub trait Place<S: Scalar> {
    /// The ray as the primitive sees it; `None` if even its closest point is farther than the number type reaches.
    /// `reach` is the distance from the frame's origin within which the primitive lies; where it has no end, `is_far`
    /// says whether a point several reaches away is far from its surface too.
    fn localize(&self, ray: &Ray<S>, reach: S, is_far: impl FnOnce(Vec3<S>) -> bool) -> Option<Local<S>>;
    /// The ray for plain integers, where the placement is simple enough for them.
    #[inline(always)]
    fn plain_line(&self, _: &Ray<S>) -> Option<PlainLine<S>> {
        None
    }
    /// A world point in the primitive's frame, rounded.
    fn to_local(&self, point: Vec3<S>) -> Vec3<S>;
    /// Origin and direction of the ray's line in the primitive's frame, without rounding but for that of the numbers
    /// asked for. The direction has any length: `t` is the ray's own.
    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2];
    /// A point in the primitive's frame, as [`Place::line`].
    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3];
}

/// The frame that is the world's.
#[derive(Clone, Copy, Debug)]
pub struct InWorld;

impl<S: Scalar> Place<S> for InWorld {
    #[inline]
    fn localize(&self, ray: &Ray<S>, reach: S, is_far: impl FnOnce(Vec3<S>) -> bool) -> Option<Local<S>> {
        Some(Local::in_world(ray, reach, is_far))
    }
    #[inline(always)]
    fn plain_line(&self, ray: &Ray<S>) -> Option<PlainLine<S>> {
        Some(PlainLine { origin: ray.origin().to_array(), finer: 0, direction: ray.direction().to_array() })
    }
    #[inline]
    fn to_local(&self, point: Vec3<S>) -> Vec3<S> {
        point
    }
    #[inline]
    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2] {
        [ray.origin().to_array().map(N::scalar), ray.direction().to_array().map(N::unit)]
    }
    #[inline]
    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        point.to_array().map(N::scalar)
    }
}

/// A [`Line`] and the way from its `t` back to that of the ray: `t = start + t_line * 2^exponent / stretch`.
///
/// (In fixed point exponent and start are always zero, and the line itself divides by the stretch.)
#[derive(Clone, Copy, Debug)]
pub struct Local<S: Scalar> {
    pub(crate) line: Line<S>,
    pub(crate) exponent: i32,
    start: S,
    stretch: Option<S::Real>,
}

impl<S: Scalar> Local<S> {
    /// The ray in a frame that is the world's.
    #[inline]
    fn in_world(ray: &Ray<S>, reach: S, is_far: impl FnOnce(Vec3<S>) -> bool) -> Self {
        let (mut origin, direction) = (ray.origin().to_array(), ray.direction().to_array());
        let (mut start, mut rest) = (S::ZERO, [S::ZERO; 3]);
        if let Some(step) = S::step_closer(S::dot(origin, direction), reach)
            && ray.departure().is_none()
            && is_far(ray.origin())
        {
            let moved = S::walk(origin, Vec3::<S>::ZERO.to_array(), direction, step);
            origin = moved.map(|[near, _]| near);
            rest = moved.map(|[_, rest]| rest);
            start = step;
        }
        let mut local = Self::new(ray, (origin, 0), direction, start, None, reach);
        local.line.rest = rest.map(|component| component.scaled(-local.exponent));
        local
    }

    /// From the origin, as [`Scalar::finest`] gives it, and the direction in the primitive's frame. `start` is the `t` to
    /// which the origin has been moved, `stretch` the length by which the direction was divided.
    #[inline]
    pub(crate) fn new(
        ray: &Ray<S>,
        (origin, finer): ([S; 3], i32),
        direction: [S::Unit; 3],
        start: S,
        stretch: Option<S::Real>,
        size: S,
    ) -> Self {
        let exponent = S::binary_exponent(largest([origin[0], origin[1], origin[2], size]));
        let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
        let origin = origin.map(|component| component.scaled(-exponent));
        let (of_line, after) = if S::RELATIVE { (None, stretch) } else { (stretch, None) };
        let line = Line { origin, rest: [S::ZERO; 3], finer, direction, stretch: of_line, departure };
        Self { line, exponent, start, stretch: after }
    }

    /// The ray's `t` for a `t` on the line.
    #[inline]
    pub(crate) fn to_ray(self, t: S) -> S {
        if !t.is_finite() {
            return t;
        }
        match self.stretch {
            None => self.start.plus(t.scaled(self.exponent)),
            Some(stretch) => self.start.plus(S::round(t.scaled(self.exponent).real() / stretch)),
        }
    }

    /// True if lengths along the line are those along the ray.
    #[inline]
    pub(crate) fn is_unstretched(&self) -> bool {
        self.stretch.is_none() && self.line.stretch.is_none()
    }

    /// True if the ray's range is the line's `t >= 0`, or a beginning of it, and it departs from nowhere.
    #[inline]
    pub(crate) fn is_forward(&self, ray: &Ray<S>) -> bool {
        self.start == S::ZERO && ray.range().start() == S::ZERO && self.line.departure.is_none()
    }
}
