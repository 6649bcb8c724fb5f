//! Lengths of 32 bits, and their products of 64 bits.

mod placed;
mod quotient;
mod stretched;

use super::length::{Length, Product};
use super::round_off;
use crate::number::machine::{
    high_product_signed, leading_zeros, leading_zeros_of_64, product, root_of_normalized, square,
};

impl Product for i64 {
    const ZERO: Self = 0;
    const ONE: Self = 1;

    #[inline(always)]
    fn magnitude(self) -> Self {
        self.unsigned_abs() as Self
    }
    #[inline(always)]
    fn zeros(self) -> u32 {
        self.leading_zeros()
    }
    #[inline(always)]
    fn lowest(self, bits: u32) -> Self {
        self & ((1 << bits) - 1)
    }
}

/// The high word.
#[inline(always)]
const fn high(n: i64) -> i32 {
    (n >> 32) as i32
}

/// The bits of a number's magnitude, or, for a negative number, those of the magnitude less one.
#[inline(always)]
const fn magnitude_bits(n: i32) -> u32 {
    (n ^ (n >> 31)) as u32
}

/// The square root of a number of at least 2^32 and below 2^62, to within one.
#[inline(always)]
fn root(n: u64) -> u32 {
    let (high, low) = ((n >> 32) as u32, n as u32);
    // An even shift: 2, and up to 28 further bits.
    let more = leading_zeros(high).wrapping_sub(2) & 0x1e;
    let root = root_of_normalized((high << more << 2) | (low >> (30 - more)), low << more << 2);
    ((root >> (more / 2)) + 1) >> 1
}

/// The number, or the largest raw value, which stands for infinity.
#[inline(always)]
fn within_type(t: i64) -> i32 {
    if t >= i32::MAX as i64 {
        i32::MAX
    } else if t <= -(i32::MAX as i64) {
        -i32::MAX
    } else {
        t as i32
    }
}

impl Length for i32 {
    type Product = i64;
    type Normalized = quotient::Normalized;
    /// In units of 2^-48, for directions whose length is 1 within 2^-20: its square is negligible.
    type Excess = i32;

    const BITS: u32 = 32;
    const CONE_BITS: u32 = 24;
    const FINER: i32 = 6;
    const GUARDS_APPROACH: bool = false;
    const MOMENT_BITS: u32 = 2;
    const NORMAL: (u32, u32) = (3, 31);
    const ZERO: Self = 0;
    const MAX: Self = Self::MAX;

    #[inline(always)]
    fn top(self) -> u32 {
        magnitude_bits(self)
    }
    #[inline(always)]
    fn zeros<const M: usize>(lengths: [Self; M]) -> u32 {
        leading_zeros(lengths.into_iter().fold(1, |all, length| all | magnitude_bits(length)))
    }
    #[inline(always)]
    fn up(self, by: u32) -> Self {
        self << (by & 0x1f)
    }
    #[inline(always)]
    fn down(self, by: u32) -> Self {
        self >> (by & 0x1f)
    }
    #[inline(always)]
    fn at_unit(self) -> i64 {
        (self as i64) << Self::FRACTION
    }
    #[inline(always)]
    fn raised(self, by: u32) -> i64 {
        ((self >> ((32 - by) & 0x1f)) as i64) << 32 | (self << (by & 0x1f)) as u32 as i64
    }
    #[inline(always)]
    fn checked_plus(self, other: Self) -> Option<Self> {
        self.checked_add(other)
    }
    #[inline(always)]
    fn saturating_plus(self, other: Self) -> Self {
        self.saturating_add(other)
    }
    #[inline(always)]
    fn apart(self, other: Self) -> Self {
        self.wrapping_sub(other)
    }
    #[inline(always)]
    fn are_within(self, other: Self, bits: u32) -> bool {
        self.abs_diff(other) >> bits == 0
    }

