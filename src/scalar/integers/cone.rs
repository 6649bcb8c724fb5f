//! A line and a cone's side.

use super::nappes::Roots;
use super::quotient::{Divisor, Normalized};
use super::{high, leading_zeros, magnitude_bits, product, root, round_off, square};
use crate::scalar::{Attempt, InNappe, found};

/// A line and both nappes of a cone, `h^2 (x^2 + z^2) = (h r + g y)^2`, that has the radius `r` at `y = 0` and grows by `g` over the
/// height `h`.
///
/// In coordinates scaled by `h` across the axis and by the outline along it, `X = h x`, `Z = h z`, `Y = h r + g y`, the cone is
/// `X^2 + Z^2 = Y^2`, and the line's moment `W` gives `D = Wx^2 + Wz^2 - Wy^2`, so that `t = (-k -+ sqrt(D)) / a`.
struct AtCone {
    /// Of the point where the line is taken up.
    y: i32,
    dy: i32,
    a: i64,
    k: i64,
    root: i64,
    divisor: Divisor,
    /// Lengths are in units of `2^-unit`.
    unit: u32,
    /// The whole unit of `t` at that point.
    start: i32,
    /// Ends are only good enough so far from there.
    farthest: i32,
}

impl AtCone {
    /// The origin is in units of `2^-finer` of the sizes'.
    // Not inlined: a shape that may be any cone has it twice.
    #[inline(never)]
    fn new(o: [i32; 3], finer: i32, d: [i32; 3], [r, g, h]: [i32; 3]) -> Attempt<Self> {
        // The proportions, the larger one above 1/2 and at most 1 in units of 2^-30.
        let free = leading_zeros(magnitude_bits(g) | (h - 1) as u32 | 1);
        let radius = r << (finer & 0x1f);
        if free < 2 || !(0..28).contains(&finer) || radius >> finer != r {
            return Attempt::Unsure;
        }
        let (g, h) = (g << (free - 2), h << (free - 2));
        // From the whole unit of t next to the point closest to the frame's origin: the products are exact, and lengths are those of
        // the cone and of the line's distance from it, however far away the ray starts.
        let closest = -((product(o[0], d[0]) + product(o[1], d[1]) + product(o[2], d[2])) >> (30 + finer));
        if closest != closest as i32 as i64 || finer + 32 - (closest.unsigned_abs() as u32).leading_zeros() as i32 > 31
        {
            return Attempt::Unsure;
        }
        let start = closest as i32;
        let walked = |length: i32, d: i32| ((length as i64) << 30) + product(start << finer, d);
        let near = [walked(o[0], d[0]), walked(o[1], d[1]), walked(o[2], d[2])];
        let radius = (radius as i64) << 30;
        // Lengths on a grid on which none has more than 29 bits.
        let [hx, hy, hz] = near.map(|length| magnitude_bits(high(length)));
        let zeros = leading_zeros(hx | hy | hz | high(radius) as u32 | 1);
        if zeros < 4 {
            return Attempt::Unsure;
        }
        let up = zeros - 3;
        let unit = (up as i32 - 2 + finer) as u32;
        // Cut off towards zero, so that a mirrored line is on mirrored points.
        let on_grid = |length: i64| {
            let magnitude = length.unsigned_abs();
            let length_on_grid = (((magnitude >> 32) as u32) << up | (magnitude as u32) >> (32 - up)) as i32;
            if length < 0 { -length_on_grid } else { length_on_grid }
        };
        let nearest = |n: i64| round_off(n, 30) as i32;
        let along = |length: i64, proportion: i32| nearest(product(on_grid(length), proportion));
        let (x, y, z) = (along(near[0], h), along(radius, h) + along(near[1], g), along(near[2], h));
        let [dx, dy, dz] = [nearest(product(d[0], h)), nearest(product(d[1], g)), nearest(product(d[2], h))];

        let a = square(dx) + square(dz) - square(dy);
        let Some(a_digits) = Normalized::new(a) else {
            return Attempt::Unsure;
        };
        let wx = nearest(product(y, dz) - product(z, dy));
        let wy = nearest(product(z, dx) - product(x, dz));
        let wz = nearest(product(x, dy) - product(y, dx));
        let discriminant = square(wx) + square(wz) - square(wy);
        // The coordinates' rounding, of up to 1.5 units across the axis and 3 along it, moves D by no more than ten times this.
        let moment = wx.unsigned_abs() as i64 + wy.unsigned_abs() as i64 + wz.unsigned_abs() as i64;
        if discriminant < -(moment << 4) && a > 0 {
            return Attempt::Miss;
        }
        // ... and t by no more than half a unit (in all that was measured, by a twentieth), if the root is not small against the moment.
        let spare = unit as i32 - 3 - a_digits.shift as i32;
        // A framed origin is off by half of its own unit.
        let spare = if finer == 0 { spare } else { spare.min(finer - 2 - a_digits.shift as i32) };
        if high(discriminant) <= 0 || spare < 0 {
            return Attempt::Unsure;
        }
        let root = root(discriminant as u64) as i64;
        if root < moment >> spare {
            return Attempt::Unsure;
        }
        let k = product(x, dx) + product(z, dz) - product(y, dy);
        let divisor = a_digits.divisor();
        // Farther away, the rounding of a turned direction counts, 2^-31 of t, of which a small root makes as much more.
        let more = leading_zeros(root as u32) as i32 - leading_zeros(moment as u32) as i32 + 1;
        let farthest = (1 << if finer == 0 { 24 } else { (28 - more).clamp(0, 24) }) >> divisor.shift;
        Attempt::Found(Self { y, dy, a, k, root, divisor, unit, start, farthest })
    }

