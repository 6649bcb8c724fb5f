//! Which numbers each tier computes in.
//!
//! `Fast` and `Stable` take the result of their fast path, or of its second or third attempt; if all are unsure, the robust number decides.
//! `Exact` repeats the query in the next wider number until every sign is certain: see `exactly`.

mod exactly;

pub(crate) use exactly::precision;

use crate::equations::{Described, EquationKinds, Equations};
use crate::fast::Guards;
use crate::geometry::Geometry;
use crate::intersection::{End, Intersection, Span};
use crate::line::Place;
use crate::query::Solve;
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::{Attempt, FromScalar, LocalLine, Scalar, found};
use crate::solve::{self, Line, Of};
use crate::tier::{Fast, Plain, Stable};
use crate::vector::Vec3;

/// Implements the tiers that decide by the signs of rounded values.
macro_rules! solve_robustly {
    ($Tier:ident) => {
        impl<S: Scalar> Solve<S> for $Tier {
            #[inline(always)]
            fn fast<G: Geometry<S>>(
                geometry: &G,
                place: &impl Place<S>,
                ray: &Ray<S>,
                since: Option<S>,
            ) -> Attempt<Intersection<S>> {
                fast::<S, $Tier, G, _>(geometry, place, ray, since)
            }
            #[inline(always)]
            fn fast_ahead<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Attempt<()> {
                fast_ahead::<S, $Tier, G, _>(geometry, place, ray)
            }
            // Not inlined, so that programs that list hits and search nearest hits have it once.
            #[inline(never)]
            fn climb<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Intersection<S> {
                let found = match rare::<S, $Tier, G>(geometry, place, ray) {
                    Attempt::Unsure => second_attempt::<S, $Tier, G, _>(geometry, place, ray),
                    found => found,
                };
                match found {
                    Attempt::Hit(intersection) => intersection,
                    Attempt::Miss => Intersection::Miss,
                    // The robust number knows every sign, so that there is always a result.
                    Attempt::Unsure => {
                        climb::<S, S::Robust, G>(&geometry.equations(), place, ray).unwrap_or(Intersection::Miss)
                    }
                }
            }
            fn contains<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, point: Vec3<S>) -> bool {
                holds::<S, S::Robust, G>(&geometry.equations(), place, point).unwrap_or(false)
            }
        }
    };
}
// `Plain` has no solver of its own: it answers as `Fast` does.
solve_robustly!(Plain);
solve_robustly!(Fast);
solve_robustly!(Stable);

/// The intersection, computed in numbers of the type `N`; `None` if they do not know a sign.
#[inline]
fn climb<S: Scalar, N: Of<S>, G: Described>(
    equations: &Equations<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Option<Intersection<S>> {
    debug_assert!(G::EQUATIONS.has(equations.kind()));
    let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
    if solve::meets_nothing(equations, departure) {
        return Some(Intersection::Miss);
    }
    solve::intersect::<S, N, G>(equations, &line::<S, N, G>(equations, place, ray), ray.range())
}

/// The ray's line in the primitive's frame.
#[inline]
pub(crate) fn line<S: Scalar, N: FromScalar<S>, G: Described>(
    equations: &Equations<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Line<N> {
    let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
    let [origin, direction] = if is_ball::<S, G>(equations) { place.ball_line::<N>(ray) } else { place.line::<N>(ray) };
    Line { origin, direction, departure }
}

/// The inside test, computed in numbers of the type `N`; `None` if they do not know a sign.
fn holds<S: Scalar, N: Of<S>, G: Described>(
    equations: &Equations<S>,
    place: &impl Place<S>,
    point: Vec3<S>,
) -> Option<bool> {
    debug_assert!(G::EQUATIONS.has(equations.kind()));
    let point = if is_ball::<S, G>(equations) { place.ball_point::<N>(point) } else { place.point::<N>(point) };
    solve::holds::<S, N, G>(equations, point)
}

/// True for a ball; a constant for a geometry that has none.
#[inline(always)]
pub(crate) const fn is_ball<S, G: Described>(equations: &Equations<S>) -> bool {
    G::EQUATIONS.has(EquationKinds::BALL) && matches!(equations, Equations::Ball { .. })
}

/// `Hit` for the most frequent rays, `Miss` for rays that are known to miss, and `Unsure` for the others, whose fast path is in [`rare`].
#[inline(always)]
fn is_frequent<S: Scalar, G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Attempt<()> {
    if let Some(departure) = ray.departure() {
        return if meets_nothing(geometry, departure) { Attempt::Miss } else { Attempt::Unsure };
    }
    if stretches_integers(place) {
        return Attempt::Unsure;
    }
    if geometry.radius_about_axis().is_some_and(|r| place.passes_axis(ray, r)) {
        return Attempt::Miss;
    }
    Attempt::Hit(())
}

/// The intersection by the fast path for the most frequent rays; [`rare`] has that of the others. If `since` is given, only the first end at or after
/// it is needed.
#[inline(always)]
fn fast<S: Scalar, T: Guards, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
    since: Option<S>,
) -> Attempt<Intersection<S>> {
    found!(is_frequent(geometry, place, ray));
    let Some(mut line) = geometry.fast_line(place, ray) else {
        return if P::HAS_FAR_LINES { from_afar::<S, T, G>(geometry, place, ray, since) } else { Attempt::Unsure };
    };
    geometry.fit(&mut line);
    (line.is_strict, line.is_doubled) = (T::STRICT, false);
    // Only if the line's `t` is the ray's, but for its start.
    line.since = since.filter(|_| !P::STRETCHES && (S::RELATIVE || line.start == S::ZERO));
    in_own_t(place, &line, geometry.fast_intersection::<T>(&line))
}

/// The fast path of rays that depart inwards, and in fixed point of all with an affine placement. These are separate functions, so that the compiler
/// knows after [`fast`] which kind of intersection there is.
#[inline(always)]
fn rare<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    if let Some(departure) = ray.departure() {
        return inwards::<S, T, G>(geometry, place, ray, departure);
    }
    if stretches_integers(place) { whole(stretched::<S, T, G>(geometry, place, ray)) } else { Attempt::Unsure }
}

