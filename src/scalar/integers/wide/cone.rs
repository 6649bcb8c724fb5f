//! A line and a cone's side.

use super::quotient::{Divisor, Normalized};
use super::{
    Digits, FINER, digits, dot, down_to_64, high, leading_zeros, minor, refined, root, round_off, squared, up_to_128,
    upper_bits, words,
};
use crate::scalar::{Attempt, InNappe, found};

/// A line and both nappes of a cone, in the coordinates that the kernel of 32 bits describes.
struct Roots {
    /// Of the point where the line is taken up.
    y: Digits,
    dy: i64,
    a: i128,
    k: i128,
    root: u64,
    divisor: Divisor,
    /// Lengths are in units of `2^-unit`.
    unit: u32,
    /// The whole unit of `t` at that point.
    start: i64,
    /// Ends are only good enough so far from there.
    farthest: i64,
}

/// The zeros above a number that is not zero.
#[inline(always)]
fn zeros_above(n: u64) -> u32 {
    let [low, high] = words(n);
    if high != 0 { leading_zeros(high) } else { 32 + leading_zeros(low | 1) }
}

/// `length * proportion`, of which that has 62 bits below the point, rounded to nearest.
#[inline(always)]
fn along(length: i64, proportion: Digits) -> i64 {
    round_off::<62>(dot([Digits::new(length)], [proportion]))
}

impl Roots {
    /// The origin is in units of `2^-finer` of the sizes'.
    // Not inlined: a shape that may be any cone has it twice.
    #[inline(never)]
    fn new(o: [i64; 3], finer: i32, d: [i64; 3], [r, g, h]: [i64; 3]) -> Attempt<Self> {
        let Some(radius) = refined(r, finer) else { return Attempt::Unsure };
        if (upper_bits(o[0]) | upper_bits(o[1]) | upper_bits(o[2]) | upper_bits(radius)) >> 28 != 0 {
            return Attempt::Unsure;
        }
        // The proportions, the larger one above 1/2 and at most 1 in units of 2^-62.
        let free = zeros_above((g ^ (g >> 63)) as u64 | (h - 1) as u64 | 1);
        if free < 2 {
            return Attempt::Unsure;
        }
        let (g, h) = (Digits::new(g << (free - 2)), Digits::new(h << (free - 2)));
        // From the whole unit of t next to the point closest to the frame's origin, as with 32 bits.
        let direction = digits(d);
        let closest = -(dot(digits(o), direction) >> 62 >> finer);
        let start = closest as i64;
        if upper_bits(start << finer) >> 29 != 0 || (start << finer) >> finer != start || start as i128 != closest {
            return Attempt::Unsure;
        }
        let walk = Digits::new(start << finer);
        let walked = |i: usize| ((o[i] as i128) << 62) + dot([walk], [direction[i]]);
        let near = [walked(0), walked(1), walked(2)];
        let radius = (radius as i128) << 62;
        // Lengths on a grid on which none has more than 61 bits.
        let bits = |n: i128| (high(n) ^ (high(n) >> 63)) as u64;
        let zeros = zeros_above(bits(near[0]) | bits(near[1]) | bits(near[2]) | bits(radius) | 1);
        if zeros < 4 {
            return Attempt::Unsure;
        }
        let up = zeros - 3;
        let unit = up as i32 - 2 + finer;
        if unit < 0 {
            return Attempt::Unsure;
        }
        // Cut off towards zero, so that a mirrored line is on mirrored points.
        let on_grid = |length: i128| {
            let on_grid = down_to_64(length.unsigned_abs(), 64 - up) as i64;
            if length < 0 { -on_grid } else { on_grid }
        };
        let x = along(on_grid(near[0]), h);
        let y = along(on_grid(radius), h) + along(on_grid(near[1]), g);
        let z = along(on_grid(near[2]), h);
        let [dx, dy, dz] = [along(d[0], h), along(d[1], g), along(d[2], h)];
        let ([x, y, z], [ex, ey, ez]) = (digits([x, y, z]), digits([dx, dy, dz]));

        let a = squared(ex) + squared(ez) - squared(ey);
        let Some(a_digits) = Normalized::new(a) else {
            return Attempt::Unsure;
        };
        // 1 has one.
        let shift = a_digits.shift as i32 - 1;
        let w = [minor([y, z], [ey, ez]), minor([z, x], [ez, ex]), minor([x, y], [ex, ey])].map(round_off::<62>);
        let [wx, wy, wz] = digits(w);
        let discriminant = squared(wx) + squared(wz) - squared(wy);
        // The coordinates' rounding, of up to 1.5 units across the axis and 3 along it, moves D by no more than ten times this.
        let moment = w.into_iter().fold(0, |sum, w| sum + w.unsigned_abs() as i128);
        if discriminant < -(moment << 4) && a > 0 {
            return Attempt::Miss;
        }
        // The same bounds as with 32 bits.
        let spare = unit - 3 - shift;
        let spare = if finer == 0 { spare } else { spare.min(FINER - 2 - shift) };
        if high(discriminant) <= 0 || high(discriminant) >> 62 != 0 || spare < 0 {
            return Attempt::Unsure;
        }
        let root = root(discriminant);
        // A moment has at most 65 bits.
        let moment = (moment >> 2) as u64;
        if spare < 64 && root >> 2 < moment >> spare {
            return Attempt::Unsure;
        }
        let k = dot([x, z], [ex, ez]) - dot([y], [ey]);
        let divisor = a_digits.divisor();
        // Farther away, the rounding of a turned direction counts, 2^-63 of t, of which a small root makes as much more.
        let more = zeros_above(root) as i32 - zeros_above(moment | 1) as i32 + 3;
        let farthest = (1 << if finer == 0 { 52 } else { (58 - more).clamp(0, 52) }) >> shift.max(0);
        Attempt::Found(Self { y, dy, a, k, root, divisor, unit: unit as u32, start, farthest })
    }

