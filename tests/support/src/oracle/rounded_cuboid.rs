//! A line against all points within a radius of a cuboid: the union of 27 convex sets. For each choice of axes and of a
//! sign for each of them, it is what a ball about a corner, a cylinder about an edge or a slab about a face has between
//! the planes of the cuboid across all other axes. The union is convex, so that the line's piece in it reaches from the
//! least to the greatest of their ends.

use std::cmp::Ordering;

use dashu::rational::RBig;

use super::algebraic::Root;
use super::departing::{self, Leaving};
use super::dyadic::Dyadic;
use super::solids::{Line, Part, RoundedCuboid};
use super::solve::{Answer, End, Span};

/// The axes and signs of a set: 1 beyond the upper plane across an axis, -1 below the lower one, 0 between both.
type Region = [i8; 3];

/// A line in rational numbers, relative to a rounded cuboid.
struct Cells {
    /// Where the line starts along each axis, as seen from below and from above: the same, but from the side of a face
    /// that it departs from.
    origin: [[RBig; 2]; 3],
    direction: [RBig; 3],
    half: [RBig; 3],
    radius: RBig,
    /// The set from whose surface the line departs.
    own: Option<Region>,
}

fn sign(value: &RBig) -> i8 {
    match value.partial_cmp(&RBig::ZERO) {
        Some(Ordering::Less) => -1,
        Some(Ordering::Greater) => 1,
        _ => 0,
    }
}

/// The face of a set that has one.
fn face(region: Region) -> Option<Part> {
    Some(RoundedCuboid::part_of(region)).filter(|part| *part != Part::Side)
}

impl Cells {
    fn new(solid: &RoundedCuboid, line: &Line) -> Self {
        let rational = |vector: &[Dyadic; 3]| vector.each_ref().map(Dyadic::to_rational);
        Self {
            origin: rational(&line.origin).map(|c| [c.clone(), c]),
            direction: rational(&line.direction),
            half: rational(&solid.half),
            radius: solid.radius.to_rational(),
            own: None,
        }
    }

    /// The coefficients of `a t^2 + 2 k t + c`, the square of the distance from the nearest point, edge or plane of the
    /// cuboid, less that of the radius.
    fn function(&self, region: Region) -> [RBig; 3] {
        let [mut a, mut k, mut c] = [RBig::ZERO, RBig::ZERO, -(&self.radius * &self.radius)];
        for axis in (0..3).filter(|axis| region[*axis] != 0) {
            let from = self.from(axis, region[axis]) - RBig::from(region[axis]) * &self.half[axis];
            let d = &self.direction[axis];
            a += d * d;
            k += &from * d;
            c += &from * &from;
        }
        if self.own == Some(region) {
            c = RBig::ZERO;
        }
        [a, k, c]
    }

    /// The start, as seen from a side.
    fn from(&self, axis: usize, side: i8) -> &RBig {
        &self.origin[axis][usize::from(side > 0)]
    }

    /// Where the line crosses the plane across an axis that is so far from the cuboid, on this side.
    fn crossing(&self, axis: usize, side: i8, beyond: &RBig) -> RBig {
        (RBig::from(side) * (&self.half[axis] + beyond) - self.from(axis, side)) / &self.direction[axis]
    }

    /// The ends of the line's piece in a set.
    fn piece(&self, region: Region) -> Option<[Root; 2]> {
        let [a, k, c] = self.function(region);
        let mut ends: Option<[Root; 2]> = if sign(&a) == 0 {
            if sign(&c) > 0 {
                return None;
            }
            None
        } else {
            let square = &k * &k - &a * &c;
            if sign(&square) < 0 {
                return None;
            }
            Some([-1, 1].map(|s| Root::from_rationals(&-&k, s, &square, &a)))
        };
        for axis in (0..3).filter(|axis| region[*axis] == 0) {
            let half = &self.half[axis];
            if sign(&self.direction[axis]) == 0 {
                if self.from(axis, 1) > half || *self.from(axis, -1) < -half {
                    return None;
                }
                continue;
            }
            let mut planes = [-1, 1].map(|side| Root::from_rational(&self.crossing(axis, side, &RBig::ZERO)));
            planes.sort();
            let [low, high] = planes;
            ends = Some(match ends {
                None => [low, high],
                Some([enter, exit]) => [enter.max(low), exit.min(high)],
            });
        }
        ends.filter(|[enter, exit]| enter <= exit)
    }

