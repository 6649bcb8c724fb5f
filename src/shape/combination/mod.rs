//! Combinations of solids: union, intersection and difference.
//!
//! | module | what it holds |
//! |---|---|
//! | `operation` | the operations, as a predicate over the set of leaves that a point lies in |
//! | `crossings` | where the predicate changes along a ray |
//! | `departing` | the leaf that a ray departs from |
//! | `boxes` | the box of a combination |
//! | `error` | why solids cannot be combined |
//! | `stored` | how a combination is stored and logged |
//!
//! A [`Combination`] borrows its solids, its *leaves*, and may be a constant. [`Combination::shape`] is a shape like
//! any other, for a list, a scene, a hierarchy or [`solids`](crate::solids): one solid.
//!
//! # What it is
//!
//! The result is regularised: a closed solid without faces or points that hang in the air. Along a ray, all crossings
//! of the leaves at one place are taken together, and there is a hit if the predicate differs before and behind that
//! place. So a hole exactly as deep as its block is open at the bottom, two blocks that share a face are one, and a
//! solid less itself is nothing: coincident faces leave no layer, however thin. What is one place is decided as in the
//! [order](crate::solids) of many solids: in [`Exact`](crate::Exact) by exact roots, in the other tiers by the rounded
//! `t`, so that faces which coincide but are computed differently (in two frames, or one by a departing ray) may leave
//! a layer of some units.
//!
//! Crossings at one place are taken in the order of [`solids`](crate::solids): exits, touches, entries, and among these
//! the leaf of the lower index. The hit is that of the crossing with which the predicate takes the value that it keeps.
//!
//! A touch is a hit if the ray is outside of the result before and behind it, and if the leaf that it touches alone
//! would put it inside, even in the subtracted leaves that it touches there. To touch a subtracted leaf is no hit.
//!
//! `t` and part of a hit are those of the leaf; the crossing is that of the result, and the normal points out of it:
//! both are turned around where a leaf is subtracted. [`Surface::leaf`](crate::Surface::leaf) and
//! [`Combination::leaf_hits`] name the leaf. Surface coordinates are those of the leaf.
//!
//! [`Shape::contains`](crate::Shape::contains) applies the operations to the leaves, which are closed sets: a point
//! exactly on a subtracted leaf is not in the result.
//!
//! # Placement
//!
//! A combination has no placement of its own: its leaves are placed in the world, and [`Shape::placed`] does not exist
//! for its shape. (A placement of a placement would be rounded, so that an exact tier would no longer be exact.) To
//! move it, move the leaves; [`Frame::frame_to_world`](crate::Frame::frame_to_world) composes frames:
//!
//! ```
//! use raylet::{Combination, Cuboid, Cylinder, Frame, Ray, Shape, UnitVec3, Vec3};
//! let block = Shape::new(Cuboid::new(1.0_f32, 1.0, 1.0)?);
//! let hole = Shape::new(Cylinder::capped(0.5, 2.0)?).placed(Frame::at(Vec3::new(0.0, -1.0, 0.0))?);
//! let whole = Frame::from_base_and_axis(Vec3::new(0.0, 0.0, 10.0), UnitVec3::Z)?;
//! let mut leaves = [block, hole];
//! for leaf in &mut leaves {
//!     let own = leaf.frame().copied().unwrap_or(Frame::at(Vec3::ZERO)?);
//!     *leaf = leaf.placed(whole.frame_to_world(&own)?);
//! }
//! let drilled = Combination::difference(&leaves)?;
//! // Through the hole, which now runs along z, and into the block beside it.
//! let ray = |x| Ray::new(Vec3::new(x, 0.0, 0.0), UnitVec3::Z);
//! assert_eq!(drilled.shape().nearest(&ray(0.25)?), None);
//! assert_eq!(drilled.shape().nearest(&ray(0.75)?).map(|hit| hit.t), Some(9.0));
//! # Ok::<(), raylet::Error>(())
//! ```
//!
//! [`Shape::placed`]: crate::Shape::placed

mod boxes;
mod crossings;
mod departing;
mod error;
mod operation;
#[cfg(any(feature = "serde", feature = "defmt"))]
mod stored;

pub(crate) use boxes::bounds;
pub use error::CombinationError;
pub use operation::Op;

use crate::hit::Hit;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::shape::kinds::{All, Combining, Primitives};
use crate::shape::{Shape, Visible};
use crate::tier::{Stable, Tier};
use operation::{Operations, mask};

/// The most leaves of a combination.
pub const MOST_LEAVES: usize = 16;

/// The most crossings that a line can have with the leaves of a combination: two of each, and four of one that is not
/// convex (a double cone, a tube, a torus, a solid with a waist).
pub const MOST_CROSSINGS: usize = 2 * MOST_LEAVES;

