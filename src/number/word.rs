//! Machine words as mantissas; their products, reciprocals and roots.

use core::fmt::Debug;

/// A mantissa.
pub trait Word: Copy + Ord + Debug + Send + Sync + 'static {
    /// An integer of twice as many bits, and a sign.
    type Wide: Wide<Self>;
    /// Its bits.
    const BITS: u32;
    /// No bit.
    const ZERO: Self;
    /// The highest bit.
    const TOP: Self;

    /// From 128 bits, the lowest of which may be lost.
    fn from_highest(bits: u128) -> Self;
    /// From its highest 64 bits.
    fn from_word(bits: u64) -> Self;
    /// As the highest of 128 bits.
    fn highest(self) -> u128;
    /// Shifted right by one.
    fn half(self) -> Self;
    /// Shifted left, by less than its bits.
    fn shifted_left(self, by: u32) -> Self;
    /// Zeros above the highest bit.
    fn leading_zeros(self) -> u32;
    /// Bits by which a quotient or a root is rounded.
    const SPARE: u32;
    /// Rounded by [`Word::SPARE`] bits; `None` if that carries.
    fn shortened(self) -> Option<Self>;
    /// `self * other`
    fn product(self, other: Self) -> Self::Wide;
    /// `self 2^BITS / divisor` but for some units, for a divisor with its highest bit that is larger.
    fn quotient(self, divisor: Self) -> Self;
    /// `sqrt(self 2^BITS)` but for some units, for a number with one of its two highest bits.
    fn root(self) -> Self;
}

/// A sum of products of words.
pub trait Wide<W>: Copy {
    /// Nothing.
    const ZERO: Self;
    /// `word * 2^BITS`
    fn from_high(word: W) -> Self;
    /// Shifted right without regard to a sign.
    fn shifted_right(self, by: u32) -> Self;
    /// True if a shift right loses a bit.
    fn loses(self, by: u32) -> bool;
    /// The sum.
    fn plus(self, other: Self) -> Self;
    /// The negative.
    fn negated(self) -> Self;
    /// True below zero.
    fn is_negative(self) -> bool;
    /// True at zero.
    fn is_zero(self) -> bool;
    /// The highest bits, how many zeros stand above them, and whether bits are below them; not for zero.
    fn normalized(self) -> (W, u32, bool);
}

impl Word for u64 {
    type Wide = u128;
    const BITS: u32 = 64;
    const SPARE: u32 = 3;
    const ZERO: Self = 0;
    const TOP: Self = 1 << 63;

    #[inline(always)]
    fn from_highest(bits: u128) -> Self {
        (bits >> 64) as Self
    }
    #[inline(always)]
    fn from_word(bits: u64) -> Self {
        bits
    }
    #[inline(always)]
    fn highest(self) -> u128 {
        (self as u128) << 64
    }
    #[inline(always)]
    fn half(self) -> Self {
        self >> 1
    }
    #[inline(always)]
    fn shifted_left(self, by: u32) -> Self {
        self << by
    }
    #[inline(always)]
    fn leading_zeros(self) -> u32 {
        Self::leading_zeros(self)
    }
    #[inline(always)]
    fn shortened(self) -> Option<Self> {
        self.checked_add(1 << (Self::SPARE - 1)).map(|rounded| rounded >> Self::SPARE << Self::SPARE)
    }
    #[inline(always)]
    fn product(self, other: Self) -> u128 {
        full_product(self, other)
    }

    /// By a reciprocal of 30 bits: each residual adds as many.
    #[inline]
    fn quotient(self, divisor: Self) -> Self {
        let reciprocal = reciprocal_of_normalized((divisor >> 32) as u32);
        // n 2^64 / d = n 2^32 / d', with 1 / d' = reciprocal / 2^63.
        let first = full_product(self, reciprocal as u64) >> 31;
        let first = if first >> 64 == 0 { first as u64 } else { Self::MAX };
        let residual = (self as u128).wrapping_shl(64).wrapping_sub(full_product(first, divisor)) as i128;
        // Below 2^99: its highest 64 bits, and the quotient of those.
        let step = |residual: i128| {
            let magnitude = (residual.unsigned_abs() >> 40) as u64;
            let quotient = (full_product(magnitude, reciprocal as u64) >> 55) as u64;
            if residual < 0 { quotient.wrapping_neg() } else { quotient }
        };
        let second = first.wrapping_add(step(residual));
        let residual = (self as u128).wrapping_shl(64).wrapping_sub(full_product(second, divisor)) as i128;
        second.wrapping_add(step(residual))
    }

