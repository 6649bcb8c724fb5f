//! What a ray with a range of `t` must report, given where its line meets the solid.

use std::cmp::Ordering;

use super::algebraic::Root;
use super::dyadic::Dyadic;
use super::solids::Part;
use super::solve::{Answer, Approach};

/// What a hit does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExpectedCrossing {
    /// Goes in.
    Enter,
    /// Comes out.
    Exit,
    /// Touches from outside.
    Touch,
}

/// A hit that must be reported.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpectedHit {
    /// The parameter of the line.
    pub t: Root,
    /// Where on the surface.
    pub part: Part,
    /// What it does.
    pub crossing: ExpectedCrossing,
}

/// What a ray must report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InRange {
    /// The hits within the closed range, sorted by `t`.
    pub hits: Vec<ExpectedHit>,
    /// Whether the range begins within a span that began before it: `enter < lo <= exit`. Open surfaces have no inside.
    pub starts_inside: bool,
    /// Whether the line lies in the surface somewhere within the range; then there are no hits.
    pub coincident: bool,
}

/// The part of an answer within `lo <= t <= hi`.
pub fn hits_in_range(answer: &Answer, lo: &Dyadic, hi: Option<&Dyadic>) -> InRange {
    let before = |t: &Root| t.cmp_dyadic(lo) == Ordering::Less;
    let beyond = |t: &Root| hi.is_some_and(|hi| t.cmp_dyadic(hi) == Ordering::Greater);
    let mut result = InRange { hits: vec![], starts_inside: false, coincident: false };
    let mut report = |t: &Root, part, crossing| {
        if !before(t) && !beyond(t) {
            result.hits.push(ExpectedHit { t: t.clone(), part, crossing });
        }
    };
    match answer {
        Answer::Spans(spans) => {
            for span in spans {
                if span.is_touch() {
                    if let Some(end) = &span.enter {
                        report(&end.t, end.part, ExpectedCrossing::Touch);
                    }
                    continue;
                }
                if let Some(end) = &span.enter {
                    report(&end.t, end.part, ExpectedCrossing::Enter);
                }
                if let Some(end) = &span.exit {
                    report(&end.t, end.part, ExpectedCrossing::Exit);
                }
            }
            result.starts_inside = spans.iter().any(|span| {
                span.enter.as_ref().is_none_or(|end| before(&end.t))
                    && span.exit.as_ref().is_none_or(|end| !before(&end.t))
            });
        }
        Answer::Crossings(crossings) => {
            for crossing in crossings {
                let kind = match crossing.side {
                    Approach::FromOutside => ExpectedCrossing::Enter,
                    Approach::FromInside => ExpectedCrossing::Exit,
                    Approach::Touch => ExpectedCrossing::Touch,
                };
                report(&crossing.t, crossing.part, kind);
            }
        }
        Answer::Coincident { from, to } => {
            let starts_beyond = from.as_ref().is_some_and(beyond);
            let ends_before = to.as_ref().is_some_and(before);
            result.coincident = !starts_beyond && !ends_before;
        }
    }
    result
}
