//! Where a line that departs from a solid at `t = 0` meets it again.
//!
//! Its start is a point of the part that it departs from, whatever its coordinates say: of that part's quadric the
//! constant term is zero, so that the roots are 0 and `-2k/a`; of that part's plane the crossing is at 0. All other
//! equations take the coordinates as they are. Outwards from anything convex, and from anything flat, there is nothing
//! to meet. Inwards there is one end ahead, of the convex set that the line is in; an end that coordinates put behind
//! the start is at the start.

use dashu::integer::IBig;

use super::algebraic::Root;
use super::dyadic::{Dyadic, sign_of};
use super::quadric::{EVERYWHERE, IntegerLine, Interval, LateralLine, Overlap, Quadratic, sphere};
use super::solids::{ConeExtent, CylinderExtent, Line, Part, Solid};
use super::solve::{Answer, Approach, Crossing, End, Span};

/// To which side of the surface the line departs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Leaving {
    /// Along the outward normal.
    Outwards,
    /// Against it.
    Inwards,
}

/// The earlier of two ends; of two at the same point that of the side, which comes first here.
pub(super) fn first(side: Option<End>, plane: Option<End>) -> Option<End> {
    match (side, plane) {
        (Some(side), Some(plane)) => Some(if plane.t < side.t { plane } else { side }),
        (side, plane) => side.or(plane),
    }
}

pub(super) fn start(part: Part) -> End {
    End { t: Root::from(&Dyadic::zero()), part }
}

/// The span from before the start to the end, which is not before the start.
pub(super) fn inwards(exit: Option<End>) -> Answer {
    let exit = exit.map(|end| if end.t.signum() < 0 { start(end.part) } else { end });
    Answer::Spans(vec![Span { enter: None, exit }])
}

/// A line against a side, from which it departs or not.
fn side_of(solid: &Solid, line: &IntegerLine, departs: bool) -> LateralLine {
    let lateral = solid.lateral().expect("a solid with a side about its axis");
    let mut side = LateralLine::new(line, &lateral);
    if departs {
        side.quadratic.c = IBig::ZERO;
    }
    side
}

/// Where the line is at a height: at the start, if it departs from that cap.
fn crossing(line: &IntegerLine, height: &IBig, part: Part, from: Part) -> End {
    if part == from { start(part) } else { End { t: line.at_height(height), part } }
}

/// The plane through which the line leaves the slab between the caps; without caps, or parallel to them, it never does.
pub(super) fn last_cap(line: &IntegerLine, [base, top]: [Option<&IBig>; 2], from: Part) -> Option<End> {
    let (height, part) = match sign_of(&line.direction[1]) {
        1 => (top?, Part::Top),
        -1 => (base?, Part::Base),
        _ => return None,
    };
    Some(crossing(line, height, part, from))
}

/// A convex solid with a side and caps at these heights.
fn within_caps(solid: &Solid, line: &IntegerLine, caps: [Option<&IBig>; 2], from: Part) -> Answer {
    let side = side_of(solid, line, from == Part::Side);
    let cap = last_cap(line, caps, from);
    let on_side = |t: Root| End { t, part: Part::Side };
    let own = match side.one_nappe() {
        Overlap::Within(interval) => interval.exit.map(on_side),
        Overlap::InSurface(interval) => {
            let exit = first(interval.exit.map(on_side), cap);
            return inwards(exit.map(|end| on_side(end.t)));
        }
        // Next to the wall and parallel to it, the line runs to the cap; else its coordinates say that it does not
        // enter.
        Overlap::Nothing if side.quadratic.a.is_zero() => None,
        Overlap::Nothing => Some(start(Part::Side)),
    };
    inwards(first(own, cap))
}

