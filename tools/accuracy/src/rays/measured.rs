//! The rows of a file of rays at one solid: a row for each number type and way to answer, and the worst ray of each.

use super::csv::Line;
use super::decimal::Decimal;
use super::placement::Placement;
use crate::study::{Study, Time, Times};
use crate::time::{self, Query, Reference, Timed};
use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::{Ray, Shape};
use support::described::Described;
use support::figures::{Figures, Rays};
use support::measure::{Judgement, Measured, Rows};
use support::method::{Target, Told};
use support::oracle::InRange;
use support::placed::{Placed, UNPLACED};
use support::textbook;

/// Rounds of timing, as of the published tables.
const ROUNDS: usize = 9;

/// What is measured.
pub struct Task<'a> {
    /// The file's name, as it was given.
    pub file: &'a str,
    pub solid: Described<Decimal<'a>>,
    pub placement: Option<Placement<'a>>,
    pub lines: Vec<Line<'a>>,
    /// Number types.
    pub numbers: Vec<&'static str>,
    pub is_timed: bool,
}

/// A hit, as a report tells it.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    pub t: f64,
    /// Part and crossing; the textbook tells neither.
    pub surface: Option<[String; 2]>,
}

/// The ray with the worst answer: a lost or phantom hit before another part, and that before an error of `t`.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// The line in the file.
    pub line: usize,
    /// In units in the last place; of wrong hits there is none.
    pub error: Option<f64>,
    pub hits: Vec<Hit>,
    pub exact: Vec<Hit>,
}

/// What is told of a row beside the figures of the published tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Extra {
    /// Rays that the number type holds, and rays that it does not.
    pub rays: usize,
    pub not_held: usize,
    pub worst: Option<Worst>,
    /// The error that a share of the hits exceeds: shares from 1 down to that of a single hit.
    pub exceeded: Vec<(f64, f64)>,
}

/// All that was measured.
pub struct Outcome {
    /// The rows, with their times.
    pub study: Study,
    /// As many as the study has rows.
    pub extras: Vec<Extra>,
    /// Number types that do not hold the solid or its placement, and why.
    pub left_out: Vec<(String, String)>,
}

impl Task<'_> {
    /// How tables name the placement.
    pub fn placed(&self) -> &'static str {
        self.placement.map_or(UNPLACED, |placement| placement.name())
    }

    /// Measures every number type. Fails if none holds the solid and its placement.
    pub fn measure(&self, tick: &mut dyn FnMut()) -> Result<Outcome, String> {
        let mut found = Found::default();
        if self.is_timed {
            found.reference = Some(Reference::new());
        }
        for number in &self.numbers {
            let done = match *number {
                "f32" => self.of_type::<f32>(&mut found, tick),
                "f64" => self.of_type::<f64>(&mut found, tick),
                "I16F16" => self.of_type::<I16F16>(&mut found, tick),
                "I8F24" => self.of_type::<I8F24>(&mut found, tick),
                "I20F12" => self.of_type::<I20F12>(&mut found, tick),
                _ => self.of_type::<I32F32>(&mut found, tick),
            };
            if let Err(why) = done {
                found.left_out.push(((*number).into(), why));
            }
        }
        let Found { rows, times, left_out, reference } = found;
        if rows.is_empty() {
            let mut reasons: Vec<&str> = left_out.iter().map(|(_, why)| why.as_str()).collect();
            reasons.dedup();
            let (solid, numbers) = (self.solid.name(), self.numbers.join(", "));
            return Err(format!("no number type ({numbers}) holds the {solid}: {}", reasons.join("; ")));
        }
        let (rows, extras) = rows.into_iter().unzip();
        let times = match reference {
            Some(reference) if !times.is_empty() => reference.done(times),
            _ => Times::default(),
        };
        let rays = Rays { unplaced: self.lines.len(), placed: self.lines.len() };
        Ok(Outcome { study: Study::new(rays, rows, times, vec![], vec![]), extras, left_out })
    }

    fn of_type<S: Timed>(&self, found: &mut Found, tick: &mut dyn FnMut()) -> Result<(), String> {
        let sized = self.solid.try_map(Decimal::rounded::<S>).map_err(|error| error.to_string())?;
        let (shape, solid) = (sized.shape().map_err(|error| error.to_string())?, sized.solid());
        let placement = self.placement.map(|placement| placement.rounded::<S>()).transpose()?;
        let placed = placement.map(|placement| Placed::by(&shape, &solid, placement)).transpose();
        let placed = placed.map_err(|error| error.to_string())?;
        let stands = placed.as_ref().map_or(&shape, |placed| &placed.shape);
        let target = Target { shape: stands, solid: &solid, size: sized.size(), placed: placed.as_ref() };

        let methods = S::methods();
        let mut rows = Rows::new(&methods);
        let mut worst = vec![None; methods.len()];
        let mut held = vec![];
        for line in &self.lines {
            tick();
            let Some(ray) = line.ray::<S>() else { continue };
            held.push(ray);
            let (exact, judgements) = rows.measure(&target, &ray);
            for (worst, judgement) in worst.iter_mut().zip(&judgements) {
                keep_worst(worst, line.number, judgement, &exact);
            }
        }
        let measured = rows.done().unwrap_or_else(|| methods.iter().map(|_| Measured::default()).collect());
        for ((method, measured), worst) in methods.iter().zip(measured).zip(worst) {
            let names = (self.file.to_string(), self.placed().to_string());
            let figures = Figures::of::<S>(method.tier, self.solid.name(), names, &measured);
            let extra = Extra {
                rays: held.len(),
                not_held: self.lines.len() - held.len(),
                worst: worst.map(|(_, worst)| worst),
                exceeded: exceeded(&measured),
            };
            found.rows.push((figures, extra));
        }
        if let Some(reference) = &mut found.reference {
            let queries = queries(stands, placed.as_ref(), &held);
            let name = support::figures::name(self.file, self.placed());
            found.times.extend(reference.rows(&solid, &queries, [self.solid.name(), &name], ROUNDS));
        }
        Ok(())
    }
}

