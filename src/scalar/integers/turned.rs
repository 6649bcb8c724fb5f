//! Transformation of a line to a frame, in fixed point.

use super::{high, leading_zeros, magnitude_bits, product, round_off};

/// The least number of extra bits of the origin below the type's unit: its rounding error is then a hundredth of a
/// unit.
pub(in crate::scalar) const FINER: i32 = 6;

/// The largest number of extra bits, for lines next to the frame's origin.
pub(super) const FINEST: i32 = 12;

/// Bits of the lengths of a line with more extra bits than [`FINER`]: one less than there is room for, so that two may
/// be added.
pub(super) const LENGTH_BITS: i32 = 29;

/// The extra bits of a line that passes far away: its rounding error, a sixteenth of a unit, is too large for a hit,
/// but not for a miss.
pub(in crate::scalar) const COARSE: i32 = 3;

/// The origin of a line in a frame, moved next to the frame's origin if the line starts far from there.
pub(in crate::scalar) struct Turned {
    /// The ray's `t` there.
    pub(in crate::scalar) start: i32,
    /// The point in units of `2^-extra_bits` of the type's.
    pub(in crate::scalar) origin: [i32; 3],
    /// From [`FINER`] to [`FINEST`], or [`COARSE`].
    pub(in crate::scalar) extra_bits: i32,
    pub(in crate::scalar) direction: [i32; 3],
}

/// The line in the frame of these axes; `None` if it is too far away for that.
#[inline(always)]
pub(in crate::scalar) fn turned(o: [i32; 3], position: [i32; 3], axes: [[i32; 3]; 3], d: [i32; 3]) -> Option<Turned> {
    let apart = |o: i32, position: i32| o.wrapping_sub(position);
    let from = [apart(o[0], position[0]), apart(o[1], position[1]), apart(o[2], position[2])];
    // Up to 2^24 from the frame's origin on each axis, all products fit, and so does the result.
    let bits = magnitude_bits(from[0]) | magnitude_bits(from[1]) | magnitude_bits(from[2]);
    let (start, point, extra_bits) = if bits >> 24 == 0 {
        let extra_bits = room(bits).clamp(FINER, FINEST);
        (0, from.map(|length| length << extra_bits), extra_bits)
    } else {
        closest(from, d, FINEST)?
    };
    let nearest = |n: i64| high((n + (1 << 29)) << 2);
    let (origin, direction) = (axes.map(|axis| nearest(dot(point, axis))), axes.map(|axis| nearest(dot(d, axis))));
    Some(Turned { start, origin, extra_bits, direction })
}

#[inline(always)]
pub(super) fn dot([x, y, z]: [i32; 3], [a, b, c]: [i32; 3]) -> i64 {
    product(x, a) + product(y, b) + product(z, c)
}

/// The number of extra bits for which lengths have room, if the longest has these bits.
#[inline(always)]
pub(super) fn room(bits: u32) -> i32 {
    LENGTH_BITS - 32 + leading_zeros(bits | 1) as i32
}

/// The number of extra bits of a turned line for which the lengths of a solid with the bounding radius
/// `bounding_radius` have room too; at least [`FINER`].
#[inline(always)]
pub(in crate::scalar) fn fitting(bounding_radius: i32) -> i32 {
    room(bounding_radius as u32).max(FINER)
}

/// The point in a unit that is larger by this number of bits.
#[cold]
#[inline(never)]
pub(in crate::scalar) fn coarser(origin: [i32; 3], bits: u32) -> [i32; 3] {
    origin.map(|length| round_off(length as i64, bits) as i32)
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
    let t = i32::try_from(-(dot(from, d) >> 30)).ok()?;
    // Exact in units of 2^-30.
    let walked = |from: i32, d: i32| ((from as i64) << 30) + product(t, d);
    let exact = [walked(from[0], d[0]), walked(from[1], d[1]), walked(from[2], d[2])];
    // The part below whole units is rounded only once, however far away the ray begins.
    let bits = exact.into_iter().fold(0, |all, length| all | length.unsigned_abs()) >> 30;
    let extra_bits = match bits {
        0..0x100_0000 => room(bits as u32).clamp(FINER, finest),
        0x100_0000..0x800_0000 => COARSE,
        _ => return None,
    };
    let rounded = |length: i64| ((length + (1 << (29 - extra_bits))) >> (30 - extra_bits)) as i32;
    Some((t, [rounded(exact[0]), rounded(exact[1]), rounded(exact[2])], extra_bits))
}
