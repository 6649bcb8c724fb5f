//! Which numbers each tier computes in.
//!
//! `Fast` and `Stable` accept the result of their fast path, or of its second attempt; if both are unsure, the robust number decides.
//! `Exact` repeats the query in the next wider number until every sign is certain. Fixed point begins with the fast path in its own integers, with
//! guards that let nothing uncertain pass; then come doubles.

use crate::exact::{Certain, Effort, Exact};
use crate::fast::Guards;
use crate::figure::{Described, Figure, Figures};
use crate::geometry::Geometry;
use crate::intersection::{End, Intersection, Span};
use crate::line::Place;
use crate::query::Solve;
use crate::ray::{Departure, Leaving, Range, Ray};
use crate::scalar::{Attempt, FromScalar, LocalLine, Scalar, found};
use crate::solve::{self, Line, Of};
use crate::tier::{Fast, Stable};
use crate::vector::Vec3;

/// Implements the tiers that decide by the signs of rounded values.
macro_rules! solve_robustly {
    ($Tier:ident) => {
        impl<S: Scalar> Solve<S> for $Tier {
            #[inline(always)]
            fn fast<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Attempt<Intersection<S>> {
                fast::<S, $Tier, G>(geometry, place, ray)
            }
            #[inline(always)]
            fn fast_ahead<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Attempt<()> {
                fast_ahead::<S, $Tier, G>(geometry, place, ray)
            }
            #[inline]
            fn climb<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Intersection<S> {
                match second_attempt::<S, $Tier, G>(geometry, place, ray) {
                    Attempt::Found(intersection) => intersection,
                    Attempt::Miss => Intersection::Miss,
                    // The robust number knows every sign, so that there is always a result.
                    Attempt::Unsure => {
                        climb::<S, S::Robust, G>(&geometry.figure(), place, ray).unwrap_or(Intersection::Miss)
                    }
                }
            }
            fn contains<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, point: Vec3<S>) -> bool {
                holds::<S, S::Robust, G>(&geometry.figure(), place, point).unwrap_or(false)
            }
        }
    };
}
solve_robustly!(Fast);
solve_robustly!(Stable);

/// Implements the tier that decides by certain signs. (For each of its types separately: a generic implementation would overlap.)
macro_rules! solve_exactly {
    ($S:ty $(, $F:ident: $Bits:path)?) => {
        impl$(<$F: $Bits + Send + Sync + 'static>)? Solve<$S> for Exact {
            #[inline(always)]
            fn fast<G: Geometry<$S>>(
                geometry: &G,
                place: &impl Place<$S>,
                ray: &Ray<$S>,
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
                        Attempt::Found(intersection) => return intersection,
                        Attempt::Miss => return Intersection::Miss,
                        Attempt::Unsure => {}
                    }
                }
                let (intersection, _) = exactly::<$S, G>(&geometry.figure(), place, ray);
                intersection
            }
            fn contains<G: Geometry<$S>>(geometry: &G, place: &impl Place<$S>, point: Vec3<$S>) -> bool {
                let figure = geometry.figure();
                holds::<$S, <$S as Certain>::Filter, G>(&figure, place, point)
                    .or_else(|| holds::<$S, <$S as Certain>::Bounded, G>(&figure, place, point))
                    .or_else(|| holds::<$S, <$S as Certain>::Integer, G>(&figure, place, point))
                    .unwrap_or(false)
            }
        }
    };
}
solve_exactly!(f32);
#[cfg(feature = "fixed")]
solve_exactly!(fixed::FixedI32<F>, F: fixed::types::extra::LeEqU32);

/// The precision that an exact result needs.
pub(crate) fn effort<S: Certain, G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Effort {
    let in_integers = if starts_in_doubles(place) { Attempt::Unsure } else { fast_in_integers(geometry, place, ray) };
    match (in_integers, fast_in_doubles(geometry, place, ray)) {
        (Attempt::Unsure, Attempt::Unsure) => exactly::<S, G>(&geometry.figure(), place, ray).1,
        _ => Effort::Filter,
    }
}

/// True if the fast path of `Exact` computes in doubles, and not in the type's own integers: for floats, and through an affine placement, for which
/// the guards of integers let uncertain decisions pass.
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

/// The fast path of `Exact`: that of doubles. Its guards assume 40 correct bits of 53, so that what they decide is certain.
#[inline(always)]
fn fast_in_doubles<S: Certain, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let intersection =
        found!(fast::<f64, Certainly, _>(&geometry.in_doubles(), &place.in_doubles(), &ray.in_doubles()));
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
        Some(intersection) => Attempt::Found(intersection),
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
    let intersection = found!(fast::<S, Certainly, G>(geometry, place, ray));
    let (start, end) = (ray.range().start(), ray.range().end());
    // The order of an end and the range's, which the rounding of `t` must not decide; nor whether an exit is ahead of the surface that the ray
    // departs from. A missing end is infinite.
    let is_certain = |t: S| {
        let is_doubtful = |bound: S| S::are_doubtful(t, bound);
        !t.is_finite()
            || !(is_doubtful(start) || is_doubtful(end) || (ray.departure().is_some() && is_doubtful(S::ZERO)))
    };
    match intersection.try_map(|t| is_certain(t).then_some(t)) {
        Some(intersection) => Attempt::Found(intersection),
        None => Attempt::Unsure,
    }
}

