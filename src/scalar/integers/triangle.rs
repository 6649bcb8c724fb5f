//! A line and a triangle.

use super::quotient::Normalized;
use super::{leading_zeros, magnitude_bits, product};
use crate::scalar::attempt::within_edges_in_turn;
use crate::scalar::{Attempt, found};

/// `a . b`
#[inline(always)]
fn dot([x, y, z]: [i32; 3], [u, v, w]: [i32; 3]) -> i64 {
    product(x, u) + product(y, v) + product(z, w)
}

/// `a x b`
#[inline(always)]
fn cross([x, y, z]: [i32; 3], [u, v, w]: [i32; 3]) -> [i64; 3] {
    [product(y, w) - product(z, v), product(z, u) - product(x, w), product(x, v) - product(y, u)]
}

/// Where the line crosses the triangle, and whether it comes from the front; the signs as in `solve::flat`, with the
/// line's origin as the origin, so that the volume of an edge from `p` to `q` is `d . (p x q) = q . (d x p)`.
///
/// The origin is in units of `2^-extra_bits` of the vertices'; the answer is in the vertices'.
#[inline(always)]
pub(in crate::scalar) fn triangle(
    o: [i32; 3],
    extra_bits: i32,
    d: [i32; 3],
    vertices: [[i32; 3]; 3],
) -> Attempt<(i32, bool)> {
    // Exact, in the origin's unit, with 30 bits.
    let mut all = 0;
    let mut from_origin = |v: i32, o: i32| {
        let length = ((v as i64) << (extra_bits & 0x1f)) - o as i64;
        all |= (length ^ (length >> 63)) as u64;
        length as i32
    };
    let [a, b, c] = vertices.map(|[x, y, z]| [from_origin(x, o[0]), from_origin(y, o[1]), from_origin(z, o[2])]);
    if all >> 30 != 0 {
        return Attempt::Unsure;
    }
    // On a grid on which none has more than 28 bits, truncated by less than one unit. The error of a framed origin is
    // half of its own unit, so that a finer grid would gain nothing.
    let bits = 32 - leading_zeros(all as u32 | 1);
    let up = if extra_bits == 0 { 28 - bits as i32 } else { 0 };
    let cut = bits.saturating_sub(28);
    let on_grid = |vertex: [i32; 3]| vertex.map(|length| if up > 0 { length << up } else { length >> cut });
    let corners = [on_grid(a), on_grid(b), on_grid(c)];
    // The error of a component of d x p is less than 16 (twice 4 from the truncation of p, and as much from a framed
    // origin and direction), that of one of q less than 2. Together that is less than 2^7 times the largest q, or a
    // fourth of the largest d x p.
    let doubt = 1_i64 << if up > 0 { 35 } else { bits - cut + 7 };
    let volume = |(p, q): ([i32; 3], [i32; 3])| {
        // d x p in fourths of the grid's unit.
        let moment = cross(d, p).map(|component| (component >> 28) as i32);
        dot(q, moment)
    };
    let [p, q, r] = corners;
    let from_front = found!(within_edges_in_turn([(p, q), (q, r), (r, p)], doubt, volume));
    crossing(a, extra_bits, d, vertices, from_front)
}

/// Where the line crosses the plane of a triangle that it meets, `t = a . n / d . n`, from a vertex `a` seen from its
/// origin.
#[inline(always)]
fn crossing(
    a: [i32; 3],
    extra_bits: i32,
    d: [i32; 3],
    [u, v, w]: [[i32; 3]; 3],
    from_front: bool,
) -> Attempt<(i32, bool)> {
    let edge = |from: [i32; 3], to: [i32; 3]| {
        [to[0].wrapping_sub(from[0]), to[1].wrapping_sub(from[1]), to[2].wrapping_sub(from[2])]
    };
    let edges = [edge(u, v), edge(u, w)];
    let all = edges.into_iter().flatten().fold(0, |all, component| all | magnitude_bits(component));
    if all >> 30 != 0 {
        return Attempt::Unsure;
    }
    // The normal, exact except for its last bit, as 2^31 times a number of 30 bits, and a remainder.
    let normal = cross(edges[0], edges[1]);
    let longest = normal.into_iter().fold(0, |all, component| all | component.unsigned_abs());
    let scaled = normal.map(|component| component << (longest.leading_zeros().saturating_sub(2) & 0x3f) >> 1);
    let (high, low) = (scaled.map(|n| (n >> 31) as i32), scaled.map(|n| (n & 0x7fff_ffff) as i32));
    let along = |vector: [i32; 3]| dot(high, vector) + (dot(low, vector) >> 31);
    let (distance, slope) = (along(a), along(d));
    let Some(digits) = Normalized::new(slope).filter(|_| (slope < 0) == from_front) else {
        return Attempt::Unsure;
    };
    // The errors of a framed origin and direction, half of the origin's unit and 2^-31, are larger at the crossing if
    // the line is nearly parallel to the plane.
    if extra_bits != 0 && digits.shift as i32 > extra_bits - 4 {
        return Attempt::Unsure;
    }
    let farthest = if extra_bits == 0 { 1 << 28 } else { (1 << 26) >> digits.shift };
    let t = digits.divisor().long_quotient(distance, (30 + extra_bits) as u32);
    if -farthest < t && t < farthest { Attempt::Hit((t as i32, from_front)) } else { Attempt::Unsure }
}
