//! The filter of the 32-bit fixed types: a 128-bit block with a running bound of its error.

use super::{Certain, Estimate, FromScalar, Number};
use crate::scalar::block::{Block64, Block128};
use crate::scalar::{Real, Scalar};
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};
use fixed::FixedI32;
use fixed::types::extra::{LeEqU32, U30};

/// A block, and the exponent of a power of two that its distance from the true value does not exceed.
///
/// Nearly all are exact: the products of the solvers fit 126 bits but for those of cones and of placed solids.
#[derive(Clone, Copy, Debug)]
pub struct Wide {
    value: Block128,
    /// `EXACT` where nothing has been rounded.
    error: i32,
}

/// The error of an exact number: a power of two below all others.
const EXACT: i32 = i32::MIN;

impl Wide {
    #[inline(always)]
    const fn exact(value: Block128) -> Self {
        Self { value, error: EXACT }
    }

    /// An exponent of which the power of two is above the magnitude.
    #[inline]
    fn top(self) -> i32 {
        self.value.exponent().saturating_add((128 - self.value.mantissa().unsigned_abs().leading_zeros()) as i32)
    }

    /// The highest 62 bits of a number.
    pub(super) fn truncated(value: Block128) -> Self {
        Self { value, error: Self::exact(value).top().saturating_sub(60) }
    }
}

/// The bound of a sum of errors.
#[inline]
fn total<const N: usize>(errors: [i32; N]) -> i32 {
    let (mut largest, mut active) = (EXACT, 0);
    for error in errors {
        if error != EXACT {
            active += 1;
            largest = largest.max(error);
        }
    }
    // Up to four of them: at most four times the largest.
    if active > 1 { largest.saturating_add(2) } else { largest }
}

/// The exponent of a product of a magnitude below `2^top` and an error.
#[inline]
fn times(top: i32, error: i32) -> i32 {
    if error == EXACT { EXACT } else { error.saturating_add(top) }
}

impl Add for Wide {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        let unit = value.exponent();
        // In a unit that divides both, or with one of them zero, nothing was dropped.
        let is_exact = (unit <= self.value.exponent() && unit <= other.value.exponent())
            || self.value.is_zero()
            || other.value.is_zero();
        let own = if is_exact { EXACT } else { unit };
        Self { value, error: total([self.error, other.error, own]) }
    }
}

impl Sub for Wide {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Wide {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl Mul for Wide {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let is_exact = value.exponent() == self.value.exponent().wrapping_add(other.value.exponent());
        // A factor is rounded to 63 bits at the least.
        let own = if is_exact { EXACT } else { Self::exact(value).top().saturating_sub(60) };
        let both = if self.error == EXACT { EXACT } else { times(self.error, other.error) };
        let error = total([own, times(self.top(), other.error), times(other.top(), self.error), both]);
        Self { value, error }
    }
}

impl Number for Wide {
    type Estimate = Self;
    const ZERO: Self = Self::exact(Block128::new(0, 0));
    const ONE: Self = Self::exact(Block128::new(1, 0));

    #[inline]
    fn sign(self) -> Option<Ordering> {
        // At least 2^(top - 1) in magnitude.
        if self.error != EXACT && (self.value.is_zero() || self.top().saturating_sub(1) <= self.error) {
            return None;
        }
        Some(self.value.mantissa().cmp(&0))
    }

    #[inline]
    fn scaled(self, e: i32) -> Self {
        Self { value: self.value.times_power_of_two(e), error: times(e, self.error) }
    }

    #[inline]
    fn together(values: [Self; 3], square: Self) -> ([Self; 3], Self) {
        (values, square)
    }
}

impl Estimate for Wide {
    #[inline]
    fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let quotient = Self::exact(value);
        let own = quotient.top().saturating_sub(120);
        // (error + |quotient| error') / |divisor|, whose magnitude is at least 2^(top - 2) less its error.
        let inherited = total([self.error, times(quotient.top(), other.error)]);
        Self { value, error: total([own, times(2 - other.top(), inherited)]) }
    }

    #[inline]
    fn square_root(self) -> Self {
        let value = self.value.sqrt();
        let root = Self::exact(value);
        let own = if value.is_zero() { EXACT } else { root.top().saturating_sub(62) };
        // sqrt(a) - sqrt(a - e) <= e / sqrt(a).
        Self { value, error: total([own, times(2 - root.top(), self.error)]) }
    }
}

impl<F: LeEqU32 + Send + Sync + 'static> FromScalar<FixedI32<F>> for Wide {
    #[inline]
    fn scalar(value: FixedI32<F>) -> Self {
        Self::exact(Block128::new(value.to_bits() as i128, -F::I32))
    }
    #[inline]
    fn unit(value: FixedI32<U30>) -> Self {
        Self::exact(Block128::new(value.to_bits() as i128, -30))
    }
}

impl<F: LeEqU32 + Send + Sync + 'static> Certain for FixedI32<F> {
    const LOOKS_QUICKLY: bool = false;
    type Quick = Wide;
    type Filter = Wide;
    type Integer = super::integer::Integer<{ super::FIXED_LIMBS }>;

    type Double = Block128;

    #[inline]
    fn double(self) -> Block128 {
        Block128::new(self.to_bits() as i128, -F::I32)
    }
    #[inline]
    fn double_unit(value: FixedI32<U30>) -> Block128 {
        Block128::new(value.to_bits() as i128, -30)
    }
    #[inline]
    fn double_real(value: Block64) -> Block128 {
        Block128::new(value.mantissa() as i128, value.exponent())
    }
    #[inline]
    fn from_double(value: Block128) -> Self {
        match value.to_units(-F::I32) {
            Some(raw) if raw.unsigned_abs() < i32::MAX as u128 => Self::from_bits(raw as i32),
            _ if value.is_negative() => -<Self as Scalar>::INFINITY,
            _ => <Self as Scalar>::INFINITY,
        }
    }
    #[inline]
    fn rounded(value: Wide) -> Option<Self> {
        // A 64th of a unit.
        (value.error <= -F::I32 - 6).then(|| Self::from_double(value.value))
    }
}
