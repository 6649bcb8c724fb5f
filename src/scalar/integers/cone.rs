//! A line and a cone's side.

use super::nappes::Roots;
use super::quotient::{Divisor, Normalized};
use super::{framed_bits, high, leading_zeros, magnitude_bits, product, root, round_off, square};
use crate::scalar::{Attempt, InSide, found};

/// A number with 30 bits below the point, rounded to nearest.
#[inline(always)]
fn nearest(n: i64) -> i32 {
    round_off(n, 30) as i32
}

/// A line and both nappes of a cone, `h^2 (x^2 + z^2) = (h r + g y)^2`, that has the radius `r` at `y = 0` and grows by
/// `g` over the height `h`.
///
/// In coordinates scaled by `h` across the axis and by the outline along it, `X = h x`, `Z = h z`, `Y = h r + g y`, the
/// cone is `X^2 + Z^2 = Y^2`, and the line's moment `W` gives `D = Wx^2 + Wz^2 - Wy^2`, so that
/// `t = (-k -+ sqrt(D)) / a`.
struct AtCone {
    line: Scaled,
    k: i64,
    root: i64,
    divisor: Divisor,
    /// The largest distance of an end from the moved origin of the line at which the end is accurate enough.
    farthest: i32,
}

/// A line in these coordinates, and the `a` of its roots.
#[derive(Clone, Copy)]
struct Scaled {
    /// The moved origin.
    point: [i32; 3],
    direction: [i32; 3],
    a: i64,
    digits: Normalized,
    /// Lengths are in units of `2^-unit`.
    unit: u32,
    /// The whole unit of `t` at that point.
    start: i32,
    /// The origin was in units of `2^-extra_bits`.
    extra_bits: i32,
    /// Decisions must be certain.
    is_strict: bool,
}

impl Scaled {
    /// The origin is in units of `2^-extra_bits` of the sizes'. It is moved to a point next to the line's closest
    /// point, unless the line `departs`.
    // Not inlined: a shape that may be any cone would contain it twice.
    #[inline(never)]
    fn new(
        o: [i32; 3],
        extra_bits: i32,
        d: [i32; 3],
        [r, g, h]: [i32; 3],
        departs: bool,
        is_strict: bool,
    ) -> Attempt<Self> {
        // The proportions, the larger one above 1/2 and at most 1 in units of 2^-30.
        let free = leading_zeros(magnitude_bits(g) | (h - 1) as u32 | 1);
        let radius = r << (extra_bits & 0x1f);
        if free < 2 || !(0..28).contains(&extra_bits) || radius >> extra_bits != r {
            return Attempt::Unsure;
        }
        let (g, h) = (g << (free - 2), h << (free - 2));
        // The origin is moved to the whole unit of t next to the point closest to the frame's origin. The products are
        // exact, and the lengths are those of the cone and of the line's distance from it, however far away the ray
        // starts.
        let closest = if departs {
            0
        } else {
            -((product(o[0], d[0]) + product(o[1], d[1]) + product(o[2], d[2])) >> (30 + extra_bits))
        };
        if closest != closest as i32 as i64
            || extra_bits + 32 - (closest.unsigned_abs() as u32).leading_zeros() as i32 > 31
        {
            return Attempt::Unsure;
        }
        let start = closest as i32;
        let walked = |length: i32, d: i32| ((length as i64) << 30) + product(start << extra_bits, d);
        let near = [walked(o[0], d[0]), walked(o[1], d[1]), walked(o[2], d[2])];
        let radius = (radius as i64) << 30;
        // Lengths on a grid on which none has more than 29 bits.
        let [hx, hy, hz] = near.map(|length| magnitude_bits(high(length)));
        let zeros = leading_zeros(hx | hy | hz | high(radius) as u32 | 1);
        if zeros < 4 {
            return Attempt::Unsure;
        }
        let up = zeros - 3;
        let unit = (up as i32 - 2 + extra_bits) as u32;
        // Truncated towards zero, so that a mirrored line has mirrored points.
        let on_grid = |length: i64| {
            let magnitude = length.unsigned_abs();
            let length_on_grid = (((magnitude >> 32) as u32) << up | (magnitude as u32) >> (32 - up)) as i32;
            if length < 0 { -length_on_grid } else { length_on_grid }
        };
        let along = |length: i64, proportion: i32| nearest(product(on_grid(length), proportion));
        let (x, y, z) = (along(near[0], h), along(radius, h) + along(near[1], g), along(near[2], h));
        let [dx, dy, dz] = [nearest(product(d[0], h)), nearest(product(d[1], g)), nearest(product(d[2], h))];

        let a = square(dx) + square(dz) - square(dy);
        let Some(digits) = Normalized::new(a) else {
            return Attempt::Unsure;
        };
        Attempt::Hit(Self { point: [x, y, z], direction: [dx, dy, dz], a, digits, unit, start, extra_bits, is_strict })
    }

