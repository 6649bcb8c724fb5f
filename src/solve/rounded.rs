//! Rounded cuboids: all points within a radius of a cuboid about the origin, the core.
//!
//! The excess of a coordinate is how far it is beyond the core along its axis; it is zero between the core's planes.
//! The square of the distance from the core is the sum of the squares of the excesses (Arvo, *A Simple Method for
//! Box-Sphere Intersection Testing*, in *Graphics Gems*, 1990). Along a line that is a convex function with a
//! continuous slope, and quadratic between the crossings of the core's planes, where it is that of a face, an edge or a
//! corner. So an end of the line's interval is found piece by piece, from where the line crosses the box around all: it
//! lies in the first piece at whose other end the distance is at most the radius, or grows.

use super::attempt::{Attempt, Stop, known};
use super::end::{Curve, End, Flat, Fraction, Goal, Of, inwards, settled, times};
use super::local_ray::LocalRay;
use super::quadratic::{Inside, Quadratic};
use super::quadric::{Ball, Quadric};
use super::roots::RootOfQuadric;
use super::surface::Line;
use crate::equations::{Region, axis_of_face};
use crate::hit::Crossing;
use crate::intersection::{Intersection, Span};
use crate::number::{Number, Ring};
use crate::part::{Part, face_of};
use crate::ray::Leaving;
use crate::scalar::{FromScalar, Scalar};
use crate::vector::{component, pairs, with_component};
use core::cmp::Ordering;

/// All points within `radius` of the cuboid with these half extents.
#[inline(always)]
pub(crate) fn rounded_cuboid<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    half: [S; 3],
    radius: S,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let solid = Beside::new(line, half.map(N::scalar), N::scalar(radius))?;
    if line.departs() {
        let found = match solid.end(solid.outermost(false)?, false) {
            Err(Stop::Miss) => Found::start(),
            found => found?,
        };
        return inwards(&found, line, &found.end, goal.range);
    }
    let [first, last] = solid.around()?;
    let found = solid.end(first, true)?;
    let enter = settled(&found, line, &found.end, goal.range)?;
    if found.touch {
        return Ok(Intersection::One(Span::joined(enter, enter, true)));
    }
    if goal.since.is_some_and(|since| enter.t >= since) {
        return Ok(Intersection::Entered(enter));
    }
    match solid.end(last, false).and_then(|found| settled(&found, line, &found.end, goal.range)) {
        Ok(exit) => Ok(Intersection::One(Span::joined(enter, exit, false))),
        // Rounded signs contradict each other: the line touches.
        Err(Stop::Miss) if N::IS_WIDE => Ok(Intersection::One(Span::joined(enter, enter, true))),
        Err(_) if enter.t.is_finite() && !N::IS_WIDE => Ok(Intersection::Entered(enter)),
        Err(_) => Err(Stop::Unsure),
    }
}

/// The end of the interval of a line that is hit; `None` if the number does not know a sign.
#[inline(never)]
pub(crate) fn end_at<S: Scalar, N: FromScalar<S> + Number>(
    half: [S; 3],
    radius: S,
    crossing: Crossing,
    line: &Line<N>,
    departed: Option<Part>,
) -> Option<Found<N>> {
    let departure = departed.map(|part| (part, Leaving::Inwards));
    let line = LocalRay::new([line.origin, line.direction], departure);
    let solid = Beside::new(&line, half.map(N::scalar), N::scalar(radius)).ok()?;
    let enters = crossing != Crossing::Exit;
    match solid.outermost(enters).and_then(|outermost| solid.end(outermost, enters)) {
        Err(Stop::Miss) if departed.is_some() => Some(Found::start()),
        found => found.ok(),
    }
}

/// The region of a point beside the cuboid with these half extents; `None` if the number does not know a sign.
pub(crate) fn region_at<N: Number>(point: [N; 3], half: [N; 3]) -> Option<Region> {
    let [x, y, z] = pairs(point, half).map(|(p, h)| side_of(p + h, p - h));
    Some([x?, y?, z?])
}

/// On which side of two planes a coordinate is, of which it is that far above the lower and the upper one. The planes
/// belong to what is between them.
fn side_of<N: Number>(over: N, above: N) -> Option<Ordering> {
    if over.sign()? == Ordering::Less {
        return Some(Ordering::Less);
    }
    Some(if above.sign()? == Ordering::Greater { Ordering::Greater } else { Ordering::Equal })
}

