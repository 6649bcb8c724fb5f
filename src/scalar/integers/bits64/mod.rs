//! Lengths of 64 bits, and their products of 128 bits, which are made of products of 32 bits.

mod digits;
mod quotient;
mod stretched;

use super::length::{Length, Product};
use crate::number::machine::{leading_zeros_of_64, product, square};
use digits::{Digits, carried, down, down_to_64, high, root, round_off, up, up_to_128, upper_bits};

/// Bits of the unit of an `e` in `1 + e`.
const EXCESS_BITS: u32 = 88;

impl Product for i128 {
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

impl Length for i64 {
    type Product = i128;
    type Normalized = quotient::Normalized;
    /// In units of `2^-EXCESS_BITS`: at most some 2^-39 for directions of this type, and 2^-26 for one of 30 bits.
    type Excess = i64;

    const BITS: u32 = 64;
    const CONE_BITS: u32 = 52;
    const FINER: i32 = 8;
    const GUARDS_APPROACH: bool = true;
    const MOMENT_BITS: u32 = 1;
    const NORMAL: (u32, u32) = (6, 61);
    const ZERO: Self = 0;
    const MAX: Self = Self::MAX;

    #[inline(always)]
    fn top(self) -> u32 {
        upper_bits(self)
    }
    #[inline(always)]
    fn zeros<const M: usize>(lengths: [Self; M]) -> u32 {
        leading_zeros_of_64(lengths.into_iter().fold(1, |all, length| all | (length ^ (length >> 63)) as u64))
    }
    #[inline(always)]
    fn up(self, by: u32) -> Self {
        up(self, by)
    }
    #[inline(always)]
    fn down(self, by: u32) -> Self {
        down(self, by)
    }
    #[inline(always)]
    fn at_unit(self) -> i128 {
        (self as i128) << Self::FRACTION
    }
    #[inline(always)]
    fn raised(self, by: u32) -> i128 {
        up_to_128(self as u64, by) as i128
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
    fn have_room([x, y, z]: [Self; 3]) -> bool {
        (upper_bits(x) | upper_bits(y) | upper_bits(z)) >> 28 == 0
    }
    #[inline(always)]
    fn have_products(lengths: [Self; 3]) -> bool {
        Self::have_room(lengths)
    }
    #[inline(always)]
    fn refined(self, extra_bits: i32) -> Option<Self> {
        // In a frame, or in the world.
        let room = 30_i32.wrapping_sub(extra_bits);
        let fits = (extra_bits == 0 || extra_bits == Self::FINER) && upper_bits(self) >> room == 0;
        if fits { Some(if extra_bits == 0 { self } else { self << Self::FINER }) } else { None }
    }
    #[inline(always)]
    fn refined_beside(self, o: Self, extra_bits: i32) -> Option<Self> {
        let refined = match extra_bits {
            0 => self,
            Self::FINER if upper_bits(self) >> (30 - Self::FINER) == 0 => self << Self::FINER,
            _ => return None,
        };
        ((upper_bits(refined) | upper_bits(o)) >> 28 == 0).then_some(refined)
    }
    #[inline(always)]
    fn refined_time(self, extra_bits: i32) -> Option<Self> {
        self.refined(extra_bits).filter(|t| upper_bits(*t) >> 29 == 0)
    }
    #[inline(always)]
    fn seen_from<const M: usize>(
        points: [[Self; 3]; M],
        o: [Self; 3],
        extra_bits: i32,
    ) -> Option<([[Self; 3]; M], u32)> {
        if !Self::have_room(o) || !(extra_bits == 0 || extra_bits == Self::FINER) {
            return None;
        }
        let (mut all, mut longest) = (1, 0);
        let mut seen = |length: i64, o: i64| {
            longest |= upper_bits(length);
            let length = if extra_bits == 0 { length } else { length << Self::FINER }.wrapping_sub(o);
            all |= (length ^ (length >> 63)) as u64;
            length
        };
        let points = points.map(|[x, y, z]| [seen(x, o[0]), seen(y, o[1]), seen(z, o[2])]);
        (longest >> (28 - extra_bits) == 0).then(|| (points, leading_zeros_of_64(all)))
    }
    #[inline(always)]
    fn relative_to(self, o: Self, extra_bits: i32) -> Option<Self> {
        Some(self.refined_beside(o, extra_bits)?.wrapping_sub(o))
    }
    #[inline(always)]
    fn fitting(_: Self) -> i32 {
        Self::FINER
    }
    #[cold]
    #[inline(never)]
    fn coarser(point: [Self; 3], bits: u32) -> [Self; 3] {
        point.map(|length| down(length, bits))
    }
    #[inline(always)]
    fn placed(from: [Self; 3], _: [Self; 3]) -> Option<(Self, [Self; 3], i32)> {
        // Up to 2^52 from the frame's origin on each axis, all products fit, and so does the moment of the result.
        let fits = (upper_bits(from[0]) | upper_bits(from[1]) | upper_bits(from[2])) >> 20 == 0;
        fits.then_some((0, from.map(|length| length << Self::FINER), Self::FINER))
    }

    /// The middle digits are added in 64 bits: `sum |a_i| + sum |b_i|` must be below 2^64, as it is for two unit
    /// vectors (`2 sqrt(3) 2^62`).
    #[inline(always)]
    fn dot<const M: usize>(a: [Self; M], b: [Self; M]) -> i128 {
        let (mut high, mut middle, mut low) = (0, 0, 0);
        for (a, b) in a.into_iter().zip(b) {
            let (a, b) = (Digits::new(a), Digits::new(b));
            high += product(a.high, b.high);
            middle += a.middle(b);
            // Up to 2^62 each.
            low += product(a.low, b.low) as i128;
        }
        carried(high, middle, low)
    }
    #[inline(always)]
    fn minor(ab: [Self; 2], cd: [Self; 2]) -> i128 {
        let ([a, b], [c, d]) = (ab.map(Digits::new), cd.map(Digits::new));
        let high = product(a.high, d.high) - product(b.high, c.high);
        let middle = a.middle(d) - b.middle(c);
        let low = product(a.low, d.low) as i128 - product(b.low, c.low) as i128;
        carried(high, middle, low)
    }
    #[inline(always)]
    fn squared_length<const M: usize>(v: [Self; M]) -> i128 {
        let (mut high, mut middle, mut low) = (0, 0, 0);
        for Digits { high: upper, low: lower } in v.map(Digits::new) {
            high += square(upper);
            middle += product(upper, lower);
            // Up to 2^62 each, and three at most.
            low += square(lower) as u64;
        }
        ((high as i128) << 64) + ((middle as i128) << 33) + low as i128
    }
    #[inline(always)]
    fn portion<const M: usize>(a: [Self; M], d: [Self; M]) -> Self {
        // The products of the low digits, at most a unit each, are left out.
        let (mut high, mut middle) = (0, 0);
        for (a, d) in a.into_iter().zip(d) {
            let (a, d) = (Digits::new(a), Digits::new(d));
            high += product(a.high, d.high);
            middle += a.middle(d);
        }
        (high << 2) + ((middle + (1 << 29)) >> 30)
    }

    #[inline(always)]
    fn high(product: i128) -> Self {
        high(product)
    }
    #[inline(always)]
    fn low(product: i128) -> Self {
        product as Self
    }
    #[inline(always)]
    fn narrowed(product: i128) -> Option<Self> {
        (product == product as i64 as i128).then_some(product as i64)
    }
    #[inline(always)]
    fn nearest(product: i128) -> Self {
        round_off::<62>(product)
    }
    #[inline(always)]
    fn rounded(product: i128, extra_bits: i32) -> Self {
        if extra_bits == 0 { round_off::<62>(product) } else { round_off::<{ 62 + Self::FINER as u32 }>(product) }
    }
    #[inline(always)]
    fn truncated(product: i128, by: u32) -> Self {
        down_to_64(product as u128, by) as i64
    }
    #[inline(always)]
    fn reaches(product: i128, by: u32) -> bool {
        down_to_64(product as u128 >> 64, by - 2) != 0
    }
    #[inline(always)]
    fn rounded_off(product: i128, by: u32) -> Self {
        ((down_to_64(product as u128, by - 1) + 1) >> 1) as i64
    }
    #[inline(always)]
    fn root(product: i128) -> Self {
        root(product) as i64
    }

    #[inline(always)]
    fn excess(square: i128) -> Option<i64> {
        let e = (square - (1 << 124)) >> (124 - EXCESS_BITS);
        (e.unsigned_abs() >> 62 == 0).then_some(e as i64)
    }
    #[inline(always)]
    fn share(value: i128, e: i64) -> i128 {
        let short = e >> 18;
        if short == short as i32 as i64 {
            // In units of 2^-70.
            return (product((value >> 94) as i32, short as i32) as i128) << 24;
        }
        share_of_long(value, e)
    }
    #[inline(always)]
    fn without_excess(value: i128, e: i64) -> i128 {
        // 1 / (1 + e) is 1 - (e - e^2).
        value - Self::share(value, e - (square((e >> 32) as i32) >> 24))
    }
}

/// The same for an `e` of up to 2^-26, as a direction of 30 bits has.
#[cold]
#[inline(never)]
fn share_of_long(value: i128, e: i64) -> i128 {
    i64::dot([high(value)], [e]) >> 24
}

#[cfg(units)]
#[path = "../../../../tests/units/scalar/integers/bits64.rs"]
mod tests;
