//! Where a line's origin is placed before it is turned into a frame, and with how many bits.

use super::{leading_zeros, magnitude_bits, product};
use crate::scalar::integers::length::Length;

/// The largest number of extra bits, for lines next to the frame's origin.
pub(super) const FINEST: i32 = 12;

/// Bits of the lengths of a line with more extra bits than [`Length::FINER`]: one less than there is room for, so that
/// two may be added.
pub(super) const LENGTH_BITS: i32 = 29;

/// The extra bits of a line that passes far away: its rounding error, a sixteenth of a unit, is too large for a hit,
/// but not for a miss.
const COARSE: i32 = 3;

/// [`Length::placed`]. The origin is moved next to the frame's if the line starts far from there.
#[inline(always)]
pub(super) fn placed(from: [i32; 3], d: [i32; 3]) -> Option<(i32, [i32; 3], i32)> {
    // Up to 2^24 from the frame's origin on each axis, all products fit, and so does the result.
    let bits = magnitude_bits(from[0]) | magnitude_bits(from[1]) | magnitude_bits(from[2]);
    if bits >> 24 != 0 {
        return closest(from, d, FINEST);
    }
    let extra_bits = room(bits).clamp(i32::FINER, FINEST);
    Some((0, from.map(|length| length << extra_bits), extra_bits))
}

/// The number of extra bits for which lengths have room, if the longest has these bits.
#[inline(always)]
pub(super) fn room(bits: u32) -> i32 {
    LENGTH_BITS - 32 + leading_zeros(bits | 1) as i32
}

/// The whole unit of `t` next to the point closest to the frame's origin, and that point in units of `2^-extra_bits`,
/// at most `2^-finest`.
#[inline]
pub(super) fn closest(from: [i32; 3], d: [i32; 3], finest: i32) -> Option<(i32, [i32; 3], i32)> {
    // The difference of points within the budget of coordinates, which is 2^30, overflows only at the ends of the
    // budget.
    if from.iter().any(|&length| magnitude_bits(length) >> 30 != 0) {
        return None;
    }
    let t = i32::try_from(-(i32::dot(from, d) >> 30)).ok()?;
    // Exact in units of 2^-30.
    let walked = |from: i32, d: i32| ((from as i64) << 30) + product(t, d);
    let exact = [walked(from[0], d[0]), walked(from[1], d[1]), walked(from[2], d[2])];
    // The part below whole units is rounded only once, however far away the ray begins.
    let bits = exact.into_iter().fold(0, |all, length| all | length.unsigned_abs()) >> 30;
    let extra_bits = match bits {
        0..0x100_0000 => room(bits as u32).clamp(i32::FINER, finest),
        0x100_0000..0x800_0000 => COARSE,
        _ => return None,
    };
    let rounded = |length: i64| ((length + (1 << (29 - extra_bits))) >> (30 - extra_bits)) as i32;
    Some((t, [rounded(exact[0]), rounded(exact[1]), rounded(exact[2])], extra_bits))
}
