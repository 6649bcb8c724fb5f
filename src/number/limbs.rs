//! Floating-point numbers of `64 N` bits, made of integers: the same bits on every machine.
//!
//! A number is a sign, a mantissa of `N` words whose top bit is set, and an exponent of 32 bits, so that nothing overflows or
//! underflows in a solver. Results are cut off towards zero, which keeps mirrored rays mirrored: an operation is off by less than
//! one unit of its last place. The operation that everything else is made of is a *sum of products*: products are held in full,
//! added in `128 N` bits, and cut off once (as the "long accumulator" of Kulisch, *Advanced Arithmetic for the Digital Computer*,
//! 2002, but of one width). Where products cancel, the sum keeps the bits that are left.

use super::word::{full_product, reciprocal_of_normalized, root_of_normalized};

/// `(-1)^negative * 0.words * 2^exponent`. Zero has no bit set and [`ZERO_EXPONENT`].
#[derive(Clone, Copy, Debug)]
pub struct Limbs<const N: usize> {
    /// From the lowest to the highest.
    words: [u64; N],
    exponent: i32,
    negative: bool,
}

/// Below the exponent of any number of the solvers, and far from the end of its type.
const ZERO_EXPONENT: i32 = -(1 << 28);

/// Bits that the starting value of a quotient or a root is good to.
const SEED_BITS: u32 = 28;

impl<const N: usize> Limbs<N> {
    pub(crate) const BITS: i32 = 64 * N as i32;
    pub(crate) const ZERO: Self = Self { words: [0; N], exponent: ZERO_EXPONENT, negative: false };
    pub(crate) const ONE: Self = Self::from_mantissa(1, 0, false);

    /// `(-1)^negative * mantissa * 2^exponent`, exactly.
    #[inline]
    pub(crate) const fn from_mantissa(mantissa: u64, exponent: i32, negative: bool) -> Self {
        if mantissa == 0 {
            return Self::ZERO;
        }
        let zeros = mantissa.leading_zeros();
        let mut words = [0; N];
        words[N - 1] = mantissa << zeros;
        Self { words, exponent: exponent + 64 - zeros as i32, negative }
    }

