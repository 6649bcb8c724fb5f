//! Short blocks: integers of the scalar's own width, with an exponent.
//!
//! The computing number of the tier [`Fast`](crate::tier::Fast): a product is made in the double width and rounded back
//! to the single one at once. One multiplication, one shift.

use super::{Block64, Block128};
use crate::scalar::{Real, sealed::Sealed};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Defines one short block: mantissa, the type of twice its width, that one unsigned, their bits.
macro_rules! short_block {
    ($(#[$doc:meta])* $Short:ident, $Block:ident, $mantissa:ty, $wide:ty, $unsigned:ty, $bits:literal, $wide_bits:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default)]
        pub struct $Short {
            mantissa: $mantissa,
            exponent: i32,
        }

        impl $Short {
            /// Bits of a mantissa, without its sign.
            const ROOM: u32 = $bits - 1;

            /// The double-width integer times `2^exponent`, rounded to the single width.
            #[inline]
            pub(in crate::scalar) fn new(wide: $wide, exponent: i32) -> Self {
                let bits = $wide_bits - wide.unsigned_abs().leading_zeros();
                if bits <= Self::ROOM {
                    return Self { mantissa: wide as $mantissa, exponent };
                }
                let drop = bits - Self::ROOM;
                // The carry of a mantissa of ones makes a power of two, which loses nothing when halved.
                let rounded = shift_right_rounded!(wide, drop);
                let carry = rounded.unsigned_abs() >> Self::ROOM != 0;
                let (rounded, drop) = if carry { (rounded >> 1, drop + 1) } else { (rounded, drop) };
                Self { mantissa: rounded as $mantissa, exponent: exponent.wrapping_add(drop as i32) }
            }

            /// As a number of twice the width.
            #[inline]
            pub(in crate::scalar) fn widened(self) -> $Block {
                $Block::new(self.mantissa as $wide, self.exponent)
            }
        }

        impl Sealed for $Short {}

        impl PartialEq for $Short {
            #[inline]
            fn eq(&self, other: &Self) -> bool {
                self.widened() == other.widened()
            }
        }

        impl PartialOrd for $Short {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                self.widened().partial_cmp(&other.widened())
            }
        }

        impl Neg for $Short {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                Self { mantissa: -self.mantissa, exponent: self.exponent }
            }
        }

        impl Add for $Short {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                if self.mantissa == 0 {
                    return other;
                }
                if other.mantissa == 0 {
                    return self;
                }
                let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
                let difference = high.exponent.wrapping_sub(low.exponent) as u32;
                // First the free bits of the double width, then bits of the smaller one go.
                let up = difference.min(Self::ROOM);
                let down = (difference - up).min($wide_bits - 1);
                let low = low.mantissa as $wide;
                let low = if down == 0 { low } else { shift_right_rounded!(low, down) };
                let sum = ((high.mantissa as $wide) << up) + low;
                Self::new(sum, high.exponent.wrapping_sub(up as i32))
            }
        }

        impl Sub for $Short {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }

        impl Mul for $Short {
            type Output = Self;
            #[inline]
            fn mul(self, other: Self) -> Self {
                let product = self.mantissa as $wide * other.mantissa as $wide;
                Self::new(product, self.exponent.wrapping_add(other.exponent))
            }
        }

        impl Div for $Short {
            type Output = Self;
            /// Zero for a division by zero.
            #[inline]
            fn div(self, other: Self) -> Self {
                if self.mantissa == 0 || other.mantissa == 0 {
                    return Self::default();
                }
                let magnitude = self.mantissa.unsigned_abs() as $unsigned;
                let shift = magnitude.leading_zeros();
                let quotient = (magnitude << shift).checked_div(other.mantissa.unsigned_abs() as $unsigned).unwrap_or(0);
                // Its top bit may be set: halved, it fits the signed type.
                let half = (quotient >> 1) as $wide;
                let negative = (self.mantissa < 0) != (other.mantissa < 0);
                let exponent = self.exponent.wrapping_sub(other.exponent).wrapping_sub(shift as i32).wrapping_add(1);
                Self::new(if negative { -half } else { half }, exponent)
            }
        }

        impl Real for $Short {
            const ZERO: Self = Self { mantissa: 0, exponent: 0 };
            const ONE: Self = Self { mantissa: 1, exponent: 0 };
            const ROUNDING: i32 = -(Self::ROOM as i32);

            #[inline]
            fn from_int(n: i32) -> Self {
                Self::new(n as $wide, 0)
            }
            #[inline]
            fn sqrt(self) -> Self {
                if self.mantissa <= 0 {
                    return Self::default();
                }
                let mut n = self.mantissa.unsigned_abs() as $unsigned;
                let mut shift = n.leading_zeros();
                // An even exponent, with one of the two top bits set.
                if self.exponent.wrapping_sub(shift as i32) & 1 != 0 {
                    shift -= 1;
                }
                n <<= shift;
                let root = $Block::integer_square_root(n);
                Self::new(root as $wide, self.exponent.wrapping_sub(shift as i32) >> 1)
            }
            /// The plain sum: nothing is left over.
            #[inline]
            fn sum_with_rest<const N: usize>(terms: [[Self; 2]; N]) -> [Self; 2] {
                let mut sum = Self::ZERO;
                for [a, b] in terms {
                    sum = sum + a * b;
                }
                [sum, Self::ZERO]
            }
            #[inline]
            fn abs(self) -> Self {
                Self { mantissa: self.mantissa.abs(), exponent: self.exponent }
            }
            #[inline]
            fn times_power_of_two(self, n: i32) -> Self {
                Self { mantissa: self.mantissa, exponent: self.exponent.wrapping_add(n) }
            }
            #[inline]
            fn is_negative(self) -> bool {
                self.mantissa < 0
            }
            #[inline]
            fn is_zero(self) -> bool {
                self.mantissa == 0
            }
        }
    };
}

short_block! {
    /// The computing number of the 32-bit fixed types in the tier [`Fast`](crate::tier::Fast): 31 bits and an exponent.
    Short32, Block64, i32, i64, u64, 32, 64
}
short_block! {
    /// The computing number of the 64-bit fixed types in the tier [`Fast`](crate::tier::Fast): 63 bits and an exponent.
    Short64, Block128, i64, i128, u128, 64, 128
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(x: Short32) -> f64 {
        x.mantissa as f64 * (x.exponent as f64).exp2()
    }

    /// Every operation is right to 30 bits, for mantissas and exponents of all sizes.
    #[test]
    fn operations_keep_thirty_bits() {
        let mut state = 7_u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let mantissa = (state as i64) >> (state >> 59);
            Short32::new(mantissa, ((state >> 40) % 40) as i32 - 20)
        };
        let close = |got: Short32, want: f64| {
            assert!((value(got) - want).abs() <= want.abs() * (-29.0_f64).exp2(), "{got:?} for {want}");
        };
        for _ in 0..200_000 {
            let (a, b) = (next(), next());
            close(a * b, value(a) * value(b));
            close(a + b, value(a) + value(b));
            close(a.abs().sqrt(), value(a).abs().sqrt());
            if !b.is_zero() {
                close(a / b, value(a) / value(b));
            }
            assert_eq!(a < b, value(a) < value(b));
        }
        assert!((Short32::ONE / Short32::ZERO).is_zero());
        assert!((-Short32::ONE).sqrt().is_zero());
    }
}
