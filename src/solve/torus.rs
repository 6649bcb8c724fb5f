//! The torus: all points within the radius `r` of the circle of the radius `R` about the y axis.
//!
//! With `S = |p|^2 - R^2 - r^2` a point `p` is inside where `f = S^2 + 4 R^2 (y^2 - r^2) <= 0`. Let the line be
//! `o + t d` with the moment `w = o x d`, `D = |d|^2` and `m = o . d`. In `u = D t + m`, the distance along the line from
//! the point closest to the centre, times `|d|`, the equation has no cubic term and no denominators:
//!
//! `D^2 f = u^4 + 2 p u^2 + 4 q u + s` with
//! `p = e + 2 (R d_y)^2`, `q = 2 R^2 g d_y`, `s = e^2 + 4 R^2 (g - r D) (g + r D)`,
//! `e = |w|^2 - D (R^2 + r^2)`, `g = d_z w_x - d_x w_z`.
//!
//! (On the line `D |p|^2 = u^2 + |w|^2` and `D y = u d_y + g`.) With
//! `c = p^2 - s = 2 (R d_y)^2 (e + p) - 4 R^2 (g - r D) (g + r D)` its discriminant has the sign of
//! `s c^2 + q^2 (16 p s - 2 p c - 27 q^2)`: negative for two real roots, positive for four if `p < 0` and `c > 0`, and
//! otherwise for none (Rees, *Graphical Discussion of the Roots of a Quartic Equation*, 1922). In a plane of constant
//! height `q = 0`, and where that plane touches the torus `c = 0`, in rounded numbers too.
//!
//! A line that departs from the torus at `t = 0` meets it again where `f / t = 0`, which is cubic.

use super::attempt::{Attempt, Stop, known};
use super::end::{Curve, End, Fraction, Goal, Interval, Of, Place, and_again, inwards, settled, solid, span};
use super::local_ray::LocalRay;
use super::newton;
use super::quartic::{Equation, Roots, Where};
use crate::intersection::{Intersection, Span};
use crate::number::{Estimate, Number, Ring};
use crate::part::Part;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// The torus along the line `o + x d`: `f(o + x d) = f + 2 h x + a x^2` up to the second order.
#[derive(Clone, Copy)]
pub(crate) struct Torus<N> {
    pub(super) o: [N; 3],
    pub(super) d: [N; 3],
    /// `R` and `r`.
    pub(super) radii: [N; 2],
}

impl<N: Ring> Torus<N> {
    /// `R^2 + r^2`
    #[inline(always)]
    fn squares(&self) -> N {
        let [major, minor] = self.radii;
        N::sum([[major, major], [minor, minor]])
    }
    /// `S`
    #[inline(always)]
    fn power(&self) -> N {
        let [x, y, z] = self.o;
        N::sum([[x, x], [y, y], [z, z], [-self.squares(), N::ONE]])
    }
    /// `2 R`
    #[inline(always)]
    fn twice(&self) -> N {
        let [major, _] = self.radii;
        major + major
    }
    /// `f` at `o`.
    #[inline(always)]
    pub(super) fn value(&self) -> N {
        let (power, y, r) = (self.power(), self.twice() * self.o[1], self.twice() * self.radii[1]);
        N::sum([[power, power], [y, y], [-r, r]])
    }
    /// Half the gradient of `f`: `2 S p + 4 R^2 y e_y`.
    #[inline(always)]
    pub(super) fn gradient(&self) -> [N; 3] {
        let ([x, y, z], power) = (self.o, self.power());
        let (twice, two) = (self.twice(), power + power);
        [two * x, N::sum([[two, y], [twice * twice, y]]), two * z]
    }
    /// `f`, `h` and `a`, where `h` is the product of half the gradient and `d`.
    #[inline(always)]
    fn expansion(&self) -> [N; 3] {
        let ([_, y, _], [_, dy, _], twice) = (self.o, self.d, self.twice());
        let (power, m) = (self.power(), N::scalar_product(self.o, self.d));
        let ([y, dy, r], two) = ([y, dy, self.radii[1]].map(|length| twice * length), power + power);
        [
            N::sum([[power, power], [y, y], [-r, r]]),
            N::sum([[two, m], [y, dy]]),
            N::sum([[m + m, m + m], [two, N::scalar_product(self.d, self.d)], [dy, dy]]),
        ]
    }
    /// `h`
    #[inline(always)]
    pub(super) fn slope(&self) -> N {
        self.expansion()[1]
    }
    /// `a`
    #[inline(always)]
    pub(super) fn bending(&self) -> N {
        self.expansion()[2]
    }
}

