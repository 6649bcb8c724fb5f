//! A line and planes across the y axis.

use super::quotient::Normalized;
use crate::scalar::Plain;

/// Where the line crosses each of the heights: `t = (y - oy) / dy`. A line that stays in one height meets none of them.
///
/// The origin is in units of `2^-finer` of the heights'; the answer is in the heights'.
#[inline(always)]
pub(in crate::scalar) fn crossings(oy: i32, finer: i32, dy: i32, [low, high]: [i32; 2]) -> Plain<[i32; 2]> {
    if dy == 0 {
        return Plain::Miss;
    }
    if !(0..28).contains(&finer) {
        return Plain::Unclear;
    }
    let Some(divisor) = Normalized::new((dy as i64) << 30).map(Normalized::divisor) else {
        return Plain::Unclear;
    };
    let above = |y: i32| ((y as i64) << finer) - oy as i64;
    let (low, high) = (above(low), above(high));
    if (low.unsigned_abs() | high.unsigned_abs()) >> 33 != 0 {
        return Plain::Unclear;
    }
    // With 28 bits more, so that the quotient has room for its fraction.
    let unit = 28 + finer as u32;
    match (divisor.quotient(low << 28, unit), divisor.quotient(high << 28, unit)) {
        (Some(low), Some(high)) => Plain::Found([low, high]),
        _ => Plain::Unclear,
    }
}
