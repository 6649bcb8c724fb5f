//! Cuboids and rectangles.
//!
//! A cuboid is what three slabs between parallel planes have in common, and the line's interval in it is what the
//! intervals in the slabs have in common (Kay and Kajiya, *Ray Tracing Complex Scenes*, 1986).

use super::attempt::{Attempt, Stop, known};
use super::end::{End, Flat, Fraction, Goal, Interval, Of, Place, inwards, solid, span, times};
use super::flat::crossing;
use super::local_ray::LocalRay;
use crate::intersection::Intersection;
use crate::number::{Difference, Estimate, Number, Ring};
use crate::part::{FACES, Part};
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// Where the line crosses the plane of a face: `t = (bound - o) / d` of the coordinates across it.
#[derive(Clone, Copy)]
struct Crossed<N: Number> {
    bound: N,
    o: N,
    d: N,
    /// The parameter; zero in wide numbers, which are compared without it.
    t: N::Estimate,
    /// The number of the face's axis in the order of [`FACES`], or of a face among those that own edges.
    rank: usize,
    part: Part,
}

impl<N: Number> Crossed<N> {
    #[inline(always)]
    fn new(bound: N, o: N, d: N, (rank, part): (usize, Part)) -> Self {
        let t = if N::IS_WIDE { N::Estimate::ZERO } else { (bound - o).estimate().over(d.estimate()) };
        Self { bound, o, d, t, rank, part }
    }

    #[inline(always)]
    fn end(self, part: Part) -> End<N> {
        let t = Fraction { n: self.bound - self.o, e: self.d };
        if N::IS_WIDE { End::at(t, part) } else { End { place: Place::At(t), t: self.t, part } }
    }

    /// How it compares with another. Wide numbers decide by one sum of products, so that the start of a far line
    /// cancels before any rounding.
    #[inline(always)]
    fn order(&self, other: &Self) -> Attempt<Ordering> {
        known(if N::IS_WIDE { self.order_by_signs(other) } else { N::order_of_crossings(self.t, other.t) })
    }

    fn order_by_signs(&self, other: &Self) -> Option<Ordering> {
        let sum = N::sum([[self.bound, other.d], [-self.o, other.d], [-other.bound, self.d], [other.o, self.d]]);
        Some(times(sum.sign()?, times(self.d.sign()?, other.d.sign()?)))
    }
}

/// The interval of the line in the slabs, as far as it has been clipped. A missing end is infinite.
#[derive(Clone, Copy)]
pub(super) struct Clipped<N: Number> {
    enter: Option<Crossed<N>>,
    exit: Option<Crossed<N>>,
    /// The first face whose plane the line lies in.
    along: Option<(usize, Part)>,
}

impl<N: Number> Clipped<N> {
    /// The whole line.
    #[inline(always)]
    pub(super) const fn everywhere() -> Self {
        Self { enter: None, exit: None, along: None }
    }

    /// The interval of the line with every coordinate at most that of `half` in magnitude; a miss if there is none.
    #[inline(always)]
    fn new(line: &LocalRay<N>, half: [N; 3]) -> Attempt<Self> {
        let mut clipped = Self::everywhere();
        let ([x, y, z], [dx, dy, dz], [hx, hy, hz]) = (line.origin, line.direction, half);
        clipped.clip(line, 0, [x, dx, hx])?;
        clipped.clip(line, 1, [z, dz, hz])?;
        clipped.clip(line, 2, [y, dy, hy])?;
        Ok(clipped)
    }

    /// Clips by the slab `|o + t d| <= h`. If two planes are crossed at the same `t`, the first one counts. The start
    /// of a line that departs from a face is taken to lie on it and between all others, and there is no entry.
    #[inline(always)]
    fn clip(&mut self, line: &LocalRay<N>, rank: usize, [o, d, h]: [N; 3]) -> Attempt<()> {
        let departs = line.departs();
        let [low, high] = FACES[rank];
        let (enter, exit) = match known(d.sign())? {
            Ordering::Greater => ((low, -h), (high, h)),
            Ordering::Less => ((high, h), (low, -h)),
            Ordering::Equal => {
                let along = lies_between(line, [low, high], [o, h])?;
                self.along = self.along.or(along.map(|part| (rank, part)));
                return Ok(());
            }
        };
        let crossed = |(part, bound): (Part, N)| {
            if line.departs_from(part) {
                return Crossed::new(N::ZERO, N::ZERO, N::ONE, (rank, part));
            }
            Crossed::new(bound, o, d, (rank, part))
        };
        if !departs {
            self.enter = later(self.enter, crossed(enter), Ordering::Greater)?;
        }
        self.exit = later(self.exit, crossed(exit), Ordering::Less)?;
        Ok(())
    }

