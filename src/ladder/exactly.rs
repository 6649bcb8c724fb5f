//! The numbers of the tier `Exact`.
//!
//! Fixed point begins with the fast path in its own integers, with guards that only certain results pass. Floats begin with the fast path in doubles,
//! which is the second step of fixed point. Rays that these cannot decide are computed in wider and wider numbers, until every sign is certain.

use super::{climb, fast_or_rare, holds};
use crate::equations::{Described, Equations};
use crate::exact::{Exact, ExactScalar, Precision};
use crate::fast::Guards;
use crate::geometry::Geometry;
use crate::intersection::Intersection;
use crate::line::Place;
use crate::query::Solve;
use crate::ray::Ray;
use crate::scalar::{Attempt, Scalar, found};
use crate::vector::Vec3;

/// Implements the tier that decides by certain signs. (For each of its types separately: a generic implementation would overlap.)
macro_rules! solve_exactly {
    ($S:ty $(, $F:ident: $Bits:path)?) => {
        impl$(<$F: $Bits + Send + Sync + 'static>)? Solve<$S> for Exact {
            const EXACT_ENDS: bool = true;
            const GIVES_ENTRIES: bool = false;

            #[inline(always)]
            fn fast<G: Geometry<$S>>(
                geometry: &G,
                place: &impl Place<$S>,
                ray: &Ray<$S>,
                _: Option<$S>,
            ) -> Attempt<Intersection<$S>> {
                if starts_in_doubles(place) {
                    fast_in_doubles(geometry, place, ray)
                } else {
                    fast_in_integers(geometry, place, ray)
                }
            }
            #[inline(always)]
            fn fast_ahead<G: Geometry<$S>>(_: &G, _: &impl Place<$S>, _: &Ray<$S>) -> Attempt<()> {
                Attempt::Unsure
            }
            #[inline]
            fn climb<G: Geometry<$S>>(geometry: &G, place: &impl Place<$S>, ray: &Ray<$S>) -> Intersection<$S> {
                if !starts_in_doubles(place) {
                    match fast_in_doubles(geometry, place, ray) {
                        Attempt::Hit(intersection) => return intersection,
                        Attempt::Miss => return Intersection::Miss,
                        Attempt::Unsure => {}
                    }
                }
                let (intersection, _) = exactly::<$S, G>(&geometry.equations(), place, ray);
                intersection
            }
            fn contains<G: Geometry<$S>>(geometry: &G, place: &impl Place<$S>, point: Vec3<$S>) -> bool {
                let equations = geometry.equations();
                holds::<$S, <$S as ExactScalar>::Filter, G>(&equations, place, point)
                    .or_else(|| holds::<$S, <$S as ExactScalar>::Bounded, G>(&equations, place, point))
                    .or_else(|| holds::<$S, <$S as ExactScalar>::Integer, G>(&equations, place, point))
                    .unwrap_or(false)
            }
        }
    };
}
solve_exactly!(f32);
#[cfg(feature = "fixed")]
solve_exactly!(fixed::FixedI32<F>, F: fixed::types::extra::LeEqU32);

/// The precision that an exact result needs.
pub(crate) fn precision<S: ExactScalar, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Precision {
    let in_integers = if starts_in_doubles(place) { Attempt::Unsure } else { fast_in_integers(geometry, place, ray) };
    match (in_integers, fast_in_doubles(geometry, place, ray)) {
        (Attempt::Unsure, Attempt::Unsure) => exactly::<S, G>(&geometry.equations(), place, ray).1,
        _ => Precision::Filter,
    }
}

/// True if the fast path of `Exact` computes in doubles, and not in the type's own integers: for floats, and for affine placements, for which
/// uncertain decisions may pass the guards of integers.
#[inline(always)]
const fn starts_in_doubles<S: Scalar, P: Place<S>>(_: &P) -> bool {
    S::RELATIVE || P::STRETCHES
}

/// The guards of the fast path of `Exact`.
struct Certainly;

impl Guards for Certainly {
    const GUARDED: bool = true;
    const STRICT: bool = true;
}

/// The fast path of `Exact`: that of doubles. Its guards assume 40 correct bits of 53, so that their decisions are certain.
#[inline(always)]
fn fast_in_doubles<S: ExactScalar, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let intersection = found!(fast_or_rare::<f64, Certainly, _>(&geometry.in_type(), &place.in_type(), &ray.in_type()));
    let (start, end) = (ray.range().start().to_f64(), ray.range().end().to_f64());
    // The exact value of an end decides whether it lies in the range. An end before or beyond the range is made infinite.
    let settled = |t: f64| {
        if is_close(t, start) || is_close(t, end) {
            return None;
        }
        let beyond = if t < start { -S::INFINITY } else { S::INFINITY };
        Some(if t < start || t > end { beyond } else { S::from_f64(t).unwrap_or(beyond) })
    };
    match intersection.try_map(settled) {
        Some(intersection) => Attempt::Hit(intersection),
        None => Attempt::Unsure,
    }
}

/// The fast path of `Exact` in fixed point.
#[inline(always)]
fn fast_in_integers<S: Scalar, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let intersection = found!(fast_or_rare::<S, Certainly, G>(geometry, place, ray));
    let (start, end) = (ray.range().start(), ray.range().end());
    // The rounding of `t` must decide neither the order of an end and an end of the range, nor whether an exit is ahead of the surface that the ray
    // departs from. A missing end is infinite.
    let is_certain = |t: S| {
        let is_doubtful = |bound: S| S::are_doubtful(t, bound);
        !t.is_finite()
            || !(is_doubtful(start) || is_doubtful(end) || (ray.departure().is_some() && is_doubtful(S::ZERO)))
    };
    match intersection.try_map(|t| is_certain(t).then_some(t)) {
        Some(intersection) => Attempt::Hit(intersection),
        None => Attempt::Unsure,
    }
}

/// True if the rounding of `t` may decide on which side of a bound it lies.
#[inline(always)]
fn is_close(t: f64, bound: f64) -> bool {
    const PART: f64 = 1.0 / (1u32 << 30) as f64;
    // A missing end is infinite, for which the comparison is false.
    (t - bound).abs() <= t.abs() * PART && t.is_finite()
}

/// The intersection where the fast path is unsure, and the precision that was needed.
#[inline(never)]
fn exactly<S: ExactScalar, G: Described>(
    equations: &Equations<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> (Intersection<S>, Precision) {
    if let Some(intersection) = climb::<S, S::Filter, G>(equations, place, ray) {
        return (intersection, Precision::Filter);
    }
    match climb::<S, S::Bounded, G>(equations, place, ray) {
        Some(intersection) => (intersection, Precision::Filter),
        None => (in_integers::<S, G>(equations, place, ray), Precision::Integers),
    }
}

#[cold]
#[inline(never)]
fn in_integers<S: ExactScalar, G: Described>(
    equations: &Equations<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Intersection<S> {
    // Integers know every sign, so that there is always a result.
    let intersection = climb::<S, S::Integer, G>(equations, place, ray);
    debug_assert!(intersection.is_some());
    intersection.unwrap_or(Intersection::Miss)
}
