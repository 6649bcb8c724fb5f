//! Spheres, capsules and double cones.

use super::form::{Ball, Cone, Line, Tube};
use super::quadratic::Curve;
use super::quadratic::{End, Flat, Fraction, Inside, Interval, Quadratic, times};
use super::settle::{self, Of, inwards, span};
use super::side::slab;
use crate::intersection::{self, Intersection, Span};
use crate::part::Part;
use crate::ray::{Leaving, Range};
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// The ball about the origin.
#[inline(never)]
pub(super) fn ball<S: Scalar, N: Of<S>>(line: &Line<N>, r: N, range: Range<S>) -> Option<Intersection<S>> {
    let departs = line.departure.is_some();
    let quadratic = Quadratic::new(Ball { r }, line, departs)?;
    let Inside::Between(touch) = quadratic.inside()? else {
        // a > 0, so that there is no other case.
        return Some(Intersection::Miss);
    };
    let interval = quadratic.between(touch);
    Some(Intersection::One(if departs {
        inwards(&quadratic, interval.exit, range)?
    } else {
        span(&quadratic, interval, range)?
    }))
}

/// Both nappes of a cone about its apex at the origin.
#[inline(never)]
pub(super) fn double_cone<S: Scalar, N: Of<S>>(line: &Line<N>, slope: N, range: Range<S>) -> Option<Intersection<S>> {
    let leaving = line.departure.map(|(_, leaving)| leaving);
    let quadratic = Quadratic::new(Cone::slope(slope), line, leaving.is_some())?;
    let inside = quadratic.inside()?;
    if let Some(leaving) = leaving {
        return departing_double_cone(&quadratic, inside, leaving, range);
    }
    let ends = || quadratic.ends().map(Some);
    let one = |interval: Interval<N>| Some(Intersection::One(span(&quadratic, interval, range)?));
    match inside {
        Inside::Nowhere => Some(Intersection::Miss),
        Inside::Between(touch) => one(quadratic.between(touch)),
        Inside::Beyond => {
            let [first, second] = ends();
            let first = span(&quadratic, Interval::new(None, first), range)?;
            let second = span(&quadratic, Interval::new(second, None), range)?;
            Some(in_order(first, second))
        }
        Inside::Until => one(Interval::new(None, ends()[0])),
        Inside::From => one(Interval::new(ends()[0], None)),
        Inside::Everywhere | Inside::InSurface => {
            Some(Intersection::LiesIn(span(&Flat, Interval::<N>::EVERYWHERE, range)?))
        }
    }
}

/// Two intervals, of which the second does not begin before the first ends.
fn in_order<S: Scalar>(first: Span<S>, mut second: Span<S>) -> Intersection<S> {
    if second.enter.t < first.exit.t {
        second.enter.t = first.exit.t;
    }
    Intersection::Two(first, second)
}

/// A double cone is not convex: a ray that leaves it outwards may meet the other nappe. One of the roots is the start.
fn departing_double_cone<S: Scalar, N: Of<S>>(
    quadratic: &Quadratic<'_, N, Cone<N>>,
    inside: Inside,
    leaving: Leaving,
    range: Range<S>,
) -> Option<Intersection<S>> {
    let [first, second] = quadratic.ends();
    let is_ahead = |end: &End<N>| Some(settle::compare(quadratic, end, S::ZERO)? == Ordering::Greater);
    let until = |end: Option<End<N>>| inwards(quadratic, end, range);
    let from = |end: End<N>| span(quadratic, Interval::new(Some(end), None), range);
    Some(match (inside, leaving) {
        (Inside::Everywhere | Inside::InSurface, _) => {
            Intersection::LiesIn(span(&Flat, Interval::<N>::EVERYWHERE, range)?)
        }
        (Inside::Between(_), Leaving::Inwards) => Intersection::One(until(Some(second))?),
        // The other root is the entry into the other nappe.
        (Inside::Beyond, Leaving::Outwards) if is_ahead(&second)? => Intersection::One(from(second)?),
        // The interval of a ray that departs inwards but leads away from the nappe ends at its start.
        (Inside::Beyond, Leaving::Inwards) if is_ahead(&second)? => in_order(until(Some(first))?, from(second)?),
        (Inside::Beyond | Inside::From, Leaving::Inwards) => Intersection::One(until(None)?),
        (Inside::Until, Leaving::Inwards) => Intersection::One(until(Some(first))?),
        (Inside::Nowhere, _) | (_, Leaving::Outwards) => Intersection::Miss,
    })
}