/// A torus and a line, both divided by `2^scale`, so that no power of a length overflows.
pub(super) struct Along<N: Number> {
    torus: Torus<N>,
    /// `D`
    pub(super) dd: N,
    /// `m`
    pub(super) m: N,
    scale: i32,
    pub(super) equation: Equation<N>,
    pub(super) roots: Roots,
    /// The simple roots of the equation, approximately.
    rough: [RoughOf<N>; 4],
    /// A length below which the surface is nearly flat, times `D`.
    size: RoughOf<N>,
}

/// An approximate number, whose error is of no interest.
pub(super) type RoughOf<N> = <<N as Number>::Estimate as Estimate>::Rough;

fn rough<N: Number>(number: N) -> RoughOf<N> {
    number.estimate().rough()
}

impl<N: Number> Along<N> {
    #[inline(always)]
    pub(super) fn new<S: Scalar>(line: &LocalRay<N>, radii: [S; 2], scale: i32) -> Attempt<Self>
    where
        N: Of<S>,
    {
        let torus = Torus {
            o: line.origin.map(|c| c.scaled(-scale)),
            d: line.direction,
            radii: radii.map(|radius| N::scalar(radius).scaled(-scale)),
        };
        let (dd, m) = (N::scalar_product(torus.d, torus.d), N::scalar_product(torus.o, torus.d));
        let [major, minor] = torus.radii;
        let w = N::vector_product(torus.o, torus.d);
        let (ww, around) = (N::scalar_product(w, w), major + minor);
        // The square of half the chord in the ball around the torus, times D.
        let square = N::sum([[dd, around * around], [-ww, N::ONE]]);
        let square = if line.departs() {
            rough(square)
        } else if known(square.sign())? == Ordering::Less {
            return Err(Stop::Miss);
        } else {
            rough(square)
        };
        let half = if square.sign() == Some(Ordering::Greater) { square.square_root() } else { Ring::ZERO };
        let equation = if line.departs() { torus.after_departure(dd, m) } else { torus.depressed(dd, w, ww) };
        let roots = known(equation.roots())?;
        let size = (half * rough(minor)).over(rough(major));
        let rough = match (roots, equation) {
            (Roots::None, Equation::Quartic(_)) => return Err(Stop::Miss),
            (Roots::Simple(count), Equation::Quartic([p, q, _, c])) => {
                newton::of_quartic([p, q, c].map(rough), count, half)
            }
            (Roots::Simple(count), Equation::Cubic(coefficients)) => {
                let most_and_size = [half - rough(m), size].map(|length| length.over(rough(dd)));
                newton::of_cubic(coefficients.map(rough), count, most_and_size)
            }
            _ => [Ring::ZERO; 4],
        };
        Ok(Self { torus, dd, m, scale, equation, roots, rough, size })
    }

    /// An end of one of the intervals, of which the departure of a line begins the first.
    pub(super) fn end(&self, interval: usize, is_exit: bool) -> End<N> {
        let found = self.roots.place(&self.equation, interval, is_exit);
        let t = match (found, self.equation) {
            (Where::Simple(number), equation) => {
                let [first, second, third, fourth] = self.rough;
                let root = match number {
                    0 => first,
                    1 => second,
                    2 => third,
                    _ => fourth,
                };
                let t = match equation {
                    Equation::Quartic(_) => (root - rough(self.m)).over(rough(self.dd)),
                    Equation::Cubic(_) => root,
                };
                self.corrected(t, is_exit)
            }
            (Where::Root(root), Equation::Quartic(_)) => {
                let t = (root.estimate() - self.m.estimate()).over(self.dd.estimate());
                if !self.roots.touches(interval) {
                    self.corrected(t.rough(), is_exit)
                } else if self.is_near_origin(t.rough()) {
                    let [_, h, a] = self.torus.expansion().map(N::estimate);
                    (-h).over(a)
                } else {
                    t
                }
            }
            (Where::Root(root), Equation::Cubic(_)) => root.estimate(),
        };
        let place = if is_exit { Place::Second } else { Place::First };
        End { t: t.scaled(self.scale), part: Part::Side, place }
    }