/// A coordinate along a line.
#[derive(Clone, Copy)]
struct Axis<N> {
    /// That of the line's origin, relative to the core's lower and upper plane.
    over: N,
    above: N,
    /// How fast it grows.
    d: N,
}

impl<N: Ring> Axis<N> {
    #[inline(always)]
    fn new(o: N, d: N, half: N) -> Self {
        Self { over: o + half, above: o - half, d }
    }
    #[inline(always)]
    fn relative_to(&self, side: Ordering) -> N {
        if side == Ordering::Less { self.over } else { self.above }
    }
    /// Where the line crosses the core's plane on a side.
    #[inline(always)]
    fn plane(&self, side: Ordering) -> Fraction<N> {
        Fraction { n: -self.relative_to(side), e: self.d }
    }
    /// Where it crosses the plane at the distance `r` from that.
    #[inline(always)]
    fn outer(&self, side: Ordering, r: N) -> Fraction<N> {
        let r = if side == Ordering::Less { -r } else { r };
        Fraction { n: r - self.relative_to(side), e: self.d }
    }
}

/// The ball about the point of the core that is nearest to all points of a region: that of a corner; a cylinder about
/// an edge or two planes at a face, whose other excesses are zero.
#[inline(always)]
fn ball<N: Ring>(axes: [Axis<N>; 3], r: N, region: Region) -> Ball<N> {
    let [[x, dx], [y, dy], [z, dz]] = pairs(axes, region).map(|(axis, side)| match side {
        Ordering::Equal => [N::ZERO; 2],
        side => [axis.relative_to(side), axis.d],
    });
    Ball { o: [x, y, z], d: [dx, dy, dz], r }
}

/// The same for the line `o + t d` and a core with these half extents.
#[inline(always)]
pub(super) fn piece<N: Ring>(o: [N; 3], d: [N; 3], half: [N; 3], r: N, region: Region) -> Ball<N> {
    ball(pairs(o, pairs(d, half)).map(|(o, (d, half))| Axis::new(o, d, half)), r, region)
}

/// An end of the line's interval: where it crosses the plane of a face or passes from one piece to another, or a root
/// of a piece.
pub(crate) struct Found<N: Number> {
    end: End<N>,
    /// The line only touches the solid there.
    touch: bool,
    piece: Option<Quadratic<N, Ball<N>>>,
    region: Region,
}

impl<N: Number> Found<N> {
    /// Of a line that departs and is outside by its rounded coordinates.
    fn start() -> Self {
        Self { end: End::start(Part::Side), touch: false, piece: None, region: [Ordering::Equal; 3] }
    }
    /// Its approximate parameter.
    pub(crate) const fn t(&self) -> N::Estimate {
        self.end.t
    }
    /// On which sides of the core's planes it is.
    pub(crate) const fn region(&self) -> Region {
        self.region
    }
    /// The root of the equation of its face, edge or corner.
    pub(super) fn root(&self) -> RootOfQuadric<N> {
        let f = self.piece.as_ref().map_or([N::ZERO; 3], Quadratic::coefficients);
        RootOfQuadric::new(f, self.end.place)
    }
}

impl<N: Number> Curve<N> for Found<N> {
    fn order_by_signs(&self, end: &End<N>, t: Fraction<N>) -> Option<Ordering> {
        match &self.piece {
            Some(piece) => piece.order_by_signs(end, t),
            None => Flat.order_by_signs(end, t),
        }
    }
}

/// A plane that a line crosses: its axis, and where.
type Plane<N> = (usize, Fraction<N>);

/// A line beside the core.
struct Beside<'a, N: Number> {
    line: &'a LocalRay<N>,
    axes: [Axis<N>; 3],
    /// The sign of the growth along each axis.
    growth: Region,
    r: N,
    /// The region of the edge or corner from which the line departs.
    own: Option<Region>,
}

impl<'a, N: Number> Beside<'a, N> {
    /// A line that departs from a face, or from the rest at a point over a face, is taken to start in that plane; its
    /// coordinates relative to all others are what they are.
    #[inline(always)]
    fn new(line: &'a LocalRay<N>, half: [N; 3], r: N) -> Attempt<Self> {
        let axes = pairs(line.origin, pairs(line.direction, half)).map(|(o, (d, half))| Axis::new(o, d, half));
        let [x, y, z] = line.direction.map(|d| known(d.sign()));
        let mut solid = Self { line, axes, growth: [x?, y?, z?], r, own: None };
        if line.departs() {
            solid.depart(half)?;
        }
        Ok(solid)
    }

