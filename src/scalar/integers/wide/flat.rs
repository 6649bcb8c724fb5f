//! A line and planes across the y axis.

use super::quotient::Normalized;
use super::{Digits, FINER, carried, product, refined, rounded, upper_bits};
use crate::scalar::Attempt;

/// Where the line crosses each of the heights: `t = (y - oy) / dy`. A line that stays in one height meets none of them.
///
/// The origin is in units of `2^-finer` of the heights'; the answer is in the heights'.
#[inline(always)]
pub(in crate::scalar) fn crossings(oy: i64, finer: i32, dy: i64, [low, high]: [i64; 2]) -> Attempt<[i64; 2]> {
    if dy == 0 {
        return Attempt::Miss;
    }
    // Up to 2^60 differences fit.
    let (Some(low), Some(high)) = (refined(low, finer), refined(high, finer)) else {
        return Attempt::Unsure;
    };
    if (upper_bits(oy) | upper_bits(low) | upper_bits(high)) >> 28 != 0 {
        return Attempt::Unsure;
    }
    let Some(divisor) = Normalized::new((dy as i128) << 62).map(Normalized::divisor) else {
        return Attempt::Unsure;
    };
    // A framed origin is rounded to a five-hundredth of a unit, which a line almost in the plane makes more of.
    if finer != 0 && divisor.shift > 6 {
        return Attempt::Unsure;
    }
    match (divisor.quotient_of_length(low - oy, finer), divisor.quotient_of_length(high - oy, finer)) {
        (Some(low), Some(high)) => Attempt::Found([low, high]),
        _ => Attempt::Unsure,
    }
}

/// The height `oy + t dy`, rounded to the unit of `t`; the origin is in units of `2^-finer` of that.
#[inline(always)]
pub(in crate::scalar) fn height(oy: i64, finer: i32, dy: i64, t: i64) -> Attempt<i64> {
    // Up to 2^60 the sum fits, and up to 2^52 it does in the units of a frame.
    if (upper_bits(oy) | upper_bits(t)) >> 28 != 0 || !(finer == 0 || finer == FINER && upper_bits(t) >> 20 == 0) {
        return Attempt::Unsure;
    }
    let (t, dy) = (Digits::new(t), Digits::new(dy));
    let climbed = carried(product(t.high, dy.high), t.middle(dy), product(t.low, dy.low) as i128);
    let climbed = if finer == 0 { climbed } else { climbed << FINER };
    Attempt::Found(rounded(((oy as i128) << 62) + climbed, finer))
}

/// `oy - y` in units of `2^-finer` of those of `y`.
#[inline(always)]
pub(in crate::scalar) fn lowered(oy: i64, finer: i32, y: i64) -> Attempt<i64> {
    // Up to 2^60 the difference fits, and so does its moment.
    match refined(y, finer) {
        Some(y) if (upper_bits(oy) | upper_bits(y)) >> 28 == 0 => Attempt::Found(oy - y),
        _ => Attempt::Unsure,
    }
}
