//! Integers of a fixed capacity, times a power of two.
//!
//! Sums and products of scalars are exact in them, whatever the exponents, so that every sign is certain. They cost a
//! hundred times as much as the bounded number, which is therefore tried first. The arithmetic is schoolbook, on 32-bit
//! limbs. A number has only as many limbs as it needs, which for usual inputs are few.

use super::{Bounded, Limbs, Number, Parts, Ring};
use core::cmp::Ordering;

/// Limbs of an integer that holds every polynomial of the solvers over `f32`.
///
/// A coordinate spans 277 binary places, a local coordinate, which has a row of an affine inverse as a factor, at most
/// 690. The widest polynomial is that of a frustum where the line crosses a plane, of less than 3,900 places.
pub(crate) const FLOAT_LIMBS: usize = 128;
/// The same over 32-bit fixed types: a local coordinate has 66 places, and the exponents of the rows of an affine
/// inverse differ by up to 124; the widest polynomial spans some 640.
#[cfg(feature = "fixed")]
pub(crate) const FIXED_LIMBS: usize = 32;

/// Limbs of an integer that holds every polynomial of the equation of a torus over `f32`: the discriminant of a quartic
/// spans less than 17,000 binary places.
const LONG_FLOAT_LIMBS: usize = 544;
/// The same over 32-bit fixed types: less than 4,900 places.
#[cfg(feature = "fixed")]
const LONG_FIXED_LIMBS: usize = 160;

/// `(-1)^negative * limbs * 2^(32 * exponent)`, with neither a highest nor a lowest limb of zero.
#[derive(Clone, Copy, Debug)]
pub struct Integer<const N: usize> {
    limbs: [u32; N],
    length: usize,
    exponent: i32,
    negative: bool,
}

impl<const N: usize> Integer<N> {
    const NOTHING: Self = Self { limbs: [0; N], length: 0, exponent: 0, negative: false };

    #[inline]
    fn limb(&self, index: i32) -> u32 {
        usize::try_from(index).ok().and_then(|index| self.limbs.get(index)).copied().unwrap_or(0)
    }

    /// Adds `value * 2^(32 index)` to the limbs. A carry beyond the capacity would be lost; the capacity is chosen so
    /// that there is none.
    #[inline]
    fn accumulate(&mut self, mut index: usize, mut value: u64) {
        while value != 0 {
            let Some(limb) = self.limbs.get_mut(index) else {
                debug_assert!(false, "the capacity holds every polynomial of the solvers");
                return;
            };
            let sum = *limb as u64 + (value & 0xffff_ffff);
            *limb = sum as u32;
            value = (value >> 32) + (sum >> 32);
            index += 1;
        }
    }

    /// Counts the limbs in use, and drops the lowest limbs that are zero.
    fn trimmed(mut self) -> Self {
        let Some(highest) = self.limbs.iter().rposition(|limb| *limb != 0) else {
            return Self::NOTHING;
        };
        let lowest = self.limbs.iter().position(|limb| *limb != 0).unwrap_or(0);
        if lowest > 0 {
            // Up to the end, although all limbs above the highest are zero: a range that cannot be empty has no panic
            // path.
            self.limbs.copy_within(lowest.., 0);
            let used = highest + 1 - lowest;
            self.limbs.iter_mut().skip(used).for_each(|limb| *limb = 0);
        }
        self.length = highest + 1 - lowest;
        self.exponent += lowest as i32;
        self
    }

    pub(crate) fn of(Parts { mantissa, exponent, negative }: Parts) -> Self {
        let result = Self::new(mantissa, exponent);
        if negative { -result } else { result }
    }

    /// `mantissa * 2^exponent`.
    fn new(mantissa: u64, exponent: i32) -> Self {
        let mut result = Self { exponent: exponent.div_euclid(32), ..Self::NOTHING };
        let shifted = (mantissa as u128) << exponent.rem_euclid(32);
        for index in 0..3 {
            result.accumulate(index, (shifted >> (32 * index)) as u32 as u64);
        }
        result.trimmed()
    }

    fn compare_magnitude(&self, other: &Self) -> Ordering {
        let (top, other_top) = (self.length as i32 + self.exponent, other.length as i32 + other.exponent);
        if self.length == 0 || other.length == 0 || top != other_top {
            return (self.length != 0).cmp(&(other.length != 0)).then(top.cmp(&other_top));
        }
        let lowest = self.exponent.min(other.exponent);
        let mut place = top;
        while place > lowest {
            place -= 1;
            let order = self.limb(place - self.exponent).cmp(&other.limb(place - other.exponent));
            if order != Ordering::Equal {
                return order;
            }
        }
        Ordering::Equal
    }