    #[cold]
    #[inline(never)]
    fn depart(&mut self, half: [N; 3]) -> Attempt<()> {
        for (axis, side) in (0..3).flat_map(|axis| [(axis, Ordering::Less), (axis, Ordering::Greater)]) {
            if self.line.departs_from(face_of(axis, side)) {
                self.start_in(axis, side);
                return Ok(());
            }
        }
        let region = known(region_at(self.line.origin, half))?;
        match axis_of_face(region) {
            Some(axis) => self.start_in(axis, component(region, axis)),
            None => self.own = (region != [Ordering::Equal; 3]).then_some(region),
        }
        Ok(())
    }

    /// The start is in the plane of a face.
    fn start_in(&mut self, axis: usize, side: Ordering) {
        let (own, r) = (component(self.axes, axis), self.r);
        let moved = if side == Ordering::Less { Axis { over: -r, ..own } } else { Axis { above: r, ..own } };
        self.axes = with_component(self.axes, axis, moved);
    }

    /// Each axis, with the side from which the line comes along it; or, against its direction, to which it goes.
    #[inline(always)]
    fn with_outside(&self, enters: bool) -> [(Axis<N>, Ordering); 3] {
        pairs(self.axes, self.growth.map(|growth| if enters { growth.reverse() } else { growth }))
    }

    /// The planes by which the line enters and leaves the box around the solid; a miss if it passes that.
    #[inline(always)]
    fn around(&self) -> Attempt<[Plane<N>; 2]> {
        for (axis, growth) in pairs(self.axes, self.growth) {
            let is_beyond = || {
                let below = known((axis.over + self.r).sign())? == Ordering::Less;
                Ok(below || known((axis.above - self.r).sign())? == Ordering::Greater)
            };
            if growth == Ordering::Equal && is_beyond()? {
                return Err(Stop::Miss);
            }
        }
        let ends @ [(_, enter), (_, exit)] = [self.outermost(true)?, self.outermost(false)?];
        if known(enter.order(exit))? == Ordering::Greater { Err(Stop::Miss) } else { Ok(ends) }
    }

    /// True if the line comes to `t` after `other`, going inwards from this end.
    #[inline(always)]
    fn is_later(t: Fraction<N>, other: Fraction<N>, enters: bool) -> Attempt<bool> {
        Ok(known(t.order(other))? == if enters { Ordering::Greater } else { Ordering::Less })
    }

    /// The last of the planes around the solid by which the line enters the box, or the first by which it leaves.
    #[inline(always)]
    fn outermost(&self, enters: bool) -> Attempt<Plane<N>> {
        let mut last = None;
        for (i, (axis, outside)) in self.with_outside(enters).into_iter().enumerate() {
            if outside == Ordering::Equal {
                continue;
            }
            let crossing = axis.outer(outside, self.r);
            last = match last {
                Some((_, own)) if !Self::is_later(crossing, own, enters)? => last,
                _ => Some((i, crossing)),
            };
        }
        last.ok_or(Stop::Unsure)
    }

    /// The region of the line's point on the plane of a face.
    #[inline(always)]
    fn region_on(&self, face: usize, t: Fraction<N>, enters: bool) -> Attempt<Region> {
        let mut region = [Ordering::Equal; 3];
        for (i, (side, (axis, outside))) in region.iter_mut().zip(self.with_outside(enters)).enumerate() {
            *side = if outside == Ordering::Equal {
                known(side_of(axis.over, axis.above))?
            } else if i == face || Self::is_later(axis.plane(outside), t, enters)? {
                outside
            } else if Self::is_later(t, axis.plane(outside.reverse()), enters)? {
                outside.reverse()
            } else {
                Ordering::Equal
            };
        }
        Ok(region)
    }

    /// The next of the core's planes that the line crosses.
    #[inline(always)]
    fn next(&self, region: Region, enters: bool) -> Attempt<Option<Plane<N>>> {
        let mut next = None;
        for (i, ((axis, outside), own)) in pairs(self.with_outside(enters), region).into_iter().enumerate() {
            let side = if own == outside { outside } else { outside.reverse() };
            if outside == Ordering::Equal || own == outside.reverse() {
                continue;
            }
            let crossing = axis.plane(side);
            next = match next {
                Some((_, own)) if !Self::is_later(own, crossing, enters)? => next,
                _ => Some((i, crossing)),
            };
        }
        Ok(next)
    }