    /// From a root of 32 bits, by `s + (n - s^2) / 2 s`.
    #[inline]
    fn root(self) -> Self {
        // It may be one less than the root, and then without its top bit.
        let high = root_of_normalized((self >> 32) as u32, self as u32).max(1 << 31);
        let reciprocal = reciprocal_of_normalized(high) as u64;
        let step = |root: u64| {
            let residual = self.highest().wrapping_sub(full_product(root, root)) as i128;
            let magnitude = (residual.unsigned_abs() >> 36) as u64;
            // 1 / 2 s = reciprocal / 2^96
            let step = (full_product(magnitude, reciprocal) >> 60) as u64;
            if residual < 0 { root.wrapping_sub(step) } else { root.saturating_add(step) }
        };
        step(step((high as u64) << 32))
    }
}

impl Wide<u64> for u128 {
    const ZERO: Self = 0;

    #[inline(always)]
    fn from_high(word: u64) -> Self {
        (word as Self) << 64
    }
    #[inline(always)]
    fn shifted_right(self, by: u32) -> Self {
        if by < 128 { self >> by } else { 0 }
    }
    #[inline(always)]
    fn loses(self, by: u32) -> bool {
        self != 0 && self.trailing_zeros() < by
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self.wrapping_add(other)
    }
    #[inline(always)]
    fn negated(self) -> Self {
        self.wrapping_neg()
    }
    #[inline(always)]
    fn is_negative(self) -> bool {
        (self as i128) < 0
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self == 0
    }
    #[inline(always)]
    fn normalized(self) -> (u64, u32, bool) {
        let zeros = self.leading_zeros();
        let normalized = self << zeros;
        ((normalized >> 64) as u64, zeros, normalized as u64 != 0)
    }
}

/// 256 bits.
#[derive(Clone, Copy, Debug)]
pub struct Double {
    high: u128,
    low: u128,
}

impl Word for u128 {
    type Wide = Double;
    const BITS: u32 = 128;
    const SPARE: u32 = 4;
    const ZERO: Self = 0;
    const TOP: Self = 1 << 127;

    #[inline(always)]
    fn from_highest(bits: u128) -> Self {
        bits
    }
    #[inline(always)]
    fn from_word(bits: u64) -> Self {
        (bits as Self) << 64
    }
    #[inline(always)]
    fn highest(self) -> u128 {
        self
    }
    #[inline(always)]
    fn half(self) -> Self {
        self >> 1
    }
    #[inline(always)]
    fn shifted_left(self, by: u32) -> Self {
        self << by
    }
    #[inline(always)]
    fn leading_zeros(self) -> u32 {
        Self::leading_zeros(self)
    }
    #[inline(always)]
    fn shortened(self) -> Option<Self> {
        self.checked_add(1 << (Self::SPARE - 1)).map(|rounded| rounded >> Self::SPARE << Self::SPARE)
    }

    #[inline(always)]
    fn product(self, other: Self) -> Double {
        let (a, b, c, d) = ((self >> 64) as u64, self as u64, (other >> 64) as u64, other as u64);
        // The lower words of stored numbers are often zero.
        if b == 0 && d == 0 {
            return Double { high: full_product(a, c), low: 0 };
        }
        let (low, high) = (full_product(b, d), full_product(a, c));
        let (middle, carry) = full_product(a, d).overflowing_add(full_product(b, c));
        let (low, is_over) = low.overflowing_add(middle << 64);
        let high = high + (middle >> 64) + ((carry as u128) << 64) + is_over as u128;
        Double { high, low }
    }

    /// By the quotient of the highest words, and residuals.
    #[inline]
    fn quotient(self, divisor: Self) -> Self {
        // 2^127 / d' of the divisor's highest word.
        let highest = (divisor >> 64) as u64;
        let reciprocal = u64::TOP.half().quotient(highest);
        let mut quotient = 0_u128;
        let mut residual = Double { high: self, low: 0 };
        for _ in 0..3 {
            let negative = residual.is_negative();
            let magnitude = if negative { residual.negated() } else { residual };
            // The residual's highest 64 bits, times the reciprocal.
            let (word, zeros, _) = if magnitude.is_zero() { (0, 0, false) } else { magnitude.normalized() };
            let step = full_product((word >> 64) as u64, reciprocal);
            // word 2^(192 - zeros) / d, d = d' 2^64, 1 / d' = reciprocal / 2^126
            let step = match zeros {
                0 | 1 if step >> (126 + zeros) != 0 => Self::MAX,
                0 | 1 => step << (2 - zeros),
                2..130 => step >> (zeros - 2),
                _ => 0,
            };
            quotient = if negative { quotient.wrapping_sub(step) } else { quotient.wrapping_add(step) };
            residual = Double { high: self, low: 0 }.plus(quotient.product(divisor).negated());
        }
        quotient
    }

