//! Integers of 64 and of 128 bits as mantissas.

use super::machine::{full_product, reciprocal_of_normalized, root_of_normalized};
use core::fmt::Debug;
use core::ops::{Shl, Shr};

/// A mantissa.
pub trait Word: Copy + Ord + Debug + Shl<u32, Output = Self> + Shr<u32, Output = Self> + Send + Sync + 'static {
    /// An integer of twice as many bits, and a sign.
    type Wide: Wide<Self>;
    /// The number of its bits.
    const BITS: u32;
    /// Zero: no bit is set.
    const ZERO: Self;
    /// The highest bit.
    const TOP: Self;

    /// The word with the highest of these 128 bits; the lowest may be lost.
    fn from_highest(bits: u128) -> Self;
    /// The word with these highest 64 bits.
    fn from_word(bits: u64) -> Self;
    /// The word as the highest of 128 bits.
    fn highest(self) -> u128;
    /// Zeros above the highest bit.
    fn leading_zeros(self) -> u32;
    /// Bits by which a quotient or a root is rounded.
    const SPARE: u32;
    /// The sum; `None` if that carries.
    fn checked_plus(self, other: Self) -> Option<Self>;
    /// `self * other`
    fn product(self, other: Self) -> Self::Wide;
    /// `self * 2^BITS / divisor` with an error of some units, for a larger divisor whose highest bit is set.
    fn quotient(self, divisor: Self) -> Self;
    /// `sqrt(self * 2^BITS)` with an error of some units, for a number with one of its two highest bits set.
    fn root(self) -> Self;
}

/// A sum of products of words.
pub trait Wide<W>: Copy {
    /// Zero.
    const ZERO: Self;
    /// `word * 2^BITS`
    fn from_high(word: W) -> Self;
    /// Shifted right without regard to a sign.
    fn shifted_right(self, by: u32) -> Self;
    /// True if a shift right loses a bit.
    fn loses(self, by: u32) -> bool;
    /// The sum.
    fn plus(self, other: Self) -> Self;
    /// The negative.
    fn negated(self) -> Self;
    /// True below zero.
    fn is_negative(self) -> bool;
    /// True at zero.
    fn is_zero(self) -> bool;
    /// The highest bits, the number of zeros above them, and whether a bit below them is set; not for zero.
    fn normalized(self) -> (W, u32, bool);
}

impl Word for u64 {
    type Wide = u128;
    const BITS: u32 = 64;
    const SPARE: u32 = 3;
    const ZERO: Self = 0;
    const TOP: Self = 1 << 63;

    #[inline(always)]
    fn from_highest(bits: u128) -> Self {
        (bits >> 64) as Self
    }
    #[inline(always)]
    fn from_word(bits: u64) -> Self {
        bits
    }
    #[inline(always)]
    fn highest(self) -> u128 {
        (self as u128) << 64
    }
    #[inline(always)]
    fn leading_zeros(self) -> u32 {
        Self::leading_zeros(self)
    }
    #[inline(always)]
    fn checked_plus(self, other: Self) -> Option<Self> {
        self.checked_add(other)
    }
    #[inline(always)]
    fn product(self, other: Self) -> u128 {
        full_product(self, other)
    }

    /// By a reciprocal of 30 bits: each residual step adds 30 bits.
    #[inline]
    fn quotient(self, divisor: Self) -> Self {
        let reciprocal = reciprocal_of_normalized((divisor >> 32) as u32);
        // n 2^64 / d = n 2^32 / d', with 1 / d' = reciprocal / 2^63.
        let first = full_product(self, reciprocal as u64) >> 31;
        let first = if first >> 64 == 0 { first as u64 } else { Self::MAX };
        let residual = (self as u128).wrapping_shl(64).wrapping_sub(full_product(first, divisor)) as i128;
        // The residual is less than 2^99: the quotient of its highest 64 bits is taken.
        let step = |residual: i128| {
            let magnitude = (residual.unsigned_abs() >> 40) as u64;
            let quotient = (full_product(magnitude, reciprocal as u64) >> 55) as u64;
            if residual < 0 { quotient.wrapping_neg() } else { quotient }
        };
        let second = first.wrapping_add(step(residual));
        let residual = (self as u128).wrapping_shl(64).wrapping_sub(full_product(second, divisor)) as i128;
        second.wrapping_add(step(residual))
    }

