//! Where a line meets a solid or a surface, by the rules of closed sets, seams and ends.

use std::cmp::Ordering;

use dashu::integer::IBig;

use super::algebraic::Root;
use super::dyadic::{Dyadic, sign_of};
use super::flat::{annulus, disc, plane, triangle};
use super::quadric::{EVERYWHERE, IntegerLine, Interval, LateralLine, Overlap, Quadratic, sphere_overlap};
use super::slabs::{cuboid, rectangle};
use super::solids::{ConeExtent, CylinderExtent, Lateral, Line, Part, Solid, triangle_normal};

/// An end of a span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// The parameter of the line.
    pub t: Root,
    /// Where on the surface.
    pub part: Part,
}

/// A maximal piece of a line within a solid; `None` where it has no end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// Its lower end.
    pub enter: Option<End>,
    /// Its upper end.
    pub exit: Option<End>,
}

impl Span {
    /// Whether the line only touches the solid.
    pub fn is_touch(&self) -> bool {
        matches!((&self.enter, &self.exit), (Some(enter), Some(exit)) if enter.t == exit.t)
    }
}

/// How a line comes to a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// From the side that the normal points to: outside the tube or cone, above the plane.
    FromOutside,
    /// From the other side.
    FromInside,
    /// Along it, without crossing it.
    Touch,
}

/// A crossing of a surface that encloses nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// The parameter of the line.
    pub t: Root,
    /// From where.
    pub side: Approach,
    /// Where on the surface.
    pub part: Part,
}

/// Where a line meets a solid or a surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Of a solid: the pieces of the line within it, sorted; at most two, and two for a double cone, a waist, a
    /// tube or a torus only.
    Spans(Vec<Span>),
    /// Of an open or flat surface: the crossings, sorted.
    Crossings(Vec<Crossing>),
    /// The line lies in an open, flat or infinite surface from one parameter to another, which may be the same;
    /// `None` where it never leaves.
    Coincident {
        /// The lower end.
        from: Option<Root>,
        /// The upper end.
        to: Option<Root>,
    },
}

/// The piece of a line between two heights.
#[derive(Clone)]
pub(super) enum Slab {
    Nothing,
    Everywhere,
    Between { enter: End, exit: End },
}

impl Slab {
    pub(super) fn new(line: &IntegerLine, low: &IBig, high: &IBig) -> Self {
        let [_, y, _] = &line.origin;
        let climb = sign_of(&line.direction[1]);
        if climb == 0 {
            return if y < low || y > high { Self::Nothing } else { Self::Everywhere };
        }
        let base = End { t: line.at_height(low), part: Part::Base };
        let top = End { t: line.at_height(high), part: Part::Top };
        if climb > 0 { Self::Between { enter: base, exit: top } } else { Self::Between { enter: top, exit: base } }
    }
}

/// A line against both nappes of a cone, where `f <= 0`.
fn both_nappes(side: &LateralLine) -> Answer {
    let Quadratic { a, k, c } = &side.quadratic;
    let intervals = match sign_of(a) {
        1 => side
            .quadratic
            .roots(side.exponent)
            .map(|(enter, exit)| Interval::between(enter, exit))
            .into_iter()
            .collect(),
        -1 => {
            let (lower, upper) = side.quadratic.roots(side.exponent).expect("a line that runs within a nappe meets it");
            vec![Interval::until(lower), Interval::from(upper)]
        }
        _ => match sign_of(k) {
            -1 => vec![Interval::from(side.single_root())],
            1 => vec![Interval::until(side.single_root())],
            _ if c.is_zero() => return coincident(EVERYWHERE),
            _ => vec![],
        },
    };
    Answer::Spans(intervals.into_iter().map(all_side).collect())
}

fn side_end(t: Root) -> End {
    End { t, part: Part::Side }
}

fn all_side(interval: Interval) -> Span {
    Span { enter: interval.enter.map(side_end), exit: interval.exit.map(side_end) }
}

pub(super) fn coincident(interval: Interval) -> Answer {
    Answer::Coincident { from: interval.enter, to: interval.exit }
}

