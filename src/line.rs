//! Transformation of a ray's line into the frame of a primitive.

use crate::ray::Ray;
use crate::scalar::{FinerLine, FromScalar, Including, LocalLine, Scalar};
use crate::vector::Vec3;

/// A placement: the transformation from the world to a primitive's frame.
pub trait Place<S: Scalar> {
    /// The same placement in another number type.
    type In<R: Scalar>: Place<R>;

    /// True if the line's own `t` is not the ray's: see [`LocalLine::inverse_length`].
    const STRETCHES: bool = false;
    /// True if [`Place::fast_line_near`] does not handle rays that start far away: floats have [`Place::far_line`] for these.
    const HAS_FAR_LINES: bool = false;

    /// The placement in a type that holds all values of this one.
    fn in_type<R: Including<S>>(&self) -> Self::In<R>;
    /// The line for the fast path; `None` if the placement is not suitable for it.
    fn fast_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>>;
    /// [`Place::fast_line`]; `None` if a ray starts so far from the frame's origin that [`Place::far_line`] should be tried.
    #[inline(always)]
    fn fast_line_near(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        self.fast_line(ray)
    }
    /// [`Place::fast_line`] where the placement stretches and the number type is fixed point, for a solid whose lengths are at most `bounding_radius`.
    #[inline(always)]
    fn finer_line(&self, _ray: &Ray<S>, _bounding_radius: S) -> Option<FinerLine<S>> {
        None
    }
    /// True if the ray's line passes the placement's y axis at a distance greater than `r`; false where rounding may decide, and for placements
    /// that do not know it.
    #[inline(always)]
    fn passes_axis(&self, _ray: &Ray<S>, _r: S) -> bool {
        false
    }
    /// The line of a ray that starts far away, with its origin moved to a point next to the frame's origin.
    #[inline(always)]
    fn far_line(&self, _ray: &Ray<S>) -> Option<LocalLine<S>> {
        None
    }
    /// The line for the fast path of a sphere about the frame's origin, which needs no rotation.
    #[inline(always)]
    fn fast_ball_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        self.fast_line(ray)
    }
    /// The line for the fast path's second attempt, which costs more and is more accurate. Its origin is moved to a point next to the
    /// primitive's point `base`, and is relative to that. In a frame it is moved only if it starts farther away than `near`.
    fn second_line(&self, ray: &Ray<S>, base: Vec3<S>, near: S) -> Option<LocalLine<S>>;
    /// [`Place::second_line`] for a sphere about the frame's origin.
    #[inline(always)]
    fn second_ball_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        self.second_line(ray, Vec3::ZERO, S::ZERO)
    }
    /// Origin and direction of the ray's line in the primitive's frame, rounded only by the operations of the number `N`. The direction may
    /// have any length, so that `t` is the ray's.
    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2];
    /// A point in the primitive's frame, as [`Place::line`].
    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3];
    /// Transforms a gradient from the primitive's frame to the world: by the transpose of the matrix that transforms points to the frame.
    fn gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3];
    /// [`Place::line`] for a sphere about the frame's origin. In a [`Frame`](crate::Frame) it is translated only, since a rotated sphere is the
    /// same sphere; stored axes, which are orthogonal only to their last bits, would deform it.
    #[inline]
    fn ball_line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2] {
        self.line(ray)
    }
    /// [`Place::point`] for a sphere about the frame's origin.
    #[inline]
    fn ball_point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        self.point(point)
    }
    /// [`Place::gradient_to_world`] for a sphere about the frame's origin.
    #[inline]
    fn ball_gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3] {
        self.gradient_to_world(gradient)
    }
}

/// The identity placement.
#[derive(Clone, Copy, Debug)]
pub struct InWorld;

impl<S: Scalar> Place<S> for InWorld {
    type In<R: Scalar> = Self;
    const HAS_FAR_LINES: bool = S::RELATIVE;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Self::In<R> {
        Self
    }
    #[inline(always)]
    fn fast_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        Some(LocalLine::along(ray.origin().to_array(), ray.direction().to_array(), S::ZERO))
    }
    #[inline(always)]
    fn fast_line_near(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        let is_far = S::is_far(ray.origin().to_array(), ray.direction().to_array());
        if is_far { None } else { self.fast_line(ray) }
    }
    #[inline(always)]
    fn far_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        S::fast_from_afar(ray.origin().to_array(), ray.direction().to_array())
    }
    #[inline(always)]
    fn second_line(&self, ray: &Ray<S>, base: Vec3<S>, _near: S) -> Option<LocalLine<S>> {
        S::fast_closer(ray.origin().to_array(), ray.direction().to_array(), base.to_array())
    }
    #[inline]
    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2] {
        [ray.origin().to_array().map(N::scalar), ray.direction().to_array().map(N::unit)]
    }
    #[inline]
    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        point.to_array().map(N::scalar)
    }
    #[inline]
    fn gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3] {
        gradient
    }
}
