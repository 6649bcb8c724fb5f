//! Types that have a shape.

use super::Shape;
use super::kinds::Kinds;
use crate::scalar::Scalar;

/// A type that has a shape: a [`Shape`] itself, an [`Object`](crate::Object) of a scene, or a type of your own.
///
/// A [`Hierarchy`](crate::hierarchy::Hierarchy) and [`Shapes`](crate::hierarchy::Shapes) are made of such things.
///
/// ```
/// use raylet::{Shape, Shaped, shape::kinds::All};
/// struct Obstacle {
///     shape: Shape<f32>,
///     name: &'static str,
/// }
/// impl Shaped<f32> for Obstacle {
///     type Kinds = All;
///     fn shape(&self) -> &Shape<f32> {
///         &self.shape
///     }
/// }
/// ```
pub trait Shaped<S: Scalar> {
    /// The kinds among which the shape is.
    type Kinds: Kinds;

    /// The shape. It must be the same at every call, until the value itself is changed.
    fn shape(&self) -> &Shape<S, Self::Kinds>;
}

impl<S: Scalar, K: Kinds> Shaped<S> for Shape<S, K> {
    type Kinds = K;

    #[inline(always)]
    fn shape(&self) -> &Self {
        self
    }
}

/// All hits of a ray with the shape of an `X`: [`Hits`](crate::Hits), of the capacity that the kinds need.
pub type HitsOf<S, X> = <<X as Shaped<S>>::Kinds as Kinds>::Hits<S>;
