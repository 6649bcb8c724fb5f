//! A quadric along a line, and the order of its roots and of planes, decided by signs.
//!
//! Whether a root comes before a plane is decided by approximate parameters if their error bounds allow it, otherwise by the signs of the
//! quadric and of its derivative where the line crosses the plane. Any sign may be unknown (`None`); then the whole query is repeated in
//! wider numbers.

use super::form::{Homogeneous, Line, Quadric, Weight};
use crate::number::{Estimate, Number, Ring};
use crate::part::Part;
use core::cmp::Ordering;

/// A parameter `n / e` of the line; `e` is not zero.
#[derive(Clone, Copy)]
pub(super) struct Fraction<N> {
    pub(super) n: N,
    pub(super) e: N,
}

impl<N: Number> Fraction<N> {
    /// How it compares with another.
    pub(super) fn order(self, other: Self) -> Option<Ordering> {
        let order = N::sum([[self.n, other.e], [-other.n, self.e]]).sign()?;
        Some(times(order, times(self.e.sign()?, other.e.sign()?)))
    }
}

/// The sign of a product, as an ordering with zero.
pub(super) fn times(a: Ordering, b: Ordering) -> Ordering {
    match b {
        Ordering::Less => a.reverse(),
        Ordering::Equal => Ordering::Equal,
        Ordering::Greater => a,
    }
}

/// One end of an interval of the line.
#[derive(Clone, Copy)]
pub(super) enum Place<N> {
    /// The lower root of the quadric, or its only one.
    First,
    /// The upper root.
    Second,
    /// Where the line crosses a plane.
    At(Fraction<N>),
}

/// An end of an interval, its approximate parameter, and the part of the surface that it lies on.
#[derive(Clone, Copy)]
pub(super) struct End<N: Number> {
    pub(super) place: Place<N>,
    pub(super) t: N::Estimate,
    pub(super) part: Part,
}

impl<N: Number> End<N> {
    /// Where the line crosses a plane.
    #[inline(never)]
    pub(super) fn at(t: Fraction<N>, part: Part) -> Self {
        Self { place: Place::At(t), t: t.n.estimate().over(t.e.estimate()), part }
    }

    /// The start of the line.
    pub(super) fn start(part: Part) -> Self {
        Self { place: Place::At(Fraction { n: N::ZERO, e: N::ONE }), t: N::Estimate::ZERO, part }
    }

    /// The same end with the part `Side`.
    pub(super) fn of_side(self) -> Self {
        Self { part: Part::Side, ..self }
    }
}

/// The interval of the line inside a convex set. A missing end is infinite.
#[derive(Clone, Copy)]
pub(super) struct Interval<N: Number> {
    pub(super) enter: Option<End<N>>,
    pub(super) exit: Option<End<N>>,
    /// The two ends are one point.
    pub(super) touch: bool,
}

impl<N: Number> Interval<N> {
    pub(super) const EVERYWHERE: Self = Self { enter: None, exit: None, touch: false };

    pub(super) const fn new(enter: Option<End<N>>, exit: Option<End<N>>) -> Self {
        Self { enter, exit, touch: false }
    }
}

/// The parameters of the line for which a quadric is zero or negative.
pub(super) enum Inside {
    Nowhere,
    /// From the first to the second root; `true` if they are one.
    Between(bool),
    /// Up to the first and from the second on.
    Beyond,
    /// Up to the only root.
    Until,
    /// From the only root on.
    From,
    Everywhere,
    InSurface,
}

/// The order of roots and planes along a line.
pub(super) trait Curve<N> {
    /// How the end compares with the parameter `t`.
    fn order_for_certain(&self, place: Place<N>, t: Fraction<N>) -> Option<Ordering>;
}

/// For flat primitives, which have no roots.
pub(super) struct Flat;

impl<N: Number> Curve<N> for Flat {
    fn order_for_certain(&self, place: Place<N>, t: Fraction<N>) -> Option<Ordering> {
        match place {
            Place::At(own) => own.order(t),
            Place::First | Place::Second => None,
        }
    }
}

