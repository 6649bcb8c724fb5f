//! Conversion of ends in computing numbers to an intersection in the ray's number type.

use super::quadratic::{Curve, End, Fraction, Interval};
use crate::intersection::{self, Span};
use crate::number::{Estimate, Number};
use crate::ray::Range;
use crate::scalar::{FromScalar, Scalar, ToScalar};
use core::cmp::Ordering;

/// A computing number for the scalars of one type.
pub(crate) trait Of<S: Scalar>: FromScalar<S> + Number<Estimate: ToScalar<S> + FromScalar<S>> {}
impl<S: Scalar, N: FromScalar<S> + Number<Estimate: ToScalar<S> + FromScalar<S>>> Of<S> for N {}

/// How an end, a root of the curve or on a plane, compares with a bound of the range.
#[inline(never)]
pub(super) fn compare<S: Scalar, N: Of<S>>(curve: &impl Curve<N>, end: &End<N>, bound: S) -> Option<Ordering> {
    end.t
        .compare(<N::Estimate as FromScalar<S>>::scalar(bound))
        .or_else(|| curve.order_for_certain(end.place, Fraction { n: N::scalar(bound), e: N::ONE }))
}

/// The `t` of an end and its part. In the exact tier, whose exact values decide whether an end lies in the range, an end outside is made
/// infinite.
#[inline(never)]
fn settle<S: Scalar, N: Of<S>>(curve: &impl Curve<N>, end: &End<N>, range: Range<S>) -> Option<intersection::End<S>> {
    let t = if <N::Estimate as ToScalar<S>>::ROUNDING_DECIDES {
        end.t.rounded()?
    } else if compare(curve, end, range.start())? == Ordering::Less {
        -S::INFINITY
    } else if compare(curve, end, range.end())? == Ordering::Greater {
        S::INFINITY
    } else {
        end.t.rounded()?
    };
    Some(intersection::End::new(t, end.part))
}

/// The entry; infinite if there is none.
#[inline(always)]
pub(super) fn entry<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    end: Option<End<N>>,
    range: Range<S>,
) -> Option<intersection::End<S>> {
    match end {
        None => Some(intersection::End::none(-S::INFINITY)),
        Some(end) => settle(curve, &end, range),
    }
}

/// The exit; infinite if there is none. It is never before the entry, although two ends close together may be rounded in the wrong order,
/// and the signs of rounded values may contradict each other.
#[inline(always)]
pub(super) fn exit<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    end: Option<End<N>>,
    range: Range<S>,
    entry: intersection::End<S>,
) -> Option<intersection::End<S>> {
    let end = match end {
        None => intersection::End::none(S::INFINITY),
        Some(end) => settle(curve, &end, range)?,
    };
    Some(if end.t < entry.t { intersection::End { t: entry.t, ..end } } else { end })
}

/// Both ends.
#[inline(never)]
pub(super) fn span<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    interval: Interval<N>,
    range: Range<S>,
) -> Option<Span<S>> {
    let enter = entry(curve, interval.enter, range)?;
    let exit = exit(curve, interval.exit, range, enter)?;
    // The ends are one point, although they may be rounded differently.
    let exit = if interval.touch { intersection::End { t: enter.t, ..exit } } else { exit };
    Some(Span { enter, exit, touch: interval.touch })
}

/// The interval of a ray that departs inwards. It has no entry, and an exit that rounding puts before the start is moved to the start.
pub(super) fn inwards<S: Scalar, N: Of<S>>(
    curve: &impl Curve<N>,
    end: Option<End<N>>,
    range: Range<S>,
) -> Option<Span<S>> {
    let end = match end {
        Some(end) if compare(curve, &end, S::ZERO)? == Ordering::Less => Some(End::start(end.part)),
        end => end,
    };
    let enter = intersection::End::none(-S::INFINITY);
    Some(Span { enter, exit: exit(curve, end, range, enter)?, touch: false })
}