    #[inline(always)]
    fn have_room(_: [Self; 3]) -> bool {
        true
    }
    #[inline(always)]
    fn have_products([x, y, z]: [Self; 3]) -> bool {
        (magnitude_bits(x) | magnitude_bits(y) | magnitude_bits(z)) >> 30 == 0
    }
    #[inline(always)]
    fn refined(self, extra_bits: i32) -> Option<Self> {
        let refined = self << (extra_bits & 0x1f);
        (refined >> (extra_bits & 0x1f) == self && magnitude_bits(refined) >> 30 == 0).then_some(refined)
    }
    #[inline(always)]
    fn refined_beside(self, o: Self, extra_bits: i32) -> Option<Self> {
        let refined = self << (extra_bits & 0x1f);
        let fits = (magnitude_bits(o) | refined as u32) >> 30 == 0;
        (refined >> (extra_bits & 0x1f) == self && fits).then_some(refined)
    }
    #[inline(always)]
    fn refined_time(self, extra_bits: i32) -> Option<Self> {
        let refined = self << (extra_bits & 0x1f);
        (refined >> (extra_bits & 0x1f) == self).then_some(refined)
    }
    #[inline(always)]
    fn seen_from<const M: usize>(
        points: [[Self; 3]; M],
        o: [Self; 3],
        extra_bits: i32,
    ) -> Option<([[Self; 3]; M], u32)> {
        let mut all = 1;
        let mut seen = |length: i32, o: i32| {
            let length = ((length as i64) << (extra_bits & 0x1f)) - o as i64;
            all |= (length ^ (length >> 63)) as u64;
            length as i32
        };
        let points = points.map(|[x, y, z]| [seen(x, o[0]), seen(y, o[1]), seen(z, o[2])]);
        (all >> 30 == 0).then(|| (points, leading_zeros(all as u32)))
    }
    #[inline(always)]
    fn relative_to(self, o: Self, extra_bits: i32) -> Option<Self> {
        let length = ((self as i64) << (extra_bits & 0x1f)) - o as i64;
        ((length ^ (length >> 63)) as u64 >> 30 == 0).then_some(length as i32)
    }
    #[inline(always)]
    fn fitting(longest: Self) -> i32 {
        placed::room(longest as u32).max(Self::FINER)
    }
    #[cold]
    #[inline(never)]
    fn coarser(point: [Self; 3], bits: u32) -> [Self; 3] {
        point.map(|length| round_off(length as i64, bits) as i32)
    }
    #[inline(always)]
    fn placed(from: [Self; 3], d: [Self; 3]) -> Option<(Self, [Self; 3], i32)> {
        placed::placed(from, d)
    }

    #[inline(always)]
    fn dot<const M: usize>(a: [Self; M], b: [Self; M]) -> i64 {
        let mut sum = 0;
        for (a, b) in a.into_iter().zip(b) {
            sum += product(a, b);
        }
        sum
    }
    #[inline(always)]
    fn minor([a, b]: [Self; 2], [c, d]: [Self; 2]) -> i64 {
        product(a, d) - product(b, c)
    }
    #[inline(always)]
    fn squared_length<const M: usize>(v: [Self; M]) -> i64 {
        v.into_iter().fold(0, |sum, component| sum + square(component))
    }
    #[inline(always)]
    fn portion<const M: usize>(a: [Self; M], d: [Self; M]) -> Self {
        // Each is cut off: half of the error is added back.
        let mut sum = M as i32 / 2;
        for (a, d) in a.into_iter().zip(d) {
            sum += high_product_signed(a << 2, d);
        }
        sum
    }

    #[inline(always)]
    fn high(product: i64) -> Self {
        high(product)
    }
    #[inline(always)]
    fn low(product: i64) -> Self {
        product as Self
    }
    #[inline(always)]
    fn narrowed(product: i64) -> Option<Self> {
        (product == product as i32 as i64).then_some(product as i32)
    }
    #[inline(always)]
    fn nearest(product: i64) -> Self {
        round_off(product, Self::FRACTION) as i32
    }
    #[inline(always)]
    fn rounded(product: i64, extra_bits: i32) -> Self {
        within_type(round_off(product, Self::FRACTION + extra_bits as u32))
    }
    #[inline(always)]
    fn truncated(product: i64, by: u32) -> Self {
        ((((product >> 32) as u32) << ((32 - by) & 0x1f)) | (product as u32) >> (by & 0x1f)) as i32
    }
    #[inline(always)]
    fn reaches(product: i64, by: u32) -> bool {
        ((product >> 32) as u32) >> ((by - 2) & 0x1f) != 0
    }
    #[inline(always)]
    fn rounded_off(product: i64, by: u32) -> Self {
        let twice = Self::truncated(product, by - 1);
        (twice >> 1) + (twice & 1)
    }
    #[inline(always)]
    fn root(product: i64) -> Self {
        root(product as u64) as i32
    }

    #[inline(always)]
    fn excess(square: i64) -> Option<i32> {
        Some(((square - (1 << 60)) >> 12) as i32)
    }
    #[inline(always)]
    fn share(value: i64, e: i32) -> i64 {
        product(high(value), e) >> 16
    }
    #[inline(always)]
    fn without_excess(value: i64, e: i32) -> i64 {
        value - Self::share(value, e)
    }
}

#[cfg(units)]
#[path = "../../../../tests/units/scalar/integers/bits32.rs"]
mod tests;
