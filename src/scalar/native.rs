//! The number type's own computing number, as a rung of the ladder: for what needs no more.

use super::Real;
use crate::number::{Estimate, Number, Ring};
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// A float, or a block of the fixed-point types.
#[derive(Clone, Copy, Debug)]
pub struct Native<R>(pub(crate) R);

impl<R: Real> Add for Native<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl<R: Real> Sub for Native<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl<R: Real> Neg for Native<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<R: Real> Mul for Native<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl<R: Real> Ring for Native<R> {
    const ZERO: Self = Self(R::ZERO);
    const ONE: Self = Self(R::ONE);

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        Self(self.0.times_power_of_two(e))
    }
}

impl<R: Real> Number for Native<R> {
    type Estimate = Self;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        self.0.partial_cmp(&R::ZERO)
    }
    #[inline(always)]
    fn estimate(self) -> Self {
        self
    }
}

impl<R: Real> Estimate for Native<R> {
    #[inline(always)]
    fn over(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
    #[inline(always)]
    fn square_root(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn compare(self, other: Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
    #[inline(always)]
    fn top(self) -> Option<i32> {
        None
    }
}
