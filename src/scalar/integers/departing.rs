//! Lines that depart inwards from a surface, on the grid of fixed point.

use super::quotient::Normalized;
use super::{high, magnitude_bits, product, square};
use crate::scalar::Attempt;

/// Where a line that begins in the surface of a ball about the origin, or of a cylinder about the y axis, leaves it:
/// the other root of `a t^2 + 2 k t`, whatever its rounded coordinates are.
///
/// The origin is in units of `2^-extra_bits` of the answer's.
#[inline]
pub(in crate::scalar) fn exit_from_round(o: [i32; 3], extra_bits: i32, d: [i32; 3], is_ball: bool) -> Attempt<i32> {
    let ([x, y, z], [dx, dy, dz]) = (o, d);
    let (mut a, mut k) = (square(dx) + square(dz), product(x, dx) + product(z, dz));
    if is_ball {
        a += square(dy);
        k += product(y, dy);
    }
    let Some(digits) = Normalized::new(a).filter(|_| magnitude_bits(high(k)) >> 28 == 0) else {
        return Attempt::Unsure;
    };
    // The error of a framed origin is half of its own unit. The origin is less than 2^30 of these units away, so that
    // with the rounding of a framed direction, 2^-31, the error becomes a unit and a half: at most 2^(2 + shift) of
    // these units at the exit.
    if extra_bits != 0 && extra_bits < digits.shift as i32 + 5 {
        return Attempt::Unsure;
    }
    match digits.divisor().quotient(-2 * k, (30 + extra_bits) as u32) {
        Some(t) if t > 0 => Attempt::Hit(t),
        _ => Attempt::Unsure,
    }
}
