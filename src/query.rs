//! The queries of any primitive through any placement.

use crate::geometry::Geometry;
use crate::hit::{Crossing, Hit, Hits};
use crate::intersection::Intersection;
use crate::line::Place;
use crate::ray::{Range, Ray};
use crate::scalar::{Attempt, Scalar, largest};
use crate::vector::Vec3;

/// The steps of a query in a tier.
pub trait Solve<S: Scalar> {
    /// True if the ends of a range are compared with exact roots, and not with the rounded `t` of hits.
    const EXACT_ENDS: bool = false;
    /// False if the fast path gives no entry without its exit.
    const GIVES_ENTRIES: bool = true;

    /// The intersection by the fast path. If `since` is given, only the first end at or after it is needed: see
    /// [`LocalLine::since`](crate::scalar::LocalLine).
    fn fast<G: Geometry<S>>(
        geometry: &G,
        place: &impl Place<S>,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> Attempt<Intersection<S>>;
    /// Occlusion of the half-line `t >= 0` by the fast path; agrees with [`Solve::fast`].
    fn fast_ahead<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Attempt<()>;
    /// The intersection by the solver, in wider numbers.
    fn climb<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Intersection<S>;
    /// True if the point belongs to the geometry.
    fn contains<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, point: Vec3<S>) -> bool;

    /// All hits.
    #[inline]
    fn hits<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Hits<S> {
        let whole = || Self::climb(geometry, place, ray);
        match Self::fast(geometry, place, ray, None) {
            Attempt::Miss => Hits::none(),
            Attempt::Unsure => apart(|| whole().hits(ray.range())),
            // The list begins with the nearest hit, for which the fast path needs only the entry.
            Attempt::Hit(Intersection::Entered(enter)) if Self::GIVES_ENTRIES => {
                apart(|| whole().entered_at(enter).hits(ray.range()))
            }
            Attempt::Hit(intersection) => intersection.hits(ray.range()),
        }
    }

    /// The first hit that `accept` accepts. `short` is the same geometry, possibly in another type, in which the fast path is computed.
    #[inline]
    fn nearest<F: Geometry<S>, G: Geometry<S>>(
        short: &F,
        geometry: &G,
        place: &impl Place<S>,
        ray: &Ray<S>,
        accept: impl Fn(Crossing) -> bool,
    ) -> Option<Hit<S>> {
        // If the entry is accepted, later ends are not needed.
        let since = accept(Crossing::Enter).then(|| ray.range().start());
        let (range, whole) = (ray.range(), || Self::climb(geometry, place, ray));
        match Self::fast(short, place, ray, since) {
            Attempt::Miss => None,
            Attempt::Unsure => apart(|| whole().nearest(range, accept)),
            Attempt::Hit(Intersection::Entered(enter))
                if Self::GIVES_ENTRIES && !(range.contains(enter.t) && accept(Crossing::Enter)) =>
            {
                // If the range ends before the entry, it holds no exit either. The entry stays as it is, so that the hit is one of [`Solve::hits`].
                apart(|| if enter.t > range.end() { None } else { whole().entered_at(enter).nearest(range, accept) })
            }
            Attempt::Hit(intersection) => intersection.nearest(range, accept),
        }
    }

    /// True if there is a hit that `accept` accepts. `short` is that of [`Solve::nearest`].
    #[inline]
    fn occludes<F: Geometry<S>, G: Geometry<S>>(
        short: &F,
        geometry: &G,
        place: &impl Place<S>,
        ray: &Ray<S>,
        accept: impl Fn(Crossing) -> bool,
    ) -> bool {
        if ray.range() == Range::FORWARD && accept(Crossing::Enter) && accept(Crossing::Exit) {
            match Self::fast_ahead(short, place, ray) {
                Attempt::Miss => return false,
                Attempt::Hit(()) => return true,
                Attempt::Unsure => {}
            }
        }
        apart(|| Self::nearest(geometry, geometry, place, ray, accept).is_some())
    }
}

/// In a separate function, so that the code of the fast path stays small.
#[cold]
#[inline(never)]
fn apart<A>(work: impl FnOnce() -> A) -> A {
    work()
}

/// The geometry and a point of its frame, both scaled by a power of two so that the larger of them is near 1 and no square overflows; and
/// the exponent of that power, which is zero for fixed types.
#[inline]
pub(crate) fn near_one<S: Scalar, G: Geometry<S>>(geometry: &G, point: Vec3<S>) -> (G, Vec3<S>, i32) {
    let exponent = S::binary_exponent(largest([point.x, point.y, point.z, geometry.bounding_radius()]));
    (geometry.scaled(-exponent), scaled(point, -exponent), exponent)
}

/// The point times `2^e`.
#[inline]
pub(crate) fn scaled<S: Scalar>(point: Vec3<S>, e: i32) -> Vec3<S> {
    point.to_array().map(|component| component.scaled(e)).into()
}