/// What has been measured so far.
#[derive(Default)]
struct Found {
    rows: Vec<(Figures, Extra)>,
    times: Vec<Time>,
    left_out: Vec<(String, String)>,
    /// `None`: nothing is timed.
    reference: Option<Reference>,
}

/// How bad an answer is: wrong hits, another part, the error.
type Badness = (bool, bool, f64);

fn keep_worst<S: Timed>(worst: &mut Option<(Badness, Worst)>, line: usize, judgement: &Judgement<S>, exact: &InRange) {
    let badness = (judgement.is_wrong, judgement.is_on_other_part, judgement.error);
    // Of a ray without hits, and without wrong ones, there is nothing to tell.
    let is_told = judgement.is_wrong || !judgement.hits.is_empty();
    if !is_told || worst.as_ref().is_some_and(|(before, _)| badness <= *before) {
        return;
    }
    let told = |hit: &Told<S>| Hit {
        t: hit.t.to_f64(),
        surface: hit.surface.map(|(part, crossing)| [format!("{part:?}"), format!("{crossing:?}")]),
    };
    let hits = judgement.hits.iter().map(told).collect();
    let wanted = exact.hits.iter().map(|hit| Hit {
        t: hit.t.to_f64(),
        surface: Some([format!("{:?}", hit.part), format!("{:?}", hit.crossing)]),
    });
    let error = (!judgement.is_wrong).then_some(judgement.error);
    *worst = Some((badness, Worst { line, error, hits, exact: wanted.collect() }));
}

/// Errors by the share of hits that exceed them: of 1, 2 and 5 of a power of ten, down to a single hit.
fn exceeded(measured: &Measured) -> Vec<(f64, f64)> {
    let mut points = vec![];
    for power in 0.. {
        for step in [1.0, 2.0, 5.0] {
            let part = step * 10.0_f64.powi(power);
            if part > measured.hits as f64 {
                if measured.hits > 0 {
                    points.push((1.0 / measured.hits as f64, measured.quantile(1.0)));
                }
                return points;
            }
            points.push((1.0 / part, measured.quantile(1.0 - 1.0 / part)));
        }
    }
    points
}

/// Of the rays those that hit and those that miss, as many as the published times are of, from all over the file.
fn queries<S: Timed>(shape: &Shape<S>, placed: Option<&Placed<S>>, rays: &[Ray<S>]) -> [Vec<Query<S>>; 2] {
    let (hits, misses): (Vec<_>, Vec<_>) = rays.iter().partition(|ray| shape.occludes(ray));
    [hits, misses].map(|rays| {
        let step = rays.len().div_ceil(time::RAYS).max(1);
        let query = |ray: Ray<S>| Query { shape: *shape, place: placed.map(textbook::place), ray };
        rays.into_iter().step_by(step).map(query).collect()
    })
}
