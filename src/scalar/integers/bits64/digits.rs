//! Numbers of 64 and 128 bits as digits of 32 bits.
//!
//! A number is multiplied as two [`Digits`] of 32 bits, both signed, so that the four products of two numbers need no
//! correction, and sums of products add each of the four kinds in 64 bits before any carry.
//!
//! Sums of 128 bits are a few additions with carry on any chip; products and shifts of 128 bits would be calls of
//! functions.

use crate::number::machine::{high_product, leading_zeros, product, product_unsigned, reciprocal_root};

/// `high * 2^32 + low`, with a low digit of either sign.
#[derive(Clone, Copy)]
pub(super) struct Digits {
    pub(super) high: i32,
    pub(super) low: i32,
}

impl Digits {
    /// The digits of a number of at most little more than 2^62 in magnitude.
    #[inline(always)]
    pub(super) const fn new(n: i64) -> Self {
        // The low word as a signed number is 2^32 less if its top bit is set.
        Self { high: (n >> 32) as i32 + (n as u32 >> 31) as i32, low: n as i32 }
    }

    /// The parts of the product that are multiples of 2^32.
    #[inline(always)]
    pub(super) fn middle(self, other: Self) -> i64 {
        product(self.high, other.low) + product(self.low, other.high)
    }
}

/// `high * 2^64 + middle * 2^32 + low`
#[inline(always)]
pub(super) const fn carried(high: i64, middle: i64, low: i128) -> i128 {
    ((high as i128) << 64) + ((middle as i128) << 32) + low
}

/// The bits of the upper word of a number's magnitude.
#[inline(always)]
pub(super) const fn upper_bits(n: i64) -> u32 {
    let high = (n >> 32) as i32;
    (high ^ (high >> 31)) as u32
}

/// The upper half.
#[inline(always)]
pub(super) const fn high(n: i128) -> i64 {
    (n >> 64) as i64
}

/// The two words.
#[inline(always)]
pub(super) const fn words(n: u64) -> [u32; 2] {
    [n as u32, (n >> 32) as u32]
}

/// The number of these words.
#[inline(always)]
pub(super) const fn joined([low, high]: [u32; 2]) -> u64 {
    ((high as u64) << 32) | low as u64
}

/// `high * 2^by + low / 2^(32 - by)` for `by` below 32.
#[inline(always)]
pub(super) const fn moved_up(high: u32, low: u32, by: u32) -> u32 {
    (high << (by & 0x1f)) | (low >> 1 >> (!by & 0x1f))
}

/// `low / 2^by + high * 2^(32 - by)` for `by` below 32.
#[inline(always)]
pub(super) const fn moved_down(high: u32, low: u32, by: u32) -> u32 {
    (low >> (by & 0x1f)) | (high << 1 << (!by & 0x1f))
}

/// `n * 2^by` for `by` below 64.
#[inline(always)]
pub(super) const fn up(n: i64, by: u32) -> i64 {
    let [low, high] = words(n as u64);
    let lower = low << (by & 0x1f);
    (if by & 32 == 0 { joined([lower, moved_up(high, low, by)]) } else { joined([0, lower]) }) as i64
}

/// `n / 2^by` for `by` below 64, rounded down.
#[inline(always)]
pub(super) const fn down(n: i64, by: u32) -> i64 {
    let [low, high] = words(n as u64);
    let upper = (high as i32) >> (by & 0x1f);
    if by & 32 == 0 { joined([moved_down(high, low, by), upper as u32]) as i64 } else { upper as i64 }
}

/// `n / 2^by` for `by` below 64, rounded down; it must be below 2^64.
#[inline(always)]
pub(super) const fn down_to_64(n: u128, by: u32) -> u64 {
    let ([a, b], [c, d]) = (words(n as u64), words((n >> 64) as u64));
    let [low, middle, high] = if by & 32 == 0 { [a, b, c] } else { [b, c, d] };
    joined([moved_down(middle, low, by), moved_down(high, middle, by)])
}

/// `n * 2^by` for `by` below 64.
#[inline(always)]
pub(super) const fn up_to_128(n: u64, by: u32) -> u128 {
    let [low, high] = words(n);
    let [low, middle, high] = [low << (by & 0x1f), moved_up(high, low, by), moved_up(0, high, by)];
    if by & 32 == 0 {
        ((high as u128) << 64) | joined([low, middle]) as u128
    } else {
        (joined([middle, high]) as u128) << 64 | ((low as u128) << 32)
    }
}

/// `n / 2^by` for `by` below 32 and a number of at least zero, rounded down.
#[inline(always)]
pub(super) const fn down_by_few(n: i128, by: u32) -> i128 {
    let ([a, b], [c, d]) = (words(n as u64), words(high(n) as u64));
    let low = joined([moved_down(b, a, by), moved_down(c, b, by)]);
    let high = joined([moved_down(d, c, by), d >> (by & 0x1f)]);
    ((high as i128) << 64) | low as i128
}

/// `n * 2^-SHIFT` rounded to nearest, ties to even, as that of the grid.
#[inline(always)]
pub(super) const fn round_off<const SHIFT: u32>(n: i128) -> i64 {
    let odd = (n >> SHIFT) & 1;
    ((n + ((1 << (SHIFT - 1)) - 1) + odd) >> SHIFT) as i64
}

/// The square root of `(high * 2^32 + low) * 2^64`, which must have one of its two top bits set; to within 64.
///
/// A step of the third order leads from 14 bits of the reciprocal root to 29, and one of Markstein's steps from there
/// to the root, as in [`root_of_normalized`](super::root_of_normalized) for half the length.
#[inline]
pub(super) fn root_of_normalized(high: u32, low: u32) -> u64 {
    // y = 1 / sqrt(m), in units of 2^-15
    let y = reciprocal_root(high) >> 1;
    // 1 - m y^2 in units of 2^-43, below 2^-12 in magnitude: the product wraps around one.
    let lack = ((product_unsigned(high, y * y) >> 19) as u32).wrapping_neg() as i32;
    // y (1 + lack / 2 + 3 lack^2 / 8) in units of 2^-31; a little too small, so that it stays below 2.
    let short = lack >> 16;
    let step = lack.wrapping_add(((3 * (short * short) as u32) >> 13) as i32);
    let y = (y << 16).wrapping_add((product(y as i32, step) >> 28) as u32).wrapping_sub(1);
    // sqrt(m) = m y, in units of 2^-32; never larger than the root.
    let root = (product_unsigned(high, y) >> 31) as u32;
    // (m - root^2) / (2 root): the remainder has a few bits more than a word.
    let [rest, above] = words(joined([low, high]).wrapping_sub(product_unsigned(root, root)));
    let step = high_product(rest, y) as u64 + product_unsigned(above, y);
    joined([0, root]).saturating_add(step)
}

/// The square root of a number of at least 2^64 and below 2^126, rounded down, with a relative error of at most 2^-57.
#[inline(always)]
pub(super) fn root(n: i128) -> u64 {
    let ([a, b], [c, d]) = (words(n as u64), words(high(n) as u64));
    let ([low, middle, high], less) = if d != 0 { ([b, c, d], 0) } else { ([a, b, c], 16) };
    let more = leading_zeros(high | 1) & 0x1e;
    let root = root_of_normalized(moved_up(high, middle, more), moved_up(middle, low, more));
    let ([low, high], less) = (words(root), less + more / 2);
    joined([moved_down(high, low, less), high >> less])
}
