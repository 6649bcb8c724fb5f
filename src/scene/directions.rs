//! The rays of a row of pixels and the balls that they may meet, in integers.
//!
//! In the coordinates of a pinhole camera, to the right, upwards and forwards from the eye, the ray through a pixel has
//! the direction `D = (u, v, f)`: `u` and `v` are the pixel's distances from the middle of the picture, and `f` is how
//! far in front of the eye pixels are as wide as that. It meets the ball of radius `r` about `c` if `c . D > 0` and
//!
//! ```text
//! q = (c . D)^2 - (D . D) (c . c - r^2) >= 0
//! ```
//!
//! Along a row `q` is a quadratic function of the column, so that two additions lead to the next column (forward
//! differences), and the columns with `q >= 0` follow each other. The plane of the row has the normal `n = (0, f, -v)`:
//! there may be no point of the ball within it.
//!
//! In the light at `l` its shadow is the balls about `c + m (c - l)` with the radii `(1 + m) r`, for `m >= 0`; in a
//! distant light towards `l` it is those about `c - m l` with the radius `r`.
//!
//! All lengths are rounded to [`BITS`] bits, so that products of four are below `2^62`, and the ball is larger by as
//! much as that may change; all else is exact in 64 bits.

use super::balls::{BITS, Ball, BallInWorld, around, radius, truncated_all};
use super::{Light, Raster, Size};
use crate::number::dot;
use crate::scalar::{Real, Ring, Scalar};
use crate::shape::Shape;
use crate::shape::kinds::Kinds;
use crate::vector::{UnitVec3, Vec3, pairs};

/// The coordinates of a pinhole camera.
#[derive(Clone, Copy)]
pub(crate) struct View<S: Scalar> {
    eye: Vec3<S>,
    /// To the right, upwards and forwards.
    axes: [UnitVec3<S>; 3],
    /// The same in units of `2^-AXIS`.
    turn: [[i32; 3]; 3],
}

/// The fraction bits of an axis.
const AXIS: u32 = 15;

/// Rays whose cosine with a normal is less than `2^-GRAZING` may miss the plane.
const GRAZING: i32 = 6;

impl<S: Scalar> View<S> {
    /// That of a picture.
    pub(crate) fn of(raster: &Raster<S>) -> Self {
        Self::new(raster.camera().position(), raster.axes())
    }

    /// From an eye, to the right, upwards and forwards.
    pub(crate) fn new(eye: Vec3<S>, axes: [UnitVec3<S>; 3]) -> Self {
        let turn = axes.map(|axis| axis.to_array().map(|c| S::unit_parts(c).truncated(AXIS as i32)));
        Self { eye, axes, turn }
    }

    /// The coordinates of a point, off by no more than a unit of the type and by the rounding of the axes.
    fn coordinates(&self, point: Vec3<S>) -> [S; 3] {
        let from_eye = pairs(point.to_array(), self.eye.to_array()).map(|(point, eye)| point.minus(eye));
        if from_eye.into_iter().all(S::is_finite) {
            self.axes.map(|axis| S::round(S::dot(from_eye, axis.to_array())))
        } else {
            [S::INFINITY; 3]
        }
    }

    /// A ball that surely holds the shape; `None` if none is known.
    pub(crate) fn ball<K: Kinds>(&self, shape: &Shape<S, K>) -> Option<SeenBall> {
        Some(self.seen(&Ball::seen(around(shape)?, self.eye)?))
    }

    /// A ball in these coordinates, with [`BITS`] bits: its centre is off by less than 7 of its units.
    pub(crate) fn seen(&self, Ball { centre, radius, .. }: &Ball) -> SeenBall {
        let [x, y, z] = centre.map(i32::from);
        SeenBall { c: self.turn.map(|[a, b, c]| i64::from((x * a + y * b + z * c) >> AXIS)), r: i64::from(*radius) }
    }

