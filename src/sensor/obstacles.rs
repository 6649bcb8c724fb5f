//! What may be in the way of a sensor's rays.

use crate::hierarchy::Shapes;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::shape::Shaped;

/// What may be in the way: a slice of shapes, [`Bounded`](super::Bounded) shapes, or [`Shapes`] with their tree. Every reading is the
/// same of all of them.
///
/// A slice is tested shape by shape. It may lie in flash.
pub trait Obstacles<S: Scalar> {
    /// What has the shapes.
    type Item: Shaped<S>;

    /// The obstacles; [`Return::obstacle`](super::Return::obstacle) is an index of this list.
    fn list(&self) -> &[Self::Item];
    /// Calls `test` with the index of every obstacle that the ray may meet. `test` returns the end of the range that
    /// remains to be searched, or `None` to stop.
    fn each(&self, ray: &Ray<S>, test: impl FnMut(u32) -> Option<S>);
}

impl<S: Scalar, X: Shaped<S>> Obstacles<S> for [X] {
    type Item = X;

    #[inline(always)]
    fn list(&self) -> &[X] {
        self
    }
    #[inline(always)]
    fn each(&self, _: &Ray<S>, mut test: impl FnMut(u32) -> Option<S>) {
        for index in 0..self.len() as u32 {
            if test(index).is_none() {
                return;
            }
        }
    }
}

impl<S: Scalar, O: Obstacles<S> + ?Sized> Obstacles<S> for &O {
    type Item = O::Item;

    #[inline(always)]
    fn list(&self) -> &[O::Item] {
        (**self).list()
    }
    #[inline(always)]
    fn each(&self, ray: &Ray<S>, test: impl FnMut(u32) -> Option<S>) {
        (**self).each(ray, test);
    }
}

impl<S: Scalar, X: Shaped<S>> Obstacles<S> for Shapes<'_, S, X> {
    type Item = X;

    #[inline(always)]
    fn list(&self) -> &[X] {
        Shapes::list(self)
    }
    #[inline(always)]
    fn each(&self, ray: &Ray<S>, test: impl FnMut(u32) -> Option<S>) {
        self.visit(ray, test);
    }
}
