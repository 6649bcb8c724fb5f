//! The order of the simple real roots of an equation, by signs (Sturm 1829; Basu, Pollack and Roy, *Algorithms in Real
//! Algebraic Geometry*, 2.2).
//!
//! In the Sturm chain of `f` each function is the negative remainder of the division of the two before it, times a
//! positive number. As many roots lie above `x` as the signs of the chain change more often at `x` than at infinity.

use super::end::{Fraction, times};
use super::quartic::{Equation, double_root, three};
use super::roots::RootOfQuadric;
use crate::number::Number;
use core::cmp::Ordering;

/// A polynomial, its coefficients from the lowest power to the highest.
type Polynomial<N> = [N; 5];

/// The Sturm chain of an equation whose roots are all simple.
pub(super) struct Chain<'a, N> {
    pub(super) equation: &'a Equation<N>,
    /// The sign of its discriminant.
    pub(super) discriminant: Ordering,
}

impl<N: Number> Chain<'_, N> {
    /// How the root with this number, from 0 among those that count, compares with `x`; `None` if a sign is not known.
    #[inline(never)]
    pub(super) fn order(&self, number: usize, x: Fraction<N>) -> Option<Ordering> {
        self.order_by(number, |polynomial| sign_at(polynomial, x))
    }

    /// How it compares with a root of a quadratic equation.
    #[inline(never)]
    pub(super) fn order_with_root(&self, number: usize, root: &RootOfQuadric<N>) -> Option<Ordering> {
        self.order_by(number, |polynomial| root.sign_of(polynomial))
    }

    /// The same for an `x` at which this is the sign of a polynomial.
    fn order_by(&self, number: usize, sign: impl Fn(&Polynomial<N>) -> Option<Ordering>) -> Option<Ordering> {
        let last = self.last()?;
        let (mut at_x, mut at_infinity) = ([last; 5], [last; 5]);
        for (index, (at_x, at_infinity)) in at_x.iter_mut().zip(&mut at_infinity).take(4).enumerate() {
            let polynomial = self.member(index)?;
            (*at_x, *at_infinity) = (sign(&polynomial)?, leading_sign(&polynomial)?);
        }
        let beyond = changes(at_x).saturating_sub(changes(at_infinity));
        let up_to = self.equation.count()?.saturating_sub(beyond);
        Some(if number >= up_to {
            Ordering::Greater
        } else if number + 1 == up_to && at_x[0] == Ordering::Equal {
            Ordering::Equal
        } else {
            Ordering::Less
        })
    }

    /// A function of the chain; `None` if a sign is not known.
    fn member(&self, index: usize) -> Option<Polynomial<N>> {
        let zero = N::ZERO;
        Some(match (*self.equation, index) {
            (Equation::Quartic([p, q, s, _]), 0) => [s, q.scaled(2), p + p, zero, N::ONE],
            (Equation::Quartic([p, q, ..]), 1) => [q, p, zero, N::ONE, zero],
            (Equation::Quartic([p, q, s, _]), 2) => [-s, -three(q), -p, zero, zero],
            // Without a square the function before is linear, and the next is the constant.
            (Equation::Quartic([p, ..]), _) if p.sign()? == Ordering::Equal => [zero; 5],
            (Equation::Quartic(coefficients), _) => {
                let [value, slope] = double_root(coefficients);
                [value, -slope, zero, zero, zero]
            }
            (Equation::Cubic([h, c, b, a]), 0) => [h, c, b, a, zero],
            (Equation::Cubic([_, c, b, a]), 1) => [c, b + b, three(a), zero, zero],
            (Equation::Cubic([h, c, b, a]), 2) => {
                let slope = N::sum([[b, b], [-three(a), c]]);
                [N::sum([[b, c], [-three(three(a)), h]]), slope + slope, zero, zero, zero]
            }
            (Equation::Cubic(_), _) => [zero; 5],
        })
    }

    /// The sign of the last function, a constant.
    fn last(&self) -> Option<Ordering> {
        Some(match *self.equation {
            Equation::Quartic([p, q, ..]) if p.sign()? == Ordering::Equal => times(self.discriminant, q.sign()?),
            _ => self.discriminant,
        })
    }
}

/// The sign of the highest coefficient that is not zero.
fn leading_sign<N: Number>(polynomial: &Polynomial<N>) -> Option<Ordering> {
    for coefficient in polynomial.iter().rev() {
        let sign = coefficient.sign()?;
        if sign != Ordering::Equal {
            return Some(sign);
        }
    }
    Some(Ordering::Equal)
}

/// The sign of a polynomial at `n / e`, by Horner's rule: it is multiplied by `e^4`.
fn sign_at<N: Number>([c0, c1, c2, c3, c4]: &Polynomial<N>, Fraction { n, e }: Fraction<N>) -> Option<Ordering> {
    let (mut value, mut power) = (*c4, N::ONE);
    for coefficient in [c3, c2, c1, c0] {
        power = power * e;
        value = N::sum([[value, n], [*coefficient, power]]);
    }
    value.sign()
}

/// How often signs change, without those that are zero.
fn changes(signs: [Ordering; 5]) -> usize {
    let (mut last, mut changes) = (Ordering::Equal, 0);
    for sign in signs.into_iter().filter(|sign| *sign != Ordering::Equal) {
        if sign == last.reverse() {
            changes += 1;
        }
        last = sign;
    }
    changes
}
