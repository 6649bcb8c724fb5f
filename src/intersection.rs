//! Intervals along a line, and the rule by which their ends become hits.

use crate::hit::{Crossing, Hit, Hits};
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::{Attempt, Scalar};

/// One end of an interval: where the line crosses the surface, and on which part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End<S> {
    /// The parameter; [`Scalar::INFINITY`] of either sign for a missing end.
    pub(crate) t: S,
    pub(crate) part: Part,
}

impl<S: Scalar> End<S> {
    #[inline(always)]
    pub(crate) const fn new(t: S, part: Part) -> Self {
        Self { t, part }
    }

    /// A missing end: the interval is infinite.
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

    /// Between two ends. Those of a touch are one point, and an exit that was rounded to before the entry is moved to
    /// it.
    #[inline(always)]
    pub(crate) fn joined(enter: End<S>, exit: End<S>, touch: bool) -> Self {
        let exit = if touch || exit.t < enter.t { End { t: enter.t, ..exit } } else { exit };
        Self { enter, exit, touch }
    }

    /// Between two ends on the side.
    #[inline(always)]
    pub(crate) const fn of_side([enter, exit]: [S; 2]) -> Self {
        Self::new(End::new(enter, Part::Side), End::new(exit, Part::Side))
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
            // Across a rim, which belongs to the side.
            let rim = End::new(enter.t, Part::Side);
            return Some(Self { enter: rim, exit: rim, touch: true });
        }
        Some(Self { enter, exit, touch: self.touch })
    }

    /// The interval as a range, clamped to the limits of the number type.
    pub(crate) fn as_range(self, within: Range<S>) -> Option<Range<S>> {
        let start = if self.enter.t > within.start() { self.enter.t } else { within.start() };
        let end = if self.exit.t < within.end() { self.exit.t } else { within.end() };
        Range::new(start, end).ok()
    }
}

/// The intersection of a line and a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intersection<S> {
    /// A miss.
    Miss,
    /// One interval, whose ends are the hits.
    One(Span<S>),
    /// The entry of one interval, whose exit was not computed: it is not needed, or uncertain.
    Entered(End<S>),
    /// Two intervals, in order (of a double cone, across a waist, through a tube or a torus). Of an open surface an exit
    /// and a later entry, whose missing ends are infinite with the other signs, so that no point is inside.
    Two(Span<S>, Span<S>),
    /// The crossings of an open surface: those ends of the interval that lie on it. The others are infinite.
    Surface(Span<S>),
    /// The line lies in an open or infinite surface over this interval.
    LiesIn(Span<S>),
}

impl<R> Intersection<R> {
    /// The intersection with `f` applied to its ends, unless `f` is unsure of one.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    pub(crate) fn try_map<S>(self, f: impl Fn(R) -> Option<S>) -> Option<Intersection<S>> {
        let end = |End { t, part }: End<R>| Some(End { t: f(t)?, part });
        let span = |Span { enter, exit, touch }: Span<R>| Some(Span { enter: end(enter)?, exit: end(exit)?, touch });
        Some(match self {
            Self::Miss => Intersection::Miss,
            Self::One(one) => Intersection::One(span(one)?),
            Self::Entered(enter) => Intersection::Entered(end(enter)?),
            Self::Two(one, two) => Intersection::Two(span(one)?, span(two)?),
            Self::Surface(one) => Intersection::Surface(span(one)?),
            Self::LiesIn(one) => Intersection::LiesIn(span(one)?),
        })
    }
}

impl<S: Scalar> Intersection<S> {
    /// Calls `report` for each end, in order.
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
            Self::Entered(End { t, part }) => report(Hit { t, part, crossing: Crossing::Enter }),
            Self::One(span) | Self::Surface(span) => span_ends(span),
            Self::Two(first, second) => {
                span_ends(first);
                span_ends(second);
            }
        }
    }

    /// The intersection with this part at the ends of its one interval.
    pub(crate) fn with_part(self, part: Part) -> Self {
        let of_part = |end: End<S>| End { part, ..end };
        match self {
            Self::One(Span { enter, exit, touch }) => {
                Self::One(Span { enter: of_part(enter), exit: of_part(exit), touch })
            }
            Self::Entered(enter) => Self::Entered(of_part(enter)),
            other => other,
        }
    }

    /// Two intervals, of which the second does not begin before the first ends, nor end before it begins.
    pub(crate) fn in_order(first: Span<S>, mut second: Span<S>) -> Self {
        if second.enter.t < first.exit.t {
            second.enter.t = first.exit.t;
        }
        if second.exit.t < second.enter.t {
            second.exit.t = second.enter.t;
        }
        Self::Two(first, second)
    }

    /// The intersection with an entry that is certain, in place of that of the interval which it begins: also where
    /// that was rounded to a point, or to none.
    pub(crate) fn entered_at(self, enter: End<S>) -> Self {
        match self {
            Self::One(Span { exit, .. }) => Self::One(Span::joined(enter, exit, false)),
            // The entry that is nearer: in another number the first interval may have ended before it.
            Self::Two(first, second) => {
                let off = |span: &Span<S>| span.enter.t.minus(enter.t).magnitude();
                let joined = |span: Span<S>| Span::joined(enter, span.exit, false);
                if off(&second) < off(&first) {
                    Self::in_order(first, joined(second))
                } else {
                    Self::in_order(joined(first), second)
                }
            }
            Self::Miss => Self::One(Span::new(enter, enter)),
            other => other,
        }
    }

    /// Rule 3 of the contract: the ends in the range, sorted, and whether the range starts inside.
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

    /// The first end in the range that `accept` accepts.
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
            Self::Entered(enter) => take(enter, Crossing::Enter),
            Self::One(span) | Self::Surface(span) => first(span),
            Self::Two(one, two) => first(one).or_else(|| first(two)),
        }
    }

    /// Occlusion of the half-line `t >= 0`.
    #[inline(always)]
    pub(crate) fn occlusion(self) -> Attempt<()> {
        if let Self::Entered(End { t, .. }) = self
            && t < S::ZERO
        {
            // The exit, which was not computed, may be ahead.
            return Attempt::Unsure;
        }
        self.nearest(Range::FORWARD, |_| true).map_or(Attempt::Miss, |_| Attempt::Hit(()))
    }
}
