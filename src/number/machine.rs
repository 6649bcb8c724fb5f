//! Products, reciprocals and roots of machine words, by multiplications alone.
//!
//! The grid of fixed point uses all of these functions, the robust number some of them.

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

/// `a * b` in 64 bits, from products of 16 bits: ARMv6-M has no long multiplication, and the compiler calls a function
/// for it (Warren, *Hacker's Delight*, 8-2).
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

/// `a * a` as in [`product`], with one product fewer.
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
    // The lower half of `second` is the upper half of the low word. Subtracting it changes nothing, but without it
    // LLVM 22 sees that this is a long product, and calls the function for it.
    ah * bh + (first >> 16) + ((second - (a.wrapping_mul(b) >> 16)) >> 16)
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

/// `1 / sqrt(m)` in units of 2^-16, accurate to 14 bits and never too large, for `m = high / 2^32` in [1/4, 1): by a
/// table for 8 bits and a Newton step.
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
/// A reciprocal root of 14 bits, and with it two steps for the root: remainder over twice the root (Markstein, *IA-64
/// and Elementary Functions*, 2000, chapter 8, here in integers). Multiplications only.
#[inline]
pub(crate) fn root_of_normalized(high: u32, low: u32) -> u32 {
    // m = high / 2^32
    let y = reciprocal_root(high);
    // sqrt(m) = m y, in units of 2^-16; never too large, since m and y are rounded down.
    let root = (high >> 16).wrapping_mul(y >> 1) >> 15;
    // (m - root^2) / (2 root), in units of 2^-32. The step may be too large by a few units: after subtracting 32 the
    // root is certainly not too large.
    let rest = (high.wrapping_sub(root * root) << 11) | (low >> 21);
    let step = (high_product(rest, y) << 4) | (rest.wrapping_mul(y) >> 28);
    let root = ((root << 16) + step).wrapping_sub(32);
    // A second step for the last bits.
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
    // The step may be a little too large: after subtracting 8 the reciprocal is certainly not too large.
    let y = (y << 15).wrapping_add((product(lack, y as i32) >> 25) as u32).wrapping_sub(8);
    // A last step: 2^63 - n y, which is a few units of 2^32, in units of 2^24
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

/// The leading zeros of a number that is not zero, by halves: these chips have no instruction for it, and the
/// compiler's own code has twice as many instructions.
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
    // The leading zeros of four bits, from a table with two bits each.
    zeros + ((0x55af_u32 >> (2 * (n >> 28))) & 3)
}

/// The leading zeros of a number that is not zero.
#[inline(always)]
pub(crate) fn leading_zeros_of_64(n: u64) -> u32 {
    let (high, low) = ((n >> 32) as u32, n as u32);
    if high != 0 { leading_zeros(high) } else { 32 + leading_zeros(low) }
}