    /// The root next to `t` of the function's expansion up to the second order, as often as that changes it by much.
    /// The error is that of the last expansion.
    fn corrected(&self, t: RoughOf<N>, is_exit: bool) -> N::Estimate {
        let mut t = t;
        for _ in 0..8 {
            if self.is_near_origin(t) {
                let expansion = match self.equation {
                    Equation::Quartic(_) => self.torus.expansion(),
                    Equation::Cubic([h, c, b, _]) => [h, c.scaled(-1), b],
                };
                return newton::step(expansion.map(N::estimate), is_exit);
            }
            let from = N::Estimate::exactly(t);
            let step = newton::step(self.expansion(from), is_exit);
            let next = from + step;
            if self.is_near_origin(step.rough()) {
                return next;
            }
            t = next.rough();
        }
        let t = N::Estimate::exactly(t);
        t + newton::step(self.expansion(t), is_exit)
    }

    /// True if the expansion at the line's origin gives a root at `t` to the precision of the number. Its coordinates
    /// are known best, and such a `t` must be accurate relative to itself.
    fn is_near_origin(&self, t: RoughOf<N>) -> bool {
        newton::is_below(t * rough(self.dd), self.size.scaled(-<RoughOf<N> as Estimate>::DIGITS / 3))
    }

    /// A bound of what the last expansion leaves out.
    pub(super) fn doubt(&self) -> RoughOf<N> {
        self.size.scaled(16 - <RoughOf<N> as Estimate>::DIGITS).over(rough(self.dd))
    }

    /// `f`, `h` and `a` of `f + 2 h x + a x^2` at `t`. After a departure `f` is divided by `t`.
    fn expansion(&self, t: N::Estimate) -> [N::Estimate; 3] {
        match self.equation {
            Equation::Quartic(_) => {
                let [o, d] = [self.torus.o, self.torus.d].map(|v| v.map(N::estimate));
                let at = |i: usize| N::Estimate::sum([[o[i], N::Estimate::ONE], [d[i], t]]);
                let torus = Torus { o: [at(0), at(1), at(2)], d, radii: self.torus.radii.map(N::estimate) };
                torus.expansion()
            }
            Equation::Cubic(coefficients) => {
                let [h, c, b, a] = coefficients.map(N::estimate);
                let (at, three) = (a * t, a + a + a);
                [((at + b) * t + c) * t + h, ((three * t + b + b) * t + c).scaled(-1), three * t + b]
            }
        }
    }

    /// One of the intervals inside.
    fn interval(&self, interval: usize) -> Interval<N> {
        let touch = self.roots.touches(interval);
        let enter = self.end(interval, false);
        Interval { enter, exit: if touch { enter } else { self.end(interval, true) }, touch }
    }
}

impl<N: Number> Torus<N> {
    /// The equation of a line that does not depart.
    #[inline(always)]
    fn depressed(&self, dd: N, [wx, _, wz]: [N; 3], ww: N) -> Equation<N> {
        let ([dx, dy, dz], [major, minor]) = (self.d, self.radii);
        let e = N::sum([[ww, N::ONE], [-dd, self.squares()]]);
        let (g, rd, y, twice) = (N::sum([[dz, wx], [-dx, wz]]), minor * dd, major * dy, self.twice());
        let (rise, product) = ((y + y) * y, (g - rd) * (g + rd));
        let (p, square) = (e + rise, twice * twice);
        let s = N::sum([[e, e], [square, product]]);
        let difference = N::sum([[rise, e + p], [-square, product]]);
        Equation::Quartic([p, twice * y * g, s, difference])
    }

