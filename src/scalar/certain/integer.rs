//! The last resort: integers of a fixed capacity, times a power of two.
//!
//! Sums and products of scalars are exact in them, whatever the exponents, so that every sign is certain. They cost a
//! hundred times as much as the filters, which is why those are asked first. Plain schoolbook arithmetic on 32-bit limbs:
//! numbers keep only the limbs that they use, and those of everyday inputs are few.

use super::double::Double;
use super::{FromScalar, Number};
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

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

    /// Adds `value * 2^(32 index)` to the limbs; what carries beyond the capacity is lost, which the capacity forbids.
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

    /// Counts the limbs in use, and drops lowest ones of zero.
    fn trimmed(mut self) -> Self {
        let Some(highest) = self.limbs.iter().rposition(|limb| *limb != 0) else {
            return Self::NOTHING;
        };
        let lowest = self.limbs.iter().position(|limb| *limb != 0).unwrap_or(0);
        if lowest > 0 {
            // Up to the end, though all above the highest are zero: a range that cannot be empty needs no panic.
            self.limbs.copy_within(lowest.., 0);
            let used = highest + 1 - lowest;
            self.limbs.iter_mut().skip(used).for_each(|limb| *limb = 0);
        }
        self.length = highest + 1 - lowest;
        self.exponent += lowest as i32;
        self
    }

    /// `mantissa * 2^exponent`.
    pub(super) fn new(mantissa: i64, exponent: i32) -> Self {
        let mut result = Self { negative: mantissa < 0, exponent: exponent.div_euclid(32), ..Self::NOTHING };
        let shifted = (mantissa.unsigned_abs() as u128) << exponent.rem_euclid(32);
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

    /// The highest 64 bits, and the exponent that belongs to them.
    fn leading(&self) -> (u64, i32) {
        let top = self.length as i32;
        let (a, b, c) = (self.limb(top - 1), self.limb(top - 2), self.limb(top - 3));
        let shift = a.leading_zeros() % 32;
        let all = ((a as u128) << 64) | ((b as u128) << 32) | c as u128;
        let bits = ((all << shift) >> 32) as u64;
        (bits, 32 * (top - 2 + self.exponent) - shift as i32)
    }

    /// An exponent of which the power of two is above the magnitude.
    fn top(&self) -> i32 {
        let (_, exponent) = self.leading();
        exponent + 64
    }

    /// The value divided by `2^e`, as a block or a double makes it from the highest 62 bits.
    fn leading_over(&self, e: i32) -> (i64, i32) {
        let (bits, exponent) = self.leading();
        let magnitude = (bits >> 2) as i64;
        (if self.negative { -magnitude } else { magnitude }, exponent + 2 - e)
    }

    /// The exponent by which three numbers come near 1.
    fn common_exponent(values: &[Self; 3]) -> i32 {
        values.iter().filter(|value| value.length != 0).map(Self::top).max().unwrap_or(0)
    }
}

impl<const N: usize> Add for Integer<N> {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let order = self.compare_magnitude(&other);
        let subtract = self.negative != other.negative;
        if order == Ordering::Less {
            Self::combined(&other, &self, subtract)
        } else {
            Self::combined(&self, &other, subtract)
        }
    }
}

impl<const N: usize> Neg for Integer<N> {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.negative = !self.negative && self.length != 0;
        self
    }
}

impl<const N: usize> Sub for Integer<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const N: usize> Mul for Integer<N> {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
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
}

macro_rules! integer {
    ($N:expr, $Estimate:ident, $to_estimate:expr) => {
        impl Number for Integer<{ $N }> {
            type Estimate = $Estimate;
            const ZERO: Self = Self::NOTHING;
            const ONE: Self = {
                let mut one = Self::NOTHING;
                one.limbs[0] = 1;
                one.length = 1;
                one
            };

            fn sign(self) -> Option<Ordering> {
                Some(match (self.length, self.negative) {
                    (0, _) => Ordering::Equal,
                    (_, true) => Ordering::Less,
                    (_, false) => Ordering::Greater,
                })
            }

            fn scaled(self, e: i32) -> Self {
                self * Self::new(1, e)
            }

            fn together(values: [Self; 3], square: Self) -> ([$Estimate; 3], $Estimate) {
                let e = Self::common_exponent(&values);
                let estimate = |value: &Self, e: i32| {
                    if value.length == 0 {
                        return <$Estimate as Number>::ZERO;
                    }
                    let (mantissa, exponent) = value.leading_over(e);
                    $to_estimate(mantissa, exponent)
                };
                (values.map(|value| estimate(&value, e)), estimate(&square, 2 * e))
            }
        }
    };
}

integer!(super::FLOAT_LIMBS, Double, |mantissa: i64, exponent: i32| {
    use crate::scalar::Real;
    Double::rounded_once((mantissa as f64).times_power_of_two(exponent))
});

impl FromScalar<f32> for Integer<{ super::FLOAT_LIMBS }> {
    fn scalar(value: f32) -> Self {
        let bits = value.to_bits();
        let (field, fraction) = ((bits >> 23) & 0xff, (bits & 0x007f_ffff) as i64);
        let magnitude = if field == 0 { fraction } else { fraction | 0x0080_0000 };
        Self::new(if value.is_sign_negative() { -magnitude } else { magnitude }, field.max(1) as i32 - 150)
    }
    fn unit(value: f32) -> Self {
        <Self as FromScalar<f32>>::scalar(value)
    }
}

#[cfg(feature = "fixed")]
mod fixed_point {
    use super::super::wide::Wide;
    use super::{FromScalar, Integer, Number, Ordering};
    use crate::scalar::block::Block128;
    use fixed::FixedI32;
    use fixed::types::extra::{LeEqU32, U30};

    integer!(super::super::FIXED_LIMBS, Wide, |mantissa: i64, exponent: i32| {
        Wide::truncated(Block128::new(mantissa as i128, exponent))
    });

    impl<F: LeEqU32 + Send + Sync + 'static> FromScalar<FixedI32<F>> for Integer<{ super::super::FIXED_LIMBS }> {
        fn scalar(value: FixedI32<F>) -> Self {
            Self::new(value.to_bits() as i64, -F::I32)
        }
        fn unit(value: FixedI32<U30>) -> Self {
            Self::new(value.to_bits() as i64, -30)
        }
    }
}