    /// Clips by the half-space `value + slope t <= 0`, that of a face in the order of those that own edges, as
    /// [`Clipped::clip`] does by two of them.
    #[inline(always)]
    pub(super) fn by_half_space(
        &mut self,
        line: &LocalRay<N>,
        [value, slope]: [N; 2],
        (rank, part): (usize, Part),
    ) -> Attempt<()> {
        let crossed = || {
            if line.departs_from(part) {
                return Crossed::new(N::ZERO, N::ZERO, N::ONE, (rank, part));
            }
            Crossed::new(N::ZERO, value, slope, (rank, part))
        };
        match known(slope.sign())? {
            Ordering::Greater => self.exit = later(self.exit, crossed(), Ordering::Less)?,
            Ordering::Less if line.departs() => {}
            Ordering::Less => self.enter = later(self.enter, crossed(), Ordering::Greater)?,
            Ordering::Equal if line.departs_from(part) => self.along = self.along.or(Some((rank, part))),
            Ordering::Equal => match known(value.sign())? {
                Ordering::Greater if !line.departs() => return Err(Stop::Miss),
                Ordering::Equal => self.along = self.along.or(Some((rank, part))),
                _ => {}
            },
        }
        Ok(())
    }

    /// Where it leaves.
    #[inline(always)]
    pub(super) fn exit(&self) -> End<N> {
        self.end(self.exit, End::never_left)
    }

    /// An end with its part: that of the first face that holds it.
    #[inline(always)]
    fn end(&self, end: Option<Crossed<N>>, missing: fn() -> End<N>) -> End<N> {
        let Some(crossed) = end else { return missing() };
        let part = self.along.filter(|(along, _)| *along < crossed.rank).map_or(crossed.part, |(_, part)| part);
        crossed.end(part)
    }

    /// The interval; a miss if it is empty.
    #[inline(always)]
    pub(super) fn interval(&self) -> Attempt<Interval<N>> {
        let enter = self.end(self.enter, End::never_entered);
        let exit = self.exit();
        let (Some(first), Some(last)) = (&self.enter, &self.exit) else {
            return Ok(Interval { enter, exit, touch: false });
        };
        match first.order(last)? {
            Ordering::Greater => Err(Stop::Miss),
            Ordering::Less => Ok(Interval { enter, exit, touch: false }),
            // The interval is one point of an edge.
            Ordering::Equal => {
                let end = if first.rank < last.rank { enter } else { exit };
                Ok(Interval { enter: end, exit: end, touch: true })
            }
        }
    }
}

/// A line parallel to a slab: the face whose plane it lies in; a miss if it lies outside.
#[cold]
#[inline(never)]
fn lies_between<N: Number>(line: &LocalRay<N>, [low, high]: [Part; 2], [o, h]: [N; 2]) -> Attempt<Option<Part>> {
    let departed = [low, high].into_iter().find(|part| line.departs_from(*part));
    Ok(match departed {
        None => match (known((o + h).sign())?, known((o - h).sign())?) {
            (Ordering::Less, _) | (_, Ordering::Greater) if !line.departs() => return Err(Stop::Miss),
            (Ordering::Equal, _) => Some(low),
            (_, Ordering::Equal) => Some(high),
            _ => None,
        },
        own => own,
    })
}

/// `new` if it compares with `own` as `counts` says, otherwise `own`.
#[inline(always)]
fn later<N: Number>(own: Option<Crossed<N>>, new: Crossed<N>, counts: Ordering) -> Attempt<Option<Crossed<N>>> {
    Ok(match own {
        Some(own) if new.order(&own)? != counts => Some(own),
        _ => Some(new),
    })
}

/// The cuboid about the origin with these half extents.
#[inline(always)]
pub(crate) fn cuboid<S: Scalar, N: Of<S>>(line: &LocalRay<N>, half: [S; 3], goal: Goal<S>) -> Attempt<Intersection<S>> {
    let clipped = Clipped::new(line, half.map(N::scalar))?;
    if line.departs() {
        return inwards(&Flat, line, &clipped.exit(), goal.range);
    }
    solid(&Flat, line, &clipped.interval()?, goal)
}

/// The rectangle about the origin with these half extents along x and z, in the plane `y = 0`.
///
/// Times `dy`, the coordinates of the point where the line crosses the plane are components of its Pluecker moment.
#[inline(always)]
pub(crate) fn rectangle<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    half: [S; 2],
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let ([x, y, z], [dx, dy, dz], [hx, hz]) = (line.origin, line.direction, half.map(N::scalar));
    let climb = known(dy.sign_among(Difference::Signs, || N::ONE))?;
    if climb == Ordering::Equal {
        return chord_of_rectangle(line, [hx, hz], goal);
    }
    for (o, d, h) in [(x, dx, hx), (z, dz, hz)] {
        let w = N::sum([[o, dy], [-y, d]]);
        let rim = h * dy;
        // The error of the sums is less than eight roundings of these.
        let terms = || (o * dy).magnitude() + (y * d).magnitude() + rim.magnitude();
        let side = |w: N| known(w.sign_among(Difference::Edges, terms));
        let (above, below) = (side(w - rim)?, side(w + rim)?);
        if above == below && above != Ordering::Equal {
            return Err(Stop::Miss);
        }
    }
    crossing(line, Fraction { n: -y, e: dy }, climb, goal)
}

/// A line parallel to the plane of a rectangle.
#[cold]
#[inline(never)]
fn chord_of_rectangle<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    [hx, hz]: [N; 2],
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if known(line.origin[1].sign())? != Ordering::Equal {
        return Err(Stop::Miss);
    }
    let overlap = Clipped::new(line, [hx, N::ZERO, hz])?.interval()?;
    let overlap = Interval { enter: overlap.enter.of_side(), exit: overlap.exit.of_side(), ..overlap };
    Ok(Intersection::LiesIn(span(&Flat, line, &overlap, goal.range)?))
}
