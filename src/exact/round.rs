//! The round figures: balls, capsules, and what lies within a side and between planes, decided by signs.

use super::form::{Form, Homogeneous, Line, Weight};
use super::found::Found;
use super::solve::{End, Fraction, Inside, Interval, Of, Piece, Place, Quadratic, Settled, piece, settle, times};
use crate::figure::{Extent, Side};
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::certain::{Certain, Number};
use core::cmp::Ordering;

#[inline(always)]
fn between<N: Number>(quadratic: &Quadratic<'_, N>, touch: bool) -> Interval<N> {
    let [first, second] = quadratic.ends();
    Interval { enter: Some(first), exit: Some(second), touch }
}

/// The ball about the origin.
pub(super) fn ball<S: Certain, N: Of<S>>(line: &Line<N>, r: N, range: Range<S>) -> Option<Found<S>> {
    let quadratic = Quadratic::new(Form::Ball { r }, line)?;
    Some(match quadratic.inside()? {
        Inside::Between(touch) => Found::One(piece(Some(&quadratic), between(&quadratic, touch), range)?),
        // a > 0: no other case.
        _ => Found::Miss,
    })
}

/// Both nappes of a cone about its apex at the origin.
pub(super) fn double_cone<S: Certain, N: Of<S>>(line: &Line<N>, slope: N, range: Range<S>) -> Option<Found<S>> {
    let quadratic = Quadratic::new(Form::slope(slope), line)?;
    let ends = || quadratic.ends().map(Some);
    let one = |interval: Interval<N>| Some(Found::One(piece(Some(&quadratic), interval, range)?));
    match quadratic.inside()? {
        Inside::Nowhere => Some(Found::Miss),
        Inside::Between(touch) => one(between(&quadratic, touch)),
        Inside::Beyond => {
            let [first, second] = ends();
            let [until, from] = [Interval::new(None, first), Interval::new(second, None)];
            let first = piece(Some(&quadratic), until, range)?;
            let mut second = piece(Some(&quadratic), from, range)?;
            second.enter = second.enter.map(|enter| enter.not_before(first.exit));
            Some(Found::Two(first, second))
        }
        Inside::Until => one(Interval::new(None, ends()[0])),
        Inside::From => one(Interval::new(ends()[0], None)),
        Inside::Everywhere | Inside::InSurface => Some(Found::LiesIn(piece(None, Interval::<N>::EVERYWHERE, range)?)),
    }
}

/// What is left of the line, or of an interval.
enum Cut<N: Number> {
    Nothing,
    Piece(Interval<N>),
}

/// The piece of the line with `low <= y <= high`; its ends bear the parts of the two planes.
#[inline(always)]
fn slab<N: Number>(line: &Line<N>, low: Option<N>, high: Option<N>) -> Option<Cut<N>> {
    let (y, dy) = (line.origin[1], line.direction[1]);
    let end = |bound: Option<N>, part: Part| bound.map(|bound| End::at(Fraction { n: bound - y, e: dy }, part));
    let base = || end(low, Part::Base);
    let top = || end(high, Part::Top);
    Some(match dy.sign()? {
        Ordering::Greater => Cut::Piece(Interval::new(base(), top())),
        Ordering::Less => Cut::Piece(Interval::new(top(), base())),
        Ordering::Equal => {
            let is_below = match low {
                Some(low) => (y - low).sign()? == Ordering::Less,
                None => false,
            };
            let is_above = match high {
                Some(high) => (y - high).sign()? == Ordering::Greater,
                None => false,
            };
            if is_below || is_above { Cut::Nothing } else { Cut::Piece(Interval::EVERYWHERE) }
        }
    })
}

/// The line inside a side: in an interval, or along it.
enum Within<N: Number> {
    Nowhere,
    In(Interval<N>),
    /// All of the interval is on the side.
    Along(Interval<N>),
}

