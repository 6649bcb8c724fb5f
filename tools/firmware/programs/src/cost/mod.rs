//! What a query costs, in instructions and in stack: every primitive, query, number type and tier, hits and misses
//! apart, beside the formulas of the textbook.
//!
//! | module | what it holds |
//! |---|---|
//! | `measure` | instructions and stack of a query |
//! | `textbook` | the formulas that everyone writes first |
//!
//! The primitives, the queries and the rays are those of the crate `shared`, which the host is measured with too.

pub(crate) mod measure;
mod textbook;

use core::fmt::{self, Display};
use fixed::types::{I16F16, I32F32};
use measure::{instructions, stack};
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{Hit, Ray, Scalar};
use shared::every_subject;
use shared::rays::{RAYS, rays};
use shared::subject::{Subject, query};
use shared::workload::{Query, SENSED, SENSED_EVERY, sensed};

/// One figure.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The primitive.
    pub subject: &'static str,
    /// The query.
    pub query: &'static str,
    /// The number type.
    pub number: &'static str,
    /// The tier; `any` where an answer does not depend on it, `textbook` for the formulas to compare with.
    pub tier: &'static str,
    /// What the figure is.
    pub of: Of,
    /// The figure.
    pub figure: u64,
}

/// What a figure is.
#[derive(Clone, Copy, Debug)]
pub enum Of {
    /// Instructions a query in the mean over rays that hit.
    Hit,
    /// Instructions a query in the mean over rays that miss.
    Miss,
    /// Bytes of stack of a query, at most.
    Stack,
}

impl Display for Of {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Hit => "hit",
            Self::Miss => "miss",
            Self::Stack => "stack",
        })
    }
}

/// Takes rows.
pub type Report<'a> = &'a mut dyn FnMut(Row);

/// Rays at one subject, in its number type.
pub struct Rays<S: Scalar> {
    hitting: [Ray<S>; RAYS],
    missing: [Ray<S>; RAYS],
}

/// What is measured, but for the query.
#[derive(Clone, Copy)]
struct Names {
    subject: &'static str,
    number: &'static str,
    tier: &'static str,
}

impl Names {
    fn row(self, query: &'static str, of: Of, figure: u64) -> Row {
        let Self { subject, number, tier } = self;
        Row { subject, query, number, tier, of, figure }
    }
}

/// The queries that each tier answers in its own way.
#[inline(never)]
fn tier<S: Scalar, T: Tier<S>, P: Subject<S>>(names: Names, subject: &P, rays: &Rays<S>, report: Report<'_>) {
    let queries: [(&str, fn(&P, &Ray<S>)); 3] = [
        ("all hits", query::hits::<S, T, P>),
        ("nearest", query::nearest::<S, T, P>),
        ("occlusion", query::occludes::<S, T, P>),
    ];
    for (name, query) in queries {
        report(names.row(name, Of::Hit, instructions(subject, &rays.hitting, query)));
        report(names.row(name, Of::Miss, instructions(subject, &rays.missing, query)));
        let deepest = stack(subject, &rays.hitting, query).max(stack(subject, &rays.missing, query));
        report(names.row(name, Of::Stack, deepest));
    }
}

/// What is computed of a hit, which no tier changes.
#[inline(never)]
fn surface<S: Scalar, P: Subject<S>>(names: Names, subject: &P, rays: &Rays<S>, report: Report<'_>) {
    let hits: [(Ray<S>, Option<Hit<S>>); RAYS] = rays.hitting.map(|ray| (ray, subject.nearest::<Stable>(&ray)));
    let queries: [(&str, fn(&P, &(Ray<S>, Option<Hit<S>>))); 2] =
        [("normal", query::normal::<S, P>), ("uv", query::uv::<S, P>)];
    for (name, query) in queries {
        report(names.row(name, Of::Hit, instructions(subject, &hits, query)));
        report(names.row(name, Of::Stack, stack(subject, &hits, query)));
    }
}

/// Everything for one subject: each tier that its number type has, and what no tier changes.
macro_rules! measure {
    ($subject:expr, $name:expr, $report:expr, $S:ty, $number:literal: $($T:ident)+) => {{
        let rays = Rays { hitting: rays(&$subject, true), missing: rays(&$subject, false) };
        $(
            let names = Names { subject: $name, number: $number, tier: stringify!($T) };
            tier::<$S, $T, _>(names, &$subject, &rays, $report);
        )+
        let names = Names { subject: $name, number: $number, tier: "any" };
        surface::<$S, _>(names, &$subject, &rays, $report);
    }};
}

/// The tests of the range sensor: each zone tests each solid. None is told apart from another: most miss.
#[inline(never)]
fn sensor<S: Scalar, T: Tier<S>>(names: Names, report: Report<'_>) {
    let mut tests = heapless::Vec::<Query<S>, { SENSED.div_ceil(SENSED_EVERY) }>::new();
    for query in (0..SENSED).step_by(SENSED_EVERY).filter_map(sensed) {
        // There is room for all of them.
        let _ = tests.push(query);
    }
    let query: fn(&(), &Query<S>) = |(), test| query::nearest::<S, T, _>(&test.shape, &test.ray);
    report(names.row("nearest", Of::Hit, instructions(&(), &tests, query)));
    report(names.row("nearest", Of::Stack, stack(&(), &tests, query)));
}

/// Every subject in one number type.
macro_rules! number {
    ($report:expr, $S:ty, $number:literal: $($T:ident)+) => {{
        $(sensor::<$S, $T>(Names { subject: "range sensor", number: $number, tier: stringify!($T) }, $report);)+
        every_subject!($S, |name, subject| measure!(subject, name, $report, $S, $number: $($T)+));
        textbook::every::<$S>($number, $report);
    }};
}

/// Measures everything, always in the same order. The clock must have been started.
pub fn all(report: Report<'_>) {
    number!(report, f32, "f32": Plain Fast Stable Exact);
    number!(report, I16F16, "I16F16": Plain Fast Stable Exact);
    number!(report, I32F32, "I32F32": Plain Fast Stable);
    number!(report, f64, "f64": Plain Fast Stable);
    textbook::with_the_chips_root(report);
}
