//! The methods of fixed point: the kernels of integers on a common grid.
//!
//! They know only the rays that arrive from outside, and those that depart inwards; they are unsure where their
//! integers have no room.

use super::exactly::InDoubles;
use super::{ExactScalar, In, Method, Tiers, passes, whole};
use crate::geometry::Geometry;
use crate::grid::Guards;
use crate::intersection::{End, Intersection, Span};
use crate::line::Place;
use crate::number::{Bounded, FIXED_LIMBS, Integer, Plain as PlainNumber};
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::{Attempt, GridScalar, LocalLine, RealOf, are_doubtful, found};
use crate::solve::{self, Stop};
use crate::tier::{Fast, Stable};
use core::marker::PhantomData;

/// The tiers of fixed point.
#[derive(Clone, Copy, Debug)]
pub struct FixedPoint;

impl<S: GridScalar> Tiers<S> for FixedPoint
where
    S::Real: RealOf<S>,
{
    type PlainNumber = PlainNumber<S::Real>;
    type Plain = (OnGrid<Fast>, In<PlainNumber<S::Real>>);
    type Fast = (OnGrid<Fast>, In<S::Robust>);
    type Stable = (OnGrid<Stable>, OnWiderGrid, In<S::Robust>);
}

/// On the grid of the type's own width, with these guards.
#[derive(Clone, Copy, Debug)]
pub struct OnGrid<T>(PhantomData<T>);

impl<S: GridScalar, T: Guards> Method<S> for OnGrid<T> {
    #[inline(always)]
    fn nearest<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> solve::Attempt<Intersection<S>> {
        decided(if P::STRETCHES {
            stretched::<S, T, G>(geometry, place, ray)
        } else {
            frequent::<S, T, G, P>(geometry, place, ray, since)
        })
    }
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> solve::Attempt<Intersection<S>> {
        match ray.departure() {
            Some(departure) => decided(inwards::<S, T, G, P>(geometry, place, ray, departure)),
            None => Self::nearest(geometry, place, ray, None),
        }
    }
    #[inline(always)]
    fn ahead<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> solve::Attempt<()> {
        if P::STRETCHES || ray.departure().is_some() {
            return Err(Stop::Unsure);
        }
        decided(is_ahead::<S, T, G, P>(geometry, place, ray))
    }
}

/// On the grid of [`GridScalar::Wider`].
#[derive(Clone, Copy, Debug)]
pub struct OnWiderGrid;

impl<S: GridScalar> Method<S> for OnWiderGrid {
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> solve::Attempt<Intersection<S>> {
        if S::WIDENS { decided(in_wider(geometry, place, ray)) } else { Err(Stop::Unsure) }
    }
}

/// A result of the kernels as one of the solver.
#[inline(always)]
fn decided<A>(attempt: Attempt<A>) -> solve::Attempt<A> {
    match attempt {
        Attempt::Hit(found) => Ok(found),
        Attempt::Miss => Err(Stop::Miss),
        Attempt::Unsure => Err(Stop::Unsure),
    }
}

/// Rays without departure at a solid that is not stretched. If `since` is given, only the first end at or after it is
/// needed.
#[inline(always)]
fn frequent<S: GridScalar, T: Guards, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
    since: Option<S>,
) -> Attempt<Intersection<S>> {
    if passes(geometry, place, ray) {
        return Attempt::Miss;
    }
    let Some(mut line) = geometry.grid_line(place, ray) else { return Attempt::Unsure };
    geometry.fit(&mut line);
    line.is_strict = T::STRICT;
    // Only if the line's `t` is the ray's.
    line.since = since.filter(|_| line.start == S::ZERO);
    in_own_t(&line, on_the_grid::<S, T, G>(geometry, &line))
}

/// The intersection with a line in the frame. The kernels of short formulas are compiled into the query; the others are
/// functions that all placements share.
#[inline(always)]
fn on_the_grid<S: GridScalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    line: &LocalLine<S>,
) -> Attempt<Intersection<S>> {
    if G::HAS_FEW_FACTORS { geometry.meets_on_grid::<T>(line) } else { shared::<S, T, G>(geometry, line) }
}

