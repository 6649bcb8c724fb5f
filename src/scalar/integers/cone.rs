//! A line and the side of a cone, on the grid of fixed point. The words of the comments are those of
//! [`integers`](super).

use super::length::{Length, Normalized, Product};
use super::roots::{self, OnGrid, Roots, along, other_root};
use crate::scalar::{Attempt, InSide, found};

/// A nappe: where `h rho <= s r + g y`, at the distance `rho` from the y axis. Only the ratios of `s`, `g` and `h`
/// matter; `s` is at least `h`.
#[derive(Clone, Copy)]
pub(in crate::scalar) struct Nappe<N> {
    r: N,
    s: N,
    g: N,
    h: N,
}

impl<N: Length> Nappe<N> {
    /// It has the radius `r` at `y = 0`, which grows by `g` over the height `h`.
    #[inline(always)]
    pub(in crate::scalar) const fn of_radii([r, g, h]: [N; 3]) -> Self {
        Self { r, s: h, g, h }
    }

    /// It touches a ball about the origin and one about `(0, height, 0)`, if neither holds the other: with the sine
    /// `(base - top) / height` of half its angle, `cos rho = base - sin y`.
    ///
    /// The root is rounded down to a whole number, which moves a length of the grid by half a unit at most.
    #[inline(always)]
    pub(in crate::scalar) fn around([base, top]: [N; 2], height: N) -> Option<Self> {
        let growth = top - base;
        if growth.max(-growth) >= height {
            return None;
        }
        let free = N::zeros([height - N::from(1)]);
        if free < 2 {
            return None;
        }
        let (s, g) = (height.up(free - 2), growth.up(free - 2));
        let square = N::squared_length([s]) - N::squared_length([g]);
        if N::high(square) <= N::ZERO {
            return None;
        }
        // It may be off by one, with 64 bits by nine.
        let mut h = N::root(square);
        while N::squared_length([h]) > square {
            h = h - N::from(1);
        }
        while N::squared_length([h + N::from(1)]) <= square {
            h = h + N::from(1);
        }
        Some(Self { r: base, s, g, h })
    }
}

/// A line in the coordinates `X = h x`, `Z = h z`, `Y = s r + g y`, in which a [`Nappe`] is `X^2 + Z^2 <= Y^2` with
/// `Y >= 0`. Along the line `X^2 + Z^2 - Y^2 = a t^2 + 2 k t + c`.
#[derive(Clone, Copy)]
struct Scaled<N: Length> {
    line: OnGrid<N>,
    a: N::Product,
    /// The leading digits of `a`.
    digits: N::Normalized,
}

impl<N: Length> Scaled<N> {
    /// The line of [`OnGrid::new`].
    // Not inlined: a shape that may be any cone would contain it twice.
    #[inline(never)]
    fn new(o: [N; 3], extra_bits: i32, d: [N; 3], nappe: Nappe<N>, departs: bool, is_strict: bool) -> Attempt<Self> {
        // They are shifted so that the largest is at least 1/2 and at most 1.
        let free = N::zeros([nappe.g, nappe.s - N::from(1)]);
        if free < 2 {
            return Attempt::Unsure;
        }
        let [s, g, h] = [nappe.s, nappe.g, nappe.h].map(|ratio| ratio.up(free - 2));
        let (line, [r, _]) = found!(OnGrid::new(o, extra_bits, d, [nappe.r, N::ZERO], departs, is_strict));
        let [x, y, z] = line.point;
        let point = [along(x, h), along(r, s) + along(y, g), along(z, h)];
        let [dx, dy, dz] = [along(d[0], h), along(d[1], g), along(d[2], h)];

        let a = N::squared_length([dx, dz]) - N::squared_length([dy]);
        let Some(digits) = N::Normalized::new(a) else {
            return Attempt::Unsure;
        };
        Attempt::Hit(Self { line: OnGrid { point, direction: [dx, dy, dz], ..line }, a, digits })
    }

    #[inline(always)]
    fn is_steep(&self) -> bool {
        roots::is_steep::<N>(self.a)
    }

    #[inline(always)]
    fn k(&self) -> N::Product {
        let ([x, y, z], [dx, dy, dz]) = (self.line.point, self.line.direction);
        N::dot([x, z], [dx, dz]) - N::dot([y], [dy])
    }

