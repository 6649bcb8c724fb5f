//! Balls around the objects of a scene, in integers, and those that a ray may meet.
//!
//! All coordinates are from the eye, along the world's axes. The line through `p` in the unit direction `d` passes the
//! centre `c` at the distance `|(c - p) x d|`, and is closest to it at `t = (c - p) . d`. (The cross product has the
//! digits that `|c - p|^2 - t^2` cancels.)
//!
//! Lengths are rounded to [`BITS`] bits, and the ball is larger by as much as that may change. All else is exact in 32
//! bits: a test takes some 50 instructions on a chip without any but short products, and needs no root.

use super::{Light, Scene};
use crate::number::machine::leading_zeros_of_64;
use crate::number::{Parts, dot};
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar, largest};
use crate::shape::Shape;
use crate::shape::kinds::Kinds;
use crate::vector::{UnitVec3, Vec3, cross, pairs};

/// The most objects that have a ball; all others may be met by any ray. A picture of more needs a hierarchy.
pub(crate) const MOST: usize = 16;

/// The bits of a length.
pub(super) const BITS: i32 = 14;

/// The fraction bits of a direction.
const DIRECTION: u32 = 15;

/// The bits of a ray's origin, before its unit is that of a ball.
const ORIGIN: i32 = 30;

/// A set of objects of a scene, among which all are that a ray may meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Candidates {
    /// Bit `i` is object `i`.
    first: u16,
}

impl Candidates {
    /// All objects.
    pub(crate) const ALL: Self = Self { first: u16::MAX };
    /// No object, of at most [`MOST`].
    pub(crate) const NONE: Self = Self { first: 0 };

    /// True if the ray may meet the object of this index.
    #[inline(always)]
    pub(crate) fn contain(self, object: u32) -> bool {
        object >= MOST as u32 || self.first & (1 << object) != 0
    }

    /// With one of the first [`MOST`] objects.
    #[must_use]
    pub(crate) fn with(self, object: u32) -> Self {
        Self { first: self.first | 1 << (object % MOST as u32) }
    }

    /// These and those.
    #[must_use]
    pub(crate) const fn or(self, other: Self) -> Self {
        Self { first: self.first | other.first }
    }

    /// Those that are among these, too.
    #[must_use]
    pub(crate) const fn and(self, those: Self) -> Self {
        Self { first: self.first & those.first }
    }

    /// True if those are among these.
    pub(crate) const fn include(self, those: Self) -> bool {
        those.first & !self.first == 0
    }

    /// True if there are none.
    pub(crate) const fn are_none(self) -> bool {
        self.first == 0
    }

    /// The first one of the first [`MOST`] objects.
    pub(crate) const fn first(self) -> Option<u32> {
        if self.are_none() { None } else { Some(self.first.trailing_zeros()) }
    }

    /// The only one of the first [`MOST`] objects.
    pub(crate) const fn only(self) -> Option<u32> {
        if self.first.is_power_of_two() { Some(self.first.trailing_zeros()) } else { None }
    }

    /// Removes one of the first [`MOST`] objects.
    pub(super) fn remove(&mut self, object: usize) {
        self.first &= !(1 << object);
    }
}

/// A ball that surely holds a shape: its centre and radius, in units of `2^exponent`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub(super) centre: [i16; 3],
    pub(super) radius: u16,
    exponent: i16,
}

impl Ball {
    /// That of a shape as seen from this place; `None` if none is known.
    pub(crate) fn around<S: Scalar, K: Kinds>(shape: &Shape<S, K>, eye: Vec3<S>) -> Option<Self> {
        Self::seen(around_box(shape)?, eye)
    }

    /// A ball in the world as seen from this place; `None` if that is beyond the type.
    pub(crate) fn seen<S: Scalar>((centre, legs): BallInWorld<S>, eye: Vec3<S>) -> Option<Self> {
        let ([x, y, z], [a, b, c]) = (from(eye, centre), legs);
        let ([x, y, z, a, b, c], exponent) = truncated_all([x, y, z, a, b, c], BITS)?;
        Some(Self { centre: [x, y, z].map(|c| c as i16), radius: radius([a, b, c]) as u16, exponent: exponent as i16 })
    }

