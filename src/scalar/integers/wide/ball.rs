//! A line and a ball.

use super::{
    Digits, FINER, digits, dot, down, down_to_64, high, leading_zeros, minor, product, refined, root, rounded, square,
    squared, squared_length, up, up_to_128, upper_bits, words,
};
use crate::scalar::Attempt;

/// The closest approach of a line to a ball, for a direction assumed to have length 1: `k = o . d` and
/// `D = r^2 - |o - k d|^2`, so that `t = -k -+ sqrt(D)`.
pub(in crate::scalar) struct ByApproach {
    o: [Digits; 3],
    r: Digits,
    k: i64,
    discriminant: i128,
    /// The error bound of the discriminant's upper half.
    certain: i64,
    /// Lengths are in units of `2^-unit`; those in the discriminant are in units finer by `up` bits.
    unit: u32,
    up: u32,
}

impl ByApproach {
    /// The origin is in units of `2^-extra_bits` of the radius's.
    #[inline(always)]
    pub(in crate::scalar) fn new(o: [i64; 3], extra_bits: i32, d: [i64; 3], r: i64) -> Attempt<Self> {
        // On a grid on which no length has more than 60 bits. With fewer than four bits below the unit its rounding
        // would matter.
        let Some(r) = refined(r, extra_bits) else { return Attempt::Unsure };
        let all = upper_bits(o[0]) | upper_bits(o[1]) | upper_bits(o[2]) | (r >> 32) as u32;
        if all >= 1 << 24 {
            return Attempt::Unsure;
        }
        // The unit's exponent has five bits.
        let grid = leading_zeros(all | 1 << 4) - 4;
        let unit = grid + extra_bits as u32;
        let [x, y, z] = [up(o[0], grid), up(o[1], grid), up(o[2], grid)];
        let (o, d) = (digits([x, y, z]), digits(d));
        // Products with the direction are rounded to the grid. The products of the low digits, at most a unit each, are
        // left out.
        let on_grid = |high: i64, middle: i64| (high << 2) + ((middle + (1 << 29)) >> 30);
        let k = on_grid(
            product(o[0].high, d[0].high) + product(o[1].high, d[1].high) + product(o[2].high, d[2].high),
            o[0].middle(d[0]) + o[1].middle(d[1]) + o[2].middle(d[2]),
        );
        let back = Digits::new(k);
        let along = |d: Digits| on_grid(product(back.high, d.high), back.middle(d));
        let p = [x - along(d[0]), y - along(d[1]), z - along(d[2])];
        // From here on the grid is one on which the radius has 61 bits.
        let r = up(r, grid);
        let more = leading_zeros((r >> 32) as u32 | 1) - 3;
        // Twice the radius or more.
        if (upper_bits(p[0]) | upper_bits(p[1]) | upper_bits(p[2])) >> (30 - more) != 0 {
            return Attempt::Miss;
        }
        let radius = Digits::new(up(r, more));
        let discriminant = squared(radius) - squared_length(digits(p.map(|length| up(length, more))));
        // The error is a unit and a half of the grid on each axis, which changes t by at most a third of a unit; that
        // of a framed origin is a five-hundredth of a unit.
        let known = if extra_bits == 0 { unit } else { FINER as u32 + 1 };
        let certain = down(square(radius.high), (2 * (known - 3)).min(30)) + 2;
        Attempt::Hit(Self { o, r: Digits::new(r), k, discriminant, certain, unit, up: more })
    }

    /// The two ends, in the radius's unit.
    #[inline(always)]
    pub(in crate::scalar) fn ends(self) -> Attempt<[i64; 2]> {
        if high(self.discriminant) < self.certain {
            return if high(self.discriminant) < -self.certain { Attempt::Miss } else { Attempt::Unsure };
        }
        let root = down(root(self.discriminant) as i64, self.up);
        let middle = ((1_u32 << self.unit) >> 1) as i64 - self.k;
        Attempt::Hit([down(middle - root, self.unit), down(middle + root, self.unit)])
    }

    /// Whether there is an end at `t >= 0`; the same result as that of [`ByApproach::ends`].
    #[inline(always)]
    pub(in crate::scalar) fn meets_ahead(self) -> Attempt<()> {
        if high(self.discriminant) < self.certain {
            return if high(self.discriminant) < -self.certain { Attempt::Miss } else { Attempt::Unsure };
        }
        if self.k < 0 {
            return Attempt::Hit(());
        }
        // The line leads away: the far end is at -c / (k + sqrt(D)), and an end within half a unit of the type of zero
        // counts as zero; here within one, to include the lower half of c, and the change of k^2 by a direction whose
        // square is off by 2^-19.
        let k = (self.k >> 32) as i32;
        let near = (k >> (31 - self.unit)) as i64 + (square(k) >> 18) + 2;
        let c = high(squared_length(self.o) - squared(self.r));
        if c > near {
            Attempt::Miss
        } else if c < -near {
            Attempt::Hit(())
        } else {
            Attempt::Unsure
        }
    }
}

/// The closest approach of a line to a ball, from its Pluecker moment `w = o x d`: `D = a r^2 - |w|^2`, so that
/// `t = (-k -+ sqrt(D)) / a`.
///
/// `k` is exact; `a = 1 + e` with an `e` of at most 2^-39, whose square is negligible, or, rarely, of at most 2^-26.
pub(in crate::scalar) struct ByMoment {
    d: [Digits; 3],
    k: i128,
    rr: i128,
    /// `r^2 - |w|^2`
    residual: i128,
    /// Radius and moment are in units of `2^-grid`, `k` of `2^(-62 - extra_bits)`, which is finer by `down` bits.
    grid: u32,
    down: u32,
    extra_bits: i32,
}