    /// The number of bits by which the coordinates are finer than an eighth of the type's unit, and a framed origin
    /// than a fourth, if the roots multiply errors by `2^shift`.
    #[inline(always)]
    fn spare(&self) -> i32 {
        let shift = self.digits.shift as i32;
        let spare = self.unit as i32 - 3 - shift;
        // The error of a framed origin is half of its own unit.
        if self.extra_bits == 0 { spare } else { spare.min(self.extra_bits - 2 - shift) }
    }

    /// The exponent of the error of a coordinate, in its units, if it comes from a framed origin.
    #[inline(always)]
    fn framed_bits(&self) -> i32 {
        framed_bits(self.extra_bits, self.unit as i32)
    }

    #[inline(always)]
    fn k(&self) -> i64 {
        let ([x, y, z], [dx, dy, dz]) = (self.point, self.direction);
        product(x, dx) + product(z, dz) - product(y, dy)
    }

    /// Whether the point halfway between the roots, at `t = -k / a`, is in the nappe whose outline is positive: the
    /// sign there is that of `Y a - dY k`.
    #[inline(always)]
    fn is_middle_inside(&self, k: i64) -> Attempt<bool> {
        let (a, k) = (high(self.a << 2), high(k << 2));
        let middle = product(self.point[1], a) - product(self.direction[1], k);
        // If strict: the sum of the errors of Y a and dY k is 2^35, and 2^31.4 more for each unit of error of a framed
        // origin.
        let doubtful = if self.is_strict { 36.max(34 + self.framed_bits()) } else { 34 };
        if middle.unsigned_abs() >> doubtful == 0 { Attempt::Unsure } else { Attempt::Hit(middle > 0) }
    }
}

impl AtCone {
    /// The origin is in units of `2^-extra_bits` of the sizes'.
    // Not inlined, as above.
    #[inline(never)]
    fn new(o: [i32; 3], extra_bits: i32, d: [i32; 3], outline: [i32; 3], is_strict: bool) -> Attempt<Self> {
        let line = found!(Scaled::new(o, extra_bits, d, outline, false, is_strict));
        let ([x, y, z], [dx, dy, dz]) = (line.point, line.direction);
        let wx = nearest(product(y, dz) - product(z, dy));
        let wy = nearest(product(z, dx) - product(x, dz));
        let wz = nearest(product(x, dy) - product(y, dx));
        let discriminant = square(wx) + square(wz) - square(wy);
        // The rounding of the coordinates, up to 1.5 units perpendicular to the axis and 3 along it, changes D by at
        // most ten times this.
        let moment = wx.unsigned_abs() as i64 + wy.unsigned_abs() as i64 + wz.unsigned_abs() as i64;
        // If strict: by 16 times this, and by 4 times this for each unit of error of a framed origin.
        let doubt = moment << if is_strict { 5.max(3 + line.framed_bits()) } else { 4 };
        if discriminant < -doubt && line.a > 0 {
            return Attempt::Miss;
        }
        if is_strict && discriminant <= doubt {
            return Attempt::Unsure;
        }
        // It changes t by at most half a unit (a twentieth in all measurements), if the root is not small relative to
        // the moment.
        let spare = line.spare();
        if high(discriminant) <= 0 || spare < 0 {
            return Attempt::Unsure;
        }
        let root = root(discriminant as u64) as i64;
        if root < moment >> spare {
            return Attempt::Unsure;
        }
        let k = line.k();
        let divisor = line.digits.divisor();
        // Farther away the rounding of a turned direction matters: an error of 2^-31 of t, which a small root enlarges
        // likewise.
        let more = leading_zeros(root as u32) as i32 - leading_zeros(moment as u32) as i32 + 1;
        let farthest = (1 << if extra_bits == 0 { 24 } else { (28 - more).clamp(0, 24) }) >> divisor.shift;
        Attempt::Hit(Self { line, k, root, divisor, farthest })
    }

