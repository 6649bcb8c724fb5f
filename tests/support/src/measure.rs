//! How wrong the ways to answer in one number type are, on one primitive and one workload.

use super::exact_types::{Exact as Number, expected, same_crossing, same_part};
use super::method::{Asked, Method, Told};
use super::oracle::{self, InRange};
use super::placed::{Placed, Placing};
use super::random::Random;
use super::subject::Subject;
use super::workload::Workload;
use raylet::tier::Tier;
use raylet::{Ray, Shape};

/// What was measured over one row.
#[derive(Default)]
pub struct Measured {
    pub rays: usize,
    pub hits: usize,
    /// In units in the last place, sorted.
    errors: Vec<f64>,
    /// As lengths, sorted.
    lengths: Vec<f64>,
    /// Hits of exact arithmetic that are missing.
    pub lost: usize,
    /// Hits that exact arithmetic does not have.
    pub phantom: usize,
    /// Hits within one unit of the range's start that are on the other side of it, in either direction.
    pub edge: usize,
    /// Hits on another part, or with another crossing.
    pub part: usize,
    /// Rays that the exact tier decided in integers.
    pub integers: usize,
}

impl Measured {
    /// Compares the hits of one ray with the exact ones.
    fn count<S: Number>(&mut self, mut got: Vec<Told<S>>, want: &InRange) {
        self.rays += 1;
        let mut want: Vec<_> = want.hits.iter().collect();
        if want.len() != got.len() {
            // A t of less than half a unit rounds onto the range's start, or off it.
            let unit = |t: &oracle::Root| t.error_in(&S::ZERO.exact(), &S::unit_at(t)) <= 1.0;
            let before = want.len() + got.len();
            want.retain(|hit| !unit(&hit.t));
            got.retain(|hit| hit.t.to_f64().abs() > f64::from(f32::MIN_POSITIVE).max(unit_of::<S>()));
            self.edge += before - want.len() - got.len();
        }
        if want.len() != got.len() {
            self.lost += want.len().saturating_sub(got.len());
            self.phantom += got.len().saturating_sub(want.len());
            return;
        }
        for (want, got) in want.iter().zip(&got) {
            self.hits += 1;
            let differs = |(part, crossing)| !same_part(part, want.part) || !same_crossing(crossing, want.crossing);
            self.part += usize::from(got.surface.is_some_and(differs));
            let unit = S::unit_at(&want.t);
            let error = want.t.error_in(&got.t.exact(), &unit);
            self.errors.push(error);
            // A unit is a power of two: the product is as exact as the error.
            self.lengths.push(error * unit.to_f64());
        }
    }

    fn sorted(mut self) -> Self {
        self.errors.sort_by(f64::total_cmp);
        self.lengths.sort_by(f64::total_cmp);
        self
    }

    /// The error in units in the last place that this share of all hits does not exceed.
    pub fn quantile(&self, fraction: f64) -> f64 {
        quantile(&self.errors, fraction)
    }

    /// The same as a length.
    pub fn length(&self, fraction: f64) -> f64 {
        quantile(&self.lengths, fraction)
    }
}

fn quantile(sorted: &[f64], fraction: f64) -> f64 {
    if sorted.is_empty() { 0.0 } else { sorted[((sorted.len() - 1) as f64 * fraction) as usize] }
}

/// The smallest positive value of a fixed type; of a float, next to nothing.
fn unit_of<S: Number>() -> f64 {
    S::BUDGET.smallest_size.to_f64()
}

/// One row for each method, all at the same rays: the exact answer, which takes longest, is found once.
struct Rows<'a, S: Number> {
    methods: &'a [Method<S>],
    rows: Vec<Measured>,
}

impl<'a, S: Number> Rows<'a, S> {
    fn new(methods: &'a [Method<S>]) -> Self {
        Self { methods, rows: methods.iter().map(|_| Measured::default()).collect() }
    }

    fn ask(&mut self, asked: &Asked<'_, S>, ray: &Ray<S>, want: &InRange) {
        for (method, row) in self.methods.iter().zip(&mut self.rows) {
            row.count((method.hits)(asked, ray), want);
            row.integers += usize::from((method.in_integers)(asked.shape(), ray));
        }
    }

    fn done(self) -> Option<Vec<Measured>> {
        let any = self.rows.first().is_some_and(|row| row.rays > 0);
        any.then(|| self.rows.into_iter().map(Measured::sorted).collect())
    }
}

/// The workload's rays for which `counts` holds; `None` if it has no sense for the subject, or no ray fits the type.
pub fn measure_each<S: Number>(
    methods: &[Method<S>],
    subject: &Subject<S>,
    workload: Workload,
    rays: usize,
    seed: u64,
    counts: impl Fn(&Ray<S>) -> bool,
) -> Option<Vec<Measured>> {
    let mut random = Random(seed);
    let mut rows = Rows::new(methods);
    for _ in 0..rays {
        if let Some(ray) = workload.ray(subject, &mut random).filter(&counts) {
            rows.ask(&Asked { subject, placed: None }, &ray, &expected(&subject.solid, &ray));
        }
    }
    rows.done()
}

/// Rays at the primitive, placed anew for each.
pub fn measure_placed<S: Number>(
    methods: &[Method<S>],
    subject: &Subject<S>,
    placing: Placing,
    rays: usize,
    seed: u64,
) -> Option<Vec<Measured>> {
    let mut random = Random(seed);
    let mut rows = Rows::new(methods);
    for _ in 0..rays {
        let Some(placed) = Placed::new(subject, placing, &mut random) else { continue };
        let Some(ray) = placed.ray(subject, &mut random) else { continue };
        let answer = oracle::solve(&subject.solid, &placed.line(&ray));
        let want = oracle::hits_in_range(&answer, &ray.range().start().exact(), Some(&ray.range().end().exact()));
        rows.ask(&Asked { subject, placed: Some(&placed) }, &ray, &want);
    }
    rows.done()
}

/// One tier at the workload's rays; `None` if it has no sense for the subject.
pub fn measure<S: Number, T: Tier<S>>(
    subject: &Subject<S>,
    workload: Workload,
    rays: usize,
    seed: u64,
) -> Option<Measured> {
    measure_where::<S, T>(subject, workload, rays, seed, |_| true, |_, _| false)
}

/// Of the workload's rays those for which `counts` holds.
pub fn measure_where<S: Number, T: Tier<S>>(
    subject: &Subject<S>,
    workload: Workload,
    rays: usize,
    seed: u64,
    counts: impl Fn(&Ray<S>) -> bool,
    in_integers: fn(&Shape<S>, &Ray<S>) -> bool,
) -> Option<Measured> {
    let method = Method { in_integers, ..Method::tier::<T>("") };
    measure_each(&[method], subject, workload, rays, seed, counts)?.pop()
}
