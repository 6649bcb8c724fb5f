//! A line and a cone's side.

use super::super::nappes::Roots;
use super::quotient::{Divisor, Normalized};
use super::{
    Digits, FINER, digits, dot, down_to_64, high, leading_zeros_of_64, minor, refined, root, round_off, squared,
    up_to_128, upper_bits,
};
use crate::scalar::{Attempt, InSide, found};

/// A line and both nappes of a cone, in the coordinates that the kernel of 32 bits describes.
struct AtCone {
    line: Scaled,
    k: i128,
    root: u64,
    divisor: Divisor,
    /// The largest distance of an end from the moved origin of the line at which the end is accurate enough.
    farthest: i64,
}

/// A line in these coordinates, and the `a` of its roots; as with 32 bits.
#[derive(Clone, Copy)]
struct Scaled {
    point: [Digits; 3],
    direction: [Digits; 3],
    a: i128,
    digits: Normalized,
    /// Lengths are in units of `2^-unit`.
    unit: i32,
    /// The whole unit of `t` to which the origin was moved.
    start: i64,
    /// The origin was in units of `2^-extra_bits`.
    extra_bits: i32,
}

/// `length * proportion`, rounded to nearest; the proportion has 62 fraction bits.
#[inline(always)]
fn along(length: i64, proportion: Digits) -> i64 {
    round_off::<62>(dot([Digits::new(length)], [proportion]))
}

impl Scaled {
    /// The origin is in units of `2^-extra_bits` of the sizes'. It is moved to a point next to the line's closest
    /// point, unless the line `departs`.
    // Not inlined: a shape that may be any cone would contain it twice.
    #[inline(never)]
    fn new(o: [i64; 3], extra_bits: i32, d: [i64; 3], [r, g, h]: [i64; 3], departs: bool) -> Attempt<Self> {
        let Some(radius) = refined(r, extra_bits) else { return Attempt::Unsure };
        if (upper_bits(o[0]) | upper_bits(o[1]) | upper_bits(o[2]) | upper_bits(radius)) >> 28 != 0 {
            return Attempt::Unsure;
        }
        // The proportions, the larger one above 1/2 and at most 1 in units of 2^-62.
        let free = leading_zeros_of_64((g ^ (g >> 63)) as u64 | (h - 1) as u64 | 1);
        if free < 2 {
            return Attempt::Unsure;
        }
        let (g, h) = (Digits::new(g << (free - 2)), Digits::new(h << (free - 2)));
        // The origin is moved to the whole unit of t next to the point closest to the frame's origin, as with 32 bits.
        let direction = digits(d);
        let closest = if departs { 0 } else { -(dot(digits(o), direction) >> 62 >> extra_bits) };
        let start = closest as i64;
        if upper_bits(start << extra_bits) >> 29 != 0
            || (start << extra_bits) >> extra_bits != start
            || start as i128 != closest
        {
            return Attempt::Unsure;
        }
        let walk = Digits::new(start << extra_bits);
        let walked = |i: usize| ((o[i] as i128) << 62) + dot([walk], [direction[i]]);
        let near = [walked(0), walked(1), walked(2)];
        let radius = (radius as i128) << 62;
        // Lengths on a grid on which none has more than 61 bits.
        let bits = |n: i128| (high(n) ^ (high(n) >> 63)) as u64;
        let zeros = leading_zeros_of_64(bits(near[0]) | bits(near[1]) | bits(near[2]) | bits(radius) | 1);
        if zeros < 4 {
            return Attempt::Unsure;
        }
        let up = zeros - 3;
        let unit = up as i32 - 2 + extra_bits;
        if unit < 0 {
            return Attempt::Unsure;
        }
        // Truncated towards zero, so that a mirrored line has mirrored points.
        let on_grid = |length: i128| {
            let on_grid = down_to_64(length.unsigned_abs(), 64 - up) as i64;
            if length < 0 { -on_grid } else { on_grid }
        };
        let x = along(on_grid(near[0]), h);
        let y = along(on_grid(radius), h) + along(on_grid(near[1]), g);
        let z = along(on_grid(near[2]), h);
        let [dx, dy, dz] = [along(d[0], h), along(d[1], g), along(d[2], h)];
        let (point, direction) = (digits([x, y, z]), digits([dx, dy, dz]));
        let [ex, ey, ez] = direction;

        let a = squared(ex) + squared(ez) - squared(ey);
        let Some(digits) = Normalized::new(a) else {
            return Attempt::Unsure;
        };
        Attempt::Hit(Self { point, direction, a, digits, unit, start, extra_bits })
    }

    /// As with 32 bits.
    #[inline(always)]
    fn shift(&self) -> i32 {
        // A divisor of 1 has a shift of one.
        self.digits.shift as i32 - 1
    }

    /// The same bounds as with 32 bits.
    #[inline(always)]
    fn spare(&self) -> i32 {
        let spare = self.unit - 3 - self.shift();
        if self.extra_bits == 0 { spare } else { spare.min(FINER - 2 - self.shift()) }
    }

    #[inline(always)]
    fn k(&self) -> i128 {
        let ([x, y, z], [dx, dy, dz]) = (self.point, self.direction);
        dot([x, z], [dx, dz]) - dot([y], [dy])
    }

    #[inline(always)]
    fn rises(&self) -> bool {
        let Digits { high, low } = self.direction[1];
        high > 0 || (high == 0 && low > 0)
    }

