//! The operators of vectors.

use super::Vec3;
use crate::scalar::Scalar;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

impl<S: Scalar> Add for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x.plus(other.x), self.y.plus(other.y), self.z.plus(other.z))
    }
}

impl<S: Scalar> Sub for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x.minus(other.x), self.y.minus(other.y), self.z.minus(other.z))
    }
}

impl<S: Scalar> Mul<S> for Vec3<S> {
    type Output = Self;
    fn mul(self, factor: S) -> Self {
        Self::round(self.real().map(|component| component * factor.real()))
    }
}

impl<S: Scalar> Div<S> for Vec3<S> {
    type Output = Self;
    fn div(self, divisor: S) -> Self {
        Self::round(self.real().map(|component| component / divisor.real()))
    }
}

impl<S: Scalar> AddAssign for Vec3<S> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Scalar> SubAssign for Vec3<S> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<S: Scalar> MulAssign<S> for Vec3<S> {
    fn mul_assign(&mut self, factor: S) {
        *self = *self * factor;
    }
}

impl<S: Scalar> DivAssign<S> for Vec3<S> {
    fn div_assign(&mut self, divisor: S) {
        *self = *self / divisor;
    }
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // The lowest raw value of a fixed type has no negative.
        Self::ZERO - self
    }
}