    /// From a root of 32 bits, by `s + (n - s^2) / 2 s`.
    #[inline]
    fn root(self) -> Self {
        // It may be one less than the root, so that its top bit is missing.
        let high = root_of_normalized((self >> 32) as u32, self as u32).max(1 << 31);
        let reciprocal = reciprocal_of_normalized(high) as u64;
        let step = |root: u64| {
            let residual = self.highest().wrapping_sub(full_product(root, root)) as i128;
            let magnitude = (residual.unsigned_abs() >> 36) as u64;
            // 1 / 2 s = reciprocal / 2^96
            let step = (full_product(magnitude, reciprocal) >> 60) as u64;
            if residual < 0 { root.wrapping_sub(step) } else { root.saturating_add(step) }
        };
        step(step((high as u64) << 32))
    }
}

impl Wide<u64> for u128 {
    const ZERO: Self = 0;

    #[inline(always)]
    fn from_high(word: u64) -> Self {
        (word as Self) << 64
    }
    #[inline(always)]
    fn shifted_right(self, by: u32) -> Self {
        if by < 128 { self >> by } else { 0 }
    }
    #[inline(always)]
    fn loses(self, by: u32) -> bool {
        self != 0 && self.trailing_zeros() < by
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self.wrapping_add(other)
    }
    #[inline(always)]
    fn negated(self) -> Self {
        self.wrapping_neg()
    }
    #[inline(always)]
    fn is_negative(self) -> bool {
        (self as i128) < 0
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self == 0
    }
    #[inline(always)]
    fn normalized(self) -> (u64, u32, bool) {
        let zeros = self.leading_zeros();
        let normalized = self << zeros;
        ((normalized >> 64) as u64, zeros, normalized as u64 != 0)
    }
}

/// 256 bits.
#[derive(Clone, Copy, Debug)]
pub struct Double {
    high: u128,
    low: u128,
}

impl Word for u128 {
    type Wide = Double;
    const BITS: u32 = 128;
    const SPARE: u32 = 4;
    const ZERO: Self = 0;
    const TOP: Self = 1 << 127;

    #[inline(always)]
    fn from_highest(bits: u128) -> Self {
        bits
    }
    #[inline(always)]
    fn from_word(bits: u64) -> Self {
        (bits as Self) << 64
    }
    #[inline(always)]
    fn highest(self) -> u128 {
        self
    }
    #[inline(always)]
    fn leading_zeros(self) -> u32 {
        Self::leading_zeros(self)
    }
    #[inline(always)]
    fn checked_plus(self, other: Self) -> Option<Self> {
        self.checked_add(other)
    }

    #[inline(always)]
    fn product(self, other: Self) -> Double {
        let (a, b, c, d) = ((self >> 64) as u64, self as u64, (other >> 64) as u64, other as u64);
        // The lower words of stored numbers are often zero.
        if b == 0 && d == 0 {
            return Double { high: full_product(a, c), low: 0 };
        }
        let (low, high) = (full_product(b, d), full_product(a, c));
        let (middle, carry) = full_product(a, d).overflowing_add(full_product(b, c));
        let (low, is_over) = low.overflowing_add(middle << 64);
        let high = high + (middle >> 64) + ((carry as u128) << 64) + is_over as u128;
        Double { high, low }
    }

