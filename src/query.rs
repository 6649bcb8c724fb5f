//! The queries of any primitive through any placement.

use crate::geometry::Geometry;
use crate::hit::{Crossing, Hit, Hits, Undecided};
use crate::intersection::{End, Intersection};
use crate::line::Place;
use crate::ray::{Range, Ray};
use crate::scalar::{Scalar, largest};
use crate::solve::{self, Attempt, Of, Root, Stop};
use crate::vector::Vec3;
use core::cmp::Ordering;

/// The steps of a query in a tier.
pub trait Solve<S: Scalar> {
    /// True if the ends of a range are compared with exact roots, and not with the rounded `t` of hits.
    const EXACT_ENDS: bool = false;
    /// True if pictures are shaded from the rounded `t` of a hit, without a correction.
    const SHADES_ROUGHLY: bool = false;

    /// The intersection of a ray without departure by the first method of the tier. If `since` is given, only the first
    /// end at or after it is needed.
    fn first<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> Attempt<Intersection<S>>;
    /// The intersection of any ray by the first method.
    fn all_by_first<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>>;
    /// The intersection by the other methods.
    fn others<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Intersection<S>;
    /// True if the point belongs to the geometry.
    fn contains<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, point: Vec3<S>) -> bool;

    /// How two crossings of one line compare, by their exact roots; `None` in a tier that compares their rounded `t`.
    #[inline(always)]
    fn order(_: &impl Crossed<S>, _: &impl Crossed<S>) -> Option<Ordering> {
        None
    }
    /// Occlusion of the half-line `t >= 0`, from the signs of the equations alone.
    #[inline(always)]
    fn ahead<G: Geometry<S>, P: Place<S>>(_: &G, _: &P, _: &Ray<S>) -> Attempt<()> {
        Err(Stop::Unsure)
    }
}

/// A crossing of a surface by a line.
pub trait Crossed<S: Scalar> {
    /// The root of the surface's equation; `None` if the number does not know a sign.
    fn root<N: Of<S>>(&self) -> Option<Root<N>>;
}

/// The kinds of crossings that are reported, entries and exits; a touch always is.
#[derive(Clone, Copy)]
pub(crate) struct Reported {
    pub(crate) enter: bool,
    pub(crate) exit: bool,
}

impl Reported {
    /// All of them.
    pub(crate) const ALL: Self = Self { enter: true, exit: true };

    #[inline(always)]
    const fn has(self, crossing: Crossing) -> bool {
        match crossing {
            Crossing::Enter => self.enter,
            Crossing::Exit => self.exit,
            Crossing::Touch => true,
        }
    }
}

/// All hits. This function and the next are one for each primitive, placement and tier, so that a program has the code
/// of a query once.
#[inline(never)]
pub(crate) fn hits<S: Scalar, T: Solve<S>, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Hits<S> {
    if misses_by_departure(geometry, ray) {
        return Hits::none();
    }
    match T::all_by_first(geometry, place, ray) {
        Err(Stop::Miss) => Hits::none(),
        Err(Stop::Unsure) => others::<S, T, G, P>(geometry, place, ray).hits(ray.range()),
        // The list begins with the nearest hit, which needs only the entry.
        Ok(Intersection::Entered(enter)) => {
            others::<S, T, G, P>(geometry, place, ray).entered_at(enter).hits(ray.range())
        }
        Ok(intersection) => intersection.hits(ray.range()),
    }
}

/// The first hit that is reported.
#[inline(never)]
pub(crate) fn nearest<S: Scalar, T: Solve<S>, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
    reported: Reported,
) -> Option<Hit<S>> {
    let (range, accept) = (ray.range(), |crossing| reported.has(crossing));
    // If the entry is accepted, later ends are not needed.
    let since = reported.enter.then(|| range.start());
    if ray.departure().is_some() {
        if misses_by_departure(geometry, ray) {
            return None;
        }
        return departing::<S, T, G, P>(geometry, place, ray).nearest(range, accept);
    }
    match T::first(geometry, place, ray, since) {
        Err(Stop::Miss) => None,
        Err(Stop::Unsure) => others::<S, T, G, P>(geometry, place, ray).nearest(range, accept),
        // The common case is tested by itself: the compiler then passes the entry on in registers.
        Ok(Intersection::Entered(enter)) if range.contains(enter.t) && reported.enter => {
            Some(Hit { t: enter.t, part: enter.part, crossing: Crossing::Enter })
        }
        // If the range ends before the entry, it holds no exit either.
        Ok(Intersection::Entered(enter)) if enter.t > range.end() => None,
        // The entry stays as it is, so that the hit is one of [`hits`].
        Ok(Intersection::Entered(enter)) => {
            others::<S, T, G, P>(geometry, place, ray).entered_at(enter).nearest(range, accept)
        }
        Ok(intersection) => intersection.nearest(range, accept),
    }
}

