//! Floor 4: the one quadratic solver.
//!
//! Along the line `o + t d` a quadric's equation becomes `f(t) = a t^2 + 2 k t + c`, with `f <= 0` inside. The
//! primitives give `a`, `k` and the discriminant `D = k^2 - a c`, which they never compute as that difference: `a`, `k`
//! and `c` are rounded, and far away or near grazing the difference holds nothing but their rounding. They use the ray's
//! moment `w = o x d` instead; each says how.

use crate::arithmetic::Arithmetic;
use crate::line::Line;
use crate::part::Part;
use crate::ray::Leaving;
use crate::scalar::{Plain, PlainLine, Real, Scalar, UnitScalar};
use crate::span::{End, Span};
use core::cmp::Ordering;

/// The coefficients of `a t^2 + 2 k t + c` without `c`, and the discriminant `k^2 - a c` as a difference.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadric<R> {
    pub(crate) a: R,
    pub(crate) k: R,
    /// The discriminant is `positive - negative`, both at least zero: made from the line's moment, not from `k` and `c`.
    pub(crate) positive: R,
    pub(crate) negative: R,
}

/// The coefficients that can cancel, held to twice the precision; each is made only where it decides something.
pub(crate) trait Careful<R> {
    /// `k`
    fn k(&self) -> R;
    /// `c`
    fn c(&self) -> R;
    /// `k^2 - a c`, from the moment.
    fn discriminant(&self) -> R;
}

/// Where along a line a quadric's `f` is zero or below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Inside<S> {
    /// Nowhere.
    Nowhere,
    /// Between two roots, or at one.
    Between(Span<S>),
    /// Up to the first root and from the second on.
    Beyond(S, S),
    /// Up to the only root.
    Until(S),
    /// From the only root on.
    From(S),
    /// Everywhere.
    Everywhere,
    /// `f` is zero everywhere: the line lies in the surface.
    InSurface,
}

impl<R: Real> Quadric<R> {
    /// Solves for `f <= 0`; `careful` is asked only where it decides something.
    #[inline]
    pub(crate) fn solve<S: Scalar, T: Arithmetic<S, Real = R>>(
        self,
        line: &Line<S>,
        careful: &impl Careful<R>,
    ) -> Inside<S> {
        let Self { a, mut k, positive, negative } = self;
        if a.is_zero() {
            return Self::solve_linear::<S, T>(line, careful.k(), careful.c());
        }
        let mut discriminant = positive - negative;
        if T::COMPENSATES && discriminant.abs() < positive.times_power_of_two(-3) {
            // Grazing: most of the difference is rounding.
            (k, discriminant) = (careful.k(), careful.discriminant());
        }
        if discriminant.is_negative() && !a.is_negative() {
            return Inside::Nowhere;
        }
        // With a < 0 the discriminant cannot be negative but by rounding: the square root is then zero.
        let root = discriminant.sqrt();
        if root.is_zero() {
            let t = line.t::<T>(-k, a);
            let end = End::new(t, Part::Side);
            return if a.is_negative() {
                Inside::Beyond(t, t)
            } else {
                Inside::Between(Span { enter: end, exit: end, touch: true })
            };
        }
        // -k - root and -k + root: where k and the root have nearly the same size one of them cancels, and
        // c / q takes its place (Press et al., Numerical Recipes, 5.6).
        let magnitude = k.abs();
        let cancels =
            T::COMPENSATES && magnitude < root.times_power_of_two(1) && root < magnitude.times_power_of_two(1);
        let (low, high) = if !cancels {
            (line.t::<T>(-k - root, a), line.t::<T>(-k + root, a))
        } else if k.is_negative() {
            let q = root - k;
            (line.t::<T>(careful.c(), q), line.t::<T>(q, a))
        } else {
            let q = -k - root;
            (line.t::<T>(q, a), line.t::<T>(careful.c(), q))
        };
        // Equal after rounding can come out in the wrong order.
        let (low, high) = if a.is_negative() { (high, low) } else { (low, high) };
        let (low, high) = if low <= high { (low, high) } else { (high, low) };
        if a.is_negative() {
            Inside::Beyond(low, high)
        } else {
            Inside::Between(Span::new(End::new(low, Part::Side), End::new(high, Part::Side)))
        }
    }

