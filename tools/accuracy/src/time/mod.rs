//! How long a nearest hit takes, as a ratio to the textbook's sphere in `f32` in the same run.
//!
//! The machine is noisy: each short batch is preceded by one of the reference, several rounds are made, and the median
//! of the ratios counts. What calling a function takes that does nothing is subtracted from both.
//!
//! | module | what it holds |
//! |---|---|
//! | `batch` | a query at some rays, again and again |
//! | `rays` | of a workload's rays those that hit, and others that miss |

mod batch;
mod rays;

pub use rays::{Query, RAYS};

use crate::study::{Cost, Time, Times};
use batch::{Batch, nothing, textbook, tier};
use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::tier::{Exact, Fast, Plain, Stable};
use rays::{Kind, queries};
use support::method::{Measurable, Method};
use support::oracle::Solid;
use support::placed::PLACINGS;
use support::subject::{SUBJECTS, Subject};
use support::workload::{WORKLOADS, Workload};

/// How often `tick` is called.
pub const TICKS: usize = 4 * SUBJECTS.len() * (WORKLOADS.len() + PLACINGS.len());

/// A number type whose tiers can be timed.
pub trait Timed: Measurable {
    /// The tiers at these rays, beside the textbook.
    fn tiers(queries: &[Query<Self>]) -> Vec<(&'static str, Batch)>;
}

macro_rules! timed {
    ($($Number:ty: $($Tier:ident)+;)+) => {
        $(
            impl Timed for $Number {
                fn tiers(queries: &[Query<Self>]) -> Vec<(&'static str, Batch)> {
                    vec![$((stringify!($Tier), tier::<Self, $Tier>(queries)),)+]
                }
            }
        )+
    };
}
timed! {
    f32: Plain Fast Stable Exact;
    f64: Plain Fast Stable;
    I16F16: Plain Fast Stable Exact;
    I32F32: Plain Fast Stable;
    I8F24: Plain Fast Stable Exact;
    I20F12: Plain Fast Stable Exact;
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Three digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// What all batches are compared with.
pub struct Reference {
    textbook: Batch,
    nothing: Batch,
    /// Of every round, in nanoseconds.
    seen: Vec<f64>,
}

impl Reference {
    pub fn new() -> Self {
        let subject = Subject::<f32>::new("sphere");
        let [hits, _] = queries(&subject, Kind::Unplaced(Workload::Benign), 1000);
        Self { textbook: textbook(&subject.solid, &hits), nothing: nothing(&hits), seen: vec![] }
    }

    /// What each batch takes.
    fn compare(&mut self, batches: &[Batch], rounds: usize) -> Vec<Cost> {
        let mut seen = vec![(vec![], vec![]); batches.len()];
        for _ in 0..rounds {
            for (batch, (ratios, nanoseconds)) in batches.iter().zip(&mut seen) {
                let nothing = self.nothing.nanoseconds();
                let reference = (self.textbook.nanoseconds() - nothing).max(0.1);
                let taken = (batch.nanoseconds() - nothing).max(0.0);
                self.seen.push(reference);
                ratios.push(taken / reference);
                nanoseconds.push(taken);
            }
        }
        let cost =
            |(ratios, nanoseconds)| Cost { ratio: rounded(median(ratios)), nanoseconds: rounded(median(nanoseconds)) };
        seen.into_iter().map(cost).collect()
    }

    /// What each way to answer takes at these rays, by tier; nothing where there are none.
    fn tiers<S: Timed>(&mut self, solid: &Solid, queries: &[Query<S>], rounds: usize) -> Vec<(&'static str, Cost)> {
        if queries.is_empty() {
            return vec![];
        }
        let (tiers, batches): (Vec<_>, Vec<_>) =
            [("Textbook", textbook(solid, queries))].into_iter().chain(S::tiers(queries)).unzip();
        tiers.into_iter().zip(self.compare(&batches, rounds)).collect()
    }

    /// The rows of a primitive and a workload: of rays that hit, and of rays that miss.
    pub fn rows<S: Timed>(
        &mut self,
        solid: &Solid,
        queries: &[Vec<Query<S>>; 2],
        [primitive, workload]: [&str; 2],
        rounds: usize,
    ) -> Vec<Time> {
        let [hits, misses] = queries.each_ref().map(|queries| self.tiers(solid, queries, rounds));
        let row = |method: Method<S>| {
            let of = |costs: &[(&str, Cost)]| costs.iter().find(|(tier, _)| *tier == method.tier).map(|it| it.1);
            let (hit, miss) = (of(&hits), of(&misses));
            (hit.is_some() || miss.is_some()).then(|| Time {
                number: S::name(),
                tier: method.tier.into(),
                primitive: primitive.into(),
                workload: workload.into(),
                hit,
                miss,
            })
        };
        S::methods().into_iter().filter_map(row).collect()
    }

    /// All that was compared with it in a run.
    pub fn done(self, rows: Vec<Time>) -> Times {
        Times { machine: machine(), reference_nanoseconds: rounded(median(self.seen)), rows }
    }
}

fn number<S: Timed>(rounds: usize, reference: &mut Reference, all: &mut Vec<Time>, tick: &mut dyn FnMut()) {
    let workloads = WORKLOADS.into_iter().zip(1000..).map(|(workload, seed)| (Kind::Unplaced(workload), seed));
    let kinds: Vec<_> = workloads
        .chain(PLACINGS.into_iter().zip(2000..).map(|(placing, seed)| (Kind::Placed(placing), seed)))
        .collect();
    for primitive in SUBJECTS {
        let subject = Subject::<S>::new(primitive);
        for (kind, seed) in &kinds {
            let queries = queries(&subject, *kind, *seed);
            all.extend(reference.rows(&subject.solid, &queries, [primitive, &kind.name()], rounds));
            tick();
        }
    }
}

/// What this machine is called.
fn machine() -> String {
    let about = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = about.lines().find_map(|line| line.strip_prefix("model name")?.split(": ").nth(1));
    let compiler = std::process::Command::new("rustc").arg("--version").output().ok();
    let compiler = compiler.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    let build = if cfg!(debug_assertions) { ", without --release" } else { "" };
    format!("{} ({}), {}{build}", model.unwrap_or("unknown processor").trim(), std::env::consts::ARCH, compiler.trim())
}

/// Every way to answer on every primitive and workload.
pub fn measure(rounds: usize, tick: &mut dyn FnMut()) -> Times {
    let mut reference = Reference::new();
    let mut rows = vec![];
    number::<f32>(rounds, &mut reference, &mut rows, tick);
    number::<f64>(rounds, &mut reference, &mut rows, tick);
    number::<I16F16>(rounds, &mut reference, &mut rows, tick);
    number::<I32F32>(rounds, &mut reference, &mut rows, tick);
    reference.done(rows)
}