/// `1 + e` in units of `2^-124`.
const ONE: i128 = 1 << 124;

impl ByMoment {
    /// The origin is in units of `2^-extra_bits` of the radius's.
    #[inline(always)]
    pub(in crate::scalar) fn new(o: [i64; 3], extra_bits: i32, d: [i64; 3], r: i64) -> Attempt<Self> {
        // A grid on which the radius has 61 bits; the moment is shifted down to it. With fewer than eight bits below
        // the unit its rounding would matter.
        let [low, above] = words(r as u64);
        // Farther away on all axes sums of products would not fit.
        let all = upper_bits(o[0]) | upper_bits(o[1]) | upper_bits(o[2]);
        if above >= 1 << 21 || all >= 1 << 29 || !(extra_bits == 0 || extra_bits == FINER) {
            return Attempt::Unsure;
        }
        let (top, grid) = if above != 0 { (above, 0) } else { (low, 32) };
        let grid = leading_zeros(top | 1) + grid - 3;
        let down = 62 + extra_bits as u32 - grid;
        let (o, d) = (digits(o), digits(d));
        let ([x, y, z], [dx, dy, dz]) = (o, d);
        let w = [minor([y, z], [dy, dz]), minor([z, x], [dz, dx]), minor([x, y], [dx, dy])];
        let [wx, wy, wz] = w.map(i128::unsigned_abs);
        // Twice the radius or more.
        if down_to_64((wx | wy | wz) >> 64, down - 2) != 0 {
            return Attempt::Miss;
        }
        let on_grid = |minor: u128| Digits::new(((down_to_64(minor, down - 1) + 1) >> 1) as i64);
        let w = [on_grid(wx), on_grid(wy), on_grid(wz)];
        let rr = squared(Digits::new(up_to_128(r as u64, grid) as i64));
        Attempt::Hit(Self { d, k: dot(o, d), rr, residual: rr - squared_length(w), grid, down, extra_bits })
    }

    /// The number of bits by which the discriminant may be smaller than `r^2`: the rounding of the moment, half a unit
    /// of the grid, then changes t by at most a thirtieth of a unit, that of a framed origin by at most a twentieth.
    #[inline(always)]
    const fn spare(&self) -> u32 {
        if self.extra_bits == 0 { 2 * (self.grid - 5) } else { 8 }
    }

    /// The two ends, in the radius's unit.
    #[inline(always)]
    pub(in crate::scalar) fn ends(self) -> Attempt<[i64; 2]> {
        // In units of 2^-70.
        let e = ((squared_length(self.d) - ONE) >> 54) as i64;
        if e != e as i32 as i64 {
            return self.ends_along_rounded();
        }
        let e = e as i32;
        let excess = (product((self.rr >> 96) as i32, e) as i128) << 26;
        self.ends_by(excess, |numerator| (product((numerator >> 94) as i32, e) as i128) << 24)
    }

    /// The two ends for an `e` of up to 2^-26, as a direction of 30 bits has; its square is not negligible.
    #[cold]
    #[inline(never)]
    fn ends_along_rounded(self) -> Attempt<[i64; 2]> {
        // In units of 2^-88.
        let e = (squared_length(self.d) - ONE) >> 36;
        if e.unsigned_abs() >> 62 != 0 {
            return Attempt::Unsure;
        }
        let e = e as i64;
        let times = |value: i128, e: i64| dot([Digits::new(high(value))], [Digits::new(e)]) >> 24;
        // 1 / (1 + e) is 1 - (e - e^2).
        let part = e - (square((e >> 32) as i32) >> 24);
        self.ends_by(times(self.rr, e), |numerator| times(numerator, part))
    }

    /// The two ends from `e r^2`, and the fraction by which `a` reduces a numerator.
    #[inline(always)]
    fn ends_by(&self, excess: i128, part: impl Fn(i128) -> i128) -> Attempt<[i64; 2]> {
        let discriminant = self.residual + excess;
        let certain = down(high(self.rr), self.spare().min(30));
        if high(discriminant) < certain {
            return if high(discriminant) < -certain { Attempt::Miss } else { Attempt::Unsure };
        }
        let root = up_to_128(root(discriminant), self.down) as i128;
        let end = |numerator: i128| rounded(numerator - part(numerator), self.extra_bits);
        Attempt::Hit([end(-self.k - root), end(root - self.k)])
    }

    /// Whether there is an end at `t >= 0`; the same result as that of [`ByMoment::ends`].
    #[inline(always)]
    pub(in crate::scalar) fn meets_ahead(self) -> Attempt<()> {
        // For any length of the direction within these bounds.
        let certain = down(high(self.rr), self.spare().min(17));
        if high(self.residual) < certain {
            return if high(self.residual) < -certain { Attempt::Miss } else { Attempt::Unsure };
        }
        if self.k < 0 {
            return Attempt::Hit(());
        }
        // The line leads away: the far end is at (D - k^2) / (k + sqrt(D)), and an end within half a unit of the type
        // of zero counts as zero.
        let k = self.k as u128;
        if down_to_64(k >> 64, self.down - 2) != 0 {
            return Attempt::Miss;
        }
        let k = down_to_64(k, self.down);
        let beyond = high(squared(Digits::new(k as i64)) - self.residual);
        // Two units, or the error of the discriminant from the direction's length.
        let near = down_to_64(k as u128, self.down - self.extra_bits as u32) as i64 + (high(self.rr) >> 18) + 1;
        if beyond > near {
            Attempt::Miss
        } else if beyond < -near {
            Attempt::Hit(())
        } else {
            Attempt::Unsure
        }
    }
}
