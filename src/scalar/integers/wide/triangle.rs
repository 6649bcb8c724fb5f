//! A line and a triangle.

use super::quotient::Normalized;
use super::{Digits, digits, dot, leading_zeros_of_64, minor, refined, upper_bits};
use crate::scalar::attempt::within_edges_in_turn;
use crate::scalar::{Attempt, found};

/// Bits of a vertex on the grid of the edges.
const GRID: u32 = 59;

/// `a x b`
#[inline(always)]
fn cross([x, y, z]: [Digits; 3], [u, v, w]: [Digits; 3]) -> [i128; 3] {
    [minor([y, z], [v, w]), minor([z, x], [w, u]), minor([x, y], [u, v])]
}

/// Where the line crosses the triangle, and whether it comes from the front; as with 32 bits.
///
/// The origin is in units of `2^-extra_bits` of the vertices'; the answer is in the vertices'.
#[inline(always)]
pub(in crate::scalar) fn triangle(
    o: [i64; 3],
    extra_bits: i32,
    d: [i64; 3],
    vertices: [[i64; 3]; 3],
) -> Attempt<(i64, bool)> {
    // Exact, in the origin's unit.
    let (mut all, mut fits) = (0, true);
    let mut from_origin = |v: i64, o: i64| {
        let Some(v) = refined(v, extra_bits) else {
            fits = false;
            return 0;
        };
        fits &= (upper_bits(v) | upper_bits(o)) >> 28 == 0;
        let length = v.wrapping_sub(o);
        all |= (length ^ (length >> 63)) as u64;
        length
    };
    let [a, b, c] = vertices.map(|[x, y, z]| [from_origin(x, o[0]), from_origin(y, o[1]), from_origin(z, o[2])]);
    if !fits {
        return Attempt::Unsure;
    }
    // On a grid on which none has more than 59 bits, truncated by less than one unit. The error of a framed origin is
    // half of its own unit, so that a finer grid would gain nothing.
    let bits = 64 - leading_zeros_of_64(all | 1);
    let up = if extra_bits == 0 { GRID as i32 - bits as i32 } else { 0 };
    let cut = bits.saturating_sub(GRID);
    let on_grid = |vertex: [i64; 3]| vertex.map(|length| if up > 0 { length << up } else { length >> cut });
    let corners = [on_grid(a), on_grid(b), on_grid(c)].map(digits);
    let direction = digits(d);
    // The error of a component of d x p is less than 8 (twice 2 from the truncation of p, and as much from a framed
    // origin and direction), that of one of q less than 2. Together that is less than 2^6 times the largest q, or half
    // the largest d x p.
    let doubt = 1_i128 << if up > 0 { GRID + 6 } else { bits - cut + 6 };
    let volume = |(p, q): ([Digits; 3], [Digits; 3])| {
        // d x p in halves of the grid's unit.
        let moment = digits(cross(direction, p).map(|component| (component >> 61) as i64));
        dot(q, moment)
    };
    let [p, q, r] = corners;
    let from_front = found!(within_edges_in_turn([(p, q), (q, r), (r, p)], doubt, volume));
    crossing(a, extra_bits, direction, vertices, from_front)
}

/// Where the line crosses the plane of a triangle that it meets, `t = a . n / d . n`, from a vertex `a` seen from its
/// origin.
#[inline(always)]
fn crossing(
    a: [i64; 3],
    extra_bits: i32,
    d: [Digits; 3],
    [u, v, w]: [[i64; 3]; 3],
    from_front: bool,
) -> Attempt<(i64, bool)> {
    let edge = |from: [i64; 3], to: [i64; 3]| {
        [to[0].wrapping_sub(from[0]), to[1].wrapping_sub(from[1]), to[2].wrapping_sub(from[2])]
    };
    let edges = [edge(u, v), edge(u, w)];
    if edges.into_iter().flatten().fold(0, |all, component| all | upper_bits(component)) >> 28 != 0 {
        return Attempt::Unsure;
    }
    // The normal, exact except for its last bits, as 2^61 times a number of 61 bits, and a remainder.
    let normal = cross(digits(edges[0]), digits(edges[1]));
    let longest = normal.into_iter().fold(0, |all, component| all | component.unsigned_abs());
    let up = longest.leading_zeros().saturating_sub(6) & 0x7f;
    let scaled = normal.map(|component| component << up);
    let high = digits(scaled.map(|n| (n >> 61) as i64));
    let low = digits(scaled.map(|n| n as i64 & ((1 << 61) - 1)));
    let along = |vector: [Digits; 3]| dot(high, vector) + (dot(low, vector) >> 61);
    let (distance, slope) = (along(digits(a)), along(d));
    let Some(divisor) = Normalized::new(slope).filter(|_| (slope < 0) == from_front) else {
        return Attempt::Unsure;
    };
    // The error of a framed origin, a five-hundredth of a unit, is larger at the crossing if the line is nearly
    // parallel to the plane. (A normal of 61 bits has a shift of 1 or 2.)
    if extra_bits != 0 && divisor.shift > 8 {
        return Attempt::Unsure;
    }
    match divisor.divisor().quotient(distance, extra_bits) {
        Some(t) if upper_bits(t) >> 20 == 0 => Attempt::Hit((t, from_front)),
        _ => Attempt::Unsure,
    }
}
