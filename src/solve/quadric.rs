//! The quadrics, in coordinates along a line in which they are sums of squares.
//!
//! A point of the line has the coordinates `u + t u'` and `v + t v'`; it is inside where `f = u . u - v^2 <= 0`, and
//! `f = a t^2 + 2 k t + c` with `a = u' . u' - v'^2`, `k = u . u' - v v'`, `c = u . u - v^2`. The discriminant
//! `k^2 - a c` is computed from the minors of the line in these coordinates (Lagrange's identity), which are its
//! Pluecker moment: `k^2 - a c` itself would lose all digits far away.

use crate::number::{Number, Ring};
use crate::outline::Outline;
use core::cmp::Ordering;

/// A quadric along a line.
pub(super) trait Quadric<N: Ring>: Copy {
    /// True for a cone. Its quadric has two nappes (halves that meet in the apex), and only that with `v >= 0` counts.
    const HAS_NAPPES: bool = false;
    /// `(-k -+ root) / a` is accurate if `|k|` is at most `2^-SPREAD` of the root: the `a` of a cone may be small.
    const SPREAD: i32 = 0;

    fn a(&self) -> N;
    fn k(&self) -> N;
    fn c(&self) -> N;
    /// `k^2 - a c`
    fn discriminant(&self, a: N) -> N;
    /// The sum of the magnitudes of the discriminant's terms.
    fn terms(&self, a: N) -> N;
    /// `f` at `n / e`, times `e^2`.
    fn at(&self, n: N, e: N) -> N;
    /// The outline `v` at the line's origin, and its growth `v'` along the line.
    fn outline(&self) -> [N; 2];
    /// True if the line is certainly parallel to the axis of a tube, although products may underflow.
    #[inline(always)]
    fn is_parallel(&self) -> bool
    where
        N: Number,
    {
        false
    }
}

/// The ball about the origin: `u = (x, y, z)`, `v = r`.
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
    #[inline(always)]
    fn outline(&self) -> [N; 2] {
        [self.r, N::ZERO]
    }
}

/// The infinite cylinder about the y axis: `u = (x, z)`, `v = r`.
#[derive(Clone, Copy)]
pub(crate) struct Tube<N> {
    pub(super) o: [N; 2],
    pub(super) d: [N; 2],
    pub(super) r: N,
}

impl<N: Ring> Tube<N> {
    /// Along the line `o + t d`.
    #[inline(always)]
    pub(super) fn along([x, _, z]: [N; 3], [dx, _, dz]: [N; 3], r: N) -> Self {
        Self { o: [x, z], d: [dx, dz], r }
    }
    /// `w_y` of the moment `w = o x d`
    #[inline(always)]
    fn moment(&self) -> N {
        let [x, z] = self.o;
        N::scalar_product([z, -x], self.d)
    }
}

impl<N: Ring> Quadric<N> for Tube<N> {
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
    fn outline(&self) -> [N; 2] {
        [self.r, N::ZERO]
    }
    #[inline(always)]
    fn is_parallel(&self) -> bool
    where
        N: Number,
    {
        self.d.iter().all(|component| component.sign() == Some(Ordering::Equal))
    }
}

/// The outline of a cone in computing numbers: the radius at `y` is `(base h + growth y) / h`. A cone of slope `m` has
/// `base = 0`, `growth = m`, `h = 1`; one through the radii `r0` and `r1` at the heights 0 and `h` has `base = r0`,
/// `growth = r1 - r0`, so that no slope is rounded.
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

/// A cone about the y axis: `u = (h x, h z)`, `v = base h + growth y` of its [`Profile`]. Of the line's moment in these
/// coordinates, `w`, the discriminant is `w_1^2 + w_2^2 - w_3^2`.
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
    /// The product of two vectors of these coordinates, `u_1 u'_1 + u_2 u'_2 - v v'`: that with itself is `f`.
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

/// `e o + n d`
#[inline(never)]
fn along<N: Ring, const M: usize>(o: [N; M], d: [N; M], n: N, e: N) -> [N; M] {
    core::array::from_fn(|i| N::sum([[o[i], e], [d[i], n]]))
}
