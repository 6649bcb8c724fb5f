//! A line and planes across the y axis.

use super::quotient::{Normalized, upper_product};
use super::{
    Digits, FINER, carried, digits, down_to_64, leading_zeros, minor, product, refined, rounded, squared, up_to_128,
    upper_bits, words,
};
use crate::scalar::{Attempt, found};

/// Where the line crosses each of the heights: `t = (y - oy) / dy`. A line of constant height crosses none of them.
///
/// The origin is in units of `2^-extra_bits` of the heights'; the answer is in the heights'.
#[inline(always)]
pub(in crate::scalar) fn crossings(oy: i64, extra_bits: i32, dy: i64, [low, high]: [i64; 2]) -> Attempt<[i64; 2]> {
    if dy == 0 {
        return Attempt::Miss;
    }
    // Up to 2^60 differences fit.
    let (Some(low), Some(high)) = (refined(low, extra_bits), refined(high, extra_bits)) else {
        return Attempt::Unsure;
    };
    if (upper_bits(oy) | upper_bits(low) | upper_bits(high)) >> 28 != 0 {
        return Attempt::Unsure;
    }
    let Some(divisor) = Normalized::new((dy as i128) << 62).map(Normalized::divisor) else {
        return Attempt::Unsure;
    };
    // The rounding error of a framed origin, a five-hundredth of a unit, is larger at the crossing if the line is
    // nearly parallel to the plane.
    if extra_bits != 0 && divisor.shift > 6 {
        return Attempt::Unsure;
    }
    match (divisor.quotient_of_length(low - oy, extra_bits), divisor.quotient_of_length(high - oy, extra_bits)) {
        (Some(low), Some(high)) => Attempt::Hit([low, high]),
        _ => Attempt::Unsure,
    }
}

/// Where the line crosses the disc of radius `r` about the origin: as with 32 bits where `w_x^2 + w_z^2 <= (r dy)^2`,
/// with the line's moment `w = o x d`.
///
/// The origin is in units of `2^-extra_bits` of the radius's; the answer is in the radius's.
#[inline(always)]
pub(in crate::scalar) fn disc(o: [i64; 3], extra_bits: i32, d: [i64; 3], r: i64) -> Attempt<i64> {
    // As for a ball: a grid on which the radius has 61 bits, and the moment shifted down to it.
    let [low, above] = words(r as u64);
    let far = upper_bits(o[0]) | upper_bits(o[1]) | upper_bits(o[2]);
    if above >= 1 << 21 || far >= 1 << 28 || !(extra_bits == 0 || extra_bits == FINER) {
        return Attempt::Unsure;
    }
    let (top, grid) = if above != 0 { (above, 0) } else { (low, 32) };
    let grid = leading_zeros(top | 1) + grid - 3;
    let less = 62 + extra_bits as u32 - grid;
    let ([x, y, z], [dx, dy, dz]) = (digits(o), digits(d));
    let [wx, wz] = [minor([y, z], [dy, dz]), minor([x, y], [dx, dy])].map(i128::unsigned_abs);
    // Twice the radius or more.
    if down_to_64((wx | wz) >> 64, less - 2) != 0 {
        return Attempt::Miss;
    }
    let on_grid = |minor: u128| (down_to_64(minor, less - 1) + 1) >> 1;
    let bounding_radius = upper_product((up_to_128(r as u64, grid) as u64) << 1, d[1].unsigned_abs() << 1);
    let (wx, wz) = (on_grid(wx), on_grid(wz));
    let square = |n: u64| squared(Digits::new(n as i64));
    let inside = square(bounding_radius) - square(wx) - square(wz);
    // The error of each of the three is less than 4 units, in a frame with two further roundings of the origin.
    let off = if extra_bits == 0 { 2 } else { grid.saturating_sub(extra_bits as u32) + 3 };
    if off > 56 || inside.unsigned_abs() <= up_to_128(bounding_radius | wx | wz, off + 3) {
        return Attempt::Unsure;
    }
    if inside < 0 {
        return Attempt::Miss;
    }
    let [t, _] = found!(crossings(o[1], extra_bits, d[1], [0, 0]));
    Attempt::Hit(t)
}

/// Where the line crosses the rectangle with these half extents about the origin: as with 32 bits where
/// `|w_z| <= h_x |dy|` and `|w_x| <= h_z |dy|`.
///
/// The origin is in units of `2^-extra_bits` of the half extents'; the answer is in theirs.
#[inline(always)]
pub(in crate::scalar) fn rectangle(o: [i64; 3], extra_bits: i32, d: [i64; 3], [hx, hz]: [i64; 2]) -> Attempt<i64> {
    let far = upper_bits(o[0]) | upper_bits(o[1]) | upper_bits(o[2]);
    let (Some(hx), Some(hz)) = (refined(hx, extra_bits), refined(hz, extra_bits)) else {
        return Attempt::Unsure;
    };
    if (far | upper_bits(hx) | upper_bits(hz)) >> 28 != 0 || !(extra_bits == 0 || extra_bits == FINER) {
        return Attempt::Unsure;
    }
    // In units of 2^-(62 + extra_bits), exact except for the rounding of a framed line, which is less than two of the
    // origin's units.
    let ([x, y, z], [dx, dy, dz]) = (digits(o), digits(d));
    let [wx, wz] = [minor([y, z], [dy, dz]), minor([x, y], [dx, dy])].map(i128::unsigned_abs);
    let doubt = if extra_bits == 0 { 0 } else { 1_i128 << 65 };
    let mut is_inside = true;
    for (w, h) in [(wz, hx), (wx, hz)] {
        let h = Digits::new(h);
        let bounding_radius = carried(product(h.high, dy.high), h.middle(dy), product(h.low, dy.low) as i128).abs();
        let beyond = w as i128 - bounding_radius;
        if beyond > doubt {
            return Attempt::Miss;
        }
        is_inside &= beyond < -doubt;
    }
    if !is_inside {
        return Attempt::Unsure;
    }
    let [t, _] = found!(crossings(o[1], extra_bits, d[1], [0, 0]));
    Attempt::Hit(t)
}

/// The height `oy + t dy`, rounded to the unit of `t`; the origin is in units of `2^-extra_bits` of that.
#[inline(always)]
pub(in crate::scalar) fn height(oy: i64, extra_bits: i32, dy: i64, t: i64) -> Attempt<i64> {
    // Up to 2^60 the sum fits, and up to 2^52 it does in the units of a frame.
    if (upper_bits(oy) | upper_bits(t)) >> 28 != 0
        || !(extra_bits == 0 || extra_bits == FINER && upper_bits(t) >> 20 == 0)
    {
        return Attempt::Unsure;
    }
    let (t, dy) = (Digits::new(t), Digits::new(dy));
    let climbed = carried(product(t.high, dy.high), t.middle(dy), product(t.low, dy.low) as i128);
    let climbed = if extra_bits == 0 { climbed } else { climbed << FINER };
    Attempt::Hit(rounded(((oy as i128) << 62) + climbed, extra_bits))
}

/// `oy - y` in units of `2^-extra_bits` of those of `y`.
#[inline(always)]
pub(in crate::scalar) fn lowered(oy: i64, extra_bits: i32, y: i64) -> Attempt<i64> {
    // Up to 2^60 the difference fits, and so does its moment.
    match refined(y, extra_bits) {
        Some(y) if (upper_bits(oy) | upper_bits(y)) >> 28 == 0 => Attempt::Hit(oy - y),
        _ => Attempt::Unsure,
    }
}
