//! How long a query takes, on a machine that does other things too.
//!
//! The contestants take turns, round after round, for some fifty microseconds each. What disturbs the machine for
//! longer than a round disturbs them all, so that the ratios of one round are worth more than any time: of each ratio
//! the median over the rounds counts.

use crate::contestant::Prepared;
use std::time::Instant;

/// How long a turn should be.
const TURN: f64 = 50e-6;

/// How the time is divided.
#[derive(Clone, Copy)]
pub struct Effort {
    /// Rays of each kind.
    pub rays: usize,
    /// Rounds.
    pub rounds: usize,
}

/// What was measured of one contestant.
#[derive(Clone, Debug, PartialEq)]
pub struct Speed {
    /// Nanoseconds a ray.
    pub nanoseconds: f64,
    /// Its time over that of raylet's `Stable` at the same rays.
    pub to_stable: f64,
}

/// One who takes turns.
struct Runner<'a, S> {
    prepared: &'a dyn Prepared<S>,
    /// Passes over the rays that make a turn.
    passes: usize,
    /// Per round, seconds a ray.
    seconds: Vec<f64>,
}

impl<'a, S> Runner<'a, S> {
    fn new(prepared: &'a dyn Prepared<S>) -> Self {
        prepared.pass();
        let start = Instant::now();
        prepared.pass();
        let pass = start.elapsed().as_secs_f64().max(1e-9);
        Self { prepared, passes: ((TURN / pass) as usize).clamp(1, 100), seconds: vec![] }
    }

    fn turn(&mut self) {
        // What ran before has filled caches and predictors with its own.
        self.prepared.pass();
        let start = Instant::now();
        for _ in 0..self.passes {
            self.prepared.pass();
        }
        let queries = self.passes * self.prepared.rays();
        self.seconds.push(start.elapsed().as_secs_f64() / queries as f64);
    }
}

/// Times contestants against each other, all at the same rays; `stable` is the place of raylet's `Stable` among them.
pub fn race<S>(contestants: &[Box<dyn Prepared<S> + '_>], stable: usize, rounds: usize) -> Vec<Speed> {
    let mut runners: Vec<_> = contestants.iter().map(|prepared| Runner::new(prepared.as_ref())).collect();
    let count = runners.len();
    for round in 0..rounds {
        for place in 0..count {
            // Nobody always runs behind the same one.
            runners[(place + round) % count].turn();
        }
    }
    let to_stable = |runner: &Runner<'_, S>| {
        median(runner.seconds.iter().zip(&runners[stable].seconds).map(|(own, stable)| own / stable).collect())
    };
    runners
        .iter()
        .map(|runner| Speed { nanoseconds: 1e9 * median(runner.seconds.clone()), to_stable: to_stable(runner) })
        .collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[(values.len() - 1) / 2]
}
