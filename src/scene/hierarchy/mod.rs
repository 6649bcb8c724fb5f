//! Boxes in boxes: which objects a ray may meet at all, without asking each.

mod build;
mod split;

use super::{Counters, Object};
use crate::ray::Ray;
use crate::scalar::{Scalar, UnitScalar};
use core::fmt;

/// A box of a [`Hierarchy`], opaque: make an array of [`Node::EMPTY`] or of `Node::default()` and lend it to
/// [`Hierarchy::build`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Node<S> {
    centre: [S; 3],
    half: [S; 3],
    /// How many objects lie in it.
    objects: u32,
    /// The index of its object, if it is one; else how many lie in its lower half, and in the top bits the axis along which that is lower.
    object: u32,
}

/// Bits of [`Node::object`] below the axis.
const AXIS: u32 = 30;

/// How many objects there may be.
const MOST_OBJECTS: usize = (1 << AXIS) - 1;

/// Levels of a tree below its root, at most: so many nodes wait at once while a ray walks through it.
const LEVELS: u32 = 40;

impl<S: Scalar> Node<S> {
    /// Nothing yet.
    pub const EMPTY: Self = Self { centre: [S::ZERO; 3], half: [S::ZERO; 3], objects: 0, object: 0 };

    /// How many objects lie in the lower half.
    #[inline(always)]
    const fn lower(&self) -> u32 {
        self.object & MOST_OBJECTS as u32
    }

    /// The axis along which the halves lie, 0 to 2.
    #[inline(always)]
    const fn axis(&self) -> u32 {
        self.object >> AXIS
    }
}

impl<S: Scalar> Default for Node<S> {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// Boxes around the objects of a scene, boxes around these, and so on up to one around all: a ray that misses a box misses
/// what lies in it.
///
/// It changes no bit of any answer, only what an answer costs: about as many tests as the logarithm of the number of objects,
/// instead of one for each. Without it a scene tests every object and no boxes: a box for each pays too from some ten objects on, but
/// takes half the memory of the whole hierarchy, and no scene pays for it unasked.
///
/// Built at the start, or on a host, into storage that it borrows; nothing is allocated. A walk through it meets nearer boxes first and
/// takes some 200 bytes of stack.
/// Objects without bounds (planes, infinite cylinders and cones) or beyond the budget of coordinates have no box and are always
/// tested. So are those whose own rounding matters more than a box allows for: cones flatter than 1 : 256, and what an
/// [`Affine`](crate::Affine) stretches along one axis more than some 100 times as much as along another, or presses nearly flat.
///
/// ```
/// use raylet::scene::{Hierarchy, Node};
/// use raylet::{Camera, Counters, Frame, Material, Object, Ray, Scene, Shape, Sphere, UnitVec3, Vec3};
///
/// let ball = Shape::new(Sphere::new(0.25_f32)?);
/// let mut objects = Vec::new();
/// for i in 0..100 {
///     objects.push(Object::new(ball.placed(Frame::at(Vec3::new(i as f32, 0.0, 0.0))?), 0));
/// }
/// let mut nodes = [Node::EMPTY; Hierarchy::<f32>::nodes_for(100)];
/// let hierarchy = Hierarchy::build(&objects, &mut nodes)?;
///
/// let materials = [Material::default()];
/// let camera = Camera::new(Vec3::new(42.0, 0.0, 9.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0)?;
/// let scene = Scene::new(&objects, &materials, &[], camera)?.with_hierarchy(&hierarchy)?;
/// let (mut counters, ray) = (Counters::default(), Ray::new(Vec3::new(42.0, 0.0, 9.0), -UnitVec3::Z)?);
/// assert_eq!(scene.nearest(&ray, &mut counters).map(|on| on.object), Some(42));
/// assert_eq!(counters.intersection_tests, 1);
/// assert!(counters.box_tests < 20);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Hierarchy<'a, S> {
    /// What has no box: its objects only.
    unbounded: &'a [Node<S>],
    /// Each node, the nodes of its lower part, those of its upper part: what is below a node of n objects are the 2 (n - 1) behind
    /// it.
    tree: &'a [Node<S>],
}

