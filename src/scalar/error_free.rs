//! Sums and products of floats with their rounding errors, and powers of two.
//!
//! With a floating-point unit they are computed in floats. Without one each operation on floats is a call of some
//! hundred instructions. There a product is computed in integers, and a sum by three operations instead of six, with
//! the same bits.

/// Defines these functions for a float. `$half` is the number of mantissa bits that a split moves to the low part.
macro_rules! error_free {
    (
        $name:ident, $Float:ident, $bits:ident, $half:literal, $mantissa:literal, $bias:literal, product: $product:path,
        without_unit: $without_unit:meta
    ) => {
        pub(super) mod $name {
            pub(in crate::scalar) use by_floats::split;
            pub(in crate::scalar) use implementation::{two_product, two_sum};

            #[cfg(not($without_unit))]
            use by_floats as implementation;
            #[cfg($without_unit)]
            use by_integers as implementation;

            pub(in crate::scalar) mod by_floats {
                /// `a = high + low`, each with at most half of the bits, so that products of halves are exact.
                /// Rounded in the integer representation: unlike Veltkamp's split it cannot overflow inside the budget.
                #[inline(always)]
                pub(in crate::scalar) fn split(a: $Float) -> ($Float, $Float) {
                    let high = $Float::from_bits((a.to_bits() + (1 << ($half - 1))) & ($bits::MAX << $half));
                    (high, a - high)
                }

                /// `a * b = p + e` exactly (Dekker, *A floating-point technique for extending the available precision*,
                /// 1971).
                #[cfg_attr($without_unit, inline(never))]
                #[cfg_attr(not($without_unit), inline(always))]
                pub(in crate::scalar) fn two_product(a: $Float, b: $Float) -> ($Float, $Float) {
                    let p = a * b;
                    let ((ah, al), (bh, bl)) = (split(a), split(b));
                    (p, (((ah * bh - p) + ah * bl) + al * bh) + al * bl)
                }

                /// `a + b = s + e` exactly (Knuth, *The Art of Computer Programming* 2, 4.2.2, Theorem B).
                #[cfg(any(units, not($without_unit)))]
                #[inline(always)]
                pub(in crate::scalar) fn two_sum(a: $Float, b: $Float) -> ($Float, $Float) {
                    let s = a + b;
                    let b_part = s - a;
                    (s, (a - (s - b_part)) + (b - b_part))
                }
            }

            #[cfg(any(units, $without_unit))]
            pub(in crate::scalar) mod by_integers {
                const FIELD: $bits = 2 * $bias + 1;
                const SIGN: $bits = 1 << ($bits::BITS - 1);

                /// The same bits as in floats.
                #[inline(never)]
                pub(in crate::scalar) fn two_product(a: $Float, b: $Float) -> ($Float, $Float) {
                    const ONE: $bits = 1 << $mantissa;
                    let (x, y) = (a.to_bits(), b.to_bits());
                    let (ex, ey) = ((x >> $mantissa) & FIELD, (y >> $mantissa) & FIELD);
                    let sum = (ex + ey) as i32;
                    // Both are normal numbers, and so is the lowest bit of the product.
                    let is_normal = 0 < ex && ex < FIELD - 1 && 0 < ey && ey < FIELD - 1;
                    if !is_normal || sum <= $bias + 2 * $mantissa + 2 || sum >= 3 * $bias - 2 {
                        return super::by_floats::two_product(a, b);
                    }
                    let product = $product((x & (ONE - 1)) | ONE, (y & (ONE - 1)) | ONE);
                    let top = (product >> (2 * $mantissa + 1)) as i32;
                    let product = if top == 0 { product << 1 } else { product };
                    // To nearest, ties to even.
                    let (high, rest) = ((product >> ($mantissa + 1)) as $bits, product as $bits & (2 * ONE - 1));
                    let up = (rest > ONE || rest == ONE && high & 1 != 0) as $bits;
                    let sign = (x ^ y) & SIGN;
                    let place = sum - $bias + top;
                    // The mantissa's top bit adds one to the exponent's field, and so does a carry.
                    let p = sign | ((((place - 1) as $bits) << $mantissa) + high + up);
                    if rest == 0 {
                        return ($Float::from_bits(p), 0.0);
                    }
                    let (low, low_sign) = if up == 0 { (rest, sign) } else { (2 * ONE - rest, sign ^ SIGN) };
                    let zeros = low.leading_zeros() - ($bits::BITS - $mantissa - 1);
                    let place = place - 1 - $mantissa - zeros as i32;
                    let e = low_sign | ((((place - 1) as $bits) << $mantissa) + (low << zeros));
                    ($Float::from_bits(p), $Float::from_bits(e))
                }

                /// The same bits as in floats (Dekker 1971, for a first operand that is not the smaller).
                #[inline(never)]
                pub(in crate::scalar) fn two_sum(a: $Float, b: $Float) -> ($Float, $Float) {
                    let s = a + b;
                    if s.to_bits() & !SIGN >= FIELD << $mantissa {
                        return (s, $Float::NAN);
                    }
                    let is_less = a.to_bits() & !SIGN < b.to_bits() & !SIGN;
                    let (large, small) = if is_less { (b, a) } else { (a, b) };
                    if small.to_bits() & !SIGN == 0 { (s, 0.0) } else { (s, small - (s - large)) }
                }
            }

            /// `2^e` for an exponent of a normal number.
            #[inline(always)]
            pub(in crate::scalar) fn power_of_two(e: i32) -> $Float {
                $Float::from_bits(((e + $bias) as $bits) << $mantissa)
            }

            /// `x * 2^e` for any exponent; rounds only where the result is subnormal.
            #[inline]
            pub(in crate::scalar) fn scale(mut x: $Float, mut e: i32) -> $Float {
                if e > $bias {
                    x *= power_of_two($bias);
                    e = (e - $bias).min($bias);
                } else if e < 1 - $bias {
                    x *= power_of_two(1 - $bias);
                    e = (e - (1 - $bias)).max(1 - $bias);
                }
                x * power_of_two(e)
            }
        }
    };
}

error_free!(
    exact_f32, f32, u32, 12, 23, 127, product: crate::number::machine::product_unsigned,
    without_unit: all(
        target_os = "none",
        any(all(target_arch = "arm", not(target_abi = "eabihf")), target_arch = "riscv32")
    )
);
error_free!(
    exact_f64, f64, u64, 27, 52, 1023, product: crate::number::machine::full_product,
    without_unit: all(target_os = "none", any(target_arch = "arm", target_arch = "riscv32"))
);

#[cfg(units)]
#[path = "../../tests/units/scalar/error_free.rs"]
mod tests;
