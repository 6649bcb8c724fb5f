//! Quotients by one divisor.

use super::digits::{down_by_few, down_to_64, joined, moved_up, up, upper_bits, words};
use crate::number::machine::{high_product, leading_zeros, product, product_unsigned, reciprocal_of_normalized};
use crate::scalar::integers::length::{self, Length};

/// A divisor with its top bit set.
#[derive(Clone, Copy, Debug)]
pub struct Normalized {
    /// The magnitude is `digits * 2^(-63 - shift)`.
    digits: u64,
    shift: u32,
    negative: bool,
}

impl length::Normalized<i64> for Normalized {
    type Divisor = Divisor;

    #[inline(always)]
    fn new(a: i128) -> Option<Self> {
        let magnitude = a.unsigned_abs();
        let ([_, low], [middle, above]) = (words(magnitude as u64), words((magnitude >> 64) as u64));
        if above < 1 << 17 {
            return None;
        }
        let zeros = leading_zeros(above);
        let digits = joined([moved_up(middle, low, zeros), moved_up(above, middle, zeros)]);
        // A divisor of 1 has three.
        Some(Self { digits, shift: zeros.saturating_sub(3), negative: a < 0 })
    }
    #[inline(always)]
    fn shift(self) -> i32 {
        self.shift as i32
    }
    #[inline(always)]
    fn of_square(self, r: i64) -> i128 {
        // a r; before it is shifted down the product has full precision.
        let scaled = upper_product(self.digits, (r as u64) << 1) as i64;
        down_by_few(i64::dot([scaled], [r]), self.shift)
    }
    #[inline(always)]
    fn divisor(self) -> Divisor {
        Divisor { reciprocal: reciprocal_of_digits(self.digits), shift: self.shift, negative: self.negative }
    }
}

/// `2^127 / n` for a number with its top bit set, with a relative error of at most 2^-59.
///
/// It is a step of the third order from the reciprocal of the upper word.
#[inline(always)]
pub(super) fn reciprocal_of_digits(n: u64) -> u64 {
    let [low, high] = words(n);
    // m = n / 2^64 in [1/2, 1); y = 1 / m in (1, 2], in units of 2^-31
    let y = reciprocal_of_normalized(high);
    // 1 - m y in units of 2^-63, below 2^-29 in magnitude; in units of 2^-60 it fits a word.
    let rest = (1_u64 << 63).wrapping_sub(product_unsigned(high, y)).wrapping_sub(high_product(low, y) as u64);
    let rest = (rest as i64 >> 3) as i32;
    let short = rest >> 16;
    let step = rest.wrapping_add((short * short) >> 28);
    // y has its top bit set: as a signed number it is 2^32 less.
    joined([0, y]).saturating_add_signed((product(y as i32, step) + ((step as i64) << 32)) >> 28)
}

/// A divisor as its reciprocal.
#[derive(Clone, Copy, Debug)]
pub struct Divisor {
    /// `2^127` over the digits of [`Normalized`].
    reciprocal: u64,
    shift: u32,
    negative: bool,
}

/// Bits below the unit of a numerator, if the divisor is near 1: its truncation changes the quotient by at most a
/// hundredth of a unit. The quotient stays below 2^55, so that the error from the reciprocal is at most a sixteenth of
/// a unit.
const FRACTION: u32 = 7;

impl length::Divisor<i64> for Divisor {
    #[inline(always)]
    fn quotient(self, numerator: i128, unit: u32) -> Option<i64> {
        let (magnitude, down) = (numerator.unsigned_abs(), 61 + unit - FRACTION - self.shift);
        if down & 64 != 0 {
            return Some(self.signed(down_to_64(magnitude >> 64, down & 0x3f), numerator < 0));
        }
        if down_to_64(magnitude >> 64, down.wrapping_sub(1)) != 0 {
            return None;
        }
        Some(self.signed(down_to_64(magnitude, down), numerator < 0))
    }
    #[inline(always)]
    fn quotient_of_difference(self, y: i64, o: i64, extra_bits: i32) -> Option<i64> {
        let (difference, more) = (y.relative_to(o, extra_bits)?, FRACTION + 1 + self.shift - extra_bits as u32);
        if upper_bits(difference) >> (31 - more) != 0 {
            return None;
        }
        Some(self.signed(up(difference.unsigned_abs() as i64, more) as u64, difference < 0))
    }
}

impl Divisor {
    /// The quotient of a numerator in units of `2^(-FRACTION - 1 - shift)`, below 2^63.
    #[inline(always)]
    fn signed(self, magnitude: u64, negative: bool) -> i64 {
        let quotient = ((upper_product(magnitude, self.reciprocal) >> FRACTION) + 1) >> 1;
        if negative == self.negative { quotient as i64 } else { -(quotient as i64) }
    }
}

/// The upper half of the product of two numbers.
#[inline(always)]
pub(super) fn upper_product(a: u64, b: u64) -> u64 {
    let ([a, above], [b, beyond]) = (words(a), words(b));
    let [first, carried] = words(product_unsigned(a, beyond) + high_product(a, b) as u64);
    let [_, more] = words(product_unsigned(above, b) + first as u64);
    product_unsigned(above, beyond) + carried as u64 + more as u64
}
