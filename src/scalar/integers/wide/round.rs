//! A line and the round side of a cylinder, without its ends.

use super::quotient::{Normalized, upper_product};
use super::{
    Digits, FINER, carried, digits, dot, down, down_by_few, down_to_64, high, leading_zeros, minor, product, root,
    squared, up_to_128, upper_bits, words,
};
use crate::scalar::Attempt;

/// Where the line is inside the infinite cylinder about the y axis: `a = dx^2 + dz^2`, `D = a r^2 - w_y^2`,
/// `t = (-k -+ sqrt(D)) / a`.
///
/// The origin is in units of `2^-extra_bits` of the radius's; the answer is in the radius's.
#[inline(always)]
pub(in crate::scalar) fn tube(o: [i64; 3], extra_bits: i32, d: [i64; 3], r: i64) -> Attempt<[i64; 2]> {
    // As for a ball: a grid on which the radius has 61 bits, and the moment shifted down to it.
    let [low, above] = words(r as u64);
    if above >= 1 << 21 || (upper_bits(o[0]) | upper_bits(o[2])) >= 1 << 29 || !(extra_bits == 0 || extra_bits == FINER)
    {
        return Attempt::Unsure;
    }
    let (top, grid) = if above != 0 { (above, 0) } else { (low, 32) };
    let grid = leading_zeros(top | 1) + grid - 3;
    let less = 62 + extra_bits as u32 - grid;
    let ([x, _, z], [dx, _, dz]) = (digits(o), digits(d));
    let wy = minor([z, x], [dz, dx]).unsigned_abs();
    // Twice the radius or more.
    if down_to_64(wy >> 64, less - 2) != 0 {
        return Attempt::Miss;
    }
    let wy = Digits::new(((down_to_64(wy, less - 1) + 1) >> 1) as i64);
    let r = up_to_128(r as u64, grid) as u64;
    let Some(digits) = Normalized::new(squared(dx) + squared(dz)) else {
        return Attempt::Unsure;
    };
    // a r, and a r^2; before it is shifted down both have full precision.
    let scaled = Digits::new(upper_product(digits.digits, r << 1) as i64);
    let r = Digits::new(r as i64);
    let positive = carried(product(scaled.high, r.high), scaled.middle(r), product(scaled.low, r.low) as i128);
    let positive = down_by_few(positive, digits.shift - 1);
    let discriminant = positive - squared(wy);
    // The rounding of the moment, half a unit of the grid, changes t by at most a thirtieth of a unit, that of a framed
    // origin by at most a twentieth.
    let spare = grid.wrapping_sub(digits.shift) as i32;
    if spare < 8 || extra_bits != 0 && digits.shift > 6 {
        return Attempt::Unsure;
    }
    let certain =
        down(high(positive), if extra_bits == 0 { (2 * (spare as u32 - 5)).min(30) } else { 8 - digits.shift });
    if high(discriminant) < certain {
        return if high(discriminant) < -certain { Attempt::Miss } else { Attempt::Unsure };
    }
    let divisor = digits.divisor();
    let root = up_to_128(root(discriminant), less) as i128;
    let k = dot([x, z], [dx, dz]);
    match (divisor.quotient(-k - root, extra_bits), divisor.quotient(root - k, extra_bits)) {
        (Some(low), Some(high)) => Attempt::Hit([low, high]),
        _ => Attempt::Unsure,
    }
}
