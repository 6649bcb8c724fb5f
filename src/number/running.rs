//! A value with a running bound of its error.
//!
//! Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., 3.3: each operation adds its own rounding to the
//! error that its operands bring along. The bound is in *roundings*: units of `u`, half of the spacing of floats next
//! to 1.
//!
//! The rounded result `x` of an addition or a subtraction has an error of at most `u |x|`, also where it is subnormal.
//! That of a product or a quotient has at most `u |x| + m` with the smallest normal number `m`: where the result
//! underflows the error is at most `u m`, but a bound below `m` would itself lose bits. For operands `a + u e`,
//! `b + u f`, of which `a` and `b` are computed, the error that is brought along is at most
//!
//! | operation | error, in roundings |
//! |---|---|
//! | `a + b` | `e + f` |
//! | `a b` | `(|a| + u e) f + e |b|` |
//! | `a / b` | `(e + |a / b| f) / (|b| - u f)` |
//! | `sqrt(a)` | `e / (sqrt(a) + sqrt(a - u e))`, which is at most `(1 + x) e / (2 sqrt(a))` with `x = u e / a` in [0, 1]: its convex function lies below the chord |
//!
//! A sum of products adds a rounding of each product and of each partial sum. The components of a vector have one
//! bound, that of the largest error: then a scalar product `a . b` inherits at most `(|a| + M u e) f + e |b|` with
//! sums of magnitudes `|a|`, `|b|`, which several products share, and a vector product no more. (A bound for each
//! component costs 3 to 10 % more instructions.)
//!
//! The bound is computed with rounding itself: in fewer than 64 operations one after the other, each of which changes
//! it by at most one part in `1 / u`. [`Running::sure`] allows for a thousand times as much.

use super::{Estimate, Number, Ring};
use crate::scalar::Real;
use core::cmp::Ordering;

/// A value, and a bound of its error in roundings.
///
/// If it is `STABLE`, a parameter of the ray is known only if its error is so small that it has the accuracy of the
/// tier `Stable`. If it is not, it need only be right to one part in 2^12, for the tier `Fast`, which promises signs
/// and no accuracy.
#[derive(Clone, Copy, Debug)]
pub struct Running<R, const STABLE: bool = true> {
    pub(crate) value: R,
    pub(crate) error: R,
}

impl<R: Real, const STABLE: bool> Running<R, STABLE> {
    /// A value without an error.
    #[inline(always)]
    pub(crate) const fn exact(value: R) -> Self {
        Self { value, error: R::ZERO }
    }

    /// The smallest normal number, in roundings.
    #[inline(always)]
    fn underflow() -> R {
        R::SMALLEST.scaled(-R::ROUNDING)
    }

    /// The error that a bound stands for, and what the computation of the bound may have lost.
    #[inline(always)]
    pub(crate) fn sure(error: R) -> R {
        error * (R::ONE.scaled(R::ROUNDING) + R::ONE.scaled(R::ROUNDING - 8))
    }

    /// The largest magnitude that the exact value may have.
    #[inline(always)]
    fn most(self) -> R {
        self.value.abs() + self.error.scaled(R::ROUNDING)
    }

    /// The sum of the components' magnitudes, and the largest of their errors.
    #[inline(always)]
    fn size_and_error<const M: usize>(v: [Self; M]) -> [R; 2] {
        let (mut size, mut error) = (v[0].value.abs(), v[0].error);
        let mut i = 1;
        while i < M {
            size = size + v[i].value.abs();
            error = if v[i].error > error { v[i].error } else { error };
            i += 1;
        }
        [size, error]
    }

    /// The error that a product of two vectors inherits, and what its products lose by underflow.
    #[inline(always)]
    fn inherited_by_vectors<const M: usize>(a: [Self; M], b: [Self; M]) -> R {
        let ([a, e], [b, f]) = (Self::size_and_error(a), Self::size_and_error(b));
        let bits = if M > 2 { 2 } else { 1 };
        (a + e.scaled(R::ROUNDING + bits)) * f + e * b + Self::underflow().scaled(bits)
    }