/// The interval within the slab; ends that the interval and the slab share are the interval's, and so the side's.
pub(super) fn clip(interval: Interval, slab: Slab) -> Option<Span> {
    let mut span = all_side(interval);
    match slab {
        Slab::Nothing => return None,
        Slab::Everywhere => {}
        Slab::Between { enter, exit } => {
            if span.enter.as_ref().is_none_or(|own| own.t < enter.t) {
                span.enter = Some(enter);
            }
            if span.exit.as_ref().is_none_or(|own| own.t > exit.t) {
                span.exit = Some(exit);
            }
        }
    }
    if let (Some(enter), Some(exit)) = (&mut span.enter, &mut span.exit) {
        match enter.t.cmp(&exit.t) {
            Ordering::Greater => return None,
            // A touch is one point: where it is on the side at all, it is on the rim, which the side owns.
            Ordering::Equal if enter.part == Part::Side || exit.part == Part::Side => {
                enter.part = Part::Side;
                exit.part = Part::Side;
            }
            _ => {}
        }
    }
    Some(span)
}

pub(super) fn solid_with_flat_caps(overlap: Overlap, slab: Slab) -> Answer {
    let span = match overlap {
        Overlap::Nothing => None,
        Overlap::Within(interval) => clip(interval, slab),
        // Every point of it is on the side, its ends on the rims among them.
        Overlap::InSurface(interval) => clip(interval, slab).map(|span| {
            let side = |end: End| side_end(end.t);
            Span { enter: span.enter.map(side), exit: span.exit.map(side) }
        }),
    };
    Answer::Spans(span.into_iter().collect())
}

pub(super) fn open_side(overlap: Overlap, slab: Slab) -> Answer {
    match overlap {
        Overlap::Nothing => Answer::Crossings(vec![]),
        Overlap::InSurface(interval) => match clip(interval, slab) {
            None => Answer::Crossings(vec![]),
            Some(span) => Answer::Coincident { from: span.enter.map(|end| end.t), to: span.exit.map(|end| end.t) },
        },
        Overlap::Within(interval) => {
            let reached = |t: &Root| match &slab {
                Slab::Nothing => false,
                Slab::Everywhere => true,
                Slab::Between { enter, exit } => enter.t <= *t && *t <= exit.t,
            };
            let touches = interval.enter.is_some() && interval.enter == interval.exit;
            let crossing = |t, side| Crossing { t, side, part: Part::Side };
            let crossings = if touches {
                vec![interval.enter.map(|t| crossing(t, Approach::Touch))]
            } else {
                vec![
                    interval.enter.map(|t| crossing(t, Approach::FromOutside)),
                    interval.exit.map(|t| crossing(t, Approach::FromInside)),
                ]
            };
            Answer::Crossings(crossings.into_iter().flatten().filter(|crossing| reached(&crossing.t)).collect())
        }
    }
}

fn unbounded(overlap: Overlap) -> Answer {
    match overlap {
        Overlap::Nothing => Answer::Spans(vec![]),
        Overlap::Within(interval) => Answer::Spans(vec![all_side(interval)]),
        Overlap::InSurface(interval) => coincident(interval),
    }
}

/// The capsule as the union of a capped cylinder and two balls: the union is convex, so that the line's piece in it
/// reaches from the least to the greatest of their ends.
fn capsule(line: &IntegerLine, lateral: &Lateral, radius: &IBig, height: &IBig) -> Answer {
    let mut ends: Vec<(Root, Root, bool)> = [IBig::ZERO, height.clone()]
        .iter()
        .filter_map(|centre| sphere_overlap(line, radius, centre))
        .filter_map(|ball| Some((ball.enter?, ball.exit?, false)))
        .collect();
    let body = solid_with_flat_caps(LateralLine::new(line, lateral).one_nappe(), Slab::new(line, &IBig::ZERO, height));
    if let Answer::Spans(spans) = body {
        ends.extend(spans.into_iter().filter_map(|span| Some((span.enter?.t, span.exit?.t, true))));
    }
    let part_at = |t: &Root| {
        let y =
            t.mul_add(&Dyadic::new(line.direction[1].clone(), -line.exponent), &Dyadic::new(line.origin[1].clone(), 0));
        if y.signum() < 0 {
            Part::Base
        } else if y.cmp_dyadic(&Dyadic::new(height.clone(), 0)) == Ordering::Greater {
            Part::Top
        } else {
            Part::Side
        }
    };
    let end = |(t, on_body): (Root, bool)| {
        let part = if on_body { Part::Side } else { part_at(&t) };
        End { t, part }
    };
    let enter = ends
        .iter()
        .map(|(enter, _, on_body)| (enter.clone(), *on_body))
        .reduce(|best, next| if next.0 < best.0 { next } else { best });
    let exit = ends
        .iter()
        .map(|(_, exit, on_body)| (exit.clone(), *on_body))
        .reduce(|best, next| if next.0 > best.0 { next } else { best });
    Answer::Spans(
        enter
            .zip(exit)
            .map(|(enter, exit)| Span { enter: Some(end(enter)), exit: Some(end(exit)) })
            .into_iter()
            .collect(),
    )
}