    /// From words of which the highest may be zero, the lowest first: their highest `64 N` bits, and whether others were lost.
    /// The words are an integer times `2^exponent`.
    pub(crate) fn from_words(words: &[u32], exponent: i32, negative: bool) -> (Self, bool) {
        let Some(top) = words.iter().rposition(|word| *word != 0) else {
            return (Self::ZERO, false);
        };
        let word = |index: i32| usize::try_from(index).ok().and_then(|index| words.get(index)).copied().unwrap_or(0);
        let top = top as i32;
        let zeros = word(top).leading_zeros();
        // The 64 bits that start `below` bits under the top one.
        let bits = |below: i32| {
            let highest = top - below / 32;
            let three =
                ((word(highest) as u128) << 64) | ((word(highest - 1) as u128) << 32) | word(highest - 2) as u128;
            ((three << zeros) >> 32) as u64
        };
        let mut limbs = [0; N];
        let mut below = 0;
        for limb in limbs.iter_mut().rev() {
            *limb = bits(below);
            below += 64;
        }
        let used = 32 * (top + 1) - zeros as i32;
        let lowest = words.iter().position(|word| *word != 0).unwrap_or(0) as i32;
        let trailing = 32 * lowest + word(lowest).trailing_zeros() as i32;
        let number = Self { words: limbs, exponent: exponent.saturating_add(used), negative };
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

    /// The exponent of a power of two above the magnitude, of which the half is not above it.
    #[inline(always)]
    pub(crate) const fn top(&self) -> i32 {
        self.exponent
    }

    /// The highest 64 bits of the magnitude: it is at least that integer times `2^(top - 64)`.
    #[inline(always)]
    pub(crate) fn leading(&self) -> u64 {
        self.words[N - 1]
    }

    /// The magnitude as an integer of the unit `2^unit`, rounded to nearest, ties to even; `None` if that takes more than 64 bits.
    #[inline]
    pub(crate) fn to_units(self, unit: i32) -> Option<u64> {
        let bits = self.exponent.saturating_sub(unit);
        if bits > 64 {
            return None;
        }
        if bits < 0 {
            return Some(0);
        }
        let leading = self.leading();
        let (whole, fraction) = match bits {
            0 => (0, leading),
            64 => (leading, 0),
            _ => (leading >> (64 - bits), leading << bits),
        };
        let (next, rest) = match bits {
            64 if N > 1 => (self.words[N - 2], self.words[..N - 2].iter().any(|word| *word != 0)),
            64 => (0, false),
            _ => (fraction, self.words[..N - 1].iter().any(|word| *word != 0)),
        };
        let half = 1 << 63;
        let is_up = next > half || next == half && (rest || whole & 1 != 0);
        whole.checked_add(is_up as u64)
    }

    #[inline(always)]
    pub(crate) fn negated(self) -> Self {
        Self { negative: !self.negative, ..self }
    }

    #[inline(always)]
    pub(crate) fn magnitude(self) -> Self {
        Self { negative: false, ..self }
    }

    /// `self * 2^e`
    #[inline(always)]
    pub(crate) fn scaled(self, e: i32) -> Self {
        if self.is_zero() { self } else { Self { exponent: self.exponent + e, ..self } }
    }

    /// How the magnitude compares with another.
    #[inline]
    pub(crate) fn compare_magnitude(&self, other: &Self) -> core::cmp::Ordering {
        let mut order = self.exponent.cmp(&other.exponent);
        for (own, other) in self.words.iter().zip(&other.words).rev() {
            order = order.then(own.cmp(other));
        }
        order
    }

    /// The product, and whether bits of it were cut off.
    #[inline]
    pub(crate) fn product(&self, other: &Self) -> (Self, bool) {
        if self.is_zero() || other.is_zero() {
            return (Self::ZERO, false);
        }
        let words = product(&self.words, &other.words);
        let sum = Sum { words, above: 0, top: self.exponent + other.exponent, is_cut: false };
        sum.normalized(self.negative != other.negative)
    }

    /// The sum of two numbers, and whether bits of it were cut off.
    #[inline(never)]
    pub(crate) fn total(&self, other: &Self) -> (Self, bool) {
        if self.is_zero() {
            return (*other, false);
        }
        if other.is_zero() {
            return (*self, false);
        }
        let mut sum = Sum::new(self.exponent.max(other.exponent));
        for term in [self, other] {
            let mut words = [[0; 2]; N];
            for (word, own) in words.as_flattened_mut().iter_mut().skip(N).zip(term.words) {
                *word = own;
            }
            sum.add(words, term.exponent, term.negative);
        }
        sum.finished()
    }

    /// The sum of products, and whether bits of it were cut off.
    #[inline(never)]
    pub(crate) fn sum_of_products(terms: &[[Self; 2]]) -> (Self, bool) {
        let top = |[a, b]: &[Self; 2]| a.exponent + b.exponent;
        let mut sum = Sum::new(terms.iter().map(top).max().unwrap_or(ZERO_EXPONENT));
        for term in terms {
            let [a, b] = term;
            if !(a.is_zero() || b.is_zero()) {
                sum.add(product(&a.words, &b.words), top(term), a.negative != b.negative);
            }
        }
        sum.finished()
    }

    /// `self / divisor` to the last places; the divisor must not be zero.
    ///
    /// From a reciprocal `x` of [`SEED_BITS`] the quotient is made by residuals, `q + (n - q d) x`, each of which adds as many bits.
    #[inline(never)]
    pub(crate) fn quotient(&self, divisor: &Self) -> Self {
        if self.is_zero() || divisor.is_zero() {
            return Self::ZERO;
        }
        let seed = reciprocal_of_normalized((divisor.leading() >> 32) as u32);
        let x = Self::from_mantissa(seed as u64, -31 - divisor.exponent, divisor.negative);
        let (mut q, _) = self.product(&x);
        for _ in 0..Self::steps() {
            let (residual, _) = Self::sum_of_products(&[[*self, Self::ONE], [q.negated(), *divisor]]);
            (q, _) = Self::sum_of_products(&[[q, Self::ONE], [residual, x]]);
        }
        q.shortened()
    }

    /// The square root of the magnitude to the last places.
    ///
    /// From `y = 1 / sqrt(n)` of [`SEED_BITS`] the root is made by residuals, `s + (n - s^2) y / 2`.
    #[inline(never)]
    pub(crate) fn square_root(&self) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        // n = m 2^(2 h) with m in [1/4, 1)
        let is_odd = self.exponent & 1 != 0;
        let h = (self.exponent + is_odd as i32) >> 1;
        let m = if is_odd { self.leading() >> 1 } else { self.leading() };
        // It may be one less than the root, and then without its top bit.
        let root = root_of_normalized((m >> 32) as u32, m as u32).max(1 << 31);
        let y = Self::from_mantissa(reciprocal_of_normalized(root) as u64, -32 - h, false);
        let n = self.magnitude();
        let mut s = Self::from_mantissa(root as u64, h - 32, false);
        for _ in 0..Self::steps() {
            let (residual, _) = Self::sum_of_products(&[[n, Self::ONE], [s.negated(), s]]);
            (s, _) = Self::sum_of_products(&[[s, Self::ONE], [residual, y]]);
        }
        s.shortened()
    }