    /// The exponent of its unit.
    pub(crate) fn exponent(&self) -> i32 {
        self.exponent.into()
    }

    /// True if the ray may meet it.
    #[inline(always)]
    fn may_be_met(&self, line: &Line) -> bool {
        // Both in the coarser unit, in which neither has more than BITS bits.
        let exponent = i32::from(self.exponent).max(line.exponent + ORIGIN - BITS);
        let shift = |by: i32| by.min(31) as u32;
        let (of_ball, of_line) = (shift(exponent - i32::from(self.exponent)), shift(exponent - line.exponent));
        let [x, y, z] = pairs(self.centre, line.p).map(|(c, p)| (i32::from(c) >> of_ball) - (p >> of_line));
        let [dx, dy, dz] = line.d;
        // By Cauchy-Schwarz no sum of products is longer than |c - p| |d|, which is below 2^31. Coordinates of `c - p`
        // are off by less than 2, of `d` by less than a unit, and of the results by less than 1: in all that moves the
        // line by less than 9.
        let reach = (i32::from(self.radius) >> of_ball) + 10;
        // Most balls are passed on one of the axes.
        let (mut left, limit) = (reach * reach, reach as u32);
        for [a, b, c, d] in [[y, z, dy, dz], [z, x, dz, dx], [x, y, dx, dy]] {
            let off = (a * d - b * c) >> DIRECTION;
            if off.unsigned_abs() > limit {
                return false;
            }
            left -= off * off;
        }
        left >= 0 && (x * dx + y * dy + z * dz) >> DIRECTION >= -reach
    }

    /// The same in floats of a chip that has instructions for them, where that takes half as many as integers do.
    #[inline(always)]
    fn may_be_met_in_numbers<R: Real>(&self, p: [R; 3], d: [R; 3]) -> bool {
        let unit = R::ONE.scaled(i32::from(self.exponent));
        let e = pairs(self.centre, p).map(|(c, p)| R::from_int(c.into()) * unit - p);
        let [x, y, z] = e.map(R::abs);
        // The centre is off by less than 2, and the line by some millionths of its length.
        let reach = R::from_int(i32::from(self.radius) + 2) * unit + (x + y + z).scaled(-20);
        let ([x, y, z], [dx, dy, dz]) = (e, d);
        let [u, v, w] = [y * dz - z * dy, z * dx - x * dz, x * dy - y * dx];
        // The ball may be met, too, where its unit is too small for the type, or a square is infinite.
        let passes = u * u + v * v + w * w > reach * reach || x * dx + y * dy + z * dz < -reach;
        unit == R::ZERO || !passes
    }
}

/// The line of a ray.
struct Line {
    /// In units of `2^exponent`, of [`ORIGIN`] bits.
    p: [i32; 3],
    exponent: i32,
    /// In units of `2^-DIRECTION`.
    d: [i32; 3],
}

impl Line {
    /// `None` if the point is beyond the type.
    #[inline(always)]
    fn new<S: Scalar>(p: [S; 3], d: [S::Unit; 3]) -> Option<Self> {
        let d = d.map(|c| S::unit_parts(c).truncated(DIRECTION as i32));
        if p == [S::ZERO; 3] {
            return Some(Self { p: [0; 3], exponent: i32::from(i16::MIN), d });
        }
        let (p, exponent) = truncated_all(p, ORIGIN)?;
        Some(Self { p, exponent, d })
    }
}

/// The balls around the first objects of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Balls {
    balls: [Option<Ball>; MOST],
    /// How many of them are of objects; none if no object has a ball.
    count: u8,
}

impl Balls {
    /// Those of a scene, from its camera. None if it has a hierarchy, which finds candidates at less cost.
    pub(crate) fn of<S: Scalar, T, K: Kinds>(scene: &Scene<'_, S, T, K>) -> Self {
        let objects = if scene.hierarchy.is_none() { scene.objects } else { &[] };
        Self::around(objects.iter().map(|object| &object.shape), scene.camera.position())
    }

