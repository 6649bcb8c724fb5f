//! Floating-point numbers made of integers: the same bits on every machine.
//!
//! A number is a sign, a mantissa whose top bit is set, and an exponent of 32 bits, so that no number of a solver
//! overflows or underflows. Results are truncated towards zero, so that mirrored rays have mirrored results; the error
//! of an operation is less than one unit in the last place. The basic operation is a *sum of products*: products are
//! computed in twice the width, added, and truncated once (like the "long accumulator" of Kulisch, *Advanced Arithmetic
//! for the Digital Computer*, 2002, but of fixed width). If products cancel, the bits that remain are exact.

use super::Ring;
use super::word::{Wide, Word};
use core::cmp::Ordering;

/// `(-1)^negative * 0.mantissa * 2^exponent`. Zero has no bit set and the lowest exponent.
#[derive(Clone, Copy, Debug)]
pub struct Limbs<W> {
    pub(super) mantissa: W,
    pub(super) exponent: i32,
    pub(super) negative: bool,
}

/// The exponent of zero: below that of any number of the solvers, and far from the limit of its type.
pub(super) const ZERO_EXPONENT: i32 = -(1 << 28);

/// The exponent of infinity: above that of any number of the solvers.
pub(super) const INFINITE_EXPONENT: i32 = 1 << 27;

/// Bits above a product in a sum, so that a sum of four products does not reach the sign.
const HEADROOM: u32 = 3;

impl<W: Word> Limbs<W> {
    pub(crate) const BITS: i32 = W::BITS as i32;

    /// `(-1)^negative * integer * 2^exponent`, exactly.
    #[inline]
    pub(crate) fn from_integer(integer: u64, exponent: i32, negative: bool) -> Self {
        if integer == 0 {
            return Self::ZERO;
        }
        let zeros = integer.leading_zeros();
        let mantissa = W::from_word(integer << zeros);
        Self { mantissa, exponent: exponent + 64 - zeros as i32, negative }
    }

    /// The highest bits of an integer times `2^exponent`, and whether other bits were lost. The integer is given as
    /// words, the lowest first; the highest words may be zero.
    pub(crate) fn from_words(words: &[u32], exponent: i32, negative: bool) -> (Self, bool) {
        let Some(top) = words.iter().rposition(|word| *word != 0) else {
            return (Self::ZERO, false);
        };
        let word = |below: usize| top.checked_sub(below).and_then(|index| words.get(index)).copied().unwrap_or(0);
        let zeros = word(0).leading_zeros();
        let mut highest = 0;
        for below in 0..4 {
            highest = highest << 32 | word(below) as u128;
        }
        let highest = highest << zeros | (word(4) >> 1 >> (31 - zeros)) as u128;
        let used = 32 * (top as i32 + 1) - zeros as i32;
        let lowest = words.iter().position(|word| *word != 0).unwrap_or(0);
        let trailing = 32 * lowest as i32 + word(top - lowest).trailing_zeros() as i32;
        let number = Self { mantissa: W::from_highest(highest), exponent: exponent.saturating_add(used), negative };
        (number, used - trailing > Self::BITS)
    }

    #[inline(always)]
    pub(crate) const fn is_zero(&self) -> bool {
        self.exponent == ZERO_EXPONENT
    }

    #[inline(always)]
    pub(crate) const fn is_negative(&self) -> bool {
        self.negative
    }

    /// The exponent of the smallest power of two above the magnitude.
    #[inline(always)]
    pub(crate) const fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The magnitude as an integer of the unit `2^unit`, rounded to nearest, ties to even; `None` if that takes more
    /// than 64 bits.
    #[inline]
    pub(crate) fn to_units(self, unit: i32) -> Option<u64> {
        let bits = self.exponent.saturating_sub(unit);
        if bits > 64 {
            return None;
        }
        if bits < 0 {
            return Some(0);
        }
        let all = self.mantissa.highest();
        // Two shifts, since all bits may be above the unit, or below it.
        let whole = (all >> 1 >> (127 - bits)) as u64;
        let fraction = all << bits;
        let half = 1 << 127;
        let is_up = fraction > half || fraction == half && whole & 1 != 0;
        whole.checked_add(is_up as u64)
    }

    #[inline(always)]
    pub(crate) fn negative(self) -> Self {
        Self { negative: !self.negative, ..self }
    }

    #[cfg(units)]
    pub(crate) fn magnitude(self) -> Self {
        Self { negative: false, ..self }
    }

    /// How the magnitude compares with another.
    #[inline]
    pub(crate) fn compare_magnitude(&self, other: &Self) -> Ordering {
        self.exponent.cmp(&other.exponent).then(self.mantissa.cmp(&other.mantissa))
    }

    /// The product, and whether bits of it were cut off.
    #[inline(never)]
    pub(crate) fn product(&self, other: &Self) -> (Self, bool) {
        if self.is_zero() || other.is_zero() {
            return (Self::ZERO, false);
        }
        let (mantissa, zeros, is_cut) = self.mantissa.product(other.mantissa).normalized();
        let exponent = self.exponent + other.exponent - zeros as i32;
        (Self { mantissa, exponent, negative: self.negative != other.negative }, is_cut)
    }

