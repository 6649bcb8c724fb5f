//! Floor 3: intervals along a line, and the one rule by which ends become hits.

use crate::hit::{Crossing, Hit, Hits};
use crate::part::Part;
use crate::ray::{Leaving, Range};
use crate::scalar::Scalar;

/// One end of an interval: where the line crosses the surface, and on which part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End<S> {
    /// [`Scalar::INFINITY`] of either sign where there is no end.
    pub(crate) t: S,
    pub(crate) part: Part,
}

impl<S: Scalar> End<S> {
    #[inline(always)]
    pub(crate) const fn new(t: S, part: Part) -> Self {
        Self { t, part }
    }

    /// No end: the interval goes on for ever.
    #[inline(always)]
    pub(crate) const fn none(t: S) -> Self {
        Self { t, part: Part::Side }
    }
}

/// The interval of a line inside a convex set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<S> {
    pub(crate) enter: End<S>,
    pub(crate) exit: End<S>,
    /// The two ends are one point.
    pub(crate) touch: bool,
}

impl<S: Scalar> Span<S> {
    #[inline(always)]
    pub(crate) const fn new(enter: End<S>, exit: End<S>) -> Self {
        Self { enter, exit, touch: false }
    }

    /// The whole line.
    pub(crate) fn everywhere() -> Self {
        Self::new(End::none(-S::INFINITY), End::none(S::INFINITY))
    }

    /// The part of `self` (the side's) that lies in `caps`. Rule 1 of the contract: two convex sets meet in one
    /// interval, so that crossings pair up whatever the rounding. Rule 5: where both end at the same `t`, the
    /// side owns the rim.
    #[inline(always)]
    pub(crate) fn intersection(self, caps: Self) -> Option<Self> {
        let enter = if caps.enter.t > self.enter.t { caps.enter } else { self.enter };
        let exit = if caps.exit.t < self.exit.t { caps.exit } else { self.exit };
        if enter.t > exit.t {
            return None;
        }
        if enter.t == exit.t && enter.part != exit.part {
            // Across a rim, which is the side's.
            let rim = End::new(enter.t, Part::Side);
            return Some(Self { enter: rim, exit: rim, touch: true });
        }
        Some(Self { enter, exit, touch: self.touch })
    }

    /// The interval as a range, cut off at what the number type can represent.
    pub(crate) fn as_range(self, within: Range<S>) -> Option<Range<S>> {
        let start = if self.enter.t > within.start() { self.enter.t } else { within.start() };
        let end = if self.exit.t < within.end() { self.exit.t } else { within.end() };
        Range::new(start, end).ok()
    }
}

/// How a line meets a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meeting<S> {
    /// Not at all.
    Miss,
    /// In one interval, whose ends are the hits.
    One(Span<S>),
    /// In two intervals, in order (a double cone).
    Two(Span<S>, Span<S>),
    /// In the crossings of an open surface: the ends of the interval that lie on it; the others are infinite.
    Surface(Span<S>),
    /// The line lies in an open or infinite surface over this interval.
    LiesIn(Span<S>),
}

impl<S: Scalar> Meeting<S> {
    /// A meeting in the given interval, if any.
    #[inline(always)]
    pub(crate) fn solid(span: Option<Span<S>>) -> Self {
        span.map_or(Self::Miss, Self::One)
    }

    /// The ends of a line that runs in the side lie on its rims or seams, which the side owns (rule 5).
    #[cold]
    pub(crate) fn along_the_side(self) -> Self {
        match self {
            Self::One(span) => Self::One(Span {
                enter: End::new(span.enter.t, Part::Side),
                exit: End::new(span.exit.t, Part::Side),
                touch: span.touch,
            }),
            other => other,
        }
    }

    /// Replaces each `t`; the order of ends must not change.
    #[inline]
    pub(crate) fn map_t(self, f: impl Fn(S) -> S) -> Self {
        let map = |span: Span<S>| Span {
            enter: End::new(f(span.enter.t), span.enter.part),
            exit: End::new(f(span.exit.t), span.exit.part),
            touch: span.touch,
        };
        match self {
            Self::Miss => Self::Miss,
            Self::One(span) => Self::One(map(span)),
            Self::Two(first, second) => Self::Two(map(first), map(second)),
            Self::Surface(span) => Self::Surface(map(span)),
            Self::LiesIn(span) => Self::LiesIn(map(span)),
        }
    }

