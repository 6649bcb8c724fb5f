//! Shapes that own their list and the nodes of their hierarchy.

use super::refit::refit;
use super::{Hierarchy, HierarchyError, Node, Shapes};
use crate::hit::Hit;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::shape::{HitsOf, Shaped};
use crate::tier::{Stable, Tier};

mod sealed {
    pub trait Sealed {}
}

/// A list that a [`ShapeTree`] owns. Sealed: an array, a `heapless::Vec`, and with the feature `std` a `Vec`, of
/// [`Shape`](crate::Shape)s or of anything else that is [`Shaped`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no list of shapes that a `ShapeTree` can own",
    note = "it owns an array, a `heapless::Vec` or, with the feature `std` of raylet, a `Vec`, of what is `Shaped`"
)]
pub trait List<S: Scalar>: AsRef<[Self::Item]> + AsMut<[Self::Item]> + sealed::Sealed {
    /// What is in the list.
    type Item: Shaped<S>;
    /// As many pairs of nodes: a hierarchy of n shapes has 2 n - 1 nodes.
    type Nodes: AsRef<[[Node<S>; 2]]> + AsMut<[[Node<S>; 2]]>;

    /// A pair of unused nodes for each item.
    fn nodes(&self) -> Self::Nodes;
}

impl<X, const N: usize> sealed::Sealed for [X; N] {}

impl<S: Scalar, X: Shaped<S>, const N: usize> List<S> for [X; N] {
    type Item = X;
    type Nodes = [[Node<S>; 2]; N];

    fn nodes(&self) -> Self::Nodes {
        [[Node::EMPTY; 2]; N]
    }
}

impl<X, const N: usize> sealed::Sealed for heapless::Vec<X, N> {}

impl<S: Scalar, X: Shaped<S>, const N: usize> List<S> for heapless::Vec<X, N> {
    type Item = X;
    type Nodes = <[X; N] as List<S>>::Nodes;

    fn nodes(&self) -> Self::Nodes {
        [[Node::EMPTY; 2]; N]
    }
}

#[cfg(feature = "std")]
impl<X> sealed::Sealed for std::vec::Vec<X> {}

#[cfg(feature = "std")]
impl<S: Scalar, X: Shaped<S>> List<S> for std::vec::Vec<X> {
    type Item = X;
    type Nodes = std::vec::Vec<[Node<S>; 2]>;

    fn nodes(&self) -> Self::Nodes {
        std::vec![[Node::EMPTY; 2]; self.len()]
    }
}

/// Shapes with a hierarchy of boxes around them, both owned: as [`Shapes`], which borrows them, for a program that
/// keeps them in a field or moves them.
///
/// ```
/// use raylet::hierarchy::ShapeTree;
/// use raylet::{Frame, Ray, Shape, Sphere, UnitVec3, Vec3};
/// let ball = Shape::new(Sphere::new(0.25_f32)?);
/// let mut balls = heapless::Vec::<Shape<f32>, 8>::new();
/// for x in 0..8_u8 {
///     let _ = balls.push(ball.placed(Frame::at(Vec3::new(f32::from(x), 0.0, 0.0))?));
/// }
/// let mut balls = ShapeTree::new(balls)?;
/// let ray = Ray::new(Vec3::new(5.0, 0.0, 3.0), -UnitVec3::Z)?;
/// assert_eq!(balls.nearest(&ray).map(|(ball, hit)| (ball, hit.t)), Some((5, 2.75)));
/// // The sixth ball moves away.
/// let away = Frame::at(Vec3::new(5.0, 1.0, 0.0))?;
/// balls.change(5, |ball| *ball = ball.placed(away));
/// assert_eq!(balls.nearest(&ray), None);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ShapeTree<S: Scalar, L: List<S>> {
    list: L,
    nodes: L::Nodes,
    /// How many objects have no box: the first nodes.
    unbounded: usize,
    /// Where the tree begins.
    tree: usize,
}

