//! A line against the convex hull of two balls: the union of both and of the part of the cone that touches them between
//! the circles where it does. The union is convex, so that the line's piece in it reaches from the least to the
//! greatest of their ends.

use dashu::integer::IBig;

use super::algebraic::Root;
use super::departing::{self, Leaving};
use super::dyadic::{Dyadic, sign_of};
use super::quadric::{IntegerLine, LateralLine, Overlap, Quadratic, sphere, sphere_overlap};
use super::solids::{Line, Part, RoundCone};
use super::solve::{Answer, End, Slab, Span, solid_with_flat_caps};

/// The line in units of lengths, and in units of their squares: multiplied by the height, so that the heights of the
/// circles are integers; `t` is the same.
struct Hull<'a> {
    solid: &'a RoundCone,
    line: IntegerLine,
    wide: IntegerLine,
    radii: [IBig; 2],
    height: IBig,
    k: IBig,
}

impl<'a> Hull<'a> {
    fn new(solid: &'a RoundCone, line: &Line) -> Self {
        let line = IntegerLine::new(line, &[&solid.base_radius, &solid.top_radius, &solid.height]);
        let radii = [&solid.base_radius, &solid.top_radius].map(|radius| line.length(radius));
        let height = line.length(&solid.height);
        let wider = |vector: &[IBig; 3]| vector.each_ref().map(|c| c * &height);
        let wide = IntegerLine {
            origin: wider(&line.origin),
            direction: wider(&line.direction),
            length_unit: line.length_unit,
            exponent: line.exponent,
        };
        let k = &radii[0] - &radii[1];
        Self { solid, line, wide, radii, height, k }
    }

    /// The infinite cone, from which the line departs or not.
    fn side(&self, departs: bool) -> LateralLine {
        let (h, k, r) = (&self.height, &self.k, &self.radii[0]);
        let w = h * h - k * k;
        let ([x, y, z], [dx, dy, dz]) = (&self.line.origin, &self.line.direction);
        let (reach, reach_slope) = (r * h - k * y, -k * dy);
        let c = if departs { IBig::ZERO } else { &w * (x * x + z * z) - &reach * &reach };
        let quadratic = Quadratic {
            a: &w * (dx * dx + dz * dz) - &reach_slope * &reach_slope,
            k: &w * (x * dx + z * dz) - &reach * &reach_slope,
            c,
        };
        LateralLine { quadratic, reach, reach_slope, exponent: self.line.exponent }
    }

    /// The heights of the circles, in units of squares.
    fn seams(&self) -> [IBig; 2] {
        [&self.radii[0] * &self.k, &self.height * &self.height + &self.radii[1] * &self.k]
    }

    fn part_at(&self, t: &Root) -> Part {
        let ([_, dy, _], [_, y, _]) = (&self.wide.direction, &self.wide.origin);
        let y = t.mul_add(&Dyadic::new(dy.clone(), -self.line.exponent), &Dyadic::new(y.clone(), 0));
        let [low, high] = self.seams();
        let beside = |seam: IBig| y.cmp_dyadic(&Dyadic::new(seam, 0));
        if beside(low).is_lt() {
            Part::Base
        } else if beside(high).is_gt() {
            Part::Top
        } else {
            Part::Side
        }
    }

    /// The ball of a part: its radius and the height of its centre.
    fn ball(&self, part: Part) -> [IBig; 2] {
        match part {
            Part::Top => [self.radii[1].clone(), self.height.clone()],
            _ => [self.radii[0].clone(), IBig::ZERO],
        }
    }
}

/// Where the line meets the hull.
pub(super) fn solve(solid: &RoundCone, line: &Line) -> Answer {
    let hull = Hull::new(solid, line);
    let of_ball = |part: Part| {
        let [radius, centre] = hull.ball(part);
        sphere_overlap(&hull.line, &radius, &centre)
    };
    if let Some((part, ..)) = hull.solid.ball() {
        let end = |t: Option<Root>| t.map(|t| End { t, part });
        let span = of_ball(part).map(|ball| Span { enter: end(ball.enter), exit: end(ball.exit) });
        return Answer::Spans(span.into_iter().collect());
    }
    let mut ends: Vec<(Root, Root, bool)> = [Part::Base, Part::Top]
        .into_iter()
        .filter_map(of_ball)
        .filter_map(|ball| Some((ball.enter?, ball.exit?, false)))
        .collect();
    let [low, high] = hull.seams();
    let between = solid_with_flat_caps(hull.side(false).one_nappe(), Slab::new(&hull.wide, &low, &high));
    if let Answer::Spans(spans) = between {
        ends.extend(spans.into_iter().filter_map(|span| Some((span.enter?.t, span.exit?.t, true))));
    }
    // What is between the circles comes last, and is taken if a ball's end is no earlier or later.
    let end = |t: Root, is_between: bool| {
        let part = if is_between { Part::Side } else { hull.part_at(&t) };
        End { t, part }
    };
    let enter = ends
        .iter()
        .map(|(enter, _, is_between)| (enter, *is_between))
        .reduce(|best, next| if next.0 < best.0 { next } else { best });
    let exit = ends
        .iter()
        .map(|(_, exit, is_between)| (exit, *is_between))
        .reduce(|best, next| if next.0 > best.0 { next } else { best });
    let span = enter.zip(exit).map(|(enter, exit)| Span {
        enter: Some(end(enter.0.clone(), enter.1)),
        exit: Some(end(exit.0.clone(), exit.1)),
    });
    Answer::Spans(span.into_iter().collect())
}

/// Where a line that departs inwards from the part leaves the hull.
pub(super) fn departing(solid: &RoundCone, line: &Line, from: Part, leaving: Leaving) -> Answer {
    if leaving == Leaving::Outwards {
        return Answer::Spans(vec![]);
    }
    let hull = Hull::new(solid, line);
    let in_ball = |part: Part, departs: bool| {
        let [radius, centre] = hull.ball(part);
        let mut ball = sphere(&hull.line, &radius, &centre);
        if departs {
            ball.c = IBig::ZERO;
        }
        ball.roots(hull.line.exponent).map(|(_, t)| End { t, part })
    };
    if let Some((part, ..)) = solid.ball() {
        return departing::inwards(in_ball(part, true));
    }
    let climb = sign_of(&hull.line.direction[1]);
    let part = match hull.side(from == Part::Side).one_nappe() {
        Overlap::Within(interval) => match interval.exit {
            Some(t) => match hull.part_at(&t) {
                Part::Side => return departing::inwards(Some(End { t, part: Part::Side })),
                part => part,
            },
            None => {
                if climb > 0 {
                    Part::Top
                } else {
                    Part::Base
                }
            }
        },
        // Along the side it ends at the circle, which is the side's.
        Overlap::InSurface(_) => {
            let [low, high] = hull.seams();
            let cap = departing::last_cap(&hull.wide, [Some(&low), Some(&high)], from);
            return departing::inwards(cap.map(|end| End { part: Part::Side, ..end }));
        }
        Overlap::Nothing => {
            let start = departing::start(Part::Side);
            match hull.part_at(&start.t) {
                Part::Side => return departing::inwards(Some(start)),
                part => part,
            }
        }
    };
    departing::inwards(Some(in_ball(part, part == from).unwrap_or_else(|| departing::start(from))))
}
