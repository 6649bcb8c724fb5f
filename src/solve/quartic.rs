//! The real roots of the equation of a torus along a line, counted by signs.

use super::end::{Fraction, Place, times};
use super::roots::RootOfQuadric;
use super::sturm::Chain;
use crate::number::Number;
use core::cmp::Ordering;

/// An equation of a parameter along a line.
#[derive(Clone, Copy)]
pub(super) enum Equation<N> {
    /// `x^4 + 2 p x^2 + 4 q x + s`, given by `p`, `q`, `s` and `p^2 - s`, which is computed without cancellation. It is
    /// not negative far away: the line enters first.
    Quartic([N; 4]),
    /// A cubic equation, from the lowest power to the highest, whose coefficient is positive. Only its positive roots
    /// count; that with the largest number is an exit.
    Cubic([N; 4]),
}

/// What the real roots are that count, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Roots {
    /// There is none, or the line only touches the surface from within.
    None,
    /// This many simple ones.
    Simple(usize),
    /// A double one, where the line touches the torus.
    Touch,
    /// That, and two simple ones after it.
    TouchAndTwo,
    /// Two simple ones, and the double one after them.
    TwoAndTouch,
    /// Two simple ones, and between them a double one, where the line touches the surface from within.
    TwoAroundDouble,
    /// Two double ones.
    TwoTouches,
    /// Three that are one, and a simple one.
    Triple,
    /// Four that are one, where the line touches the torus.
    Quadruple,
    /// Of a cubic with a double root: the simple one.
    Exit,
    /// That, and the double one after it.
    ExitAndTouch,
}

/// Where a root is.
#[derive(Clone, Copy)]
pub(super) enum Where<N> {
    /// A simple root, by its number from 0.
    Simple(usize),
    /// A root of a quadratic equation, or a rational one.
    Root(RootOfQuadric<N>),
}

impl Roots {
    /// How many intervals a line has inside that does not depart.
    pub(super) const fn intervals(self) -> usize {
        match self {
            Self::None => 0,
            Self::Simple(4) | Self::TouchAndTwo | Self::TwoAndTouch | Self::TwoTouches => 2,
            _ => 1,
        }
    }

    /// True if an interval is one point. That before the first exit of a line that departs has the number 0.
    pub(super) const fn touches(self, interval: usize) -> bool {
        match self {
            Self::Touch | Self::TwoTouches | Self::Quadruple => true,
            Self::TouchAndTwo => interval == 0,
            Self::TwoAndTouch | Self::ExitAndTouch => interval == 1,
            _ => false,
        }
    }

    /// True if a line that departs is inside at first.
    pub(super) const fn has_exit(self) -> bool {
        matches!(self, Self::Simple(1 | 3) | Self::Exit | Self::ExitAndTouch)
    }

    /// True if a line that departs meets the torus again from outside.
    pub(super) const fn returns(self) -> bool {
        matches!(self, Self::Simple(2 | 3) | Self::Touch | Self::ExitAndTouch)
    }

    /// True if there is such an end: see [`Roots::place`].
    pub(super) const fn has_end(self, interval: usize, is_exit: bool, departs: bool) -> bool {
        match (departs, interval) {
            (false, _) => interval < self.intervals(),
            (true, 0) => is_exit && self.has_exit(),
            (true, _) => self.returns(),
        }
    }

    /// Where an end of an interval is.
    pub(super) fn place<N: Number>(self, equation: &Equation<N>, interval: usize, is_exit: bool) -> Where<N> {
        let end = usize::from(is_exit);
        match (self, equation) {
            (Self::Simple(_), Equation::Quartic(_)) => Where::Simple(2 * interval + end),
            (Self::Simple(count), Equation::Cubic(_)) => {
                Where::Simple((2 * interval + end).saturating_sub(if count % 2 == 0 { 2 } else { 1 }))
            }
            (roots, Equation::Quartic(coefficients)) => Where::Root(roots.of_quartic(*coefficients, interval, is_exit)),
            (_, Equation::Cubic(coefficients)) => {
                let [double, simple] = multiple_roots(*coefficients);
                Where::Root(RootOfQuadric::at(if interval == 0 { simple } else { double }))
            }
        }
    }

