//! The direction of a vector.

use crate::number::machine::{high_product, leading_zeros, product, product_unsigned, reciprocal_root, square};
use crate::scalar::{Attempt, found};

/// The direction and the length of a vector.
pub(super) struct Unit {
    /// In units of 2^-30.
    pub(super) components: [i32; 3],
    /// One over the length is `reciprocal * 2^-(31 + halvings)`. It is at least 2^31, with an error of at most two
    /// units.
    pub(super) reciprocal: u32,
    pub(super) halvings: i32,
}

/// The unit vector along `v`, as [`unit`] computes it.
#[inline]
pub(in crate::scalar) fn direction(v: [i32; 3]) -> Attempt<[i32; 3]> {
    Attempt::Hit(found!(unit(v)).components)
}

/// The unit vector along `v`, each component within .51 units of 2^-30 (a miss for the zero vector): `r = 1 / |v|` by
/// Newton's steps `r (1 + e / 2)` with `e = 1 - |v|^2 r^2`, of which the last is applied to the products with `v`.
#[inline(always)]
pub(super) fn unit(v: [i32; 3]) -> Attempt<Unit> {
    let [x, y, z] = v.map(i32::unsigned_abs);
    let all = x | y | z;
    if all >= i32::MAX as u32 {
        return Attempt::Unsure;
    }
    // The longest component is brought between 2^30 and 2^31.
    let up = leading_zeros(all | 1) - 1;
    let [x, y, z] = [(x << up) as i32, (y << up) as i32, (z << up) as i32];
    let squares = square(x) as u64 + square(y) as u64 + square(z) as u64;
    if squares == 0 {
        return Attempt::Miss;
    }
    // |v|^2 = 2^62 m or 2^64 m, with m in [1/4, 1).
    let long = squares >> 62 != 0;
    let squares = if long { squares } else { squares << 2 };
    let (above, below) = ((squares >> 32) as u32, squares as u32);

    // To 14 bits, in units of 2^-16; then to 27, in units of 2^-30.
    let r = reciprocal_root(above);
    let root = high_product(above, r << 15);
    let lack = (1 << 30) - high_product(root, r << 15) as i32;
    let r = ((r << 14).wrapping_add(((r as i32 >> 4).wrapping_mul(lack) >> 13) as u32)).min(i32::MAX as u32);

    // m r in units of 2^-62, m r^2 in units of 2^-60, and e in units of 2^-38.
    let (low, carry) = above.wrapping_mul(r).overflowing_add(high_product(below, r));
    let root = high_product(above, r) + carry as u32;
    let lack = (1 << 60) - product_unsigned(root, r) as i64 - high_product(low, r) as i64;
    let lack = (lack >> 22) as i32;

    let along = |component: i32, signed: i32| {
        // v r, in units of 2^-62 or of 2^-61, and the correction by the last step.
        let product = product(component, r as i32);
        let step = (((product >> 32) as i32 >> 13).wrapping_mul(lack) as i64) << 6;
        let sum = if long { product + step } else { (product + step) << 1 };
        let magnitude = (((sum >> 31) + 1) >> 1) as i32;
        if signed < 0 { -magnitude } else { magnitude }
    };
    let components = [along(x, v[0]), along(y, v[1]), along(z, v[2])];
    // r (1 + e / 2), in units of 2^-31; the length is 2^31 or 2^32 times the root of m, divided by the power of two by
    // which v was shifted up.
    let reciprocal = ((r as i64) << 1) + (product(r as i32, lack) >> 38);
    let reciprocal = if reciprocal > u32::MAX as i64 { u32::MAX } else { reciprocal as u32 };
    Attempt::Hit(Unit { components, reciprocal, halvings: 31 + long as i32 - up as i32 })
}