    /// The normal of a plane, away from the eye, in units of `2^-AXIS`: rays that surely go along it meet the plane
    /// within the budget, as [`Directions::go_along`] has it. `None` if the eye is next to the plane, or too far away.
    pub(crate) fn beyond(&self, (on, normal): (Vec3<S>, UnitVec3<S>)) -> Option<[i64; 3]> {
        let from_eye = pairs(on.real(), self.eye.real()).map(|(on, eye)| on - eye);
        let height = dot(from_eye, normal.real());
        let doubt = from_eye.into_iter().fold(S::Real::ZERO, |sum, c| sum + c.abs()).scaled(-8);
        let most = S::BUDGET.coordinate.real().scaled(-GRAZING - 1);
        if height.abs() <= doubt || height.abs() > most {
            return None;
        }
        let along =
            |axis: UnitVec3<S>| i64::from(S::unit_parts(S::unit_round(axis.dot(normal))).truncated(AXIS as i32));
        Some(self.axes.map(|axis| if height.is_negative() { -along(axis) } else { along(axis) }))
    }

    /// The shadow of a ball in this light, and the part of it that another shape may throw, too; `None` if the ball is
    /// beyond the type.
    pub(crate) fn shadow<K: Kinds>(
        &self,
        (centre, legs): BallInWorld<S>,
        light: &Light<S>,
        other: Option<&Shape<S, K>>,
    ) -> Option<Shadow> {
        let ([x, y, z], [a, b, c]) = (self.coordinates(centre), legs);
        let plane = other.and_then(Shape::plane);
        let above = |point: Vec3<S>| plane.map_or(S::ZERO, |(on, normal)| S::round((point - on).dot(normal)));
        if light.distant {
            let ([x, y, z, a, b, c, height], _) = truncated_all([x, y, z, a, b, c, above(centre)], BITS)?;
            // Of a length of its own, which does not matter.
            let towards = UnitVec3::<S>::from_real(light.position.real())?;
            let along =
                |axis: UnitVec3<S>| i64::from(S::unit_parts(S::unit_round(towards.dot(axis))).truncated(BITS - 1));
            let rise = plane.map_or(0, |(_, normal)| along(normal));
            let side = rise.signum();
            return Some(Shadow {
                ball: SeenBall { c: [x, y, z].map(i64::from), r: i64::from(radius([a, b, c])) },
                from_light: self.axes.map(|axis| -along(axis)),
                growth: 0,
                heights: [side * i64::from(height), -side * rise],
            });
        }
        let [lx, ly, lz] = self.coordinates(light.position);
        let lengths = [x, y, z, a, b, c, lx, ly, lz, above(centre), above(light.position)];
        let ([x, y, z, a, b, c, lx, ly, lz, height, of_light], _) = truncated_all(lengths, BITS)?;
        let (centre, side) = ([x, y, z].map(i64::from), i64::from(of_light.signum()));
        let [lx, ly, lz, height, of_light] = [lx, ly, lz, height, of_light].map(i64::from);
        let r = i64::from(radius([a, b, c]));
        Some(Shadow {
            ball: SeenBall { c: centre, r },
            from_light: pairs(centre, [lx, ly, lz]).map(|(c, l)| c - l),
            growth: r,
            heights: [side * height, side * (height - of_light)],
        })
    }
}

/// A number no less than the square root.
fn root(square: i64) -> i64 {
    // In 32 bits if there is room, in which a root takes a third of the instructions of a chip with such words.
    u32::try_from(square).map_or_else(|_| square.unsigned_abs().isqrt() as i64, |square| square.isqrt().into()) + 1
}

/// True if there is an `m >= 0` for which every `a + b m` of these is no less than zero.
fn are_positive(terms: [[i64; 2]; 4]) -> bool {
    // From `low` to `high`, which are fractions; 1 / 0 is infinite.
    let (mut low, mut high) = ([0, 1], [1, 0]);
    let is_less = |[a, b]: [i64; 2], [c, d]: [i64; 2]| i128::from(a) * i128::from(d) < i128::from(c) * i128::from(b);
    for [a, b] in terms {
        if a < 0 && b <= 0 {
            return false;
        } else if a < 0 {
            low = if is_less(low, [-a, b]) { [-a, b] } else { low };
        } else if b < 0 {
            high = if is_less([a, -b], high) { [a, -b] } else { high };
        }
    }
    !is_less(high, low)
}