    /// `|larger| +- |smaller|`, with the sign of the larger.
    fn combined(larger: &Self, smaller: &Self, subtract: bool) -> Self {
        let exponent = larger.exponent.min(smaller.exponent);
        let mut result = Self { exponent, negative: larger.negative, ..Self::NOTHING };
        let (offset, smaller_offset) = (larger.exponent - exponent, smaller.exponent - exponent);
        let mut carry = 0i64;
        for (index, limb) in result.limbs.iter_mut().enumerate() {
            let index = index as i32;
            let term = smaller.limb(index - smaller_offset) as i64;
            carry += larger.limb(index - offset) as i64 + if subtract { -term } else { term };
            *limb = carry as u32;
            carry >>= 32;
        }
        debug_assert!(carry == 0, "the capacity holds every polynomial of the solvers");
        result.trimmed()
    }

    #[inline(never)]
    fn plus(self, other: Self) -> Self {
        let order = self.compare_magnitude(&other);
        let subtract = self.negative != other.negative;
        if order == Ordering::Less {
            Self::combined(&other, &self, subtract)
        } else {
            Self::combined(&self, &other, subtract)
        }
    }

    #[inline(never)]
    fn times(self, other: Self) -> Self {
        let negative = self.negative != other.negative;
        let mut result = Self { exponent: self.exponent + other.exponent, negative, ..Self::NOTHING };
        for (i, a) in self.limbs.iter().take(self.length).enumerate() {
            let mut carry = 0u64;
            let mut place = i;
            for b in other.limbs.iter().take(other.length) {
                let Some(limb) = result.limbs.get_mut(place) else {
                    debug_assert!(false, "the capacity holds every polynomial of the solvers");
                    break;
                };
                let sum = *a as u64 * *b as u64 + *limb as u64 + carry;
                *limb = sum as u32;
                carry = sum >> 32;
                place += 1;
            }
            result.accumulate(place, carry);
        }
        result.trimmed()
    }

    fn negative(mut self) -> Self {
        self.negative = !self.negative && self.length != 0;
        self
    }
}

operators!(Integer<N>, const N: usize);

impl<const N: usize> Ring for Integer<N> {
    const ZERO: Self = Self::NOTHING;
    const ONE: Self = {
        let mut one = Self::NOTHING;
        one.limbs[0] = 1;
        one.length = 1;
        one
    };

    #[inline]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let mut sum = Self::ZERO;
        for [a, b] in terms {
            sum = sum + a * b;
        }
        sum
    }

    fn scaled(self, e: i32) -> Self {
        self * Self::new(1, e)
    }
}

/// An integer whose length is one of those that the solvers use.
pub trait OfKnownLength: Copy {
    /// One that holds every polynomial of the equation of a torus, whose discriminant is of the 24th degree in
    /// coordinates.
    type Long: Number<Estimate = Bounded<u128>, Long = Self::Long>;
    /// The same number.
    fn lengthened(self) -> Self::Long;
}

impl<const N: usize> Integer<N> {
    fn resized<const M: usize>(self) -> Integer<M> {
        let mut limbs = [0; M];
        limbs.iter_mut().zip(self.limbs).for_each(|(limb, own)| *limb = own);
        Integer { limbs, length: self.length, exponent: self.exponent, negative: self.negative }
    }
}

/// Names the longer integer of each length, which stable Rust cannot compute.
macro_rules! lengths {
    ($($Length:expr => $Long:expr),+ $(,)?) => {
        $(
            impl OfKnownLength for Integer<{ $Length }> {
                type Long = Integer<{ $Long }>;
                #[inline(always)]
                fn lengthened(self) -> Self::Long {
                    self.resized()
                }
            }
        )+
    };
}
lengths!(
    FLOAT_LIMBS => LONG_FLOAT_LIMBS,
    LONG_FLOAT_LIMBS => LONG_FLOAT_LIMBS,
    FLOAT_LIMBS / 2 * 5 => LONG_FLOAT_LIMBS / 2 * 5,
    LONG_FLOAT_LIMBS / 2 * 5 => LONG_FLOAT_LIMBS / 2 * 5,
);
#[cfg(feature = "fixed")]
lengths!(
    FIXED_LIMBS => LONG_FIXED_LIMBS,
    LONG_FIXED_LIMBS => LONG_FIXED_LIMBS,
    FIXED_LIMBS / 2 * 5 => LONG_FIXED_LIMBS / 2 * 5,
    LONG_FIXED_LIMBS / 2 * 5 => LONG_FIXED_LIMBS / 2 * 5,
);

impl<const N: usize> Number for Integer<N>
where
    Self: OfKnownLength,
{
    type Estimate = Bounded<u128>;
    type Long = <Self as OfKnownLength>::Long;
    const DECIDES_BY_SIGNS: bool = true;

    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        super::in_a_function(work)
    }

    fn sign(self) -> Option<Ordering> {
        Some(match (self.length, self.negative) {
            (0, _) => Ordering::Equal,
            (_, true) => Ordering::Less,
            (_, false) => Ordering::Greater,
        })
    }

    #[inline(always)]
    fn long(self) -> Self::Long {
        self.lengthened()
    }

    fn estimate(self) -> Bounded<u128> {
        let used = self.limbs.get(..self.length).unwrap_or(&self.limbs);
        Bounded::cut_off(Limbs::from_words(used, 32 * self.exponent, self.negative))
    }
}
