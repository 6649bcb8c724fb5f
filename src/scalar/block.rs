//! Block-floating integers: the [`Real`] of the fixed-point types.
//!
//! A block is `mantissa * 2^exponent`. Its mantissa is twice as wide as the scalar, so that the product of two scalars,
//! and sums of such products, are exact. Only when a product would need more than the double width is an operand
//! reduced to half the width, rounded to nearest: a relative error of at most 2^-32 (2^-64 for the wide block). Blocks
//! never overflow: the exponent has 32 bits.
//!
//! Square roots and quotients are computed from integers, normalised by their leading zeros. The macro makes the same
//! code for three widths; the smallest is small enough to be tested on every operand.

use super::{Real, sealed::Sealed};
use crate::number::Ring;
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

#[macro_use]
mod division;

/// Defines one block type.
///
/// `$mantissa`/`$unsigned` are the double width, `$bits` their bits; a reduced factor has `$bits / 2 - 1` bits.
macro_rules! block {
    ($(#[$doc:meta])* $vis:vis $Block:ident, $mantissa:ty, $unsigned:ty, $bits:tt) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default)]
        $vis struct $Block {
            mantissa: $mantissa,
            exponent: i32,
        }

        impl $Block {
            /// Bits of a factor that is multiplied exactly, however long the other factor is.
            const HALF: u32 = $bits / 2 - 1;

            /// `mantissa * 2^exponent`, exactly; the mantissa's magnitude must not exceed `2^($bits - 2)`.
            #[inline(always)]
            pub const fn new(mantissa: $mantissa, exponent: i32) -> Self {
                Self { mantissa, exponent }
            }

            /// The integer part of the block.
            #[inline(always)]
            pub const fn mantissa(self) -> $mantissa {
                self.mantissa
            }

            /// The power of two that the mantissa is multiplied by.
            #[inline(always)]
            pub const fn exponent(self) -> i32 {
                self.exponent
            }

            /// Bits of the magnitude.
            #[inline(always)]
            fn bits(self) -> u32 {
                $bits - self.mantissa.unsigned_abs().leading_zeros()
            }

            /// The mantissa rounded from `bits` to `room` bits (or exactly `2^room`).
            #[inline(always)]
            fn reduced(self, bits: u32, room: u32) -> Self {
                if bits <= room {
                    return self;
                }
                let drop = bits - room;
                Self::new(shift_right_rounded!(self.mantissa, drop), self.exponent.wrapping_add(drop as i32))
            }

            /// The value as an integer of the unit `2^unit`, rounded to nearest, ties to even;
            /// `None` if that does not fit `$bits - 1` bits.
            #[inline]
            pub fn to_units(self, unit: i32) -> Option<$mantissa> {
                if self.mantissa == 0 {
                    return Some(0);
                }
                let up = self.exponent.wrapping_sub(unit);
                if up >= 0 {
                    let room = self.mantissa.unsigned_abs().leading_zeros() as i32 - 1;
                    if up > room { None } else { Some(self.mantissa << up) }
                } else {
                    let down = up.unsigned_abs();
                    if down >= $bits { Some(0) } else { Some(shift_right_rounded!(self.mantissa, down)) }
                }
            }

            /// Magnitude shifted left until its top bit is set, and the exponent that belongs to it.
            #[inline]
            fn normalized(self) -> ($unsigned, i32) {
                let magnitude = self.mantissa.unsigned_abs();
                let shift = magnitude.leading_zeros();
                (magnitude << shift, self.exponent.wrapping_sub(shift as i32))
            }

            /// The square root of `n`, rounded down; `n` must have one of its two top bits set.
            ///
            /// Zimmermann's recursion (*Karatsuba Square Root*, 1999) unrolled into Newton steps on prefixes of
            /// `n`: each step doubles the bits of the root of a prefix and is at most one too large.
            #[inline]
            pub(in crate::scalar) fn integer_square_root(n: $unsigned) -> $unsigned {
                const QUARTER: u32 = $bits / 4;
                // Root of the top half of the bits, from the next smaller integer.
                let top = n >> ($bits / 2);
                let root = root_of_half!($bits, top);
                // One Newton step on the whole.
                let mut root: $unsigned = (root << (QUARTER - 1)) + quotient!((n >> (QUARTER + 1)), root);
                // The step never falls short; it can be one too large, and then at the top of the range its square
                // overflows.
                if root >> ($bits / 2) != 0 || root * root > n {
                    root -= 1;
                }
                root
            }

            /// `floor(high * 2^$bits / divisor)` for a divisor whose top bit is set and `high < divisor`: schoolbook
            /// division by two digits of half the width (Knuth, *The Art of Computer Programming* 2, 4.3.1, D).
            #[inline]
            fn divide_wide(high: $unsigned, divisor: $unsigned) -> $unsigned {
                const DIGIT: u32 = $bits / 2;
                const MASK: $unsigned = (1 << DIGIT) - 1;
                let (top, low) = (divisor >> DIGIT, divisor & MASK);
                let digit = |remainder: $unsigned| -> ($unsigned, $unsigned) {
                    let mut quotient = quotient!(remainder, top);
                    let mut rest = remainder.wrapping_sub(quotient.wrapping_mul(top));
                    // At most two corrections, since the divisor is normalised.
                    while quotient >> DIGIT != 0 || quotient * low > (rest << DIGIT) {
                        quotient -= 1;
                        rest += top;
                        if rest >> DIGIT != 0 {
                            break;
                        }
                    }
                    (quotient, (remainder << DIGIT).wrapping_sub(quotient.wrapping_mul(divisor)))
                };
                let (first, rest) = digit(high);
                let (second, _) = digit(rest);
                (first << DIGIT) + second
            }
        }

        impl Sealed for $Block {}

        impl PartialEq for $Block {
            #[inline]
            fn eq(&self, other: &Self) -> bool {
                self.partial_cmp(other) == Some(Ordering::Equal)
            }
        }

        impl PartialOrd for $Block {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                let (a, b) = (self.mantissa.signum(), other.mantissa.signum());
                if a != b || a == 0 {
                    return Some(a.cmp(&b));
                }
                // Same sign: compare exactly by the normalised magnitudes.
                let ((m, e), (n, f)) = (self.normalized(), other.normalized());
                let order = e.cmp(&f).then(m.cmp(&n));
                Some(if a > 0 { order } else { order.reverse() })
            }
        }

        impl Neg for $Block {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::new(-self.mantissa, self.exponent)
            }
        }

        impl Add for $Block {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                if self.mantissa == 0 {
                    return other;
                }
                if other.mantissa == 0 {
                    return self;
                }
                let (mut high, mut low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
                let difference = high.exponent.wrapping_sub(low.exponent) as u32;
                // First use the free bits of the one with the greater exponent, then drop bits of the other.
                let room = high.mantissa.unsigned_abs().leading_zeros().saturating_sub(2);
                let up = if difference < room { difference } else { room };
                high.mantissa <<= up;
                high.exponent = high.exponent.wrapping_sub(up as i32);
                let down = difference - up;
                if down >= $bits {
                    return high;
                }
                if down > 0 {
                    low.mantissa = shift_right_rounded!(low.mantissa, down);
                }
                // The sum of two magnitudes of at most 2^(bits - 2) reaches the sign bit only if both are that power of
                // two.
                match high.mantissa.checked_add(low.mantissa) {
                    Some(sum) if sum.unsigned_abs() <= 1 << ($bits - 2) => Self::new(sum, high.exponent),
                    Some(sum) => Self::new(shift_right_rounded!(sum, 1), high.exponent.wrapping_add(1)),
                    None => Self::new((high.mantissa >> 1) + (low.mantissa >> 1), high.exponent.wrapping_add(1)),
                }
            }
        }

        impl Sub for $Block {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }

        impl Mul for $Block {
            type Output = Self;
            #[inline]
            fn mul(self, other: Self) -> Self {
                const ROOM: u32 = $bits - 2;
                let (mut a, mut b) = (self, other);
                let (p, q) = (a.bits(), b.bits());
                if p + q > ROOM {
                    // The longer factor may use the bits that the shorter one leaves free.
                    (a, b) = if p <= Self::HALF {
                        (a, b.reduced(q, ROOM - p))
                    } else if q <= Self::HALF {
                        (a.reduced(p, ROOM - q), b)
                    } else {
                        (a.reduced(p, Self::HALF), b.reduced(q, Self::HALF))
                    };
                }
                Self::new(a.mantissa * b.mantissa, a.exponent.wrapping_add(b.exponent))
            }
        }

        impl Div for $Block {
            type Output = Self;
            /// The quotient to nearly the double width; zero for a division by zero.
            #[inline(never)]
            fn div(self, other: Self) -> Self {
                if self.mantissa == 0 || other.mantissa == 0 {
                    return Self::ZERO;
                }
                let ((n, e), (d, f)) = (self.normalized(), other.normalized());
                // n / 2 < d, since both have their top bit set: the quotient fits.
                let quotient = Self::divide_wide(n >> 1, d);
                let mantissa = (quotient >> 2) as $mantissa + ((quotient >> 1) & 1) as $mantissa;
                let negative = (self.mantissa < 0) != (other.mantissa < 0);
                Self::new(
                    if negative { -mantissa } else { mantissa },
                    e.wrapping_sub(f).wrapping_add(3).wrapping_sub($bits),
                )
            }
        }

        impl Ring for $Block {
            const ZERO: Self = Self::new(0, 0);
            const ONE: Self = Self::new(1, 0);

            #[inline]
            fn scaled(self, n: i32) -> Self {
                Self::new(self.mantissa, self.exponent.wrapping_add(n))
            }
        }

        impl Real for $Block {
            const ROUNDING: i32 = -(Self::HALF as i32);
            const IS_FLOAT: bool = false;
            const HAS_INSTRUCTIONS: bool = false;
            const INFINITY: Self = Self::new(1, 1 << 24);
            const SMALLEST: Self = Self::new(0, 0);

            #[inline]
            fn from_int(n: i32) -> Self {
                Self::new(n as $mantissa, 0)
            }

            #[inline(never)]
            fn sqrt(self) -> Self {
                if self.mantissa <= 0 {
                    return Self::ZERO;
                }
                let (mut n, mut exponent) = self.normalized();
                if exponent & 1 != 0 {
                    n >>= 1;
                    exponent = exponent.wrapping_add(1);
                }
                let root = Self::integer_square_root(n);
                // Rounded to nearest: n - root^2 > root means that root + 1/2 is still below.
                let root = root + ((n - root * root > root) as $unsigned);
                Self::new(root as $mantissa, exponent >> 1)
            }

            #[inline]
            fn sum_with_rest<const N: usize>(terms: [[Self; 2]; N]) -> [Self; 2] {
                sum_of_products!($bits, $Block, terms)
            }

            #[inline]
            fn abs(self) -> Self {
                Self::new(self.mantissa.abs(), self.exponent)
            }

            #[inline(always)]
            fn is_negative(self) -> bool {
                self.mantissa < 0
            }

            #[inline(always)]
            fn is_zero(self) -> bool {
                self.mantissa == 0
            }
        }
    };
}