/// A ball in the coordinates of a camera, in the unit in which its numbers have [`BITS`] bits along the world's axes.
#[derive(Clone, Copy)]
pub(crate) struct SeenBall {
    pub(crate) c: [i64; 3],
    pub(crate) r: i64,
}

/// The shadow of a ball in the same coordinates: the balls about `c + m (c - l)` with the radii `(1 + m) r`; of a
/// distant light about `c - m l` with the radius `r`, and then `l` may have any length.
pub(crate) struct Shadow {
    ball: SeenBall,
    /// `c - l`, or `-l`.
    from_light: [i64; 3],
    /// `r`, or 0.
    growth: i64,
    /// How far these centres are on the light's side of a plane, which shades all that is on the other side: for
    /// `m = 0`, and the growth. Zero without a plane.
    heights: [i64; 2],
}

/// The directions of the rays of a row, in the coordinates of a pinhole camera.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Directions {
    /// `u` of the first column, and by how much it grows.
    u: [i64; 2],
    v: i64,
    f: i64,
    width: u16,
    /// The rays are up to this far above the row's middle, and below it.
    height: i64,
    /// No less than the length of `n` at any of these heights.
    length: i64,
    /// No less than what the error of `f` moves a ray by at a centre.
    turned: i64,
}

impl Directions {
    /// Those of row `y`, which may lie below the picture. `None` if they are parallel, or have no room in [`BITS`]
    /// bits.
    pub(crate) fn of_row<S: Scalar>(raster: &Raster<S>, y: u32) -> Option<Self> {
        let Size { width, height, samples } = raster.size();
        Self::across(raster, [width, height], i64::from(height) - 2 * i64::from(y) - 1, samples)
    }

    /// Those of a row of so many pixels, of so many rows, that is so many half pixels from the middle.
    fn across<S: Scalar>(raster: &Raster<S>, [width, height]: [u16; 2], from_middle: i64, samples: u8) -> Option<Self> {
        let [pixels, rows] = [width, height].map(i64::from);
        let mut shift = BITS - (u64::BITS - pixels.max(rows).leading_zeros()) as i32;
        // How far in front of the eye half a pixel is a unit wide, as a share of 2^BITS.
        let mut far = (S::Real::ONE / raster.half_a_pixel()?).scaled(shift - BITS);
        while far >= S::Real::ONE && shift > 0 {
            (far, shift) = (far.scaled(-1), shift - 1);
        }
        if far >= S::Real::ONE || shift < 0 {
            return None;
        }
        let f = i64::from(S::unit_parts(S::unit_round(far)).truncated(BITS));
        let (u, v) = ((1 - pixels) << shift, from_middle << shift);
        // So that the error of `f` is a small angle; and room for rows below the picture.
        if f < 1 << 6 || v.abs() >= 1 << (BITS + 1) {
            return None;
        }
        let height = if samples > 1 { 1 << shift } else { 0 };
        let highest = v.abs() + height;
        let length = root(f * f + highest * highest);
        // That `f` is off by less than 1 turns a ray by less than 1 / 2 f; a centre is nearer than 2^(BITS + 1).
        let turned = (1_i64 << BITS).checked_div(f)?;
        Some(Self { u: [u, 2 << shift], v, f, width, height, length, turned })
    }

    /// Those of row `y` of so many, if these are of any other, for rays through the middle of pixels.
    pub(crate) fn in_row(&self, y: u16, rows: u16) -> Self {
        let v = (i64::from(rows) - 2 * i64::from(y) - 1) * (self.u[1] / 2);
        Self { v, length: root(self.f * self.f + v * v), ..*self }
    }

    /// The radius of a ball, and as much as rounding may matter.
    fn enlarged(&self, r: i64) -> i64 {
        // A centre is off by less than 7. Directions of rays are rounded too.
        r + 9 + (r >> 10) + self.turned
    }

