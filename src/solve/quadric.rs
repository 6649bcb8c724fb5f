//! The quadrics along a line, in coordinates in which they are a difference of squares.
//!
//! A quadric is `f = u . u - v^2` of a vector `u` and a number `v`, which are linear in the coordinates of a point; a
//! point is inside where `f <= 0`. Along a line they are `u + t u'` and `v + t v'`, so that
//! `f = a t^2 + 2 k t + c` with `a = u' . u' - v'^2`, `k = u . u' - v v'`, `c = u . u - v^2`.
//!
//! The discriminant `k^2 - a c` is computed by Lagrange's identity from the 2x2 minors of `(u, v)` and `(u', v')`,
//! which are the Pluecker moment of the line in these coordinates. The difference `k^2 - a c` itself would lose all
//! digits where the line starts far away: its terms grow with the square of the distance, the discriminant does not.

use crate::number::{Number, Ring};
use crate::outline::{Meridian, Outline};
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// A quadric along a line.
pub(super) trait Quadric<N: Ring>: Copy {
    /// True for a cone. Its quadric has two nappes (halves that meet in the apex), and only that with `v >= 0` counts.
    const HAS_NAPPES: bool = false;
    /// From the point of closest approach `(-k -+ root) / a` is taken to be accurate if `|k|` is at most `2^-SPREAD`
    /// times the root. A cone needs a smaller `|k|`, since its `a` may be small.
    const SPREAD: i32 = 0;
    /// True if a line may lie inside of it from one end to the other: `a < 0`, and no roots.
    const MAY_HOLD_LINES: bool = false;

    fn a(&self) -> N;
    fn k(&self) -> N;
    fn c(&self) -> N;
    /// `k^2 - a c`
    fn discriminant(&self, a: N) -> N;
    /// The sum of the magnitudes of the terms of [`Quadric::discriminant`].
    fn terms(&self, a: N) -> N;
    /// `f` at `t = n / e`, times `e^2`.
    fn at(&self, n: N, e: N) -> N;
    /// Of a cone, the outline `v` at the line's origin, and its growth `v'` along the line.
    #[inline(always)]
    fn outline(&self) -> [N; 2] {
        [N::ZERO; 2]
    }
    /// True if `a` is certainly zero, although products may underflow.
    #[inline(always)]
    fn is_linear(&self) -> bool
    where
        N: Number,
    {
        false
    }
    /// True if `a` and `k` are certainly zero, although products may underflow.
    #[inline(always)]
    fn is_constant(&self) -> bool
    where
        N: Number,
    {
        self.is_linear()
    }
}

/// The ball about the origin: `u = (x, y, z)`, `v = r`. The line is `o + t d`, here and below; its moment `w = o x d`.
#[derive(Clone, Copy)]
pub(crate) struct Ball<N> {
    pub(super) o: [N; 3],
    pub(super) d: [N; 3],
    pub(super) r: N,
}

impl<N: Ring> Quadric<N> for Ball<N> {
    #[inline(always)]
    fn a(&self) -> N {
        N::scalar_product(self.d, self.d)
    }
    #[inline(always)]
    fn k(&self) -> N {
        N::scalar_product(self.o, self.d)
    }
    #[inline(always)]
    fn c(&self) -> N {
        -N::less_square(self.r, self.r, self.o)
    }
    /// `a r^2 - |w|^2`
    #[inline(always)]
    fn discriminant(&self, a: N) -> N {
        N::less_square(a, self.r * self.r, N::vector_product(self.o, self.d))
    }
    #[inline(always)]
    fn terms(&self, a: N) -> N {
        let w = N::vector_product(self.o, self.d);
        a * (self.r * self.r) + N::scalar_product(w, w)
    }
    fn at(&self, n: N, e: N) -> N {
        let r = e * self.r;
        -N::less_square(r, r, along(self.o, self.d, n, e))
    }
}

/// The infinite cylinder about the y axis: `u = (x, z)`, `v = r`.
#[derive(Clone, Copy)]
pub(crate) struct Cylinder<N> {
    pub(super) o: [N; 2],
    pub(super) d: [N; 2],
    pub(super) r: N,
}