    /// A root of a quartic of which two are one.
    #[cold]
    fn of_quartic<N: Number>(
        self,
        coefficients @ [p, q, ..]: [N; 4],
        interval: usize,
        is_exit: bool,
    ) -> RootOfQuadric<N> {
        let [n, e] = double_root(coefficients);
        match self {
            Self::TwoTouches => {
                let place = if interval == 0 { Place::First } else { Place::Second };
                RootOfQuadric::new([N::ONE, N::ZERO, p], place)
            }
            // The threefold root x = -3 q / 2 p, and -3 x.
            Self::Triple => {
                let n = three(q);
                let is_threefold = (q.sign() == Some(Ordering::Less)) != is_exit;
                RootOfQuadric::at(Fraction { n: if is_threefold { -n } else { three(n) }, e: p + p })
            }
            Self::Quadruple => RootOfQuadric::at(Fraction { n: N::ZERO, e: N::ONE }),
            roots if roots.touches(interval) => RootOfQuadric::at(Fraction { n, e }),
            // The quotient by the square of the double root x: y^2 + 2 x y + 2 p + 3 x^2.
            _ => {
                let place = if is_exit { Place::Second } else { Place::First };
                RootOfQuadric::new([e * e, n * e, N::sum([[p + p, e * e], [three(n), n]])], place)
            }
        }
    }
}

impl<N: Number> Equation<N> {
    /// Its roots that count; `None` if a sign is not known.
    #[inline(always)]
    pub(super) fn roots(&self) -> Option<Roots> {
        let discriminant = self.discriminant()?;
        match *self {
            Self::Quartic([p, _, _, difference]) => match discriminant {
                Ordering::Less => Some(Roots::Simple(2)),
                Ordering::Greater => {
                    let has_four = p.sign()? == Ordering::Less && difference.sign()? == Ordering::Greater;
                    Some(if has_four { Roots::Simple(4) } else { Roots::None })
                }
                Ordering::Equal => self.multiple(),
            },
            Self::Cubic(coefficients) => positive_roots(coefficients, discriminant),
        }
    }

    /// The sign of the discriminant.
    #[inline(always)]
    fn discriminant(&self) -> Option<Ordering> {
        match *self {
            Self::Quartic([p, q, s, difference]) => {
                let (twice, nine) = (p + p, three(three(q)));
                let rest = N::sum([[twice.scaled(3), s], [-twice, difference], [-three(nine), q]]);
                N::sum([[s * difference, difference], [q * q, rest]]).sign()
            }
            Self::Cubic([h, c, b, a]) => {
                // b^2 (c^2 - 4 b h) + a (18 b c h - 4 c^3 - 27 a h^2)
                let (bh, nine) = (b * h, three(three(h)));
                let first = N::sum([[c, c], [-bh.scaled(2), N::ONE]]);
                let second = N::sum([[(b * nine).scaled(1), c], [-(c * c).scaled(2), c], [-(a * three(nine)), h]]);
                N::sum([[b * b, first], [a, second]]).sign()
            }
        }
    }

    /// The roots of a quartic of which two are one.
    #[cold]
    fn multiple(&self) -> Option<Roots> {
        let Self::Quartic(coefficients @ [p, ..]) = *self else { return None };
        let [n, e] = double_root(coefficients);
        let p_sign = p.sign()?;
        if first_invariant(coefficients).sign()? == Ordering::Equal {
            return Some(if p_sign == Ordering::Equal { Roots::Quadruple } else { Roots::Triple });
        }
        if e.sign()? == Ordering::Equal {
            return Some(if p_sign == Ordering::Less { Roots::TwoTouches } else { Roots::None });
        }
        // The double root is x = n / e: the sign of half the second derivative there, 2 (3 x^2 + p), and that of the
        // discriminant of the quotient, -2 (x^2 + p).
        let curvature = N::sum([[three(n), n], [p * e, e]]).sign()?;
        let has_others = N::sum([[n, n], [p * e, e]]).sign()? == Ordering::Less;
        Some(match (curvature, has_others) {
            (Ordering::Greater, false) => Roots::Touch,
            (Ordering::Greater, true) if times(n.sign()?, e.sign()?) == Ordering::Less => Roots::TouchAndTwo,
            (Ordering::Greater, true) => Roots::TwoAndTouch,
            (_, true) => Roots::TwoAroundDouble,
            (_, false) => Roots::None,
        })
    }

