//! Lines that begin in a surface and lead inwards.

use super::quotient::Normalized;
use super::{FINER, digits, dot, squared, squared_length, upper_bits};
use crate::scalar::Attempt;

/// Where a line that begins in the surface of a ball about the origin, or of a cylinder about the y axis, leaves it; as
/// with 32 bits.
#[inline]
pub(in crate::scalar) fn exit_from_round(o: [i64; 3], extra_bits: i32, d: [i64; 3], is_ball: bool) -> Attempt<i64> {
    if (upper_bits(o[0]) | upper_bits(o[1]) | upper_bits(o[2])) >> 28 != 0 || !(extra_bits == 0 || extra_bits == FINER)
    {
        return Attempt::Unsure;
    }
    let ([x, y, z], [dx, dy, dz]) = (digits(o), digits(d));
    let (a, k) = if is_ball {
        (squared_length([dx, dy, dz]), dot([x, y, z], [dx, dy, dz]))
    } else {
        (squared(dx) + squared(dz), dot([x, z], [dx, dz]))
    };
    // The error of a framed origin, a five-hundredth of a unit, is larger at the exit if the line is nearly parallel to
    // the axis. (A divisor of 1 has a shift of one.)
    let Some(digits) = Normalized::new(a).filter(|digits| extra_bits == 0 || digits.shift <= 6) else {
        return Attempt::Unsure;
    };
    match digits.divisor().quotient(-2 * k, extra_bits) {
        // Up to here the rounding of a framed direction, 2^-63, is less than an eighth of a unit; that of a stretched
        // one, up to 1.3 2^-62, less than a third.
        Some(t) if t > 0 && upper_bits(t) >> 16 == 0 => Attempt::Hit(t),
        _ => Attempt::Unsure,
    }
}