/// Where the line is inside a side. Of a cone only the nappe counts in which the outline is positive.
#[inline(always)]
fn within<N: Number>(quadratic: &Quadratic<'_, N>, side: Form<N>, line: &Line<N>) -> Option<Within<N>> {
    let is_cone = matches!(side, Form::Cone { .. });
    let g = side.outline(Homogeneous { v: line.origin, w: Weight::One });
    let slope = side.outline(Homogeneous { v: line.direction, w: Weight::Zero });
    let from = |end: End<N>| Within::In(Interval::new(Some(end), None));
    let until = |end: End<N>| Within::In(Interval::new(None, Some(end)));
    Some(match quadratic.inside()? {
        Inside::Nowhere => Within::Nowhere,
        Inside::Between(touch) => {
            // The outline at the vertex t = -k/a, which lies between the roots, has the sign of the nappe.
            let lower = is_cone && (g * quadratic.a - slope * quadratic.k).sign()? == Ordering::Less;
            if lower { Within::Nowhere } else { Within::In(between(quadratic, touch)) }
        }
        // Steeper than the side: one half-line in each nappe; the outline grows with t if it rises.
        Inside::Beyond if slope.sign()? == Ordering::Greater => from(quadratic.ends()[1]),
        Inside::Beyond => until(quadratic.ends()[0]),
        // Parallel to a generator: one half-line, in the nappe into which it leads.
        Inside::From if slope.sign()? == Ordering::Greater => from(quadratic.ends()[0]),
        Inside::Until if slope.sign()? == Ordering::Less => until(quadratic.ends()[0]),
        Inside::From | Inside::Until => Within::Nowhere,
        Inside::Everywhere => Within::In(Interval::EVERYWHERE),
        Inside::InSurface => {
            let apex = || Some(End::at(Fraction { n: -g, e: slope }, Part::Side));
            Within::Along(match slope.sign()? {
                Ordering::Equal => Interval::EVERYWHERE,
                Ordering::Greater => Interval::new(apex(), None),
                Ordering::Less => Interval::new(None, apex()),
            })
        }
    })
}

/// The side's interval between the planes (rule 1 of the contract: one interval). Where the side and a plane end it at
/// the same point, that is a rim, which the side owns (rule 5).
#[inline(always)]
fn clip<N: Number>(quadratic: &Quadratic<'_, N>, side: Interval<N>, caps: Interval<N>) -> Option<Cut<N>> {
    let choose = |own: Option<End<N>>, cap: Option<End<N>>, cap_counts: Ordering| {
        Some(match (own, cap) {
            (None, end) | (end, None) => end,
            (Some(own), Some(cap)) if quadratic.order(&own, &cap)? == cap_counts => Some(cap),
            (own, _) => own,
        })
    };
    let enter = choose(side.enter, caps.enter, Ordering::Less)?;
    let exit = choose(side.exit, caps.exit, Ordering::Greater)?;
    let (Some(first), Some(last)) = (enter, exit) else {
        return Some(Cut::Piece(Interval { enter, exit, touch: side.touch }));
    };
    let lengths = match (first.place, last.place) {
        (_, Place::At(_)) => quadratic.order(&first, &last)?,
        (Place::At(_), _) => quadratic.order(&last, &first)?.reverse(),
        // The roots are in order.
        _ => Ordering::Less,
    };
    Some(match lengths {
        Ordering::Greater => Cut::Nothing,
        Ordering::Less => Cut::Piece(Interval { enter, exit, touch: side.touch }),
        Ordering::Equal => {
            Cut::Piece(Interval { enter: Some(first.of_side()), exit: Some(last.of_side()), touch: true })
        }
    })
}

/// What lies within a side, or the side alone.
pub(super) fn round<S: Certain, N: Of<S>>(
    line: &Line<N>,
    side: Side<S>,
    extent: Extent<S>,
    range: Range<S>,
) -> Option<Found<S>> {
    let form = form_of(side);
    let (low, high) = match extent {
        Extent::Infinite => (None, None),
        Extent::Open(height) => (Some(N::ZERO), Some(N::scalar(height))),
        Extent::Capped(low, high) => (low.map(N::scalar), high.map(N::scalar)),
    };
    let Cut::Piece(caps) = slab(line, low, high)? else {
        return Some(Found::Miss);
    };
    let quadratic = Quadratic::new(form, line)?;
    let within = within(&quadratic, form, line)?;
    let is_closed = matches!(extent, Extent::Capped(..));
    match within {
        Within::Nowhere => Some(Found::Miss),
        Within::Along(interval) => {
            let Cut::Piece(interval) = clip(&quadratic, interval, caps)? else {
                return Some(Found::Miss);
            };
            // Its ends lie on rims, which are the side's.
            let [enter, exit] = [interval.enter, interval.exit].map(|end| end.map(End::of_side));
            let interval = Interval { enter, exit, ..interval };
            let piece = piece(Some(&quadratic), interval, range)?;
            Some(if is_closed { Found::One(piece) } else { Found::LiesIn(piece) })
        }
        Within::In(interval) if matches!(extent, Extent::Open(_)) => {
            let on_surface = |end: Option<End<N>>| {
                let Some(end) = end else { return Some(None) };
                let reaches = |cap: Option<End<N>>, beyond: Ordering| match cap {
                    Some(cap) => Some(quadratic.order(&end, &cap)? != beyond),
                    None => Some(true),
                };
                let reached = reaches(caps.enter, Ordering::Less)? && reaches(caps.exit, Ordering::Greater)?;
                Some(reached.then_some(end))
            };
            let (enter, exit) = (on_surface(interval.enter)?, on_surface(interval.exit)?);
            let interval = Interval { enter, exit, touch: interval.touch };
            Some(Found::Surface(piece(Some(&quadratic), interval, range)?))
        }
        Within::In(interval) => match clip(&quadratic, interval, caps)? {
            Cut::Piece(interval) => Some(Found::One(piece(Some(&quadratic), interval, range)?)),
            Cut::Nothing => Some(Found::Miss),
        },
    }
}

