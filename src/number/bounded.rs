//! The robust number with an error bound.

use super::word::Word;
use super::{Estimate, Limbs, Number, Parts, Ring};
use core::cmp::Ordering;

/// A mantissa and exponent, and the exponent of a power of two that bounds the error (running error analysis: Higham,
/// *Accuracy and Stability of Numerical Algorithms*, 3.3).
#[derive(Clone, Copy, Debug)]
pub struct Bounded<W> {
    value: Limbs<W>,
    /// The exponent of the error bound; [`EXACT`] if no bits have been cut off.
    error: i32,
}

/// The exponent of the error bound of an exact number, below all others.
const EXACT: i32 = i32::MIN;

impl<W: Word> Bounded<W> {
    /// A stored number.
    #[inline]
    pub(crate) fn of(Parts { mantissa, exponent, negative }: Parts) -> Self {
        Self::exact(Limbs::from_integer(mantissa, exponent, negative))
    }

    /// The value, if its error is at most `2^most(top)`, where `2^top` is just above its magnitude.
    #[inline]
    pub(crate) fn within(self, most: impl Fn(i32) -> i32) -> Option<Limbs<W>> {
        (self.error == EXACT || self.error <= most(self.value.exponent())).then_some(self.value)
    }

    #[inline(always)]
    const fn exact(value: Limbs<W>) -> Self {
        Self { value, error: EXACT }
    }

    /// The highest bits of a number, with an error bound if bits were cut off.
    pub(super) fn cut_off((value, is_cut): (Limbs<W>, bool)) -> Self {
        Self { value, error: cut(&value, is_cut) }
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        let (value, is_cut) = self.value.total::<true>(&other.value);
        let mut total = Total::NONE.with(self.error).with(other.error);
        if is_cut {
            // The error of the shorter term, cut off where the sum ends, and that of the sum itself.
            let top = self.value.exponent().max(other.value.exponent());
            total = total.with(top - 2 * Limbs::<W>::BITS + 4).with(value.exponent() - Limbs::<W>::BITS);
        }
        Self { value, error: total.exponent() }
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        let (value, is_cut) = self.value.product(&other.value);
        Self { value, error: product_error([self, other]).with(cut(&value, is_cut)).exponent() }
    }

    #[inline(always)]
    fn negative(self) -> Self {
        Self { value: self.value.negative(), ..self }
    }
}

operators!(Bounded<W>, W: Word);

/// A bound of the sum of errors, at most 64 of them.
#[derive(Clone, Copy)]
struct Total {
    largest: i32,
    count: u32,
}

impl Total {
    const NONE: Self = Self { largest: EXACT, count: 0 };

    #[inline(always)]
    fn with(self, error: i32) -> Self {
        if error == EXACT {
            return self;
        }
        Self { largest: if error > self.largest { error } else { self.largest }, count: self.count + 1 }
    }

    #[inline(always)]
    fn exponent(self) -> i32 {
        if self.count < 2 {
            return self.largest;
        }
        // The least power of two that is not below the count.
        self.largest + (32 - (self.count - 1).leading_zeros()) as i32
    }
}

/// The exponent of a product of a magnitude below `2^top` and an error.
#[inline(always)]
fn times(top: i32, error: i32) -> i32 {
    if error == EXACT { EXACT } else { error + top }
}

/// The error of a number of which bits were cut off.
#[inline(always)]
fn cut<W: Word>(value: &Limbs<W>, is_cut: bool) -> i32 {
    if is_cut { value.exponent() - Limbs::<W>::BITS } else { EXACT }
}

/// The error of a product from the errors of its factors.
#[inline(always)]
fn product_error<W: Word>([a, b]: [Bounded<W>; 2]) -> Total {
    let both = if a.error == EXACT { EXACT } else { times(a.error, b.error) };
    Total::NONE.with(times(a.value.exponent(), b.error)).with(times(b.value.exponent(), a.error)).with(both)
}

impl<W: Word> Ring for Bounded<W> {
    const ZERO: Self = Self::exact(Limbs::ZERO);
    const ONE: Self = Self::exact(Limbs::ONE);

    #[inline]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let (value, is_cut) = Limbs::sum_of_products::<M, true>(&terms.map(|term| term.map(|factor| factor.value)));
        let mut total = Total::NONE;
        let mut top = i32::MIN;
        for [a, b] in terms {
            let inherited = product_error([a, b]).exponent();
            total = total.with(inherited);
            top = top.max(a.value.exponent() + b.value.exponent());
        }
        if is_cut {
            // The errors of the terms, cut off where the sum ends (at most four terms, with three bits of room above),
            // and that of the sum itself.
            total = total.with(top - 2 * Limbs::<W>::BITS + 5).with(value.exponent() - Limbs::<W>::BITS);
        }
        Self { value, error: total.exponent() }
    }

    #[inline]
    fn scaled(self, e: i32) -> Self {
        Self { value: self.value.scaled(e), error: times(e, self.error) }
    }
}

impl<W: Word> Number for Bounded<W> {
    type Estimate = Self;
    type Long = Self;
    const DECIDES_BY_SIGNS: bool = true;

    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        super::in_a_function(work)
    }

    #[inline]
    fn sign(self) -> Option<Ordering> {
        // At least 2^(top - 1) in magnitude.
        if self.error != EXACT && (self.value.is_zero() || self.value.exponent() - 1 <= self.error) {
            return None;
        }
        self.value.sign()
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

impl<W: Word> Estimate for Bounded<W> {
    const INFINITY: Self = Self::exact(Limbs::INFINITY);
    const DIGITS: i32 = Limbs::<W>::BITS;
    type Rough = Limbs<W>;

    #[inline(always)]
    fn rough(self) -> Limbs<W> {
        self.value
    }
    #[inline(always)]
    fn exactly(value: Limbs<W>) -> Self {
        Self::exact(value)
    }

    #[inline]
    fn over(self, other: Self) -> Self {
        let value = self.value.quotient(&other.value);
        // The residual steps leave an error of a few units in the last place, in addition to the rounding.
        let own = value.exponent() - Limbs::<W>::BITS + W::SPARE as i32 + 1;
        // (error + |quotient| error') / |divisor|, where the magnitude of the divisor is at least 2^(top - 1) minus its
        // error, and the error is less than half of that.
        let inherited = Total::NONE.with(self.error).with(times(value.exponent(), other.error)).exponent();
        Self { value, error: Total::NONE.with(own).with(times(2 - other.value.exponent(), inherited)).exponent() }
    }

    #[inline]
    fn square_root(self) -> Self {
        let value = self.value.root();
        let own = if self.value.is_zero() { EXACT } else { value.exponent() - Limbs::<W>::BITS + W::SPARE as i32 + 1 };
        // sqrt(a) - sqrt(a - e) <= e / sqrt(a), and sqrt(a) is at least 2^(top - 1).
        let inherited = if self.value.is_zero() { halved(self.error) } else { times(1 - value.exponent(), self.error) };
        Self { value, error: Total::NONE.with(own).with(inherited).exponent() }
    }

    #[inline]
    fn top(self) -> Option<i32> {
        self.value.top()
    }

    #[inline]
    fn compare(self, other: Self) -> Option<Ordering> {
        (self - other).sign()
    }
}

/// The root of an error, rounded up.
fn halved(error: i32) -> i32 {
    if error == EXACT { EXACT } else { (error >> 1) + 1 }
}
