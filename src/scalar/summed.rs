//! Numbers whose sums of products are rounded once.

use super::Real;
use crate::number::{Ring, operators};

/// A computing number, of which a sum of products keeps the bits that a cancellation leaves. Its other operations are
/// those of the number.
#[derive(Clone, Copy, Debug)]
pub struct Summed<R>(pub(crate) R);

impl<R: Real> Summed<R> {
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

operators!(Summed<R>, R: Real);

impl<R: Real> Ring for Summed<R> {
    const ZERO: Self = Self(R::ZERO);
    const ONE: Self = Self(R::ONE);

    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        Self(R::sum_of_products(terms.map(|[Self(a), Self(b)]| [a, b])))
    }

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        Self(self.0.scaled(e))
    }
}