    /// By the quotient of the highest words, and residuals.
    #[inline]
    fn quotient(self, divisor: Self) -> Self {
        // 2^127 / d' of the divisor's highest word.
        let highest = (divisor >> 64) as u64;
        let reciprocal = (u64::TOP >> 1).quotient(highest);
        let mut quotient = 0_u128;
        let mut residual = Double { high: self, low: 0 };
        for _ in 0..3 {
            let negative = residual.is_negative();
            let magnitude = if negative { residual.negated() } else { residual };
            // The residual's highest 64 bits, times the reciprocal.
            let (word, zeros, _) = if magnitude.is_zero() { (0, 0, false) } else { magnitude.normalized() };
            let step = full_product((word >> 64) as u64, reciprocal);
            // word 2^(192 - zeros) / d, d = d' 2^64, 1 / d' = reciprocal / 2^126
            let step = match zeros {
                0 | 1 if step >> (126 + zeros) != 0 => Self::MAX,
                0 | 1 => step << (2 - zeros),
                2..130 => step >> (zeros - 2),
                _ => 0,
            };
            quotient = if negative { quotient.wrapping_sub(step) } else { quotient.wrapping_add(step) };
            residual = Double { high: self, low: 0 }.plus(quotient.product(divisor).negated());
        }
        quotient
    }

    /// From a root of 64 bits, by `s + (n - s^2) / 2 s`.
    #[inline]
    fn root(self) -> Self {
        let high = ((self >> 64) as u64).root().max(u64::TOP);
        let reciprocal = (u64::TOP >> 1).quotient(high);
        let mut root = (high as u128) << 64;
        for _ in 0..2 {
            let residual = Double { high: self, low: 0 }.plus(root.product(root).negated());
            let negative = residual.is_negative();
            let magnitude = if negative { residual.negated() } else { residual };
            let (word, zeros, _) = if magnitude.is_zero() { (0, 0, false) } else { magnitude.normalized() };
            let step = full_product((word >> 64) as u64, reciprocal);
            // As for a quotient by s, halved.
            let step = if (1..129).contains(&zeros) { step >> (zeros - 1) } else { 0 };
            root = if negative { root.wrapping_sub(step) } else { root.saturating_add(step) };
        }
        root
    }
}

impl Wide<u128> for Double {
    const ZERO: Self = Self { high: 0, low: 0 };

    #[inline(always)]
    fn from_high(word: u128) -> Self {
        Self { high: word, low: 0 }
    }
    #[inline(always)]
    fn shifted_right(self, by: u32) -> Self {
        let Self { high, low } = self;
        match by {
            0 => self,
            1..128 => Self { high: high >> by, low: low >> by | high << (128 - by) },
            128..256 => Self { high: 0, low: high >> (by - 128) },
            _ => Self::ZERO,
        }
    }
    #[inline(always)]
    fn loses(self, by: u32) -> bool {
        let zeros = if self.low == 0 { 128 + self.high.trailing_zeros() } else { self.low.trailing_zeros() };
        !self.is_zero() && zeros < by
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let (low, carry) = self.low.overflowing_add(other.low);
        Self { high: self.high.wrapping_add(other.high).wrapping_add(carry as u128), low }
    }
    #[inline(always)]
    fn negated(self) -> Self {
        let (low, carry) = (!self.low).overflowing_add(1);
        Self { high: (!self.high).wrapping_add(carry as u128), low }
    }
    #[inline(always)]
    fn is_negative(self) -> bool {
        (self.high as i128) < 0
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.high == 0 && self.low == 0
    }
    #[inline(always)]
    fn normalized(self) -> (u128, u32, bool) {
        let Self { high, low } = self;
        if high == 0 {
            let zeros = low.leading_zeros();
            return (low << zeros, zeros + 128, false);
        }
        let zeros = high.leading_zeros();
        if zeros == 0 {
            return (high, 0, low != 0);
        }
        (high << zeros | low >> (128 - zeros), zeros, low << zeros != 0)
    }
}
