//! The search through many shapes, with a hierarchy or one after the other: for scenes and for
//! [`Shapes`](super::Shapes).

use super::Hierarchy;
use crate::hit::{Crossing, Hit, HitList};
use crate::ray::{Departure, Range, Ray};
use crate::scalar::Scalar;
use crate::shape::kinds::Kinds;
use crate::shape::{HitsOf, Shape, Shaped, known};
use crate::tier::Tier;

/// Counts the tests. `()` does not count, and costs nothing.
pub(crate) trait Watch {
    /// A ray is about to be tested against a shape.
    #[inline(always)]
    fn count_test(&mut self) {}

    /// A ray is about to be tested against a box.
    #[inline(always)]
    fn count_box(&mut self) {}

    /// The shape of this index was tested, for the nearest hit or for occlusion.
    #[inline(always)]
    fn tested(&mut self, index: u32, found: bool) {
        let _ = (index, found);
    }
}

impl Watch for () {}

/// What is known of the start of a ray among many shapes, beside its coordinates, and which hits may have one place.
pub(crate) trait Known<S: Scalar> {
    /// False if nothing is known but departures. The code of all else is then removed.
    const KNOWS_INSIDE: bool;
    /// False if no surface is shaded. No normal is then computed to find what has one place.
    const SHADES: bool;

    /// The shapes whose results do not follow from where the ray starts, so that no box may exclude them.
    fn shapes(&self) -> impl Iterator<Item = u32> + Clone;
    /// How the ray departs from a shape.
    fn departure_from(&self, shape: u32) -> Option<Departure>;
    /// Whether it starts inside of a solid that it does not depart from; `None` if its coordinates decide.
    fn is_inside(&self, shape: u32) -> Option<bool>;
    /// The largest `t` that may be the same place as this one.
    fn near(&self, t: S) -> S;
    /// False if it is certain that the ray does not meet this shape.
    #[inline(always)]
    fn may_meet(&self, shape: u32) -> bool {
        let _ = shape;
        true
    }
}

/// Nothing but the departure of the ray itself.
impl<S: Scalar> Known<S> for Ray<S> {
    const KNOWS_INSIDE: bool = false;
    const SHADES: bool = true;

    #[inline(always)]
    fn shapes(&self) -> impl Iterator<Item = u32> + Clone {
        self.departure().map(|departure| departure.object).into_iter()
    }
    #[inline(always)]
    fn departure_from(&self, shape: u32) -> Option<Departure> {
        self.departure().filter(|departure| departure.object == shape)
    }
    #[inline(always)]
    fn is_inside(&self, _: u32) -> Option<bool> {
        None
    }
    #[inline(always)]
    fn near(&self, t: S) -> S {
        t
    }
}

/// The nearest hit of a ray, the index of its shape, and whether another shape may be hit at the same place. It is the
/// lower index of two that are hit at the same `t`.
#[inline(always)]
pub(crate) fn nearest<S: Scalar, T: Tier<S>, W: Watch>(
    shapes: &[impl Shaped<S>],
    hierarchy: Option<&Hierarchy<'_, S>>,
    ray: &Ray<S>,
    known: &impl Known<S>,
    watch: &mut W,
) -> Option<(u32, Hit<S>, bool)> {
    let mut nearest: Option<(u32, Hit<S>)> = None;
    // The hit that is the nearest but one, or that was the nearest.
    let mut second: Option<S> = None;
    let whole = ray.without_departure();
    let mut shortened = whole;
    let mut test = |index: u32, watch: &mut W| {
        if !known.may_meet(index) {
            return Some(shortened.range().end());
        }
        let shape = shapes.get(index as usize)?.shape();
        watch.count_test();
        // The rounding of an exact root close to the end of a range depends on that end: the result of a shape must not
        // depend on that of another.
        let searched = if T::EXACT_ENDS { &whole } else { &shortened };
        let hit = first_hit::<S, T, _>(shape, searched, index, known);
        watch.tested(index, hit.is_some());
        if let Some(hit) = hit {
            if nearest.is_none_or(|(own, best)| hit.t < best.t || (hit.t == best.t && index < own)) {
                second = nearest.map(|(_, hit)| hit.t);
                nearest = Some((index, hit));
                let reach = known.near(hit.t);
                // Its `t` is rounded: the exact root of an equal hit, of a lower index, may lie above it.
                let end = if T::EXACT_ENDS { sooner(reach.next_up(), ray.range().end()) } else { reach };
                if let Ok(range) = Range::new(ray.range().start(), sooner(end, ray.range().end())) {
                    shortened = shortened.with_range(range);
                }
            } else if second.is_none_or(|second| hit.t < second) {
                second = Some(hit.t);
            }
        }
        Some(shortened.range().end())
    };
    each(shapes.len(), hierarchy, ray, known, watch, &mut test);
    nearest.map(|(index, hit)| (index, hit, second.is_some_and(|second| second <= known.near(hit.t))))
}

/// Calls `found` with the first hit of every shape up to this `t`.
pub(crate) fn up_to<S: Scalar, T: Tier<S>, W: Watch>(
    shapes: &[impl Shaped<S>],
    hierarchy: Option<&Hierarchy<'_, S>>,
    ray: &Ray<S>,
    known: &impl Known<S>,
    end: S,
    watch: &mut W,
    found: &mut impl FnMut(u32, Hit<S>),
) {
    let whole = ray.without_departure();
    each(shapes.len(), hierarchy, ray, known, watch, &mut |index, watch: &mut W| {
        if !known.may_meet(index) {
            return Some(end);
        }
        let shape = shapes.get(index as usize)?.shape();
        watch.count_test();
        let hit = first_hit::<S, T, _>(shape, &whole, index, known);
        watch.tested(index, hit.is_some());
        if let Some(hit) = hit.filter(|hit| hit.t <= end) {
            found(index, hit);
        }
        Some(end)
    });
}