/// All points within `r` of the segment from the origin to `(0, height, 0)`.
///
/// The balls at its ends lie in the infinite tube, and a line that is in the tube beyond a ball without hitting the ball does not return to the side.
/// Therefore each end of the interval in the tube corresponds to one end of the interval in the capsule, or the line misses the capsule.
#[inline(never)]
pub(super) fn capsule<S: Scalar, N: Of<S>>(
    line: &Line<N>,
    r: N,
    height: N,
    range: Range<S>,
) -> Option<Intersection<S>> {
    let tube = Quadratic::new(Tube { r }, line, line.departs_from(Part::Side))?;
    let solver = Capsule { line, r, height, tube: &tube, climb: line.direction[1].sign()?, range };
    let interval = match tube.inside()? {
        Inside::Between(touch) => tube.between(touch),
        Inside::Everywhere => Interval::EVERYWHERE,
        // From seam to seam; if the height is zero, at one point.
        Inside::InSurface => {
            let Some(seams) = slab(line, Some(N::ZERO), Some(height))? else {
                return Some(Intersection::Miss);
            };
            let touch = height.sign()? == Ordering::Equal;
            let [enter, exit] = [seams.enter, seams.exit].map(|end| end.map(End::of_side));
            if line.departure.is_some() {
                return Some(Intersection::One(inwards(&Flat, exit, range)?));
            }
            return Some(Intersection::One(span(&Flat, Interval { enter, exit, touch }, range)?));
        }
        _ if line.departure.is_some() => Interval::new(None, Some(End::start(Part::Side))),
        _ => return Some(Intersection::Miss),
    };
    if let Some((part, _)) = line.departure {
        // If it misses the ball at its end by its rounded coordinates, its interval ends at its start.
        let exit = match solver.end(interval.exit, false)? {
            Some((exit, _)) => exit,
            None => settle::exit(&Flat, Some(End::<N>::start(part)), range, intersection::End::none(-S::INFINITY))?,
        };
        return Some(Intersection::One(Span::new(intersection::End::none(-S::INFINITY), exit)));
    }
    let (Some((enter, touches)), Some((exit, _))) =
        (solver.end(interval.enter, true)?, solver.end(interval.exit, false)?)
    else {
        return Some(Intersection::Miss);
    };
    // If the line only touches the ball or the side at its entry, the exit is the same point.
    let touch = (touches || interval.touch) && enter.part == exit.part;
    let exit_t = if touch || exit.t < enter.t { enter.t } else { exit.t };
    Some(Intersection::One(Span { enter, exit: intersection::End { t: exit_t, ..exit }, touch }))
}

/// The quantities from which the ends of a capsule are computed.
struct Capsule<'a, S: Scalar, N> {
    line: &'a Line<N>,
    r: N,
    height: N,
    tube: &'a Quadratic<'a, N, Tube<N>>,
    /// The sign of the direction's y component.
    climb: Ordering,
    range: Range<S>,
}

impl<S: Scalar, N: Of<S>> Capsule<'_, S, N> {
    /// How the height of a root of the tube compares with a seam's.
    fn beside(&self, end: &End<N>, seam: N) -> Option<Ordering> {
        let (y, dy) = (self.line.origin[1], self.line.direction[1]);
        match self.climb {
            Ordering::Equal => (y - seam).sign(),
            climb => {
                let crossing = End::at(Fraction { n: seam - y, e: dy }, Part::Side);
                Some(times(self.tube.order(end, &crossing)?, climb))
            }
        }
    }

    /// The end in the capsule for one end in the infinite tube (`None` if the line is parallel to it), and whether the line only touches the
    /// ball there. It is on the side between the seams (included), and on a ball beyond them. `None` if the line misses that ball.
    fn end(&self, end: Option<End<N>>, entering: bool) -> Option<Option<(intersection::End<S>, bool)>> {
        let part = match end {
            Some(end) => {
                if self.beside(&end, N::ZERO)? == Ordering::Less {
                    Part::Base
                } else if self.beside(&end, self.height)? == Ordering::Greater {
                    Part::Top
                } else {
                    return Some(Some((self.settled(self.tube, end, entering)?, false)));
                }
            }
            None if (self.climb == Ordering::Greater) == entering => Part::Base,
            None => Part::Top,
        };
        let [x, y, z] = self.line.origin;
        let y = if part == Part::Top { y - self.height } else { y };
        let seen = Line { origin: [x, y, z], ..*self.line };
        let ball = Quadratic::new(Ball { r: self.r }, &seen, self.line.departs_from(part))?;
        let Inside::Between(touch) = ball.inside()? else {
            return Some(None);
        };
        let [first, second] = ball.ends();
        let end = End { part, ..if entering { first } else { second } };
        Some(Some((self.settled(&ball, end, entering)?, touch)))
    }

    fn settled(&self, quadratic: &impl Curve<N>, end: End<N>, entering: bool) -> Option<intersection::End<S>> {
        if entering {
            return settle::entry(quadratic, Some(end), self.range);
        }
        if self.line.departure.is_some() {
            return Some(inwards(quadratic, Some(end), self.range)?.exit);
        }
        settle::exit(quadratic, Some(end), self.range, intersection::End::none(-S::INFINITY))
    }
}
