//! The order of a torus' crossings among those of other solids.

use super::newton;
use super::quartic::{Equation, Where};
use super::roots::RootOfQuadric;
use super::torus::{Along, RoughOf, parameter};
use crate::number::{Estimate, Number};
use core::cmp::Ordering;

/// Where a line crosses a torus.
#[expect(missing_debug_implementations, reason = "the numbers of solvers need not be written")]
#[derive(Clone, Copy)]
pub struct RootOfTorus<N: Number> {
    equation: Equation<N>,
    /// `D` and `m`.
    line: [N; 2],
    place: Where<N>,
    /// Approximately; the bound of its error does not hold the next term of the function's expansion.
    t: N::Estimate,
    /// A bound of that term.
    doubt: RoughOf<N>,
}

impl<N: Number> RootOfTorus<N> {
    /// How it compares with `t`, if they are apart.
    fn compare(&self, t: N::Estimate) -> Option<Ordering> {
        let off = self.t.rough() - t.rough();
        if newton::is_below(off, self.doubt) { None } else { self.t.compare(t) }
    }

    /// How it compares with the root of another torus.
    pub(super) fn order(&self, other: &Self) -> Option<Ordering> {
        self.compare(other.t).or_else(|| {
            let are_same = |a: N, b: N| (a - b).sign() == Some(Ordering::Equal);
            let lines = self.line.into_iter().zip(other.line).all(|(a, b)| are_same(a, b));
            match (self.place, other.place) {
                (Where::Simple(own), Where::Simple(other_number)) if lines => {
                    self.equation.is_same(&other.equation, are_same).then(|| own.cmp(&other_number))
                }
                (Where::Root(own), Where::Root(other)) if lines => own.order(&other),
                _ => None,
            }
        })
    }

    /// How it compares with the root of a quadric.
    pub(super) fn order_with_quadric(&self, other: &RootOfQuadric<N>) -> Option<Ordering> {
        self.compare(other.estimate()).or_else(|| {
            let ([dd, m], equation) = (self.line, &self.equation);
            // For t = (u - m) / D the equation a t^2 + 2 k t + c, times D^2.
            let in_u = |[a, k, c]: [N; 3]| match equation {
                Equation::Quartic(_) => {
                    let k = k * dd;
                    [a, k - a * m, N::sum([[a * m, m], [-(k + k), m], [c * dd, dd]])]
                }
                Equation::Cubic(_) => [a, k, c],
            };
            equation.order_with_quadric(self.place, &other.map(in_u, |t| parameter(equation, self.line, t)))
        })
    }
}

/// The root nearest to `t` at which the line enters or leaves; `None` if it never does.
pub(super) fn nearest_to<N: Number>(
    t: RoughOf<N>,
    along: &Along<N>,
    is_exit: bool,
    departs: bool,
) -> Option<RootOfTorus<N>> {
    let mut nearest: Option<(RoughOf<N>, RootOfTorus<N>)> = None;
    for interval in [0, 1] {
        if !along.roots.has_end(interval, is_exit, departs) {
            continue;
        }
        let end = along.end(interval, is_exit);
        let off = end.t.rough() - t;
        let off = if off.sign() == Some(Ordering::Less) { -off } else { off };
        if nearest.is_none_or(|(least, _)| off.compare(least) == Some(Ordering::Less)) {
            let place = along.roots.place(&along.equation, interval, is_exit);
            let line = [along.dd, along.m];
            let root = RootOfTorus { equation: along.equation, line, place, t: end.t, doubt: along.doubt() };
            nearest = Some((off, root));
        }
    }
    nearest.map(|(_, root)| root)
}
