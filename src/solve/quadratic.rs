//! A quadric along a line: its roots, and their order with planes.

use super::attempt::{Attempt, Stop, known};
use super::end::{Curve, End, Fraction, Interval, Place, times};
use super::local_ray::LocalRay;
use super::quadric::Quadric;
use crate::number::{Difference, Estimate, Number, Ring};
use crate::part::Part;
use core::cmp::Ordering;

/// The parameters `t` of the line with `f(t) <= 0`, where `f` is a quadric along the line.
#[derive(Clone, Copy)]
pub(super) enum Inside {
    Nowhere,
    /// From the first to the second root; `true` if they are one.
    Between(bool),
    /// Up to the first root and from the second on.
    Beyond,
    /// Up to the only root, of a linear `f`.
    Until,
    /// From the only root on, of a linear `f`.
    From,
    Everywhere,
    /// Everywhere, and `f` is zero.
    InSurface,
}

/// A quadric along the line: `f = a t^2 + 2 k t + c`.
///
/// For a line that departs from the quadric, `t = 0` is a root, whatever its rounded coordinates (rule 8 of the
/// contract, in the crate's documentation): `c = 0`, the discriminant is `k^2`, and the other root is `-2 k / a`.
#[derive(Clone, Copy)]
pub(super) struct Quadratic<N, Q> {
    pub(super) quadric: Q,
    departs: bool,
    pub(super) a: N,
    pub(super) k: N,
    discriminant: N,
    pub(super) a_sign: Ordering,
    pub(super) inside: Inside,
    /// The line's origin was moved to the point closest to the frame's origin.
    is_moved: bool,
}

impl<N: Number, Q: Quadric<N>> Quadratic<N, Q> {
    #[inline(always)]
    pub(super) fn new(quadric: Q, line: &LocalRay<N>, departs: bool) -> Attempt<Self> {
        N::apart(
            #[inline(always)]
            || Self::solved(quadric, line, departs),
        )
    }

    #[inline(always)]
    fn solved(quadric: Q, line: &LocalRay<N>, departs: bool) -> Attempt<Self> {
        let a = quadric.a();
        let a_sign = match a.sign() {
            // Squares may underflow; then a number with an error bound cannot tell that their sum is zero.
            None if quadric.is_linear() => Ordering::Equal,
            sign => known(sign)?,
        };
        let mut discriminant = N::ZERO;
        // The result is built in one place, so that the compiler keeps its parts in registers.
        let (inside, k) = if a_sign == Ordering::Equal {
            Self::linear(quadric, departs)?
        } else if departs {
            let k = quadric.k();
            let touch = known(k.sign())? == Ordering::Equal;
            (if a_sign == Ordering::Greater { Inside::Between(touch) } else { Inside::Beyond }, k)
        } else {
            discriminant = quadric.discriminant(a);
            let sign = known(discriminant.sign_among(Difference::Squares, || quadric.terms(a) + line.far(N::MOVED)))?;
            let inside = match (a_sign, sign) {
                (Ordering::Greater, Ordering::Less) if !line.departs() => return Err(Stop::Miss),
                // The line departs from another part, such as a cap, and meets that even if it misses the side.
                (Ordering::Greater, Ordering::Less) => Inside::Nowhere,
                (Ordering::Greater, sign) => Inside::Between(sign == Ordering::Equal),
                (_, Ordering::Less) if Q::MAY_HOLD_LINES => Inside::Everywhere,
                // Only rounding makes it negative: a < 0 occurs with lines steeper than a cone's side, and then
                // k^2 >= a c by the reversed Cauchy-Schwarz inequality for u . u - v^2. The next number decides.
                // Numbers without a next one take zero for it, except where it is not small since terms overflowed.
                (_, Ordering::Less) => {
                    let k = quadric.k();
                    let is_small = || ((k * k).scaled(-16) + discriminant).sign() == Some(Ordering::Greater);
                    if !(N::IS_WIDE || N::KNOWS_ZERO && is_small()) {
                        return Err(Stop::Unsure);
                    }
                    discriminant = N::ZERO;
                    Inside::Beyond
                }
                _ => Inside::Beyond,
            };
            (inside, quadric.k())
        };
        Ok(Self { quadric, departs, a, k, discriminant, a_sign, inside, is_moved: line.start.is_some() })
    }

    /// The case `a = 0`, a line parallel to the axis of a cylinder or to a generator of a cone: `f = 2 k t + c`.
    #[inline(never)]
    fn linear(quadric: Q, departs: bool) -> Attempt<(Inside, N)> {
        let k = quadric.k();
        let k_sign = if quadric.is_constant() { Ordering::Equal } else { known(k.sign())? };
        let inside = match k_sign {
            Ordering::Less => Inside::From,
            Ordering::Greater => Inside::Until,
            Ordering::Equal => {
                let c = if departs { N::ZERO } else { quadric.c() };
                match known(c.sign())? {
                    Ordering::Less => Inside::Everywhere,
                    Ordering::Equal if !N::KNOWS_ZERO => return Err(Stop::Unsure),
                    Ordering::Equal => Inside::InSurface,
                    Ordering::Greater => Inside::Nowhere,
                }
            }
        };
        Ok((inside, k))
    }

    /// The roots, the lower one first; the only root of a linear function is returned twice.
    #[inline(always)]
    pub(super) fn ends(&self) -> [End<N>; 2] {
        let [first, second] = N::apart(
            #[inline(always)]
            || self.roots(),
        );
        let end = |place: Place<N>, t: N::Estimate| End { place, t, part: Part::Side };
        [end(Place::First, first), end(Place::Second, second)]
    }

