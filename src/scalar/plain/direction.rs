//! The direction of a vector.

use super::{high, high_product, leading_zeros, magnitude_bits, product, reciprocal_root, square};
use crate::scalar::Plain;

/// The unit vector along `v`, each component within .51 units of 2^-30 (a miss for the zero vector): `y = 1 / |v|` by Newton's
/// steps `y (1 + e / 2)` with `e = 1 - |v|^2 y^2`, of which the last is taken by the products with `v`.
#[inline]
pub(in crate::scalar) fn direction(v: [i32; 3]) -> Plain<[i32; 3]> {
    let [x, y, z] = v;
    let all = magnitude_bits(x) | magnitude_bits(y) | magnitude_bits(z);
    if all >> 30 != 0 {
        return Plain::Unclear;
    }
    // The longest between 2^29 and 2^30.
    let up = leading_zeros(all | 1) - 2;
    let v = [x << up, y << up, z << up];
    let squares = (square(v[0]) + square(v[1]) + square(v[2])) as u64;
    if squares == 0 {
        return Plain::Miss;
    }
    // |v|^2 = 2^60 m or 2^62 m, with m in [1/4, 1).
    let long = squares >> 60 != 0;
    let squares = if long { squares << 2 } else { squares << 4 };
    let (above, below) = ((squares >> 32) as u32, squares as u32);

    // To 14 bits, in units of 2^-16; then to 27, in units of 2^-30.
    let y = reciprocal_root(above);
    let root = high_product(above, y << 15);
    let lack = (1 << 30) - high_product(root, y << 15) as i32;
    let y = ((y << 14).wrapping_add(((y as i32 >> 4).wrapping_mul(lack) >> 13) as u32)).min(i32::MAX as u32);

    // m y in units of 2^-62, m y^2 in units of 2^-60, and e in units of 2^-38.
    let (low, carry) = above.wrapping_mul(y).overflowing_add(high_product(below, y));
    let root = high_product(above, y) + carry as u32;
    let lack = (1 << 60) - product(root as i32, y as i32) - high_product(low, y) as i64;
    let lack = (lack >> 22) as i32;

    let along = |component: i32| {
        // v y, in units of 2^-62 or of 2^-61, and what the last step adds to it.
        let product = product(component.abs(), y as i32);
        let step = ((high(product) >> 12).wrapping_mul(lack) as i64) << 5;
        let sum = if long { product + step } else { (product + step) << 1 };
        let magnitude = (((sum >> 30) + 1) >> 1) as i32;
        if component < 0 { -magnitude } else { magnitude }
    };
    Plain::Found([along(v[0]), along(v[1]), along(v[2])])
}