    /// Whether the point halfway between the roots, at `t = -k / a`, is in the nappe with `Y >= 0`, for `a > 0`: the
    /// sign of `Y` there is that of `Y a - dY k`.
    #[inline(always)]
    fn is_middle_inside(&self, k: N::Product) -> Attempt<bool> {
        let (a, k) = (N::high(self.a << 2), N::high(k << 2));
        let middle = N::minor([self.line.point[1], self.line.direction[1]], [k, a]);
        // If strict: the sum of the errors of Y a and dY k is at most 2^(BITS + 3), and 2^(BITS - 0.6) more for each
        // unit of error of a framed origin.
        let doubtful = if self.line.is_strict { 4.max(2 + self.line.framed_bits()) } else { 2 };
        if middle.magnitude() >> (N::BITS + doubtful) == N::Product::ZERO {
            Attempt::Unsure
        } else {
            Attempt::Hit(N::high(middle) >= N::ZERO)
        }
    }

    /// Both nappes. The discriminant is `D = Wx^2 + Wz^2 - Wy^2` of the line's Pluecker moment `W`.
    // Not inlined, as above.
    #[inline(never)]
    fn roots(&self) -> Attempt<Roots<N>> {
        let ([x, y, z], [dx, dy, dz]) = (self.line.point, self.line.direction);
        let w = [N::minor([y, z], [dy, dz]), N::minor([z, x], [dz, dx]), N::minor([x, y], [dx, dy])].map(N::nearest);
        let [wx, wy, wz] = w;
        let discriminant = N::squared_length([wx, wz]) - N::squared_length([wy]);
        let [p, q, r] = w.map(|w| N::Product::from(w).magnitude());
        Roots::new(self.line, (self.a, self.digits), || self.k(), discriminant, p + q + r)
    }
}

/// Where the line is inside the nappe.
///
/// The origin is in units of `2^-extra_bits` of the unit of the sizes; the answer is in the unit of the sizes.
#[inline(always)]
pub(in crate::scalar) fn nappe<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    nappe: Nappe<N>,
    is_strict: bool,
) -> Attempt<InSide<N>> {
    let line = found!(Scaled::new(o, extra_bits, d, nappe, false, is_strict));
    let cone = found!(line.roots());
    if line.is_steep() {
        // A half-line lies in each nappe. Along the one in this nappe, away from the other, Y grows.
        return if line.line.direction[1] > N::ZERO {
            cone.between(cone.first(), (N::MAX, true))
        } else {
            cone.between((-N::MAX, true), cone.second())
        };
    }
    if found!(line.is_middle_inside(cone.k)) { cone.between(cone.first(), cone.second()) } else { Attempt::Miss }
}

/// Where the line is inside both nappes of the cone of slope `g / h` about its apex at the origin: between its ends, or
/// (`true`) before the first and after the second.
#[inline(always)]
pub(in crate::scalar) fn double_cone<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    [g, h]: [N; 2],
    is_strict: bool,
) -> Attempt<([N; 2], bool)> {
    let line = found!(Scaled::new(o, extra_bits, d, Nappe::of_radii([N::ZERO, g, h]), false, is_strict));
    let cone = found!(line.roots());
    match (cone.first(), cone.second()) {
        ((first, true), (second, true)) if line.is_steep() => Attempt::Hit(([second, first], true)),
        ((first, true), (second, true)) => Attempt::Hit(([first, second], false)),
        _ => Attempt::Unsure,
    }
}

/// Where a line that begins in the side of [`nappe`] leaves that nappe: the other root of `a t^2 + 2 k t`, whatever its
/// rounded coordinates are; infinite if it does not leave it.
#[inline]
pub(in crate::scalar) fn exit_from_nappe<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    nappe: Nappe<N>,
    is_strict: bool,
) -> Attempt<N> {
    let line = found!(Scaled::new(o, extra_bits, d, nappe, true, is_strict));
    let k = line.k();
    let Some((t, is_near)) = other_root(&line.line, line.digits, k) else { return Attempt::Unsure };
    if line.is_steep() {
        // A half-line lies in each nappe, and that of this nappe has no end.
        let leads_in = t < -N::from(1) && line.line.direction[1] > N::ZERO;
        return if leads_in { Attempt::Hit(N::MAX) } else { Attempt::Unsure };
    }
    if N::ZERO < t && is_near && found!(line.is_middle_inside(k)) { Attempt::Hit(t) } else { Attempt::Unsure }
}
