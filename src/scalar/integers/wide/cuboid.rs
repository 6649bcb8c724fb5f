//! Slabs of a cuboid in integers of 64 bits.

use super::{Digits, crossings, minor, refined, upper_bits};
use crate::scalar::integers::cuboid::Length;
use crate::scalar::{Attempt, found};

/// Products of up to 2^124 in 128 bits.
impl Length for i64 {
    type Product = i128;
    const ZERO: Self = 0;
    const MAX: Self = Self::MAX;
    const STEP: Self = 2;
    const NOTHING: i128 = 0;
    // Two products of at most 2 * 2^62, and two of at most 2 * 2^61.
    const DOUBT: i128 = 1 << 65;

    #[inline(always)]
    fn refined(self, o: Self, extra_bits: i32) -> Option<Self> {
        refined(self, extra_bits).filter(|bounding_radius| (upper_bits(o) | upper_bits(*bounding_radius)) >> 28 == 0)
    }
    #[inline(always)]
    fn difference(self, d: Self, other: Self, d_other: Self) -> i128 {
        minor([Digits::new(self), Digits::new(other)], [Digits::new(d), Digits::new(d_other)])
    }
    #[inline(always)]
    fn crossing(self, o: Self, extra_bits: i32, d: Self) -> Attempt<Self> {
        let [t, _] = found!(crossings(o, extra_bits, d, [self; 2]));
        Attempt::Hit(t)
    }
    #[inline(always)]
    fn two_behind(extra_bits: i32) -> Self {
        -(2 << (extra_bits & 0x1f))
    }
}