/// Solids combined into one: see [`combination`](crate::shape::combination).
///
/// A block with a hole:
///
/// ```
/// use raylet::{Combination, Crossing, Cuboid, Cylinder, Ray, Shape, UnitVec3, Vec3};
/// let leaves = [Shape::new(Cuboid::new(1.0_f32, 1.0, 1.0)?), Shape::new(Cylinder::infinite(0.5)?)];
/// let drilled = Combination::difference(&leaves)?;
/// let across = Ray::new(Vec3::new(-3.0, 0.0, 0.0), UnitVec3::X)?;
/// let hits = drilled.shape().hits(&across);
/// let ts: Vec<_> = hits.iter().map(|hit| (hit.t, hit.crossing)).collect();
/// assert_eq!(ts, [(2.0, Crossing::Enter), (2.5, Crossing::Exit), (3.5, Crossing::Enter), (4.0, Crossing::Exit)]);
/// // The wall of the hole faces the axis.
/// assert_eq!(drilled.shape().surface(&across, &hits[1]).normal(), UnitVec3::X);
/// # Ok::<(), raylet::Error>(())
/// ```
///
/// In flash:
///
/// ```
/// use raylet::{Combination, Cuboid, Shape, Sphere, constant};
/// static LEAVES: [Shape<f32>; 2] = [
///     constant!(Cuboid::<f32>::const_new(1.0, 1.0, 1.0)).into_shape(),
///     constant!(Sphere::<f32>::const_new(1.25)).into_shape(),
/// ];
/// static ROUNDED: Combination<'_, f32> = constant!(Combination::intersection(&LEAVES));
/// assert!(ROUNDED.shape().contains(raylet::Vec3::new(0.875, 0.875, 0.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Combination<'a, S: Scalar, L: Primitives = All> {
    leaves: &'a [Shape<S, L>],
    operations: Operations<'a>,
    /// The leaves that are subtracted: a bit for each.
    turned: u32,
}

impl<'a, S: Scalar, L: Primitives> Combination<'a, S, L> {
    /// What is in any of the solids.
    ///
    /// # Errors
    ///
    /// As [`Combination::new`].
    pub const fn union(leaves: &'a [Shape<S, L>]) -> Result<Self, CombinationError> {
        Self::checked(leaves, Operations::Every(Op::Union))
    }

    /// What is in all of the solids.
    ///
    /// # Errors
    ///
    /// As [`Combination::new`].
    pub const fn intersection(leaves: &'a [Shape<S, L>]) -> Result<Self, CombinationError> {
        Self::checked(leaves, Operations::Every(Op::Intersection))
    }

    /// What is in the first solid and in none of the others.
    ///
    /// # Errors
    ///
    /// As [`Combination::new`].
    pub const fn difference(leaves: &'a [Shape<S, L>]) -> Result<Self, CombinationError> {
        Self::checked(leaves, Operations::Every(Op::Difference))
    }

