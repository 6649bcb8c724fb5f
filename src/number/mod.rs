//! The numbers that solvers compute in.
//!
//! A solver is generic over a [`Number`] whose sign may be unknown. It runs in the cheapest number first. If that does not know a sign,
//! the solver runs again in the next:
//!
//! | number | sign | used by |
//! |---|---|---|
//! | [`Twofold`](crate::scalar::Twofold) | not used | points and normals, where it is accurate enough |
//! | [`Robust`] | that of the rounded value | `Fast` and `Stable`, where their fast path is unsure |
//! | [`Filtered`] | unknown if a value is small relative to its terms | `Exact` |
//! | [`Bounded`] | unknown if the value is within its error bound of zero | `Exact`, where a sign is unknown in [`Filtered`] |
//! | [`Integer`] | always certain | `Exact`, where a sign is unknown in [`Bounded`] |
//!
//! Before that all tiers take a fast path in the number type's own width, which does not use these numbers.

/// The operators of a number with the methods `plus`, `negative` and `times`.
macro_rules! operators {
    ($Number:ty $(, $($parameters:tt)+)?) => {
        impl$(<$($parameters)+>)? core::ops::Add for $Number {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                self.plus(other)
            }
        }
        impl$(<$($parameters)+>)? core::ops::Sub for $Number {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                self.plus(other.negative())
            }
        }
        impl$(<$($parameters)+>)? core::ops::Neg for $Number {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.negative()
            }
        }
        impl$(<$($parameters)+>)? core::ops::Mul for $Number {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                self.times(other)
            }
        }
    };
}
pub(crate) use operators;

mod bounded;
#[cfg(feature = "libm")]
mod filtered;
mod integer;
mod limbs;
pub(crate) mod machine;
mod robust;
#[cfg(test)]
mod tests;
pub(crate) mod word;

pub use bounded::Bounded;
#[cfg(feature = "libm")]
pub use filtered::{Filtered, Rounded};
#[cfg(feature = "fixed")]
pub(crate) use integer::FIXED_LIMBS;
pub(crate) use integer::FLOAT_LIMBS;
pub use integer::Integer;
pub use limbs::Limbs;
pub use robust::Robust;

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// Numbers that can be added and multiplied. A placement needs no other operations.
pub trait Ring: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;

    /// A sum of products, rounded once.
    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let mut sum = Self::ZERO;
        for [a, b] in terms {
            sum = sum + a * b;
        }
        sum
    }
    /// `self * 2^e`, exactly.
    fn scaled(self, e: i32) -> Self;
}

/// A number whose sign may be unknown.
pub trait Number: Ring {
    /// The type of approximate quotients and square roots.
    type Estimate: Estimate;

    /// How it compares with zero; `None` if that is unknown.
    fn sign(self) -> Option<Ordering>;
    /// The number rounded to [`Number::Estimate`].
    fn estimate(self) -> Self::Estimate;
}

/// A number of limited precision.
pub trait Estimate: Number<Estimate = Self> {
    /// `self / other`; `other` must not be zero.
    fn over(self, other: Self) -> Self;
    /// The square root of a number that is not negative.
    fn square_root(self) -> Self;
    /// How it compares with another; `None` if that is unknown.
    fn compare(self, other: Self) -> Option<Ordering>;
    /// The exponent of the smallest power of two above the magnitude; `None` for zero.
    fn top(self) -> Option<i32>;
}

/// The parts of a stored number: `(-1)^negative * mantissa * 2^exponent`.
#[derive(Clone, Copy, Debug)]
pub struct Parts {
    /// The integer.
    pub mantissa: u64,
    /// The exponent of the power of two that it is multiplied by.
    pub exponent: i32,
    /// The sign.
    pub negative: bool,
}

/// `a . b`
#[inline]
pub(crate) fn dot<N: Ring>(a: [N; 3], b: [N; 3]) -> N {
    N::sum([[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]])
}

/// `a x b`
#[inline]
pub(crate) fn cross<N: Ring>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    let minor = |i: usize, j: usize| N::sum([[a[i], b[j]], [-a[j], b[i]]]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// `a - b`
#[inline]
pub(crate) fn difference<N: Ring>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
