//! The queries that the benchmarks run, prepared beforehand: every primitive, query, number type and tier, and scenes
//! of 1 to 256 spheres, hits and misses apart.
//!
//! The subjects and their rays are those of the firmware's program `cost`, so that the host can be read beside
//! `docs/microcontrollers.md`.

pub mod scenes;
mod textbook;

use fixed::types::{I16F16, I32F32};
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{Hit, Ray, Scalar};
use shared::every_subject;
use shared::rays::{RAYS, rays};
use shared::subject::{Subject, query};
use std::fmt;
use std::hint::black_box;

/// Queries in a case: one with each of so many rays.
pub const QUERIES: usize = RAYS;

/// What a case is called.
#[derive(Clone, Debug)]
pub struct Name {
    /// The primitive, or the scene.
    pub subject: String,
    /// Its query.
    pub query: &'static str,
    /// The number type.
    pub number: &'static str,
    /// The tier; `any` where an answer does not depend on it, `textbook` for the formulas to compare with.
    pub tier: &'static str,
    /// `hit` or `miss`: what all the rays do.
    pub rays: &'static str,
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { subject, query, number, tier, rays } = self;
        write!(f, "{subject} | {query} | {number} | {tier} | {rays}")
    }
}

/// One figure to be measured.
pub struct Case {
    /// What it is called.
    pub name: Name,
    run: Box<dyn Fn() + Send + Sync>,
}

impl Case {
    /// Runs the query with every ray, once.
    #[inline]
    pub fn run(&self) {
        (self.run)();
    }

    /// A query of a subject with each of the inputs.
    pub fn new<P, I>(name: Name, subject: P, inputs: Vec<I>, query: fn(&P, &I)) -> Self
    where
        P: Send + Sync + 'static,
        I: Send + Sync + 'static,
    {
        // The compiler must not know which function it is: it would make a copy of the loop for each.
        Self { name, run: Box::new(move || run_each(&subject, &inputs, black_box(query))) }
    }
}

#[inline(never)]
fn run_each<P, I>(subject: &P, inputs: &[I], query: fn(&P, &I)) {
    for input in inputs {
        query(black_box(subject), black_box(input));
    }
}

/// The two kinds of rays.
const KINDS: [(bool, &str); 2] = [(true, "hit"), (false, "miss")];

/// Which queries are wanted: their names are `all hits`, `nearest`, `occlusion`, `normal` and `uv`.
type Wanted<'a> = &'a dyn Fn(&Name) -> bool;

/// The cases of one subject in one number type.
///
/// What is not `ALL_HITS` needs no lists of hits, and saves the compiler a third of the queries.
struct Builder<'a, const ALL_HITS: bool> {
    cases: &'a mut Vec<Case>,
    wanted: Wanted<'a>,
    subject: &'static str,
    number: &'static str,
}

impl<const ALL_HITS: bool> Builder<'_, ALL_HITS> {
    fn add<P, I>(&mut self, [query, tier, rays]: [&'static str; 3], subject: &P, inputs: &[I], run: fn(&P, &I))
    where
        P: Clone + Send + Sync + 'static,
        I: Clone + Send + Sync + 'static,
    {
        let name = Name { subject: self.subject.into(), query, number: self.number, tier, rays };
        if (self.wanted)(&name) {
            self.cases.push(Case::new(name, subject.clone(), inputs.to_vec(), run));
        }
    }

    /// The queries that each tier answers in its own way.
    fn tier<S, T, P>(&mut self, tier: &'static str, subject: &P, at: &[Vec<Ray<S>>; 2])
    where
        S: Scalar,
        T: Tier<S>,
        P: Subject<S> + Clone + Send + Sync + 'static,
    {
        for ((_, kind), rays) in KINDS.into_iter().zip(at) {
            if ALL_HITS {
                self.add(["all hits", tier, kind], subject, rays, query::hits::<S, T, P>);
            }
            self.add(["nearest", tier, kind], subject, rays, query::nearest::<S, T, P>);
            self.add(["occlusion", tier, kind], subject, rays, query::occludes::<S, T, P>);
        }
    }

    /// What a hit has, which no tier changes.
    fn surface<S, P>(&mut self, subject: &P, hitting: &[Ray<S>])
    where
        S: Scalar,
        P: Subject<S> + Clone + Send + Sync + 'static,
    {
        let hits: Vec<(Ray<S>, Option<Hit<S>>)> =
            hitting.iter().map(|ray| (*ray, subject.nearest::<Stable>(ray))).collect();
        self.add(["normal", "any", "hit"], subject, &hits, query::normal::<S, P>);
        self.add(["uv", "any", "hit"], subject, &hits, query::uv::<S, P>);
    }
}

/// Every subject in one number type, with the tiers that the type has.
macro_rules! number {
    ($cases:ident, $wanted:ident, $S:ty, $number:literal: $($T:ident)+) => {
        every_subject!($S, |name, subject| {
            let at = KINDS.map(|(hitting, _)| rays::<$S, _>(&subject, hitting).to_vec());
            let mut builder =
                Builder::<ALL_HITS> { cases: &mut $cases, wanted: $wanted, subject: name, number: $number };
            $(builder.tier::<$S, $T, _>(stringify!($T), &subject, &at);)+
            builder.surface::<$S, _>(&subject, &at[0]);
        });
    };
}

/// The wanted cases of the primitives, always in the same order.
pub fn of_primitives<const ALL_HITS: bool>(wanted: Wanted<'_>) -> Vec<Case> {
    let mut cases = Vec::new();
    number!(cases, wanted, f32, "f32": Plain Fast Stable Exact);
    number!(cases, wanted, f64, "f64": Plain Fast Stable);
    number!(cases, wanted, I16F16, "I16F16": Plain Fast Stable Exact);
    number!(cases, wanted, I32F32, "I32F32": Plain Fast Stable);
    cases
}

/// The cases of the textbook's formulas, always in the same order.
pub fn of_textbook() -> Vec<Case> {
    let mut cases = textbook::cases::<f32>("f32");
    cases.extend(textbook::cases::<f64>("f64"));
    cases.extend(textbook::cases::<I16F16>("I16F16"));
    cases.extend(textbook::cases::<I32F32>("I32F32"));
    cases
}

/// The cases of the scenes, always in the same order.
pub fn of_scenes() -> Vec<Case> {
    let mut cases = scenes::cases::<f32>("f32");
    cases.extend(scenes::cases::<I16F16>("I16F16"));
    cases
}