    #[inline(always)]
    fn end(&self, numerator: i64) -> (i32, bool) {
        let Self { start, farthest, .. } = *self;
        match self.divisor.quotient(numerator, 30 + self.unit) {
            Some(t) if -farthest < t && t < farthest => (start.saturating_add(t), true),
            _ if (numerator < 0) == (self.a < 0) => (start.saturating_add(farthest), false),
            _ => (start.saturating_sub(farthest), false),
        }
    }
}

impl Roots for AtCone {
    type Length = i32;

    const INFINITY: i32 = i32::MAX;

    #[inline(always)]
    fn start(&self) -> i32 {
        self.start
    }

    #[inline(always)]
    fn is_steep(&self) -> bool {
        self.a < 0
    }

    #[inline(always)]
    fn rises(&self) -> bool {
        self.dy > 0
    }

    #[inline(always)]
    fn is_middle_inside(&self) -> Attempt<bool> {
        let (a, k) = (high(self.a << 2), high(self.k << 2));
        let middle = product(self.y, a) - product(self.dy, k);
        if middle.unsigned_abs() >> 34 == 0 { Attempt::Unsure } else { Attempt::Found(middle > 0) }
    }

    #[inline(always)]
    fn first(&self) -> (i32, bool) {
        self.end(-self.k - (self.root << 30))
    }

    #[inline(always)]
    fn second(&self) -> (i32, bool) {
        self.end((self.root << 30) - self.k)
    }
}

/// Where the line is inside the nappe of [`AtCone`] in which `h r + g y >= 0`.
///
/// The origin is in units of `2^-finer` of the sizes'; the answer is in the sizes'.
#[inline(always)]
pub(in crate::scalar) fn nappe(o: [i32; 3], finer: i32, d: [i32; 3], outline: [i32; 3]) -> Attempt<InNappe<i32>> {
    found!(AtCone::new(o, finer, d, outline)).in_nappe()
}

/// Where the line is inside both nappes of the cone of slope `g / h` about its apex at the origin: between its ends, or (`true`) beyond
/// them.
#[inline(always)]
pub(in crate::scalar) fn double_cone(
    o: [i32; 3],
    finer: i32,
    d: [i32; 3],
    [g, h]: [i32; 2],
) -> Attempt<([i32; 2], bool)> {
    found!(AtCone::new(o, finer, d, [0, g, h])).in_both()
}
