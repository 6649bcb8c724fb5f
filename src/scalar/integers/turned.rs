//! A line seen from a frame.

use super::{high, magnitude_bits, product};

/// How much finer than the type's unit the origin is kept: its rounding is then a hundredth of a unit.
pub(in crate::scalar) const FINER: i32 = 6;

/// The same of a line that passes far away: its rounding, a sixteenth of a unit, is too much for a hit, but not for a miss.
pub(in crate::scalar) const COARSE: i32 = 3;

/// Where a line is taken up, next to the frame's origin if it begins far from there.
pub(in crate::scalar) struct Turned {
    /// The ray's `t` there.
    pub(in crate::scalar) start: i32,
    /// The point in units of `2^-finer` of the type's.
    pub(in crate::scalar) origin: [i32; 3],
    /// [`FINER`] or [`COARSE`].
    pub(in crate::scalar) finer: i32,
    pub(in crate::scalar) direction: [i32; 3],
}

/// The line in the frame of these axes; `None` if it is too far away for that.
#[inline(always)]
pub(in crate::scalar) fn turned(o: [i32; 3], position: [i32; 3], axes: [[i32; 3]; 3], d: [i32; 3]) -> Option<Turned> {
    let apart = |o: i32, position: i32| o.wrapping_sub(position);
    let from = [apart(o[0], position[0]), apart(o[1], position[1]), apart(o[2], position[2])];
    // Up to 2^24 from the frame's origin on each axis, all products fit, and so does the result.
    let (start, point, finer) =
        if is_near(from) { (0, from.map(|length| length << FINER), FINER) } else { closest(from, d)? };
    let nearest = |n: i64| high((n + (1 << 29)) << 2);
    let (origin, direction) = (axes.map(|axis| nearest(dot(point, axis))), axes.map(|axis| nearest(dot(d, axis))));
    Some(Turned { start, origin, finer, direction })
}

#[inline(always)]
fn dot([x, y, z]: [i32; 3], [a, b, c]: [i32; 3]) -> i64 {
    product(x, a) + product(y, b) + product(z, c)
}

#[inline(always)]
fn is_near([x, y, z]: [i32; 3]) -> bool {
    (magnitude_bits(x) | magnitude_bits(y) | magnitude_bits(z)) >> 24 == 0
}

/// The whole unit of `t` next to the point closest to the frame's origin, and that point in units of `2^-finer`.
#[inline]
fn closest(from: [i32; 3], d: [i32; 3]) -> Option<(i32, [i32; 3], i32)> {
    // Between points within the budget of coordinates, which is 2^30, nothing has overflowed but at its very ends.
    if from.iter().any(|&length| magnitude_bits(length) >> 30 != 0) {
        return None;
    }
    let t = i32::try_from(-(dot(from, d) >> 30)).ok()?;
    // Exact in units of 2^-30.
    let walked = |from: i32, d: i32| ((from as i64) << 30) + product(t, d);
    let exact = [walked(from[0], d[0]), walked(from[1], d[1]), walked(from[2], d[2])];
    let is_within = |bits: i32| exact.iter().all(|length| length.unsigned_abs() >> (30 + bits) == 0);
    let finer = if is_within(24) { FINER } else { COARSE };
    if !is_within(27) {
        return None;
    }
    let rounded = |length: i64| ((length + (1 << (29 - finer))) >> (30 - finer)) as i32;
    Some((t, [rounded(exact[0]), rounded(exact[1]), rounded(exact[2])], finer))
}
