//! Quotients by one divisor.

use super::{high, leading_zeros, product};
use crate::number::machine::{high_product, reciprocal_of_normalized};
use crate::scalar::integers::length;

/// A divisor with its top bit set.
#[derive(Clone, Copy, Debug)]
pub struct Normalized {
    /// The magnitude is `digits * 2^(-31 - shift)`.
    digits: u32,
    shift: u32,
    negative: bool,
}

impl length::Normalized<i32> for Normalized {
    type Divisor = Divisor;

    #[inline(always)]
    fn new(a: i64) -> Option<Self> {
        let magnitude = a.unsigned_abs();
        let (above, below) = ((magnitude >> 32) as u32, magnitude as u32);
        if above < 1 << 16 {
            return None;
        }
        let zeros = leading_zeros(above) & 0xf;
        let digits = (above << zeros) | (below >> (32 - zeros));
        // If rounding has made it larger than 1, it has one zero fewer; that precision is sufficient for the callers.
        Some(Self { digits, shift: zeros.saturating_sub(3), negative: a < 0 })
    }

    #[inline(always)]
    fn shift(self) -> i32 {
        self.shift as i32
    }
    #[inline(always)]
    fn of_square(self, r: i32) -> i64 {
        // 2 a r; without the shift both products have full precision.
        let twice = high_product(self.digits, (r as u32) << 2) as i32;
        product(twice, r) >> (1 + self.shift)
    }
    #[inline(always)]
    fn divisor(self) -> Divisor {
        Divisor { reciprocal: reciprocal_of_normalized(self.digits), shift: self.shift, negative: self.negative }
    }
}

/// A divisor as its reciprocal.
#[derive(Clone, Copy, Debug)]
pub struct Divisor {
    /// `2^63` over the digits of [`Normalized`], to 31 bits.
    reciprocal: u32,
    shift: u32,
    negative: bool,
}

/// Quotients of at least this magnitude are left to wider numbers: the error from the reciprocal would be a sixteenth
/// of a unit.
const TOO_LARGE: i32 = 1 << 27;

impl length::Divisor<i32> for Divisor {
    #[inline(always)]
    fn quotient(self, numerator: i64, unit: u32) -> Option<i32> {
        let quotient = rounded(self.times_reciprocal(numerator), unit.wrapping_add(30).wrapping_sub(self.shift))?;
        Some(if self.negative { -quotient } else { quotient })
    }
    #[inline(always)]
    fn quotient_of_difference(self, y: i32, o: i32, extra_bits: i32) -> Option<i32> {
        let difference = ((y as i64) << extra_bits) - o as i64;
        if difference.unsigned_abs() >> 33 != 0 {
            return None;
        }
        // With 28 further bits, so that the quotient has room for its fraction.
        let quotient = rounded(self.times_reciprocal(difference << 28), 28 + extra_bits as u32 - self.shift)?;
        Some(if self.negative { -quotient } else { quotient })
    }
}

impl Divisor {
    #[inline(always)]
    fn times_reciprocal(self, numerator: i64) -> i64 {
        // The reciprocal has its top bit set: as a signed number it is 2^32 less.
        let above = product(high(numerator), self.reciprocal as i32) + ((high(numerator) as i64) << 32);
        above + high_product(numerator as u32, self.reciprocal) as i64
    }
}

/// `value / 2^shift` for a shift between 9 and 64, rounded; `None` if that is too large.
#[inline(always)]
fn rounded(value: i64, shift: u32) -> Option<i32> {
    // With a further bit, in the high word.
    let (above, below) = (high(value), value as u32);
    let fine = if shift > 33 {
        above >> ((shift - 33) & 0x1f)
    } else {
        let up = (33 - shift) & 0x1f;
        let shifted = above << up;
        if shifted >> up != above {
            return None;
        }
        shifted | (below >> 1 >> (31 - up)) as i32
    };
    let quotient = (fine >> 1) + (fine & 1);
    (-TOO_LARGE < quotient && quotient < TOO_LARGE).then_some(quotient)
}