/// Where the line meets the solid or the surface, exactly.
///
/// Closed and infinite solids answer with spans, open and flat surfaces with crossings; a line that lies in an open,
/// flat or infinite surface is coincident with it.
///
/// # Panics
///
/// If a triangle has no area.
pub fn solve(solid: &Solid, line: &Line) -> Answer {
    let one_nappe = |integers: &IntegerLine| match solid.lateral() {
        Some(lateral) => LateralLine::new(integers, &lateral).one_nappe(),
        None => Overlap::Nothing,
    };
    match solid {
        Solid::Sphere { radius } => {
            let integers = IntegerLine::new(line, &[radius]);
            let ball = sphere_overlap(&integers, &integers.length(radius), &IBig::ZERO);
            Answer::Spans(ball.map(all_side).into_iter().collect())
        }
        Solid::Cylinder { extent: CylinderExtent::Infinite, .. } | Solid::Cone { extent: ConeExtent::Nappe, .. } => {
            unbounded(one_nappe(&IntegerLine::new(line, &[])))
        }
        Solid::Cone { extent: ConeExtent::Double, .. } => {
            let lateral = solid.lateral().expect("a cone has a side");
            both_nappes(&LateralLine::new(&IntegerLine::new(line, &[]), &lateral))
        }
        Solid::Cylinder { extent: CylinderExtent::Capped(height), .. }
        | Solid::Cone { extent: ConeExtent::Capped(height), .. }
        | Solid::Frustum { height, capped: true, .. } => {
            let integers = IntegerLine::new(line, &[height]);
            let slab = Slab::new(&integers, &IBig::ZERO, &integers.length(height));
            solid_with_flat_caps(one_nappe(&integers), slab)
        }
        Solid::Cylinder { extent: CylinderExtent::Open(height), .. }
        | Solid::Cone { extent: ConeExtent::Open(height), .. }
        | Solid::Frustum { height, capped: false, .. } => {
            let integers = IntegerLine::new(line, &[height]);
            let slab = Slab::new(&integers, &IBig::ZERO, &integers.length(height));
            open_side(one_nappe(&integers), slab)
        }
        Solid::Capsule { radius, height } => {
            let integers = IntegerLine::new(line, &[radius, height]);
            let lateral = solid.lateral().expect("a capsule has a side");
            capsule(&integers, &lateral, &integers.length(radius), &integers.length(height))
        }
        Solid::RoundCone(cone) => super::round_cone::solve(cone, line),
        Solid::Revolved(revolved) => super::revolved::solve(revolved, line),
        Solid::Tube { inner, outer, height } => super::tube::solve([inner, outer, height], line),
        Solid::Torus { major, minor } => super::torus::solve([major, minor], line),
        Solid::Plane => plane(&IntegerLine::new(line, &[])),
        Solid::Disc { radius } => {
            let integers = IntegerLine::new(line, &[radius]);
            disc(&integers, &integers.length(radius))
        }
        Solid::Annulus { inner, outer } => {
            let integers = IntegerLine::new(line, &[inner, outer]);
            annulus(&integers, [integers.length(inner), integers.length(outer)])
        }
        Solid::Cuboid { half } => cuboid(line, half),
        Solid::RoundedCuboid(cuboid) => super::rounded_cuboid::solve(cuboid, line),
        Solid::HalfSpaces(of) => super::half_spaces::solve(of, line),
        Solid::Rectangle { half } => rectangle(line, half),
        Solid::Triangle { vertices } => {
            // Called for its check that the triangle has an area.
            triangle_normal(vertices);
            let lengths: Vec<&Dyadic> = vertices.iter().flatten().collect();
            let integers = IntegerLine::new(line, &lengths);
            let corners = vertices.each_ref().map(|vertex| vertex.each_ref().map(|x| integers.length(x)));
            triangle(&integers, &corners)
        }
    }
}
