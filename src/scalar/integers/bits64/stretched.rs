//! Transformation of a line by an affine map.

use super::digits::{joined, root, upper_bits, words};
use super::quotient::{reciprocal_of_digits, upper_product};
use crate::scalar::integers::length::{InverseLength, Length, Stretch, Stretched};

/// The extra bits of the origin.
const FINER: i32 = i64::FINER;

/// Bits of an end below its unit, while it is multiplied by the inverse length.
const FRACTION: u32 = 5;

/// Longer ends have no room for [`FRACTION`].
const TOO_FAR: u64 = 1 << (62 - FRACTION);

impl Stretch for i64 {
    // A line of 64 bits always starts at zero.
    #[inline(always)]
    fn along_ray(InverseLength { digits, below, shift }: InverseLength, _start: i64, t: i64) -> Option<i64> {
        if t == i64::MAX || t == -i64::MAX {
            return Some(t);
        }
        let magnitude = t.unsigned_abs();
        if magnitude >= TOO_FAR {
            return None;
        }
        // The upper half of the product is too small by less than 2^-FRACTION of a unit along the line.
        let whole = upper_product(magnitude << FRACTION, joined([below, digits])) >> (shift - 65);
        let rounded = ((whole >> FRACTION) + 1) >> 1;
        Some(if t < 0 { -(rounded as i64) } else { rounded as i64 })
    }

    // The direction's length is rounded to some 2^-57 of itself. Direction and inverse length are multiples of the same
    // rounded reciprocal, so that the line and its `t` are accurate to their last bits; only the direction's length
    // differs from 1 by that.
    #[inline]
    fn stretched(
        o: [i64; 3],
        d: [i64; 3],
        position: [i64; 3],
        rows: [([i64; 3], i32); 3],
        longest: i64,
    ) -> Option<Stretched<i64>> {
        let apart = |o: i64, position: i64| o.wrapping_sub(position);
        let from = [apart(o[0], position[0]), apart(o[1], position[1]), apart(o[2], position[2])];
        // The same limit as for a frame.
        if (upper_bits(from[0]) | upper_bits(from[1]) | upper_bits(from[2])) >> 20 != 0 {
            return None;
        }
        // Exact except for the bits of smaller rows below the unit of the largest: in units of 2^(exponent - 62) and
        // 2^(exponent - 124).
        let [x, y, z] = rows.map(|(_, exponent)| exponent);
        let exponent = x.max(y).max(z);
        let down = [x, y, z].map(|own| (exponent - own).min(126) as u32);
        let rows = rows.map(|(row, _)| row);
        // Not one sum of three: all components of a row may be next to 1, and the middle digits of the products then
        // exceed 64 bits.
        let product = |[x, y, z]: [i64; 3], [a, b, c]: [i64; 3]| i64::dot([x, y], [a, b]) + i64::dot([z], [c]);
        let image = |v: [i64; 3]| {
            [product(v, rows[0]) >> down[0], product(v, rows[1]) >> down[1], product(v, rows[2]) >> down[2]]
        };
        let (origin, direction) = (image(from), image(d));

        // The direction, at first with 62 bits in its longest component, or one more. With fewer than 80 its last bits
        // would be missing.
        let excess = bits_of_longest(direction) - 62;
        if excess < 18 {
            return None;
        }
        let components = shifted(direction, excess as u32);
        // The longest component is at least 2^61; the root of a direction along an axis may be rounded to below it.
        let length = root(i64::squared_length(components)).max(1 << 61);
        let zeros = length.leading_zeros();
        // 2^127 over the length's digits
        let reciprocal = reciprocal_of_digits(length << (zeros & 0x3f));
        // The component over the length, in units of 2^-62: c reciprocal 2^(zeros - 65), where zeros is 1 or 2.
        let along = |c: i64| {
            // A component may be 2^62 itself, which has one bit too many.
            let digits = c.unsigned_abs().min((1 << 62) - 1);
            let quotient = upper_product(digits << 2, reciprocal) >> (2_u32.saturating_sub(zeros));
            let magnitude = ((quotient + 1) >> 1) as i64;
            if c < 0 { -magnitude } else { magnitude }
        };
        let direction = components.map(along);

        // The ray's t is the line's times reciprocal 2^-shift. A unit along the line is at most half of one along the
        // ray.
        let shift = 3 + excess + exponent - zeros as i32;
        let scale = (65 - shift).max(0);
        let shift = shift + scale;
        let has_room = scale < 40 && longest >> (53 - scale.min(40)) == 0 && shift < 65 + 62;
        // To units of 2^-FINER of that.
        let by = 62 - FINER - exponent - scale;
        if !has_room || bits_of_longest(origin) - by > 62 || by >= 126 {
            return None;
        }
        let origin = if by > 0 { shifted(origin, by as u32) } else { origin.map(|n| (n << by.unsigned_abs()) as i64) };
        let [below, digits] = words(reciprocal);
        Some(Stretched {
            start: 0,
            origin,
            extra_bits: FINER,
            direction,
            scale,
            inverse_length: InverseLength { digits, below, shift: shift as u32 },
        })
    }
}

/// The bits of the longest component, or one less.
#[inline(always)]
fn bits_of_longest([x, y, z]: [i128; 3]) -> i32 {
    let bits = |n: i128| (n ^ (n >> 127)) as u128;
    128 - (bits(x) | bits(y) | bits(z) | 1).leading_zeros() as i32
}

/// Components times `2^-by`, rounded to nearest, where the results fit; `by` is not zero.
#[inline(always)]
fn shifted(v: [i128; 3], by: u32) -> [i64; 3] {
    v.map(|n| ((n + (1 << (by - 1))) >> by) as i64)
}
