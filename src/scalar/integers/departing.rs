//! Lines that depart inwards from a surface.

use super::length::{Divisor, Length, Normalized};
use crate::scalar::Attempt;

/// Where a line that begins in the surface of a ball about the origin, or of a cylinder about the y axis, leaves it:
/// the other root of `a t^2 + 2 k t`, whatever its rounded coordinates are.
///
/// The origin is in units of `2^-extra_bits` of the answer's.
#[inline]
pub(in crate::scalar) fn exit_from_round<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    is_ball: bool,
) -> Attempt<N> {
    let ([x, _, z], [dx, _, dz]) = (o, d);
    if !N::have_room(o) {
        return Attempt::Unsure;
    }
    let (a, k) = if is_ball {
        (N::squared_length(d), N::dot(o, d))
    } else {
        (N::squared_length([dx, dz]), N::dot([x, z], [dx, dz]))
    };
    let Some(digits) = N::Normalized::new(a).filter(|_| N::high(k).top() >> 28 == 0) else {
        return Attempt::Unsure;
    };
    // The errors of a framed origin and direction, half of the origin's unit and 2^-(BITS - 1), are up to 2^(1 + shift)
    // times as large at the exit; neither must exceed an eighth of a unit.
    let shift = digits.shift();
    if extra_bits != 0 && extra_bits < shift + 3 {
        return Attempt::Unsure;
    }
    match digits.divisor().quotient(-(k << 1), extra_bits as u32) {
        Some(t) if t > N::ZERO && (extra_bits == 0 || t.top() >> (27 - shift) == 0) => Attempt::Hit(t),
        _ => Attempt::Unsure,
    }
}