    #[inline(always)]
    fn end(&self, numerator: i64) -> (i32, bool) {
        let (Scaled { start, a, unit, .. }, farthest) = (self.line, self.farthest);
        match self.divisor.quotient(numerator, 30 + unit) {
            Some(t) if -farthest < t && t < farthest => match start.checked_add(t) {
                Some(t) => (t, true),
                None => (start.saturating_add(t), false),
            },
            _ if (numerator < 0) == (a < 0) => (start.saturating_add(farthest), false),
            _ => (start.saturating_sub(farthest), false),
        }
    }
}

impl Roots for AtCone {
    type Length = i32;

    const ZERO: i32 = 0;
    const INFINITY: i32 = i32::MAX;

    #[inline(always)]
    fn start(&self) -> i32 {
        self.line.start
    }

    #[inline(always)]
    fn is_steep(&self) -> bool {
        self.line.a < 0
    }

    #[inline(always)]
    fn rises(&self) -> bool {
        self.line.direction[1] > 0
    }

    #[inline(always)]
    fn is_middle_inside(&self) -> Attempt<bool> {
        self.line.is_middle_inside(self.k)
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
/// The origin is in units of `2^-extra_bits` of the sizes'; the answer is in the sizes'.
#[inline(always)]
pub(in crate::scalar) fn nappe(
    o: [i32; 3],
    extra_bits: i32,
    d: [i32; 3],
    outline: [i32; 3],
    is_strict: bool,
) -> Attempt<InSide<i32>> {
    found!(AtCone::new(o, extra_bits, d, outline, is_strict)).in_nappe()
}

/// Where the line is inside both nappes of the cone of slope `g / h` about its apex at the origin: between its ends, or
/// (`true`) before the first and after the second.
#[inline(always)]
pub(in crate::scalar) fn double_cone(
    o: [i32; 3],
    extra_bits: i32,
    d: [i32; 3],
    [g, h]: [i32; 2],
    is_strict: bool,
) -> Attempt<([i32; 2], bool)> {
    found!(AtCone::new(o, extra_bits, d, [0, g, h], is_strict)).in_both()
}

/// Where a line that begins in the side of [`nappe`] leaves that nappe: the other root of `a t^2 + 2 k t`, whatever its
/// rounded coordinates are; the largest number if it does not leave it.
#[inline]
pub(in crate::scalar) fn exit_from_nappe(
    o: [i32; 3],
    extra_bits: i32,
    d: [i32; 3],
    outline: [i32; 3],
    is_strict: bool,
) -> Attempt<i32> {
    let line = found!(Scaled::new(o, extra_bits, d, outline, true, is_strict));
    let (k, shift) = (line.k(), line.digits.shift);
    // The rounding of the coordinates changes t by at most a fourth of a unit.
    if line.spare() < 3 {
        return Attempt::Unsure;
    }
    let Some(t) = line.digits.divisor().quotient(-2 * k, 30 + line.unit) else {
        return Attempt::Unsure;
    };
    if line.a < 0 {
        // The line is steeper than the side: a half-line lies in each nappe, and that of this nappe has no end.
        return if t < -1 && line.direction[1] > 0 { Attempt::Hit(i32::MAX) } else { Attempt::Unsure };
    }
    if 0 < t && t < 1 << 24 >> shift && found!(line.is_middle_inside(k)) { Attempt::Hit(t) } else { Attempt::Unsure }
}
