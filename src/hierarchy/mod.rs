//! Bounding volume hierarchy, with which a ray tests only few of many objects: for a [`Scene`](crate::Scene), or for
//! [`Shapes`] without a scene.
//!
//! | module | what it holds |
//! |---|---|
//! | `build`, `split` | how a hierarchy is built |
//! | `search` | the nearest hit and occlusion of many shapes |
//! | `shapes`, `tree` | many shapes without a scene, borrowed or owned |
//! | `refit` | new boxes for a shape that has moved |

mod build;
mod refit;
pub(crate) mod search;
mod shapes;
mod split;
mod tree;

pub use shapes::Shapes;
pub use tree::{List, ShapeTree};

use crate::ray::Ray;
use crate::scalar::{Scalar, UnitScalar};
use crate::shape::Shaped;
use core::fmt;
use search::Watch;

/// A node of a [`Hierarchy`]. Its fields are private: make an array of [`Node::EMPTY`] or of `Node::default()` and pass
/// it to [`Hierarchy::build`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Node<S> {
    centre: [S; 3],
    half: [S; 3],
    /// The number of objects in it.
    objects: u32,
    /// Of a leaf, the index of its object. Of an inner node, the number of objects in its lower child, and in the top
    /// bits the axis along which that child is lower.
    object: u32,
}

/// Bits of [`Node::object`] below the axis.
const AXIS: u32 = 30;

/// The largest number of objects.
const MOST_OBJECTS: usize = (1 << AXIS) - 1;

/// The largest number of levels of a tree below its root, and of nodes that wait during a traversal.
const LEVELS: u32 = 40;

impl<S: Scalar> Node<S> {
    /// An unused node.
    pub const EMPTY: Self = Self { centre: [S::ZERO; 3], half: [S::ZERO; 3], objects: 0, object: 0 };

    /// The number of objects in the lower child.
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

/// A bounding volume hierarchy: a binary tree of axis-aligned boxes around the objects of a scene, or around the shapes
/// of a list ([`Shapes`]).
///
/// It changes no bit of a result. The number of tests of a ray grows about with the logarithm of the number of objects.
/// Without a hierarchy a scene tests every object.
///
/// It is built into storage that it borrows, without allocation. A traversal visits nearer boxes first and takes some
/// 200 bytes of stack.
///
/// Infinite objects (planes, infinite cylinders and cones) and objects beyond the budget of coordinates have no box and
/// are always tested. So are objects whose rounding errors may exceed the margin of a box: cones flatter than 1 : 256,
/// and objects that an [`Affine`](crate::Affine) stretches along one axis more than some 100 times as much as along
/// another, or makes nearly flat.
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
    /// Leaves of the objects that have no box.
    unbounded: &'a [Node<S>],
    /// The tree in preorder: a node, then the nodes of its lower child, then those of its upper child. A node with n
    /// objects is followed by its 2 (n - 1) descendants.
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

    /// Calls `test` for every object that the ray may hit. `test` returns the end of the range that remains to be
    /// searched, or `None` to stop. Counts the tests of boxes.
    ///
    /// Of two children the one that the ray reaches first is visited first, so that a hit in it shortens the range. The
    /// objects `always` are tested first, whatever their boxes.
    #[inline(always)]
    fn walk<W: Watch>(
        &self,
        ray: &Ray<S>,
        always: &(impl Iterator<Item = u32> + Clone),
        watch: &mut W,
        mut test: impl FnMut(u32, &mut W) -> Option<S>,
    ) {
        let (start, mut end) = (ray.range().start(), ray.range().end());
        let is_tested = |object: u32| always.clone().any(|own| own == object);
        let unbounded = self.unbounded.iter().map(|node| node.object).filter(|object| !is_tested(*object));
        for object in always.clone().filter(|own| (*own as usize) < self.objects()).chain(unbounded) {
            match test(object, watch) {
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
            watch.count_box();
            if !S::misses_box(&slabs, [start, end], node.centre, node.half) {
                if node.objects > 1 {
                    let (lower, upper) = (place + 1, place + 2 * node.lower());
                    let is_falling = falling >> node.axis() & 1 != 0;
                    let (first, second) = if is_falling { (upper, lower) } else { (lower, upper) };
                    // Cannot be full: a tree has at most `LEVELS` levels.
                    let _ = waiting.push(second);
                    next = Some(first);
                    continue;
                }
                if !is_tested(node.object) {
                    match test(node.object, watch) {
                        Some(nearer) => end = nearer,
                        None => return,
                    }
                }
            }
            next = waiting.pop();
        }
    }

    /// True if it was built for exactly these objects, in this order.
    pub(crate) fn is_of(&self, objects: &[impl Shaped<S>]) -> bool {
        let mut leaves = self.unbounded.iter().chain(self.tree.iter().filter(|node| node.objects == 1));
        self.objects() == objects.len()
            && leaves.all(|leaf| {
                objects.get(leaf.object as usize).is_some_and(|object| Node::leaf(leaf.object, object.shape()) == *leaf)
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
    /// There are more objects than an index can name.
    TooManyObjects,
}

impl fmt::Display for HierarchyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Storage { needed, given } => write!(
                f,
                "the hierarchy needs {needed} nodes, and has room for {given}: give it \
                 Hierarchy::nodes_for(objects) of them"
            ),
            Self::TooManyObjects => f.write_str("a hierarchy holds at most 2^30 - 1 objects: divide the scene"),
        }
    }
}

impl core::error::Error for HierarchyError {}
