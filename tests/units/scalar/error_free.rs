//! With and without a floating-point unit the bits are the same.

/// Floats of all exponents, of one exponent and next to powers of two, and special values.
macro_rules! both_ways_have_the_same_bits {
    ($test:ident, $module:ident, $Float:ident, $bits:ident, $mantissa:literal) => {
        #[test]
        fn $test() {
            use super::$module::{by_floats, by_integers};
            let mut state = 0x9e37_79b9_7f4a_7c15_u64;
            let mut next = || {
                state ^= state >> 12;
                state ^= state << 25;
                state ^= state >> 27;
                state.wrapping_mul(0x2545_f491_4f6c_dd1d)
            };
            let special = [0.0, -0.0, 1.0, -1.0, 1.5, $Float::MIN_POSITIVE, $Float::MAX, $Float::EPSILON];
            let mut number = || -> $Float {
                let bits = (next() >> (64 - $bits::BITS)) as $bits;
                let fraction = bits & ((1 << $mantissa) - 1);
                let one = (1.0 as $Float).to_bits();
                match next() % 5 {
                    0 => $Float::from_bits(bits),
                    1 => $Float::from_bits(one | fraction),
                    2 => -$Float::from_bits((one | fraction) + ((next() % 40) << $mantissa) as $bits),
                    3 => $Float::from_bits((one | fraction >> 20) - (next() % 4) as $bits),
                    _ => special[(next() % 8) as usize],
                }
            };
            let bits = |(a, b): ($Float, $Float)| (a.to_bits(), if b.is_finite() { b.to_bits() } else { 0 });
            for _ in 0..1_000_000 {
                let (a, b) = (number(), number());
                // At the end of the range intermediate results in floats overflow.
                if !(a.abs() < $Float::MAX / 8.0 && b.abs() < $Float::MAX / 8.0) {
                    continue;
                }
                assert_eq!(bits(by_floats::two_sum(a, b)), bits(by_integers::two_sum(a, b)), "{a:e} + {b:e}");
                let product = by_floats::two_product(a, b);
                assert_eq!(bits(product), bits(by_integers::two_product(a, b)), "{a:e} * {b:e}");
            }
        }
    };
}
both_ways_have_the_same_bits!(f32_has_the_same_bits_with_and_without_a_unit, exact_f32, f32, u32, 23);
both_ways_have_the_same_bits!(f64_has_the_same_bits_with_and_without_a_unit, exact_f64, f64, u64, 52);
