//! A line and a ball.

use super::{
    FINER, coarser, framed_bits, half, high, high_product_signed, leading_zeros, magnitude_bits, more_bits, product,
    root, round_off, square,
};
use crate::scalar::Attempt;

/// `|v|^2`
#[inline(always)]
fn squared_length([x, y, z]: [i32; 3]) -> i64 {
    square(x) + square(y) + square(z)
}

/// The closest approach of a line to a ball, for a direction assumed to have length 1: `k = o . d` and
/// `D = r^2 - |o - k d|^2`, so that `t = -k -+ sqrt(D)`.
pub(in crate::scalar) struct ByApproach {
    o: [i32; 3],
    rr: i64,
    k: i32,
    discriminant: i64,
    /// Lengths are in units of `2^-unit`.
    unit: u32,
}

impl ByApproach {
    /// The origin is in units of `2^-extra_bits` of the radius's.
    #[inline(always)]
    pub(in crate::scalar) fn new(o: [i32; 3], extra_bits: i32, d: [i32; 3], r: i32) -> Attempt<Self> {
        // There is no room here for an origin with more extra bits.
        let (o, extra_bits) =
            if extra_bits > FINER { (coarser(o, (extra_bits - FINER) as u32), FINER) } else { (o, extra_bits) };
        // All lengths are converted to the origin's unit, then to a grid on which none has more than 28 bits.
        if !(0..28).contains(&extra_bits) {
            return Attempt::Unsure;
        }
        let radius = r << extra_bits;
        let all = magnitude_bits(o[0]) | magnitude_bits(o[1]) | magnitude_bits(o[2]) | radius as u32;
        if all >= 1 << 28 || radius >> extra_bits != r {
            return Attempt::Unsure;
        }
        let grid = leading_zeros(all) - 4;
        let unit = grid + extra_bits as u32;
        if unit > 30 {
            return Attempt::Unsure;
        }
        // Products with the direction are cut off at the grid: an error of a unit and a half in sum, of which one unit
        // is added back.
        let along = |length: i32, d: i32| high_product_signed(length << 2, d);
        let [x, y, z] = o.map(|length| length << grid);
        let k = along(x, d[0]) + along(y, d[1]) + along(z, d[2]) + 1;
        let p = [x - along(k, d[0]), y - along(k, d[1]), z - along(k, d[2])];
        let rr = square(radius << grid);
        Attempt::Hit(Self { o: [x, y, z], rr, k, discriminant: rr - squared_length(p), unit })
    }

    /// The two ends, in the radius's unit.
    #[inline(always)]
    pub(in crate::scalar) fn ends(self) -> Attempt<[i32; 2]> {
        if self.discriminant < 0 {
            return Attempt::Miss;
        }
        if high(self.discriminant) == 0 {
            return Attempt::Unsure;
        }
        let root = root(self.discriminant as u64) as i32;
        let half = (1 << self.unit) >> 1;
        Attempt::Hit([(half - self.k - root) >> self.unit, (half - self.k + root) >> self.unit])
    }

    /// Whether there is an end at `t >= 0`; the same result as that of [`ByApproach::ends`].
    #[inline(always)]
    pub(in crate::scalar) fn meets_ahead(self) -> Attempt<()> {
        if self.discriminant < 0 {
            return Attempt::Miss;
        }
        if high(self.discriminant) == 0 {
            return Attempt::Unsure;
        }
        if self.k < 0 {
            return Attempt::Hit(());
        }
        // The line leads away: the far end is at -c / (k + sqrt(D)), and an end within half a unit of the type of zero
        // counts as zero. (The grid must be so fine that its rounding cannot decide this.) The square of the direction's
        // length may be off by 2^-19.
        let length = square(self.k) >> 18;
        let near = ((self.k as i64 + 1) << (self.unit + 1)) + length;
        let c = squared_length(self.o) - self.rr;
        if self.unit < 4 || (c >= -length && c <= near) {
            Attempt::Unsure
        } else if c < 0 {
            Attempt::Hit(())
        } else {
            Attempt::Miss
        }
    }
}

/// The closest approach of a line to a ball, from its Pluecker moment `w = o x d`: `D = a r^2 - |w|^2`, so that
/// `t = (-k -+ sqrt(D)) / a`.
///
/// `k` is exact; `a = 1 + e` with an `e` of at most 2^-20, whose square is negligible.
pub(in crate::scalar) struct ByMoment {
    d: [i32; 3],
    k: i64,
    rr: i64,
    /// `r^2 - |w|^2`
    residual: i64,
    /// Radius and moment are in units of `2^-grid`, `k` of `2^-unit`, which is finer by `down` bits.
    grid: i32,
    unit: u32,
    down: u32,
}

