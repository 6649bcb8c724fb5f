//! A line and planes across the y axis.

use super::quotient::Normalized;
use super::{magnitude_bits, product, round_off};
use crate::scalar::Attempt;

/// Where the line crosses each of the heights: `t = (y - oy) / dy`. A line that stays in one height meets none of them.
///
/// The origin is in units of `2^-finer` of the heights'; the answer is in the heights'.
#[inline(always)]
pub(in crate::scalar) fn crossings(oy: i32, finer: i32, dy: i32, [low, high]: [i32; 2]) -> Attempt<[i32; 2]> {
    if dy == 0 {
        return Attempt::Miss;
    }
    if !(0..28).contains(&finer) {
        return Attempt::Unsure;
    }
    let Some(divisor) = Normalized::new((dy as i64) << 30).map(Normalized::divisor) else {
        return Attempt::Unsure;
    };
    // A framed origin is rounded to a hundredth of a unit, which a line almost in the plane makes more of.
    if finer != 0 && divisor.shift > 3 {
        return Attempt::Unsure;
    }
    let above = |y: i32| ((y as i64) << finer) - oy as i64;
    let (low, high) = (above(low), above(high));
    if (low.unsigned_abs() | high.unsigned_abs()) >> 33 != 0 {
        return Attempt::Unsure;
    }
    // With 28 bits more, so that the quotient has room for its fraction.
    let unit = 28 + finer as u32;
    match (divisor.quotient(low << 28, unit), divisor.quotient(high << 28, unit)) {
        (Some(low), Some(high)) => Attempt::Found([low, high]),
        _ => Attempt::Unsure,
    }
}

/// The height `oy + t dy`, rounded to the unit of `t`; the origin is in units of `2^-finer` of that.
#[inline(always)]
pub(in crate::scalar) fn height(oy: i32, finer: i32, dy: i32, t: i32) -> Attempt<i32> {
    // Up to 2^24 the sum fits, and so does the height.
    if !(0..7).contains(&finer) || magnitude_bits(t) >> 24 != 0 {
        return Attempt::Unsure;
    }
    let height = ((oy as i64) << 30) + (product(t, dy) << finer);
    let height = round_off(height, (30 + finer) as u32);
    if height == height as i32 as i64 { Attempt::Found(height as i32) } else { Attempt::Unsure }
}

/// `oy - y` in units of `2^-finer` of those of `y`.
#[inline(always)]
pub(in crate::scalar) fn lowered(oy: i32, finer: i32, y: i32) -> Attempt<i32> {
    let lowered = oy as i64 - ((y as i64) << (finer & 0x1f));
    // Up to 2^30 its moment fits.
    if lowered.unsigned_abs() >> 30 == 0 && (0..28).contains(&finer) {
        Attempt::Found(lowered as i32)
    } else {
        Attempt::Unsure
    }
}
