//! A double-word number with the magnitude of its terms.

use super::{Number, Ring, Running};
use crate::scalar::{Real, Twofold};
use core::cmp::Ordering;

/// A double-word number, and the same polynomial of the magnitudes of its inputs.
///
/// An operation on double-words has an error of at most `8 u^2` relative to the magnitudes of its terms (Joldes, Muller
/// and Popescu, *Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word Arithmetic*, 2017; a sum may
/// cancel, which is why the error counts relative to the terms). No polynomial of the solver has more than 64
/// operations one after the other, so that its error is less than `2^10 u^2` of its magnitude.
#[derive(Clone, Copy, Debug)]
pub struct Doubled<R> {
    value: Twofold<R>,
    magnitude: R,
}

/// The exponent of that bound, in squares of `u`.
const DOUBT: i32 = 10;

impl<R: Real> Doubled<R> {
    /// A value without an error.
    #[inline(always)]
    pub(crate) fn exact(value: R) -> Self {
        Self { value: Twofold::of(value), magnitude: value.abs() }
    }

    /// The difference of two values, without an error.
    #[inline(always)]
    pub(crate) fn difference(a: R, b: R) -> Self {
        let [high, low] = a.plus_with_rest(-b);
        Self { value: Twofold { high, low }, magnitude: high.abs() }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        // A product that underflows has an error of its own, and zero is not certain.
        Self { value: self.value * other.value, magnitude: self.magnitude * other.magnitude + R::SMALLEST }
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

operators!(Doubled<R>, R: Real);

impl<R: Real> Ring for Doubled<R> {
    const ZERO: Self = Self { value: Twofold::ZERO, magnitude: R::ZERO };
    const ONE: Self = Self { value: Twofold::ONE, magnitude: R::ONE };

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        Self { value: self.value.scaled(e), magnitude: self.magnitude.scaled(e) + R::SMALLEST }
    }
}

impl<R: Real> Number for Doubled<R> {
    type Estimate = Running<R>;
    const KNOWS_ZERO: bool = false;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        // The low word of a product next to the smallest number is lost.
        let doubt = self.magnitude.scaled(2 * R::ROUNDING + DOUBT) + R::SMALLEST.scaled(6);
        if self.value.high > doubt {
            Some(Ordering::Greater)
        } else if self.value.high < -doubt {
            Some(Ordering::Less)
        } else if self.magnitude.is_zero() {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
    #[inline(always)]
    fn estimate(self) -> Running<R> {
        let value = self.value.high;
        let error = self.magnitude.scaled(R::ROUNDING + DOUBT) + value.abs();
        Running { value, error: error + R::SMALLEST.scaled(6 - R::ROUNDING) }
    }
    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        super::in_a_function(work)
    }
}
