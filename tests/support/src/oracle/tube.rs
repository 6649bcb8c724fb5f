//! A line against what lies between two cylinders about the y axis and between two planes.

use dashu::integer::IBig;

use super::algebraic::Root;
use super::departing::{self, Leaving};
use super::dyadic::Dyadic;
use super::quadric::{IntegerLine, Interval, LateralLine, Overlap};
use super::solids::{Lateral, Line, Part};
use super::solve::{Answer, End, Slab, Span, clip, solid_with_flat_caps};

/// The line, and the pieces of it within both cylinders.
struct Sides {
    line: IntegerLine,
    inner: Overlap,
    outer: Overlap,
    height: IBig,
}

impl Sides {
    fn new([inner, outer, height]: [&Dyadic; 3], line: &Line, from: Option<Part>) -> Self {
        let line = IntegerLine::new(line, &[inner, outer, height]);
        let overlap = |radius: &Dyadic, part: Part| {
            let lateral = Lateral { weight: Dyadic::from(1), offset: radius.clone(), growth: Dyadic::zero() };
            let mut side = LateralLine::new(&line, &lateral);
            if from == Some(part) {
                side.quadratic.c = IBig::ZERO;
            }
            side.one_nappe()
        };
        let (inner, outer) = (overlap(inner, Part::Inner), overlap(outer, Part::Side));
        let height = line.length(height);
        Self { line, inner, outer, height }
    }

    fn slab(&self) -> Slab {
        Slab::new(&self.line, &IBig::ZERO, &self.height)
    }

    /// The ends of the open interval within the inner cylinder, if the line does not only touch that.
    fn gap(&self) -> Option<[Root; 2]> {
        match &self.inner {
            Overlap::Within(Interval { enter: Some(enter), exit: Some(exit) }) if enter != exit => {
                Some([enter.clone(), exit.clone()])
            }
            _ => None,
        }
    }
}

/// The span with the part `Inner` at the roots of the inner cylinder.
fn with_inner(span: Span, roots: &[Root; 2]) -> Span {
    let named = |end: End| if roots.contains(&end.t) && end.part == Part::Side { of_inner(end) } else { end };
    Span { enter: span.enter.map(named), exit: span.exit.map(named) }
}

fn of_inner(end: End) -> End {
    End { part: Part::Inner, ..end }
}

/// Where the line meets the tube of these radii and this height.
pub(super) fn solve(sizes: [&Dyadic; 3], line: &Line) -> Answer {
    let sides = Sides::new(sizes, line, None);
    let (slab, gap) = (sides.slab(), sides.gap());
    let outer = match (sides.outer, sides.inner) {
        (Overlap::Within(_), Overlap::InSurface(inner)) => {
            let of_inner = |span: Span| Span { enter: span.enter.map(of_inner), exit: span.exit.map(of_inner) };
            return match solid_with_flat_caps(Overlap::InSurface(inner), slab) {
                Answer::Spans(spans) => Answer::Spans(spans.into_iter().map(of_inner).collect()),
                answer => answer,
            };
        }
        // Parallel to the axis, in the hole.
        (Overlap::Within(_), Overlap::Within(Interval { enter: None, .. })) => return Answer::Spans(vec![]),
        (Overlap::Within(outer), _) => outer,
        (overlap, _) => return solid_with_flat_caps(overlap, slab),
    };
    let Some(roots) = gap else { return Answer::Spans(clip(outer, slab).into_iter().collect()) };
    let before = Interval { enter: outer.enter, exit: Some(roots[0].clone()) };
    let after = Interval { enter: Some(roots[1].clone()), exit: outer.exit };
    let pieces = [clip(before, slab.clone()), clip(after, slab)];
    Answer::Spans(pieces.into_iter().flatten().map(|span| with_inner(span, &roots)).collect())
}

/// Where a line that departs from the part meets the tube again.
pub(super) fn departing(sizes: [&Dyadic; 3], line: &Line, from: Part, leaving: Leaving) -> Answer {
    if leaving == Leaving::Outwards && from != Part::Inner {
        return Answer::Spans(vec![]);
    }
    let sides = Sides::new(sizes, line, Some(from));
    let cap = departing::last_cap(&sides.line, [Some(&IBig::ZERO), Some(&sides.height)], from);
    let along = match (&sides.outer, &sides.inner) {
        (Overlap::InSurface(_), _) => Some(Part::Side),
        (_, Overlap::InSurface(_)) => Some(Part::Inner),
        _ => None,
    };
    if let Some(part) = along {
        return match leaving {
            Leaving::Outwards => Answer::Spans(vec![]),
            Leaving::Inwards => departing::inwards(cap.map(|end| End { part, ..end })),
        };
    }
    let own = match &sides.outer {
        Overlap::Within(interval) => interval.exit.clone().map(|t| End { t, part: Part::Side }),
        Overlap::Nothing if sides.line.direction[0].is_zero() && sides.line.direction[2].is_zero() => None,
        // By its coordinates it is outside: it leaves where it starts, and does not enter again.
        _ if leaving == Leaving::Outwards => return Answer::Spans(vec![]),
        _ => return departing::inwards(Some(departing::start(Part::Side))),
    };
    let last = departing::first(own, cap.clone());
    let Some(roots) = sides.gap().filter(|[_, exit]| exit.signum() > 0) else {
        return match leaving {
            Leaving::Outwards => Answer::Spans(vec![]),
            Leaving::Inwards => departing::inwards(last),
        };
    };
    // The start is between the planes, whatever its coordinates, and the plane that it departs from is met there.
    let slab = match sides.slab() {
        Slab::Between { enter, exit } => {
            let met = |end: End| if end.part == from { departing::start(from) } else { end };
            Slab::Between { enter: departing::start(enter.part), exit: met(exit) }
        }
        _ => Slab::Everywhere,
    };
    let again = clip(Interval::from(roots[1].clone()), slab).map(|span| {
        let span = with_inner(span, &roots);
        if span.is_touch() { span } else { Span { exit: last, ..span } }
    });
    if leaving == Leaving::Outwards {
        return Answer::Spans(again.into_iter().collect());
    }
    let inner = Some(End { t: roots[0].clone(), part: Part::Inner });
    match departing::inwards(departing::first(inner, cap)) {
        Answer::Spans(first) => Answer::Spans(first.into_iter().chain(again).collect()),
        answer => answer,
    }
}
