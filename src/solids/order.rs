//! The order of the crossings of many solids along one ray.

use super::Start;
use crate::hit::{Crossing, Hit, Hits};
use crate::query::Crossed;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::shape::kinds::Kinds;
use crate::shape::{Shape, Shaped};
use crate::solve::{Of, Root};
use crate::tier::Tier;
use core::cmp::Ordering;

/// A crossing of one of many solids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Entry<S> {
    pub(super) solid: u32,
    pub(super) hit: Hit<S>,
    /// Its place among those at equal `t`.
    pub(super) class: Class,
    /// It was moved to the start of the range.
    pub(super) is_at_start: bool,
    /// The set of solids changes there.
    pub(super) is_solid: bool,
}

/// The order of crossings at equal `t`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Class {
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
pub(super) struct Located<'a, S: Scalar, K: Kinds> {
    ray: Ray<S>,
    shape: &'a Shape<S, K>,
    entry: Entry<S>,
}

/// Finds the solid of a crossing in its list, and the ray that it was tested with.
pub(super) fn located<'a, S: Scalar, X: Shaped<S>, const W: usize>(
    shapes: &'a [X],
    ray: &Ray<S>,
    start: &Start<W>,
) -> impl Fn(&Entry<S>) -> Option<Located<'a, S, X::Kinds>> {
    |entry| {
        let shape = shapes.get(entry.solid as usize)?.shape();
        Some(Located { ray: start.ray_for(ray, entry.solid), shape, entry: *entry })
    }
}

impl<S: Scalar, K: Kinds> Crossed<S> for Located<'_, S, K> {
    fn root<N: Of<S>>(&self) -> Option<Root<N>> {
        let Entry { hit, is_at_start, .. } = &self.entry;
        if *is_at_start {
            return Some(Root::at_parameter(N::scalar(hit.t)));
        }
        let root = self.shape.root::<N>(&self.ray, hit)?;
        // An exit that rounding puts before the start of a departing ray is at the start: rule 8 of the contract.
        if hit.t == S::ZERO && self.ray.departure().is_some() { root.not_before_start() } else { Some(root) }
    }
}

/// How two crossings compare by `t`; by the exact one in the tier `Exact`.
pub(super) fn by_t<S: Scalar, T: Tier<S>, C: Crossed<S>>(
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

/// How two crossings compare: by `t`, and at equal `t` by the rule of [`solids`](super). Those of one solid keep their
/// order.
pub(super) fn order<S: Scalar, T: Tier<S>, C: Crossed<S>>(
    a: &Entry<S>,
    b: &Entry<S>,
    located: &impl Fn(&Entry<S>) -> Option<C>,
) -> Ordering {
    by_t::<S, T, C>(a, b, located).then(a.class.cmp(&b.class)).then(a.solid.cmp(&b.solid))
}

/// The crossings of one solid, with their places among those of others.
pub(super) fn entries<S: Scalar, T: Tier<S>, K: Kinds, C: Crossed<S>>(
    solid: u32,
    shape: &Shape<S, K>,
    (hits, is_moved): &(Hits<S>, bool),
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