    /// `2 k t + c <= 0`: a line parallel to an asymptote has one root, not none.
    #[cold]
    fn solve_linear<S: Scalar, T: Arithmetic<S, Real = R>>(line: &Line<S>, k: R, c: R) -> Inside<S> {
        if k.is_zero() {
            return if c.is_zero() {
                Inside::InSurface
            } else if c.is_negative() {
                Inside::Everywhere
            } else {
                Inside::Nowhere
            };
        }
        let t = line.t::<T>(-c, k.times_power_of_two(1));
        if k.is_negative() { Inside::From(t) } else { Inside::Until(t) }
    }

    /// Solves for a ray that departs from this quadric: `c` is exactly zero, and the other root is `-2k/a`.
    ///
    /// The side to which it leaves gives the sign of `k`, whatever its rounding.
    pub(crate) fn solve_departing<S: Scalar, T: Arithmetic<S, Real = R>>(
        self,
        line: &Line<S>,
        leaving: Leaving,
    ) -> Inside<S> {
        let a = self.a;
        let k = match leaving {
            Leaving::Inwards => -self.k.abs(),
            Leaving::Outwards => self.k.abs(),
        };
        if a.is_zero() {
            return match leaving {
                Leaving::Inwards => Inside::From(S::ZERO),
                Leaving::Outwards => Inside::Until(S::ZERO),
            };
        }
        let other = if k.is_zero() { S::ZERO } else { line.t::<T>(k.times_power_of_two(1), -a) };
        let (low, high) = if other < S::ZERO { (other, S::ZERO) } else { (S::ZERO, other) };
        if a.is_negative() {
            Inside::Beyond(low, high)
        } else {
            Inside::Between(Span::new(End::new(low, Part::Side), End::new(high, Part::Side)))
        }
    }
}

/// Where along a line `low <= y <= high`; a missing bound is infinitely far away. The ends bear the parts of the
/// two planes. The planes themselves belong to the slab, so that a line in one of them lies inside.
#[inline]
pub(crate) fn slab<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, low: Option<S>, high: Option<S>) -> Option<Span<S>> {
    let ([_, y, _], [_, rest, _], [_, slope, _]) = (line.point::<T>(), line.rest::<T>(), line.along::<T>());
    if slope.is_zero() {
        let outside = low.is_some_and(|low| line.compare_height(low) == Some(Ordering::Less))
            || high.is_some_and(|high| line.compare_height(high) == Some(Ordering::Greater));
        return (!outside).then(Span::everywhere);
    }
    // t = (bound - oy) / dy; the articles that this crate grew from print -(oy + bound) / dy.
    let end = |bound: Option<S>, part: Part, missing: S| {
        bound.map_or(End::none(missing), |bound| End::new(line.t::<T>(T::real(bound) - y - rest, slope), part))
    };
    Some(if slope.is_negative() {
        Span::new(end(high, Part::Top, -S::INFINITY), end(low, Part::Base, S::INFINITY))
    } else {
        Span::new(end(low, Part::Base, -S::INFINITY), end(high, Part::Top, S::INFINITY))
    })
}

/// Whether rounding may decide how the ends of a side and of the planes that close it follow each other.
#[inline(always)]
pub(crate) fn are_close<S: Scalar>(side: &Span<S>, planes: &Span<S>) -> bool {
    let close = |a: End<S>, b: End<S>| S::plain_close(a.t, b.t);
    close(side.enter, planes.enter)
        || close(side.exit, planes.exit)
        || close(side.enter, planes.exit)
        || close(side.exit, planes.enter)
}

/// [`slab`] between two bounds, if plain integers tell.
#[inline(always)]
pub(crate) fn plain_slab<S: Scalar>(line: &PlainLine<S>, low: S, high: S) -> Plain<Span<S>> {
    let ([_, y, _], [_, dy, _]) = (line.origin, line.direction);
    match S::plain_crossings(*line, [low, high]) {
        Plain::Found([low, high]) => {
            let (base, top) = (End::new(low, Part::Base), End::new(high, Part::Top));
            Plain::Found(if dy < S::Unit::ZERO { Span::new(top, base) } else { Span::new(base, top) })
        }
        Plain::Miss if line.finer == 0 => {
            if low <= y && y <= high {
                Plain::Found(Span::everywhere())
            } else {
                Plain::Miss
            }
        }
        _ => Plain::Unclear,
    }
}
