//! What a shape holds if it is a combination; nothing, by its type, if it cannot be one.

use super::kinds::Primitives;
use super::{Shape, Visible};
use crate::hit::{Hit, HitList, Hits, MOST_HITS};
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::shape::combination::{Combination, Op};
use crate::tier::Tier;
use crate::vector::Vec3;
use core::fmt::Debug;
use core::marker::PhantomData;

/// The leaves and the operations of a combination.
pub(crate) type Parts<'a, S, L, I> = (&'a [Shape<S, L>], I);

/// What a shape holds if it is a combination. Its methods answer `None` for a primitive.
///
/// Of kinds without combinations they are constants, so that the compiler removes what would follow.
pub trait Combined<S: Scalar>: Copy + Debug + PartialEq {
    /// The kinds of the leaves.
    type Leaves: Primitives;
    /// The list of all hits.
    type Hits: HitList<S>;
    /// What the surface at a hit of a combination knows of its leaf.
    type Leaf: Copy + Debug + PartialEq;

    /// A primitive.
    const NONE: Self;
    /// The surface of a primitive.
    const NO_LEAF: Self::Leaf;

    /// The leaves and the operations.
    fn parts(&self) -> Option<Parts<'_, S, Self::Leaves, impl Iterator<Item = Op>>>;
    /// True if it is a combination.
    fn is_combination(&self) -> bool;
    /// All hits: its own, or those of the primitive.
    fn hits<T: Tier<S>>(&self, ray: &Ray<S>, of_primitive: impl FnOnce() -> Hits<S>) -> Self::Hits;
    /// The first hit that is seen; none of a primitive.
    fn nearest<T: Tier<S>>(&self, ray: &Ray<S>, visible: Visible) -> Option<Hit<S>>;
    /// Whether it contains a point.
    fn contains<T: Tier<S>>(&self, point: Vec3<S>) -> Option<bool>;
    /// The leaf of a hit.
    fn at<T: Tier<S>>(&self, ray: &Ray<S>, hit: &Hit<S>) -> Option<OnLeaf<'_, S, Self::Leaves, Self::Leaf>>;
    /// True if the result is on the other side of the leaf's surface than the leaf.
    fn is_turned(leaf: Self::Leaf) -> bool;
    /// The combination, to be written.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    fn combination(&self) -> Option<&Combination<'_, S, Self::Leaves>>;
}

/// A hit of a combination as one of its leaf.
#[derive(Debug)]
pub struct OnLeaf<'a, S: Scalar, L: Primitives, X> {
    /// The leaf.
    pub(crate) shape: &'a Shape<S, L>,
    /// The ray that it was tested with.
    pub(crate) ray: Ray<S>,
    /// The hit, crossed as the leaf is.
    pub(crate) hit: Hit<S>,
    pub(crate) leaf: X,
}

/// The index of a leaf, and whether the result is on the other side of its surface than it is itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaf {
    pub(crate) index: u32,
    pub(crate) is_turned: bool,
}

/// A shape that cannot be a combination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotCombined<L>(PhantomData<L>);

impl<S: Scalar, L: Primitives> Combined<S> for NotCombined<L> {
    type Leaves = L;
    type Hits = Hits<S, MOST_HITS>;
    type Leaf = ();

    const NONE: Self = Self(PhantomData);
    const NO_LEAF: () = ();

    #[inline(always)]
    fn parts(&self) -> Option<Parts<'_, S, L, impl Iterator<Item = Op>>> {
        None::<(_, core::iter::Empty<Op>)>
    }
    #[inline(always)]
    fn is_combination(&self) -> bool {
        false
    }
    #[inline(always)]
    fn hits<T: Tier<S>>(&self, _: &Ray<S>, of_primitive: impl FnOnce() -> Hits<S>) -> Hits<S> {
        of_primitive()
    }
    #[inline(always)]
    fn nearest<T: Tier<S>>(&self, _: &Ray<S>, _: Visible) -> Option<Hit<S>> {
        None
    }
    #[inline(always)]
    fn contains<T: Tier<S>>(&self, _: Vec3<S>) -> Option<bool> {
        None
    }
    #[inline(always)]
    fn at<T: Tier<S>>(&self, _: &Ray<S>, _: &Hit<S>) -> Option<OnLeaf<'_, S, L, ()>> {
        None
    }
    #[inline(always)]
    fn is_turned((): ()) -> bool {
        false
    }
    #[cfg(any(feature = "serde", feature = "defmt"))]
    #[inline(always)]
    fn combination(&self) -> Option<&Combination<'_, S, L>> {
        None
    }
}

impl<'a, S: Scalar, L: Primitives> Combined<S> for Option<&'a Combination<'a, S, L>> {
    type Leaves = L;
    type Hits = Hits<S, { crate::shape::combination::MOST_CROSSINGS }>;
    type Leaf = Option<Leaf>;

    const NONE: Self = None;
    const NO_LEAF: Option<Leaf> = None;

    fn parts(&self) -> Option<Parts<'_, S, L, impl Iterator<Item = Op>>> {
        self.map(|combination| (combination.leaves(), combination.operations()))
    }
    fn is_combination(&self) -> bool {
        self.is_some()
    }
    #[inline(always)]
    fn hits<T: Tier<S>>(&self, ray: &Ray<S>, of_primitive: impl FnOnce() -> Hits<S>) -> Self::Hits {
        let mut hits = Hits::none();
        match self {
            Some(combination) => combination.all_hits::<T>(ray, &mut hits),
            None => hits.take(&of_primitive()),
        }
        hits
    }
    fn nearest<T: Tier<S>>(&self, ray: &Ray<S>, visible: Visible) -> Option<Hit<S>> {
        self.and_then(|combination| combination.nearest_seen::<T>(ray, visible))
    }
    fn contains<T: Tier<S>>(&self, point: Vec3<S>) -> Option<bool> {
        self.map(|combination| combination.holds_at::<T>(point))
    }
    fn at<T: Tier<S>>(&self, ray: &Ray<S>, hit: &Hit<S>) -> Option<OnLeaf<'_, S, L, Option<Leaf>>> {
        self.and_then(|combination| combination.on_leaf::<T>(ray, hit))
    }
    fn is_turned(leaf: Option<Leaf>) -> bool {
        leaf.is_some_and(|leaf| leaf.is_turned)
    }
    #[cfg(any(feature = "serde", feature = "defmt"))]
    fn combination(&self) -> Option<&Combination<'_, S, L>> {
        *self
    }
}
