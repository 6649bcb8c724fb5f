//! Tubes: what lies between two cylinders about the y axis, and between two planes.
//!
//! The inner cylinder cuts an open interval out of that which the outer one and the planes have in common. It lies
//! inside of the outer one, so that the roots of the two are in order along every line: only roots and planes are
//! compared.

use super::attempt::{Attempt, Stop, known};
use super::end::{self, Curve, End, Fraction, Goal, Interval, Of, and_again, between, inwards, settled, solid, span};
use super::local_ray::LocalRay;
use super::quadratic::{Inside, Quadratic};
use super::quadric::Cylinder;
use super::side::{choose, clip, in_the_whole_side, slab};
use crate::intersection::{self, Intersection, Span};
use crate::number::Number;
use crate::part::Part;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// The side of a tube along a line, outside or inside.
type Side<N> = Quadratic<N, Cylinder<N>>;

/// Both sides: an end with the part `Inner` is a root of the inner one.
struct Sides<N> {
    inner: Side<N>,
    outer: Side<N>,
}

impl<N: Number> Curve<N> for Sides<N> {
    fn order_by_signs(&self, end: &End<N>, t: Fraction<N>) -> Option<Ordering> {
        let side = if end.part == Part::Inner { &self.inner } else { &self.outer };
        side.order_by_signs(end, t)
    }
}

/// The tube between these radii.
#[inline(always)]
pub(crate) fn tube<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    [inner, outer]: [S; 2],
    height: S,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let side = |radius: S, part: Part| {
        let cylinder = Cylinder::along(line.origin, line.direction, N::scalar(radius));
        Quadratic::new(cylinder, line, line.departs_from(part))
    };
    let outer = side(outer, Part::Side)?;
    let planes = slab(line, Some(N::ZERO), Some(N::scalar(height)))?;
    if let Inside::InSurface = outer.inside {
        return in_the_whole_side(line, &outer, planes, true, goal);
    }
    if line.departs() {
        let sides = Sides { inner: side(inner, Part::Inner)?, outer };
        // It departs from a point between the planes, although its rounded coordinates may be outside.
        let exit = planes.map_or_else(End::never_left, |planes| planes.exit);
        return departing(line, &sides, &Interval::new(End::never_entered(), exit), goal);
    }
    let Some(planes) = planes else { return Err(Stop::Miss) };
    let whole = clip(&outer, &outer.interval()?, &planes)?;
    if whole.touch {
        return solid(&outer, line, &whole, goal);
    }
    let enter = settled(&outer, line, &whole.enter, goal.range)?;
    // A line that enters by the outer side is in the wall first, whatever the inner side does.
    let is_in_the_wall = whole.enter.part == Part::Side;
    if is_in_the_wall && goal.since.is_some_and(|since| enter.t >= since) {
        return Ok(Intersection::Entered(enter));
    }
    match side(inner, Part::Inner) {
        Ok(inner) => less_the_inside(line, &Sides { inner, outer }, &planes, (&whole, enter), goal),
        Err(Stop::Miss) => between(&outer, line, enter, || Ok(whole.exit), goal),
        Err(Stop::Unsure) if is_in_the_wall => entered::<S, N>(enter),
        Err(Stop::Unsure) => Err(Stop::Unsure),
    }
}

/// The entry alone, if it is known.
fn entered<S: Scalar, N: Of<S>>(enter: intersection::End<S>) -> Attempt<Intersection<S>> {
    if enter.t.is_finite() && !N::IS_WIDE { Ok(Intersection::Entered(enter)) } else { Err(Stop::Unsure) }
}

