//! A line and the round side of a cylinder, without its ends.

use super::quotient::Normalized;
use super::{framed_bits, half, high, high_product, leading_zeros, more_bits, product, root, square};
use crate::scalar::Attempt;

/// Where the line is inside the infinite cylinder about the y axis: `a = dx^2 + dz^2`, `D = a r^2 - w_y^2`,
/// `t = (-k -+ sqrt(D)) / a`.
///
/// The origin is in units of `2^-extra_bits` of the radius's; the answer is in the radius's. With `is_strict` only if
/// it is certain whether the line is inside.
#[inline(always)]
pub(in crate::scalar) fn tube(o: [i32; 3], extra_bits: i32, d: [i32; 3], r: i32, is_strict: bool) -> Attempt<[i32; 2]> {
    let ([x, _, z], [dx, _, dz]) = (o, d);
    // As for a ball: a grid on which the radius has 29 bits, and the moment shifted down to it.
    let grid = leading_zeros(r as u32) as i32 - 3;
    let down = 30 + extra_bits - grid;
    if grid < 4 || !(3..32).contains(&down) {
        return Attempt::Unsure;
    }
    let down = down as u32;
    let wy = (product(z, dx) - product(x, dz)).unsigned_abs();
    // Twice the radius or more.
    let above = (wy >> 32) as u32;
    if above >> (down - 2) != 0 {
        return Attempt::Miss;
    }
    let wy = half((above << (33 - down)) | (wy as u32 >> (down - 1)));
    let r = r << grid;
    let a = square(dx) + square(dz);
    let Some(digits) = Normalized::new(a) else {
        return Attempt::Unsure;
    };
    // 2 a r, and a r^2; without the shift both have full precision.
    let twice = high_product(digits.digits, (r as u32) << 2) as i32;
    let positive = product(twice, r) >> (1 + digits.shift);
    let discriminant = positive - square(wy);
    // Their rounding is below 2^31, that of the moment below 2^30, and what a framed origin adds below 2^31 times its
    // error.
    let doubt = if is_strict { 1 << framed_bits(extra_bits, grid) } else { 1 };
    if high(discriminant) < -doubt {
        return Attempt::Miss;
    }
    // The rounding of the moment, half a unit of the grid, changes t by at most a thirtieth of a unit (near the upper
    // limit of the radius, a fifth).
    let spare = grid - digits.shift as i32;
    // The error of a framed origin, a hundredth of a unit, becomes a sixth of a unit if the root is a sixteenth of the
    // radius, or if the direction is at an angle of an eighth to the axis. With each further bit of the origin the root
    // may be half as large.
    let (most, steep) = if extra_bits == 0 { (22, 63) } else { (8 + 2 * more_bits(extra_bits, grid), 6) };
    let least = high(positive) >> (2 * (spare - 5)).clamp(3, most);
    if spare < 4 || digits.shift > steep || high(discriminant) <= least || (is_strict && high(discriminant) <= doubt) {
        return Attempt::Unsure;
    }
    let divisor = digits.divisor();
    let root = (root(discriminant as u64) as i64) << down;
    let k = product(x, dx) + product(z, dz);
    let unit = (30 + extra_bits) as u32;
    match (divisor.quotient(-k - root, unit), divisor.quotient(root - k, unit)) {
        (Some(low), Some(high)) => Attempt::Hit([low, high]),
        _ => Attempt::Unsure,
    }
}