/// A quadric along the line: `f = a t^2 + 2 k t + c`.
///
/// For a line that departs from the quadric, `t = 0` is a root by rule 8 of the contract, whatever its rounded coordinates:
/// `c = 0`, the discriminant is `k^2`, and the other root is `-2 k / a`.
pub(super) struct Quadratic<'a, N, F> {
    form: F,
    line: &'a Line<N>,
    departs: bool,
    pub(super) a: N,
    pub(super) k: N,
    /// Divided by the square of [`Quadric::factor`].
    discriminant: N,
    pub(super) a_sign: Ordering,
    discriminant_sign: Ordering,
}

// These functions are not inlined: each is called in several places, and the solver runs too seldom to justify the code size.
impl<'a, N: Number, F: Quadric<N>> Quadratic<'a, N, F> {
    #[inline(never)]
    pub(super) fn new(form: F, line: &'a Line<N>, departs: bool) -> Option<Self> {
        let (o, d) = (Self::point(line), Self::along(line));
        let a = of(form, d, d);
        let a_sign = a.sign()?;
        if departs {
            let k = of(form, o, d);
            let discriminant_sign = if k.sign()? == Ordering::Equal { Ordering::Equal } else { Ordering::Greater };
            return Some(Self { form, line, departs, a, k, discriminant: N::ZERO, a_sign, discriminant_sign });
        }
        let discriminant = form.discriminant(line, a);
        let discriminant_sign = discriminant.sign()?;
        // A miss needs no k.
        let misses = (a_sign, discriminant_sign) == (Ordering::Greater, Ordering::Less);
        let k = if misses { N::ZERO } else { of(form, o, d) };
        Some(Self { form, line, departs, a, k, discriminant, a_sign, discriminant_sign })
    }

    #[inline(always)]
    fn point(line: &Line<N>) -> Homogeneous<N> {
        Homogeneous { v: line.origin, w: Weight::One }
    }

    #[inline(always)]
    fn along(line: &Line<N>) -> Homogeneous<N> {
        Homogeneous { v: line.direction, w: Weight::Zero }
    }

    #[inline(always)]
    fn c(&self) -> N {
        if self.departs {
            return N::ZERO;
        }
        let o = Self::point(self.line);
        of(self.form, o, o)
    }

    #[inline(always)]
    pub(super) fn inside(&self) -> Option<Inside> {
        Some(match (self.a_sign, self.discriminant_sign) {
            (Ordering::Greater, Ordering::Less) => Inside::Nowhere,
            (Ordering::Greater, sign) => Inside::Between(sign == Ordering::Equal),
            (Ordering::Less, _) => Inside::Beyond,
            // A line parallel to a generator of a cone has one root.
            (Ordering::Equal, _) => match self.k.sign()? {
                Ordering::Less => Inside::From,
                Ordering::Greater => Inside::Until,
                Ordering::Equal => match self.c().sign()? {
                    Ordering::Less => Inside::Everywhere,
                    Ordering::Equal => Inside::InSurface,
                    Ordering::Greater => Inside::Nowhere,
                },
            },
        })
    }

    /// How the end compares with another, which is not a root.
    #[inline]
    pub(super) fn order(&self, end: &End<N>, other: &End<N>) -> Option<Ordering> {
        // The approximate parameters decide in nearly all cases.
        end.t.compare(other.t).or_else(|| match other.place {
            Place::At(t) => self.order_for_certain(end.place, t),
            Place::First | Place::Second => None,
        })
    }

    /// The sign of `f` at `n / e`.
    fn sign_at(&self, t: Fraction<N>) -> Option<Ordering> {
        if self.departs {
            // n (a n + 2 k e), over e^2
            let k = self.k + self.k;
            return Some(times(t.n.sign()?, N::sum([[self.a, t.n], [k, t.e]]).sign()?));
        }
        // At the point e (o + t d), times e^2.
        let along = |i: usize| N::sum([[self.line.origin[i], t.e], [self.line.direction[i], t.n]]);
        let point = Homogeneous { v: [along(0), along(1), along(2)], w: Weight::By(t.e) };
        of(self.form, point, point).sign()
    }

