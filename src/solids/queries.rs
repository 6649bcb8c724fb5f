//! The nearest hit and occlusion of many solids by a ray whose start is known.

use super::{List, Start};
use crate::hit::Hit;
use crate::ray::{Range, Ray};
use crate::scalar::Scalar;
use crate::shape::Shaped;
use crate::shape::order::{self, Entry};
use crate::tier::Tier;
use core::ops::ControlFlow;

/// Calls `test` with every solid of a list that a ray may meet, and its ray, until it breaks: first those whose result
/// does not follow from where the ray is, so that no box may exclude them. The ray of all others is the same one.
pub(super) fn each<S: Scalar, L: List<S> + ?Sized, const W: usize>(
    solids: &L,
    ray: &Ray<S>,
    start: &Start<W>,
    mut test: impl FnMut(u32, &L::Item, &Ray<S>) -> ControlFlow<()>,
) {
    let (shapes, plain) = (solids.list(), ray.without_departure());
    let is_known =
        |solid: u32| start.knows(solid) || ray.departure().is_some_and(|departure| departure.object == solid);
    let mut seen = |solid: u32, own: &Ray<S>| match shapes.get(solid as usize) {
        Some(shape) if !start.leaves_out(solid) => test(solid, shape, own),
        _ => ControlFlow::Continue(()),
    };
    for (solid, _) in (0_u32..).zip(shapes) {
        if is_known(solid) && seen(solid, &start.ray_for(ray, solid)).is_break() {
            return;
        }
    }
    solids.visit(&plain, |solid| if is_known(solid) { ControlFlow::Continue(()) } else { seen(solid, &plain) });
}

/// The first visible crossing of a ray among many solids, and the index of its solid: that of
/// [`Crossings`](super::Crossings), at equal `t` too, without a list of the others. `None` if there is none.
///
/// ```
/// use raylet::solids::{self, SolidSet, Start};
/// use raylet::{Ray, Shape, Sphere, Stable, UnitVec3, Vec3};
/// let balls = [Shape::new(Sphere::new(2.0_f32)?), Shape::new(Sphere::new(1.0)?)];
/// let ray = Ray::new(Vec3::new(-5.0, 0.0, 0.0), UnitVec3::X)?;
/// // Through the outer ball, which is left out.
/// let start = Start::<1>::new().leaving_out(SolidSet::EMPTY.with(0));
/// let nearest = solids::nearest::<_, Stable, 1>(&balls, &ray, &start);
/// assert_eq!(nearest.map(|(ball, hit)| (ball, hit.t)), Some((1, 4.0)));
/// # Ok::<(), raylet::Error>(())
/// ```
pub fn nearest<S: Scalar, T: Tier<S>, const W: usize>(
    solids: &(impl List<S> + ?Sized),
    ray: &Ray<S>,
    start: &Start<W>,
) -> Option<(u32, Hit<S>)> {
    let located = start.located::<S, T, _>(solids.list(), ray);
    let mut nearest: Option<Entry<S>> = None;
    each(solids, ray, start, |solid, shape, own| {
        let shape = shape.shape();
        let hits = start.crossings_of::<S, T, _>(own, solid, shape);
        let first = order::entries::<S, T, _, _>(solid, shape, &hits, &located)
            .find(|entry| shape.visible().sees(entry.hit.crossing));
        if let Some(entry) = first
            && nearest.is_none_or(|best| order::order::<S, T, _>(&entry, &best, &located).is_lt())
        {
            nearest = Some(entry);
        }
        ControlFlow::Continue(())
    });
    nearest.map(|entry| (entry.solid, entry.hit))
}

/// True if a ray whose start is known has a visible crossing in its range, other than the one at which it
/// [arrives](Start::arriving).
///
/// Whether a point that was just seen is hidden from another one:
///
/// ```
/// use raylet::solids::{self, Start};
/// use raylet::{Ray, Shape, Sphere, Stable, UnitVec3, Vec3};
/// let ball = Shape::new(Sphere::new(1.0_f32)?);
/// let eye = Ray::towards(Vec3::new(-5.0, 0.3, 0.1), Vec3::new(0.1, 0.2, 0.3))?;
/// let hit = ball.nearest(&eye).expect("it looks at it");
/// let surface = ball.surface(&eye, &hit);
/// let back = Ray::segment(eye.origin(), surface.point())?;
/// let start = Start::<1>::new().arriving(surface.departure(0, raylet::Leaving::Outwards));
/// assert!(!solids::occludes::<_, Stable, 1>(&[ball], &back, &start));
/// # Ok::<(), raylet::Error>(())
/// ```
pub fn occludes<S: Scalar, T: Tier<S>, const W: usize>(
    solids: &(impl List<S> + ?Sized),
    ray: &Ray<S>,
    start: &Start<W>,
) -> bool {
    let mut is_hit = false;
    each(solids, ray, start, |solid, shape, own| {
        let (shape, arrives) = (shape.shape(), start.arrives_at(solid));
        let end = ray.range().end();
        // The crossing at which it arrives may lie behind the end, by rounding.
        let (hits, _) = match (arrives, Range::from(ray.range().start())) {
            (Some(_), Ok(range)) => start.crossings_of::<S, T, _>(&own.with_range(range), solid, shape),
            _ => start.crossings_of::<S, T, _>(own, solid, shape),
        };
        let (mut before, mut nearest) = (hits.len(), S::INFINITY);
        for (index, hit) in hits.iter().enumerate().filter(|(_, hit)| Some(hit.crossing) == arrives) {
            let from_end = hit.t.minus(end).magnitude();
            if from_end < nearest {
                (before, nearest) = (index, from_end);
            }
        }
        is_hit = hits.iter().take(before).any(|hit| hit.t <= end && shape.visible().sees(hit.crossing));
        if is_hit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    is_hit
}