#[inline(never)]
fn shared<S: GridScalar, T: Guards, G: Geometry<S>>(geometry: &G, line: &LocalLine<S>) -> Attempt<Intersection<S>> {
    geometry.meets_on_grid::<T>(line)
}

/// Occlusion of the half-line `t >= 0`: a function of its own, one for the tiers that share the guards.
#[inline(never)]
fn is_ahead<S: GridScalar, T: Guards, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Attempt<()> {
    if passes(geometry, place, ray) {
        return Attempt::Miss;
    }
    let Some(mut line) = geometry.grid_line(place, ray) else { return Attempt::Unsure };
    geometry.fit(&mut line);
    line.since = (line.start == S::ZERO).then_some(S::ZERO);
    if line.start == S::ZERO && !line.is_coarse {
        return geometry.occludes_on_grid::<T>(&line);
    }
    found!(in_own_t(&line, on_the_grid::<S, T, G>(geometry, &line))).occlusion()
}

/// The guards of the wider grid. Formulas without guards assume directions of length 1; those of a narrower type have
/// it only to their own last bits.
struct Widely;

impl Guards for Widely {
    const GUARDED: bool = true;
}

/// The intersection with an affine placement.
#[inline(never)]
fn stretched<S: GridScalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let Some(line) = place.finer_line(ray, geometry.lengths()) else { return Attempt::Unsure };
    let intersection = found!(on_the_grid::<S, T, G>(&geometry.scaled(line.scale), &line.line));
    intersection.try_map(|t| line.along_ray(t)).map_or(Attempt::Unsure, Attempt::Hit)
}

/// The grid of [`GridScalar::Wider`] has room for all lengths of this type, in finer units. The ends are
/// rounded to this type.
#[cold]
#[inline(never)]
fn in_wider<S: GridScalar, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let Some(geometry) = geometry.in_type::<S::Wider>() else { return Attempt::Unsure };
    let (place, wider) = (place.in_type(), ray.in_type());
    let intersection = match whole(OnGrid::<Widely>::all(&geometry, &place, &wider)) {
        Ok(intersection) => intersection,
        Err(Stop::Miss) => return Attempt::Miss,
        Err(Stop::Unsure) => return Attempt::Unsure,
    };
    // An exit must be ahead of the surface that the ray departs from; for an exit next to that surface rounding would
    // decide this.
    let departs = ray.departure().is_some();
    let narrowed = |t: S::Wider| {
        let t = S::narrowed(t);
        (!departs || t != S::ZERO).then_some(t)
    };
    intersection.try_map(narrowed).map_or(Attempt::Unsure, Attempt::Hit)
}

/// The exit of a ray that departs inwards. It is a function of its own so that the common case stays short.
#[inline(never)]
fn inwards<S: GridScalar, T: Guards, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
    departure: Departure,
) -> Attempt<Intersection<S>> {
    let exit = |geometry: &G, line: &LocalLine<S>| exit_along::<S, T, G>(geometry, line, departure);
    if P::STRETCHES {
        let Some(line) = place.finer_line(ray, geometry.lengths()) else { return Attempt::Unsure };
        let intersection = found!(exit(&geometry.scaled(line.scale), &line.line));
        // An exit must be ahead: for one next to the start rounding would decide this.
        let along = |t| line.along_ray(t).filter(|t| *t > S::ZERO);
        return match intersection {
            Intersection::One(Span { exit: End { t, part }, .. }) => match along(t) {
                Some(t) => Attempt::Hit(Intersection::One(Span::new(End::none(-S::INFINITY), End::new(t, part)))),
                None => Attempt::Unsure,
            },
            _ => Attempt::Unsure,
        };
    }
    let Some(mut line) = geometry.grid_line(place, ray) else { return Attempt::Unsure };
    geometry.fit(&mut line);
    line.is_strict = T::STRICT;
    in_own_t(&line, exit(geometry, &line))
}