    /// Any nested combination, by its operations in postfix notation, in which every leaf is taken once, in order. A
    /// solid that is needed twice is listed twice.
    ///
    /// # Errors
    ///
    /// [`CombinationError`] for no leaf or more than [`MOST_LEAVES`], for one that is not a solid or is seen from one
    /// side only, if a line may have more than [`MOST_CROSSINGS`] crossings with them, and for operations that do not
    /// combine each leaf once to one set.
    ///
    /// ```
    /// use raylet::shape::combination::Op;
    /// use raylet::{Combination, Cuboid, Cylinder, Shape, Sphere, Vec3};
    /// // (block and ball) less hole.
    /// let leaves = [
    ///     Shape::new(Cuboid::new(1.0_f32, 1.0, 1.0)?),
    ///     Shape::new(Sphere::new(1.25)?),
    ///     Shape::new(Cylinder::infinite(0.5)?),
    /// ];
    /// let operations = [Op::Leaf, Op::Leaf, Op::Intersection, Op::Leaf, Op::Difference];
    /// let bead = Combination::new(&leaves, &operations)?;
    /// let is_in = |x| bead.shape().contains(Vec3::new(x, 0.75, 0.0));
    /// assert_eq!([0.25, 0.75, 1.0].map(is_in), [false, true, true]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub const fn new(leaves: &'a [Shape<S, L>], operations: &'a [Op]) -> Result<Self, CombinationError> {
        Self::checked(leaves, Operations::Listed(operations))
    }

    const fn checked(leaves: &'a [Shape<S, L>], operations: Operations<'a>) -> Result<Self, CombinationError> {
        let given = leaves.len();
        if given == 0 || given > MOST_LEAVES {
            return Err(CombinationError::Leaves { given });
        }
        let (mut left, mut leaf, mut most) = (leaves, 0_u32, 0_usize);
        while let Some((shape, behind)) = left.split_first() {
            let crossings = shape.primitive().most_crossings();
            if crossings == 0 {
                return Err(CombinationError::NotSolid { leaf });
            }
            if !matches!(shape.visible(), Visible::Both) {
                return Err(CombinationError::OneSided { leaf });
            }
            (left, leaf, most) = (behind, leaf.saturating_add(1), most.saturating_add(crossings));
        }
        if most > MOST_CROSSINGS {
            return Err(CombinationError::Crossings { most });
        }
        match operations.check(given) {
            Ok(()) => Ok(Self { leaves, operations, turned: operations.turned(leaf) }),
            Err(error) => Err(error),
        }
    }

    /// The solids that are combined.
    pub const fn leaves(&self) -> &'a [Shape<S, L>] {
        self.leaves
    }

    /// The operations, as [`Combination::new`] takes them.
    ///
    /// ```
    /// use raylet::shape::combination::Op;
    /// use raylet::{Combination, Shape, Sphere};
    /// let balls = [Shape::new(Sphere::new(1.0_f32)?); 3];
    /// let union: Vec<_> = Combination::union(&balls)?.operations().collect();
    /// assert_eq!(union, [Op::Leaf, Op::Leaf, Op::Union, Op::Leaf, Op::Union]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn operations(&self) -> impl Iterator<Item = Op> + use<'a, S, L> {
        self.operations.iter(self.leaves.len())
    }

    /// Its shape, seen from both sides.
    pub const fn shape(&'a self) -> Shape<S, Combining<'a, L>> {
        Shape::combining(self)
    }

    /// All hits of a ray, sorted by `t`, with their leaves.
    ///
    /// ```
    /// use raylet::{Combination, Cuboid, Part, Ray, Shape, Sphere, UnitVec3, Vec3};
    /// let leaves = [Shape::new(Cuboid::new(1.0_f32, 1.0, 1.0)?), Shape::new(Sphere::new(0.5)?)];
    /// let hollow = Combination::difference(&leaves)?;
    /// let ray = Ray::new(Vec3::new(-3.0, 0.0, 0.0), UnitVec3::X)?;
    /// let hits: Vec<_> = hollow.leaf_hits(&ray).map(|on| (on.leaf, on.hit.part)).collect();
    /// assert_eq!(hits, [(0, Part::Left), (1, Part::Side), (1, Part::Side), (0, Part::Right)]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn leaf_hits(&self, ray: &Ray<S>) -> impl Iterator<Item = LeafHit<S>> {
        self.leaf_hits_at::<Stable>(ray)
    }

    /// As [`Combination::leaf_hits`], in a chosen accuracy tier.
    pub fn leaf_hits_at<T: Tier<S>>(&self, ray: &Ray<S>) -> impl Iterator<Item = LeafHit<S>> {
        self.changes::<T>(ray)
    }

    fn with_bits(&self) -> impl Iterator<Item = (u32, &'a Shape<S, L>)> {
        (0_u32..).map(|leaf| 1_u32.wrapping_shl(leaf)).zip(self.leaves)
    }

    /// True if a point that lies in these leaves lies in the result.
    #[inline]
    fn holds(&self, leaves: u32) -> bool {
        self.operations.hold(leaves, self.leaves.len() as u32)
    }

    /// The leaves that are not subtracted.
    const fn added(&self) -> u32 {
        mask(self.leaves.len() as u32) & !self.turned
    }

    /// True if the leaf of this index is subtracted, an odd number of times: what is in it more is in the result less,
    /// and its surface is turned around.
    ///
    /// ```
    /// use raylet::shape::combination::Op;
    /// use raylet::{Combination, Shape, Sphere};
    /// let balls = [Shape::new(Sphere::new(1.0_f32)?); 3];
    /// // The first less (the second less the third).
    /// let operations = [Op::Leaf, Op::Leaf, Op::Leaf, Op::Difference, Op::Difference];
    /// let combination = Combination::new(&balls, &operations)?;
    /// assert_eq!([0, 1, 2].map(|leaf| combination.is_subtracted(leaf)), [false, true, false]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub const fn is_subtracted(&self, leaf: u32) -> bool {
        self.turned.wrapping_shr(leaf) & 1 != 0
    }
}

/// A hit of a combination, and the leaf that it is on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct LeafHit<S> {
    /// The index of the leaf.
    pub leaf: u32,
    /// Where, on which part, and how the ray crosses the result.
    pub hit: Hit<S>,
}