    /// Rule 8: the end from which the ray departs (at `t = 0`, exactly) is not met again.
    ///
    /// `convex` says that the set is convex, so that a ray leaving outwards meets nothing of it.
    pub(crate) fn departed(self, leaving: Leaving, convex: bool) -> Self {
        let without_zero = |span: Span<S>| {
            let mut span = span;
            match leaving {
                // From the inside of the surface the next crossing is the far end.
                Leaving::Inwards => {
                    if span.enter.t <= S::ZERO {
                        span.enter = End::none(-S::INFINITY);
                    }
                    if span.exit.t < S::ZERO {
                        span.exit.t = S::ZERO;
                    }
                    span.touch = false;
                    Some(span)
                }
                Leaving::Outwards => (span.enter.t > S::ZERO).then_some(span),
            }
        };
        match (self, leaving) {
            (_, Leaving::Outwards) if convex => Self::Miss,
            (Self::One(span), _) => Self::solid(without_zero(span)),
            (Self::Two(first, second), Leaving::Inwards) => {
                // The interval that holds zero is the one that the ray is in.
                if second.enter.t <= S::ZERO {
                    Self::solid(without_zero(second))
                } else {
                    without_zero(first).map_or(Self::One(second), |first| Self::Two(first, second))
                }
            }
            (Self::Two(first, second), Leaving::Outwards) => match (without_zero(first), without_zero(second)) {
                (Some(first), Some(second)) => Self::Two(first, second),
                (None, span) | (span, None) => Self::solid(span),
            },
            (Self::Surface(span), Leaving::Inwards) => {
                let span = Span { enter: End::none(-S::INFINITY), touch: false, ..span };
                if span.exit.t > S::ZERO { Self::Surface(span) } else { Self::Miss }
            }
            (Self::Surface(_), Leaving::Outwards) => Self::Miss,
            (Self::Miss | Self::LiesIn(_), _) => self,
        }
    }

    /// Hands the ends, in order, to `report`.
    #[inline]
    fn each_end(self, mut report: impl FnMut(Hit<S>)) {
        let mut span_ends = |span: Span<S>| {
            let Span { enter, exit, touch } = span;
            if touch {
                return report(Hit { t: enter.t, part: enter.part, crossing: Crossing::Touch });
            }
            report(Hit { t: enter.t, part: enter.part, crossing: Crossing::Enter });
            report(Hit { t: exit.t, part: exit.part, crossing: Crossing::Exit });
        };
        match self {
            Self::Miss | Self::LiesIn(_) => {}
            Self::One(span) | Self::Surface(span) => span_ends(span),
            Self::Two(first, second) => {
                span_ends(first);
                span_ends(second);
            }
        }
    }

    /// Rule 3: the ends in the range, sorted; and whether the range starts inside.
    pub(crate) fn hits(self, range: Range<S>) -> Hits<S> {
        let mut hits = Hits::none();
        if let Self::LiesIn(span) = self {
            return span.as_range(range).map_or(hits, Hits::lying_in);
        }
        self.each_end(|hit| {
            // An infinite t is outside every range.
            if range.contains(hit.t) {
                hits.push(hit);
            }
        });
        let holds_start = |span: Span<S>| span.enter.t < range.start() && range.start() <= span.exit.t;
        if match self {
            Self::One(span) => holds_start(span),
            Self::Two(first, second) => holds_start(first) || holds_start(second),
            _ => false,
        } {
            hits.start_inside();
        }
        hits
    }

    /// The first end in the range that `accept` takes.
    #[inline(always)]
    pub(crate) fn nearest(self, range: Range<S>, accept: impl Fn(Crossing) -> bool) -> Option<Hit<S>> {
        let take = |end: End<S>, crossing: Crossing| {
            let taken = range.contains(end.t) && accept(crossing);
            taken.then_some(Hit { t: end.t, part: end.part, crossing })
        };
        let first = |span: Span<S>| {
            if span.touch {
                return take(span.enter, Crossing::Touch);
            }
            take(span.enter, Crossing::Enter).or_else(|| take(span.exit, Crossing::Exit))
        };
        match self {
            Self::Miss | Self::LiesIn(_) => None,
            Self::One(span) | Self::Surface(span) => first(span),
            Self::Two(one, two) => first(one).or_else(|| first(two)),
        }
    }
}