    /// From a root of 64 bits, by `s + (n - s^2) / 2 s`.
    #[inline]
    fn root(self) -> Self {
        let high = ((self >> 64) as u64).root().max(u64::TOP);
        let reciprocal = u64::TOP.half().quotient(high);
        let mut root = (high as u128) << 64;
        for _ in 0..2 {
            let residual = Double { high: self, low: 0 }.plus(root.product(root).negated());
            let negative = residual.is_negative();
            let magnitude = if negative { residual.negated() } else { residual };
            let (word, zeros, _) = if magnitude.is_zero() { (0, 0, false) } else { magnitude.normalized() };
            let step = full_product((word >> 64) as u64, reciprocal);
            // As for a quotient by s, and half of it.
            let step = if (1..129).contains(&zeros) { step >> (zeros - 1) } else { 0 };
            root = if negative { root.wrapping_sub(step) } else { root.saturating_add(step) };
        }
        root
    }
}

impl Wide<u128> for Double {
    const ZERO: Self = Self { high: 0, low: 0 };

    #[inline(always)]
    fn from_high(word: u128) -> Self {
        Self { high: word, low: 0 }
    }
    #[inline(always)]
    fn shifted_right(self, by: u32) -> Self {
        let Self { high, low } = self;
        match by {
            0 => self,
            1..128 => Self { high: high >> by, low: low >> by | high << (128 - by) },
            128..256 => Self { high: 0, low: high >> (by - 128) },
            _ => Self::ZERO,
        }
    }
    #[inline(always)]
    fn loses(self, by: u32) -> bool {
        let zeros = if self.low == 0 { 128 + self.high.trailing_zeros() } else { self.low.trailing_zeros() };
        !self.is_zero() && zeros < by
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let (low, carry) = self.low.overflowing_add(other.low);
        Self { high: self.high.wrapping_add(other.high).wrapping_add(carry as u128), low }
    }
    #[inline(always)]
    fn negated(self) -> Self {
        let (low, carry) = (!self.low).overflowing_add(1);
        Self { high: (!self.high).wrapping_add(carry as u128), low }
    }
    #[inline(always)]
    fn is_negative(self) -> bool {
        (self.high as i128) < 0
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.high == 0 && self.low == 0
    }
    #[inline(always)]
    fn normalized(self) -> (u128, u32, bool) {
        let Self { high, low } = self;
        if high == 0 {
            let zeros = low.leading_zeros();
            return (low << zeros, zeros + 128, false);
        }
        let zeros = high.leading_zeros();
        if zeros == 0 {
            return (high, 0, low != 0);
        }
        (high << zeros | low >> (128 - zeros), zeros, low << zeros != 0)
    }
}

/// `a * b` in 128 bits.
#[cfg(target_pointer_width = "64")]
#[inline(always)]
pub(crate) fn full_product(a: u64, b: u64) -> u128 {
    a as u128 * b as u128
}

/// `a * b` in 128 bits, from products of 32 bits: compilers for these chips call a function for it.
#[cfg(not(target_pointer_width = "64"))]
#[inline(always)]
pub(crate) fn full_product(a: u64, b: u64) -> u128 {
    let (al, ah, bl, bh) = (a as u32, (a >> 32) as u32, b as u32, (b >> 32) as u32);
    let (low, high) = (product_unsigned(al, bl), product_unsigned(ah, bh));
    let middle = product_unsigned(al, bh) + (low >> 32);
    let (middle, carry) = middle.overflowing_add(product_unsigned(ah, bl));
    let low = (middle << 32) | (low as u32 as u64);
    let high = high + (middle >> 32) + ((carry as u64) << 32);
    (high as u128) << 64 | low as u128
}