    /// The roots in order; the only root of a linear function is returned twice.
    #[inline(always)]
    pub(super) fn ends(&self) -> [End<N>; 2] {
        let [first, second] = self.roots();
        let end = |place: Place<N>, t: N::Estimate| End { place, t, part: Part::Side };
        [end(Place::First, first), end(Place::Second, second)]
    }

    /// The interval between the roots.
    #[inline(always)]
    pub(super) fn between(&self, touch: bool) -> Interval<N> {
        let [first, second] = self.ends();
        Interval { enter: Some(first), exit: Some(second), touch }
    }

    /// The roots' parameters, approximately.
    #[inline(never)]
    fn roots(&self) -> [N::Estimate; 2] {
        let (a, k) = (self.a.estimate(), self.k.estimate());
        let zero = N::Estimate::ZERO;
        if self.departs {
            if self.a_sign == Ordering::Equal {
                return [zero; 2];
            }
            let other = (-(k + k)).over(a);
            return if k.sign() == Some(self.a_sign) { [other, zero] } else { [zero, other] };
        }
        let c = self.c().estimate();
        if self.a_sign == Ordering::Equal {
            return [(-c).over(k + k); 2];
        }
        let root = if self.discriminant_sign == Ordering::Greater {
            let root = self.discriminant.estimate().square_root();
            self.form.factor().map_or(root, |h| h.estimate() * root)
        } else {
            zero
        };
        // -k and the root are added where they have the same sign; the other root is c over that sum (Press et al., *Numerical Recipes*,
        // 5.6).
        let [lower, upper] = match k.sign() {
            Some(Ordering::Greater) => {
                let q = -k - root;
                [q.over(a), c.over(q)]
            }
            Some(Ordering::Less) => {
                let q = root - k;
                [c.over(q), q.over(a)]
            }
            // k is zero or close to zero: nothing cancels.
            _ => [(-k - root).over(a), (root - k).over(a)],
        };
        if self.a_sign == Ordering::Greater { [lower, upper] } else { [upper, lower] }
    }
}

impl<N: Number, F: Quadric<N>> Curve<N> for Quadratic<'_, N, F> {
    #[inline(never)]
    fn order_for_certain(&self, place: Place<N>, t: Fraction<N>) -> Option<Ordering> {
        let second = match place {
            Place::At(own) => return own.order(t),
            Place::First => false,
            Place::Second => true,
        };
        let f = self.sign_at(t)?;
        if self.a_sign == Ordering::Equal {
            // f = 2 k t + c: where it has the sign of k, the root has passed.
            return Some(times(f, self.k.sign()?).reverse());
        }
        // For either sign of a, f / a is a parabola that opens upwards.
        let f = times(f, self.a_sign);
        if f == Ordering::Less {
            return Some(if second { Ordering::Greater } else { Ordering::Less });
        }
        let slope = N::sum([[self.a, t.n], [self.k, t.e]]).sign()?;
        let slope = times(times(slope, t.e.sign()?), self.a_sign);
        Some(match (f, slope) {
            // t is the vertex, and a root: the only one.
            (_, Ordering::Equal) => Ordering::Equal,
            (Ordering::Greater, slope) => slope.reverse(),
            // t is the first root where f falls and the second where it rises.
            (_, Ordering::Less) => {
                if second {
                    Ordering::Greater
                } else {
                    Ordering::Equal
                }
            }
            (_, Ordering::Greater) => {
                if second {
                    Ordering::Equal
                } else {
                    Ordering::Less
                }
            }
        })
    }
}

/// `f(p, q)`
#[inline(never)]
fn of<N: Ring, F: Quadric<N>>(form: F, p: Homogeneous<N>, q: Homogeneous<N>) -> N {
    form.of(p, q)
}