/// The wall alone, between its rims, which belong to it: from its inner side the far wall is met, and the start is not.
fn open(solid: &Solid, line: &IntegerLine, height: &IBig) -> Answer {
    let Overlap::Within(Interval { exit: Some(t), .. }) = side_of(solid, line, true).one_nappe() else {
        return Answer::Crossings(vec![]);
    };
    let is_between = match sign_of(&line.direction[1]) {
        0 => true,
        climb => {
            let rims = [line.at_height(&IBig::ZERO), line.at_height(height)];
            let [low, high] = if climb > 0 { rims } else { [rims[1].clone(), rims[0].clone()] };
            low <= t && t <= high
        }
    };
    let is_met = t.signum() > 0 && is_between;
    let crossing = Crossing { t, side: Approach::FromInside, part: Part::Side };
    Answer::Crossings(if is_met { vec![crossing] } else { vec![] })
}

/// Both nappes: outwards from one the other may be met.
fn both_nappes(solid: &Solid, line: &IntegerLine, leaving: Leaving) -> Answer {
    let side = side_of(solid, line, true);
    let Quadratic { a, k, .. } = &side.quadratic;
    let at = |t: Root| Some(End { t, part: Part::Side });
    if sign_of(a) == 0 {
        return match (sign_of(k), leaving) {
            (0, _) => super::solve::coincident(EVERYWHERE),
            (_, Leaving::Outwards) => Answer::Spans(vec![]),
            (-1, Leaving::Inwards) => inwards(None),
            (_, Leaving::Inwards) => inwards(Some(start(Part::Side))),
        };
    }
    let (lower, upper) = side.quadratic.roots(side.exponent).expect("the start is a root");
    let is_ahead = upper.signum() > 0;
    let beyond = |enter: Root| Span { enter: at(enter), exit: None };
    match (sign_of(a), leaving) {
        (1, Leaving::Inwards) => inwards(at(upper)),
        (1, Leaving::Outwards) => Answer::Spans(vec![]),
        // The start is the lower root, and the other nappe ahead.
        (_, Leaving::Outwards) if is_ahead => Answer::Spans(vec![beyond(upper)]),
        (_, Leaving::Outwards) => Answer::Spans(vec![]),
        // Said to enter, the line leads away: it ends where it starts.
        (_, Leaving::Inwards) if is_ahead => Answer::Spans(vec![Span { enter: None, exit: at(lower) }, beyond(upper)]),
        (_, Leaving::Inwards) => inwards(None),
    }
}

/// The end of the infinite tube where it lies between the seams, and beyond them that of the ball there; where
/// coordinates say that the line misses that ball, the start.
fn capsule(solid: &Solid, line: &IntegerLine, radius: &IBig, height: &IBig, from: Part) -> Answer {
    let tube = side_of(solid, line, from == Part::Side);
    let climb = sign_of(&line.direction[1]);
    let part_of = |t: &Root| {
        let y =
            t.mul_add(&Dyadic::new(line.direction[1].clone(), -line.exponent), &Dyadic::new(line.origin[1].clone(), 0));
        match (y.signum() < 0, y.cmp_dyadic(&Dyadic::new(height.clone(), 0)).is_gt()) {
            (true, _) => Part::Base,
            (_, true) => Part::Top,
            _ => Part::Side,
        }
    };
    let (end, part) = match tube.one_nappe() {
        Overlap::Within(Interval { exit: Some(t), .. }) => {
            let part = part_of(&t);
            (Some(t), part)
        }
        // Along the side, it ends at the seam, which is the side's.
        Overlap::InSurface(_) => {
            let cap = last_cap(line, [Some(&IBig::ZERO), Some(height)], from);
            return inwards(cap.map(|end| End { part: Part::Side, ..end }));
        }
        Overlap::Nothing => {
            let t = start(Part::Side).t;
            let part = part_of(&t);
            (Some(t), part)
        }
        Overlap::Within(_) => (None, if climb > 0 { Part::Top } else { Part::Base }),
    };
    let centre = match part {
        Part::Side => return inwards(end.map(|t| End { t, part })),
        Part::Base => &IBig::ZERO,
        Part::Top => height,
        _ => unreachable!("a capsule has no faces"),
    };
    let mut ball = sphere(line, radius, centre);
    if part == from {
        ball.c = IBig::ZERO;
    }
    let exit = ball.roots(line.exponent).map_or_else(|| start(from), |(_, t)| End { t, part });
    inwards(Some(exit))
}