    /// True if both have the same coefficients.
    pub(super) fn is_same(&self, other: &Self, are_same: impl Fn(N, N) -> bool) -> bool {
        match (self, other) {
            (Self::Quartic(own), Self::Quartic(other)) => own.iter().zip(other).all(|(a, b)| are_same(*a, *b)),
            (Self::Cubic(own), Self::Cubic(other)) => own.iter().zip(other).all(|(a, b)| are_same(*a, *b)),
            _ => false,
        }
    }

    /// How a root compares with `x`.
    pub(super) fn order(&self, place: Where<N>, x: Fraction<N>) -> Option<Ordering> {
        match place {
            Where::Root(root) => root.against(x),
            Where::Simple(number) => Chain { equation: self, discriminant: self.discriminant()? }.order(number, x),
        }
    }

    /// How a root compares with one of a quadratic equation.
    pub(super) fn order_with_quadric(&self, place: Where<N>, other: &RootOfQuadric<N>) -> Option<Ordering> {
        match (place, other.parameter()) {
            (Where::Root(root), _) => root.order(other),
            (_, Some(t)) => self.order(place, t),
            (Where::Simple(number), None) => {
                Chain { equation: self, discriminant: self.discriminant()? }.order_with_root(number, other)
            }
        }
    }

    /// How many of its roots count, if they are simple.
    pub(super) fn count(&self) -> Option<usize> {
        Some(if let Roots::Simple(count) = self.roots()? { count } else { 0 })
    }
}

/// The positive roots of a cubic equation whose discriminant has this sign (Descartes' rule of signs).
fn positive_roots<N: Number>([h, c, b, a]: [N; 4], discriminant: Ordering) -> Option<Roots> {
    let [h_sign, c_sign, b_sign] = [h.sign()?, c.sign()?, b.sign()?];
    // The sign of the function next to zero.
    let start = h_sign.then(c_sign).then(b_sign);
    let falls = b_sign == Ordering::Less;
    Some(match (start, discriminant) {
        (Ordering::Less, Ordering::Greater) if falls && c_sign == Ordering::Greater => Roots::Simple(3),
        (Ordering::Less, Ordering::Greater | Ordering::Less) => Roots::Simple(1),
        (_, Ordering::Greater) if falls || c_sign == Ordering::Less => Roots::Simple(2),
        (_, Ordering::Greater | Ordering::Less) => Roots::None,
        (_, Ordering::Equal) => {
            let [double, simple] = multiple_roots([h, c, b, a]);
            let is_ahead = times(double.n.sign()?, double.e.sign()?) == Ordering::Greater;
            match start {
                Ordering::Less if is_ahead && double.order(simple)? == Ordering::Greater => Roots::ExitAndTouch,
                Ordering::Less => Roots::Exit,
                _ if is_ahead => Roots::Touch,
                _ => Roots::None,
            }
        }
    })
}

/// The double and the simple root of a cubic equation that has a double one. If it is threefold, both are that.
fn multiple_roots<N: Number>([h, c, b, a]: [N; 4]) -> [Fraction<N>; 2] {
    let e = N::sum([[b, b], [-three(a), c]]);
    if e.sign() == Some(Ordering::Equal) {
        return [Fraction { n: -b, e: three(a) }; 2];
    }
    let (n, e) = (N::sum([[three(three(a)), h], [-b, c]]), e + e);
    [Fraction { n, e }, Fraction { n: -N::sum([[b, e], [n + n, a]]), e: a * e }]
}

/// `p^2 + 3 s` of a quartic.
#[inline(always)]
fn first_invariant<N: Number>([p, _, s, _]: [N; 4]) -> N {
    N::sum([[p, p], [three(s), N::ONE]])
}

/// Numerator and denominator of the double root of a quartic that has one: `-q (p^2 + 3 s) / (p (p^2 - s) + 9 q^2)`.
pub(super) fn double_root<N: Number>(coefficients @ [p, q, _, difference]: [N; 4]) -> [N; 2] {
    [-(q * first_invariant(coefficients)), N::sum([[p, difference], [three(q), three(q)]])]
}

/// `3 n`
#[inline(always)]
pub(super) fn three<N: Number>(n: N) -> N {
    n + n + n
}
