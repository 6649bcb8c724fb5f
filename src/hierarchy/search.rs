//! The search through many shapes, with a hierarchy or one after the other: for scenes and for
//! [`Shapes`](super::Shapes).

use super::Hierarchy;
use crate::hit::{Hit, Hits};
use crate::ray::{Range, Ray};
use crate::scalar::Scalar;
use crate::shape::Shaped;
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

/// The nearest hit of a ray, and the index of its shape: the lower one of two that are hit at the same `t`.
#[inline(always)]
pub(crate) fn nearest<S: Scalar, T: Tier<S>, W: Watch>(
    shapes: &[impl Shaped<S>],
    hierarchy: Option<&Hierarchy<'_, S>>,
    ray: &Ray<S>,
    watch: &mut W,
) -> Option<(u32, Hit<S>)> {
    let mut nearest: Option<(u32, Hit<S>)> = None;
    let mut shortened = *ray;
    let mut test = |index: u32, watch: &mut W| {
        let shape = shapes.get(index as usize)?.shape();
        watch.count_test();
        // The rounding of an exact root close to the end of a range depends on that end: the result of a shape must not
        // depend on that of another.
        let searched = if T::EXACT_ENDS { ray } else { &shortened };
        let hit = shape.nearest_at::<T>(&for_shape(searched, index));
        watch.tested(index, hit.is_some());
        if let Some(hit) = hit
            && nearest.is_none_or(|(own, best)| hit.t < best.t || (hit.t == best.t && index < own))
        {
            nearest = Some((index, hit));
            // Its `t` is rounded: the exact root of an equal hit, of a lower index, may lie above it.
            let end = if T::EXACT_ENDS { sooner(hit.t.next_up(), ray.range().end()) } else { hit.t };
            if let Ok(range) = Range::new(ray.range().start(), end) {
                shortened = shortened.with_range(range);
            }
        }
        Some(shortened.range().end())
    };
    if let Some(hierarchy) = hierarchy {
        hierarchy.walk(ray, watch, test);
    } else {
        for (index, _) in (0_u32..).zip(shapes) {
            let _ = test(index, watch);
        }
    }
    nearest
}

fn sooner<S: Scalar>(a: S, b: S) -> S {
    if a < b { a } else { b }
}

/// The index of any shape that the ray hits, not necessarily of the nearest: the first one that the search finds.
#[inline(always)]
pub(crate) fn occluder<S: Scalar, T: Tier<S>, W: Watch>(
    shapes: &[impl Shaped<S>],
    hierarchy: Option<&Hierarchy<'_, S>>,
    ray: &Ray<S>,
    watch: &mut W,
) -> Option<u32> {
    let Some(hierarchy) = hierarchy else {
        let mut indices = (0_u32..).zip(shapes).map(|(index, _)| index);
        return indices.find(|index| is_hit::<S, T, W>(shapes, *index, ray, watch));
    };
    let mut occluder = None;
    hierarchy.walk(ray, watch, |index, watch| {
        if is_hit::<S, T, W>(shapes, index, ray, watch) {
            occluder = Some(index);
            return None;
        }
        Some(ray.range().end())
    });
    occluder
}

/// True if the ray hits the shape of this index; false beyond the last shape.
#[inline(always)]
pub(crate) fn is_hit<S: Scalar, T: Tier<S>, W: Watch>(
    shapes: &[impl Shaped<S>],
    index: u32,
    ray: &Ray<S>,
    watch: &mut W,
) -> bool {
    let Some(of) = shapes.get(index as usize) else { return false };
    watch.count_test();
    let found = of.shape().occludes_at::<T>(&for_shape(ray, index));
    watch.tested(index, found);
    found
}

/// Calls `each` with the hits of every shape that has some, or that the ray starts inside of.
pub(super) fn every_hit<S: Scalar, T: Tier<S>>(
    shapes: &[impl Shaped<S>],
    hierarchy: &Hierarchy<'_, S>,
    ray: &Ray<S>,
    each: &mut impl FnMut(u32, Hits<S>),
) {
    hierarchy.walk(ray, &mut (), |index, ()| {
        let hits = shapes.get(index as usize)?.shape().hits_at::<T>(&for_shape(ray, index));
        if !hits.is_empty() || hits.starts_inside() || hits.coincident().is_some() {
            each(index, hits);
        }
        Some(ray.range().end())
    });
}

/// The ray for a test of the shape of this index: with its departure only if that names the shape.
fn for_shape<S: Scalar>(ray: &Ray<S>, index: u32) -> Ray<S> {
    match ray.departure() {
        Some(departure) if departure.object == index => *ray,
        _ => ray.without_departure(),
    }
}
