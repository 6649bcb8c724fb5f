//! Many shapes without a scene.

use super::{Hierarchy, HierarchyError, Node, search};
use crate::hit::Hit;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::shape::{HitsOf, Shape, Shaped};
use crate::tier::{Stable, Tier};
use core::ops::ControlFlow;

/// Shapes with a hierarchy of boxes around them: the nearest hit and occlusion of many shapes without a scene, for a
/// program that needs distances and no picture. There is no camera, and there are no materials and counters.
///
/// The list holds [`Shape`]s, of any kind or of chosen ones, or anything else that is [`Shaped`]. The hierarchy is
/// built for the list when the value is made, and both are borrowed as long as it exists, so that they cannot differ.
/// To move a shape, drop the value, change the list and make a new one. A [`ShapeTree`](super::ShapeTree) owns both and
/// moves shapes in place.
///
/// Every result has the same bits as a loop over the list. A list may be empty; then nothing is hit.
///
/// The 64 zones of a range sensor, over 40 posts:
///
/// ```
/// use fixed::types::I16F16;
/// use raylet::hierarchy::{Hierarchy, Node, Shapes};
/// use raylet::{Cylinder, Frame, Ray, Shape, Vec3};
///
/// type Post = Shape<I16F16, (Cylinder<I16F16>, Frame<I16F16>)>;
/// let metres = |x: f64| I16F16::from_num(x);
/// let point = |x, y, z| Vec3::new(metres(x), metres(y), metres(z));
/// let mut posts = heapless::Vec::<Post, 40>::new();
/// for i in 0..40_u8 {
///     let foot = point(f64::from(i % 8) - 3.5, 0.0, -2.0 - f64::from(i / 8));
///     let _ = posts.push(Post::of(Cylinder::capped(metres(0.125), metres(2.0))?).placed(Frame::at(foot)?));
/// }
/// let mut nodes = [Node::EMPTY; Hierarchy::<I16F16>::nodes_for(40)];
/// let posts = Shapes::new(&posts, &mut nodes)?;
///
/// let mut zones = [[None; 8]; 8];
/// for (row, y) in zones.iter_mut().zip([1.35, 1.25, 1.15, 1.05, 0.95, 0.85, 0.75, 0.65]) {
///     for (zone, x) in row.iter_mut().zip([-0.7, -0.5, -0.3, -0.1, 0.1, 0.3, 0.5, 0.7]) {
///         let ray = Ray::towards(point(0.0, 1.0, 0.0), point(x, y, -1.0))?;
///         *zone = posts.nearest(&ray).map(|(post, hit)| (post, hit.t));
///     }
/// }
/// // Between the posts of the first two rows, it hits one of the third.
/// assert_eq!(zones[3][3].map(|(post, _)| post), Some(19));
/// assert!(zones.iter().flatten().flatten().all(|(_, t)| *t > metres(1.875)));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Debug)]
pub struct Shapes<'a, S: Scalar, X = Shape<S>> {
    shapes: &'a [X],
    hierarchy: Hierarchy<'a, S>,
}

// Not derived: what has a shape need not be `Clone`.
impl<S: Scalar, X> Clone for Shapes<'_, S, X> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Scalar, X> Copy for Shapes<'_, S, X> {}

impl<'a, S: Scalar, X: Shaped<S>> Shapes<'a, S, X> {
    /// These shapes, with the hierarchy that [`Hierarchy::build`] makes of them in storage of at least
    /// [`Hierarchy::nodes_for`] nodes.
    ///
    /// # Errors
    ///
    /// [`HierarchyError::Storage`] if the storage is too small; [`HierarchyError::TooManyObjects`] for more than 2^30 -
    /// 1 shapes.
    pub fn new(shapes: &'a [X], nodes: &'a mut [Node<S>]) -> Result<Self, HierarchyError> {
        Ok(Self { shapes, hierarchy: Hierarchy::build(shapes, nodes)? })
    }

    pub(super) const fn of(shapes: &'a [X], hierarchy: Hierarchy<'a, S>) -> Self {
        Self { shapes, hierarchy }
    }

    /// The list; an index that [`Shapes::nearest`] returns is one of this list.
    pub const fn list(&self) -> &'a [X] {
        self.shapes
    }

    /// The nearest visible hit of a ray, and the index of its shape. If two shapes are hit at the same `t`, the one
    /// with the lower index is returned. `None` if the ray hits nothing within its range.
    ///
    /// A departure of the ray (see [`Departure`](crate::Departure)) applies to the shape whose index it names; the
    /// other shapes are tested with the ray without departure.
    pub fn nearest(&self, ray: &Ray<S>) -> Option<(u32, Hit<S>)> {
        self.nearest_at::<Stable>(ray)
    }

    /// As [`Shapes::nearest`], in a chosen accuracy tier.
    pub fn nearest_at<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<(u32, Hit<S>)> {
        let nearest = search::nearest::<S, T, ()>(self.shapes, Some(&self.hierarchy), ray, ray, &mut ());
        nearest.map(|(index, hit, _)| (index, hit))
    }

    /// True if the ray hits any shape within its range. Stops at the first that it finds.
    pub fn occludes(&self, ray: &Ray<S>) -> bool {
        self.occludes_at::<Stable>(ray)
    }

    /// As [`Shapes::occludes`], in a chosen accuracy tier.
    pub fn occludes_at<T: Tier<S>>(&self, ray: &Ray<S>) -> bool {
        search::occluder::<S, T, ()>(self.shapes, Some(&self.hierarchy), ray, ray, &mut ()).is_some()
    }

    /// All hits of a ray, shape by shape: calls `each` with the index of a shape and its hits, in the order in which
    /// the hierarchy finds them, not by `t`. Shapes that the ray misses are left out, except those that it starts
    /// inside of.
    pub fn hits(&self, ray: &Ray<S>, each: impl FnMut(u32, HitsOf<S, X>)) {
        self.hits_at::<Stable>(ray, each);
    }

    /// As [`Shapes::hits`], in a chosen accuracy tier.
    pub fn hits_at<T: Tier<S>>(&self, ray: &Ray<S>, mut each: impl FnMut(u32, HitsOf<S, X>)) {
        search::every_hit::<S, T, X>(self.shapes, &self.hierarchy, ray, &mut each);
    }

    /// Calls `test` with the index of every shape that a ray without departure may meet. `test` returns the end of the
    /// range that remains to be searched, or `None` to stop.
    #[inline(always)]
    pub(crate) fn visit(&self, ray: &Ray<S>, mut test: impl FnMut(u32) -> Option<S>) {
        self.hierarchy.walk(ray, &core::iter::empty(), &mut (), |index, ()| test(index));
    }

    /// The same, of the whole range, until `test` breaks.
    pub(crate) fn visit_near(&self, ray: &Ray<S>, mut test: impl FnMut(u32) -> ControlFlow<()>) {
        self.visit(ray, |index| test(index).is_continue().then_some(ray.range().end()));
    }
}
