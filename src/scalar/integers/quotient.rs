//! Quotients by one divisor.

use super::{high, high_product, leading_zeros, product, reciprocal_of_normalized, round_off};

/// A divisor with its top bit set.
#[derive(Clone, Copy)]
pub(super) struct Normalized {
    /// The magnitude is `digits * 2^(-31 - shift)`.
    pub(super) digits: u32,
    pub(super) shift: u32,
    negative: bool,
}

impl Normalized {
    /// A number in units of 2^-60, between 2^-12 and 2 in magnitude.
    #[inline(always)]
    pub(super) fn new(a: i64) -> Option<Self> {
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

    /// The divisor with its reciprocal.
    #[inline(always)]
    pub(super) fn divisor(self) -> Divisor {
        Divisor { reciprocal: reciprocal_of_normalized(self.digits), shift: self.shift, negative: self.negative }
    }
}

/// A divisor as its reciprocal: a product with it costs a fourth of a division, and two ends share the reciprocal.
#[derive(Clone, Copy)]
pub(super) struct Divisor {
    /// `2^63` over the digits of [`Normalized`], to 31 bits.
    reciprocal: u32,
    /// The magnitude is at least `2^(-1 - shift)`.
    pub(super) shift: u32,
    negative: bool,
}

/// Quotients of at least this magnitude are left to wider numbers: the error from the reciprocal would be a sixteenth
/// of a unit.
const TOO_LARGE: i32 = 1 << 27;

impl Divisor {
    /// The quotient of a number below 2^62 in units of `2^-unit`, rounded to nearest; `None` if it is too large for
    /// that.
    #[inline(always)]
    pub(super) fn quotient(self, numerator: i64, unit: u32) -> Option<i32> {
        let quotient = rounded(self.times_reciprocal(numerator), unit.wrapping_sub(self.shift))?;
        Some(if self.negative { -quotient } else { quotient })
    }

    /// The same for a quotient of any size: from 2^28 on its error is more than a fourth of a unit in addition to its
    /// rounding.
    #[inline(always)]
    pub(super) fn long_quotient(self, numerator: i64, unit: u32) -> i64 {
        let quotient = round_off(self.times_reciprocal(numerator), unit.wrapping_sub(self.shift) & 0x3f);
        if self.negative { -quotient } else { quotient }
    }

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
    // With five further bits, in the high word.
    let (above, below) = (high(value), value as u32);
    let fine = if shift > 37 {
        above >> ((shift - 37) & 0x1f)
    } else {
        let up = (37 - shift) & 0x1f;
        let shifted = above << up;
        if shifted >> up != above {
            return None;
        }
        shifted | (below >> 1 >> (31 - up)) as i32
    };
    let quotient = (fine >> 5) + ((fine >> 4) & 1);
    (-TOO_LARGE < quotient && quotient < TOO_LARGE).then_some(quotient)
}