    /// Those around these shapes, as seen from this place.
    pub(crate) fn around<'a, S: Scalar, K: Kinds + 'a>(
        shapes: impl Iterator<Item = &'a Shape<S, K>>,
        eye: Vec3<S>,
    ) -> Self {
        Self::these(shapes.map(|shape| Ball::around(shape, eye)))
    }

    /// These, of the first objects of a list.
    pub(crate) fn these(those: impl Iterator<Item = Option<Ball>>) -> Self {
        let (mut balls, mut count) = ([None; MOST], 0);
        for (ball, that) in balls.iter_mut().zip(those) {
            *ball = that;
            count += 1;
        }
        Self { balls, count: if balls.iter().all(Option::is_none) { 0 } else { count } }
    }

    /// Those of the first objects, in their order.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Option<Ball>> {
        self.balls.iter().take(usize::from(self.count))
    }

    /// True if no object has one.
    pub(super) fn are_none(&self) -> bool {
        self.count == 0
    }

    /// The objects that a ray from anywhere may meet.
    pub(crate) fn met_by<S: Scalar>(&self, ray: &Ray<S>, eye: Vec3<S>) -> Candidates {
        if self.are_none() || ray.range().start() < S::ZERO {
            Candidates::ALL
        } else if S::Real::HAS_INSTRUCTIONS {
            self.met_in_numbers(ray, eye)
        } else {
            self.met_in_integers(ray, eye)
        }
    }

    /// The same of a ray that starts at `t = 0` or later.
    #[inline(always)]
    pub(super) fn met_in_integers<S: Scalar>(&self, ray: &Ray<S>, eye: Vec3<S>) -> Candidates {
        match Line::new::<S>(from(eye, ray.origin()), ray.direction().to_array()) {
            Some(line) => self.of_which(|ball| ball.may_be_met(&line)),
            None => Candidates::ALL,
        }
    }

    /// The same.
    #[inline(always)]
    pub(super) fn met_in_numbers<S: Scalar>(&self, ray: &Ray<S>, eye: Vec3<S>) -> Candidates {
        let (p, d) = (from(eye, ray.origin()).map(S::real), ray.direction().real());
        self.of_which(|ball| ball.may_be_met_in_numbers(p, d))
    }

    /// All objects but those whose balls are not met.
    #[inline(always)]
    fn of_which(&self, is_met: impl Fn(&Ball) -> bool) -> Candidates {
        let mut candidates = Candidates::ALL;
        for (index, ball) in self.iter().enumerate() {
            if ball.as_ref().is_some_and(|ball| !is_met(ball)) {
                candidates.remove(index);
            }
        }
        candidates
    }
}

/// True if two balls have no point in common.
pub(crate) fn are_apart<S: Scalar>((a, r): BallInWorld<S>, (b, s): BallInWorld<S>) -> bool {
    let square = |legs: [S::Real; 3]| legs.into_iter().fold(S::Real::ZERO, |sum, leg| sum + leg * leg);
    let [r, s] = [r, s].map(|legs| square(legs.map(S::real)));
    // |a - b|^2 > (r + s)^2 without roots, and more than rounding may matter.
    let apart = square(pairs(a.real(), b.real()).map(|(a, b)| a - b));
    let rest = apart - r - s;
    rest > S::Real::ZERO && rest * rest > (r * s).scaled(2) + (rest * rest).scaled(-8)
}

