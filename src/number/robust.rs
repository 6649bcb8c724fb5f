//! The robust number: it has so many bits that the sign of the rounded value is used as the sign.

use super::limbs::{INFINITE_EXPONENT, ZERO_EXPONENT};
use super::word::Word;
use super::{Estimate, Limbs, Number, Parts, Ring};
use core::cmp::Ordering;

/// A number of 64 bits for `f32` and 32-bit fixed point, or of 128 bits for `f64` and 64-bit fixed point.
/// `docs/design/robust-number.md` derives why that is enough.
pub type Robust<W> = Limbs<W>;

impl<W: Word> Limbs<W> {
    /// A stored number.
    #[inline]
    pub(crate) fn of(Parts { mantissa, exponent, negative }: Parts) -> Self {
        Self::from_integer(mantissa, exponent, negative)
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        self.total::<false>(&other).0
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        self.product(&other).0
    }
}

operators!(Limbs<W>, W: Word);

impl<W: Word> Ring for Limbs<W> {
    const ZERO: Self = Self { mantissa: W::ZERO, exponent: ZERO_EXPONENT, negative: false };
    const ONE: Self = Self { mantissa: W::TOP, exponent: 1, negative: false };

    #[inline]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        Self::sum_of_products::<M, false>(&terms).0
    }

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        if self.is_zero() { self } else { Self { exponent: self.exponent + e, ..self } }
    }
}

impl<W: Word> Number for Limbs<W> {
    type Estimate = Self;
    type Long = Self;

    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        super::in_a_function(work)
    }

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        Some(if self.is_zero() {
            Ordering::Equal
        } else if self.is_negative() {
            Ordering::Less
        } else {
            Ordering::Greater
        })
    }

    #[inline(always)]
    fn estimate(self) -> Self {
        self
    }

    #[inline(always)]
    fn long(self) -> Self {
        self
    }
}

impl<W: Word> Estimate for Limbs<W> {
    const INFINITY: Self = Self { mantissa: W::TOP, exponent: INFINITE_EXPONENT, negative: false };
    const DIGITS: i32 = Self::BITS;
    type Rough = Self;

    #[inline(always)]
    fn rough(self) -> Self {
        self
    }
    #[inline(always)]
    fn exactly(value: Self) -> Self {
        value
    }

    #[inline]
    fn over(self, other: Self) -> Self {
        self.quotient(&other)
    }

    #[inline]
    fn square_root(self) -> Self {
        self.root()
    }

    #[inline]
    fn top(self) -> Option<i32> {
        (!self.is_zero()).then_some(self.exponent)
    }

    #[inline]
    fn compare(self, other: Self) -> Option<Ordering> {
        let own = self.sign()?;
        Some(own.cmp(&other.sign()?).then_with(|| {
            let order = self.compare_magnitude(&other);
            match own {
                Ordering::Less => order.reverse(),
                Ordering::Equal => Ordering::Equal,
                Ordering::Greater => order,
            }
        }))
    }
}