/// `a * b` in 64 bits.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn product(a: i32, b: i32) -> i64 {
    a as i64 * b as i64
}

/// `a * b` in 64 bits, from products of 16 bits: ARMv6-M has no long multiplication, and the compiler calls a function for it
/// (Warren, *Hacker's Delight*, 8-2).
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(crate) fn product(a: i32, b: i32) -> i64 {
    let (al, ah, bl, bh) = (a & 0xffff, a >> 16, b & 0xffff, b >> 16);
    let low = al.wrapping_mul(bl) as u32;
    let first = ah.wrapping_mul(bl).wrapping_add((low >> 16) as i32);
    let second = al.wrapping_mul(bh).wrapping_add(first & 0xffff);
    let high = ah.wrapping_mul(bh).wrapping_add(first >> 16).wrapping_add(second >> 16);
    ((high as i64) << 32) | (a.wrapping_mul(b) as u32 as i64)
}

/// `a * b` of two unsigned numbers.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn product_unsigned(a: u32, b: u32) -> u64 {
    a as u64 * b as u64
}

/// `a * b` of two unsigned numbers, from products of 16 bits.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(crate) fn product_unsigned(a: u32, b: u32) -> u64 {
    ((high_product(a, b) as u64) << 32) | a.wrapping_mul(b) as u64
}

/// `a * a` for a number below 2^31 in magnitude.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn square(a: i32) -> i64 {
    a as i64 * a as i64
}

/// `a * a`, as [`product`], with one product less.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(crate) fn square(a: i32) -> i64 {
    let a = a.unsigned_abs();
    let (low, high) = (a & 0xffff, a >> 16);
    let middle = low * high;
    let upper = high * high + (middle >> 15);
    let (lower, carry) = (low * low).overflowing_add(middle << 17);
    (((upper + carry as u32) as i64) << 32) | lower as i64
}

/// The high word of the product of two unsigned numbers.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn high_product(a: u32, b: u32) -> u32 {
    ((a as u64 * b as u64) >> 32) as u32
}

/// The high word of the product of two unsigned numbers, from products of 16 bits.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(crate) fn high_product(a: u32, b: u32) -> u32 {
    let (al, ah, bl, bh) = (a & 0xffff, a >> 16, b & 0xffff, b >> 16);
    let first = ah * bl + ((al * bl) >> 16);
    let second = al * bh + (first & 0xffff);
    ah * bh + (first >> 16) + (second >> 16)
}

/// `2^12 / sqrt(n + 1/2)` less 2^8, rounded down, for the top byte `n` of a number with one of its two top bits set.
const RECIPROCAL_ROOT: [u8; 256] = {
    let mut table = [0; 256];
    let mut n = 64;
    while n < 256 {
        // The largest y with y^2 (2n + 1) <= 2^25.
        let mut y: u32 = 256;
        while (y + 1) * (y + 1) * (2 * n as u32 + 1) <= 1 << 25 {
            y += 1;
        }
        table[n] = (y - 256) as u8;
        n += 1;
    }
    table
};

/// `2^16 / (n + 1/2)` less 2^8, rounded to nearest, for the top byte `n` of a number with its top bit set.
const RECIPROCAL: [u8; 256] = {
    let mut table = [0; 256];
    let mut n = 128;
    while n < 256 {
        table[n] = (((1 << 18) / (2 * n as u32 + 1)).div_ceil(2) - 256) as u8;
        n += 1;
    }
    table
};

/// `1 / sqrt(m)` in units of 2^-16, to 14 bits and never more, for `m = high / 2^32` in [1/4, 1): by a table for 8 bits and a Newton
/// step.
#[inline(always)]
pub(crate) fn reciprocal_root(high: u32) -> u32 {
    // y = 1 / sqrt(m) in (1, 2], in units of 2^-8
    let y = 256 + RECIPROCAL_ROOT[(high >> 24) as usize] as u32;
    // 1 - m y^2 in units of 2^-32, below 2^-6 in magnitude: the product wraps around one.
    let lack = (high >> 16).wrapping_mul(y * y).wrapping_neg() as i32;
    // y (1 + lack / 2)
    ((y << 8) as i32).wrapping_add((y as i32).wrapping_mul(lack >> 10) >> 15) as u32
}

