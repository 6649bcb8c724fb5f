//! A line and a cone's side.

use super::quotient::Divisor;
use super::{high, leading_zeros, magnitude_bits, product, root, square};
use crate::scalar::{Plain, PlainNappe};

/// Where the line is inside the nappe `h^2 (x^2 + z^2) <= (h r + g y)^2`, `h r + g y >= 0`, of a cone with radius `r` at `y = 0` that
/// grows by `g` over the height `h`.
///
/// In coordinates scaled by `h` across the axis and by the outline along it, `X = h x`, `Z = h z`, `Y = h r + g y`, the cone is
/// `X^2 + Z^2 = Y^2`, and the line's moment `W` gives `D = Wx^2 + Wz^2 - Wy^2`. The origin is in units of `2^-finer` of the
/// sizes'; the answer is in the sizes'.
#[inline(always)]
pub(in crate::scalar) fn nappe(o: [i32; 3], finer: i32, d: [i32; 3], [r, g, h]: [i32; 3]) -> Plain<PlainNappe<i32>> {
    // The proportions, the larger one above 1/2 and at most 1 in units of 2^-30.
    let free = leading_zeros(magnitude_bits(g) | (h - 1) as u32 | 1);
    let radius = r << (finer & 0x1f);
    if free < 2 || !(0..28).contains(&finer) || radius >> finer != r {
        return Plain::Unclear;
    }
    let (g, h) = (g << (free - 2), h << (free - 2));
    // Lengths on a grid on which none has more than 29 bits.
    let all = magnitude_bits(o[0]) | magnitude_bits(o[1]) | magnitude_bits(o[2]) | radius as u32 | 1;
    if all >= 1 << 29 {
        return Plain::Unclear;
    }
    let grid = leading_zeros(all) - 3;
    let unit = grid + finer as u32;
    let nearest = |n: i64| high((n + (1 << 29)) << 2);
    let along = |length: i32, proportion: i32| nearest(product(length << grid, proportion));
    let (x, y, z) = (along(o[0], h), along(radius, h) + along(o[1], g), along(o[2], h));
    let [dx, dy, dz] = [nearest(product(d[0], h)), nearest(product(d[1], g)), nearest(product(d[2], h))];

    let a = square(dx) + square(dz) - square(dy);
    let Some(divisor) = Divisor::new(a) else {
        return Plain::Unclear;
    };
    let wx = nearest(product(y, dz) - product(z, dy));
    let wy = nearest(product(z, dx) - product(x, dz));
    let wz = nearest(product(x, dy) - product(y, dx));
    let discriminant = square(wx) + square(wz) - square(wy);
    // The coordinates' rounding moves D by no more than eight times this.
    let moment = wx.unsigned_abs() as i64 + wy.unsigned_abs() as i64 + wz.unsigned_abs() as i64;
    if discriminant < -(moment << 3) && a > 0 {
        return Plain::Miss;
    }
    // ... and t by no more than an eighth of a unit, if the root is not small against the moment.
    let spare = unit as i32 - 6 - divisor.shift as i32;
    if high(discriminant) <= 0 || spare < 0 {
        return Plain::Unclear;
    }
    let root = root(discriminant as u64) as i64;
    if root < moment >> spare {
        return Plain::Unclear;
    }
    let k = product(x, dx) + product(z, dz) - product(y, dy);
    let end = |numerator: i64| {
        let t = divisor.quotient(numerator, 30 + unit)?;
        // Farther away, the rounding of the direction counts.
        (magnitude_bits(t) < (1 << 24) >> divisor.shift).then_some(t)
    };
    let first = -k - (root << 30);
    let second = (root << 30) - k;
    if a < 0 {
        // Steeper than the side: a half-line in each nappe; the outline grows along the one in the upper.
        return match (dy > 0, end(if dy > 0 { first } else { second })) {
            (true, Some(t)) => Plain::Found(PlainNappe::From(t)),
            (false, Some(t)) => Plain::Found(PlainNappe::Until(t)),
            _ => Plain::Unclear,
        };
    }
    // The sign of the outline halfway between the ends, at t = -k / a, is that of Y a - dY k.
    let middle = product(y, high(a << 2)) - product(dy, high(k << 2));
    if middle.unsigned_abs() >> 34 == 0 {
        return Plain::Unclear;
    }
    if middle < 0 {
        return Plain::Miss;
    }
    match (end(first), end(second)) {
        (Some(low), Some(high)) => Plain::Found(PlainNappe::Between([low, high])),
        _ => Plain::Unclear,
    }
}
