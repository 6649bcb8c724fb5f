//! A line and a triangle.

use super::length::{Divisor, Length, Normalized, Product};
use crate::scalar::{Attempt, found};
use core::ops::Neg;

/// `a x b`
#[inline(always)]
fn cross<N: Length>([x, y, z]: [N; 3], [u, v, w]: [N; 3]) -> [N::Product; 3] {
    [N::minor([y, z], [v, w]), N::minor([z, x], [w, u]), N::minor([x, y], [u, v])]
}

/// Whether the line hits a triangle, and whether from the front, by the signed volume that it spans with each edge, and
/// the error bound of the volumes. All three are negative for a hit from the front, and positive for one from the back.
/// They are computed one after the other: a miss is often decided by the first two.
#[inline(always)]
fn within_edges_in_turn<E, V: Copy + PartialOrd + Neg<Output = V>>(
    [first, second, third]: [E; 3],
    doubt: V,
    volume: impl Fn(E) -> V,
) -> Attempt<bool> {
    let side = |edge: E| {
        let volume = volume(edge);
        (volume > doubt) as i32 - (volume < -doubt) as i32
    };
    let (first, second) = (side(first), side(second));
    if first * second < 0 {
        return Attempt::Miss;
    }
    let third = side(third);
    if third * first < 0 || third * second < 0 {
        Attempt::Miss
    } else if first * second * third != 0 {
        Attempt::Hit(third < 0)
    } else {
        Attempt::Unsure
    }
}

/// Where the line crosses the triangle, and whether it comes from the front; the signs as in `solve::flat`, with the
/// line's origin as the origin, so that the volume of an edge from `p` to `q` is `d . (p x q) = q . (d x p)`.
///
/// The origin is in units of `2^-extra_bits` of the vertices'; the answer is in the vertices'.
#[inline(always)]
pub(in crate::scalar) fn triangle<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    vertices: [[N; 3]; 3],
) -> Attempt<(N, bool)> {
    // Exact, in the origin's unit.
    let Some((seen, free)) = N::seen_from(vertices, o, extra_bits) else {
        return Attempt::Unsure;
    };
    // On a grid on which `spare` bits are free, truncated by less than one unit. The error of a framed origin is half
    // of its own unit, so that a finer grid would gain nothing.
    let spare = 6 - N::MOMENT_BITS;
    let up = if extra_bits == 0 { free.saturating_sub(spare) } else { 0 };
    let cut = spare.saturating_sub(free);
    let on_grid = |vertex: [N; 3]| vertex.map(|length| if up > 0 { length.up(up) } else { length.down(cut) });
    let [p, q, r] = seen.map(on_grid);
    // The error of a component of d x p is less than 4 units of the grid (2 from the truncation of p, and as much from
    // a framed origin and direction), that of one of q less than 2. The moment has MOMENT_BITS further bits: together
    // that is less than 2^(5 + MOMENT_BITS) times the largest q.
    let bits = if up > 0 { N::BITS - spare } else { N::BITS - free - cut };
    let doubt = N::Product::ONE << (bits + 5 + N::MOMENT_BITS);
    let volume = |(p, q): ([N; 3], [N; 3])| {
        let moment = cross(d, p).map(|component| N::low(component >> (N::FRACTION - N::MOMENT_BITS)));
        N::dot(q, moment)
    };
    let from_front = found!(within_edges_in_turn([(p, q), (q, r), (r, p)], doubt, volume));
    crossing(seen[0], extra_bits, d, vertices, from_front)
}

/// Where the line crosses the plane of a triangle that it meets, `t = a . n / d . n`, from a vertex `a` seen from its
/// origin.
#[inline(always)]
fn crossing<N: Length>(
    a: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    [u, v, w]: [[N; 3]; 3],
    from_front: bool,
) -> Attempt<(N, bool)> {
    let edge = |from: [N; 3], to: [N; 3]| [to[0].apart(from[0]), to[1].apart(from[1]), to[2].apart(from[2])];
    let edges = [edge(u, v), edge(u, w)];
    if !edges.into_iter().all(N::have_products) {
        return Attempt::Unsure;
    }
    // The normal, exact except for its last bits, as a power of two times an upper part, and a remainder.
    let (zeros, low_bits) = N::NORMAL;
    let normal = cross(edges[0], edges[1]);
    let [x, y, z] = normal.map(Product::magnitude);
    let up = (x | y | z).zeros().saturating_sub(zeros);
    let scaled = normal.map(|component| component << up);
    let upper = scaled.map(|component| N::low(component >> low_bits));
    let lower = scaled.map(|component| N::low(component.lowest(low_bits)));
    let along = |vector: [N; 3]| N::dot(upper, vector) + (N::dot(lower, vector) >> low_bits);
    let (distance, slope) = (along(a), along(d));
    let is_sign_kept = (slope < N::Product::ZERO) == from_front;
    let Some(digits) = N::Normalized::new(slope).filter(|_| is_sign_kept) else {
        return Attempt::Unsure;
    };
    // The errors of a framed origin and direction, half of the origin's unit and 2^-(BITS - 1), are larger at the
    // crossing if the line is nearly parallel to the plane: they must not exceed an eighth and a sixteenth of a unit.
    // Where it crosses the plane at a right angle, the slope has the bits of the normal's upper part.
    let shift = digits.shift() + (N::BITS + 1) as i32 - (zeros + low_bits) as i32;
    if extra_bits != 0 && shift > extra_bits - 3 {
        return Attempt::Unsure;
    }
    match digits.divisor().quotient(distance, extra_bits as u32) {
        Some(t) if extra_bits == 0 || t.top() >> (26 - shift) == 0 => Attempt::Hit((t, from_front)),
        _ => Attempt::Unsure,
    }
}