    /// The error that a product of the two inherits.
    #[inline(always)]
    fn inherited(self, other: Self) -> R {
        self.most() * other.error + self.error * other.value.abs()
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self { value, error: self.error + other.error + value.abs() }
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self::sum([[self, other]])
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

operators!(Running<R, STABLE>, R: Real, const STABLE: bool);

impl<R: Real, const STABLE: bool> Ring for Running<R, STABLE> {
    const ZERO: Self = Self::exact(R::ZERO);
    const ONE: Self = Self::exact(R::ONE);

    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let [a, b] = terms[0];
        let mut value = a.value * b.value;
        let mut error = a.inherited(b) + value.abs();
        let mut i = 1;
        while i < M {
            let [a, b] = terms[i];
            let term = a.value * b.value;
            value = value + term;
            error = error + (a.inherited(b) + term.abs()) + value.abs();
            i += 1;
        }
        Self { value, error: error + Self::underflow().scaled(if M > 2 { 2 } else { 1 }) }
    }
    #[inline(always)]
    fn scalar_product<const M: usize>(a: [Self; M], b: [Self; M]) -> Self {
        let mut value = a[0].value * b[0].value;
        let mut error = Self::inherited_by_vectors(a, b) + value.abs();
        let mut i = 1;
        while i < M {
            let term = a[i].value * b[i].value;
            value = value + term;
            error = error + term.abs() + value.abs();
            i += 1;
        }
        Self { value, error }
    }
    #[inline(always)]
    fn vector_product(a: [Self; 3], b: [Self; 3]) -> [Self; 3] {
        let inherited = Self::inherited_by_vectors(a, b);
        let minor = |i: usize, j: usize| {
            let (first, second) = (a[i].value * b[j].value, a[j].value * b[i].value);
            let value = first - second;
            Self { value, error: inherited + (first.abs() + second.abs() + value.abs()) }
        };
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }
    #[inline(always)]
    fn less_square(a: Self, b: Self, v: [Self; 3]) -> Self {
        a * b - Self::scalar_product(v, v)
    }
    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        // Rounded only where the result is subnormal.
        let power = R::ONE.scaled(e);
        Self { value: self.value * power, error: self.error * power + Self::underflow() }
    }
}

impl<R: Real, const STABLE: bool> Number for Running<R, STABLE> {
    type Estimate = Self;
    type Long = Self;
    const IS_WIDE: bool = false;
    const KNOWS_ZERO: bool = false;
    const STARTS_AT_VERTEX: bool = true;

    /// Zero is certain only for a stored number, and for sums of such: a product may have underflowed.
    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        let doubt = Self::sure(self.error);
        // Comparisons are false for what is not a number.
        if self.value > doubt {
            Some(Ordering::Greater)
        } else if self.value < -doubt {
            Some(Ordering::Less)
        } else if self.error.is_zero() {
            Some(Ordering::Equal)
        } else {
            None
        }
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
    fn without_error(self) -> Self {
        Self::exact(self.value)
    }
    #[inline(always)]
    fn is_negligible_squared(self) -> bool {
        R::ROUNDING > -38 || self.value.abs() <= R::ONE.scaled(R::ROUNDING / 2 - 2)
    }
    #[inline(always)]
    fn rounded_quotient(self, other: Self) -> Option<Self> {
        Some(self.over(other))
    }
    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        super::Plain::<R>::apart(work)
    }
}

impl<R: Real, const STABLE: bool> Estimate for Running<R, STABLE> {
    const INFINITY: Self = Self::exact(R::INFINITY);
    const DIGITS: i32 = -R::ROUNDING;
    type Rough = super::Plain<R>;

    #[inline(always)]
    fn rough(self) -> super::Plain<R> {
        super::Plain(self.value)
    }
    #[inline(always)]
    fn exactly(value: super::Plain<R>) -> Self {
        Self::exact(value.0)
    }

    #[inline(always)]
    fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let size = value.abs();
        let least = other.value.abs() - Self::sure(other.error);
        // A divisor that may be zero gives an infinite error.
        let least = if least > R::ZERO { least } else { R::ZERO };
        Self { value, error: (self.error + size * other.error) / least + size + Self::underflow() }
    }
    #[inline(always)]
    fn square_root(self) -> Self {
        let value = self.value.sqrt();
        let inherited = self.error / value;
        let half = inherited.scaled(-1);
        Self { value, error: half + half * (inherited / value).scaled(R::ROUNDING) + value }
    }
    #[inline(always)]
    fn compare(self, other: Self) -> Option<Ordering> {
        let doubt = Self::sure(self.error + other.error);
        let difference = self.value - other.value;
        if difference > doubt {
            Some(Ordering::Greater)
        } else if difference < -doubt {
            Some(Ordering::Less)
        } else if doubt.is_zero() {
            // Also for two infinities, whose difference is not a number.
            Some(Ordering::Equal)
        } else {
            None
        }
    }
    #[inline(always)]
    fn is_within(self, other: Self, e: i32) -> bool {
        self.value.abs().scaled(e) <= other.value
    }
}

#[cfg(units)]
#[path = "../../tests/units/number/running.rs"]
mod tests;