/// True if a shadow of the first ball may fall on the second in this light: if its centre is no farther from the line
/// between the centre of the second and the light than the sum of both radii.
pub(crate) fn may_shade<S: Scalar>((a, r): BallInWorld<S>, (b, s): BallInWorld<S>, light: &Light<S>) -> bool {
    let length = |legs: [S; 3]| dot(legs.map(S::real), legs.map(S::real)).sqrt();
    let close = length(r) + length(s);
    let square = close * close + (close * close).scaled(-8);
    // The squares of floats so small have no digits.
    if square <= S::Real::SMALLEST.scaled(24) {
        return true;
    }
    let from = |p: [S::Real; 3], q: [S::Real; 3]| pairs(p, q).map(|(p, q)| p - q);
    let is_close = |v: [S::Real; 3]| dot(v, v) <= square;
    let (occluder, lamp) = (from(a.real(), b.real()), light.position.real());
    let way = if light.distant { lamp } else { from(lamp, b.real()) };
    let Some(towards) = UnitVec3::<S>::from_real(way).map(UnitVec3::real) else { return true };
    let (along, whole) = (dot(occluder, towards), dot(way, towards));
    if along <= S::Real::ZERO {
        is_close(occluder)
    } else if !light.distant && along > whole {
        is_close(from(occluder, way))
    } else {
        let beside = cross(occluder, towards);
        // The direction is rounded.
        let doubt = dot(occluder, occluder).scaled(-20);
        dot(beside, beside) <= square + doubt
    }
}

/// A point from the eye; infinite beyond the type.
fn from<S: Scalar>(eye: Vec3<S>, point: Vec3<S>) -> [S; 3] {
    pairs(point.to_array(), eye.to_array()).map(|(point, eye)| point.minus(eye))
}

/// A centre, and lengths whose squares add up to that of a radius.
pub(crate) type BallInWorld<S> = (Vec3<S>, [S; 3]);

/// The same of a combination and of a shape that a matrix places, too: around its box.
pub(crate) fn around_box<S: Scalar, K: Kinds>(shape: &Shape<S, K>) -> Option<BallInWorld<S>> {
    // Of an infinite shape it is not known.
    shape.ball_or_box().map(enlarged).filter(|(_, legs)| legs.iter().all(|leg| leg.is_finite()))
}

/// A ball that holds the shape, whatever the rounding of its centre.
pub(crate) fn around<S: Scalar, K: Kinds>(shape: &Shape<S, K>) -> Option<BallInWorld<S>> {
    shape.ball().map(enlarged)
}

/// Two balls whose convex hull holds the shape, whatever the rounding of their centres.
pub(crate) fn ends<S: Scalar, K: Kinds>(shape: &Shape<S, K>) -> Option<[BallInWorld<S>; 2]> {
    Some(shape.ends()?.map(enlarged))
}

/// The ball, larger by what the rounding of its centre may be.
fn enlarged<S: Scalar>((centre, legs): BallInWorld<S>) -> BallInWorld<S> {
    // The coordinates are off by some units in their last place, which far from the origin may be as large as the
    // shape: by two on each axis in fixed point, where a length is off by one, and by one in floats.
    let farthest = largest(centre.to_array());
    let unit = farthest.next_up().minus(farthest);
    (centre, legs.map(|leg| (0..8).fold(leg, |leg, _| leg.plus(unit))))
}

/// The radius of a ball from lengths whose squares add up to its square, and which have been rounded down.
pub(super) fn radius(legs: [i32; 3]) -> i32 {
    let square = legs.into_iter().map(|leg| (leg + 1) * (leg + 1)).sum::<i32>();
    square.unsigned_abs().isqrt() as i32 + 1
}

/// Lengths in units of `2^exponent`, in which the largest has so many bits, rounded towards zero, and that exponent;
/// `None` if one is infinite, or all are zero.
#[inline(always)]
pub(super) fn truncated_all<S: Scalar, const N: usize>(lengths: [S; N], bits: i32) -> Option<([i32; N], i32)> {
    if !lengths.into_iter().all(S::is_finite) {
        return None;
    }
    let lengths = lengths.map(S::parts);
    // In the unit of the one with the largest exponent, which for fixed point is that of all.
    let exponent = lengths.iter().map(|parts| parts.exponent).max()?;
    let in_unit = |parts: &Parts| parts.mantissa.checked_shr((exponent - parts.exponent) as u32).unwrap_or(0);
    let all = lengths.iter().fold(0, |all, parts| all | in_unit(parts));
    if all == 0 {
        return None;
    }
    let top = exponent + (u64::BITS - leading_zeros_of_64(all)) as i32;
    Some((lengths.map(|length| length.truncated(bits - top)), top - bits))
}

#[cfg(all(units, feature = "fixed"))]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../tests/units/scene/balls.rs"]
mod tests;