    /// Rounded to three bits less, so that a quotient or a root with few bits comes out as it is, and a tie as a tie.
    fn shortened(mut self) -> Self {
        let mut carry = 4;
        for word in &mut self.words {
            let (sum, is_over) = word.overflowing_add(carry);
            *word = sum;
            carry = is_over as u64;
        }
        self.words[0] &= !7;
        if carry != 0 {
            // All bits were ones.
            self.words[N - 1] = 1 << 63;
            self.exponent += 1;
        }
        self
    }

    /// Residuals until all bits are good.
    const fn steps() -> u32 {
        (64 * N as u32).div_ceil(SEED_BITS) - 1
    }
}

/// The product in full.
#[inline(always)]
fn product<const N: usize>(a: &[u64; N], b: &[u64; N]) -> [[u64; 2]; N] {
    let mut result = [[0; 2]; N];
    if N == 1 {
        let product = full_product(a[0], b[0]);
        result[0] = [product as u64, (product >> 64) as u64];
        return result;
    }
    let words = result.as_flattened_mut();
    for (i, a) in a.iter().enumerate() {
        // The lower words of stored numbers are often zero.
        if *a == 0 {
            continue;
        }
        let mut carry = 0;
        let (_, place) = words.split_at_mut(i);
        let mut place = place.iter_mut();
        // In this order: a pair that is not complete must not take a place.
        for (b, word) in b.iter().zip(place.by_ref()) {
            let sum = full_product(*a, *b) + *word as u128 + carry as u128;
            *word = sum as u64;
            carry = (sum >> 64) as u64;
        }
        if let Some(word) = place.next() {
            *word = carry;
        }
    }
    result
}

/// A sum in the making: `(above, words) * 2^(top - 128 N)` in two's complement.
struct Sum<const N: usize> {
    words: [[u64; 2]; N],
    above: i64,
    top: i32,
    is_cut: bool,
}

impl<const N: usize> Sum<N> {
    #[inline(always)]
    fn new(top: i32) -> Self {
        Self { words: [[0; 2]; N], above: 0, top, is_cut: false }
    }

    /// Adds a product of this exponent, cut off where the sum ends.
    #[inline(always)]
    fn add(&mut self, term: [[u64; 2]; N], exponent: i32, negative: bool) {
        let down = self.top.wrapping_sub(exponent) as u32;
        let (term, is_cut) = shifted_right(term, down);
        self.is_cut |= is_cut;
        let flip = if negative { u64::MAX } else { 0 };
        if N == 1 {
            let ([low, high], [a, b]) = (self.words[0], term[0]);
            let (own, term) = ((high as u128) << 64 | low as u128, (b as u128) << 64 | a as u128);
            let (sum, carry) = if negative { own.overflowing_sub(term) } else { own.overflowing_add(term) };
            self.words[0] = [sum as u64, (sum >> 64) as u64];
            self.above += if negative { -(carry as i64) } else { carry as i64 };
            return;
        }
        let mut carry = negative;
        for (own, term) in self.words.as_flattened_mut().iter_mut().zip(term.as_flattened()) {
            let (sum, first) = own.overflowing_add(*term ^ flip);
            let (sum, second) = sum.overflowing_add(carry as u64);
            (*own, carry) = (sum, first | second);
        }
        self.above += carry as i64 - negative as i64;
    }