    /// The equation of a line that departs, which is `f / t`.
    fn after_departure(&self, dd: N, m: N) -> Equation<N> {
        let [_, h, a] = self.expansion();
        Equation::Cubic([h + h, a, (dd * m).scaled(2), dd * dd])
    }
}

/// The ends of one of the intervals.
struct Ends<'a, N: Number> {
    along: &'a Along<N>,
    interval: usize,
}

impl<N: Number> Curve<N> for Ends<'_, N> {
    fn order_by_signs(&self, end: &End<N>, t: Fraction<N>) -> Option<Ordering> {
        let is_exit = match end.place {
            Place::At(own) => return own.order(t),
            Place::Missing => return None,
            Place::First => false,
            Place::Second => true,
        };
        let Along { dd, m, scale, equation, roots, .. } = self.along;
        let t = Fraction { n: t.n.scaled(-scale), e: t.e };
        equation.order(roots.place(equation, self.interval, is_exit), parameter(equation, [*dd, *m], t))
    }
}

/// The parameter in which an equation is, from `t`.
pub(super) fn parameter<N: Number>(equation: &Equation<N>, [dd, m]: [N; 2], t: Fraction<N>) -> Fraction<N> {
    match equation {
        Equation::Quartic(_) => Fraction { n: N::sum([[dd, t.n], [m, t.e]]), e: t.e },
        Equation::Cubic(_) => t,
    }
}

/// The torus of these radii, the major and the minor one.
#[inline(always)]
pub(crate) fn torus<S: Scalar, N: Of<S>>(line: &LocalRay<N>, radii: [S; 2], goal: Goal<S>) -> Attempt<Intersection<S>> {
    intersect::<S, N::Long>(&line.long(), radii, goal)
}

#[inline(never)]
fn intersect<S: Scalar, N: Of<S>>(line: &LocalRay<N>, radii: [S; 2], goal: Goal<S>) -> Attempt<Intersection<S>> {
    let along = Along::new(line, radii, S::binary_exponent(radii[0]))?;
    if line.departs() {
        return departing(line, &along, goal);
    }
    let ends = |interval: usize| Ends { along: &along, interval };
    if along.roots.intervals() == 1 {
        return solid(&ends(0), line, &along.interval(0), goal);
    }
    let enter = settled(&ends(0), line, &along.end(0, false), goal.range)?;
    if goal.since.is_some_and(|since| enter.t >= since) && !along.roots.touches(0) {
        return Ok(Intersection::Entered(enter));
    }
    let exit =
        if along.roots.touches(0) { Ok(enter) } else { settled(&ends(0), line, &along.end(0, true), goal.range) };
    let first = match exit {
        Ok(exit) => Span::joined(enter, exit, along.roots.touches(0)),
        Err(_) if enter.t.is_finite() && !N::IS_WIDE => return Ok(Intersection::Entered(enter)),
        Err(_) => return Err(Stop::Unsure),
    };
    // Also if only the second interval is needed: so that both are known by the same number.
    match span(&ends(1), line, &along.interval(1), goal.range) {
        Ok(second) => Ok(Intersection::in_order(first, second)),
        Err(_) if enter.t.is_finite() && !N::IS_WIDE => Ok(Intersection::Entered(enter)),
        Err(_) => Err(Stop::Unsure),
    }
}

/// A ray that departs from the torus. Where its coordinates say that it leads to the other side, it leaves where it
/// starts, or the chord at its start does not count.
#[inline(never)]
fn departing<S: Scalar, N: Of<S>>(line: &LocalRay<N>, along: &Along<N>, goal: Goal<S>) -> Attempt<Intersection<S>> {
    let ends = |interval: usize| Ends { along, interval };
    let again = if along.roots.returns() { Ok(along.interval(1)) } else { Err(Stop::Miss) };
    if line.leads_outwards() {
        return Ok(Intersection::One(span(&ends(1), line, &again?, goal.range)?));
    }
    let exit = if along.roots.has_exit() { along.end(0, true) } else { End::start(Part::Side) };
    let first = inwards(&ends(0), line, &exit, goal.range)?;
    and_again(&ends(1), line, first, &again, goal.range)
}
