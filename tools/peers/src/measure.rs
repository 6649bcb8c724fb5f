//! Every primitive at every workload: errors, then times.

use crate::entrants::Field;
use crate::errors::{self, Errors};
use crate::names::STABLE;
use crate::rays;
use crate::sizes::PRIMITIVES;
use crate::speed::{self, Effort, Speed};
use support::subject::Subject;
use support::workload::{WORKLOADS, Workload};

/// One contestant on one workload.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub number: String,
    pub primitive: &'static str,
    pub workload: Workload,
    pub contestant: &'static str,
    pub errors: Errors,
    /// At rays that hit; `None` where there are too few.
    pub hits: Option<Speed>,
    /// At rays that miss.
    pub misses: Option<Speed>,
}

/// How much is measured.
#[derive(Clone, Copy)]
pub struct Plan {
    /// Rays that are judged, a row.
    pub rays: usize,
    pub effort: Effort,
}

/// How often [`measure`] calls `tick`.
pub const TICKS: usize = 2 * PRIMITIVES.len() * WORKLOADS.len();

/// All rows, those of one primitive and workload together.
pub fn measure(plan: Plan, tick: &mut dyn FnMut()) -> Vec<Row> {
    let mut rows = vec![];
    of_number::<f32>(plan, &mut rows, tick);
    of_number::<f64>(plan, &mut rows, tick);
    rows
}

fn of_number<S: Field>(plan: Plan, rows: &mut Vec<Row>, tick: &mut dyn FnMut()) {
    for primitive in PRIMITIVES {
        let subject = Subject::<S>::new(primitive);
        for workload in WORKLOADS {
            rows.extend(of_workload(&subject, workload, plan));
            tick();
        }
    }
}

fn of_workload<S: Field>(subject: &Subject<S>, workload: Workload, plan: Plan) -> Vec<Row> {
    let drawn = rays::drawn(subject, workload, plan.rays);
    if drawn.is_empty() {
        return vec![];
    }
    let entrants = S::entrants(subject);
    let truths = errors::truths(&subject.solid, &drawn);
    let stable = entrants.iter().position(|entrant| entrant.name == STABLE).expect("raylet takes part everywhere");
    let [mut hits, mut misses] = rays::apart(subject, workload, &drawn).map(|rays| {
        let rays = rays?;
        let rays = &rays[..rays.len().min(plan.effort.rays)];
        let prepared: Vec<_> = entrants.iter().map(|entrant| entrant.prepare(rays)).collect();
        Some(speed::race(&prepared, stable, plan.effort.rounds).into_iter())
    });
    let row = |entrant: &crate::contestant::Entrant<S>| Row {
        number: S::name(),
        primitive: subject.name,
        workload,
        contestant: entrant.name,
        errors: errors::judge(entrant, &drawn, &truths),
        hits: hits.as_mut().and_then(Iterator::next),
        misses: misses.as_mut().and_then(Iterator::next),
    };
    entrants.iter().map(row).collect()
}
