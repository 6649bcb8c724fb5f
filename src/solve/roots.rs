//! The order of the roots of two equations along one line, by the signs of polynomials of their coefficients.
//!
//! Let `f` and `g` be quadratic functions with the leading coefficients `a` and `b`. At a root of `f` the sign of `a g`
//! is that of `a g - b f`, which is linear. So no square root is needed (Deakin and Snoeyink, *On the Precision to Sort
//! Line-Quadric Intersections*, CCCG 2016).

use super::end::{Fraction, Place, times};
use super::quadratic::root_beside;
use crate::hit::Crossing;
use crate::number::{Estimate, Number};
use core::cmp::Ordering;

/// A root of `f = a t^2 + 2 k t + c`, or the parameter of a plane.
#[derive(Clone, Copy, Debug)]
pub struct RootOfQuadric<N> {
    /// `a`, `k` and `c`; unused for a plane.
    f: [N; 3],
    place: Place<N>,
}

impl<N: Number> RootOfQuadric<N> {
    /// A root of `f = a t^2 + 2 k t + c`, given by these, or the parameter of a plane.
    pub(super) const fn new(f: [N; 3], place: Place<N>) -> Self {
        Self { f, place }
    }

    pub(super) const fn at(t: Fraction<N>) -> Self {
        Self { f: [N::ZERO; 3], place: Place::At(t) }
    }

    /// The root at which `f` decreases if the line enters, otherwise the one at which it increases; if there is only
    /// one root, that one. `None` if a sign is not known, or if `f` is constant.
    pub(super) fn of(f @ [a, k, c]: [N; 3], crossing: Crossing) -> Option<Self> {
        let a_sign = a.sign()?;
        if a_sign == Ordering::Equal {
            let twice = k + k;
            return (twice.sign()? != Ordering::Equal).then(|| Self::at(Fraction { n: -c, e: twice }));
        }
        if crossing == Crossing::Touch || N::sum([[k, k], [-a, c]]).sign()? == Ordering::Equal {
            return Some(Self::at(Fraction { n: -k, e: a }));
        }
        let is_second = (crossing == Crossing::Exit) == (a_sign == Ordering::Greater);
        Some(Self { f, place: if is_second { Place::Second } else { Place::First } })
    }

    /// The same root in [`Number::Long`].
    pub(super) fn long(&self) -> RootOfQuadric<N::Long> {
        let place = match self.place {
            Place::At(Fraction { n, e }) => Place::At(Fraction { n: n.long(), e: e.long() }),
            Place::Missing => Place::Missing,
            Place::First => Place::First,
            Place::Second => Place::Second,
        };
        RootOfQuadric { f: self.f.map(N::long), place }
    }

    /// The root of the same number of another equation, or the parameter of the same plane, as these functions make
    /// them.
    pub(super) fn map(&self, f: impl Fn([N; 3]) -> [N; 3], at: impl Fn(Fraction<N>) -> Fraction<N>) -> Self {
        match self.place {
            Place::At(t) => Self::at(at(t)),
            place => Self { f: f(self.f), place },
        }
    }

    /// The sign at the root of a polynomial of the fourth degree, whose coefficients are from the lowest power to the
    /// highest: by `a t^2 + 2 k t + c = 0` it is linear in `t`. Not for a [`parameter`](Self::parameter).
    pub(super) fn sign_of(&self, [c0, c1, c2, c3, c4]: &[N; 5]) -> Option<Ordering> {
        let ([a, k, c], [mut value, mut slope], mut power) = (self.f, [*c4, N::ZERO], N::ONE);
        for coefficient in [c3, c2, c1, c0] {
            power = power * a;
            let product = N::sum([[value, a], [-(k + k), slope]]);
            value = N::sum([[*coefficient, power], [-c, slope]]);
            slope = product;
        }
        Some(match slope.sign()? {
            Ordering::Equal => value.sign()?,
            sign => times(sign, self.against(Fraction { n: -value, e: slope })?),
        })
    }

    /// Its parameter, approximately.
    pub(super) fn estimate(&self) -> N::Estimate {
        let [a, k, c] = self.f;
        let is_second = match self.place {
            Place::At(Fraction { n, e }) => return n.estimate().over(e.estimate()),
            Place::First | Place::Missing => false,
            Place::Second => true,
        };
        let root = N::sum([[k, k], [-a, c]]).estimate().square_root();
        let is_plus = is_second == (a.sign() != Some(Ordering::Less));
        (if is_plus { root - k.estimate() } else { -root - k.estimate() }).over(a.estimate())
    }

    /// That of a plane, or of a root that is rational.
    pub(super) fn parameter(&self) -> Option<Fraction<N>> {
        if let Place::At(t) = self.place { Some(t) } else { None }
    }

    /// How it compares with the parameter `t`.
    pub(super) fn against(&self, t: Fraction<N>) -> Option<Ordering> {
        let [a, k, _] = self.f;
        let is_second = match self.place {
            Place::At(own) => return own.order(t),
            Place::Missing => return None,
            Place::First => false,
            Place::Second => true,
        };
        let f = at(self.f, t).sign()?;
        let slope = N::sum([[a, t.n], [k, t.e]]).sign()?;
        let upwards = a.sign()?;
        Some(root_beside(is_second, times(f, upwards), times(times(slope, t.e.sign()?), upwards)))
    }

    /// How it compares with another root on the same line; `None` if a sign is not known.
    pub(super) fn order(&self, other: &Self) -> Option<Ordering> {
        let is_second = match (self.place, other.place) {
            (_, Place::At(t)) => return self.against(t),
            (Place::At(t), _) => return other.against(t).map(Ordering::reverse),
            (_, place) => matches!(place, Place::Second),
        };
        let ([a, k, c], [b, l, d]) = (self.f, other.f);
        // At a root of f the sign of a g is that of a g - b f = 2 slope t + value.
        let [slope, value] = [N::sum([[a, l], [-b, k]]), N::sum([[a, d], [-b, c]])];
        let difference = match slope.sign()? {
            Ordering::Equal => value.sign()?,
            sign => times(sign, self.against(Fraction { n: -value, e: slope + slope })?),
        };
        let upwards = b.sign()?;
        let g = times(times(difference, a.sign()?), upwards);
        let from_vertex = self.against(Fraction { n: -l, e: b })?;
        Some(root_beside(is_second, g, from_vertex).reverse())
    }
}

/// `f` at `n / e`, times `e^2`.
pub(super) fn at<N: Number>([a, k, c]: [N; 3], Fraction { n, e }: Fraction<N>) -> N {
    N::sum([[N::sum([[a, n], [k + k, e]]), n], [c * e, e]])
}
