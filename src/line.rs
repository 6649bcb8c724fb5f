//! The way of a ray into the frame of a primitive.

use crate::ray::Ray;
use crate::scalar::{FinerLine, FromScalar, LocalLine, Scalar};
use crate::vector::Vec3;

/// The way from the world to a primitive's frame.
pub trait Place<S: Scalar> {
    /// The same placement in doubles.
    type Doubles: Place<f64>;

    /// True if the line's own `t` is not the ray's: see [`LocalLine::pace`].
    const STRETCHES: bool = false;

    /// Itself in doubles, which hold the numbers of 32-bit types.
    fn in_doubles(&self) -> Self::Doubles;
    /// The line for the fast path, where the placement is simple enough for it.
    fn fast_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>>;
    /// [`Place::fast_line`]; `None` if a ray begins so far from the primitive's point `base` that [`Place::far_line`] should be tried.
    #[inline(always)]
    fn fast_line_near(&self, ray: &Ray<S>, _base: Vec3<S>) -> Option<LocalLine<S>> {
        self.fast_line(ray)
    }
    /// [`Place::fast_line`] where the placement stretches and the number type is fixed point, for a solid whose lengths are at most `reach`.
    #[inline(always)]
    fn finer_line(&self, _ray: &Ray<S>, _reach: S) -> Option<FinerLine<S>> {
        None
    }
    /// The line of a ray that begins far away, taken up next to the primitive's point `base` and relative to it.
    #[inline(always)]
    fn far_line(&self, _ray: &Ray<S>, _base: Vec3<S>) -> Option<LocalLine<S>> {
        None
    }
    /// The line as a ball about the frame's origin sees it, for the fast path.
    #[inline(always)]
    fn fast_ball_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        self.fast_line(ray)
    }
    /// The line for the fast path's second attempt, which costs more and is rounded less: taken up next to the primitive's point `base`,
    /// and relative to it.
    fn second_line(&self, ray: &Ray<S>, base: Vec3<S>) -> Option<LocalLine<S>>;
    /// [`Place::second_line`] for a ball about the frame's origin.
    #[inline(always)]
    fn second_ball_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        self.second_line(ray, Vec3::ZERO)
    }
    /// Origin and direction of the ray's line in the primitive's frame, without rounding but for that of the number. The direction has
    /// any length: `t` is the ray's own.
    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2];
    /// A point in the primitive's frame, as [`Place::line`].
    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3];
    /// A gradient in the primitive's frame, in the world: the transpose of the map of points.
    fn gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3];
    /// [`Place::line`] for a ball about the frame's origin, which has no axes: a turned ball is a ball, although stored axes are
    /// orthogonal only to their last bits.
    #[inline]
    fn ball_line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2] {
        self.line(ray)
    }
    /// [`Place::point`] for a ball about the frame's origin.
    #[inline]
    fn ball_point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        self.point(point)
    }
    /// [`Place::gradient_to_world`] for a ball about the frame's origin.
    #[inline]
    fn ball_gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3] {
        self.gradient_to_world(gradient)
    }
}

/// The frame that is the world's.
#[derive(Clone, Copy, Debug)]
pub struct InWorld;

impl<S: Scalar> Place<S> for InWorld {
    type Doubles = Self;

    #[inline(always)]
    fn in_doubles(&self) -> Self::Doubles {
        Self
    }
    #[inline(always)]
    fn fast_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>> {
        Some(LocalLine::along(ray.origin().to_array(), ray.direction().to_array(), S::ZERO))
    }
    #[inline(always)]
    fn fast_line_near(&self, ray: &Ray<S>, base: Vec3<S>) -> Option<LocalLine<S>> {
        let is_far = S::is_far(ray.origin().to_array(), ray.direction().to_array(), base.to_array());
        if is_far { None } else { self.fast_line(ray) }
    }
    #[inline(always)]
    fn far_line(&self, ray: &Ray<S>, base: Vec3<S>) -> Option<LocalLine<S>> {
        S::fast_from_afar(ray.origin().to_array(), ray.direction().to_array(), base.to_array())
    }
    #[inline(always)]
    fn second_line(&self, ray: &Ray<S>, base: Vec3<S>) -> Option<LocalLine<S>> {
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