    /// The sum as a number, and whether bits of it were cut off.
    #[inline(always)]
    fn finished(mut self) -> (Limbs<N>, bool) {
        let negative = self.above < 0;
        if negative {
            let mut carry = true;
            for word in self.words.as_flattened_mut() {
                (*word, carry) = (!*word).overflowing_add(carry as u64);
            }
            self.above = !self.above + carry as i64;
        }
        self.normalized(negative)
    }

    /// The highest bits of a sum that is not negative, with this sign.
    #[inline(always)]
    fn normalized(self, negative: bool) -> (Limbs<N>, bool) {
        let Self { words, above, mut top, mut is_cut } = self;
        let mut words = words;
        if above != 0 {
            // At most as many bits as the number of terms has.
            let up = 64 - above.leading_zeros();
            let (lower, is_lost) = shifted_right(words, up);
            words = lower;
            words[N - 1][1] |= (above as u64) << (64 - up);
            is_cut |= is_lost;
            top += up as i32;
        } else {
            // Whole words first.
            let mut zeros = 0;
            for word in words.as_flattened().iter().rev() {
                if *word != 0 {
                    break;
                }
                zeros += 1;
            }
            if zeros == 2 * N as i32 {
                return (Limbs::ZERO, is_cut);
            }
            let zeros = 64 * zeros as u32;
            let words_up = shifted_left_by_words(words, zeros / 64);
            let bits = words_up[N - 1][1].leading_zeros();
            words = shifted_left_by_bits(words_up, bits);
            top -= (zeros + bits) as i32;
        }
        let mut limbs = [0; N];
        let flat = words.as_flattened();
        for (limb, word) in limbs.iter_mut().zip(flat.iter().skip(N)) {
            *limb = *word;
        }
        is_cut |= flat.iter().take(N).any(|word| *word != 0);
        (Limbs { words: limbs, exponent: top, negative }, is_cut)
    }
}

/// Shifted right by any number of bits, and whether bits were lost.
#[inline(always)]
fn shifted_right<const N: usize>(words: [[u64; 2]; N], by: u32) -> ([[u64; 2]; N], bool) {
    if by == 0 {
        return (words, false);
    }
    let mut result = [[0; 2]; N];
    if by >= 128 * N as u32 {
        return (result, true);
    }
    if N == 1 {
        let [low, high] = words[0];
        let all = (high as u128) << 64 | low as u128;
        let shifted = all >> by;
        result[0] = [shifted as u64, (shifted >> 64) as u64];
        return (result, shifted << by != all);
    }
    let (whole, bits) = ((by / 64) as usize, by % 64);
    let flat = words.as_flattened();
    let mut is_cut = flat.iter().take(whole).any(|word| *word != 0);
    let mut source = flat.iter().skip(whole);
    let mut current = source.next().copied().unwrap_or(0);
    is_cut |= bits != 0 && current << (64 - bits) % 64 != 0;
    for target in result.as_flattened_mut() {
        let next = source.next().copied().unwrap_or(0);
        *target = if bits == 0 { current } else { current >> bits | next << (64 - bits) };
        current = next;
    }
    (result, is_cut)
}

#[inline(always)]
fn shifted_left_by_words<const N: usize>(words: [[u64; 2]; N], by: u32) -> [[u64; 2]; N] {
    let mut result = [[0; 2]; N];
    for (target, source) in result.as_flattened_mut().iter_mut().skip(by as usize).zip(words.as_flattened()) {
        *target = *source;
    }
    result
}

/// Shifted left by less than a word.
#[inline(always)]
fn shifted_left_by_bits<const N: usize>(mut words: [[u64; 2]; N], by: u32) -> [[u64; 2]; N] {
    if by == 0 {
        return words;
    }
    let mut below = 0;
    for word in words.as_flattened_mut() {
        (*word, below) = (*word << by | below, *word >> (64 - by));
    }
    words
}