impl<N: Ring> Cylinder<N> {
    /// Along the line `o + t d`.
    #[inline(always)]
    pub(super) fn along([x, _, z]: [N; 3], [dx, _, dz]: [N; 3], r: N) -> Self {
        Self { o: [x, z], d: [dx, dz], r }
    }
    /// `w_y`
    #[inline(always)]
    fn moment(&self) -> N {
        let [x, z] = self.o;
        N::scalar_product([z, -x], self.d)
    }
}

impl<N: Ring> Quadric<N> for Cylinder<N> {
    #[inline(always)]
    fn a(&self) -> N {
        N::scalar_product(self.d, self.d)
    }
    #[inline(always)]
    fn k(&self) -> N {
        N::scalar_product(self.o, self.d)
    }
    #[inline(always)]
    fn c(&self) -> N {
        let ([x, z], r) = (self.o, self.r);
        N::sum([[x, x], [z, z], [-r, r]])
    }
    /// `a r^2 - w_y^2`
    #[inline(always)]
    fn discriminant(&self, a: N) -> N {
        let w = self.moment();
        N::sum([[a, self.r * self.r], [-w, w]])
    }
    #[inline(always)]
    fn terms(&self, a: N) -> N {
        let w = self.moment();
        N::sum([[a, self.r * self.r], [w, w]])
    }
    fn at(&self, n: N, e: N) -> N {
        let [x, z] = along(self.o, self.d, n, e);
        let r = e * self.r;
        N::sum([[x, x], [z, z], [-r, r]])
    }
    #[inline(always)]
    fn is_linear(&self) -> bool
    where
        N: Number,
    {
        self.d.iter().all(|component| component.sign() == Some(Ordering::Equal))
    }
}

/// The outline of a cone in the numbers of the solver: the radius at `y` is `(base h + growth y) / h`. A cone of slope
/// `m` has `base = 0`, `growth = m`, `h = 1`; one through the radii `r0` and `r1` at the heights 0 and `h` has
/// `base = r0`, `growth = r1 - r0`, so that no slope is rounded.
#[derive(Clone, Copy)]
pub(crate) struct Profile<N> {
    pub(crate) base: N,
    pub(crate) growth: N,
    pub(crate) h: N,
}

impl<N: Ring> Profile<N> {
    #[inline(always)]
    pub(crate) fn of<S>(outline: Outline<S>, number: impl Fn(S) -> N) -> Self {
        match outline {
            Outline::Slope(slope) => Self { base: N::ZERO, growth: number(slope), h: N::ONE },
            Outline::Radii(base, top, height) => {
                let base = number(base);
                Self { base, growth: number(top) - base, h: number(height) }
            }
        }
    }

    /// The radius at this height, times `h`.
    #[inline(always)]
    pub(crate) fn at(self, y: N) -> N {
        N::sum([[self.base, self.h], [self.growth, y]])
    }
}

/// A cone about the y axis, both nappes: `u = (h x, h z)`, `v = base h + growth y` of its [`Profile`]. `o` and `d` are
/// the line in the coordinates `(u_1, u_2, v)`. With its moment `w = o x d` there, the discriminant is
/// `w_1^2 + w_2^2 - w_3^2`.
#[derive(Clone, Copy)]
pub(crate) struct Nappe<N> {
    pub(super) o: [N; 3],
    pub(super) d: [N; 3],
}

impl<N: Ring> Nappe<N> {
    /// Along the line `o + t d`.
    #[inline(always)]
    pub(super) fn along([x, y, z]: [N; 3], [dx, dy, dz]: [N; 3], profile: Profile<N>) -> Self {
        let Profile { growth, h, .. } = profile;
        Self { o: [h * x, h * z, profile.at(y)], d: [h * dx, h * dz, growth * dy] }
    }
    /// `u_1 u'_1 + u_2 u'_2 - v v'`, of which `f` is the case of two equal vectors.
    #[inline(always)]
    fn product([x, z, g]: [N; 3], v: [N; 3]) -> N {
        N::scalar_product([x, z, -g], v)
    }
}

impl<N: Ring> Quadric<N> for Nappe<N> {
    const HAS_NAPPES: bool = true;
    const SPREAD: i32 = 3;

