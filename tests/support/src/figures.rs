//! The rows of the accuracy tables: every number type, way to answer, primitive and workload.

use super::measure::{Measured, measure_each, measure_placed};
use super::method::Measurable;
use super::placed::PLACINGS;
use super::subject::{SUBJECTS, Subject};
use super::workload::WORKLOADS;
use fixed::types::{I16F16, I32F32};

/// The ways to answer, the plainest first. `Textbook` is `k^2 - a c` in the operators of the number type.
pub const TIERS: [&str; 4] = ["Textbook", "Fast", "Stable", "Exact"];

/// The number types of the tables.
pub const NUMBERS: [&str; 4] = ["f32", "f64", "I16F16", "I32F32"];

/// One row as it is printed: errors rounded up in the third digit.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures {
    pub tier: &'static str,
    pub number: String,
    pub primitive: &'static str,
    pub workload: String,
    pub hits: usize,
    /// Median, 99.9 % and worst error of `t`, in units in the last place.
    pub errors: [f64; 3],
    /// The same as lengths, where the solid's size is about 1.
    pub lengths: [f64; 3],
    /// Lost, phantom, on the other side of the range's start, on another part or with another crossing; and in the exact
    /// tier rays that were decided in integers.
    pub counts: [usize; 5],
}

impl Figures {
    /// Hits that are missing, and hits that are not there.
    pub fn wrong(&self) -> usize {
        self.counts[0] + self.counts[1]
    }

    fn new<S: Measurable>(tier: &'static str, primitive: &'static str, workload: String, row: &Measured) -> Self {
        const QUANTILES: [f64; 3] = [0.5, 0.999, 1.0];
        Self {
            tier,
            number: S::name(),
            primitive,
            workload,
            hits: row.hits,
            errors: QUANTILES.map(|fraction| rounded_up(row.quantile(fraction))),
            lengths: QUANTILES.map(|fraction| length_rounded_up(row.length(fraction))),
            counts: [row.lost, row.phantom, row.edge, row.part, row.integers],
        }
    }
}

/// Rounded up in the third significant digit, and in the third decimal.
pub fn rounded_up(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let digit = 10.0_f64.powi(value.log10().floor() as i32 - 2).max(1e-3);
    let rounded = (value / digit).ceil() * digit;
    // As it is written and read again.
    format!("{rounded:.3}").parse().unwrap_or(rounded)
}

/// Rounded up in the third significant digit, however small.
pub fn length_rounded_up(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let written = format!("{value:.2e}").parse().unwrap_or(value);
    if written >= value {
        return written;
    }
    let digit = 10.0_f64.powi(value.log10().floor() as i32 - 2);
    format!("{:.2e}", written + digit).parse().unwrap_or(value)
}

/// Which rows are measured, by number type and primitive.
pub type Wanted<'a> = &'a dyn Fn(&str, &str) -> bool;

fn rows<S: Measurable>(rays: usize, wanted: Wanted<'_>, all: &mut Vec<Figures>, tick: &mut dyn FnMut()) {
    let methods = S::methods();
    for primitive in SUBJECTS.into_iter().filter(|primitive| wanted(&S::name(), primitive)) {
        let subject = Subject::<S>::new(primitive);
        let mut put = |workload: String, measured: Option<Vec<Measured>>| {
            for (method, row) in methods.iter().zip(measured.into_iter().flatten()) {
                all.push(Figures::new::<S>(method.tier, primitive, workload.clone(), &row));
            }
            tick();
        };
        for (index, workload) in WORKLOADS.into_iter().enumerate() {
            put(workload.name(), measure_each(&methods, &subject, workload, rays, 1000 + index as u64, |_| true));
        }
        for (index, placing) in PLACINGS.into_iter().enumerate() {
            put(placing.name(), measure_placed(&methods, &subject, placing, rays, 2000 + index as u64));
        }
    }
}

/// How often `tick` is called for each primitive of a number type.
pub const TICKS: usize = WORKLOADS.len() + PLACINGS.len();

/// Every way to answer in every number type that it exists in, on every primitive and workload; by tier, then by number type.
pub fn measure_all(rays: usize, wanted: Wanted<'_>, tick: &mut dyn FnMut()) -> Vec<Figures> {
    let mut all = vec![];
    rows::<f32>(rays, wanted, &mut all, tick);
    rows::<f64>(rays, wanted, &mut all, tick);
    rows::<I16F16>(rays, wanted, &mut all, tick);
    rows::<I32F32>(rays, wanted, &mut all, tick);
    // A stable sort: number types, primitives and workloads stay in order.
    all.sort_by_key(|row| TIERS.iter().position(|tier| *tier == row.tier));
    all
}
