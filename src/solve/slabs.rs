//! Cuboids and rectangles, decided by signs.
//!
//! A cuboid is what three slabs between parallel planes have in common, and the line's interval in it is what the intervals in the slabs
//! have in common (Kay and Kajiya, *Ray Tracing Complex Scenes*, 1986). Which plane comes last or first is decided by the signs of
//! differences of products, not by quotients.

use super::flat::crossing;
use super::form::Line;
use super::quadratic::{End, Flat, Fraction, Interval, times};
use super::settle::{Of, inwards, span};
use crate::intersection::Intersection;
use crate::number::Number;
use crate::part::{FACES, Part};
use crate::ray::Range;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// Where the line crosses the plane of a face: `t = (bound - o) / d` of the coordinates across it.
#[derive(Clone, Copy)]
struct Crossed<N> {
    bound: N,
    o: N,
    d: N,
    /// The number of the face's axis in the order of [`FACES`].
    rank: usize,
    part: Part,
}

impl<N: Number> Crossed<N> {
    fn t(self) -> Fraction<N> {
        Fraction { n: self.bound - self.o, e: self.d }
    }

    /// How it compares with another, by one sum of products, so that the start of a far line cancels before any rounding.
    fn order(self, other: Self) -> Option<Ordering> {
        let sum = N::sum([[self.bound, other.d], [-self.o, other.d], [-other.bound, self.d], [other.o, self.d]]);
        Some(times(sum.sign()?, times(self.d.sign()?, other.d.sign()?)))
    }
}

/// The interval of the line in the slabs, as far as it has been clipped. A missing end is infinite.
#[derive(Clone, Copy)]
struct Clipped<N> {
    enter: Option<Crossed<N>>,
    exit: Option<Crossed<N>>,
    /// The first face whose plane the line lies in.
    along: Option<(usize, Part)>,
}

impl<N: Number> Clipped<N> {
    /// The interval of the line with every coordinate at most that of `half` in magnitude; `Some(None)` if there is none.
    ///
    /// If two planes are crossed at the same `t`, the first one counts. The start of a line that departs from a face is taken to lie on it
    /// and between all others, and there is no entry.
    fn new(line: &Line<N>, half: [N; 3]) -> Option<Option<Self>> {
        let departs = line.departure.is_some();
        let mut clipped = Self { enter: None, exit: None, along: None };
        let ([x, y, z], [dx, dy, dz], [hx, hy, hz]) = (line.origin, line.direction, half);
        let axes = [(x, dx, hx), (z, dz, hz), (y, dy, hy)];
        for (rank, ((o, d, h), parts)) in axes.into_iter().zip(FACES).enumerate() {
            let [low, high] = parts;
            let (enter, exit) = match d.sign()? {
                Ordering::Greater => ((low, -h), (high, h)),
                Ordering::Less => ((high, h), (low, -h)),
                Ordering::Equal => {
                    let along = match parts.into_iter().find(|part| line.departs_from(*part)) {
                        None => match ((o + h).sign()?, (o - h).sign()?) {
                            (Ordering::Less, _) | (_, Ordering::Greater) if !departs => return Some(None),
                            (Ordering::Equal, _) => Some(low),
                            (_, Ordering::Equal) => Some(high),
                            _ => None,
                        },
                        own => own,
                    };
                    clipped.along = clipped.along.or(along.map(|part| (rank, part)));
                    continue;
                }
            };
            let crossed = |(part, bound): (Part, N)| {
                if line.departs_from(part) {
                    return Crossed { bound: N::ZERO, o: N::ZERO, d: N::ONE, rank, part };
                }
                Crossed { bound, o, d, rank, part }
            };
            if !departs {
                clipped.enter = later(clipped.enter, crossed(enter), Ordering::Greater)?;
            }
            clipped.exit = later(clipped.exit, crossed(exit), Ordering::Less)?;
        }
        Some(Some(clipped))
    }

    /// An end with its part: that of the first face that holds it.
    fn end(&self, end: Option<Crossed<N>>) -> Option<End<N>> {
        let crossed = end?;
        let part = self.along.filter(|(along, _)| *along < crossed.rank).map_or(crossed.part, |(_, part)| part);
        Some(End::at(crossed.t(), part))
    }

    /// The interval, if it is not empty.
    fn interval(&self) -> Option<Option<Interval<N>>> {
        let [enter, exit] = [self.enter, self.exit].map(|end| self.end(end));
        let (Some(first), Some(last)) = (self.enter, self.exit) else {
            return Some(Some(Interval { enter, exit, touch: false }));
        };
        Some(match first.order(last)? {
            Ordering::Greater => None,
            Ordering::Less => Some(Interval { enter, exit, touch: false }),
            // The interval is one point of an edge.
            Ordering::Equal => {
                let end = self.end(Some(if first.rank < last.rank { first } else { last }));
                Some(Interval { enter: end, exit: end, touch: true })
            }
        })
    }
}

/// `new` if it compares with `own` as `counts` says, otherwise `own`.
fn later<N: Number>(own: Option<Crossed<N>>, new: Crossed<N>, counts: Ordering) -> Option<Option<Crossed<N>>> {
    Some(match own {
        Some(own) if new.order(own)? != counts => Some(own),
        _ => Some(new),
    })
}

/// The cuboid about the origin with these half extents.
#[inline(never)]
pub(super) fn cuboid<S: Scalar, N: Of<S>>(line: &Line<N>, half: [N; 3], range: Range<S>) -> Option<Intersection<S>> {
    let Some(clipped) = Clipped::new(line, half)? else { return Some(Intersection::Miss) };
    if line.departure.is_some() {
        return Some(Intersection::One(inwards(&Flat, clipped.end(clipped.exit), range)?));
    }
    Some(match clipped.interval()? {
        Some(interval) => Intersection::One(span(&Flat, interval, range)?),
        None => Intersection::Miss,
    })
}

/// The rectangle about the origin with these half extents along x and z, in the plane `y = 0`.
///
/// Times `dy`, the coordinates of the point where the line crosses the plane are components of its Pluecker moment.
#[inline(never)]
pub(super) fn rectangle<S: Scalar, N: Of<S>>(
    line: &Line<N>,
    [hx, hz]: [N; 2],
    range: Range<S>,
) -> Option<Intersection<S>> {
    let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
    let climb = dy.sign()?;
    if climb == Ordering::Equal {
        if y.sign()? != Ordering::Equal {
            return Some(Intersection::Miss);
        }
        let overlap = match Clipped::new(line, [hx, N::ZERO, hz])? {
            Some(clipped) => clipped.interval()?,
            None => None,
        };
        let Some(overlap) = overlap else { return Some(Intersection::Miss) };
        let [enter, exit] = [overlap.enter, overlap.exit].map(|end| end.map(End::of_side));
        return Some(Intersection::LiesIn(span(&Flat, Interval { enter, exit, ..overlap }, range)?));
    }
    for (o, d, h) in [(x, dx, hx), (z, dz, hz)] {
        let beyond = |h: N| N::sum([[o, dy], [-y, d], [h, dy]]).sign();
        let (above, below) = (beyond(-h)?, beyond(h)?);
        if above == below && above != Ordering::Equal {
            return Some(Intersection::Miss);
        }
    }
    crossing(Fraction { n: -y, e: dy }, climb, range)
}
