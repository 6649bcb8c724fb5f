//! The directions of the rays of a row of pixels: those of `forward + x right + y up`, of perpendicular axes, in which
//! `x` and `y` are whole numbers of steps.

use super::{Real, Scalar};
use crate::vector::pairs;
use core::fmt::Debug;

/// A row of directions.
pub trait Scanline<S: Scalar>: Copy + Debug {
    /// That of one `y`.
    fn new(forward: [S::Unit; 3], across: [[S::Unit; 3]; 2], step: S::Real, y: i32) -> Self;
    /// The unit direction for one `x`, at most 2^26 in magnitude. `None` if it has no length.
    fn direction(&self, x: i32) -> Option<[S::Unit; 3]>;
}

/// In the numbers to compute in.
#[derive(Clone, Copy, Debug)]
pub struct InNumbers<S: Scalar> {
    forward: [S::Real; 3],
    right: [S::Real; 3],
    /// `y up`
    upwards: [S::Real; 3],
    step: S::Real,
}

impl<S: Scalar> Scanline<S> for InNumbers<S> {
    #[inline]
    fn new(forward: [S::Unit; 3], [right, up]: [[S::Unit; 3]; 2], step: S::Real, y: i32) -> Self {
        let y = S::Real::from_int(y) * step;
        let [forward, right, up] = [forward, right, up].map(|axis| axis.map(S::unit_real));
        Self { forward, right, upwards: up.map(|up| up * y), step }
    }

    #[inline]
    fn direction(&self, x: i32) -> Option<[S::Unit; 3]> {
        let x = S::Real::from_int(x) * self.step;
        let offsets = pairs(self.right, self.upwards).map(|(right, upwards)| right * x + upwards);
        S::direction(pairs(self.forward, offsets).map(|(forward, offset)| forward + offset))
    }
}

/// In integers, for types of 32 bits: a step has 30 bits, so that a vector is off by a unit of a direction, times the
/// tangent of its angle with `forward`. In numbers that takes twice as long.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct InIntegers {
    /// `forward + y up` in units of 2^-30 of about a step.
    start: [i64; 3],
    /// A step to the right, in the same units.
    right: [i32; 3],
}

#[cfg(feature = "fixed")]
mod integers {
    use super::super::block::Block64;
    use super::super::integers::length::Length;
    use super::super::integers::{direction, round_off};
    use super::{InIntegers, Scanline, pairs};
    use crate::number::machine::product;
    use crate::scalar::Attempt;
    use fixed::FixedI32;
    use fixed::types::extra::{LeEqU32, U30};

    /// The bits of a step.
    const STEP: i32 = 30;

    impl<F: LeEqU32 + Send + Sync + 'static> Scanline<FixedI32<F>> for InIntegers {
        fn new(forward: [FixedI32<U30>; 3], [right, up]: [[FixedI32<U30>; 3]; 2], step: Block64, y: i32) -> Self {
            // Steps are at least 2^-60, so that `forward` has room; and longer than 1 only in pictures of a few rows.
            let bits = 64 - step.mantissa().unsigned_abs().leading_zeros() as i32;
            let exponent = (step.exponent() + bits - STEP).max(-60);
            let step = step.to_units(exponent).unwrap_or(0) as i32;
            let stepped = |axis: [FixedI32<U30>; 3]| axis.map(|c| round_off(product(step, c.to_bits()), 30) as i32);
            let up = stepped(up);
            let start = pairs(forward, up).map(|(forward, up)| {
                let forward = i64::from(forward.to_bits());
                let shift = -30 - exponent;
                let forward = if shift >= 0 { forward << shift } else { forward >> (-shift).min(63) };
                forward + product(up, y)
            });
            Self { start, right: stepped(right) }
        }

        #[inline]
        fn direction(&self, x: i32) -> Option<[FixedI32<U30>; 3]> {
            // Below 2^60, and rounded to 29 bits of the longest.
            let sums = pairs(self.start, self.right).map(|(start, right)| start + product(right, x));
            let all = sums.iter().fold(0, |all, sum| all | (sum ^ (sum >> 63)));
            let down = 35_u32.saturating_sub((all as u64).leading_zeros());
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