    /// As with 32 bits.
    #[inline(always)]
    fn first(&self) -> (i64, bool) {
        self.end(-self.k - up_to_128(self.root, 62) as i128)
    }

    /// The other one.
    #[inline(always)]
    fn second(&self) -> (i64, bool) {
        self.end(up_to_128(self.root, 62) as i128 - self.k)
    }

    #[inline(always)]
    fn end(&self, numerator: i128) -> (i64, bool) {
        let Self { start, farthest, .. } = *self;
        // What is cut off moves t by 2^-51 at most.
        match self.divisor.quotient(numerator >> self.unit, 0) {
            Some(t) if -farthest < t && t < farthest => (start.saturating_add(t), true),
            _ if (numerator < 0) == (self.a < 0) => (start.saturating_add(farthest), false),
            _ => (start.saturating_sub(farthest), false),
        }
    }
}

/// Where the line is inside the nappe of [`Roots`] in which `h r + g y >= 0`.
///
/// The origin is in units of `2^-finer` of the sizes'; the answer is in the sizes'.
#[inline(always)]
pub(in crate::scalar) fn nappe(o: [i64; 3], finer: i32, d: [i64; 3], outline: [i64; 3]) -> Attempt<InNappe<i64>> {
    let roots = found!(Roots::new(o, finer, d, outline));
    let Roots { y, dy, a, k, start, .. } = roots;
    let (low, high) = if a < 0 {
        // Steeper than the side: a half-line in each nappe; the outline grows along the one in the upper.
        if dy > 0 { (roots.first(), (i64::MAX, true)) } else { ((-i64::MAX, true), roots.second()) }
    } else {
        // The sign of the outline halfway between the ends, at t = -k / a, is that of Y a - dY k.
        let [a, k] = [a, k].map(|n| Digits::new(high(n << 2)));
        let middle = dot([y], [a]) - dot([Digits::new(dy)], [k]);
        if middle.unsigned_abs() >> 66 == 0 {
            return Attempt::Unsure;
        }
        if middle < 0 {
            return Attempt::Miss;
        }
        (roots.first(), roots.second())
    };
    // What begins somewhere beyond one end, or ends somewhere beyond the other, may be anywhere or nowhere.
    if (!low.1 && low.0 > start) || (!high.1 && high.0 < start) {
        return Attempt::Unsure;
    }
    Attempt::Found(InNappe { ends: [low.0, high.0], certain: [low.1, high.1] })
}

/// Where the line is inside both nappes of the cone of slope `g / h` about its apex at the origin: between its ends, or (`true`) beyond
/// them.
#[inline(always)]
pub(in crate::scalar) fn double_cone(
    o: [i64; 3],
    finer: i32,
    d: [i64; 3],
    [g, h]: [i64; 2],
) -> Attempt<([i64; 2], bool)> {
    let roots = found!(Roots::new(o, finer, d, [0, g, h]));
    match (roots.first(), roots.second()) {
        ((first, true), (second, true)) if roots.a < 0 => Attempt::Found(([second, first], true)),
        ((first, true), (second, true)) => Attempt::Found(([first, second], false)),
        _ => Attempt::Unsure,
    }
}