impl ByMoment {
    /// The origin is in units of `2^-extra_bits` of the radius's.
    #[inline(always)]
    pub(in crate::scalar) fn new(o: [i32; 3], extra_bits: i32, d: [i32; 3], r: i32) -> Attempt<Self> {
        // A grid on which the radius has 29 bits; the moment is shifted down to it.
        let grid = leading_zeros(r as u32) as i32 - 3;
        let down = 30 + extra_bits - grid;
        if grid < 4 || !(3..32).contains(&down) {
            return Attempt::Unsure;
        }
        let down = down as u32;
        let ([x, y, z], [dx, dy, dz]) = (o, d);
        let w = [product(y, dz) - product(z, dy), product(z, dx) - product(x, dz), product(x, dy) - product(y, dx)];
        let [wx, wy, wz] = w.map(i64::unsigned_abs);
        // Twice the radius or more.
        if ((wx | wy | wz) >> 32) as u32 >> (down - 2) != 0 {
            return Attempt::Miss;
        }
        // The bits above are zero.
        let on_grid = |minor: u64| half((((minor >> 32) as u32) << (33 - down)) | (minor as u32 >> (down - 1)));
        let w = [on_grid(wx), on_grid(wy), on_grid(wz)];
        let rr = square(r << grid);
        let residual = rr - squared_length(w);
        let k = product(x, dx) + product(y, dy) + product(z, dz);
        Attempt::Hit(Self { d, k, rr, residual, grid, unit: (30 + extra_bits) as u32, down })
    }

    /// The smallest square of the root. The error of a framed origin, a hundredth of a unit, becomes a sixth of a unit
    /// if the root is a sixteenth of the radius. With each further bit of the origin the root may be half as large.
    #[inline(always)]
    fn most(&self, unframed: i32) -> i32 {
        let extra_bits = self.unit as i32 - 30;
        if extra_bits == 0 { unframed } else { (8 + 2 * more_bits(extra_bits, self.grid)).min(unframed) }
    }

    /// The two ends, in the radius's unit; with `is_strict` only if it is certain that they exist.
    #[inline(always)]
    pub(in crate::scalar) fn ends(self, is_strict: bool) -> Attempt<[i32; 2]> {
        // In units of 2^-48.
        let e = ((squared_length(self.d) - (1 << 60)) >> 12) as i32;
        let excess = |value: i64| product(high(value), e) >> 16;
        let discriminant = self.residual + excess(self.rr);
        // The moment's rounding, half a unit of the grid, moves t by no more than a thirtieth of a unit.
        let mut certain = self.rr >> (2 * (self.grid - 5)).clamp(3, self.most(22));
        if is_strict {
            // Three roundings of the moment, of at most 2^29.5, and those of a framed origin.
            certain = certain.max(1 << (32 + framed_bits(self.unit as i32 - 30, self.grid)));
        }
        if discriminant < certain {
            return if discriminant < -certain { Attempt::Miss } else { Attempt::Unsure };
        }
        let root = (root(discriminant as u64) as i64) << self.down;
        let end = |numerator: i64| within_type(round_off(numerator - excess(numerator), self.unit));
        let ends = [end(-self.k - root), end(root - self.k)];
        // Rounding may decide whether an end is beyond the type.
        let is_beyond = |t: i32| t.unsigned_abs() == i32::MAX as u32;
        if is_strict && (is_beyond(ends[0]) || is_beyond(ends[1])) { Attempt::Unsure } else { Attempt::Hit(ends) }
    }

    /// Whether there is an end at `t >= 0`; the same result as that of [`ByMoment::ends`].
    #[inline(always)]
    pub(in crate::scalar) fn meets_ahead(self) -> Attempt<()> {
        // For any length of the direction within these bounds.
        let certain = self.rr >> (2 * (self.grid - 5)).clamp(3, self.most(17));
        if self.residual < certain {
            return if self.residual < -certain { Attempt::Miss } else { Attempt::Unsure };
        }
        // The line starts so far away that an end may be beyond the type.
        if magnitude_bits(high(self.k)) >= 1 << 28 {
            return Attempt::Unsure;
        }
        if self.k < 0 {
            return Attempt::Hit(());
        }
        // The line leads away: the far end is at (D - k^2) / (k + sqrt(D)), and an end within half a unit of the type
        // of zero counts as zero.
        let k = self.k >> self.down;
        if k >= 1 << 30 {
            return Attempt::Miss;
        }
        let beyond = square(k as i32) - self.residual;
        // Two units, or the error of the discriminant from the direction's length.
        let near = ((k + 2) << (self.grid + 2)) + (self.rr >> 18);
        if beyond > near {
            Attempt::Miss
        } else if beyond < -near {
            Attempt::Hit(())
        } else {
            Attempt::Unsure
        }
    }
}

/// The number, or the largest raw value, which stands for infinity.
#[inline(always)]
fn within_type(t: i64) -> i32 {
    if t >= i32::MAX as i64 {
        i32::MAX
    } else if t <= -(i32::MAX as i64) {
        -i32::MAX
    } else {
        t as i32
    }
}