impl<S: Scalar, L: List<S>> ShapeTree<S, L> {
    /// The hierarchy of these shapes: see [`Hierarchy::build`].
    ///
    /// # Errors
    ///
    /// [`HierarchyError::TooManyObjects`] for more than 2^30 - 1 shapes.
    pub fn new(list: L) -> Result<Self, HierarchyError> {
        let mut new = Self { nodes: list.nodes(), list, unbounded: 0, tree: 0 };
        new.build()?;
        Ok(new)
    }

    fn build(&mut self) -> Result<(), HierarchyError> {
        let nodes = self.nodes.as_mut().as_flattened_mut();
        let hierarchy = Hierarchy::build(self.list.as_ref(), nodes)?;
        let (unbounded, tree) = (hierarchy.unbounded.len(), hierarchy.tree.len());
        self.unbounded = unbounded;
        self.tree = Hierarchy::<S>::nodes_for(self.list.as_ref().len()).saturating_sub(tree);
        Ok(())
    }

    /// The shapes.
    pub fn list(&self) -> &[L::Item] {
        self.list.as_ref()
    }

    /// Changes the shape of this index, and then the boxes around it. Nothing is done beyond the last shape.
    ///
    /// The tree keeps its division, so that this takes a small part of the time of a new one; where many shapes have
    /// moved far, rays test more boxes. A shape that has no box, as a plane, or had none before,
    /// takes a new tree.
    pub fn change(&mut self, index: u32, change: impl FnOnce(&mut L::Item)) {
        let Some(item) = self.list.as_mut().get_mut(index as usize) else { return };
        change(item);
        let leaf = Node::leaf(index, item.shape());
        let tree = self.nodes.as_mut().as_flattened_mut().get_mut(self.tree..);
        if !tree.is_some_and(|tree| refit(tree, leaf)) {
            self.rebuild();
        }
    }

    /// Changes any of the shapes, and makes a new tree.
    pub fn change_all(&mut self, change: impl FnOnce(&mut [L::Item])) {
        change(self.list.as_mut());
        self.rebuild();
    }

    fn rebuild(&mut self) {
        // The number of shapes has not changed, so that a new hierarchy has room.
        let _ = self.build();
    }

    /// The list, without the hierarchy.
    pub fn into_list(self) -> L {
        self.list
    }

    /// The shapes and their hierarchy, borrowed.
    pub fn view(&self) -> Shapes<'_, S, L::Item> {
        let nodes = self.nodes.as_ref().as_flattened();
        let end = Hierarchy::<S>::nodes_for(self.list.as_ref().len());
        let unbounded = nodes.get(..self.unbounded).unwrap_or(&[]);
        Shapes::of(self.list.as_ref(), Hierarchy { unbounded, tree: nodes.get(self.tree..end).unwrap_or(&[]) })
    }

    /// The nearest visible hit of a ray, and the index of its shape: see [`Shapes::nearest`].
    pub fn nearest(&self, ray: &Ray<S>) -> Option<(u32, Hit<S>)> {
        self.nearest_at::<Stable>(ray)
    }

    /// As [`ShapeTree::nearest`], in a chosen accuracy tier.
    pub fn nearest_at<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<(u32, Hit<S>)> {
        self.view().nearest_at::<T>(ray)
    }

    /// True if the ray hits any shape within its range: see [`Shapes::occludes`].
    pub fn occludes(&self, ray: &Ray<S>) -> bool {
        self.occludes_at::<Stable>(ray)
    }

    /// As [`ShapeTree::occludes`], in a chosen accuracy tier.
    pub fn occludes_at<T: Tier<S>>(&self, ray: &Ray<S>) -> bool {
        self.view().occludes_at::<T>(ray)
    }

    /// All hits of a ray, shape by shape: see [`Shapes::hits`].
    pub fn hits(&self, ray: &Ray<S>, each: impl FnMut(u32, HitsOf<S, L::Item>)) {
        self.hits_at::<Stable>(ray, each);
    }

    /// As [`ShapeTree::hits`], in a chosen accuracy tier.
    pub fn hits_at<T: Tier<S>>(&self, ray: &Ray<S>, each: impl FnMut(u32, HitsOf<S, L::Item>)) {
        self.view().hits_at::<T>(ray, each);
    }
}
