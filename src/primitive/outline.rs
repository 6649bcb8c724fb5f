//! The outline of a cone, and the quadric that it sweeps out.
//!
//! One outline serves all cones: at height `y` the radius is `(g0 + g1 y) / h`. A cone given by its slope `m` has
//! `g0 = 0`, `g1 = m`, `h = 1`; a frustum given by two radii and a height has `g0 = r0 h`, `g1 = r1 - r0`, so that no slope is
//! rounded. With `g = g0 + g1 oy` and `g' = g1 dy` the quadric is `h^2 (x^2 + z^2) - (g0 + g1 y)^2`, and
//!
//! - `a = h^2 (dx^2 + dz^2) - g'^2`, `k = h^2 (ox dx + oz dz) - g g'`, `c = h^2 (ox^2 + oz^2) - g^2`
//! - `D = h^2 [ (g1 wz - g0 dx)^2 + (g1 wx + g0 dz)^2 - (h wy)^2 ]`, `w = o x d`
//!
//! which for a slope is `D = m^2 (wx^2 + wz^2) - wy^2`: Lagrange's identity in the metric (1, -1, 1) of the cone.

use crate::quadric::Careful;
use crate::scalar::{Real, Scalar};

/// The outline: how the radius grows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) enum Outline<S> {
    /// From the apex at the origin: radius over height.
    Slope(S),
    /// From the base radius to the top radius over the height.
    Radii(S, S, S),
}

/// The outline in the computing number: the radius at `y` is `(base h + (top - base) y) / h`. A slope is the
/// outline with base 0, top `m` and height 1.
#[derive(Clone, Copy)]
pub(super) struct Profile<R> {
    pub(super) base: R,
    pub(super) top: R,
    pub(super) h: R,
}

/// A point, or a direction (for which the outline's constant `g0` does not count).
#[derive(Clone, Copy)]
pub(super) struct Homogeneous<R> {
    pub(super) v: [R; 3],
    /// What the rounding of `v` left over.
    pub(super) rest: [R; 3],
    pub(super) is_point: bool,
}

impl<R: Real> Profile<R> {
    pub(super) fn of<S: Scalar>(outline: Outline<S>, real: impl Fn(S) -> R) -> Self {
        match outline {
            Outline::Slope(slope) => Self { base: R::ZERO, top: real(slope), h: R::ONE },
            Outline::Radii(base, top, height) => Self { base: real(base), top: real(top), h: real(height) },
        }
    }

    pub(super) fn g0(self) -> R {
        self.base * self.h
    }

    pub(super) fn g1(self) -> R {
        self.top - self.base
    }

    /// `g0 + g1 y`
    pub(super) fn at(self, y: R) -> R {
        self.g0() + self.g1() * y
    }

    /// `h x`, `h z` and `g`, each as a rounded value and what the rounding left over.
    pub(super) fn factors(self, p: Homogeneous<R>) -> [[R; 2]; 3] {
        let ([x, y, z], [u, v, w]) = (p.v, p.rest);
        let constant = if p.is_point { self.h } else { R::ZERO };
        let g =
            R::sum_with_rest([[self.base, constant], [self.top, y], [-self.base, y], [self.top, v], [-self.base, v]]);
        [R::sum_with_rest([[self.h, x], [self.h, u]]), g, R::sum_with_rest([[self.h, z], [self.h, w]])]
    }

    /// The minors of (h x, g, h z) for a point and a direction, whose squares make the discriminant; each as a
    /// rounded value and what the rounding left over.
    #[cold]
    pub(super) fn minors(self, point: Homogeneous<R>, direction: Homogeneous<R>) -> [[R; 2]; 3] {
        let ([x, g, z], [dx, slope, dz]) = (self.factors(point), self.factors(direction));
        let minor = |[a, ea]: [R; 2], [b, eb]: [R; 2], [c, ec]: [R; 2], [d, ed]: [R; 2]| {
            R::sum_with_rest([[a, b], [-c, d], [ea, b], [a, eb], [-ec, d], [-c, ed]])
        };
        [minor(x, slope, g, dx), minor(z, slope, g, dz), minor(x, dz, z, dx)]
    }

    /// `h^2 (px qx + pz qz) - g(p) g(q)`, held to twice the precision: near a generator and near the surface the two
    /// products cancel.
    #[cold]
    pub(super) fn bilinear(self, p: Homogeneous<R>, q: Homogeneous<R>) -> R {
        let ([[px, ex], [pg, eg], [pz, ez]], [[qx, fx], [qg, fg], [qz, fz]]) = (self.factors(p), self.factors(q));
        R::sum_of_products([
            [px, qx],
            [-pg, qg],
            [pz, qz],
            [ex, qx],
            [px, fx],
            [-eg, qg],
            [-pg, fg],
            [ez, qz],
            [pz, fz],
        ])
    }
}

/// What the careful coefficients of a cone are made of.
pub(super) struct CarefulCone<R> {
    pub(super) profile: Profile<R>,
    pub(super) point: Homogeneous<R>,
    pub(super) direction: Homogeneous<R>,
}

impl<R: Real> Careful<R> for CarefulCone<R> {
    fn k(&self) -> R {
        self.profile.bilinear(self.point, self.direction)
    }

    fn c(&self) -> R {
        self.profile.bilinear(self.point, self.point)
    }

    #[cold]
    fn discriminant(&self) -> R {
        let [[p, ep], [q, eq], [r, er]] = self.profile.minors(self.point, self.direction);
        let twice = |e: R| e.times_power_of_two(1);
        R::sum_of_products([[p, p], [q, q], [-r, r], [twice(ep), p], [twice(eq), q], [twice(-er), r]])
    }
}
