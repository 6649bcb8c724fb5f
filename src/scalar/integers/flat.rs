//! A line and planes across the y axis.

use super::quotient::Normalized;
use super::{half, high_product_signed, leading_zeros, magnitude_bits, product, product_unsigned, round_off, square};
use crate::scalar::{Attempt, found};

/// Where the line crosses each of the heights: `t = (y - oy) / dy`. A line of constant height crosses none of them.
///
/// The origin is in units of `2^-extra_bits` of the heights'; the answer is in the heights'.
#[inline(always)]
pub(in crate::scalar) fn crossings(oy: i32, extra_bits: i32, dy: i32, [low, high]: [i32; 2]) -> Attempt<[i32; 2]> {
    if dy == 0 {
        return Attempt::Miss;
    }
    if !(0..28).contains(&extra_bits) {
        return Attempt::Unsure;
    }
    let Some(divisor) = Normalized::new((dy as i64) << 30).map(Normalized::divisor) else {
        return Attempt::Unsure;
    };
    // The rounding error of a framed origin, half of its own unit, is larger at the crossing if the line is nearly
    // parallel to the plane; it must not exceed an eighth of a unit.
    let is_level = extra_bits != 0 && divisor.shift > 3;
    if is_level && divisor.shift as i32 > extra_bits - 3 {
        return Attempt::Unsure;
    }
    let above = |y: i32| ((y as i64) << extra_bits) - oy as i64;
    let (low, high) = (above(low), above(high));
    if (low.unsigned_abs() | high.unsigned_abs()) >> 33 != 0 {
        return Attempt::Unsure;
    }
    // With 28 further bits, so that the quotient has room for its fraction.
    let unit = 28 + extra_bits as u32;
    match (divisor.quotient(low << 28, unit), divisor.quotient(high << 28, unit)) {
        // The rounding error of the direction, 2^-31 of t, grows as that of the origin.
        (Some(low), Some(high))
            if is_level
                && (magnitude_bits(low) | magnitude_bits(high)) >> 27_u32.saturating_sub(divisor.shift) != 0 =>
        {
            Attempt::Unsure
        }
        (Some(low), Some(high)) => Attempt::Hit([low, high]),
        _ => Attempt::Unsure,
    }
}

/// Where the line crosses the disc of radius `r` about the origin: the point where it crosses the plane lies inside
/// where `w_x^2 + w_z^2 <= (r dy)^2`, with the line's moment `w = o x d`.
///
/// The origin is in units of `2^-extra_bits` of the radius's; the answer is in the radius's.
#[inline(always)]
pub(in crate::scalar) fn disc(o: [i32; 3], extra_bits: i32, d: [i32; 3], r: i32) -> Attempt<i32> {
    let ([x, y, z], [dx, dy, dz]) = (o, d);
    // As for a ball: a grid on which the radius has 29 bits, and the moment shifted down to it.
    let grid = leading_zeros(r as u32) as i32 - 3;
    let down = 30 + extra_bits - grid;
    if grid < 0 || !(3..32).contains(&down) {
        return Attempt::Unsure;
    }
    let down = down as u32;
    let [wx, wz] = [product(y, dz) - product(z, dy), product(x, dy) - product(y, dx)].map(i64::unsigned_abs);
    // Twice the radius or more.
    if ((wx | wz) >> 32) as u32 >> (down - 2) != 0 {
        return Attempt::Miss;
    }
    let on_grid = |minor: u64| half((((minor >> 32) as u32) << (33 - down)) | (minor as u32 >> (down - 1)));
    let [wx, wz, bounding_radius] = [on_grid(wx), on_grid(wz), high_product_signed(r << grid << 2, dy)];
    let inside = square(bounding_radius) - square(wx) - square(wz);
    // The error of each of the three is less than 4 units, in a frame with two further roundings of the origin.
    let off = if extra_bits == 0 { 4 } else { 4 + (2 << (grid - extra_bits).clamp(0, 24)) };
    let all = bounding_radius.unsigned_abs() | wx as u32 | wz as u32;
    if inside.unsigned_abs() >> 3 <= product_unsigned(all, off) {
        return Attempt::Unsure;
    }
    if inside < 0 {
        return Attempt::Miss;
    }
    let [t, _] = found!(crossings(y, extra_bits, dy, [0, 0]));
    Attempt::Hit(t)
}

/// Where the line crosses the rectangle with these half extents about the origin: as for a disc, the point where it
/// crosses the plane lies inside where `|w_z| <= h_x |dy|` and `|w_x| <= h_z |dy|`.
///
/// The origin is in units of `2^-extra_bits` of the half extents'; the answer is in theirs.
#[inline(always)]
pub(in crate::scalar) fn rectangle(o: [i32; 3], extra_bits: i32, d: [i32; 3], [hx, hz]: [i32; 2]) -> Attempt<i32> {
    let ([x, y, z], [dx, dy, dz]) = (o, d);
    if !(0..28).contains(&extra_bits) {
        return Attempt::Unsure;
    }
    // In units of 2^-(30 + extra_bits), exact except for the rounding of a framed line, which is less than two of the
    // origin's units.
    let [wx, wz] = [product(y, dz) - product(z, dy), product(x, dy) - product(y, dx)];
    let doubt = if extra_bits == 0 { 0 } else { 1_i64 << 33 };
    let mut is_inside = true;
    for (w, h) in [(wz, hx), (wx, hz)] {
        if leading_zeros(h as u32) as i32 <= extra_bits + 1 {
            return Attempt::Unsure;
        }
        let beyond = w.unsigned_abs() as i64 - (product(h << extra_bits, dy)).abs();
        if beyond > doubt {
            return Attempt::Miss;
        }
        is_inside &= beyond < -doubt;
    }
    if !is_inside {
        return Attempt::Unsure;
    }
    let [t, _] = found!(crossings(y, extra_bits, dy, [0, 0]));
    Attempt::Hit(t)
}

/// The height `oy + t dy`, rounded to the unit of `t`; the origin is in units of `2^-extra_bits` of that.
#[inline(always)]
pub(in crate::scalar) fn height(oy: i32, extra_bits: i32, dy: i32, t: i32) -> Attempt<i32> {
    // Farther away the rounding of a turned direction matters.
    if !(0..=30).contains(&extra_bits) || magnitude_bits(t) >> 24 != 0 {
        return Attempt::Unsure;
    }
    let height = round_off(((oy as i64) << (30 - extra_bits)) + product(t, dy), 30);
    if height == height as i32 as i64 { Attempt::Hit(height as i32) } else { Attempt::Unsure }
}

/// `oy - y` in units of `2^-extra_bits` of those of `y`.
#[inline(always)]
pub(in crate::scalar) fn lowered(oy: i32, extra_bits: i32, y: i32) -> Attempt<i32> {
    let lowered = oy as i64 - ((y as i64) << (extra_bits & 0x1f));
    // Up to 2^30 the moment fits.
    if lowered.unsigned_abs() >> 30 == 0 && (0..28).contains(&extra_bits) {
        Attempt::Hit(lowered as i32)
    } else {
        Attempt::Unsure
    }
}
