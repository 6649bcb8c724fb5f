//! What was found, as the queries report it.

use super::solve::{Piece, Settled};
use crate::hit::{Crossing, Hit, Hits};
use crate::ray::Range;
use crate::scalar::Scalar;

/// How the line meets a figure, in the ray's own numbers.
pub(super) enum Found<S> {
    Miss,
    /// A solid, in one interval.
    One(Piece<S>),
    /// A double cone, in two.
    Two(Piece<S>, Piece<S>),
    /// A surface, in the ends that are there.
    Surface(Piece<S>),
    /// Along a surface.
    LiesIn(Piece<S>),
}

impl<S: Scalar> Piece<S> {
    /// True if the start of the range lies behind the entry and not behind the exit.
    fn holds_start(&self) -> bool {
        self.enter.is_none_or(|end| end.is_before_range) && self.exit.is_none_or(|end| !end.is_before_range)
    }

    fn report(&self, hits: &mut Hits<S>) {
        let mut push = |end: Option<Settled<S>>, crossing: Crossing| {
            if let Some(end) = end
                && !end.is_before_range
                && !end.is_beyond_range
            {
                hits.push(Hit { t: end.t, part: end.part, crossing });
            }
        };
        if self.touch {
            push(self.enter, Crossing::Touch);
        } else {
            push(self.enter, Crossing::Enter);
            push(self.exit, Crossing::Exit);
        }
    }

    /// The first of what [`Piece::report`] reports that `accept` takes.
    #[inline(always)]
    fn nearest(&self, accept: impl Fn(Crossing) -> bool) -> Option<Hit<S>> {
        let (first, last) = if self.touch { (Crossing::Touch, None) } else { (Crossing::Enter, self.exit) };
        let hit = |end: Option<Settled<S>>, crossing: Crossing| {
            let end = end.filter(|end| !end.is_before_range && !end.is_beyond_range && accept(crossing))?;
            Some(Hit { t: end.t, part: end.part, crossing })
        };
        hit(self.enter, first).or_else(|| hit(last, Crossing::Exit))
    }

    /// The part of the range that it covers.
    fn overlap(&self, range: Range<S>) -> Option<Range<S>> {
        if self.enter.is_some_and(|end| end.is_beyond_range) || self.exit.is_some_and(|end| end.is_before_range) {
            return None;
        }
        let start = self.enter.filter(|end| !end.is_before_range).map_or(range.start(), |end| end.t);
        let end = self.exit.filter(|end| !end.is_beyond_range).map_or(range.end(), |end| end.t);
        Range::new(start, end).ok()
    }
}

impl<S: Scalar> Found<S> {
    /// The first hit in the range that `accept` takes.
    #[inline(always)]
    pub(super) fn nearest(&self, accept: impl Fn(Crossing) -> bool) -> Option<Hit<S>> {
        match self {
            // A line along a surface has an overlap and no hits.
            Self::Miss | Self::LiesIn(_) => None,
            Self::One(piece) | Self::Surface(piece) => piece.nearest(accept),
            Self::Two(first, second) => first.nearest(&accept).or_else(|| second.nearest(&accept)),
        }
    }

    /// The hits in the range, sorted (rule 3 of the contract).
    pub(super) fn hits(&self, range: Range<S>) -> Hits<S> {
        let mut hits = Hits::none();
        match self {
            Self::Miss => {}
            Self::One(piece) => {
                piece.report(&mut hits);
                if piece.holds_start() && !piece.touch {
                    hits.start_inside();
                }
            }
            Self::Two(first, second) => {
                first.report(&mut hits);
                second.report(&mut hits);
                if first.holds_start() || second.holds_start() {
                    hits.start_inside();
                }
            }
            Self::Surface(piece) => piece.report(&mut hits),
            Self::LiesIn(piece) => return piece.overlap(range).map_or(hits, Hits::lying_in),
        }
        hits
    }
}
