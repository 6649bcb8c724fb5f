//! Lines that pass an axis at a distance, in fixed point, by products of 32 bits.

use super::length::Length;
use crate::number::machine::{leading_zeros, leading_zeros_of_64};

/// Bits of each factor.
const BITS: u32 = 14;

/// The uncertainty of the distance, in its units: less than 17 of them from rounding, and the errors of the right
/// angles of frames that were read from files.
const DOUBT: i32 = 20;

/// True if the line along `d` passes the axis `a` at a distance greater than `r`. `from` is the vector from a point of
/// the axis to one of the line.
#[inline(always)]
pub(in crate::scalar) fn passes(from: [i32; 3], d: [i32; 3], a: [i32; 3], r: i32) -> bool {
    let bits = from[0].top() | from[1].top() | from[2].top();
    // The difference of coordinates at opposite ends of the budget, 2^31, overflows and has the wrong sign.
    if bits == i32::MAX as u32 {
        return false;
    }
    let shift = (32 - BITS).saturating_sub(leading_zeros(bits | 1));
    is_beyond(from.map(|length| length >> shift), d, a, r >> shift)
}

/// [`passes`] for 64-bit types.
#[inline(always)]
pub(in crate::scalar) fn passes_wide(from: [i64; 3], d: [i32; 3], a: [i32; 3], r: i64) -> bool {
    let magnitude = |length: i64| (length ^ (length >> 63)) as u64;
    let bits = magnitude(from[0]) | magnitude(from[1]) | magnitude(from[2]);
    if bits == i64::MAX as u64 {
        return false;
    }
    let shift = (64 - BITS).saturating_sub(leading_zeros_of_64(bits | 1));
    // A larger radius would not fit in 32 bits, and is larger than the distance of any of these lines.
    is_beyond(from.map(|length| (length >> shift) as i32), d, a, (r >> shift).min(1 << BITS) as i32)
}

/// The distance of the lines is `|n . from| / |n|`, `n = d x a` (Ericson, Real-Time Collision Detection, 5.1.8). All
/// lengths have [`BITS`] bits, and the directions 30.
#[inline(always)]
fn is_beyond(from: [i32; 3], d: [i32; 3], a: [i32; 3], r: i32) -> bool {
    if r >= 1 << BITS {
        return false;
    }
    let (d, a) = (d.map(|component| component >> (30 - BITS)), a.map(|component| component >> (30 - BITS)));
    // The error of each component is less than 4 units of 2^-14: from the rounding of four factors, and its own.
    let cross = |i: usize, j: usize| (d[i] * a[j] - d[j] * a[i]) >> BITS;
    let n = [cross(1, 2), cross(2, 0), cross(0, 1)];
    let distance = ((n[0] * from[0] + n[1] * from[1] + n[2] * from[2]) >> BITS).abs() - DOUBT;
    // |n|^2 in units of 2^-14, and its error bound.
    let nn = ((n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) >> BITS) + 16;
    let r = r + 1;
    distance > 0 && distance * distance > (((r * r) >> BITS) + 1) * nn
}

#[cfg(units)]
#[path = "../../../tests/units/scalar/integers/axis.rs"]
mod tests;
