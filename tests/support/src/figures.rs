//! The rows of the accuracy tables: every number type, way to answer, primitive, placement and workload.

use super::measure::{Broken, Measured, measure_each, measure_placed};
use super::method::{Measurable, Method};
use super::placed::{PLACINGS, Placing, UNPLACED};
use super::subject::{SUBJECTS, Subject};
use super::workload::{FURTHER, WORKLOADS, Workload};
use fixed::types::{I16F16, I32F32};

/// The ways to answer, the plainest first. `Textbook` is `k^2 - a c` in the operators of the number type.
pub const TIERS: [&str; 5] = ["Textbook", "Plain", "Fast", "Stable", "Exact"];

/// The number types of the tables.
pub const NUMBERS: [&str; 4] = ["f32", "f64", "I16F16", "I32F32"];

/// One row as it is printed: errors rounded up in the third digit.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures {
    pub tier: &'static str,
    pub number: String,
    pub primitive: &'static str,
    pub placed: String,
    pub workload: String,
    pub hits: usize,
    /// Median, 99.9 % and worst error of `t`, in units in the last place.
    pub errors: [f64; 3],
    /// The same as lengths, where the solid's size is about 1.
    pub lengths: [f64; 3],
    /// Lost, phantom, on the other side of the range's start, on another part or with another crossing; and in the
    /// exact tier rays that were decided in integers.
    pub counts: [usize; 5],
    /// Rays of which the tier's promise is broken.
    pub broken: usize,
    /// The worst of them; not in the tables.
    pub worst: Option<Broken>,
}

impl Figures {
    /// Hits that are missing, and hits that are not there.
    pub fn wrong(&self) -> usize {
        self.counts[0] + self.counts[1]
    }

    /// True if the solid is not placed.
    pub fn is_unplaced(&self) -> bool {
        self.placed == UNPLACED
    }

    /// The workload, and how the solid is placed.
    pub fn name(&self) -> String {
        name(&self.workload, &self.placed)
    }

    /// True if rays like these are timed: those of [`WORKLOADS`], and the benign ones at placed solids.
    pub fn is_timed(&self) -> bool {
        if self.is_unplaced() {
            WORKLOADS.iter().any(|workload| workload.name() == self.workload)
        } else {
            self.workload == Workload::Benign.name()
        }
    }

    fn new<S: Measurable>(tier: &'static str, primitive: &'static str, row: Row, measured: &Measured) -> Self {
        let placed = row.placing.map_or(UNPLACED.into(), Placing::name);
        Self::of::<S>(tier, primitive, (row.workload.name(), placed), measured)
    }

    /// What was measured of a tier, at a primitive, with rays of this name at solids that are placed so.
    pub fn of<S: Measurable>(
        tier: &'static str,
        primitive: &'static str,
        (workload, placed): (String, String),
        measured: &Measured,
    ) -> Self {
        const QUANTILES: [f64; 3] = [0.5, 0.999, 1.0];
        Self {
            tier,
            number: S::name(),
            primitive,
            placed,
            workload,
            hits: measured.hits,
            errors: QUANTILES.map(|fraction| rounded_up(measured.quantile(fraction))),
            lengths: QUANTILES.map(|fraction| length_rounded_up(measured.length(fraction))),
            counts: [measured.lost, measured.phantom, measured.edge, measured.part, measured.integers],
            broken: measured.broken,
            worst: measured.worst.clone(),
        }
    }
}

/// A workload at solids that are placed so.
pub fn name(workload: &str, placed: &str) -> String {
    if placed == UNPLACED { workload.into() } else { format!("{workload}, {placed}") }
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

/// What the textbook is measured with at turned solids.
const TURNED: [Workload; 3] = [Workload::Benign, Workload::Away(10_000.0), Workload::Grazing(1e-4)];

/// A row of a primitive.
#[derive(Clone, Copy)]
struct Row {
    placing: Option<Placing>,
    workload: Workload,
    seed: u64,
}

impl Row {
    /// All of them: those that are not placed first.
    fn all() -> Vec<Self> {
        let workloads = || WORKLOADS.into_iter().zip(0..).chain(FURTHER.into_iter().zip(100..));
        let mut all: Vec<_> =
            workloads().map(|(workload, index)| Self { placing: None, workload, seed: 1000 + index }).collect();
        for (place, placing) in PLACINGS.into_iter().enumerate() {
            let seed = 2000 + 1000 * place as u64;
            let has = workloads().filter(|(workload, _)| placing.has(*workload));
            all.extend(has.map(|(workload, index)| Self { placing: Some(placing), workload, seed: seed + index }));
        }
        all
    }

    /// The textbook knows no departures; where it stands placed is told by benign rays, and of turned solids also by
    /// rays from afar and by grazing ones, as the README shows them.
    fn has(self, tier: &str) -> bool {
        if tier != "Textbook" {
            return true;
        }
        match self.placing {
            None => !matches!(self.workload, Workload::Departing(_)),
            Some(Placing::Turned) => TURNED.contains(&self.workload),
            Some(_) => self.workload == Workload::Benign,
        }
    }

    fn measure<S: Measurable>(self, subject: &Subject<S>, methods: &[Method<S>], rays: Rays) -> Option<Vec<Measured>> {
        let Self { placing, workload, seed } = self;
        match placing {
            None => measure_each(methods, subject, workload, rays.unplaced, seed, |_| true),
            Some(placing) => measure_placed(methods, subject, workload, placing, rays.placed, seed),
        }
    }
}

/// How many rays a row has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rays {
    pub unplaced: usize,
    /// Fewer: there are several placements for each row that has none.
    pub placed: usize,
}

impl Rays {
    /// So many, and a quarter of them for each row that is placed.
    pub const fn new(unplaced: usize) -> Self {
        Self { unplaced, placed: unplaced.div_ceil(4) }
    }
}

/// Which rows are measured, by number type and primitive.
pub type Wanted<'a> = &'a dyn Fn(&str, &str) -> bool;

fn rows<S: Measurable>(rays: Rays, wanted: Wanted<'_>, all: &mut Vec<Figures>, tick: &mut dyn FnMut()) {
    for primitive in SUBJECTS.into_iter().filter(|primitive| wanted(&S::name(), primitive)) {
        let subject = Subject::<S>::new(primitive);
        for row in Row::all() {
            let methods: Vec<_> = S::methods().into_iter().filter(|method| row.has(method.tier)).collect();
            let measured = row.measure(&subject, &methods, rays).into_iter().flatten();
            all.extend(
                methods
                    .iter()
                    .zip(measured)
                    .map(|(method, measured)| Figures::new::<S>(method.tier, primitive, row, &measured)),
            );
            tick();
        }
    }
}

/// How often `tick` is called for each primitive of a number type.
pub fn ticks() -> usize {
    Row::all().len()
}

/// Every way to answer in every number type that it exists in, on every primitive, placement and workload; by tier,
/// then by number type.
pub fn measure_all(rays: Rays, wanted: Wanted<'_>, tick: &mut dyn FnMut()) -> Vec<Figures> {
    let mut all = vec![];
    rows::<f32>(rays, wanted, &mut all, tick);
    rows::<f64>(rays, wanted, &mut all, tick);
    rows::<I16F16>(rays, wanted, &mut all, tick);
    rows::<I32F32>(rays, wanted, &mut all, tick);
    // A stable sort: number types, primitives and workloads stay in order.
    all.sort_by_key(|row| TIERS.iter().position(|tier| *tier == row.tier));
    all
}
