//! The ends of intervals of a line, their order, and their conversion to the ray's number type.

use super::attempt::{Attempt, Stop, known};
use super::local_ray::LocalRay;
use crate::intersection::{self, Intersection, Span};
use crate::number::{Estimate, Number, Ring};
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::{FromScalar, Scalar, ToScalar};
use core::cmp::Ordering;

/// A computing number for the scalars of one type.
pub trait Of<S: Scalar>: FromScalar<S> + Number<Estimate: ToScalar<S>, Long: FromScalar<S>> {}
impl<S: Scalar, N: FromScalar<S> + Number<Estimate: ToScalar<S>, Long: FromScalar<S>>> Of<S> for N {}

/// A parameter `n / e` of the line; `e` is not zero.
#[derive(Clone, Copy, Debug)]
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
#[inline(always)]
pub(super) fn times(a: Ordering, b: Ordering) -> Ordering {
    match b {
        Ordering::Less => a.reverse(),
        Ordering::Equal => Ordering::Equal,
        Ordering::Greater => a,
    }
}

/// What defines the parameter of an end.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place<N> {
    /// There is no end: the interval is infinite.
    Missing,
    /// The lower root of a quadric, or its only one.
    First,
    /// The upper root.
    Second,
    /// Where the line crosses a plane.
    At(Fraction<N>),
}

/// An end of an interval: its approximate parameter, and the part of the surface that it lies on.
#[derive(Clone, Copy)]
pub(super) struct End<N: Number> {
    pub(super) t: N::Estimate,
    pub(super) part: Part,
    pub(super) place: Place<N>,
}

impl<N: Number> End<N> {
    /// Where the line crosses a plane.
    #[inline(always)]
    pub(super) fn at(t: Fraction<N>, part: Part) -> Self {
        N::apart(
            #[inline(always)]
            || Self { place: Place::At(t), t: t.n.estimate().over(t.e.estimate()), part },
        )
    }

    /// The start of the ray.
    #[inline(always)]
    pub(super) fn start(part: Part) -> Self {
        Self { place: Place::At(Fraction { n: N::ZERO, e: N::ONE }), t: N::Estimate::ZERO, part }
    }

    /// No entry.
    #[inline(always)]
    pub(super) fn never_entered() -> Self {
        Self { place: Place::Missing, t: -N::Estimate::INFINITY, part: Part::Side }
    }

    /// No exit.
    #[inline(always)]
    pub(super) fn never_left() -> Self {
        Self { place: Place::Missing, t: N::Estimate::INFINITY, part: Part::Side }
    }

    /// The same end with the part `Side`.
    #[inline(always)]
    pub(super) fn of_side(self) -> Self {
        Self { part: Part::Side, ..self }
    }

    #[inline(always)]
    const fn is_missing(&self) -> bool {
        matches!(self.place, Place::Missing)
    }
}

/// The interval of the line inside a convex set.
#[derive(Clone, Copy)]
pub(super) struct Interval<N: Number> {
    pub(super) enter: End<N>,
    pub(super) exit: End<N>,
    /// The two ends are one point.
    pub(super) touch: bool,
}

impl<N: Number> Interval<N> {
    #[inline(always)]
    pub(super) fn everywhere() -> Self {
        Self::new(End::never_entered(), End::never_left())
    }

    #[inline(always)]
    pub(super) const fn new(enter: End<N>, exit: End<N>) -> Self {
        Self { enter, exit, touch: false }
    }
}

/// The order of roots and planes along a line, by the signs of polynomials.
pub(super) trait Curve<N: Number> {
    /// How the end compares with the parameter `t`.
    fn order_by_signs(&self, end: &End<N>, t: Fraction<N>) -> Option<Ordering>;
}

/// Of flat parts, which have no roots.
pub(super) struct Flat;

impl<N: Number> Curve<N> for Flat {
    fn order_by_signs(&self, end: &End<N>, t: Fraction<N>) -> Option<Ordering> {
        match end.place {
            Place::At(own) => own.order(t),
            Place::First | Place::Second | Place::Missing => None,
        }
    }
}

/// How the end compares with another, which is no root. The approximate parameters decide in nearly all cases.
#[inline(always)]
pub(super) fn order<N: Number>(curve: &impl Curve<N>, end: &End<N>, other: &End<N>) -> Attempt<Ordering> {
    let by_signs = || match other.place {
        Place::At(t) if N::DECIDES_BY_SIGNS => curve.order_by_signs(end, t),
        _ => None,
    };
    known(end.t.compare(other.t).or_else(by_signs))
}

/// Which results of a query are needed.
#[derive(Clone, Copy, Debug)]
pub struct Goal<S> {
    /// The ray's range.
    pub range: Range<S>,
    /// If given, only the first end at or after this `t` is needed.
    pub since: Option<S>,
}