    #[inline(always)]
    fn a(&self) -> N {
        Self::product(self.d, self.d)
    }
    #[inline(always)]
    fn k(&self) -> N {
        Self::product(self.o, self.d)
    }
    #[inline(always)]
    fn c(&self) -> N {
        Self::product(self.o, self.o)
    }
    #[inline(always)]
    fn discriminant(&self, _: N) -> N {
        let w = N::vector_product(self.o, self.d);
        Self::product(w, w)
    }
    #[inline(always)]
    fn terms(&self, _: N) -> N {
        let w = N::vector_product(self.o, self.d);
        N::scalar_product(w, w)
    }
    fn at(&self, n: N, e: N) -> N {
        let point = along(self.o, self.d, n, e);
        Self::product(point, point)
    }
    #[inline(always)]
    fn outline(&self) -> [N; 2] {
        [self.o[2], self.d[2]]
    }
}

/// The cone that touches a ball of radius `r` about the origin and another of radius `r - k` about `(0, h, 0)`, where
/// `|k| < h`. The sine of the angle between its axis and its side is `k / h`, and the distance of a point from the side
/// `(r - y k / h) - sqrt(1 - (k / h)^2) sqrt(x^2 + z^2)`; so that no root is taken, `f = w (x^2 + z^2) - v^2` with
/// `w = h^2 - k^2` and `v = r h - k y`, or both divided by `h`. With `p = x v' - x' v`, `q = z v' - z' v` and `w_y`
/// the discriminant is `w (p^2 + q^2 - w w_y^2)`.
#[derive(Clone, Copy)]
pub(crate) struct Tangent<N> {
    pub(super) o: [N; 2],
    pub(super) d: [N; 2],
    pub(super) w: N,
    /// `v` at the line's origin, and its growth along the line.
    pub(super) v: [N; 2],
    pub(super) k: N,
}

impl<N: Ring> Tangent<N> {
    /// Along the line `o + t d`.
    #[inline(always)]
    pub(super) fn along([x, y, z]: [N; 3], [dx, dy, dz]: [N; 3], [r, h, k]: [N; 3]) -> Self {
        let v = [N::sum([[r, h], [-k, y]]), -(k * dy)];
        Self { o: [x, z], d: [dx, dz], w: (h - k) * (h + k), v, k }
    }
    /// `p`, `q` and `w_y`.
    #[inline(always)]
    fn minors(&self) -> [N; 3] {
        let ([x, z], [dx, dz], [v, dv]) = (self.o, self.d, self.v);
        [N::sum([[x, dv], [-dx, v]]), N::sum([[z, dv], [-dz, v]]), N::sum([[z, dx], [-x, dz]])]
    }
    /// Half the gradient of `f` at the line's origin.
    #[inline(always)]
    pub(super) fn gradient(&self) -> [N; 3] {
        let [x, z] = self.o;
        [self.w * x, self.k * self.v[0], self.w * z]
    }
}

impl<N: Ring> Quadric<N> for Tangent<N> {
    const HAS_NAPPES: bool = true;
    const SPREAD: i32 = 3;

    #[inline(always)]
    fn a(&self) -> N {
        let [_, dv] = self.v;
        N::sum([[self.w, N::scalar_product(self.d, self.d)], [-dv, dv]])
    }
    #[inline(always)]
    fn k(&self) -> N {
        let [v, dv] = self.v;
        N::sum([[self.w, N::scalar_product(self.o, self.d)], [-v, dv]])
    }
    #[inline(always)]
    fn c(&self) -> N {
        let [v, _] = self.v;
        N::sum([[self.w, N::scalar_product(self.o, self.o)], [-v, v]])
    }
    #[inline(always)]
    fn discriminant(&self, _: N) -> N {
        let [p, q, w] = self.minors();
        self.w * N::sum([[p, p], [q, q], [-(self.w * w), w]])
    }
    #[inline(always)]
    fn terms(&self, _: N) -> N {
        let [p, q, w] = self.minors();
        self.w * N::sum([[p, p], [q, q], [self.w * w, w]])
    }
    fn at(&self, n: N, e: N) -> N {
        let ([x, z], [v]) = (along(self.o, self.d, n, e), along([self.v[0]], [self.v[1]], n, e));
        N::sum([[self.w, N::scalar_product([x, z], [x, z])], [-v, v]])
    }
    #[inline(always)]
    fn outline(&self) -> [N; 2] {
        self.v
    }
}

