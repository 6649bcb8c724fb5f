//! Transformation of a ray's line into the frame of a primitive.

use crate::ray::Ray;
use crate::scalar::{FinerLine, FromScalar, GridScalar, Including, LocalLine, Scalar};
use crate::vector::Vec3;

/// What an intersection needs of the transformation into a primitive's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// A sphere: a frame only translates it, since a rotated sphere is the same sphere.
    Translation,
    /// A plane: only the coordinate across it.
    Height,
    /// Everything, for a primitive that has only flat parts. In the world the origin of its line is not moved: that
    /// would gain no accuracy.
    Flat,
    /// Everything.
    All,
}

/// A placement: the transformation from the world to a primitive's frame.
pub trait Place<S: Scalar> {
    /// The same placement in another number type.
    type In<R: Scalar>: Place<R>;

    /// True if the placement changes lengths.
    const STRETCHES: bool = false;
    /// True for the world, whose coordinates are exact.
    const IS_WORLD: bool = false;
    /// The placement in a type that holds all values of this one.
    fn in_type<R: Including<S>>(&self) -> Self::In<R>;
    /// The line for the grid; `None` if the placement is not suitable for it.
    #[inline(always)]
    fn grid_line(&self, _ray: &Ray<S>) -> Option<LocalLine<S>>
    where
        S: GridScalar,
    {
        None
    }
    /// [`Place::grid_line`] where the placement stretches and the number type is fixed point, for a solid whose lengths
    /// are at most `longest`.
    #[inline(always)]
    fn finer_line(&self, _ray: &Ray<S>, _longest: S) -> Option<FinerLine<S>>
    where
        S: GridScalar,
    {
        None
    }
    /// True if the ray's line passes the placement's y axis at a distance greater than `r`; false where rounding may
    /// decide, and for placements that do not know it.
    #[inline(always)]
    fn passes_axis(&self, _ray: &Ray<S>, _r: S) -> bool {
        false
    }
    /// The line for the grid of a sphere about the frame's origin, which needs no rotation.
    #[inline(always)]
    fn grid_ball_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>>
    where
        S: GridScalar,
    {
        self.grid_line(ray)
    }
    /// The position of the frame; `None` for the world.
    #[inline(always)]
    fn position(&self) -> Option<Vec3<S>> {
        None
    }
    /// The linear part of the transformation, applied to a vector of the world.
    fn linear<N: FromScalar<S>>(&self, v: [N; 3]) -> [N; 3];
    /// The heights of [`Place::line`].
    #[inline(always)]
    fn height_line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [N; 2] {
        let [[_, y, _], [_, dy, _]] = self.line::<N>(ray);
        [y, dy]
    }
    /// Origin and direction of the ray's line in the primitive's frame, rounded only by the operations of the number
    /// `N`. The direction may have any length, so that `t` is the ray's.
    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2];
    /// A point in the primitive's frame, as [`Place::line`].
    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3];
    /// Transforms a gradient from the primitive's frame to the world: by the transpose of the matrix that transforms
    /// points to the frame.
    fn gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3];
    /// [`Place::line`] for a sphere about the frame's origin. In a [`Frame`](crate::Frame) it is translated only, since
    /// a rotated sphere is the same sphere; stored axes, which are orthogonal only to their last bits, would deform it.
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
    const IS_WORLD: bool = true;
    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Self::In<R> {
        Self
    }
    #[inline(always)]
    fn grid_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>>
    where
        S: GridScalar,
    {
        Some(LocalLine::along(ray.origin().to_array(), ray.direction().to_array(), S::ZERO))
    }
    #[inline(always)]
    fn linear<N: FromScalar<S>>(&self, v: [N; 3]) -> [N; 3] {
        v
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
