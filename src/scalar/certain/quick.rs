//! The first look of `f32`: doubles that keep the size of what went into them.

use super::double::Double;
use super::{FromScalar, Number};
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// A double, and the same polynomial of the magnitudes of its inputs: its rounding errors, however many, are together a small part of
/// that (Burnikel, Funke and Seel, *Exact Geometric Computation Using Cascading*, 2001). It costs twice a double and no
/// branch, but forgets which operations were exact: what it cannot tell, [`Double`] often can.
#[derive(Clone, Copy, Debug)]
pub struct Quick {
    value: f64,
    magnitude: f64,
}

/// A value computed by `n` nested operations is off by at most `n` halves of 2^-52 of its magnitude. The deepest polynomial, a
/// frustum's along a line seen from an affine frame, nests fewer than 48; twice that covers the rounding of the magnitude.
const ERROR: f64 = 48.0 / (1u64 << 52) as f64;

/// Inputs below this are left to others: 2^-60, of which no polynomial of the solvers has so high a power that it underflows.
const SMALLEST: f64 = 1.0 / (1u64 << 60) as f64;

impl Quick {
    /// One whose magnitude is too small to trust has an infinite one, and so has all that it goes into.
    #[inline(always)]
    fn guarded(value: f64, magnitude: f64) -> Self {
        Self { value, magnitude: if magnitude < SMALLEST && magnitude != 0.0 { f64::INFINITY } else { magnitude } }
    }

    /// The value, and the size of the terms that it is a sum of.
    #[inline(always)]
    pub(super) fn with_magnitude(self) -> [f64; 2] {
        [self.value, self.magnitude]
    }

    #[inline(always)]
    fn estimate(self) -> Double {
        Double::within(self.value, self.magnitude * ERROR)
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

impl Number for Quick {
    type Estimate = Double;
    const ZERO: Self = Self { value: 0.0, magnitude: 0.0 };
    const ONE: Self = Self { value: 1.0, magnitude: 1.0 };

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        // An infinity or a NaN compares false.
        let error = self.magnitude * ERROR;
        if self.value > error {
            Some(Ordering::Greater)
        } else if self.value < -error {
            Some(Ordering::Less)
        } else if self.magnitude == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    #[inline]
    fn scaled(self, e: i32) -> Self {
        use crate::scalar::Real;
        Self::guarded(self.value.times_power_of_two(e), self.magnitude.times_power_of_two(e))
    }

    #[inline(always)]
    fn together(values: [Self; 3], square: Self) -> ([Double; 3], Double) {
        (values.map(Self::estimate), square.estimate())
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