/// The intersection of a line that departs inwards. A line that starts on the surface of a solid cannot miss it,
/// whatever its rounded coordinates.
#[inline(always)]
fn exit_along<S: GridScalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    line: &LocalLine<S>,
    departure: Departure,
) -> Attempt<Intersection<S>> {
    if departure.leaving != Leaving::Inwards {
        return Attempt::Unsure;
    }
    match geometry.exit_on_grid::<T>(line, departure.part) {
        Attempt::Hit(exit) if exit.t.plus(line.start) > S::ZERO => {
            Attempt::Hit(Intersection::One(Span::new(End::none(-S::INFINITY), exit)))
        }
        _ => Attempt::Unsure,
    }
}

/// An intersection along a local line, with its `t` converted to the ray's.
#[inline(always)]
fn in_own_t<S: GridScalar>(line: &LocalLine<S>, found: Attempt<Intersection<S>>) -> Attempt<Intersection<S>> {
    if line.is_coarse && !matches!(found, Attempt::Miss) {
        return Attempt::Unsure;
    }
    if line.start == S::ZERO { found } else { from_start(found!(found), line.start, line.is_strict) }
}

/// An intersection along a line whose origin was moved to `start`, with `start` added to its `t`.
#[inline(never)]
fn from_start<S: GridScalar>(intersection: Intersection<S>, start: S, is_strict: bool) -> Attempt<Intersection<S>> {
    let whole = |t: S| {
        let whole = if t.is_finite() { t.plus(start) } else { t };
        // The rounding may have moved it beyond the type.
        (whole.is_finite() || !t.is_finite() || !is_strict).then_some(whole)
    };
    intersection.try_map(whole).map_or(Attempt::Unsure, Attempt::Hit)
}

/// On the grid of the type's own integers by certain signs, and where that is unsure in doubles. Affine placements
/// begin there: their uncertain decisions may pass the guards of integers.
#[derive(Clone, Copy, Debug)]
pub struct OnGridOrInDoubles;

impl<S: ExactScalar + GridScalar> Method<S> for OnGridOrInDoubles {
    #[inline(always)]
    fn nearest<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> solve::Attempt<Intersection<S>> {
        if P::STRETCHES { InDoubles::nearest(geometry, place, ray, since) } else { Self::all(geometry, place, ray) }
    }
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> solve::Attempt<Intersection<S>> {
        if !P::STRETCHES {
            match certainly_on_the_grid(geometry, place, ray) {
                Err(Stop::Unsure) => {}
                found => return found,
            }
        }
        InDoubles::all(geometry, place, ray)
    }
}

impl<F: fixed::types::extra::LeEqU32 + Send + Sync + 'static> ExactScalar for fixed::FixedI32<F> {
    type First = OnGridOrInDoubles;
    type Bounded = Bounded<u128>;
    type Integer = Integer<FIXED_LIMBS>;
    type Order = Integer<{ FIXED_LIMBS / 2 * 5 }>;
}

/// The guards of the grid of `Exact`.
#[derive(Clone, Copy, Debug)]
pub struct Certainly;

impl Guards for Certainly {
    const GUARDED: bool = true;
    const STRICT: bool = true;
}

/// On the grid of the type's own integers, by certain signs.
#[inline(always)]
fn certainly_on_the_grid<S: GridScalar, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> solve::Attempt<Intersection<S>> {
    let intersection = whole(OnGrid::<Certainly>::all(geometry, place, ray))?;
    let (start, end) = (ray.range().start(), ray.range().end());
    // The rounding of `t` must decide neither the order of an end and an end of the range, nor whether an exit is ahead
    // of the surface that the ray departs from. A missing end is infinite. Every range is tested for zero, so that the
    // whole line and the half-line have the same `t`.
    let is_certain = |t: S| {
        let is_doubtful = |bound: S| are_doubtful(t, bound);
        !t.is_finite() || !(is_doubtful(start) || is_doubtful(end) || is_doubtful(S::ZERO))
    };
    intersection.try_map(|t| is_certain(t).then_some(t)).ok_or(Stop::Unsure)
}