impl<S: Scalar> Hierarchy<'_, S> {
    /// How many nodes [`Hierarchy::build`] needs for this many objects: two for each, less one.
    pub const fn nodes_for(objects: usize) -> usize {
        objects.saturating_mul(2).saturating_sub(1)
    }

    /// How many objects it was built for.
    pub fn objects(&self) -> usize {
        // Of a binary tree with n leaves: 2 n - 1 nodes.
        self.unbounded.len() + self.tree.len().div_ceil(2)
    }

    /// Puts to `test` every object that the ray may meet; `test` gives the end of the range that still matters, or `None` if
    /// nothing does any more. Counts the boxes.
    ///
    /// Of the two parts of a box the one that the ray comes to first comes first, so that what it meets there shortens the ray.
    #[inline(always)]
    pub(super) fn walk(
        &self,
        ray: &Ray<S>,
        counters: &mut Counters,
        mut test: impl FnMut(u32, &mut Counters) -> Option<S>,
    ) {
        let (start, mut end) = (ray.range().start(), ray.range().end());
        // What a ray meets of the object that it departs from follows from the departure, wherever it starts.
        let departed = ray.departure().map(|departure| departure.object).filter(|own| (*own as usize) < self.objects());
        for object in
            departed.into_iter().chain(self.unbounded.iter().map(|node| node.object).filter(|o| Some(*o) != departed))
        {
            match test(object, counters) {
                Some(nearer) => end = nearer,
                None => return,
            }
        }
        let d = ray.direction().to_array();
        let slabs = S::slabs(ray.origin().to_array(), d);
        let mut falling = 0;
        for (axis, component) in d.into_iter().enumerate() {
            falling |= u32::from(component < S::Unit::ZERO) << axis;
        }
        let mut waiting = heapless::Vec::<u32, { LEVELS as usize }>::new();
        let mut next = Some(0);
        while let Some(place) = next
            && let Some(node) = self.tree.get(place as usize)
        {
            counters.box_tests += 1;
            if !S::misses_box(&slabs, [start, end], node.centre, node.half) {
                if node.objects > 1 {
                    let (lower, upper) = (place + 1, place + 2 * node.lower());
                    let is_falling = falling >> node.axis() & 1 != 0;
                    let (first, second) = if is_falling { (upper, lower) } else { (lower, upper) };
                    // There is room: a tree has no more levels.
                    let _ = waiting.push(second);
                    next = Some(first);
                    continue;
                }
                if Some(node.object) != departed {
                    match test(node.object, counters) {
                        Some(nearer) => end = nearer,
                        None => return,
                    }
                }
            }
            next = waiting.pop();
        }
    }

    /// True if it was built for these very objects, in this order.
    pub(super) fn is_of(&self, objects: &[Object<S>]) -> bool {
        let mut leaves = self.unbounded.iter().chain(self.tree.iter().filter(|node| node.objects == 1));
        self.objects() == objects.len()
            && leaves.all(|leaf| {
                objects.get(leaf.object as usize).is_some_and(|object| Node::leaf(leaf.object, &object.shape) == *leaf)
            })
    }
}

/// Why a hierarchy cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum HierarchyError {
    /// The storage is too small.
    Storage {
        /// How many nodes are needed.
        needed: usize,
        /// How many were given.
        given: usize,
    },
    /// More objects than an index can name.
    TooManyObjects,
}

impl fmt::Display for HierarchyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Storage { needed, given } => write!(
                f,
                "the hierarchy needs {needed} nodes, and has room for {given}: give it Hierarchy::nodes_for(objects) of them"
            ),
            Self::TooManyObjects => f.write_str("a hierarchy holds at most 2^30 - 1 objects: divide the scene"),
        }
    }
}

impl core::error::Error for HierarchyError {}
