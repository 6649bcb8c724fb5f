//! A line seen from a frame.

use super::{high, magnitude_bits, product};

/// How much finer than the type's unit the origin is kept: its rounding is then a hundredth of a unit.
pub(in crate::scalar) const FINER: i32 = 6;

/// Origin, in units of `2^-FINER` of the type's, and direction in the frame of these axes; `None` if the origin is too far away
/// for that.
#[inline(always)]
pub(in crate::scalar) fn turned(
    o: [i32; 3],
    position: [i32; 3],
    axes: [[i32; 3]; 3],
    d: [i32; 3],
) -> Option<[[i32; 3]; 2]> {
    let apart = |o: i32, position: i32| o.wrapping_sub(position);
    let from = [apart(o[0], position[0]), apart(o[1], position[1]), apart(o[2], position[2])];
    // Up to 2^24 from the frame's origin on each axis, all products fit, and so does the result.
    if (magnitude_bits(from[0]) | magnitude_bits(from[1]) | magnitude_bits(from[2])) >> 24 != 0 {
        return None;
    }
    let dot = |[x, y, z]: [i32; 3], [a, b, c]: [i32; 3]| product(x, a) + product(y, b) + product(z, c);
    let fine = from.map(|length| length << FINER);
    let nearest = |n: i64| high((n + (1 << 29)) << 2);
    let ([x, y, z], [dx, dy, dz]) = (axes.map(|axis| nearest(dot(fine, axis))), axes.map(|axis| dot(d, axis)));
    Some([[x, y, z], [nearest(dx), nearest(dy), nearest(dz)]])
}