/// The part of `whole`, the interval inside of the outer side and the planes, that is outside of the inner side.
/// `enter` is where it begins.
#[inline(never)]
fn less_the_inside<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    sides: &Sides<N>,
    planes: &Interval<N>,
    (whole, enter): (&Interval<N>, intersection::End<S>),
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    match sides.inner.inside {
        Inside::Between(false) => {}
        Inside::Everywhere => return Err(Stop::Miss),
        Inside::InSurface => return in_the_inner_side(line, &sides.inner, Some(*planes), goal),
        _ => return between(sides, line, enter, || Ok(whole.exit), goal),
    }
    let first = match before(sides, planes, whole.enter) {
        Err(Stop::Unsure) if whole.enter.part == Part::Side => return entered::<S, N>(enter),
        Err(Stop::Unsure) => return Err(Stop::Unsure),
        Err(Stop::Miss) => return solid(sides, line, &after(sides, planes, whole.exit)?, goal),
        Ok(first) => first,
    };
    if first.touch {
        // It touches the inner rim, and may enter after that.
        let rim = Intersection::One(span(sides, line, &first, goal.range)?);
        return and_again(sides, line, rim, &after(sides, planes, whole.exit), goal.range);
    }
    if goal.since.is_some_and(|since| enter.t >= since) {
        return Ok(Intersection::Entered(enter));
    }
    // Also if only the second interval is needed: so that both are known by the same number.
    let found = settled(sides, line, &first.exit, goal.range).and_then(|exit| {
        let first = Intersection::One(Span::joined(enter, exit, false));
        and_again(sides, line, first, &after(sides, planes, whole.exit), goal.range)
    });
    if let Err(Stop::Unsure) = found { entered::<S, N>(enter) } else { found }
}

/// From the entry to the inner side. There is such an interval if the line enters by the outer side; if it enters by a
/// plane, there is one only if it crosses that outside of the inner side.
fn before<N: Number>(Sides { inner, .. }: &Sides<N>, planes: &Interval<N>, enter: End<N>) -> Attempt<Interval<N>> {
    if enter.part == Part::Side {
        let exit = choose(inner, inner.ends()[0], planes.exit, Ordering::Greater)?;
        return Ok(Interval::new(enter, of_the_inner_side(exit)));
    }
    let Interval { enter: rim, exit, touch } = clip(inner, &inner.until_first(), planes)?;
    let enter = if touch { of_the_inner_side(rim) } else { enter };
    Ok(Interval { enter, exit: of_the_inner_side(exit), touch })
}

/// From the inner side to the exit, alike.
fn after<N: Number>(Sides { inner, .. }: &Sides<N>, planes: &Interval<N>, exit: End<N>) -> Attempt<Interval<N>> {
    if exit.part == Part::Side {
        let enter = choose(inner, inner.ends()[1], planes.enter, Ordering::Less)?;
        return Ok(Interval::new(of_the_inner_side(enter), exit));
    }
    let Interval { enter, exit: rim, touch } = clip(inner, &inner.since_second(), planes)?;
    let exit = if touch { of_the_inner_side(rim) } else { exit };
    Ok(Interval { enter: of_the_inner_side(enter), exit, touch })
}

/// The end with the part `Inner`, if it is a root of a side.
fn of_the_inner_side<N: Number>(end: End<N>) -> End<N> {
    if end.part == Part::Side { End { part: Part::Inner, ..end } } else { end }
}

/// A line that lies in the inner side.
#[cold]
#[inline(never)]
fn in_the_inner_side<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    side: &Side<N>,
    planes: Option<Interval<N>>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    Ok(in_the_whole_side(line, side, planes, true, goal)?.with_part(Part::Inner))
}

/// A ray that departs from the tube.
#[inline(never)]
fn departing<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    sides: &Sides<N>,
    planes: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let Sides { inner, outer } = sides;
    if let Inside::InSurface = inner.inside {
        return in_the_inner_side(line, inner, Some(*planes), goal);
    }
    let exit = match outer.inside {
        Inside::Between(_) => outer.ends()[1],
        // By its rounded coordinates it is outside of the outer side. If it is parallel to the axis, it leaves by a
        // plane; any other line leaves where it starts, and does not enter again.
        Inside::Nowhere if outer.a_sign != Ordering::Equal => {
            return if line.leads_outwards() {
                Err(Stop::Miss)
            } else {
                inwards(outer, line, &End::start(Part::Side), goal.range)
            };
        }
        _ => End::never_left(),
    };
    let last = choose(outer, exit, planes.exit, Ordering::Greater)?;
    let is_cut = match inner.inside {
        Inside::Between(false) => known(end::compare(inner, line, &inner.ends()[1], S::ZERO))? == Ordering::Greater,
        _ => false,
    };
    let again = if is_cut { after(sides, planes, last) } else { Err(Stop::Miss) };
    if line.leads_outwards() {
        return Ok(Intersection::One(span(sides, line, &again?, goal.range)?));
    }
    if !is_cut {
        return inwards(sides, line, &last, goal.range);
    }
    let [first, _] = inner.ends();
    let first = choose(inner, first, planes.exit, Ordering::Greater)?;
    let first = inwards(sides, line, &of_the_inner_side(first), goal.range)?;
    and_again(sides, line, first, &again, goal.range)
}