/// True if the rounding of `t` may decide on which side of a bound it lies.
#[inline(always)]
fn is_close(t: f64, bound: f64) -> bool {
    const PART: f64 = 1.0 / (1u32 << 30) as f64;
    // A missing end is infinite, and compares false.
    (t - bound).abs() <= t.abs() * PART && t.is_finite()
}

/// The intersection where the fast path is unsure, and the precision that was needed.
#[inline(never)]
fn exactly<S: Certain, G: Described>(
    figure: &Figure<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> (Intersection<S>, Effort) {
    if let Some(intersection) = climb::<S, S::Filter, G>(figure, place, ray) {
        return (intersection, Effort::Filter);
    }
    match climb::<S, S::Bounded, G>(figure, place, ray) {
        Some(intersection) => (intersection, Effort::Filter),
        None => (in_integers::<S, G>(figure, place, ray), Effort::Integers),
    }
}

#[cold]
#[inline(never)]
fn in_integers<S: Certain, G: Described>(figure: &Figure<S>, place: &impl Place<S>, ray: &Ray<S>) -> Intersection<S> {
    // Integers know every sign, so that there is always a result.
    let intersection = climb::<S, S::Integer, G>(figure, place, ray);
    debug_assert!(intersection.is_some());
    intersection.unwrap_or(Intersection::Miss)
}

/// The intersection, computed in numbers of the type `N`; `None` if they do not know a sign.
#[inline]
fn climb<S: Scalar, N: Of<S>, G: Described>(
    figure: &Figure<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Option<Intersection<S>> {
    debug_assert!(G::FIGURES.has(figure.figures()));
    let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
    if solve::meets_nothing(figure, departure) {
        return Some(Intersection::Miss);
    }
    solve::intersect::<S, N, G>(figure, &line::<S, N, G>(figure, place, ray), ray.range())
}

/// The ray's line in the primitive's frame.
#[inline]
pub(crate) fn line<S: Scalar, N: FromScalar<S>, G: Described>(
    figure: &Figure<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Line<N> {
    let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
    let [origin, direction] = if is_ball::<S, G>(figure) { place.ball_line::<N>(ray) } else { place.line::<N>(ray) };
    Line { origin, direction, departure }
}

/// The inside test, computed in numbers of the type `N`; `None` if they do not know a sign.
fn holds<S: Scalar, N: Of<S>, G: Described>(figure: &Figure<S>, place: &impl Place<S>, point: Vec3<S>) -> Option<bool> {
    debug_assert!(G::FIGURES.has(figure.figures()));
    let point = if is_ball::<S, G>(figure) { place.ball_point::<N>(point) } else { place.point::<N>(point) };
    solve::holds::<S, N, G>(figure, point)
}

/// True for a ball; a constant for a geometry that has none.
#[inline(always)]
pub(crate) const fn is_ball<S, G: Described>(figure: &Figure<S>) -> bool {
    G::FIGURES.has(Figures::BALL) && matches!(figure, Figure::Ball { .. })
}

/// The intersection by the fast path.
#[inline(always)]
fn fast<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    if let Some(departure) = ray.departure() {
        if meets_nothing(geometry, departure) {
            return Attempt::Miss;
        }
        return inwards::<S, T, G>(geometry, place, ray, departure);
    }
    if stretches_integers(place) {
        return stretched::<S, T, G>(geometry, place, ray);
    }
    let Some(mut line) = geometry.fast_line(place, ray) else { return from_afar::<S, T, G>(geometry, place, ray) };
    geometry.fit(&mut line);
    line.is_strict = T::STRICT;
    in_own_t(place, &line, geometry.fast_intersection::<T>(&line))
}

/// True for fixed point with an affine placement.
#[inline(always)]
const fn stretches_integers<S: Scalar, P: Place<S>>(_: &P) -> bool {
    P::STRETCHES && !S::RELATIVE
}

/// The intersection by the fast path in fixed point with an affine placement.
#[inline(never)]
fn stretched<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let Some(line) = place.finer_line(ray, geometry.lengths()) else { return Attempt::Unsure };
    let intersection = found!(geometry.scaled(line.scale).fast_intersection::<T>(&line.line));
    intersection.try_map(|t| S::fast_along_ray(&line, t)).map_or(Attempt::Unsure, Attempt::Found)
}

/// The same for a ray that starts far away. It is a function of its own so that the common case stays short.
#[inline(never)]
fn from_afar<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let Some(mut line) = geometry.far_line(place, ray) else { return Attempt::Unsure };
    line.is_strict = T::STRICT;
    in_own_t(place, &line, geometry.fast_intersection::<T>(&line))
}

