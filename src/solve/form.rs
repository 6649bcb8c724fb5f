//! The line and the quadrics along it.

use crate::equations::{Described, EquationKinds, Side};
use crate::number::Ring;

/// A line in a primitive's frame. Its direction may have any length, since `t` is the parameter of the ray as stored.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<N> {
    pub(crate) origin: [N; 3],
    pub(crate) direction: [N; 3],
}

/// A point in homogeneous coordinates `(v, w)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Homogeneous<N> {
    pub(super) v: [N; 3],
    pub(super) w: Weight,
}

/// The homogeneous coordinate `w` of a point.
#[derive(Clone, Copy, Debug)]
pub(super) enum Weight {
    /// Zero: a direction.
    Zero,
    /// One: a point in Cartesian coordinates.
    One,
}

impl Weight {
    /// The number times the weight.
    #[inline(always)]
    fn times<N: Ring>(self, number: N) -> N {
        match self {
            Self::Zero => N::ZERO,
            Self::One => number,
        }
    }
}

/// A quadric as a bilinear form `f(p, q)`, with `f(p, p) <= 0` inside.
///
/// Each quadric is a type of its own, so that a program links the equations only of those that it uses.
pub(super) trait Quadric<N: Ring>: Copy {
    /// `f(p, q)`
    fn of(self, p: Homogeneous<N>, q: Homogeneous<N>) -> N;
    /// The radius at a point, times the `h` of a cone.
    fn outline(self, p: Homogeneous<N>) -> N;
}

/// `x x' + y y' + z z' - r w r w'`
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball<N> {
    pub(super) r: N,
}

impl<N: Ring> Quadric<N> for Ball<N> {
    #[inline(always)]
    fn of(self, p: Homogeneous<N>, q: Homogeneous<N>) -> N {
        let ([x, y, z], [u, v, w]) = (p.v, q.v);
        N::sum([[x, u], [y, v], [z, w], [-p.w.times(self.r), q.w.times(self.r)]])
    }
    #[inline(always)]
    fn outline(self, p: Homogeneous<N>) -> N {
        p.w.times(self.r)
    }
}

/// `x x' + z z' - r w r w'`
#[derive(Clone, Copy, Debug)]
pub(super) struct Tube<N> {
    pub(super) r: N,
}

impl<N: Ring> Quadric<N> for Tube<N> {
    #[inline(always)]
    fn of(self, p: Homogeneous<N>, q: Homogeneous<N>) -> N {
        let ([x, _, z], [u, _, w]) = (p.v, q.v);
        N::sum([[x, u], [z, w], [-p.w.times(self.r), q.w.times(self.r)]])
    }
    #[inline(always)]
    fn outline(self, p: Homogeneous<N>) -> N {
        p.w.times(self.r)
    }
}

/// `h^2 (x x' + z z') - g g'` with the outline `g = g0 w + g1 y`: the radius at `y` is `g / h`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone<N> {
    pub(super) h: N,
    pub(super) g0: N,
    pub(super) g1: N,
}

impl<N: Ring> Cone<N> {
    /// A cone of this slope.
    #[inline(always)]
    pub(super) fn slope(slope: N) -> Self {
        Self { h: N::ONE, g0: N::ZERO, g1: slope }
    }

    /// A cone through two radii.
    #[inline(always)]
    pub(super) fn radii(base: N, top: N, height: N) -> Self {
        Self { h: height, g0: base * height, g1: top - base }
    }
}

impl<N: Ring> Quadric<N> for Cone<N> {
    #[inline(always)]
    fn of(self, p: Homogeneous<N>, q: Homogeneous<N>) -> N {
        let ([x, _, z], [u, _, w], h) = (p.v, q.v, self.h);
        let (g, f) = (self.outline(p), self.outline(q));
        N::sum([[h * x, h * u], [h * z, h * w], [-g, f]])
    }
    #[inline(always)]
    fn outline(self, p: Homogeneous<N>) -> N {
        let Self { g0, g1, .. } = self;
        match p.w {
            Weight::Zero => g1 * p.v[1],
            Weight::One => N::sum([[g0, N::ONE], [g1, p.v[1]]]),
        }
    }
}

/// Any of the quadrics, for functions of points instead of lines.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form<N> {
    Ball(Ball<N>),
    Tube(Tube<N>),
    Cone(Cone<N>),
}

impl<N: Ring> Form<N> {
    /// The side's quadric, for a side that the geometry `G` has.
    #[inline(always)]
    pub(super) fn of_side<S, G: Described>(side: Side<S>, number: impl Fn(S) -> N) -> Self {
        let is_cone = G::EQUATIONS.has(EquationKinds::CONE);
        match side {
            Side::Slope(slope) if is_cone => Self::Cone(Cone::slope(number(slope))),
            Side::Radii(base, top, height) if is_cone => {
                Self::Cone(Cone::radii(number(base), number(top), number(height)))
            }
            Side::Straight(size) | Side::Slope(size) | Side::Radii(size, ..) => Self::Tube(Tube { r: number(size) }),
        }
    }

    /// `f(p, p)`
    #[inline(always)]
    pub(super) fn at(self, p: Homogeneous<N>) -> N {
        match self {
            Self::Ball(ball) => ball.of(p, p),
            Self::Tube(tube) => tube.of(p, p),
            Self::Cone(cone) => cone.of(p, p),
        }
    }
}