/// A quadric of revolution: `f = x^2 + z^2 - (a y^2 + 2 b y + r^2)`, of which the ball, the cylinder and the cone are
/// special cases. It need not be a difference of squares of linear functions. With the moment `w` of the line and
/// `A = dx^2 + dz^2 - a dy^2`, its discriminant is
/// `a (w_x^2 + w_z^2) - w_y^2 + r^2 A + b (b dy^2 + 2 (w_x dz - w_z dx))`.
#[derive(Clone, Copy)]
pub(crate) struct Revolution<N> {
    o: [N; 3],
    d: [N; 3],
    /// The coefficient `a`, and its magnitude.
    a: [N; 2],
    b: N,
    r: N,
}

impl<N: Ring> Revolution<N> {
    /// Along the line `o + t d`.
    #[inline(always)]
    pub(super) fn along<S: Scalar>(o: [N; 3], d: [N; 3], meridian: &Meridian<S>, number: impl Fn(S) -> N) -> Self {
        let Meridian { a, b, r, .. } = *meridian;
        Self { o, d, a: [number(a), number(a.magnitude())], b: number(b), r: number(r) }
    }
    /// Half the derivative of `a y^2 + 2 b y` at the line's origin.
    #[inline(always)]
    fn growth(&self) -> N {
        N::sum([[self.a[0], self.o[1]], [self.b, N::ONE]])
    }
    /// Half the gradient of `f` at the line's origin.
    #[inline(always)]
    pub(super) fn gradient(&self) -> [N; 3] {
        [self.o[0], -self.growth(), self.o[2]]
    }
}

impl<N: Ring> Quadric<N> for Revolution<N> {
    const SPREAD: i32 = 3;
    const MAY_HOLD_LINES: bool = true;

    #[inline(always)]
    fn a(&self) -> N {
        let [dx, dy, dz] = self.d;
        N::sum([[dx, dx], [dz, dz], [-(self.a[0] * dy), dy]])
    }
    #[inline(always)]
    fn k(&self) -> N {
        let ([x, _, z], [dx, dy, dz]) = (self.o, self.d);
        N::sum([[x, dx], [z, dz], [-self.growth(), dy]])
    }
    #[inline(always)]
    fn c(&self) -> N {
        let ([x, y, z], r) = (self.o, self.r);
        N::sum([[x, x], [z, z], [-(self.growth() + self.b), y], [-r, r]])
    }
    #[inline(always)]
    fn discriminant(&self, a: N) -> N {
        let ([dx, dy, dz], [wx, wy, wz]) = (self.d, N::vector_product(self.o, self.d));
        let twice = N::sum([[wx, dz], [-wz, dx]]).scaled(1);
        let across = N::sum([[wx, wx], [wz, wz]]);
        N::sum([[self.a[0], across], [-wy, wy], [self.r * self.r, a], [self.b, self.b * (dy * dy) + twice]])
    }
    /// `2 b (w_x dz - w_z dx)` is in magnitude at most `b^2 (dx^2 + dz^2) + w_x^2 + w_z^2`.
    #[inline(always)]
    fn terms(&self, _: N) -> N {
        let ([dx, dy, dz], [wx, wy, wz], [_, a]) = (self.d, N::vector_product(self.o, self.d), self.a);
        let (across, around) = (N::sum([[wx, wx], [wz, wz]]), N::sum([[dx, dx], [dz, dz]]));
        let squares = N::sum([[around, N::ONE], [a * dy, dy]]);
        N::sum([[a + N::ONE, across], [wy, wy], [self.r * self.r, squares], [self.b * self.b, around + dy * dy]])
    }
    fn at(&self, n: N, e: N) -> N {
        let [x, y, z] = along(self.o, self.d, n, e);
        let (r, growth) = (e * self.r, N::sum([[self.a[0], y], [self.b + self.b, e]]));
        N::sum([[x, x], [z, z], [-growth, y], [-r, r]])
    }
    #[inline(always)]
    fn is_linear(&self) -> bool
    where
        N: Number,
    {
        [self.a[0], self.d[0], self.d[2]].into_iter().all(|n| n.sign() == Some(Ordering::Equal))
    }
    #[inline(always)]
    fn is_constant(&self) -> bool
    where
        N: Number,
    {
        self.b.sign() == Some(Ordering::Equal) && self.is_linear()
    }
}

/// `e o + n d`
#[inline(never)]
fn along<N: Ring, const M: usize>(o: [N; M], d: [N; M], n: N, e: N) -> [N; M] {
    core::array::from_fn(|i| N::sum([[o[i], e], [d[i], n]]))
}
