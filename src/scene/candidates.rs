//! The objects that the rays of a row of pixels may meet.
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
//! differences), and the columns with `q >= 0` follow each other. All lengths are rounded to [`BITS`] bits, and the
//! ball is larger by as much as that may change; all else is exact in 64 bits. So no ray that meets the object is
//! outside of its columns, and a picture has the same bits with them as without.

use super::{Raster, Scene, Size};
use crate::number::Parts;
use crate::scalar::{Ring, Scalar};
use crate::shape::Shape;
use crate::shape::kinds::Kinds;
use crate::vector::{UnitVec3, Vec3, pairs};

/// Lengths are below 2 to the power of this: products of four are then below `2^62`.
const BITS: i32 = 14;

/// The most objects of which columns are computed; all others may be met anywhere. A picture of more needs a
/// hierarchy.
const MOST: usize = 16;

/// A set of objects of a scene, among which all are that a ray may meet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidates {
    /// Bit `i` is object `i`.
    first: u16,
}

impl Candidates {
    /// All objects.
    pub(crate) const ALL: Self = Self { first: u16::MAX };

    /// True if the ray may meet the object of this index.
    #[inline(always)]
    pub(crate) fn contain(self, object: u32) -> bool {
        object >= MOST as u32 || self.first & (1 << object) != 0
    }
}

/// The candidates of each column of a row.
#[derive(Clone, Debug)]
pub(crate) struct CandidatesOfRow {
    /// The first column of each object, and the one after its last.
    columns: heapless::Vec<[u16; 2], MOST>,
    /// Those of the columns from the last one on that was asked for, to before this one.
    until: u16,
    these: Candidates,
}

impl CandidatesOfRow {
    /// All objects in each column.
    pub(crate) const fn all() -> Self {
        Self { columns: heapless::Vec::new(), until: u16::MAX, these: Candidates::ALL }
    }

    /// Those of row `y` of a picture with one sample a pixel.
    pub(crate) fn new<S: Scalar, T, K: Kinds>(scene: &Scene<'_, S, T, K>, raster: &Raster<S>, y: u16) -> Self {
        let mut columns = heapless::Vec::new();
        // A hierarchy finds them at less cost.
        let pinhole = if scene.hierarchy.is_none() { raster.pinhole() } else { None };
        let Some((axes, pitch)) = pinhole else { return Self::all() };
        let Some(row) = Directions::of_row::<S>(raster.size(), pitch, y) else { return Self::all() };
        for object in scene.objects.iter().take(MOST) {
            // There is room for MOST.
            let ball = Ball::of(&object.shape, raster.camera().position(), axes);
            let _ = columns.push(row.columns(ball));
        }
        Self { columns, until: 0, these: Candidates::ALL }
    }

    /// Those of a column, which is not left of the last one that was asked for.
    #[inline(always)]
    pub(crate) fn of(&mut self, column: u16) -> Candidates {
        if column >= self.until {
            self.advance(column);
        }
        self.these
    }

    #[inline(never)]
    fn advance(&mut self, column: u16) {
        (self.until, self.these) = (u16::MAX, Candidates::ALL);
        for (index, columns) in self.columns.iter().enumerate() {
            let [first, end] = *columns;
            if column < first || column >= end {
                self.these.first &= !(1 << index);
            }
            let change = if column < first { first } else { end };
            if column < change && change < self.until {
                self.until = change;
            }
        }
    }
}

/// The integer below the magnitude of a number times a power of two, with its sign.
fn truncated(Parts { mantissa, exponent, negative }: Parts, scale: i32) -> i64 {
    let shift = exponent + scale;
    let magnitude = if shift >= 0 {
        mantissa.checked_shl(shift.unsigned_abs()).unwrap_or(0)
    } else {
        mantissa.checked_shr(shift.unsigned_abs()).unwrap_or(0)
    };
    if negative { -(magnitude as i64) } else { magnitude as i64 }
}

/// A ball in the coordinates of a camera, in a unit in which its numbers have [`BITS`] bits.
#[derive(Clone, Copy)]
struct Ball {
    c: [i64; 3],
    r: i64,
}