    /// How far a point is from the plane of the row, times the length of its normal.
    fn off_plane(&self, [_, y, z]: [i64; 3]) -> i64 {
        y * self.f - z * self.v
    }

    /// How far a ball may be off the plane that a ray of the row meets.
    fn reach(&self, [_, _, z]: [i64; 3], r: i64) -> i64 {
        self.enlarged(r) * self.length + z.abs() * self.height
    }

    /// True if a ray of the row may meet the ball.
    pub(crate) fn may_meet(&self, ball: &SeenBall) -> bool {
        self.off_plane(ball.c).abs() <= self.reach(ball.c, ball.r)
    }

    /// True if a ray of the row may meet the shadow on the light's side of the plane.
    pub(crate) fn may_meet_shadow(&self, Shadow { ball, from_light, growth, heights }: &Shadow) -> bool {
        // How far a ball of the shadow is off the plane of the row, how far it may be, and how far its nearest point is
        // in front of the eye: of each the value for m = 0, and the growth. The distance from the light is off by less
        // than 4.
        let radii = [ball.r, *growth].map(|r| self.enlarged(r + 4));
        let [reach, more] = [self.reach(ball.c, ball.r), self.reach(*from_light, growth + 4)];
        let [off, farther] = [ball.c, *from_light].map(|point| self.off_plane(point));
        let ahead = [ball.c[2] + radii[0], from_light[2] + radii[1]];
        let lit = [heights[0] + radii[0], heights[1] + radii[1]];
        are_positive([[reach + off, more + farther], [reach - off, more - farther], ahead, lit])
    }

    /// True if all rays of the row go along a normal ([`View::beyond`]), and false if all go against it; `None` if that
    /// is not certain.
    pub(crate) fn go_along(&self, [x, y, z]: [i64; 3]) -> Option<bool> {
        let Self { u: [first, step], v, f, .. } = *self;
        let ends = [first, first + step * i64::from(self.width.saturating_sub(1))];
        // No less than the length of a direction.
        let [near, far] = ends.map(i64::abs);
        let least = (near.max(far) + v.abs() + f) << (AXIS as i32 - GRAZING);
        let [first, last] = ends.map(|u| x * u + y * v + z * f);
        if first >= least && last >= least {
            Some(true)
        } else if first <= -least && last <= -least {
            Some(false)
        } else {
            None
        }
    }

    /// The first of these columns in which a ray may meet the ball, and the one after the last. For rays through the
    /// middle of pixels.
    pub(crate) fn columns(&self, ball: &SeenBall, all: [u16; 2]) -> [u16; 2] {
        let Self { u: [u, step], v, f, .. } = *self;
        let ([cx, cy, cz], r) = (ball.c, self.enlarged(ball.r));
        let e = cx * cx + cy * cy + cz * cz - r * r;
        if e <= 0 {
            return all;
        }
        if !self.may_meet(ball) {
            return [0; 2];
        }
        let [mut column, end] = all;
        // q = a u^2 + 2 b u + (k^2 - (v^2 + f^2) e)
        let k = cy * v + cz * f;
        let (a, b) = (cx * cx - e, cx * k);
        let left = u + step * i64::from(column);
        let mut q = (a * left + 2 * b) * left + k * k - (v * v + f * f) * e;
        let mut growth = (a * (2 * left + step) + 2 * b) * step;
        let bend = 2 * a * step * step;
        while column < end {
            // Where q >= 0, the ray or the one backwards meets the ball. Columns of both kinds may follow each other,
            // if the eye is close to the ball: then one of the ends is of the first kind.
            let (first, is_met) = (column, q >= 0);
            while (q >= 0) == is_met && column < end {
                (q, growth, column) = (q + growth, growth + bend, column + 1);
            }
            let is_ahead = |column: u16| cx * (u + step * i64::from(column)) + k > 0;
            if is_met && (is_ahead(first) || is_ahead(column - 1)) {
                return [first, column];
            }
        }
        [0; 2]
    }
}
