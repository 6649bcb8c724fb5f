//! Where a line meets a prism or a polyhedron: what the half-spaces of its faces have in common.

use super::algebraic::Root;
use super::departing::Leaving;
use super::dyadic::Dyadic;
use super::solids::{HalfSpace, HalfSpaces, Line, Part, dot};
use super::solve::{Answer, End, Span};

/// A face along a line: its part, how far the line's origin is outside of its plane, and the growth of that; both times
/// the length of the normal.
type Along = (Part, [Dyadic; 2]);

fn along(solid: &HalfSpaces, line: &Line) -> Vec<Along> {
    let of = |face: &HalfSpace| (face.part, [-&face.margin(&line.origin), dot(&face.normal, &line.direction)]);
    solid.faces.iter().map(of).collect()
}

/// Where the line crosses the plane.
fn crossing([value, slope]: &[Dyadic; 2]) -> Root {
    Root::quotient(-value.mantissa.clone(), slope.mantissa.clone(), value.exponent - slope.exponent)
}

/// The first face whose plane holds the line's point.
fn owner(faces: &[Along], t: &Root) -> Part {
    let holds = |(_, [value, slope]): &&Along| t.mul_add(slope, value).signum() == 0;
    faces.iter().find(holds).expect("an end lies in the plane of a face").0
}

pub(super) fn solve(of: &HalfSpaces, line: &Line) -> Answer {
    let faces = along(of, line);
    let (mut enter, mut exit): (Option<Root>, Option<Root>) = (None, None);
    for (_, face @ [value, slope]) in &faces {
        match slope.signum() {
            0 if value.signum() > 0 => return Answer::Spans(vec![]),
            0 => {}
            1 => {
                let t = crossing(face);
                exit = if exit.as_ref().is_none_or(|own| t < *own) { Some(t) } else { exit };
            }
            _ => {
                let t = crossing(face);
                enter = if enter.as_ref().is_none_or(|own| t > *own) { Some(t) } else { enter };
            }
        }
    }
    if enter > exit {
        return Answer::Spans(vec![]);
    }
    let end = |t: Option<Root>| t.map(|t| End { part: owner(&faces, &t), t });
    Answer::Spans(vec![Span { enter: end(enter), exit: end(exit) }])
}

/// Where a line that departs from this face meets the solid again: its start lies in the plane of that face, whatever
/// its coordinates say, and on the inner side of all others.
pub(super) fn departing(of: &HalfSpaces, line: &Line, from: Part, leaving: Leaving) -> Answer {
    if leaving == Leaving::Outwards {
        return Answer::Spans(vec![]);
    }
    let mut exit: Option<(usize, End)> = None;
    let mut lies_in = None;
    for (rank, (part, face)) in along(of, line).into_iter().enumerate() {
        let [value, slope] = &face;
        if slope.signum() == 0 && (part == from || value.is_zero()) {
            lies_in = lies_in.or(Some((rank, part)));
        }
        if slope.signum() > 0 {
            let t = if part == from { Root::from(&Dyadic::zero()) } else { crossing(&face) };
            if exit.as_ref().is_none_or(|(_, own)| t < own.t) {
                exit = Some((rank, End { t, part }));
            }
        }
    }
    let exit = exit.map(|(rank, end)| {
        let part = lies_in.filter(|(along, _)| *along < rank).map_or(end.part, |(_, part)| part);
        let t = if end.t.signum() < 0 { Root::from(&Dyadic::zero()) } else { end.t };
        End { t, part }
    });
    Answer::Spans(vec![Span { enter: None, exit }])
}