/// The first visible hit of a shape by a ray, which is given without its departures.
#[inline(always)]
fn first_hit<S: Scalar, T: Tier<S>, K: Kinds>(
    shape: &Shape<S, K>,
    ray: &Ray<S>,
    index: u32,
    known: &impl Known<S>,
) -> Option<Hit<S>> {
    if let Some(departure) = known.departure_from(index) {
        return shape.nearest_at::<T>(&ray.departing(departure));
    }
    if !starts_inside(known, index) {
        let hit = shape.nearest_at::<T>(ray);
        let is_left = matches!(hit, Some(Hit { crossing: Crossing::Exit, .. }));
        if !(is_left && knows(known) && known.is_inside(index) == Some(false)) {
            return hit;
        }
    }
    first_corrected::<S, T, K>(shape, ray, known.is_inside(index))
}

/// True if more may be known than departures.
#[inline(always)]
const fn knows<S: Scalar, N: Known<S>>(_: &N) -> bool {
    N::KNOWS_INSIDE
}

/// True if the ray is known to start inside of a shape that it does not depart from.
#[inline(always)]
fn starts_inside<S: Scalar>(known: &impl Known<S>, index: u32) -> bool {
    knows(known) && known.is_inside(index) == Some(true)
}

/// The first visible hit of a solid, of which it is known whether the ray starts inside.
#[cold]
#[inline(never)]
fn first_corrected<S: Scalar, T: Tier<S>, K: Kinds>(
    shape: &Shape<S, K>,
    ray: &Ray<S>,
    is_inside: Option<bool>,
) -> Option<Hit<S>> {
    let (hits, _) = known::crossings::<S, T, K>(ray, shape, is_inside);
    hits.iter().copied().find(|hit| shape.visible().sees(hit.crossing))
}

fn sooner<S: Scalar>(a: S, b: S) -> S {
    if a < b { a } else { b }
}

/// Calls `test` with the index of every shape that the ray may meet. `test` returns the end of the range that remains
/// to be searched, or `None` to stop.
#[inline(always)]
fn each<S: Scalar, W: Watch>(
    shapes: usize,
    hierarchy: Option<&Hierarchy<'_, S>>,
    ray: &Ray<S>,
    known: &impl Known<S>,
    watch: &mut W,
    test: &mut impl FnMut(u32, &mut W) -> Option<S>,
) {
    if let Some(hierarchy) = hierarchy {
        hierarchy.walk(ray, &known.shapes(), watch, test);
    } else {
        for index in 0..shapes as u32 {
            if test(index, watch).is_none() {
                return;
            }
        }
    }
}

/// The index of any shape that the ray hits, not necessarily of the nearest: the first one that the search finds.
#[inline(always)]
pub(crate) fn occluder<S: Scalar, T: Tier<S>, W: Watch>(
    shapes: &[impl Shaped<S>],
    hierarchy: Option<&Hierarchy<'_, S>>,
    ray: &Ray<S>,
    known: &impl Known<S>,
    watch: &mut W,
) -> Option<u32> {
    let (whole, mut occluder) = (ray.without_departure(), None);
    each(shapes.len(), hierarchy, ray, known, watch, &mut |index, watch: &mut W| {
        if known.may_meet(index) && is_hit::<S, T, W>(shapes, index, &whole, known, watch) {
            occluder = Some(index);
            return None;
        }
        Some(ray.range().end())
    });
    occluder
}

/// True if the ray, which is given without its departures, hits the shape of this index; false beyond the last shape.
#[inline(always)]
pub(crate) fn is_hit<S: Scalar, T: Tier<S>, W: Watch>(
    shapes: &[impl Shaped<S>],
    index: u32,
    ray: &Ray<S>,
    known: &impl Known<S>,
    watch: &mut W,
) -> bool {
    let Some(of) = shapes.get(index as usize) else { return false };
    watch.count_test();
    let found = if let Some(departure) = known.departure_from(index) {
        of.shape().occludes_at::<T>(&ray.departing(departure))
    } else if starts_inside(known, index) {
        first_corrected::<S, T, _>(of.shape(), ray, Some(true)).is_some()
    } else {
        of.shape().occludes_at::<T>(ray)
    };
    watch.tested(index, found);
    found
}

/// Calls `each` with the hits of every shape that has some, or that the ray starts inside of.
pub(super) fn every_hit<S: Scalar, T: Tier<S>, X: Shaped<S>>(
    shapes: &[X],
    hierarchy: &Hierarchy<'_, S>,
    ray: &Ray<S>,
    each: &mut impl FnMut(u32, HitsOf<S, X>),
) {
    hierarchy.walk(ray, &ray.shapes(), &mut (), |index, ()| {
        let own = ray.departure_from(index).map_or_else(|| ray.without_departure(), |_| *ray);
        let hits = shapes.get(index as usize)?.shape().hits_at::<T>(&own);
        if !hits.is_empty() || hits.starts_inside() || hits.coincident().is_some() {
            each(index, hits);
        }
        Some(ray.range().end())
    });
}