/// The second attempt of floats, along a line that costs more and is rounded less.
#[inline(always)]
fn second_attempt<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    if !S::RELATIVE || ray.departure().is_some() {
        return Attempt::Unsure;
    }
    let Some(line) = geometry.second_line(place, ray) else { return Attempt::Unsure };
    in_own_t(place, &line, geometry.fast_intersection::<T>(&line))
}

/// True if a ray that departs like this cannot meet the geometry again.
#[inline(always)]
fn meets_nothing<S: Scalar, G: Geometry<S>>(geometry: &G, departure: Departure) -> bool {
    solve::meets_nothing(&geometry.figure(), Some((departure.part, departure.leaving)))
}

/// The exit of a ray that departs inwards. It is a function of its own so that the common case stays short.
#[inline(never)]
fn inwards<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
    departure: Departure,
) -> Attempt<Intersection<S>> {
    if departure.leaving != Leaving::Inwards {
        return Attempt::Unsure;
    }
    // A line that starts on the surface of a solid cannot miss it, whatever its rounded coordinates.
    let exit = |geometry: &G, line: &LocalLine<S>| match geometry.fast_exit::<T>(line, departure.part) {
        Attempt::Found(exit) if exit.t.plus(line.start) > S::ZERO => {
            Attempt::Found(Intersection::One(Span::new(End::none(-S::INFINITY), exit)))
        }
        _ => Attempt::Unsure,
    };
    if stretches_integers(place) {
        let Some(line) = place.finer_line(ray, geometry.lengths()) else { return Attempt::Unsure };
        let intersection = found!(exit(&geometry.scaled(line.scale), &line.line));
        return intersection.try_map(|t| S::fast_along_ray(&line, t)).map_or(Attempt::Unsure, Attempt::Found);
    }
    let Some(mut line) = geometry.fast_line(place, ray) else { return Attempt::Unsure };
    geometry.fit(&mut line);
    line.is_strict = T::STRICT;
    in_own_t(place, &line, exit(geometry, &line))
}

/// An intersection along a local line, with its `t` converted to the ray's.
#[inline(always)]
fn in_own_t<S: Scalar, P: Place<S>>(
    _: &P,
    line: &LocalLine<S>,
    found: Attempt<Intersection<S>>,
) -> Attempt<Intersection<S>> {
    if line.is_coarse && !matches!(found, Attempt::Miss) {
        return Attempt::Unsure;
    }
    if !P::STRETCHES && line.start == S::ZERO {
        return found;
    }
    let found = if line.start == S::ZERO { found } else { from_start(found!(found), line.start, line.is_strict) };
    if P::STRETCHES {
        let pace = line.pace.real();
        return Attempt::Found(found!(found).map(|t| S::round(t.real() * pace)));
    }
    found
}

/// An intersection along a line whose origin was moved to `start`, with `start` added to its `t`.
#[inline(never)]
fn from_start<S: Scalar>(intersection: Intersection<S>, start: S, is_strict: bool) -> Attempt<Intersection<S>> {
    let whole = |t: S| {
        if !t.is_finite() {
            return Some(t);
        }
        let whole = t.plus(start);
        // Next to the ray's own start the rounding of a float's sum would be large relative to the result.
        let is_precise = if S::RELATIVE {
            whole.magnitude().plus(whole.magnitude()) >= start.magnitude()
        } else {
            // Beyond the type by its rounding, perhaps.
            whole.is_finite() || !is_strict
        };
        is_precise.then_some(whole)
    };
    intersection.try_map(whole).map_or(Attempt::Unsure, Attempt::Found)
}

/// The occlusion test by the fast path.
#[inline(always)]
fn fast_ahead<S: Scalar, T: Guards, G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Attempt<()> {
    let intersection = if let Some(departure) = ray.departure() {
        if meets_nothing(geometry, departure) {
            return Attempt::Miss;
        }
        found!(inwards::<S, T, G>(geometry, place, ray, departure))
    } else if stretches_integers(place) {
        found!(stretched::<S, T, G>(geometry, place, ray))
    } else {
        let Some(mut line) = geometry.fast_line(place, ray) else { return Attempt::Unsure };
        geometry.fit(&mut line);
        if line.start == S::ZERO && !line.is_coarse {
            return geometry.fast_occlusion::<T>(&line);
        }
        found!(in_own_t(place, &line, geometry.fast_intersection::<T>(&line)))
    };
    if intersection.nearest(Range::FORWARD, |_| true).is_some() { Attempt::Found(()) } else { Attempt::Miss }
}
