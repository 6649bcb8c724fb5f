//! Double-word numbers made of the computing number, where they are faster than the robust number.

use super::Real;
use crate::number::{Ring, operators};

/// A sum `high + low`, rounded to about twice the computing number's precision (Dekker, *A floating-point technique for
/// extending the available precision*, 1971). On overflow it is a NaN.
#[derive(Clone, Copy, Debug)]
pub struct Twofold<R> {
    pub(crate) high: R,
    pub(crate) low: R,
}

impl<R: Real> Twofold<R> {
    /// The number itself.
    #[inline(always)]
    pub(crate) const fn of(high: R) -> Self {
        Self { high, low: R::ZERO }
    }

    #[inline(always)]
    fn new([high, low]: [R; 2], rest: R) -> Self {
        let [high, low] = high.plus_with_rest(low + rest);
        Self { high, low }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self::new(self.high.plus_with_rest(other.high), self.low + other.low)
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self::new(self.high.times_with_rest(other.high), self.high * other.low + self.low * other.high)
    }

    #[inline(always)]
    fn negative(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

operators!(Twofold<R>, R: Real);

impl<R: Real> Ring for Twofold<R> {
    const ZERO: Self = Self::of(R::ZERO);
    const ONE: Self = Self::of(R::ONE);

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        Self { high: self.high.scaled(e), low: self.low.scaled(e) }
    }
}
