//! Transformation of a line by an affine map, in fixed point.

use super::placed::{FINEST, LENGTH_BITS, closest, room};
use super::{leading_zeros_of_64, magnitude_bits, round_off};
use crate::scalar::Attempt;
use crate::scalar::integers::direction::{Unit, unit};
use crate::scalar::integers::length::{InverseLength, Length, Stretch, Stretched};

/// If the largest coordinate of a line's origin, relative to the map's position, has at least this many bits, the
/// origin is moved next to that position.
const FAR: u32 = 19;

/// Ends beyond this are left to wider numbers: the error from inverse length and direction would be an eighth of a
/// unit.
const TOO_FAR: i32 = 1 << 26;

impl Stretch for i32 {
    #[inline(always)]
    fn along_ray(InverseLength { digits, shift, .. }: InverseLength, start: i32, t: i32) -> Option<i32> {
        if t == i32::MAX || t == -i32::MAX {
            return Some(t);
        }
        if t <= -TOO_FAR || t >= TOO_FAR {
            return None;
        }
        let whole = round_off(t as i64 * digits as i64, shift) + start as i64;
        (whole.unsigned_abs() < i32::MAX as u64 - 1).then_some(whole as i32)
    }

    #[inline]
    fn stretched(
        o: [i32; 3],
        d: [i32; 3],
        position: [i32; 3],
        rows: [([i32; 3], i32); 3],
        longest: i32,
    ) -> Option<Stretched<i32>> {
        let apart = |o: i32, position: i32| o.wrapping_sub(position);
        let from = [apart(o[0], position[0]), apart(o[1], position[1]), apart(o[2], position[2])];
        let bits = magnitude_bits(from[0]) | magnitude_bits(from[1]) | magnitude_bits(from[2]);
        let is_far = bits >> FAR != 0;
        let (start, point, extra_bits) = if is_far { closest(from, d, 2 * FINEST)? } else { (0, from, 0) };

        // Exact except for the bits of smaller rows below the unit of the largest: in units of 2^(exponent - 30 -
        // extra_bits) and 2^(exponent - 60).
        let [x, y, z] = rows.map(|(_, exponent)| exponent);
        let exponent = x.max(y).max(z);
        let down = [x, y, z].map(|own| (exponent - own).min(63) as u32);
        let image = |v: [i32; 3]| {
            [i32::dot(v, rows[0].0) >> down[0], i32::dot(v, rows[1].0) >> down[1], i32::dot(v, rows[2].0) >> down[2]]
        };
        let (origin, direction) = (image(point), image(d));

        // The direction, at first with 31 bits in its longest component, and the inverse length, which is one over its
        // length.
        let excess = bits_of_longest(direction) - 31;
        if excess < 1 {
            return None;
        }
        let Attempt::Hit(Unit { components, reciprocal, halvings }) = unit(shifted(direction, excess)) else {
            return None;
        };
        // The length is that of the argument of unit(), times 2^(excess + exponent - 60).
        let shift = halvings + excess + exponent - 29;

        // A unit along the line is at most half of one along the ray.
        let scale = (33 - shift).max(0);
        // As many extra bits as the lengths of line and solid leave; but rounded bits are not replaced by zeros.
        let top = bits_of_longest(origin) + exponent - 30 - extra_bits;
        let rounded = if is_far { extra_bits - 2 - exponent } else { i32::MAX };
        let finer_than_type = (LENGTH_BITS - top).min(room(longest as u32)).min(rounded).min(scale + FINEST);
        if finer_than_type < scale + i32::FINER || shift + scale > 62 {
            return None;
        }
        Some(Stretched {
            start,
            origin: shifted(origin, 30 + extra_bits - exponent - finer_than_type),
            extra_bits: finer_than_type - scale,
            direction: components,
            scale,
            inverse_length: InverseLength { digits: reciprocal, below: 0, shift: (shift + scale) as u32 },
        })
    }
}

/// The bits of the longest component, or one less.
#[inline(always)]
fn bits_of_longest([x, y, z]: [i64; 3]) -> i32 {
    let bits = |n: i64| (n ^ (n >> 63)) as u64;
    64 - leading_zeros_of_64(bits(x) | bits(y) | bits(z) | 1) as i32
}

/// Components times `2^-by`, rounded to nearest, where the results fit.
#[inline(always)]
fn shifted(v: [i64; 3], by: i32) -> [i32; 3] {
    if let 1..63 = by {
        let half = 1 << (by - 1);
        v.map(|n| ((n + half) >> by) as i32)
    } else {
        v.map(|n| n.wrapping_shl(by.unsigned_abs()) as i32)
    }
}