/// The fast path for all rays.
#[inline(always)]
fn fast_or_rare<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    match whole(fast::<S, T, G, _>(geometry, place, ray, None)) {
        Attempt::Unsure => rare::<S, T, G>(geometry, place, ray),
        found => found,
    }
}

/// The intersection, if it is more than an entry.
#[inline(always)]
fn whole<S>(found: Attempt<Intersection<S>>) -> Attempt<Intersection<S>> {
    if let Attempt::Hit(Intersection::Entered(_)) = found { Attempt::Unsure } else { found }
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
    intersection.try_map(|t| S::fast_along_ray(&line, t)).map_or(Attempt::Unsure, Attempt::Hit)
}

/// The intersection by the fast path of a ray that starts far away. It is a function of its own so that the common case stays short.
#[inline(never)]
fn from_afar<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
    since: Option<S>,
) -> Attempt<Intersection<S>> {
    let Some(mut line) = geometry.far_line(place, ray) else { return Attempt::Unsure };
    (line.is_strict, line.is_doubled, line.since) = (T::STRICT, false, since);
    in_own_t(place, &line, geometry.fast_intersection::<T>(&line))
}

/// The guards of the second attempt of fixed point. Formulas without guards assume directions of length 1; those of a narrower type have it only to
/// their own last bits.
struct Widely;

impl Guards for Widely {
    const GUARDED: bool = true;
}

/// The second attempt of fixed point: the fast path of [`Scalar::Wider`]. It has room for all lengths of this type, in finer units. The ends are
/// rounded to this type.
#[cold]
#[inline(never)]
fn in_wider<S: Scalar, G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
    let intersection =
        found!(fast_or_rare::<S::Wider, Widely, _>(&geometry.in_type(), &place.in_type(), &ray.in_type()));
    // An exit must be ahead of the surface that the ray departs from; for an exit next to that surface rounding would decide this.
    let departs = ray.departure().is_some();
    let narrowed = |t: S::Wider| {
        let t = S::narrowed(t);
        (!departs || t != S::ZERO).then_some(t)
    };
    intersection.try_map(narrowed).map_or(Attempt::Unsure, Attempt::Hit)
}

/// The second attempt of fixed point, see [`in_wider`]; the second attempt of floats, along a more accurate line, and their third, along the same
/// line in double-word numbers.
#[inline(always)]
fn second_attempt<S: Scalar, T: Guards, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    if !S::RELATIVE {
        return if S::WIDENS { in_wider(geometry, place, ray) } else { Attempt::Unsure };
    }
    let second = geometry.second_line(place, ray);
    // In world coordinates a line that starts near the primitive is exact without a transformation.
    let exact = || geometry.fast_line(place, ray).filter(|line| !line.is_rounded);
    let is_new = second.is_some();
    let Some(mut line) = second.or_else(exact) else { return Attempt::Unsure };
    // The direction of a stretched line may have any length; the plain formulas for spheres need length 1.
    line.is_doubled = !is_new || P::STRETCHES || ray.departure().is_some();
    loop {
        let along = again::<S, T, G>(geometry, ray, &line);
        let found = whole(in_own_t(place, &line, along));
        if found != Attempt::Unsure {
            return found;
        }
        // Close to the ray's start the rounding error of the sum of a `t` and the line's start would be too large.
        if line.is_doubled || whole(along) != Attempt::Unsure {
            if line.start == S::ZERO {
                return Attempt::Unsure;
            }
            line = S::fast_moved_back(&line);
        }
        line.is_doubled = true;
    }
}

