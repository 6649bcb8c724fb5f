//! The robust number: enough bits that the sign of the rounded value is taken at its word.

use super::word::Word;
use super::{Estimate, Limbs, Number, Parts, Ring};
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// A number of 64 bits, for `f32` and 32-bit fixed point, or of 128, for `f64` and 64-bit fixed point: `docs/design/robust-number.md`
/// derives why these are enough.
#[derive(Clone, Copy, Debug)]
pub struct Robust<W>(Limbs<W>);

impl<W: Word> Robust<W> {
    /// A stored number.
    #[inline]
    pub(crate) fn of(Parts { mantissa, exponent, negative }: Parts) -> Self {
        Self(Limbs::from_integer(mantissa, exponent, negative))
    }

    /// The number itself.
    #[inline(always)]
    pub(crate) const fn limbs(self) -> Limbs<W> {
        self.0
    }
}

impl<W: Word> Add for Robust<W> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.total::<false>(&other.0).0)
    }
}

impl<W: Word> Sub for Robust<W> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<W: Word> Neg for Robust<W> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.negated())
    }
}

impl<W: Word> Mul for Robust<W> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self(self.0.product(&other.0).0)
    }
}

impl<W: Word> Ring for Robust<W> {
    const ZERO: Self = Self(Limbs::ZERO);
    const ONE: Self = Self(Limbs::ONE);

    #[inline]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        Self(Limbs::sum_of_products::<M, false>(&terms.map(|term| term.map(Self::limbs))).0)
    }

    #[inline]
    fn scaled(self, e: i32) -> Self {
        Self(self.0.scaled(e))
    }
}

impl<W: Word> Number for Robust<W> {
    type Estimate = Self;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        Some(if self.0.is_zero() {
            Ordering::Equal
        } else if self.0.is_negative() {
            Ordering::Less
        } else {
            Ordering::Greater
        })
    }

    #[inline(always)]
    fn estimate(self) -> Self {
        self
    }
}

impl<W: Word> Estimate for Robust<W> {
    #[inline]
    fn over(self, other: Self) -> Self {
        Self(self.0.quotient(&other.0))
    }

    #[inline]
    fn square_root(self) -> Self {
        Self(self.0.square_root())
    }

    #[inline]
    fn top(self) -> Option<i32> {
        (!self.0.is_zero()).then(|| self.0.top())
    }

    #[inline]
    fn compare(self, other: Self) -> Option<Ordering> {
        let own = self.sign()?;
        Some(own.cmp(&other.sign()?).then_with(|| {
            let order = self.0.compare_magnitude(&other.0);
            match own {
                Ordering::Less => order.reverse(),
                Ordering::Equal => Ordering::Equal,
                Ordering::Greater => order,
            }
        }))
    }
}
