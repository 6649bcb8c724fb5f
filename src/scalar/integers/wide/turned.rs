//! Transformation of a line to a frame.

use super::{Digits, digits, dot, round_off, upper_bits};

/// The number of extra bits of the origin below the type's unit: its rounding error is then a five-hundredth of a unit.
pub(in crate::scalar) const FINER: i32 = 8;

/// As that of 32 bits.
pub(in crate::scalar) struct Turned {
    pub(in crate::scalar) start: i64,
    pub(in crate::scalar) origin: [i64; 3],
    pub(in crate::scalar) extra_bits: i32,
    pub(in crate::scalar) direction: [i64; 3],
}

/// The line in the frame of these axes, with its origin in units of `2^-FINER` of the type's; `None` if the origin is
/// too far away.
#[inline(always)]
pub(in crate::scalar) fn turned(o: [i64; 3], position: [i64; 3], axes: [[i64; 3]; 3], d: [i64; 3]) -> Option<Turned> {
    let apart = |o: i64, position: i64| o.wrapping_sub(position);
    let from = [apart(o[0], position[0]), apart(o[1], position[1]), apart(o[2], position[2])];
    // Up to 2^52 from the frame's origin on each axis, all products fit, and so does the moment of the result.
    if (upper_bits(from[0]) | upper_bits(from[1]) | upper_bits(from[2])) >> 20 != 0 {
        return None;
    }
    let (from, d) = (digits(from.map(|length| length << FINER)), digits(d));
    let seen = |v: [Digits; 3]| {
        let along = |axis: [i64; 3]| round_off::<62>(dot(v, digits(axis)));
        [along(axes[0]), along(axes[1]), along(axes[2])]
    };
    Some(Turned { start: 0, origin: seen(from), extra_bits: FINER, direction: seen(d) })
}
