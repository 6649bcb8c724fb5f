//! Doubles that keep the size of what went into them.

use crate::number::{FromScalar, Ring};
use crate::scalar::Real;
use core::ops::{Add, Mul, Neg, Sub};

/// A double, and the same polynomial of the magnitudes of its inputs: its rounding errors, however many, are together a small part of
/// that (Burnikel, Funke and Seel, *Exact Geometric Computation Using Cascading*, 2001).
#[derive(Clone, Copy, Debug)]
pub(super) struct Quick {
    pub(super) value: f64,
    pub(super) magnitude: f64,
}

/// Inputs below this are left to others: 2^-60, of which no polynomial of the solvers has so high a power that it underflows.
const SMALLEST: f64 = 1.0 / (1u64 << 60) as f64;

impl Quick {
    /// One whose magnitude is too small to trust has an infinite one, and so has all that it goes into.
    #[inline(always)]
    fn guarded(value: f64, magnitude: f64) -> Self {
        Self { value, magnitude: if magnitude < SMALLEST && magnitude != 0.0 { f64::INFINITY } else { magnitude } }
    }
}

impl Add for Quick {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }
}

impl Sub for Quick {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, magnitude: self.magnitude + other.magnitude }
    }
}

impl Neg for Quick {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Mul for Quick {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, magnitude: self.magnitude * other.magnitude }
    }
}

impl Ring for Quick {
    const ZERO: Self = Self { value: 0.0, magnitude: 0.0 };
    const ONE: Self = Self { value: 1.0, magnitude: 1.0 };

    #[inline]
    fn scaled(self, e: i32) -> Self {
        Self::guarded(self.value.times_power_of_two(e), self.magnitude.times_power_of_two(e))
    }
}

impl FromScalar<f32> for Quick {
    #[inline(always)]
    fn scalar(value: f32) -> Self {
        let value = value as f64;
        Self::guarded(value, value.abs())
    }
    #[inline(always)]
    fn unit(value: f32) -> Self {
        <Self as FromScalar<f32>>::scalar(value)
    }
}