/// Sum of products with an exact accumulator where the machine has a wider integer.
macro_rules! sum_of_products {
    (64, $Block:ident, $terms:expr) => {{
        // 62-bit mantissas multiply exactly in 128 bits; align to the largest product and leave room for the sum.
        let mut sum = Block128::ZERO;
        for [a, b] in $terms {
            let product = Block128::new(a.mantissa as i128 * b.mantissa as i128, a.exponent.wrapping_add(b.exponent));
            sum = sum + product;
        }
        let bits = 128 - sum.mantissa.unsigned_abs().leading_zeros();
        if bits <= 62 {
            [$Block::new(sum.mantissa as i64, sum.exponent), $Block::ZERO]
        } else {
            let drop = bits - 62;
            let rounded = shift_right_rounded!(sum.mantissa, drop);
            // The dropped part has at most as many bits as the shift.
            let rest = Block128::new(sum.mantissa - (rounded << drop), sum.exponent).narrow();
            [$Block::new(rounded as i64, sum.exponent.wrapping_add(drop as i32)), rest]
        }
    }};
    (128, $Block:ident, $terms:expr) => {{
        // There is no wider integer: the rounding error of each addition is kept in a low word, as for floats.
        let (mut sum, mut error) = ($Block::ZERO, $Block::ZERO);
        for [a, b] in $terms {
            let ([a, u], [b, v]) = (a.halves(), b.halves());
            for product in [a * b, a * v, u * b, u * v] {
                let [rounded, rest] = sum.add_with_rest(product);
                sum = rounded;
                error = error + rest;
            }
        }
        sum.add_with_rest(error)
    }};
    ($bits:tt, $Block:ident, $terms:expr) => {{
        let mut sum = $Block::ZERO;
        for [a, b] in $terms {
            sum = sum + a * b;
        }
        [sum, $Block::ZERO]
    }};
}

