//! The order of the crossings of many solids along one ray.

use super::Shape;
use super::kinds::Kinds;
use crate::hit::{Crossing, Hit};
use crate::query::Crossed;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::solve::{Of, Root};
use crate::tier::Tier;
use core::cmp::Ordering;
use core::marker::PhantomData;
use core::ops::Deref;

/// A crossing of one of many solids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Entry<S> {
    pub(crate) solid: u32,
    pub(crate) hit: Hit<S>,
    /// Its place among those at equal `t`.
    pub(crate) class: Class,
    /// It was moved to the start of the range.
    pub(crate) is_at_start: bool,
    /// The set of solids changes there.
    pub(crate) is_solid: bool,
}

/// The order of crossings at equal `t`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Class {
    Exit,
    Touch,
    /// An entry, or the exit at the `t` of its own entry.
    Enter,
}

impl From<Crossing> for Class {
    fn from(crossing: Crossing) -> Self {
        match crossing {
            Crossing::Exit => Self::Exit,
            Crossing::Touch => Self::Touch,
            Crossing::Enter => Self::Enter,
        }
    }
}

/// A crossing with what its exact root is computed from.
pub(crate) struct Located<'a, S: Scalar, K: Kinds, T> {
    ray: Ray<S>,
    shape: &'a Shape<S, K>,
    entry: Entry<S>,
    tier: PhantomData<T>,
}

impl<'a, S: Scalar, K: Kinds, T> Located<'a, S, K, T> {
    /// A crossing of this solid by this ray, found in the tier `T`.
    pub(crate) const fn new(ray: Ray<S>, shape: &'a Shape<S, K>, entry: &Entry<S>) -> Self {
        Self { ray, shape, entry: *entry, tier: PhantomData }
    }
}

impl<S: Scalar, K: Kinds, T: Tier<S>> Crossed<S> for Located<'_, S, K, T> {
    fn root<N: Of<S>>(&self) -> Option<Root<N>> {
        let Entry { hit, is_at_start, .. } = &self.entry;
        if *is_at_start {
            return Some(Root::at_parameter(N::scalar(hit.t)));
        }
        let root = self.shape.root::<N, T>(&self.ray, hit)?;
        // An exit that rounding puts before the start of a departing ray is at the start: rule 8 of the contract.
        if hit.t == S::ZERO && self.ray.departure().is_some() { root.not_before_start() } else { Some(root) }
    }
}

/// How two crossings compare by `t`; by the exact one in the tier `Exact`.
pub(crate) fn by_t<S: Scalar, T: Tier<S>, C: Crossed<S>>(
    a: &Entry<S>,
    b: &Entry<S>,
    located: &impl Fn(&Entry<S>) -> Option<C>,
) -> Ordering {
    let (t, other) = (a.hit.t, b.hit.t);
    if T::EXACT_ENDS {
        // Each is within a unit of its exact value.
        let is_apart = |low: S, high: S| low.next_up().next_up() < high;
        if !is_apart(t, other)
            && !is_apart(other, t)
            && let (Some(a), Some(b)) = (located(a), located(b))
            && let Some(order) = T::order(&a, &b)
        {
            return order;
        }
    }
    // No `t` is NaN.
    t.partial_cmp(&other).unwrap_or(Ordering::Equal)
}

/// How two crossings compare: by `t`, and at equal `t` by the rule of [`solids`](crate::solids). Those of one solid
/// keep their order.
pub(crate) fn order<S: Scalar, T: Tier<S>, C: Crossed<S>>(
    a: &Entry<S>,
    b: &Entry<S>,
    located: &impl Fn(&Entry<S>) -> Option<C>,
) -> Ordering {
    by_t::<S, T, C>(a, b, located).then(a.class.cmp(&b.class)).then(a.solid.cmp(&b.solid))
}

/// The crossings of one solid, with their places among those of others.
pub(crate) fn entries<S: Scalar, T: Tier<S>, K: Kinds, C: Crossed<S>>(
    solid: u32,
    shape: &Shape<S, K>,
    (hits, is_moved): &(K::Hits<S>, bool),
    located: &impl Fn(&Entry<S>) -> Option<C>,
) -> impl Iterator<Item = Entry<S>> {
    hits.iter().enumerate().scan(None, move |last: &mut Option<Entry<S>>, (index, hit)| {
        let (class, is_at_start) = (Class::from(hit.crossing), *is_moved && index == 0);
        let mut entry = Entry { solid, hit: *hit, class, is_at_start, is_solid: shape.is_solid() };
        if let Some(last) = last
            && last.class > class
            && by_t::<S, T, C>(last, &entry, located).is_eq()
        {
            entry.class = last.class;
        }
        *last = Some(entry);
        Some(entry)
    })
}

/// Crossings of many solids, in order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ordered<S, const N: usize> {
    /// Never popped from, so that it is one slice. (To make an empty `Vec` of `heapless` 0.9 zeroes its memory: of 32
    /// crossings, that takes 533 instructions on an M0+ and an M4F.)
    list: heapless::Deque<Entry<S>, N>,
}

impl<S: Scalar, const N: usize> Ordered<S, N> {
    #[inline(always)]
    pub(crate) const fn new() -> Self {
        Self { list: heapless::Deque::new() }
    }

    pub(crate) fn clear(&mut self) {
        self.list.clear();
    }

    /// Puts a crossing in its place, behind those of its own solid.
    ///
    /// # Errors
    ///
    /// The last crossing, if there is no room.
    pub(crate) fn insert<T: Tier<S>, C: Crossed<S>>(
        &mut self,
        mut entry: Entry<S>,
        located: &impl Fn(&Entry<S>) -> Option<C>,
    ) -> Result<(), Entry<S>> {
        let (list, _) = self.list.as_mut_slices();
        let place = list.iter().rposition(|other| {
            other.solid == entry.solid || order::<S, T, C>(other, &entry, located) == Ordering::Less
        });
        // Each of the later ones moves up by one place.
        let later = list.iter_mut().skip(place.map_or(0, |place| place + 1));
        later.for_each(|later| core::mem::swap(later, &mut entry));
        self.list.push_back(entry)
    }
}

impl<S, const N: usize> Deref for Ordered<S, N> {
    type Target = [Entry<S>];
    #[inline]
    fn deref(&self) -> &[Entry<S>] {
        let (list, _) = self.list.as_slices();
        list
    }
}
