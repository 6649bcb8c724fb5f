//! A double-word number with the magnitude of its terms.

use super::{Ring, Running};
use crate::scalar::{Real, Twofold};

/// A double-word number, and the same polynomial of the magnitudes of its inputs. Lines are transformed in such numbers
/// and then rounded.
///
/// An operation on double-words has an error of at most `8 u^2` relative to the magnitudes of its terms (Joldes, Muller
/// and Popescu, *Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word Arithmetic*, 2017; a sum may
/// cancel, which is why the error counts relative to the terms), and [`Ring::sum`] of three products one of at most
/// `50 u^2`. A coordinate is the sum of three products, of each of which one factor has had two operations. So its
/// error is less than `2^10 u^2` of its magnitude.
#[derive(Clone, Copy, Debug)]
pub struct Doubled<R> {
    value: Twofold<R>,
    magnitude: R,
}

/// The exponent of that bound, in squares of `u`.
const DOUBT: i32 = 10;

impl<R: Real> Doubled<R> {
    /// A magnitude whose error is that of some operations that lose the bits below the smallest subnormal number.
    #[inline(always)]
    fn underflow() -> R {
        R::SMALLEST.scaled(-R::ROUNDING - DOUBT + 6)
    }

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

    /// Rounded to one word. The low word becomes an error. It is counted three times: [`Running`] accepts bounds of up
    /// to twice the error that is promised, since those of operations are seldom reached, but this one always is.
    /// Counted once, hits of rays nearly parallel to a cap were off by 30 units, and counted twice by 15.6.
    #[inline(always)]
    pub(crate) fn rounded(self) -> Running<R> {
        let Twofold { high, low } = self.value;
        let error = self.magnitude.scaled(R::ROUNDING + DOUBT) + low.abs() * R::from_int(3).scaled(-R::ROUNDING);
        Running { value: high, error: error + R::SMALLEST.scaled(-R::ROUNDING) }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self { value: self.value * other.value, magnitude: self.magnitude * other.magnitude + Self::underflow() }
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

super::operators!(Doubled<R>, R: Real);

impl<R: Real> Ring for Doubled<R> {
    const ZERO: Self = Self { value: Twofold::ZERO, magnitude: R::ZERO };
    const ONE: Self = Self { value: Twofold::ONE, magnitude: R::ONE };

    /// The high words are summed exactly, and the low words in one word ("Dot2": Ogita, Rump and Oishi, *Accurate Sum
    /// and Dot Product*, 2005).
    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let product = |[a, b]: [Self; 2]| {
            let [high, rest] = a.value.high.times_with_rest(b.value.high);
            let low = rest + (a.value.high * b.value.low + a.value.low * b.value.high);
            (high, low, a.magnitude * b.magnitude)
        };
        let (mut high, mut low, mut magnitude) = product(terms[0]);
        let mut i = 1;
        while i < M {
            let (term, rest, size) = product(terms[i]);
            let [sum, lost] = high.plus_with_rest(term);
            high = sum;
            low = low + (lost + rest);
            magnitude = magnitude + size;
            i += 1;
        }
        let [high, low] = high.plus_with_rest(low);
        Self { value: Twofold { high, low }, magnitude: magnitude + Self::underflow() }
    }

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        Self { value: self.value.scaled(e), magnitude: self.magnitude.scaled(e) + Self::underflow() }
    }
}

#[cfg(units)]
#[path = "../../tests/units/number/doubled.rs"]
mod tests;
