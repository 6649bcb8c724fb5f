//! A value alone.

use super::{Estimate, Number, Ring};
use crate::scalar::Real;
use core::cmp::Ordering;

/// A value alone; its sign is that of the rounded value. Products that cancel lose their digits.
#[derive(Clone, Copy, Debug)]
pub struct Plain<R>(pub(crate) R);

/// How two values compare; `Less` if one is not a number, so that a discriminant that has overflowed is a miss.
#[inline(always)]
pub(super) fn order<R: Real>(a: R, b: R) -> Ordering {
    if a > b {
        Ordering::Greater
    } else if a == b {
        Ordering::Equal
    } else {
        Ordering::Less
    }
}

/// `a b + c d + ..`, rounded after each operation.
#[inline(always)]
pub(super) fn sum<R: Real, const M: usize>(terms: [[R; 2]; M]) -> R {
    let [a, b] = terms[0];
    let mut sum = a * b;
    let mut i = 1;
    while i < M {
        let [a, b] = terms[i];
        sum = sum + a * b;
        i += 1;
    }
    sum
}

impl<R: Real> Plain<R> {
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self(-self.0)
    }
}

operators!(Plain<R>, R: Real);

impl<R: Real> Ring for Plain<R> {
    const ZERO: Self = Self(R::ZERO);
    const ONE: Self = Self(R::ONE);

    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        Self(sum(terms.map(|term| term.map(|factor| factor.0))))
    }
    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        // A float's power of two is computed once for a row of a matrix.
        Self(if R::IS_FLOAT { self.0 * R::ONE.scaled(e) } else { self.0.scaled(e) })
    }
}

impl<R: Real> Number for Plain<R> {
    type Estimate = Self;
    type Long = Self;
    const IS_WIDE: bool = !R::IS_FLOAT;
    const KNOWS_LENGTH: bool = false;
    const APPROACHES_AGAIN: bool = false;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        Some(order(self.0, R::ZERO))
    }
    #[inline(always)]
    fn estimate(self) -> Self {
        self
    }
    #[inline(always)]
    fn long(self) -> Self {
        self
    }
    #[inline(always)]
    fn rounded_quotient(self, other: Self) -> Option<Self> {
        Some(self.over(other))
    }
    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        if R::HAS_INSTRUCTIONS { work() } else { super::in_a_function(work) }
    }
}

impl<R: Real> Estimate for Plain<R> {
    const INFINITY: Self = Self(R::INFINITY);
    const DIGITS: i32 = -R::ROUNDING;
    type Rough = Self;

    #[inline(always)]
    fn rough(self) -> Self {
        self
    }
    #[inline(always)]
    fn exactly(value: Self) -> Self {
        value
    }

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
        Some(order(self.0, other.0))
    }
    #[inline(always)]
    fn is_within(self, other: Self, e: i32) -> bool {
        self.0.abs().scaled(e) <= other.0
    }
}