/// Where a line that departs at `t = 0` from this part of the solid, to this side, meets it again, exactly.
///
/// A solid is answered with the span that holds the start, without its lower end; and a double cone with what lies
/// beyond.
///
/// # Panics
///
/// If a solid with a side about its axis has none.
pub fn solve_departing(solid: &Solid, line: &Line, from: Part, leaving: Leaving) -> Answer {
    match (solid, leaving) {
        (Solid::Cuboid { half }, _) => super::slabs::departing(line, half, from, leaving),
        (Solid::HalfSpaces(of), _) => super::half_spaces::departing(of, line, from, leaving),
        (Solid::RoundedCuboid(cuboid), _) => super::rounded_cuboid::departing(cuboid, line, from, leaving),
        (Solid::Revolved(revolved), _) => super::revolved::departing(revolved, line, from, leaving),
        (Solid::RoundCone(cone), _) => super::round_cone::departing(cone, line, from, leaving),
        (Solid::Torus { major, minor }, _) => super::torus::departing([major, minor], line, leaving),
        (Solid::Tube { inner, outer, height }, _) => {
            super::tube::departing([inner, outer, height], line, from, leaving)
        }
        (
            Solid::Plane
            | Solid::Disc { .. }
            | Solid::Annulus { .. }
            | Solid::Rectangle { .. }
            | Solid::Triangle { .. },
            _,
        ) => Answer::Crossings(vec![]),
        (Solid::Cone { extent: ConeExtent::Double, .. }, _) => {
            both_nappes(solid, &IntegerLine::new(line, &[]), leaving)
        }
        (_, Leaving::Outwards) => Answer::Spans(vec![]),
        (Solid::Sphere { radius }, _) => {
            let integers = IntegerLine::new(line, &[radius]);
            let ball = Quadratic { c: IBig::ZERO, ..sphere(&integers, &integers.length(radius), &IBig::ZERO) };
            let (_, t) = ball.roots(integers.exponent).expect("the start is a root");
            inwards(Some(End { t, part: Part::Side }))
        }
        (Solid::Capsule { radius, height }, _) => {
            let integers = IntegerLine::new(line, &[radius, height]);
            capsule(solid, &integers, &integers.length(radius), &integers.length(height), from)
        }
        (
            Solid::Cylinder { extent: CylinderExtent::Open(height), .. }
            | Solid::Cone { extent: ConeExtent::Open(height), .. }
            | Solid::Frustum { height, capped: false, .. },
            _,
        ) => {
            let integers = IntegerLine::new(line, &[height]);
            open(solid, &integers, &integers.length(height))
        }
        (
            Solid::Cylinder { extent: CylinderExtent::Infinite, .. } | Solid::Cone { extent: ConeExtent::Nappe, .. },
            _,
        ) => within_caps(solid, &IntegerLine::new(line, &[]), [None; 2], from),
        (
            Solid::Cylinder { extent: CylinderExtent::Capped(height), .. }
            | Solid::Cone { extent: ConeExtent::Capped(height), .. }
            | Solid::Frustum { height, capped: true, .. },
            _,
        ) => {
            let integers = IntegerLine::new(line, &[height]);
            let (base, top) = (IBig::ZERO, integers.length(height));
            // An apex ends the side itself: where the radius is zero there is no cap.
            let [has_base, has_top] = match solid {
                Solid::Cone { .. } => [false, true],
                Solid::Frustum { base_radius, top_radius, .. } => [!base_radius.is_zero(), !top_radius.is_zero()],
                _ => [true; 2],
            };
            let caps = [has_base.then_some(&base), has_top.then_some(&top)];
            within_caps(solid, &integers, caps, from)
        }
    }
}