/// How an end compares with a bound of the range, or with the start of the ray.
#[inline(always)]
pub(super) fn compare<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    line: &LocalRay<N>,
    end: &End<N>,
    bound: S,
) -> Option<Ordering> {
    let by_signs = || {
        if N::DECIDES_BY_SIGNS { curve.order_by_signs(end, Fraction { n: N::scalar(bound), e: N::ONE }) } else { None }
    };
    ToScalar::<S>::whole(end.t, line.start).compare(<N::Estimate as ToScalar<S>>::of(bound)).or_else(by_signs)
}

/// The `t` of an end and its part. In the exact tier, whose exact values decide whether an end lies in the range, an
/// end outside is made infinite.
#[inline(always)]
pub(super) fn settled<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    line: &LocalRay<N>,
    end: &End<N>,
    range: Range<S>,
) -> Attempt<intersection::End<S>> {
    N::apart(
        #[inline(always)]
        || {
            let t = if <N::Estimate as ToScalar<S>>::ROUNDING_DECIDES {
                known(ToScalar::<S>::rounded(ToScalar::<S>::whole(end.t, line.start)))?
            } else if end.is_missing() {
                if end.t.compare(N::Estimate::ZERO) == Some(Ordering::Less) { -S::INFINITY } else { S::INFINITY }
            } else if known(compare(curve, line, end, range.start()))? == Ordering::Less {
                -S::INFINITY
            } else if known(compare(curve, line, end, range.end()))? == Ordering::Greater {
                S::INFINITY
            } else {
                known(ToScalar::<S>::rounded(ToScalar::<S>::whole(end.t, line.start)))?
            };
            Ok(intersection::End::new(t, end.part))
        },
    )
}

/// The interval of a solid between two ends, or its entry alone if that is all that is needed or known.
#[inline(always)]
pub(super) fn between<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    line: &LocalRay<N>,
    enter: intersection::End<S>,
    exit: impl FnOnce() -> Attempt<End<N>>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if goal.since.is_some_and(|since| enter.t >= since) {
        return Ok(Intersection::Entered(enter));
    }
    match exit().and_then(|exit| settled(curve, line, &exit, goal.range)) {
        // Two ends close together may be rounded in the wrong order, and the signs of rounded values may contradict
        // each other.
        Ok(exit) if exit.t < enter.t => {
            Ok(Intersection::One(Span::new(enter, intersection::End { t: enter.t, ..exit })))
        }
        Ok(exit) => Ok(Intersection::One(Span::new(enter, exit))),
        Err(_) if enter.t.is_finite() && !N::IS_WIDE => Ok(Intersection::Entered(enter)),
        Err(_) => Err(Stop::Unsure),
    }
}

/// Both ends of an interval.
#[inline(always)]
pub(super) fn span<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    line: &LocalRay<N>,
    interval: &Interval<N>,
    range: Range<S>,
) -> Attempt<Span<S>> {
    let enter = settled(curve, line, &interval.enter, range)?;
    let exit = settled(curve, line, &interval.exit, range)?;
    Ok(Span::joined(enter, exit, interval.touch))
}

/// The intersection with a solid, one interval.
#[inline(always)]
pub(super) fn solid<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    line: &LocalRay<N>,
    interval: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if interval.touch {
        return Ok(Intersection::One(span(curve, line, interval, goal.range)?));
    }
    let enter = settled(curve, line, &interval.enter, goal.range)?;
    between(curve, line, enter, || Ok(interval.exit), goal)
}

/// The interval of a ray that departs inwards. It has no entry, and an exit that rounding puts before the start is
/// moved to the start.
pub(super) fn inwards<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    line: &LocalRay<N>,
    exit: &End<N>,
    range: Range<S>,
) -> Attempt<Intersection<S>> {
    let is_behind = !exit.is_missing() && known(compare(curve, line, exit, S::ZERO))? == Ordering::Less;
    let exit = if is_behind { End::start(exit.part) } else { *exit };
    let exit = settled(curve, line, &exit, range)?;
    Ok(Intersection::One(Span::new(intersection::End::none(-S::INFINITY), exit)))
}

/// The intersection with a solid that the line leaves and enters again: the first interval, and the second one, if
/// there is one.
pub(super) fn and_again<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    line: &LocalRay<N>,
    first: Intersection<S>,
    second: &Attempt<Interval<N>>,
    range: Range<S>,
) -> Attempt<Intersection<S>> {
    match (first, second) {
        (Intersection::One(first), Ok(second)) => Ok(Intersection::in_order(first, span(curve, line, second, range)?)),
        (_, Err(Stop::Unsure)) => Err(Stop::Unsure),
        (first, _) => Ok(first),
    }
}