    /// As with 32 bits.
    #[inline(always)]
    fn is_middle_inside(&self, k: i128) -> Attempt<bool> {
        let [a, k] = [self.a, k].map(|n| Digits::new(high(n << 2)));
        let middle = dot([self.point[1]], [a]) - dot([self.direction[1]], [k]);
        if middle.unsigned_abs() >> 66 == 0 { Attempt::Unsure } else { Attempt::Hit(middle > 0) }
    }
}

impl AtCone {
    /// The origin is in units of `2^-extra_bits` of the sizes'.
    // Not inlined, as above.
    #[inline(never)]
    fn new(o: [i64; 3], extra_bits: i32, d: [i64; 3], outline: [i64; 3]) -> Attempt<Self> {
        let line = found!(Scaled::new(o, extra_bits, d, outline, false));
        let ([x, y, z], [ex, ey, ez]) = (line.point, line.direction);
        let w = [minor([y, z], [ey, ez]), minor([z, x], [ez, ex]), minor([x, y], [ex, ey])].map(round_off::<62>);
        let [wx, wy, wz] = digits(w);
        let discriminant = squared(wx) + squared(wz) - squared(wy);
        // The rounding of the coordinates, up to 1.5 units perpendicular to the axis and 3 along it, changes D by at
        // most ten times this.
        let moment = w.into_iter().fold(0, |sum, w| sum + w.unsigned_abs() as i128);
        if discriminant < -(moment << 4) && line.a > 0 {
            return Attempt::Miss;
        }
        let spare = line.spare();
        if high(discriminant) <= 0 || high(discriminant) >> 62 != 0 || spare < 0 {
            return Attempt::Unsure;
        }
        let root = root(discriminant);
        // A moment has at most 65 bits.
        let moment = (moment >> 2) as u64;
        if spare < 64 && root >> 2 < moment >> spare {
            return Attempt::Unsure;
        }
        let k = line.k();
        let divisor = line.digits.divisor();
        // Farther away the rounding of a turned direction matters: an error of 2^-63 of t (1.3 2^-62 if it is
        // stretched), which a small root enlarges likewise.
        let more = leading_zeros_of_64(root) as i32 - leading_zeros_of_64(moment | 1) as i32 + 3;
        let farthest = (1 << if extra_bits == 0 { 52 } else { (58 - more).clamp(0, 52) }) >> line.shift().max(0);
        Attempt::Hit(Self { line, k, root, divisor, farthest })
    }

    #[inline(always)]
    fn end(&self, numerator: i128) -> (i64, bool) {
        let (Scaled { start, a, unit, .. }, farthest) = (self.line, self.farthest);
        // The truncation changes t by at most 2^-51.
        match self.divisor.quotient(numerator >> unit, 0) {
            Some(t) if -farthest < t && t < farthest => (start.saturating_add(t), true),
            _ if (numerator < 0) == (a < 0) => (start.saturating_add(farthest), false),
            _ => (start.saturating_sub(farthest), false),
        }
    }
}

impl Roots for AtCone {
    type Length = i64;

    const ZERO: i64 = 0;
    const INFINITY: i64 = i64::MAX;

    #[inline(always)]
    fn start(&self) -> i64 {
        self.line.start
    }

    #[inline(always)]
    fn is_steep(&self) -> bool {
        self.line.a < 0
    }

    #[inline(always)]
    fn rises(&self) -> bool {
        self.line.rises()
    }

    #[inline(always)]
    fn is_middle_inside(&self) -> Attempt<bool> {
        self.line.is_middle_inside(self.k)
    }

    #[inline(always)]
    fn first(&self) -> (i64, bool) {
        self.end(-self.k - up_to_128(self.root, 62) as i128)
    }

    #[inline(always)]
    fn second(&self) -> (i64, bool) {
        self.end(up_to_128(self.root, 62) as i128 - self.k)
    }
}

/// Where the line is inside the nappe of [`AtCone`] in which `h r + g y >= 0`.
///
/// The origin is in units of `2^-extra_bits` of the sizes'; the answer is in the sizes'.
#[inline(always)]
pub(in crate::scalar) fn nappe(o: [i64; 3], extra_bits: i32, d: [i64; 3], outline: [i64; 3]) -> Attempt<InSide<i64>> {
    found!(AtCone::new(o, extra_bits, d, outline)).in_nappe()
}

/// Where the line is inside both nappes of the cone of slope `g / h` about its apex at the origin: between its ends, or
/// (`true`) before the first and after the second.
#[inline(always)]
pub(in crate::scalar) fn double_cone(
    o: [i64; 3],
    extra_bits: i32,
    d: [i64; 3],
    [g, h]: [i64; 2],
) -> Attempt<([i64; 2], bool)> {
    found!(AtCone::new(o, extra_bits, d, [0, g, h])).in_both()
}

/// Where a line that begins in the side of [`nappe`] leaves that nappe; as with 32 bits.
#[inline]
pub(in crate::scalar) fn exit_from_nappe(o: [i64; 3], extra_bits: i32, d: [i64; 3], outline: [i64; 3]) -> Attempt<i64> {
    let line = found!(Scaled::new(o, extra_bits, d, outline, true));
    let k = line.k();
    if line.spare() < 3 {
        return Attempt::Unsure;
    }
    let Some(t) = line.digits.divisor().quotient((-2 * k) >> line.unit, 0) else {
        return Attempt::Unsure;
    };
    if line.a < 0 {
        return if t < -1 && line.rises() { Attempt::Hit(i64::MAX) } else { Attempt::Unsure };
    }
    let is_near = 0 < t && t < 1 << 52 >> line.shift().max(0);
    if is_near && found!(line.is_middle_inside(k)) { Attempt::Hit(t) } else { Attempt::Unsure }
}