block! {
    /// The [`Real`] of the 32-bit fixed types: a 64-bit integer with an exponent.
    pub Block64, i64, u64, 64
}
block! {
    /// The [`Real`] of the 64-bit fixed types: a 128-bit integer with an exponent.
    pub Block128, i128, u128, 128
}

impl Block128 {
    /// The block as a sum of two with at most 63 bits each, so that products of halves are exact.
    #[inline]
    fn halves(self) -> [Self; 2] {
        let bits = self.bits();
        if bits <= Self::HALF {
            return [self, Self::ZERO];
        }
        let high = self.reduced(bits, Self::HALF);
        [high, self - high]
    }

    /// The rounded sum and its rounding error (except for a unit of 2^-126 where the sum carries).
    #[inline]
    fn add_with_rest(self, other: Self) -> [Self; 2] {
        let sum = self + other;
        if sum.exponent <= self.exponent && sum.exponent <= other.exponent || self.is_zero() || other.is_zero() {
            return [sum, Self::ZERO];
        }
        let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        [sum, low - (sum - high)]
    }

    /// The value with a mantissa of 62 bits.
    fn narrow(self) -> Block64 {
        let bits = 128 - self.mantissa.unsigned_abs().leading_zeros();
        if bits <= 62 {
            return Block64::new(self.mantissa as i64, self.exponent);
        }
        let drop = bits - 62;
        Block64::new(shift_right_rounded!(self.mantissa, drop) as i64, self.exponent.wrapping_add(drop as i32))
    }
}

#[cfg(units)]
block! {
    /// The same code on 16 bits, where every operand can be tried.
    Block16, i16, u16, 16
}

#[cfg(units)]
#[path = "../../tests/units/scalar/block.rs"]
mod tests;