impl Ball {
    /// One that surely holds the shape; `None` if none is known.
    fn of<S: Scalar, K: Kinds>(shape: &Shape<S, K>, eye: Vec3<S>, axes: [UnitVec3<S>; 3]) -> Option<Self> {
        let (centre, legs) = shape.ball()?;
        let from_eye = pairs(centre.to_array(), eye.to_array()).map(|(centre, eye)| centre.minus(eye));
        // Each coordinate is off by two units of the type: in all less than what is added to the legs.
        let c = axes.map(|axis| S::round(S::dot(from_eye, axis.to_array())));
        let legs = legs.map(|leg| (0..4).fold(leg, |leg, _| leg.next_up()));
        if !from_eye.into_iter().chain(c).chain(legs).all(S::is_finite) {
            return None;
        }
        let (c, legs) = (c.map(S::parts), legs.map(S::parts));
        let top = |parts: Parts| parts.exponent + (u64::BITS - parts.mantissa.leading_zeros()) as i32;
        let top = c.into_iter().chain(legs).filter(|parts| parts.mantissa != 0).map(top).max()?;
        let [x, y, z] = legs.map(|leg| truncated(leg, BITS - top) + 1);
        let r = ((x * x + y * y + z * z) as u64).isqrt() as i64 + 1;
        Some(Self { c: c.map(|c| truncated(c, BITS - top)), r })
    }
}

/// The directions of the rays of a row, in the coordinates of a pinhole camera.
struct Directions {
    /// `u` of the first column, and by how much it grows.
    u: [i64; 2],
    v: i64,
    f: i64,
    width: u16,
}

impl Directions {
    /// `None` if they have no room in [`BITS`] bits.
    fn of_row<S: Scalar>(size: Size, pitch: S::Real, y: u16) -> Option<Self> {
        let [width, height] = [size.width, size.height].map(i64::from);
        let mut shift = BITS - (u64::BITS - width.max(height).leading_zeros()) as i32;
        // How far in front of the eye half a pixel is a unit wide, as a share of 2^BITS.
        let mut far = (S::Real::ONE / pitch).scaled(shift - BITS);
        while far >= S::Real::ONE && shift > 0 {
            (far, shift) = (far.scaled(-1), shift - 1);
        }
        if far >= S::Real::ONE || shift < 0 {
            return None;
        }
        let f = truncated(S::unit_parts(S::unit_round(far)), BITS);
        // So that the error of `f` is a small angle.
        if f < 1 << 6 {
            return None;
        }
        let from_middle = |pixel: i64, pixels: i64| (2 * pixel + 1 - pixels) << shift;
        let (u, v) = (from_middle(0, width), -from_middle(i64::from(y), height));
        Some(Self { u: [u, 2 << shift], v, f, width: size.width })
    }

    /// The first column in which a ray may meet the ball, and the one after the last; all columns if there is no ball.
    fn columns(&self, ball: Option<Ball>) -> [u16; 2] {
        let all = [0, self.width];
        let Some(Ball { c: [cx, cy, cz], r }) = ball else { return all };
        let Self { u: [u, step], v, f, .. } = *self;
        // The centre is off by less than 2, and that `f` is off by less than 1 turns a ray by less than 1 / 2 f, and so
        // moves it by less than 2^BITS / f at the centre, which is nearer than 2^(BITS + 1). Directions of rays are
        // rounded too.
        let r = r + 4 + (r >> 10) + (1 << BITS) / f;
        // In the plane of the row, whose normal is (0, f, -v), there may be no point of the ball.
        let off_plane = cy * f - cz * v;
        let k = cy * v + cz * f;
        let e = cx * cx + cy * cy + cz * cz - r * r;
        if off_plane * off_plane > r * r * (f * f + v * v) {
            return [0; 2];
        }
        if e <= 0 {
            return all;
        }
        // q = a u^2 + 2 b u + (k^2 - (v^2 + f^2) e)
        let (a, b) = (cx * cx - e, cx * k);
        let mut q = (a * u + 2 * b) * u + k * k - (v * v + f * f) * e;
        let mut growth = (a * (2 * u + step) + 2 * b) * step;
        let bend = 2 * a * step * step;
        let mut ahead = cx * u + k;
        let mut first = None;
        for column in 0..self.width {
            match (q >= 0 && ahead > 0, first) {
                (true, None) => first = Some(column),
                (false, Some(first)) => return [first, column],
                _ => {}
            }
            (q, growth, ahead) = (q + growth, growth + bend, ahead + cx * step);
        }
        first.map_or([0; 2], |first| [first, self.width])
    }
}

#[cfg(units)]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../tests/units/scene/candidates.rs"]
mod tests;