/// The intersection along a line of the second or third attempt: one function for both, which are rare.
#[inline(never)]
fn again<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    ray: &Ray<S>,
    line: &LocalLine<S>,
) -> Attempt<Intersection<S>> {
    match ray.departure() {
        Some(departure) => exit_along::<S, T, G>(geometry, line, departure),
        None => geometry.fast_intersection::<T>(line),
    }
}

/// True if a ray that departs like this cannot meet the geometry again.
#[inline(always)]
fn meets_nothing<S: Scalar, G: Geometry<S>>(geometry: &G, departure: Departure) -> bool {
    solve::meets_nothing(&geometry.equations(), Some((departure.part, departure.leaving)))
}

/// The exit of a ray that departs inwards. It is a function of its own so that the common case stays short.
#[inline(never)]
fn inwards<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
    departure: Departure,
) -> Attempt<Intersection<S>> {
    let exit = |geometry: &G, line: &LocalLine<S>| exit_along::<S, T, G>(geometry, line, departure);
    if stretches_integers(place) {
        let Some(line) = place.finer_line(ray, geometry.lengths()) else { return Attempt::Unsure };
        let intersection = found!(exit(&geometry.scaled(line.scale), &line.line));
        return intersection.try_map(|t| S::fast_along_ray(&line, t)).map_or(Attempt::Unsure, Attempt::Hit);
    }
    let Some(mut line) = geometry.fast_line(place, ray) else { return Attempt::Unsure };
    geometry.fit(&mut line);
    (line.is_strict, line.is_doubled) = (T::STRICT, false);
    in_own_t(place, &line, exit(geometry, &line))
}

/// The intersection of a line that departs inwards. A line that starts on the surface of a solid cannot miss it, whatever its
/// rounded coordinates.
#[inline(always)]
fn exit_along<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    line: &LocalLine<S>,
    departure: Departure,
) -> Attempt<Intersection<S>> {
    if departure.leaving != Leaving::Inwards {
        return Attempt::Unsure;
    }
    match geometry.fast_exit::<T>(line, departure.part) {
        Attempt::Hit(exit) if exit.t.plus(line.start) > S::ZERO => {
            Attempt::Hit(Intersection::One(Span::new(End::none(-S::INFINITY), exit)))
        }
        _ => Attempt::Unsure,
    }
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
        let inverse_length = line.inverse_length.real();
        return Attempt::Hit(found!(found).map(|t| S::round(t.real() * inverse_length)));
    }
    found
}

/// An intersection along a line whose origin was moved to `start`, with `start` added to its `t`; the entry alone if only the exit is inaccurate.
#[inline(never)]
fn from_start<S: Scalar>(intersection: Intersection<S>, start: S, is_strict: bool) -> Attempt<Intersection<S>> {
    let whole = |t: S| {
        if !t.is_finite() {
            return Some(t);
        }
        let whole = t.plus(start);
        // Close to the ray's start the rounding error of a float's sum would be large relative to the result.
        let is_precise = if S::RELATIVE {
            whole.magnitude().plus(whole.magnitude()) >= start.magnitude()
        } else {
            // The rounding may have moved it beyond the type.
            whole.is_finite() || !is_strict
        };
        is_precise.then_some(whole)
    };
    let entered = || intersection.entered()?.try_map(whole);
    intersection.try_map(whole).or_else(entered).map_or(Attempt::Unsure, Attempt::Hit)
}

/// The occlusion test by the fast path.
#[inline(always)]
fn fast_ahead<S: Scalar, T: Guards, G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<()> {
    found!(is_frequent(geometry, place, ray));
    let Some(mut line) = geometry.fast_line(place, ray) else { return Attempt::Unsure };
    geometry.fit(&mut line);
    line.since = (!P::STRETCHES && (S::RELATIVE || line.start == S::ZERO)).then_some(S::ZERO);
    if line.start == S::ZERO && !line.is_coarse {
        return geometry.fast_occlusion::<T>(&line);
    }
    found!(in_own_t(place, &line, geometry.fast_intersection::<T>(&line))).occlusion()
}