/// The square root of `high * 2^32 + low`, which must have one of its two top bits set: rounded down, or one less.
///
/// A reciprocal root of 14 bits, then the root by two steps with that: remainder over twice the root (Markstein, *IA-64 and
/// Elementary Functions*, 2000, chapter 8, here in integers). Multiplications only.
#[inline]
pub(crate) fn root_of_normalized(high: u32, low: u32) -> u32 {
    // m = high / 2^32
    let y = reciprocal_root(high);
    // sqrt(m) = m y, in units of 2^-16; never more than it, since m is rounded down, and so is y.
    let root = (high >> 16).wrapping_mul(y >> 1) >> 15;
    // (m - root^2) / (2 root), in units of 2^-32. The step can go too far by a few: 32 less is surely too little.
    let rest = (high.wrapping_sub(root * root) << 11) | (low >> 21);
    let step = (high_product(rest, y) << 4) | (rest.wrapping_mul(y) >> 28);
    let root = ((root << 16) + step).wrapping_sub(32);
    // Once more, for the last bits.
    let (below, borrow) = low.overflowing_sub(root.wrapping_mul(root));
    let above = high.wrapping_sub(high_product(root, root)).wrapping_sub(borrow as u32);
    let rest = (above << 11) | (below >> 21);
    root.saturating_add(rest.wrapping_mul(y >> 4) >> 24)
}

/// `2^63 / n` for a number with its top bit set, rounded down, or one less: by a table and three Newton steps.
#[inline]
pub(crate) fn reciprocal_of_normalized(n: u32) -> u32 {
    // m = n / 2^32 in [1/2, 1); y = 1 / m in (1, 2], in units of 2^-8
    let y = 256 + RECIPROCAL[(n >> 24) as usize] as u32;
    // 1 - m y in units of 2^-32, below 2^-8 in magnitude: the product wraps around one.
    let lack = (n >> 8).wrapping_mul(y).wrapping_neg() as i32;
    let y = (y << 8).wrapping_add(((y as i32).wrapping_mul(lack >> 8) >> 16) as u32);
    // 1 - m y in units of 2^-40
    let lack = (((high_product(n, y) << 24) | (n.wrapping_mul(y) >> 8)) as i32).wrapping_neg();
    // The step can go a little too far: 8 less is surely too little.
    let y = (y << 15).wrapping_add((product(lack, y as i32) >> 25) as u32).wrapping_sub(8);
    // Once more, for the last bits: 2^63 - n y, a few units of 2^32, in units of 2^24
    let lack = ((1_u32 << 31).wrapping_sub(high_product(n, y)) << 8).wrapping_sub(n.wrapping_mul(y) >> 24);
    y.saturating_add(lack.wrapping_mul(y >> 16) >> 23)
}

/// The high word of the product of two numbers.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn high_product_signed(a: i32, b: i32) -> i32 {
    ((a as i64 * b as i64) >> 32) as i32
}

/// The high word of the product of two numbers, from products of 16 bits.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(crate) fn high_product_signed(a: i32, b: i32) -> i32 {
    let (al, ah, bl, bh) = (a & 0xffff, a >> 16, b & 0xffff, b >> 16);
    let low = al.wrapping_mul(bl) as u32;
    let first = ah.wrapping_mul(bl).wrapping_add((low >> 16) as i32);
    let second = al.wrapping_mul(bh).wrapping_add(first & 0xffff);
    ah.wrapping_mul(bh).wrapping_add(first >> 16).wrapping_add(second >> 16)
}

/// The leading zeros of a number that is not zero.
#[cfg(not(any(all(target_arch = "arm", not(target_has_atomic = "32")), target_arch = "riscv32")))]
#[inline(always)]
pub(crate) fn leading_zeros(n: u32) -> u32 {
    n.leading_zeros()
}

/// The leading zeros of a number that is not zero, by halves: these chips have no instruction for it, and the compiler counts
/// bits one way or the other with twice as many.
#[cfg(any(all(target_arch = "arm", not(target_has_atomic = "32")), target_arch = "riscv32"))]
#[inline(always)]
pub(crate) fn leading_zeros(mut n: u32) -> u32 {
    let mut zeros = 0;
    if n < 1 << 16 {
        n <<= 16;
        zeros = 16;
    }
    if n < 1 << 24 {
        n <<= 8;
        zeros += 8;
    }
    if n < 1 << 28 {
        n <<= 4;
        zeros += 4;
    }
    // Those of four bits, two bits each.
    zeros + ((0x55af_u32 >> (2 * (n >> 28))) & 3)
}