    /// The interval between the roots.
    #[inline(always)]
    pub(super) fn between(&self, touch: bool) -> Interval<N> {
        let [enter, exit] = self.ends();
        Interval { enter, exit, touch }
    }

    /// The interval of the line inside the quadric, if it is one.
    #[inline(always)]
    pub(super) fn interval(&self) -> Attempt<Interval<N>> {
        Ok(match self.inside {
            Inside::Nowhere | Inside::Beyond => return Err(Stop::Miss),
            Inside::Between(touch) => self.between(touch),
            Inside::Until => self.until_first(),
            Inside::From => self.since_second(),
            Inside::Everywhere | Inside::InSurface => Interval::everywhere(),
        })
    }

    /// Up to the first root, or the only one.
    pub(super) fn until_first(&self) -> Interval<N> {
        Interval::new(End::never_entered(), self.ends()[0])
    }

    /// From the second root on, or the only one.
    pub(super) fn since_second(&self) -> Interval<N> {
        Interval::new(self.ends()[1], End::never_left())
    }

    /// The roots' parameters, approximately.
    #[inline(always)]
    fn roots(&self) -> [N::Estimate; 2] {
        let (a, k) = (self.a.estimate(), self.k.estimate());
        if self.a_sign == Ordering::Equal {
            return [if self.departs { N::Estimate::ZERO } else { linear_root(self.quadric.c().estimate(), k) }; 2];
        }
        if self.departs {
            return departing_roots(self.a_sign, a, k);
        }
        let root = if matches!(self.inside, Inside::Between(true)) {
            N::Estimate::ZERO
        } else {
            self.discriminant.estimate().square_root()
        };
        // From the point of closest approach k is zero up to rounding: (-k -+ root) / a is accurate.
        let sign = if self.is_moved && k.is_within(root, Q::SPREAD) { None } else { k.sign() };
        // Without cancellation: q = -(k + sign(k) root), and the roots are q / a and c / q (Press et al., *Numerical
        // Recipes*, 5.6).
        let [lower, upper] = match sign {
            Some(Ordering::Greater) => {
                let q = -(k + root);
                [q.over(a), self.quadric.c().estimate().over(q)]
            }
            Some(Ordering::Less) => {
                let q = root - k;
                [self.quadric.c().estimate().over(q), q.over(a)]
            }
            // k is zero, or is taken to be small as above.
            _ => [(-k - root).over(a), (root - k).over(a)],
        };
        if self.a_sign == Ordering::Greater { [lower, upper] } else { [upper, lower] }
    }

    /// `a`, `k` and `c`.
    pub(super) fn coefficients(&self) -> [N; 3] {
        [self.a, self.k, if self.departs { N::ZERO } else { self.quadric.c() }]
    }

    /// The sign of `f` at `t = n / e`.
    fn sign_at(&self, t: Fraction<N>) -> Option<Ordering> {
        if self.departs {
            // n (a n + 2 k e), over e^2
            let k = self.k + self.k;
            return Some(times(t.n.sign()?, N::sum([[self.a, t.n], [k, t.e]]).sign()?));
        }
        self.quadric.at(t.n, t.e).sign()
    }
}

/// The root of `2 k t + c`.
#[inline(never)]
fn linear_root<E: Estimate>(c: E, k: E) -> E {
    (-c).over(k + k)
}

/// The roots of `a t^2 + 2 k t`.
#[inline(never)]
fn departing_roots<E: Estimate>(a_sign: Ordering, a: E, k: E) -> [E; 2] {
    let other = (-(k + k)).over(a);
    if k.sign() == Some(a_sign) { [other, E::ZERO] } else { [E::ZERO, other] }
}

impl<N: Number, Q: Quadric<N>> Curve<N> for Quadratic<N, Q> {
    #[inline(never)]
    fn order_by_signs(&self, end: &End<N>, t: Fraction<N>) -> Option<Ordering> {
        let second = match end.place {
            Place::At(own) => return own.order(t),
            Place::Missing => return None,
            Place::First => false,
            Place::Second => true,
        };
        let f = self.sign_at(t)?;
        if self.a_sign == Ordering::Equal {
            // f = 2 k t + c: the root is before t where f has the sign of k.
            return Some(times(f, self.k.sign()?).reverse());
        }
        // The parabola f / a opens upwards for either sign of a; its slope at n / e is 2 (a n + k e) / (a e).
        let f = times(f, self.a_sign);
        if f == Ordering::Less {
            return Some(root_beside(second, f, Ordering::Equal));
        }
        let slope = N::sum([[self.a, t.n], [self.k, t.e]]).sign()?;
        Some(root_beside(second, f, times(times(slope, t.e.sign()?), self.a_sign)))
    }
}

/// How the first or the second root of a parabola that opens upwards compares with a parameter, from the signs of the
/// parabola, `f`, and of its slope there. (The slope is not needed where `f < 0`.)
#[inline(always)]
pub(super) fn root_beside(second: bool, f: Ordering, slope: Ordering) -> Ordering {
    match (f, slope) {
        (Ordering::Less, _) => {
            if second {
                Ordering::Greater
            } else {
                Ordering::Less
            }
        }
        // The parameter is the vertex. Since there are roots, f = 0 there, and it is the only root.
        (_, Ordering::Equal) => Ordering::Equal,
        (Ordering::Greater, slope) => slope.reverse(),
        // The parameter is the first root where the parabola falls and the second where it rises.
        (_, Ordering::Less) if second => Ordering::Greater,
        (_, Ordering::Less) => Ordering::Equal,
        (_, Ordering::Greater) if second => Ordering::Equal,
        (_, Ordering::Greater) => Ordering::Less,
    }
}
