//! The filter of `f32`: double precision with a running bound of its error.

use super::{Certain, Estimate, FromScalar, Number};
use crate::scalar::Real;
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// A double and a bound on its distance from the true value.
///
/// Every operation adds its own rounding to what its operands bring along (running error analysis: Higham, *Accuracy
/// and Stability of Numerical Algorithms*, 3.3). The roundings of products, quotients and roots are counted twice, and
/// [`Number::sign`] compares doubles, so that the rounding of the bound itself is covered.
#[derive(Clone, Copy, Debug)]
pub struct Double {
    value: f64,
    error: f64,
}

/// Twice the rounding of an operation, relative.
const ROUNDING: f64 = 1.0 / (1u64 << 52) as f64;
/// What covers the rounding of a bound.
const ABOVE: f64 = 1.0 + ROUNDING;
/// Below this a product may have lost bits to the end of the exponent range: 2^-900, which no polynomial of near-1
/// inputs meets.
const UNDERFLOW: f64 = f64::from_bits((1023 - 900) << 52);

/// The product of two numbers above this is a normal number: 2^-450.
const SHORT_FROM: f64 = f64::from_bits((1023 - 450) << 52);
/// What is left of a sum that is worth a second look.
const CANCELLED: f64 = 1.0 / (1u64 << 20) as f64;

impl Double {
    /// The sum of products of numbers without error, in twice the precision.
    #[cold]
    fn compensated<const M: usize>(terms: [[Self; 2]; M], magnitude: f64) -> Option<Self> {
        let is_exact = terms.iter().flatten().all(|factor| factor.error == 0.0);
        if !is_exact || magnitude < UNDERFLOW {
            return None;
        }
        let value = <f64 as Real>::sum_of_products(terms.map(|[a, b]| [a.value, b.value]));
        // Ogita, Rump and Oishi, *Accurate Sum and Dot Product*, 2005, Proposition 5.5, and Dekker's products below 2^-900.
        let error = value.abs() * ROUNDING + magnitude * (M * M) as f64 * (ROUNDING * ROUNDING) + f64::MIN_POSITIVE;
        Some(Self { value, error })
    }

    #[inline(always)]
    const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// True for an `f32` and the like: with so few bits that the product of two is exact. (Their exponents are far from the
    /// ends of a double's range unless they come out of a long computation.)
    #[inline(always)]
    fn is_short(self) -> bool {
        self.error == 0.0
            && self.value.to_bits() & ((1 << 27) - 1) == 0
            && (self.value.abs() > SHORT_FROM || self.value == 0.0)
    }

    /// Within this error.
    #[inline(always)]
    pub(super) const fn within(value: f64, error: f64) -> Self {
        Self { value, error }
    }

    /// Within the rounding of one operation, or of the end of the exponent range.
    pub(super) const fn rounded_once(value: f64) -> Self {
        let floor = if value.abs() < UNDERFLOW { UNDERFLOW } else { 0.0 };
        Self { value, error: value.abs() * ROUNDING + floor }
    }
}

impl Add for Double {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        // What the sum lost, exactly (Knuth, *The Art of Computer Programming* 2, 4.2.2, Theorem B): often nothing.
        let part = value - self.value;
        let lost = (self.value - (value - part)) + (other.value - part);
        Self { value, error: (self.error + other.error) * ABOVE + lost.abs() }
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
        if self.is_short() && other.is_short() {
            return Self { value, error: 0.0 };
        }
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

    /// Where much cancels, and nothing has been rounded before: once more in twice the precision.
    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let (mut sum, mut magnitude, mut inherited) = (0.0, 0.0, 0.0);
        for [a, b] in terms {
            let product = a * b;
            sum += product.value;
            magnitude += product.value.abs();
            inherited += product.error;
        }
        let plain = Self { value: sum, error: inherited + magnitude * (M as f64 * ROUNDING) };
        if sum.abs() >= magnitude * CANCELLED { plain } else { Self::compensated(terms, magnitude).unwrap_or(plain) }
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
        // Two quotients by one number share the division; the product is a second rounding.
        let inverse = 1.0 / other.value;
        let value = self.value * inverse;
        let uncertain = other.error * inverse.abs();
        // 1 / (|b| - e) is at most this much more than 1 / |b|, for an e up to |b| / 2.
        let growth = if uncertain < 0.5 { 1.0 + 2.0 * uncertain } else { f64::INFINITY };
        let inherited = (self.error + value.abs() * other.error) * inverse.abs() * growth;
        Self { value, error: value.abs() * (2.0 * ROUNDING) + inherited * ABOVE }
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
    const LOOKS_QUICKLY: bool = true;
    #[inline(always)]
    fn in_double(self) -> Option<f64> {
        Some(self as f64)
    }
    #[inline(always)]
    fn in_doubles(value: super::quick::Quick) -> Option<[f64; 2]> {
        Some(value.with_magnitude())
    }
    type Quick = super::quick::Quick;
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
    fn double_real(value: f32) -> f64 {
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
