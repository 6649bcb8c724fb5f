//! A line and a half-space.

use super::length::{Divisor, Length, Normalized, Product};
use crate::scalar::{Attempt, Crossed};

/// A framed component of a direction may be off by so many of its units.
const STEP: i32 = 2;

/// Where the line crosses the plane through a point with this outward normal, of any length: `t = n . a / n . d`, from
/// the point `a` as seen from the line's origin. A miss if the line is parallel to the plane and outside.
///
/// The origin is in units of `2^-extra_bits` of the point's; the answer is in the point's.
#[inline(always)]
pub(in crate::scalar) fn half_space<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    [point, normal]: [[N; 3]; 2],
) -> Attempt<Crossed<N>> {
    let zeros = N::zeros(normal);
    // Exact, in the origin's unit. Sums of three products with the normal have room.
    let Some(([seen], 3..)) = N::seen_from([point], o, extra_bits) else { return Attempt::Unsure };
    if zeros < 2 {
        return Attempt::Unsure;
    }
    // The longest component is between 2^(BITS - 3) and 2^(BITS - 2), so that the slope of a direction along the normal
    // is that of a direction.
    let n = normal.map(|c| c.up(zeros - 2));
    let (distance, slope) = (N::dot(n, seen), N::dot(n, d));
    let Some(digits) = N::Normalized::new(slope) else {
        return beside(distance, slope, extra_bits);
    };
    // As of a triangle: the errors of a framed origin and direction, half of the origin's unit and 2^-(BITS - 1), are
    // larger at the crossing if the line is nearly parallel to the plane; they must not exceed an eighth and a
    // sixteenth of a unit.
    let shift = digits.shift();
    if extra_bits != 0 && shift > extra_bits - 3 {
        return beside(distance, slope, extra_bits);
    }
    let leaves = slope > N::Product::ZERO;
    match digits.divisor().quotient(distance, extra_bits as u32) {
        Some(t) if extra_bits == 0 || t.top() >> (26 - shift) == 0 => {
            Attempt::Hit(if leaves { Crossed::Leaves(t) } else { Crossed::Enters(t) })
        }
        _ => beside(distance, slope, extra_bits),
    }
}

/// A line that is nearly parallel to the plane, or far from it: it crosses the plane beyond every range of the type,
/// on one side of it or on the other; unsure if it may cross it nearer.
#[cold]
#[inline(never)]
fn beside<N: Length>(distance: N::Product, slope: N::Product, extra_bits: i32) -> Attempt<Crossed<N>> {
    // The error of the slope is less than three times that of a component, times 2^(BITS - 2).
    let step = if extra_bits == 0 { N::Product::ZERO } else { N::Product::from(N::from(4 * STEP)) << (N::BITS - 2) };
    let reached = slope.magnitude() + step;
    // At least `2^BITS` away along the line, which is 4 in the unit of the product: twice as far as any `t` or start.
    let is_far = (distance.magnitude() >> (2 + extra_bits as u32)) > reached;
    if !is_far {
        Attempt::Unsure
    } else if distance > N::Product::ZERO {
        Attempt::Hit(Crossed::Inside)
    } else {
        Attempt::Miss
    }
}

#[cfg(units)]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../../tests/units/scalar/integers/half_space.rs"]
mod tests;
