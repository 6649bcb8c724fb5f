//! The filter of `f32`: double precision with a running bound of its error.

use super::{Certain, Estimate, FromScalar, Number};
use crate::scalar::Real;
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// A double and a bound on its distance from the true value.
///
/// Every operation adds its own rounding to what its operands bring along (running error analysis: Higham, *Accuracy
/// and Stability of Numerical Algorithms*, 3.3). The rounding is counted twice, which covers that of the bound itself.
#[derive(Clone, Copy, Debug)]
pub struct Double {
    value: f64,
    error: f64,
}

/// Twice the rounding of an operation, relative.
const ROUNDING: f64 = 1.0 / (1u64 << 52) as f64;
/// Below this a product may have lost bits to the end of the exponent range: 2^-900, which no polynomial of near-1
/// inputs meets.
const UNDERFLOW: f64 = f64::from_bits((1023 - 900) << 52);

impl Double {
    #[inline(always)]
    const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// Within the rounding of one operation.
    pub(super) const fn rounded_once(value: f64) -> Self {
        Self { value, error: value.abs() * ROUNDING }
    }
}

impl Add for Double {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self { value, error: self.error + other.error + value.abs() * ROUNDING }
    }
}

impl Sub for Double {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Double {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl Mul for Double {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let (a, b) = (self.value.abs(), other.value.abs());
        let error = value.abs() * ROUNDING + (a * other.error + b * self.error + self.error * other.error);
        let is_zero = |x: Self| x.value == 0.0 && x.error == 0.0;
        if value.abs() < UNDERFLOW && !is_zero(self) && !is_zero(other) {
            return Self { value, error: error + UNDERFLOW };
        }
        Self { value, error }
    }
}

impl Number for Double {
    type Estimate = Self;
    const ZERO: Self = Self::exact(0.0);
    const ONE: Self = Self::exact(1.0);

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        // A NaN, or an infinity with an infinite bound, compares false.
        if self.value > self.error {
            Some(Ordering::Greater)
        } else if self.value < -self.error {
            Some(Ordering::Less)
        } else if self.value == 0.0 && self.error == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    #[inline]
    fn scaled(self, e: i32) -> Self {
        Self { value: self.value.times_power_of_two(e), error: self.error.times_power_of_two(e) }
    }

    #[inline(always)]
    fn together(values: [Self; 3], square: Self) -> ([Self; 3], Self) {
        (values, square)
    }
}

impl Estimate for Double {
    #[inline(always)]
    fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let inherited = (self.error + value.abs() * other.error) / (other.value.abs() - other.error);
        Self { value, error: value.abs() * ROUNDING + inherited }
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        let value = Real::sqrt(self.value);
        // sqrt(a) - sqrt(a - e) <= e / sqrt(a).
        let inherited = if self.error > 0.0 { self.error / value } else { 0.0 };
        Self { value, error: value * ROUNDING + inherited }
    }
}

impl FromScalar<f32> for Double {
    #[inline(always)]
    fn scalar(value: f32) -> Self {
        Self::exact(value as f64)
    }
    #[inline(always)]
    fn unit(value: f32) -> Self {
        Self::exact(value as f64)
    }
}

impl Certain for f32 {
    type Filter = Double;
    type Integer = super::integer::Integer<{ super::FLOAT_LIMBS }>;

    type Double = f64;

    #[inline(always)]
    fn double(self) -> f64 {
        self as f64
    }
    #[inline(always)]
    fn double_unit(value: f32) -> f64 {
        value as f64
    }
    #[inline(always)]
    fn from_double(value: f64) -> f32 {
        value as f32
    }
    #[inline(always)]
    fn rounded(value: Double) -> Option<f32> {
        // A 64th of a unit in the last place, also where floats are subnormal.
        const SLACK: f64 = 1.0 / (1u64 << 30) as f64;
        const SMALLEST: f64 = f64::from_bits((1023 - 155) << 52);
        let Double { value, error } = value;
        (error <= value.abs() * SLACK || error <= SMALLEST).then_some(value as f32)
    }
}
