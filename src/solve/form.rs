//! The line and the quadrics along it.

use crate::number::{Ring, cross};
use crate::part::Part;
use crate::ray::Leaving;

/// A line in a primitive's frame. Its direction has any length: `t` is the parameter of the ray as stored.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<N> {
    pub(crate) origin: [N; 3],
    pub(crate) direction: [N; 3],
    /// The part that it departs from at `t = 0`, and the side to which it leaves.
    pub(crate) departure: Option<(Part, Leaving)>,
}

impl<N> Line<N> {
    pub(super) fn departs_from(&self, part: Part) -> bool {
        self.departure.is_some_and(|(from, _)| from == part)
    }
}

/// A point in homogeneous coordinates `(v, w)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Homogeneous<N> {
    pub(super) v: [N; 3],
    pub(super) w: Weight<N>,
}

/// What a point's coordinates are to be divided by.
#[derive(Clone, Copy, Debug)]
pub(super) enum Weight<N> {
    /// Nothing: it is a direction.
    Zero,
    /// One: they are the coordinates.
    One,
    /// This.
    By(N),
}

impl<N: Ring> Weight<N> {
    /// The number times the weight.
    #[inline(always)]
    fn times(self, number: N) -> N {
        match self {
            Self::Zero => N::ZERO,
            Self::One => number,
            Self::By(w) => number * w,
        }
    }
}

/// A quadric as a bilinear form `f(p, q)`, with `f(p, p) <= 0` inside.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form<N> {
    /// `x x' + y y' + z z' - r w r w'`
    Ball { r: N },
    /// `x x' + z z' - r w r w'`
    Tube { r: N },
    /// `h^2 (x x' + z z') - g g'` with the outline `g = g0 w + g1 y`: the radius at `y` is `g / h`.
    Cone { h: N, g0: N, g1: N },
}

impl<N: Ring> Form<N> {
    /// A cone of this slope.
    #[inline(always)]
    pub(super) fn slope(slope: N) -> Self {
        Self::Cone { h: N::ONE, g0: N::ZERO, g1: slope }
    }

    /// A cone through two radii.
    #[inline(always)]
    pub(super) fn radii(base: N, top: N, height: N) -> Self {
        Self::Cone { h: height, g0: base * height, g1: top - base }
    }

    /// The outline `g0 w + g1 y`; constant but for a cone.
    #[inline(always)]
    pub(super) fn outline(self, p: Homogeneous<N>) -> N {
        match self {
            Self::Ball { r } | Self::Tube { r } => p.w.times(r),
            Self::Cone { g0, g1, .. } => match p.w {
                Weight::Zero => g1 * p.v[1],
                Weight::One => N::sum([[g0, N::ONE], [g1, p.v[1]]]),
                Weight::By(w) => N::sum([[g0, w], [g1, p.v[1]]]),
            },
        }
    }

    /// `f(p, q)`
    #[inline(always)]
    pub(super) fn of(self, p: Homogeneous<N>, q: Homogeneous<N>) -> N {
        let ([x, y, z], [u, v, w]) = (p.v, q.v);
        match self {
            Self::Ball { r } => N::sum([[x, u], [y, v], [z, w], [-p.w.times(r), q.w.times(r)]]),
            Self::Tube { r } => N::sum([[x, u], [z, w], [-p.w.times(r), q.w.times(r)]]),
            Self::Cone { h, .. } => {
                let (g, f) = (self.outline(p), self.outline(q));
                N::sum([[h * x, h * u], [h * z, h * w], [-g, f]])
            }
        }
    }

    /// `(k^2 - a c) / h^2` along the line, with the `h` of a cone and 1 for the others, from the line's Pluecker moment `w = o x d`:
    /// Lagrange's identity in the metric of the form. `a` is the form of the direction.
    #[inline(always)]
    pub(super) fn discriminant(self, line: &Line<N>, a: N) -> N {
        let ([x, _, z], [dx, _, dz]) = (line.origin, line.direction);
        match self {
            // a r^2 - |w|^2
            Self::Ball { r } => {
                let [wx, wy, wz] = cross(line.origin, line.direction);
                N::sum([[a, r * r], [-wx, wx], [-wy, wy], [-wz, wz]])
            }
            // a r^2 - w_y^2
            Self::Tube { r } => {
                let wy = N::sum([[z, dx], [-x, dz]]);
                N::sum([[a, r * r], [-wy, wy]])
            }
            // (g1 wz - g0 dx)^2 + (g1 wx + g0 dz)^2 - (h wy)^2
            Self::Cone { h, g0, g1 } => {
                let [wx, wy, wz] = cross(line.origin, line.direction);
                let (p, q, s) = (N::sum([[g1, wz], [-g0, dx]]), N::sum([[g1, wx], [g0, dz]]), h * wy);
                N::sum([[p, p], [q, q], [-s, s]])
            }
        }
    }

    /// The `h` of [`Form::discriminant`], where it is not 1.
    #[inline(always)]
    pub(super) fn factor(self) -> Option<N> {
        match self {
            Self::Cone { h, .. } => Some(h),
            Self::Ball { .. } | Self::Tube { .. } => None,
        }
    }
}