/// The side's quadric.
pub(super) fn form_of<S: Certain, N: Of<S>>(side: Side<S>) -> Form<N> {
    match side {
        Side::Straight(radius) => Form::Tube { r: N::scalar(radius) },
        Side::Slope(slope) => Form::slope(N::scalar(slope)),
        Side::Radii(base, top, height) => Form::radii(N::scalar(base), N::scalar(top), N::scalar(height)),
    }
}

/// All points within `r` of the segment from the origin to `(0, height, 0)`.
///
/// The balls at its ends lie in the infinite tube, and where a line runs in the tube beyond a ball without meeting it,
/// it does not come back to the side: each end of the tube has one true end, or there is none at all.
pub(super) fn capsule<S: Certain, N: Of<S>>(line: &Line<N>, r: N, height: N, range: Range<S>) -> Option<Found<S>> {
    let tube = Quadratic::new(Form::Tube { r }, line)?;
    let (y, dy) = (line.origin[1], line.direction[1]);
    let interval = match tube.inside()? {
        Inside::Between(touch) => between(&tube, touch),
        Inside::Everywhere => Interval::EVERYWHERE,
        // From seam to seam, where the balls touch the line; without a side they touch it at one point.
        Inside::InSurface => {
            let Cut::Piece(seams) = slab(line, Some(N::ZERO), Some(height))? else {
                return Some(Found::Miss);
            };
            let touch = height.sign()? == Ordering::Equal;
            let [enter, exit] = [seams.enter, seams.exit].map(|end| end.map(End::of_side));
            let interval = Interval { enter, exit, touch };
            return Some(Found::One(piece(None, interval, range)?));
        }
        _ => return Some(Found::Miss),
    };
    let climb = dy.sign()?;
    // How the height of a root of the tube compares with a seam's.
    let beside = |end: &End<N>, seam: N| match climb {
        Ordering::Equal => (y - seam).sign(),
        _ => Some(times(tube.order(end, &End::at(Fraction { n: seam - y, e: dy }, Part::Side))?, climb)),
    };
    let end = |end: Option<End<N>>, entering: bool| -> Option<Option<(Settled<S>, bool)>> {
        let part = match end {
            Some(end) => {
                if beside(&end, N::ZERO)? == Ordering::Less {
                    Part::Base
                } else if beside(&end, height)? == Ordering::Greater {
                    Part::Top
                } else {
                    return Some(Some((settle(Some(&tube), end, range)?, interval.touch)));
                }
            }
            None if (climb == Ordering::Greater) == entering => Part::Base,
            None => Part::Top,
        };
        let [x, _, z] = line.origin;
        let seen = Line { origin: [x, if part == Part::Top { y - height } else { y }, z], ..*line };
        let ball = Quadratic::new(Form::Ball { r }, &seen)?;
        let Inside::Between(touch) = ball.inside()? else {
            return Some(None);
        };
        let [first, second] = ball.ends();
        let end = End { part, ..if entering { first } else { second } };
        Some(Some((settle(Some(&ball), end, range)?, touch)))
    };
    let Some((enter, touches)) = end(interval.enter, true)? else {
        return Some(Found::Miss);
    };
    let Some((exit, _)) = end(interval.exit, false)? else {
        return Some(Found::Miss);
    };
    // Where the ball or the side that is entered is touched, the exit is the same point.
    let exit = exit.not_before(Some(enter));
    Some(Found::One(Piece { enter: Some(enter), exit: Some(exit), touch: touches && enter.part == exit.part }))
}