/// The first hit that is reported, if the first method of the tier decides it. A program that calls only this has
/// neither the code of the other methods nor that of departing rays.
#[inline(never)]
pub(crate) fn try_nearest<S: Scalar, T: Solve<S>, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
    reported: Reported,
) -> Result<Option<Hit<S>>, Undecided> {
    if ray.departure().is_some() {
        return Err(Undecided);
    }
    by_first::<S, T, G, P>(geometry, place, ray, reported).map_err(|_| Undecided)
}

/// What the first method of a tier leaves to the others.
enum Rest<S> {
    /// The whole intersection.
    All,
    /// All but this entry, which is not the hit.
    Exit(End<S>),
}

/// The first hit that is reported, of a ray without departure, by the first method of the tier: the decisions of
/// [`nearest`]. (If that called this, queries of flat parts would take up to 30 instructions more on a Cortex-M0+. If
/// this did not say what is left, [`try_nearest`] of a framed cylinder would be 900 bytes longer.)
#[inline(always)]
fn by_first<S: Scalar, T: Solve<S>, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
    reported: Reported,
) -> Result<Option<Hit<S>>, Rest<S>> {
    let range = ray.range();
    // If the entry is accepted, later ends are not needed.
    let since = reported.enter.then(|| range.start());
    match T::first(geometry, place, ray, since) {
        Err(Stop::Miss) => Ok(None),
        Err(Stop::Unsure) => Err(Rest::All),
        // The common case is tested by itself: the compiler then passes the entry on in registers.
        Ok(Intersection::Entered(enter)) if range.contains(enter.t) && reported.enter => {
            Ok(Some(Hit { t: enter.t, part: enter.part, crossing: Crossing::Enter }))
        }
        // If the range ends before the entry, it holds no exit either.
        Ok(Intersection::Entered(enter)) if enter.t > range.end() => Ok(None),
        Ok(Intersection::Entered(enter)) => Err(Rest::Exit(enter)),
        Ok(intersection) => Ok(intersection.nearest(range, |crossing| reported.has(crossing))),
    }
}

/// True if there is a hit that is reported.
#[inline(always)]
pub(crate) fn occludes<S: Scalar, T: Solve<S>, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
    reported: Reported,
) -> bool {
    if !S::RELATIVE && ray.range() == Range::FORWARD && reported.enter && reported.exit {
        match T::ahead(geometry, place, ray) {
            Err(Stop::Miss) => return false,
            Ok(()) => return true,
            Err(Stop::Unsure) => {}
        }
    }
    nearest::<S, T, G, P>(geometry, place, ray, reported).is_some()
}

/// True if rule 8 of the contract decides that a ray that departs cannot meet the geometry again.
#[inline(always)]
fn misses_by_departure<S: Scalar, G: Geometry<S>>(geometry: &G, ray: &Ray<S>) -> bool {
    let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
    solve::meets_nothing(&geometry.equations(), departure)
}

/// The intersection of a ray that departs and may meet the geometry again.
#[inline(never)]
fn departing<S: Scalar, T: Solve<S>, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Intersection<S> {
    match T::all_by_first(geometry, place, ray) {
        Ok(Intersection::Entered(_)) | Err(Stop::Unsure) => T::others(geometry, place, ray),
        Ok(intersection) => intersection,
        Err(Stop::Miss) => Intersection::Miss,
    }
}

/// [`Solve::others`], in a function of its own, so that the code of the first method stays small.
#[cold]
#[inline(never)]
fn others<S: Scalar, T: Solve<S>, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Intersection<S> {
    T::others(geometry, place, ray)
}

/// The geometry and a point of its frame, both scaled by a power of two so that the larger of them is near 1 and no
/// square overflows; and the exponent of that power, which is zero for fixed types.
#[inline]
pub(crate) fn near_one<S: Scalar, G: Geometry<S>>(geometry: &G, point: Vec3<S>) -> (G, Vec3<S>, i32) {
    let exponent = S::binary_exponent(largest([point.x, point.y, point.z, geometry.largest_coordinate()]));
    (geometry.scaled(-exponent), scaled(point, -exponent), exponent)
}

/// The point times `2^e`.
#[inline]
pub(crate) fn scaled<S: Scalar>(point: Vec3<S>, e: i32) -> Vec3<S> {
    point.to_array().map(|component| component.scaled(e)).into()
}
