//! Where a line meets a cuboid and a rectangle.

use super::algebraic::Root;
use super::departing::Leaving;
use super::dyadic::{Dyadic, sign_of};
use super::quadric::{EVERYWHERE, IntegerLine, Interval};
use super::solids::{Line, Part};
use super::solve::{Answer, Approach, Crossing, End, Span, coincident};

/// The axes in the order in which their faces own edges and corners, each with its two faces.
const OWNERS: [(usize, [Part; 2]); 3] =
    [(0, [Part::Left, Part::Right]), (2, [Part::Back, Part::Front]), (1, [Part::Base, Part::Top])];

fn lengths(half: &[Dyadic; 3]) -> Vec<&Dyadic> {
    half.iter().collect()
}

/// The piece of the line where no coordinate is larger in magnitude than its half extent.
fn clipped(line: &Line, half: &[Dyadic; 3]) -> Option<Interval> {
    let integers = IntegerLine::new(line, &lengths(half));
    let mut interval = EVERYWHERE;
    for ((origin, direction), half) in integers.origin.iter().zip(&integers.direction).zip(half) {
        let bound = integers.length(half);
        let pace = sign_of(direction);
        if pace == 0 {
            if *origin > bound || *origin < -&bound {
                return None;
            }
            continue;
        }
        let crossings = [-&bound, bound].map(|bound| integers.ratio(bound - origin, direction));
        let [low, high] = crossings;
        let (enter, exit) = if pace > 0 { (low, high) } else { (high, low) };
        if interval.enter.as_ref().is_none_or(|own| enter > *own) {
            interval.enter = Some(enter);
        }
        if interval.exit.as_ref().is_none_or(|own| exit < *own) {
            interval.exit = Some(exit);
        }
    }
    if interval.enter > interval.exit { None } else { Some(interval) }
}

/// The first face whose plane holds the line's point.
fn owner(line: &Line, half: &[Dyadic; 3], t: &Root) -> Part {
    let is_at = |axis: usize, bound: &Dyadic| line.coordinate_at(t, axis).cmp_dyadic(bound).is_eq();
    OWNERS
        .into_iter()
        .find_map(|(axis, [low, high])| {
            let bound = &half[axis];
            if is_at(axis, &-bound) { Some(low) } else { is_at(axis, bound).then_some(high) }
        })
        .expect("an end lies in the plane of a face")
}

pub(super) fn cuboid(line: &Line, half: &[Dyadic; 3]) -> Answer {
    let end = |t: Option<Root>| t.map(|t| End { part: owner(line, half, &t), t });
    let span = clipped(line, half).map(|Interval { enter, exit }| Span { enter: end(enter), exit: end(exit) });
    Answer::Spans(span.into_iter().collect())
}

pub(super) fn rectangle(line: &Line, [x, z]: &[Dyadic; 2]) -> Answer {
    let climb = line.direction[1].signum();
    let Some(interval) = clipped(line, &[x.clone(), Dyadic::zero(), z.clone()]) else {
        return Answer::Crossings(vec![]);
    };
    match (climb, interval.enter) {
        (0, enter) => coincident(Interval { enter, ..interval }),
        (_, None) => unreachable!("a line that climbs crosses the plane"),
        (_, Some(t)) => {
            let side = if climb < 0 { Approach::FromOutside } else { Approach::FromInside };
            Answer::Crossings(vec![Crossing { t, side, part: Part::Side }])
        }
    }
}

/// Where a line that departs from this face meets the cuboid again: its start lies in the plane of that face, whatever
/// its coordinates say, and between all others.
pub(super) fn departing(line: &Line, half: &[Dyadic; 3], from: Part, leaving: Leaving) -> Answer {
    if leaving == Leaving::Outwards {
        return Answer::Spans(vec![]);
    }
    let integers = IntegerLine::new(line, &lengths(half));
    let mut exit: Option<End> = None;
    let mut lies_in = None;
    for (rank, (axis, [low, high])) in OWNERS.into_iter().enumerate() {
        let (origin, direction) = (&integers.origin[axis], &integers.direction[axis]);
        let bound = integers.length(&half[axis]);
        let (bound, part) = match sign_of(direction) {
            0 => {
                let along = [(-&bound, low), (bound, high)].into_iter();
                let own = if [low, high].contains(&from) { Some(from) } else { None };
                let along = own.or_else(|| along.into_iter().find(|(bound, _)| bound == origin).map(|(_, part)| part));
                lies_in = lies_in.or(along.map(|part| (rank, part)));
                continue;
            }
            1 => (bound, high),
            _ => (-bound, low),
        };
        let t = if part == from { Root::from(&Dyadic::zero()) } else { integers.ratio(bound - origin, direction) };
        if exit.as_ref().is_none_or(|own| t < own.t) {
            exit = Some(End { t, part });
        }
    }
    let exit = exit.map(|end| {
        let rank = OWNERS.into_iter().position(|(_, parts)| parts.contains(&end.part));
        let part = lies_in.filter(|(along, _)| Some(*along) < rank).map_or(end.part, |(_, part)| part);
        let t = if end.t.signum() < 0 { Root::from(&Dyadic::zero()) } else { end.t };
        End { t, part }
    });
    Answer::Spans(vec![Span { enter: None, exit }])
}
