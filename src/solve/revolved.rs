//! Quadrics of revolution between two planes.
//!
//! The planes select the sheet of a hyperboloid and the nappes of a cone. A line may enter a solid with a waist twice.

use super::attempt::{Attempt, Stop, known};
use super::end::{self, End, Goal, Interval, Of, and_again, inwards, settled, solid, span};
use super::local_ray::LocalRay;
use super::quadratic::{Inside, Quadratic};
use super::quadric::Revolution;
use super::side::{self, choose, clip, in_the_whole_side, is_on_the_side, slab};
use crate::intersection::{self, Intersection, Span};
use crate::outline::Meridian;
use crate::part::Part;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// A quadric of revolution along a line.
type Side<N> = Quadratic<N, Revolution<N>>;

/// The solid between the planes, or its side alone.
#[inline(always)]
pub(crate) fn revolved<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    meridian: &Meridian<S>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let quadric = Revolution::along(line.origin, line.direction, meridian, N::scalar);
    let side = Quadratic::new(quadric, line, line.departs_from(Part::Side))?;
    // A paraboloid or a spheroid that ends at the origin has no cap there, and goes no farther: rounding could take the
    // side for one.
    let has_apex = meridian.r == S::ZERO && meridian.a <= S::ZERO && !line.departs();
    let plane = |height: S| (!has_apex || height != S::ZERO).then(|| N::scalar(height));
    let [low, high] = meridian.heights.map(plane);
    let planes = slab(line, low, high)?;
    if let Inside::InSurface = side.inside {
        // A ruling of a hyperboloid, or a line along a cone or a cylinder.
        return in_the_whole_side(line, &side, planes, !meridian.is_open, goal);
    }
    let planes = match planes {
        Some(planes) => planes,
        // It departs from a point between the planes, although its rounded coordinates may be outside.
        None if line.departs() => Interval::everywhere(),
        None => return Err(Stop::Miss),
    };
    match (line.departs(), meridian.is_open) {
        (false, false) => inside(line, &side, &planes, goal),
        (false, true) => on_the_side(line, &side, &planes, goal),
        (true, false) => departing(line, &side, &planes, goal),
        (true, true) => departing_from_the_side(line, &side, &planes, goal),
    }
}

/// The intersection with the solid.
#[inline(always)]
fn inside<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    side: &Side<N>,
    planes: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if let Inside::Beyond = side.inside {
        return in_two(line, side, planes, goal);
    }
    solid(side, line, &clip(side, &side.interval()?, planes)?, goal)
}

/// A line that is inside up to the first root and from the second on, as far as the planes reach.
#[inline(never)]
fn in_two<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    side: &Side<N>,
    planes: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let pieces = [clip(side, &side.until_first(), planes), clip(side, &side.since_second(), planes)];
    match &pieces {
        [Err(Stop::Unsure), _] | [_, Err(Stop::Unsure)] => Err(Stop::Unsure),
        [Err(Stop::Miss), Err(Stop::Miss)] => Err(Stop::Miss),
        [Ok(only), Err(Stop::Miss)] | [Err(Stop::Miss), Ok(only)] => solid(side, line, only, goal),
        [Ok(first), Ok(second)] => {
            let first = span(side, line, first, goal.range)?;
            if goal.since.is_some_and(|since| first.exit.t < since) {
                return solid(side, line, second, goal);
            }
            Ok(Intersection::in_order(first, span(side, line, second, goal.range)?))
        }
    }
}

/// The crossings of the side alone.
#[inline(never)]
fn on_the_side<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    side: &Side<N>,
    planes: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if !matches!(side.inside, Inside::Beyond) {
        return side::on_the_side(line, side, &side.interval()?, planes, goal);
    }
    let [exit, enter] = side.ends().map(|end| {
        let is_met = is_on_the_side(side, &end, planes)?;
        is_met.then(|| settled(side, line, &end, goal.range)).transpose()
    });
    let (before, after) = (intersection::End::none(-S::INFINITY), intersection::End::none(S::INFINITY));
    match (exit?, enter?) {
        (None, None) => Err(Stop::Miss),
        (Some(exit), None) => Ok(Intersection::Surface(Span::new(before, exit))),
        (None, Some(enter)) => Ok(Intersection::Surface(Span::new(enter, after))),
        // The missing ends are exchanged, so that no point lies inside: it is a surface.
        (Some(exit), Some(enter)) => {
            let enter = if enter.t < exit.t { intersection::End { t: exit.t, ..enter } } else { enter };
            Ok(Intersection::Two(Span::new(after, exit), Span::new(enter, before)))
        }
    }
}

/// A ray that departs from the solid.
#[inline(never)]
fn departing<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    side: &Side<N>,
    planes: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    // The exit of the interval in which an inwards ray starts, and whether the line enters again.
    let (exit, enters_again) = match side.inside {
        // By its rounded coordinates it is outside of the side. If it is parallel to the axis, it leaves by a plane;
        // any other line leaves where it starts.
        Inside::Nowhere if side.a_sign == Ordering::Equal => (End::never_left(), false),
        Inside::Nowhere => (End::start(Part::Side), false),
        Inside::Everywhere | Inside::InSurface | Inside::From => (End::never_left(), false),
        Inside::Between(_) => (side.ends()[1], false),
        Inside::Until => (side.ends()[0], false),
        Inside::Beyond => {
            let [first, second] = side.ends();
            if is_ahead(line, side, &second)? { (first, true) } else { (End::never_left(), false) }
        }
    };
    let again = if enters_again { clip(side, &side.since_second(), planes) } else { Err(Stop::Miss) };
    if line.leads_outwards() {
        return Ok(Intersection::One(span(side, line, &again?, goal.range)?));
    }
    let first = inwards(side, line, &choose(side, exit, planes.exit, Ordering::Greater)?, goal.range)?;
    and_again(side, line, first, &again, goal.range)
}

/// A ray that departs from the side alone: it may hit the side once more, and the start itself is no hit.
#[inline(never)]
fn departing_from_the_side<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    side: &Side<N>,
    planes: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let enters = match side.inside {
        Inside::Between(_) if !line.leads_outwards() => false,
        Inside::Beyond => true,
        _ => return Err(Stop::Miss),
    };
    let [_, end] = side.ends();
    if !(is_ahead(line, side, &end)? && is_on_the_side(side, &end, planes)?) {
        return Err(Stop::Miss);
    }
    let end = settled(side, line, &end, goal.range)?;
    Ok(Intersection::Surface(if enters {
        Span::new(end, intersection::End::none(S::INFINITY))
    } else {
        Span::new(intersection::End::none(-S::INFINITY), end)
    }))
}

/// True if an end is after the start of the ray.
fn is_ahead<S: Scalar, N: Of<S>>(line: &LocalRay<N>, side: &Side<N>, end: &End<N>) -> Attempt<bool> {
    Ok(known(end::compare(side, line, end, S::ZERO))? == Ordering::Greater)
}
