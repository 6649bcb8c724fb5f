//! A line against a quadric of revolution between two planes.

use dashu::integer::IBig;

use super::departing::{self, Leaving};
use super::dyadic::{Dyadic, shifted, sign_of};
use super::quadric::{EVERYWHERE, IntegerLine, Interval, Overlap, Quadratic};
use super::solids::{Line, Part, Revolved};
use super::solve::{Answer, End, Slab, clip, open_side, solid_with_flat_caps};

/// What the line has in common with the set `f <= 0`, which need not be convex.
enum Pieces {
    Intervals(Vec<Interval>),
    InSurface,
}

/// The quadric along a line, and the line.
struct Side {
    line: IntegerLine,
    quadratic: Quadratic,
    heights: [IBig; 2],
}

impl Side {
    fn new(solid: &Revolved, line: &Line) -> Self {
        let line = IntegerLine::new(line, &[&solid.b, &solid.r, &solid.low, &solid.high]);
        // f is multiplied by a power of two that makes `a` an integer.
        let e = solid.a.exponent;
        let (a, one) = (shifted(&solid.a.mantissa, e.max(0)), shifted(&IBig::ONE, (-e).max(0)));
        let [b, r] = [&solid.b, &solid.r].map(|length| line.length(length));
        let ([x, y, z], [dx, dy, dz]) = (&line.origin, &line.direction);
        let quadratic = Quadratic {
            a: &one * (dx * dx + dz * dz) - &a * dy * dy,
            k: &one * (x * dx + z * dz - &b * dy) - &a * y * dy,
            c: &one * (x * x + z * z - ((&b * y) << 1) - &r * &r) - a * y * y,
        };
        let heights = [&solid.low, &solid.high].map(|height| line.length(height));
        Self { line, quadratic, heights }
    }

    fn roots(&self) -> Option<(super::Root, super::Root)> {
        self.quadratic.roots(self.line.exponent)
    }

    fn pieces(&self) -> Pieces {
        let Quadratic { a, k, c } = &self.quadratic;
        let single_root = || super::Root::quotient(-c, k << 1, self.line.exponent);
        Pieces::Intervals(match (sign_of(a), sign_of(k), sign_of(c)) {
            (1, ..) => self.roots().map(|(enter, exit)| Interval::between(enter, exit)).into_iter().collect(),
            (-1, ..) => match self.roots() {
                Some((lower, upper)) => vec![Interval::until(lower), Interval::from(upper)],
                None => vec![EVERYWHERE],
            },
            (_, -1, _) => vec![Interval::from(single_root())],
            (_, 1, _) => vec![Interval::until(single_root())],
            (.., -1) => vec![EVERYWHERE],
            (.., 0) => return Pieces::InSurface,
            _ => vec![],
        })
    }

    fn slab(&self) -> Slab {
        let [low, high] = &self.heights;
        Slab::new(&self.line, low, high)
    }
}

/// Where the line meets the solid or its side.
pub(super) fn solve(solid: &Revolved, line: &Line) -> Answer {
    let side = Side::new(solid, line);
    let of = |overlap| {
        if solid.capped { solid_with_flat_caps(overlap, side.slab()) } else { open_side(overlap, side.slab()) }
    };
    let pieces = match side.pieces() {
        Pieces::InSurface => return of(Overlap::InSurface(EVERYWHERE)),
        Pieces::Intervals(intervals) => intervals.into_iter().map(|interval| of(Overlap::Within(interval))),
    };
    let empty = if solid.capped { Answer::Spans(vec![]) } else { Answer::Crossings(vec![]) };
    pieces.fold(empty, |all, piece| match (all, piece) {
        (Answer::Spans(all), Answer::Spans(more)) => Answer::Spans([all, more].concat()),
        (Answer::Crossings(all), Answer::Crossings(more)) => Answer::Crossings([all, more].concat()),
        (all, _) => all,
    })
}

/// Where a line that departs from the part meets it again.
pub(super) fn departing(solid: &Revolved, line: &Line, from: Part, leaving: Leaving) -> Answer {
    let mut side = Side::new(solid, line);
    let from_side = from == Part::Side;
    if from_side {
        side.quadratic.c = IBig::ZERO;
    }
    let nothing = if solid.capped { Answer::Spans(vec![]) } else { Answer::Crossings(vec![]) };
    if leaving == Leaving::Outwards && !(from_side && solid.has_waist()) {
        return nothing;
    }
    let (q, [low, high]) = (&side.quadratic, &side.heights);
    let on_side = |t| End { t, part: Part::Side };
    // Where the line enters a second time: ahead, and after the interval in which it starts.
    let roots = if q.a.is_zero() { None } else { side.roots() };
    let ahead = roots.clone().map(|(_, upper)| upper).filter(|upper| upper.signum() > 0);
    let again = ahead.clone().filter(|_| sign_of(&q.a) < 0);
    if !solid.capped {
        let crossing = match (sign_of(&q.a), leaving) {
            (-1, _) => again.map(Interval::from),
            (1, Leaving::Inwards) => ahead.map(Interval::until),
            _ => None,
        };
        return crossing.map_or(nothing, |interval| open_side(Overlap::Within(interval), side.slab()));
    }
    // The plane that it departs from is met at the start.
    let slab = match side.slab() {
        Slab::Between { enter, exit } => {
            let met = |end: End| if end.part == from { departing::start(from) } else { end };
            Slab::Between { enter: met(enter), exit: met(exit) }
        }
        _ => Slab::Everywhere,
    };
    let second = again.clone().and_then(|enter| clip(Interval::from(enter), slab));
    if leaving == Leaving::Outwards {
        return Answer::Spans(second.into_iter().collect());
    }
    let cap = departing::last_cap(&side.line, [Some(low), Some(high)], from);
    let own = match (side.pieces(), again) {
        (Pieces::InSurface, _) => return departing::inwards(cap.map(|end| on_side(end.t))),
        (_, Some(_)) => roots.map(|(lower, _)| on_side(lower)),
        (Pieces::Intervals(pieces), None) => match pieces.as_slice() {
            [] if q.a.is_zero() => None,
            [] => Some(departing::start(Part::Side)),
            [.., last] => last.exit.clone().map(on_side),
        },
    };
    match departing::inwards(departing::first(own, cap)) {
        Answer::Spans(first) => Answer::Spans(first.into_iter().chain(second).collect()),
        answer => answer,
    }
}

/// Whether a point of the height and the square of the distance from the axis is within: positive inside.
pub fn margin(solid: &Revolved, y: &Dyadic, from_axis: &Dyadic) -> Dyadic {
    let growth = &(&solid.a * y) + &solid.b.scaled(1);
    &(&(&growth * y) + &solid.r.squared()) - from_axis
}
