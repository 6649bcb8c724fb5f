//! Square root, quotient, sums and products of blocks: every operand of the smallest width, random ones of the others.

use super::*;

fn floor_sqrt(n: u128) -> u128 {
    let mut root = (n as f64).sqrt() as u128;
    while root.checked_mul(root).is_none_or(|square| square > n) {
        root -= 1;
    }
    while (root + 1).checked_mul(root + 1).is_some_and(|square| square <= n) {
        root += 1;
    }
    root
}

/// A simple multiplicative generator. The tests need numbers of all sizes, and no statistical quality.
fn random_words() -> impl Iterator<Item = u128> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    core::iter::repeat_with(move || {
        let mut word = 0;
        for _ in 0..2 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let mut x = state ^ (state >> 31);
            x = x.wrapping_mul(0x9e37_79b9_7f4a_7c15);
            word = (word << 64) | (x ^ (x >> 29)) as u128;
        }
        word
    })
}

#[test]
fn square_root_of_16_bits_is_right_for_every_radicand() {
    for n in 0x4000..=u16::MAX {
        assert_eq!(Block16::integer_square_root(n) as u128, floor_sqrt(n as u128), "{n}");
    }
}

#[test]
fn square_root_of_32_bits_is_right_for_every_radicand_near_a_square() {
    for root in 0x8000_u64..=0xffff {
        for n in [root * root - 1, root * root, root * root + 1, root * root + 2 * root] {
            if (0x4000_0000..=u32::MAX as u64).contains(&n) {
                assert_eq!(super::division::root_of_32(n as u32) as u128, floor_sqrt(n as u128), "{n}");
            }
        }
    }
}

#[test]
fn square_root_of_64_and_128_bits_is_right_near_squares() {
    for word in random_words().take(200_000) {
        let root = (word as u64) | 1 << 63;
        let square = root as u128 * root as u128;
        for n in [square - 1, square, square + 2 * root as u128] {
            assert_eq!(Block128::integer_square_root(n), if n < square { root - 1 } else { root } as u128);
        }
        let root = (word as u32) as u64 | 1 << 31;
        for n in [root * root - 1, root * root, root * root + 2 * root] {
            if n >> 62 != 0 {
                assert_eq!(Block64::integer_square_root(n), if n < root * root { root - 1 } else { root });
            }
        }
    }
    for n in [1 << 62, u64::MAX, u64::MAX - 1, 0xffff_fffe_0000_0001, 0xffff_fffe_0000_0000] {
        assert_eq!(Block64::integer_square_root(n) as u128, floor_sqrt(n as u128), "{n}");
    }
    for n in [1 << 126, u128::MAX, u128::MAX - 1] {
        let root = Block128::integer_square_root(n);
        assert!(root * root <= n && (root + 1).checked_mul(root + 1).is_none_or(|square| square > n), "{n}");
    }
}

#[test]
fn quotient_of_16_bits_is_right_for_every_pair() {
    for divisor in 0x8000..=u16::MAX {
        // All high parts would be 2^30 pairs: a stride that is coprime to the width takes a sample of them.
        for high in (0..divisor).step_by(61).chain(divisor.saturating_sub(3)..divisor) {
            let exact = ((high as u32) << 16) / divisor as u32;
            assert_eq!(Block16::divide_wide(high, divisor) as u32, exact, "{high} {divisor}");
        }
    }
}

#[test]
fn quotient_of_64_bits_is_right() {
    for word in random_words().take(500_000) {
        let divisor = (word as u64) | 1 << 63;
        let high = ((word >> 64) as u64) % divisor;
        assert_eq!(Block64::divide_wide(high, divisor) as u128, ((high as u128) << 64) / divisor as u128);
    }
    for divisor in [1 << 63, u64::MAX, (1 << 63) | 1, (1 << 63) + (1 << 32) - 1] {
        for high in [0, 1, divisor - 1, divisor >> 1] {
            assert_eq!(Block64::divide_wide(high, divisor) as u128, ((high as u128) << 64) / divisor as u128);
        }
    }
}

#[test]
fn quotient_of_128_bits_times_divisor_comes_back() {
    for (a, b) in random_words().zip(random_words().skip(1)).take(100_000) {
        let divisor = a | 1 << 127;
        let high = b % divisor;
        let quotient = Block128::divide_wide(high, divisor);
        // high * 2^128 - quotient * divisor must lie in 0..divisor; only the low word of it can be non-zero.
        let (ql, qh, dl, dh) = (quotient as u64 as u128, quotient >> 64, divisor as u64 as u128, divisor >> 64);
        let cross = ((ql * dl) >> 64) + (ql * dh) % (1 << 64) + (qh * dl) % (1 << 64);
        let product_high = qh * dh + ((ql * dh) >> 64) + ((qh * dl) >> 64) + (cross >> 64);
        let product_low = quotient.wrapping_mul(divisor);
        let remainder = product_low.wrapping_neg();
        assert_eq!(high.wrapping_sub(product_high).wrapping_sub((product_low != 0) as u128), 0);
        assert!(remainder < divisor);
    }
}

#[test]
fn sums_and_products_of_small_blocks_are_exact_or_rounded_once() {
    let values = || (-129..=129).flat_map(|m| [-9, -3, 0, 2, 7].map(|e| (m, e)));
    let exact = |m: i16, e: i32| f64::from(m) * f64::from(e).exp2();
    for (m, e) in values() {
        for (n, f) in values() {
            let (a, b) = (Block16::new(m, e), Block16::new(n, f));
            let (x, y) = (exact(m, e), exact(n, f));
            let value = |block: Block16| exact(block.mantissa(), block.exponent());
            let sum = value(a + b);
            let bound = x.abs().max(y.abs()) * 2.0_f64.powi(-13);
            assert!((sum - (x + y)).abs() <= bound, "{m} {e} + {n} {f} = {sum}");
            let product = value(a * b);
            assert!((product - x * y).abs() <= (x * y).abs() * 2.0_f64.powi(-6), "{m} {e} * {n} {f} = {product}");
            let units = (a.to_units(-2), (x * 4.0).round_ties_even());
            assert_eq!(units.0.map(f64::from), (units.1.abs() <= f64::from(i16::MAX)).then_some(units.1), "{m} {e}");
            assert_eq!(a < b, x < y);
            assert_eq!(a == b, x == y);
            if n != 0 {
                let quotient = value(a / b);
                assert!((quotient - x / y).abs() <= (x / y).abs() * 2.0_f64.powi(-13), "{m} {e} / {n} {f}");
            }
        }
    }
}
