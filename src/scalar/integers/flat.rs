//! A line and planes across the y axis.

use super::length::{Divisor, Length, Normalized, Product};
use super::radius_grid;
use crate::scalar::{Attempt, found};

/// How a line crosses planes across the y axis.
struct Across<N: Length> {
    oy: N,
    extra_bits: i32,
    divisor: <N::Normalized as Normalized<N>>::Divisor,
    shift: i32,
    is_level: bool,
}

impl<N: Length> Across<N> {
    #[inline(always)]
    fn new(oy: N, extra_bits: i32, dy: N) -> Attempt<Self> {
        if dy == N::ZERO {
            return Attempt::Miss;
        }
        let Some(divisor) = N::Normalized::new(dy.at_unit()) else {
            return Attempt::Unsure;
        };
        // The rounding error of a framed origin, half of its own unit, is larger at the crossing if the line is nearly
        // parallel to the plane; it must not exceed an eighth of a unit.
        let shift = divisor.shift();
        let is_level = extra_bits != 0 && shift > 3;
        if is_level && shift > extra_bits - 3 {
            return Attempt::Unsure;
        }
        Attempt::Hit(Self { oy, extra_bits, divisor: divisor.divisor(), shift, is_level })
    }

    /// `t = (y - oy) / dy`
    #[inline(always)]
    fn at(&self, y: N) -> Attempt<N> {
        match self.divisor.quotient_of_difference(y, self.oy, self.extra_bits) {
            // The rounding error of the direction, 2^-(BITS - 1) of t, grows as that of the origin.
            Some(t) if !self.is_level || t.top() >> (27 - self.shift) == 0 => Attempt::Hit(t),
            _ => Attempt::Unsure,
        }
    }
}

/// Where the line crosses a height. A line of constant height crosses none.
///
/// The origin is in units of `2^-extra_bits` of the height's; the answer is in the height's.
#[inline(always)]
pub(in crate::scalar) fn crossing<N: Length>(oy: N, extra_bits: i32, dy: N, y: N) -> Attempt<N> {
    found!(Across::new(oy, extra_bits, dy)).at(y)
}

/// Where it crosses each of two heights.
#[inline(always)]
pub(in crate::scalar) fn crossings<N: Length>(oy: N, extra_bits: i32, dy: N, [low, high]: [N; 2]) -> Attempt<[N; 2]> {
    let across = found!(Across::new(oy, extra_bits, dy));
    Attempt::Hit([found!(across.at(low)), found!(across.at(high))])
}

/// Where the line crosses the disc of radius `r` about the origin: the point where it crosses the plane lies inside
/// where `w_x^2 + w_z^2 <= (r dy)^2`, with the line's moment `w = o x d`.
///
/// The origin is in units of `2^-extra_bits` of the radius's; the answer is in the radius's.
#[inline(always)]
pub(in crate::scalar) fn disc<N: Length>(o: [N; 3], extra_bits: i32, d: [N; 3], r: N) -> Attempt<N> {
    let ([x, y, z], [dx, dy, dz]) = (o, d);
    // As for a ball, the moment is shifted down to the radius's grid.
    let Some((grid, down)) = radius_grid(r, extra_bits).filter(|_| N::have_room(o)) else {
        return Attempt::Unsure;
    };
    let [wx, wz] = [N::minor([y, z], [dy, dz]), N::minor([x, y], [dx, dy])].map(Product::magnitude);
    // Twice the radius or more.
    if N::reaches(wx | wz, down) {
        return Attempt::Miss;
    }
    let (wx, wz) = (N::rounded_off(wx, down), N::rounded_off(wz, down));
    let reach = N::portion([r.up(grid as u32)], [dy]);
    let inside = N::squared_length([reach]) - N::squared_length([wx, wz]);
    // The error of each of the three is less than 4 units, in a frame with two further roundings of the origin.
    let off = if extra_bits == 0 { 2 } else { 3 + (grid - extra_bits).max(0) as u32 };
    let longest = reach.max(-reach).max(wx).max(wz);
    if off + 5 >= N::BITS || inside.magnitude() <= longest.raised(off + 5) {
        return Attempt::Unsure;
    }
    if inside < N::Product::ZERO {
        return Attempt::Miss;
    }
    crossing(y, extra_bits, dy, N::ZERO)
}

/// Where the line crosses the rectangle with these half extents about the origin: as for a disc, the point where it
/// crosses the plane lies inside where `|w_z| <= h_x |dy|` and `|w_x| <= h_z |dy|`.
///
/// The origin is in units of `2^-extra_bits` of the half extents'; the answer is in theirs.
#[inline(always)]
pub(in crate::scalar) fn rectangle<N: Length>(o: [N; 3], extra_bits: i32, d: [N; 3], [hx, hz]: [N; 2]) -> Attempt<N> {
    let ([x, y, z], [dx, dy, dz]) = (o, d);
    let (Some(hx), Some(hz)) = (hx.refined(extra_bits), hz.refined(extra_bits)) else {
        return Attempt::Unsure;
    };
    if !N::have_room(o) {
        return Attempt::Unsure;
    }
    // Exact except for the rounding of a framed line, which is less than two of the origin's units.
    let [wx, wz] = [N::minor([y, z], [dy, dz]), N::minor([x, y], [dx, dy])];
    let doubt = if extra_bits == 0 { N::Product::ZERO } else { N::Product::ONE << (N::BITS + 1) };
    let mut is_inside = true;
    for (w, h) in [(wz, hx), (wx, hz)] {
        let beyond = w.magnitude() - N::dot([h], [dy]).magnitude();
        if beyond > doubt {
            return Attempt::Miss;
        }
        is_inside &= beyond < -doubt;
    }
    if !is_inside {
        return Attempt::Unsure;
    }
    crossing(y, extra_bits, dy, N::ZERO)
}

/// The height `oy + t dy`, rounded to the unit of `t`; the origin is in units of `2^-extra_bits` of that.
#[inline(always)]
pub(in crate::scalar) fn height<N: Length>(oy: N, extra_bits: i32, dy: N, t: N) -> Attempt<N> {
    // Farther away the rounding of a turned direction matters.
    if t.top() >> 24 != 0 || !N::have_room([N::ZERO, oy, N::ZERO]) {
        return Attempt::Unsure;
    }
    // With these bounds it fits.
    let above = oy.max(-oy).raised((N::FRACTION as i32 - extra_bits) as u32);
    let height = if oy < N::ZERO { -above } else { above } + N::dot([t], [dy]);
    Attempt::Hit(N::nearest(height))
}