    /// The sum of two numbers, and whether bits of it were cut off, if that is to be checked.
    #[inline(never)]
    pub(crate) fn total<const CHECK: bool>(&self, other: &Self) -> (Self, bool) {
        if self.is_zero() {
            return (*other, false);
        }
        if other.is_zero() {
            return (*self, false);
        }
        let top = if self.exponent > other.exponent { self.exponent } else { other.exponent };
        let (one, is_one_cut) =
            term::<_, _, CHECK>(W::Wide::from_high(self.mantissa), top, self.exponent, self.negative);
        let (two, is_two_cut) =
            term::<_, _, CHECK>(W::Wide::from_high(other.mantissa), top, other.exponent, other.negative);
        finished(one.plus(two), top, is_one_cut | is_two_cut)
    }

    /// The sum of at most four products, and whether bits of it were cut off, if that is to be checked.
    ///
    /// For short words there is one function for any number of products, which saves flash on the smallest chips. For
    /// long words there is one for each number of products, which is a quarter faster.
    #[inline]
    pub(crate) fn sum_of_products<const M: usize, const CHECK: bool>(terms: &[[Self; 2]; M]) -> (Self, bool) {
        const { assert!(M <= 4) };
        if W::BITS == 64 { Self::sum_of_any::<CHECK>(terms) } else { Self::sum_of_so_many::<M, CHECK>(terms) }
    }

    #[inline(never)]
    fn sum_of_any<const CHECK: bool>(terms: &[[Self; 2]]) -> (Self, bool) {
        Self::summed::<CHECK>(terms)
    }

    #[inline(never)]
    fn sum_of_so_many<const M: usize, const CHECK: bool>(terms: &[[Self; 2]; M]) -> (Self, bool) {
        Self::summed::<CHECK>(terms)
    }

    #[inline(always)]
    fn summed<const CHECK: bool>(terms: &[[Self; 2]]) -> (Self, bool) {
        let mut top = 2 * ZERO_EXPONENT;
        for [a, b] in terms {
            let exponent = a.exponent + b.exponent;
            top = if exponent > top { exponent } else { top };
        }
        let (mut sum, mut is_cut) = (W::Wide::ZERO, false);
        for [a, b] in terms {
            if !(a.is_zero() || b.is_zero()) {
                let product = a.mantissa.product(b.mantissa);
                let (term, is_term_cut) =
                    term::<_, _, CHECK>(product, top, a.exponent + b.exponent, a.negative != b.negative);
                sum = sum.plus(term);
                is_cut |= is_term_cut;
            }
        }
        finished(sum, top, is_cut)
    }

    /// `self / divisor`, accurate to a few units in the last place; zero for a divisor of zero.
    #[inline(never)]
    pub(crate) fn quotient(&self, divisor: &Self) -> Self {
        if self.is_zero() || divisor.is_zero() {
            return Self::ZERO;
        }
        // Half of it is certainly less than the divisor.
        let quotient = (self.mantissa >> 1).quotient(divisor.mantissa);
        Self::shortened(quotient, self.exponent - divisor.exponent + 1, self.negative != divisor.negative)
    }

    /// The square root of the magnitude, accurate to a few units in the last place.
    #[inline(never)]
    pub(crate) fn root(&self) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        // m 2^(2 h) with m in [1/4, 1)
        let is_odd = self.exponent & 1 != 0;
        let mantissa = if is_odd { self.mantissa >> 1 } else { self.mantissa };
        Self::shortened(mantissa.root(), (self.exponent + is_odd as i32) >> 1, false)
    }

    /// The number with this mantissa, whose highest bit may be missing. It is rounded to a few bits fewer, so that a
    /// quotient or a root with few bits is exact, and a tie is a tie.
    #[inline(always)]
    fn shortened(mantissa: W, exponent: i32, negative: bool) -> Self {
        let zeros = mantissa.leading_zeros();
        let half = W::TOP >> (W::BITS - W::SPARE);
        match (mantissa << zeros).checked_plus(half) {
            Some(rounded) => {
                Self { mantissa: rounded >> W::SPARE << W::SPARE, exponent: exponent - zeros as i32, negative }
            }
            // All bits were ones: the rounding carries.
            None => Self { mantissa: W::TOP, exponent: exponent - zeros as i32 + 1, negative },
        }
    }
}

/// A product with this exponent, aligned for a sum whose terms are all less than `2^top`, and whether bits of it were
/// lost.
#[inline(always)]
fn term<V, D: Wide<V>, const CHECK: bool>(product: D, top: i32, exponent: i32, negative: bool) -> (D, bool) {
    let down = top.wrapping_sub(exponent) as u32 + HEADROOM;
    let shifted = product.shifted_right(down);
    let is_cut = CHECK && product.loses(down);
    (if negative { shifted.negated() } else { shifted }, is_cut)
}

/// The highest bits of a sum, and whether others were cut off.
#[inline(always)]
fn finished<W: Word>(sum: W::Wide, top: i32, is_cut: bool) -> (Limbs<W>, bool) {
    let negative = sum.is_negative();
    let magnitude = if negative { sum.negated() } else { sum };
    if magnitude.is_zero() {
        return (Limbs::ZERO, is_cut);
    }
    let (mantissa, zeros, is_rest_cut) = magnitude.normalized();
    (Limbs { mantissa, exponent: top + HEADROOM as i32 - zeros as i32, negative }, is_cut | is_rest_cut)
}
