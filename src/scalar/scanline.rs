//! The directions of the rays of a row of pixels: those of `forward + x right + y up`, of perpendicular axes, in which
//! `x` and `y` are whole numbers of two steps.

use super::{Real, Scalar};
use crate::vector::pairs;
use core::fmt::Debug;

/// A row of directions.
pub trait Scanline<S: Scalar>: Copy + Debug + PartialEq {
    /// That of `y = 0`; the steps are those to the right and upwards.
    fn new(forward: [S::Unit; 3], across: [[S::Unit; 3]; 2], steps: [S::Real; 2]) -> Self;
    /// The row so many steps above this one. Of both `y` and `x` the sum is at most 2^26 in magnitude.
    #[must_use]
    fn above(self, y: i32) -> Self;
    /// The unit direction for one `x`. `None` if it has no length.
    fn direction(&self, x: i32) -> Option<[S::Unit; 3]>;
}

/// In the numbers to compute in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InNumbers<S: Scalar> {
    forward: [S::Real; 3],
    right: [S::Real; 3],
    up: [S::Real; 3],
    steps: [S::Real; 2],
    /// `y`
    y: i32,
}

impl<S: Scalar> Scanline<S> for InNumbers<S> {
    #[inline]
    fn new(forward: [S::Unit; 3], [right, up]: [[S::Unit; 3]; 2], steps: [S::Real; 2]) -> Self {
        let [forward, right, up] = [forward, right, up].map(|axis| axis.map(S::unit_real));
        Self { forward, right, up, steps, y: 0 }
    }

    #[inline]
    fn above(self, y: i32) -> Self {
        Self { y: self.y + y, ..self }
    }

    #[inline]
    fn direction(&self, x: i32) -> Option<[S::Unit; 3]> {
        let [x, y] = [(x, self.steps[0]), (self.y, self.steps[1])].map(|(n, step)| S::Real::from_int(n) * step);
        let offsets = pairs(self.right, self.up).map(|(right, up)| right * x + up * y);
        S::direction(pairs(self.forward, offsets).map(|(forward, offset)| forward + offset))
    }
}

/// In integers, for types of 32 bits: a step has 30 bits, so that a vector is off by a unit of a direction, times the
/// tangent of its angle with `forward`. In numbers that takes twice as long.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InIntegers {
    /// `forward + y up` in units of 2^-30 of about the longer step.
    start: [i64; 3],
    /// A step to the right and one upwards, in the same units.
    right: [i32; 3],
    up: [i32; 3],
}

#[cfg(feature = "fixed")]
mod integers {
    use super::super::block::Block64;
    use super::super::integers::length::Length;
    use super::super::integers::{direction, round_off};
    use super::{InIntegers, Scanline, pairs};
    use crate::number::machine::{leading_zeros_of_64, product};
    use crate::scalar::Attempt;
    use fixed::FixedI32;
    use fixed::types::extra::{LeEqU32, U30};

    /// The bits of a step.
    const STEP: i32 = 30;

    impl<F: LeEqU32 + Send + Sync + 'static> Scanline<FixedI32<F>> for InIntegers {
        fn new(forward: [FixedI32<U30>; 3], axes: [[FixedI32<U30>; 3]; 2], steps: [Block64; 2]) -> Self {
            // Steps are at least 2^-60, so that `forward` has room; and longer than 1 only in pictures of a few rows.
            let top = |step: Block64| step.exponent() + 64 - step.mantissa().unsigned_abs().leading_zeros() as i32;
            let exponent = (top(steps[0]).max(top(steps[1])) - STEP).max(-60);
            let [right, up] = [(axes[0], steps[0]), (axes[1], steps[1])].map(|(axis, step)| {
                let step = step.to_units(exponent).unwrap_or(0) as i32;
                axis.map(|c| round_off(product(step, c.to_bits()), 30) as i32)
            });
            let shift = -30 - exponent;
            let start = forward.map(|forward| {
                let forward = i64::from(forward.to_bits());
                if shift >= 0 { forward << shift } else { forward >> (-shift).min(63) }
            });
            Self { start, right, up }
        }

        #[inline]
        fn above(self, y: i32) -> Self {
            Self { start: pairs(self.start, self.up).map(|(start, up)| start + product(up, y)), ..self }
        }

        #[inline]
        fn direction(&self, x: i32) -> Option<[FixedI32<U30>; 3]> {
            // Below 2^60, and rounded to 29 bits of the longest.
            let sums = pairs(self.start, self.right).map(|(start, right)| start + product(right, x));
            let all = sums.iter().fold(0, |all, sum| all | (sum ^ (sum >> 63)));
            let down = 35_u32.saturating_sub(leading_zeros_of_64(all as u64));
            let v = sums.map(|sum| if down < 2 { sum as i32 } else { i32::rounded_off(sum, down) });
            match direction(v) {
                Attempt::Hit(direction) => Some(direction.map(FixedI32::from_bits)),
                _ => None,
            }
        }
    }
}

#[cfg(all(units, feature = "fixed"))]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../tests/units/scalar/scanline.rs"]
mod tests;
