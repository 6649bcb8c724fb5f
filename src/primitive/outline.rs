//! The outline of a cone (its radius as a function of the height), and the quadric of revolution that follows from it.
//!
//! All cones have one form of outline: at height `y` the radius is `(g0 + g1 y) / h`. A cone given by its slope `m` has
//! `g0 = 0`, `g1 = m`, `h = 1`; a frustum given by two radii and a height has `g0 = r0 h`, `g1 = r1 - r0`, so that no
//! slope is rounded. With `g = g0 + g1 oy` and `g' = g1 dy` the quadric is `h^2 (x^2 + z^2) - (g0 + g1 y)^2`, and
//!
//! - `a = h^2 (dx^2 + dz^2) - g'^2`, `k = h^2 (ox dx + oz dz) - g g'`, `c = h^2 (ox^2 + oz^2) - g^2`
//! - `D = h^2 [ (g1 wz - g0 dx)^2 + (g1 wx + g0 dz)^2 - (h wy)^2 ]`, `w = o x d`
//!
//! where `w` is the line's Pluecker moment. For a slope that is `D = m^2 (wx^2 + wz^2) - wy^2`: Lagrange's identity in
//! the metric (1, -1, 1) of the cone.

use super::SizeError;
use crate::scalar::{Real, Scalar, ValueError};
pub(super) use crate::solve::Outline;

/// The outline in the computing number: the radius at `y` is `(base h + (top - base) y) / h`. A slope is the
/// outline with base 0, top `m` and height 1.
#[derive(Clone, Copy)]
pub(super) struct Profile<R> {
    pub(super) base: R,
    pub(super) top: R,
    pub(super) h: R,
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
}

/// The outline of a cone of this slope, if that is within the budget.
pub(super) fn checked_slope<S: Scalar>(slope: S) -> Result<Outline<S>, SizeError> {
    // The comparison is false for NaN.
    if slope >= S::BUDGET.smallest_slope && slope <= S::BUDGET.slope {
        Ok(Outline::Slope(slope))
    } else {
        Err(SizeError::Slope(ValueError::of_size(slope, S::BUDGET.smallest_slope)))
    }
}