    /// The region of the line's point. A start in the plane of a face may seem to be on both sides of a cuboid without
    /// extent: then it is on that to which the line goes.
    fn region_at(&self, t: &RBig) -> Region {
        std::array::from_fn(|axis| {
            let along = t * &self.direction[axis];
            let [below, above] = [-1, 1].map(|side| self.from(axis, side) + &along);
            let (is_above, is_below) = (above > self.half[axis], below < -&self.half[axis]);
            match (is_above, is_below) {
                (true, true) => {
                    if sign(&self.direction[axis]) > 0 {
                        1
                    } else {
                        -1
                    }
                }
                _ => i8::from(is_above) - i8::from(is_below),
            }
        })
    }

    /// The last end of a line, going back from the box around the solid, from cell to cell between the planes: in the
    /// first at whose lower end the line is inside, or nearest.
    fn exit(&self) -> Option<End> {
        let end = |t: Root, region: Region| End { t, part: face(region).unwrap_or(Part::Side) };
        let paces = (0..3).map(|axis| (axis, sign(&self.direction[axis]))).filter(|(_, pace)| *pace != 0);
        let outer = paces.map(|(axis, pace)| self.crossing(axis, pace, &self.radius));
        let last = outer.min().expect("a line has a direction");
        let mut region = self.region_at(&last);
        if face(region).is_some() {
            return Some(end(Root::from_rational(&last), region));
        }
        loop {
            let [a, k, c] = self.function(region);
            let lower = (0..3)
                .filter(|axis| {
                    let pace = sign(&self.direction[*axis]);
                    pace != 0 && region[*axis] != -pace
                })
                .map(|axis| {
                    let pace = sign(&self.direction[axis]);
                    let side = if region[axis] == pace { pace } else { -pace };
                    (self.crossing(axis, side, &RBig::ZERO), axis)
                })
                .max();
            let in_cell = || {
                let square = &k * &k - &a * &c;
                (sign(&square) >= 0).then(|| end(Root::from_rationals(&-&k, 1, &square, &a), [1; 3]))
            };
            let Some((t, axis)) = lower else { return in_cell() };
            let (value, slope) = (&a * &t * &t + &k * &t * RBig::from(2) + &c, &a * &t + &k);
            match (sign(&value), sign(&slope)) {
                (0, 0 | 1) => return Some(end(Root::from_rational(&t), self.region_at(&t))),
                (1, 1) => region[axis] -= sign(&self.direction[axis]),
                _ => return in_cell(),
            }
        }
    }
}

/// Where the line meets the solid.
pub(super) fn solve(solid: &RoundedCuboid, line: &Line) -> Answer {
    let cells = Cells::new(solid, line);
    let regions = (0..27_i8).map(|i| [i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1]);
    let ends = regions.filter_map(|region| cells.piece(region)).reduce(|[first, last], [enter, exit]| {
        let (first, last) = (first.min(enter), last.max(exit));
        [first, last]
    });
    let end = |t: Root| Some(End { part: solid.part_at(line, &t), t });
    let span = ends.map(|[enter, exit]| Span { enter: end(enter), exit: end(exit) });
    Answer::Spans(span.into_iter().collect())
}

/// Where a line that departs from a face, an edge or a corner leaves the solid. A line that departs from a face, or
/// from the rest at a point over a face, starts in the plane of that; relative to all other planes its coordinates are
/// what they are.
pub(super) fn departing(solid: &RoundedCuboid, line: &Line, from: Part, leaving: Leaving) -> Answer {
    if leaving == Leaving::Outwards {
        return Answer::Spans(vec![]);
    }
    let mut cells = Cells::new(solid, line);
    let region = match from {
        Part::Left => [-1, 0, 0],
        Part::Right => [1, 0, 0],
        Part::Base => [0, -1, 0],
        Part::Top => [0, 1, 0],
        Part::Back => [0, 0, -1],
        Part::Front => [0, 0, 1],
        _ => cells.region_at(&RBig::ZERO),
    };
    if face(region).is_some() {
        let axis = region.iter().position(|side| *side != 0).expect("a face is across an axis");
        let plane = RBig::from(region[axis]) * (&cells.half[axis] + &cells.radius);
        cells.origin[axis][usize::from(region[axis] > 0)] = plane;
    } else if region != [0; 3] {
        cells.own = Some(region);
    }
    departing::inwards(Some(cells.exit().unwrap_or_else(|| departing::start(Part::Side))))
}
