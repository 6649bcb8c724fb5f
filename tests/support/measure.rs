//! How wrong one tier in one number type is, on one primitive and one workload.

use super::exact_types::{Exact as Number, expected, same_crossing, same_part};
use super::oracle::{self, InRange};
use super::placed::{PLACINGS, Placed, Placing};
use super::random::Random;
use super::subject::{SUBJECTS, Subject};
use super::workload::{WORKLOADS, Workload};
use fixed::types::{I16F16, I32F32};
use raylet::tier::{Effort, Exact, Fast, Stable, Tier};
use raylet::{Ray, Shape};

/// What was measured over one row.
#[derive(Default)]
pub struct Measured {
    pub rays: usize,
    pub hits: usize,
    errors: Vec<f64>,
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
    fn count<S: Number, T: Tier<S>>(&mut self, shape: &Shape<S>, ray: &Ray<S>, want: InRange) {
        self.rays += 1;
        let got = shape.hits_at::<T>(ray);
        assert_eq!(shape.nearest_at::<T>(ray), got.first().copied(), "nearest is the first hit: {ray:?}");
        assert_eq!(shape.occludes_at::<T>(ray), !got.is_empty(), "occlusion agrees with the hits: {ray:?}");
        let (mut want, mut got) = (want.hits, got.to_vec());
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
            if !same_part(got.part, want.part) || !same_crossing(got.crossing, want.crossing) {
                self.part += 1;
            }
            self.errors.push(want.t.error_in(&got.t.exact(), &S::unit_at(&want.t)));
        }
    }

    /// The error in units in the last place that this share of all hits does not exceed.
    pub fn quantile(&self, fraction: f64) -> f64 {
        if self.errors.is_empty() { 0.0 } else { self.errors[((self.errors.len() - 1) as f64 * fraction) as usize] }
    }
}

/// The smallest positive value of a fixed type; of a float, next to nothing.
fn unit_of<S: Number>() -> f64 {
    S::BUDGET.smallest_size.to_f64()
}

/// The workload's rays; `None` if it has no sense for the subject.
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
    in_integers: InIntegers<S>,
) -> Option<Measured> {
    let mut random = Random(seed);
    let mut row = Measured::default();
    for _ in 0..rays {
        let Some(ray) = workload.ray(subject, &mut random) else { continue };
        if !counts(&ray) {
            continue;
        }
        row.count::<S, T>(&subject.shape, &ray, expected(&subject.solid, &ray));
        row.integers += usize::from(in_integers(&subject.shape, &ray));
    }
    row.errors.sort_by(f64::total_cmp);
    (row.rays > 0).then_some(row)
}

/// Rays at the primitive, placed anew for each.
pub fn measure_placed<S: Number, T: Tier<S>>(
    subject: &Subject<S>,
    placing: Placing,
    rays: usize,
    seed: u64,
    in_integers: InIntegers<S>,
) -> Option<Measured> {
    let mut random = Random(seed);
    let mut row = Measured::default();
    for _ in 0..rays {
        let Some(placed) = Placed::new(subject, placing, &mut random) else { continue };
        let Some(ray) = placed.ray(subject, &mut random) else { continue };
        let answer = oracle::solve(&subject.solid, &placed.line(&ray));
        let want = oracle::hits_in_range(&answer, &ray.range().start().exact(), Some(&ray.range().end().exact()));
        row.count::<S, T>(&placed.shape, &ray, want);
        row.integers += usize::from(in_integers(&placed.shape, &ray));
    }
    row.errors.sort_by(f64::total_cmp);
    (row.rays > 0).then_some(row)
}

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
    /// Lost, phantom, on the other side of the range's start, on another part or with another crossing; and in the exact
    /// tier rays that were decided in integers.
    pub counts: [usize; 5],
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

/// Whether a ray is decided in integers.
type InIntegers<S> = fn(&Shape<S>, &Ray<S>) -> bool;

fn rows<S: Number, T: Tier<S>>(
    tier: &'static str,
    rays: usize,
    in_integers: InIntegers<S>,
    all: &mut Vec<Figures>,
    tick: &mut dyn FnMut(),
) {
    for primitive in SUBJECTS {
        let subject = Subject::<S>::new(primitive);
        let figures = |row: Measured, workload: String| Figures {
            tier,
            number: S::name(),
            primitive,
            workload,
            hits: row.hits,
            errors: [0.5, 0.999, 1.0].map(|fraction| rounded_up(row.quantile(fraction))),
            counts: [row.lost, row.phantom, row.edge, row.part, row.integers],
        };
        for (index, workload) in WORKLOADS.into_iter().enumerate() {
            tick();
            let row = measure_where::<S, T>(&subject, workload, rays, 1000 + index as u64, |_| true, in_integers);
            all.extend(row.map(|row| figures(row, workload.name())));
        }
        for (index, placing) in PLACINGS.into_iter().enumerate() {
            tick();
            let row = measure_placed::<S, T>(&subject, placing, rays, 2000 + index as u64, in_integers);
            all.extend(row.map(|row| figures(row, placing.name())));
        }
    }
}

/// How often [`measure_all`] calls `tick`.
pub const TICKS: usize = 10 * SUBJECTS.len() * (WORKLOADS.len() + PLACINGS.len());

/// Every tier in every number type that it is measured in, on every primitive and workload.
pub fn measure_all(rays: usize, tick: &mut dyn FnMut()) -> Vec<Figures> {
    let mut all = vec![];
    rows::<f32, Fast>("Fast", rays, |_, _| false, &mut all, tick);
    rows::<f64, Fast>("Fast", rays, |_, _| false, &mut all, tick);
    rows::<I16F16, Fast>("Fast", rays, |_, _| false, &mut all, tick);
    rows::<I32F32, Fast>("Fast", rays, |_, _| false, &mut all, tick);
    rows::<f32, Stable>("Stable", rays, |_, _| false, &mut all, tick);
    rows::<f64, Stable>("Stable", rays, |_, _| false, &mut all, tick);
    rows::<I16F16, Stable>("Stable", rays, |_, _| false, &mut all, tick);
    rows::<I32F32, Stable>("Stable", rays, |_, _| false, &mut all, tick);
    rows::<f32, Exact>("Exact", rays, |shape, ray| shape.effort(ray) == Effort::Integers, &mut all, tick);
    rows::<I16F16, Exact>("Exact", rays, |shape, ray| shape.effort(ray) == Effort::Integers, &mut all, tick);
    all
}