    /// The region beyond the next plane across an axis.
    fn advanced(&self, region: Region, axis: usize, enters: bool) -> Region {
        let (_, outside) = component(self.with_outside(enters), axis);
        let is_outside = component(region, axis) == outside;
        with_component(region, axis, if is_outside { Ordering::Equal } else { outside.reverse() })
    }

    /// The entry into the solid, or the exit; the line crosses the box around it there. A miss if the line passes it.
    fn end(&self, (axis, t): Plane<N>, enters: bool) -> Attempt<Found<N>> {
        N::apart(
            #[inline(always)]
            || {
                let mut region = self.region_on(axis, t, enters)?;
                if let Some(axis) = axis_of_face(region) {
                    let end = End::at(t, face_of(axis, component(region, axis)));
                    return Ok(Found { end, touch: false, piece: None, region });
                }
                loop {
                    let ball = ball(self.axes, self.r, region);
                    let Some((axis, t)) = self.next(region, enters)? else { return self.root(ball, region, enters) };
                    let falls = if enters { Ordering::Less } else { Ordering::Greater };
                    let sign = known(self.sign_at(&ball, region, t))?;
                    if sign == Ordering::Less {
                        return self.root(ball, region, enters);
                    }
                    match (sign, known(slope_at(&ball, t))?) {
                        (Ordering::Greater, slope) if slope == falls => region = self.advanced(region, axis, enters),
                        (Ordering::Equal, slope) if slope != falls.reverse() => {
                            return self.seam(&ball, region, t, enters);
                        }
                        // It was nearest within the piece.
                        _ => return self.root(ball, region, enters),
                    }
                }
            },
        )
    }

    /// The sign of a piece's function at `t`. If the line departs from the piece, the start is a root.
    #[inline(always)]
    fn sign_at(&self, ball: &Ball<N>, region: Region, t: Fraction<N>) -> Option<Ordering> {
        if self.own == Some(region) {
            let k = ball.k();
            return Some(times(t.n.sign()?, N::sum([[ball.a(), t.n], [k + k, t.e]]).sign()?));
        }
        ball.at(t.n, t.e).sign()
    }

    /// The root of a piece.
    #[inline(always)]
    fn root(&self, ball: Ball<N>, region: Region, enters: bool) -> Attempt<Found<N>> {
        let piece = Quadratic::new(ball, self.line, self.own == Some(region))?;
        let Inside::Between(touch) = piece.inside else { return Err(Stop::Miss) };
        let [first, second] = piece.ends();
        Ok(Found { end: if enters { first } else { second }, touch, piece: Some(piece), region })
    }

    /// The end is where one piece passes into another, or, along several axes, into a third. Its own region is that of
    /// the closed pieces that hold it which is beyond the core along the fewest axes.
    #[cold]
    #[inline(never)]
    fn seam(&self, piece: &Ball<N>, region: Region, t: Fraction<N>, enters: bool) -> Attempt<Found<N>> {
        let (mut own, mut beyond) = (region, region);
        for (((axis, outside), own), beyond) in self.with_outside(enters).into_iter().zip(&mut own).zip(&mut beyond) {
            let is_at = |side| Ok(known(axis.plane(side).order(t))? == Ordering::Equal);
            if outside == Ordering::Equal {
                continue;
            }
            if *own == outside && is_at(outside)? {
                [*own, *beyond] = [Ordering::Equal; 2];
            }
            if *own == Ordering::Equal && is_at(outside.reverse())? {
                *beyond = outside.reverse();
            }
        }
        // The distance grows on both sides, unless the piece beyond is as far from the core everywhere.
        let is_lowest = known(slope_at(piece, t))? == Ordering::Equal;
        let touch = is_lowest && known(ball(self.axes, self.r, beyond).a().sign())? != Ordering::Equal;
        let part = axis_of_face(own).map_or(Part::Side, |axis| face_of(axis, component(own, axis)));
        Ok(Found { end: End::at(t, part), touch, piece: None, region: own })
    }
}

/// The sign of the slope of a piece's function at `t`.
#[inline(always)]
fn slope_at<N: Number>(ball: &Ball<N>, t: Fraction<N>) -> Option<Ordering> {
    Some(times(N::sum([[ball.a(), t.n], [ball.k(), t.e]]).sign()?, t.e.sign()?))
}
