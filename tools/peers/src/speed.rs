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
    /// Its time over that of the textbook's `f32` sphere at benign rays that hit: first quartile, median, third
    /// quartile.
    pub to_sphere: [f64; 3],
    /// Its time over that of raylet's `Stable` at the same rays, likewise.
    pub to_stable: [f64; 3],
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

/// Times contestants against each other, all at the same rays; `stable` is the place of raylet's `Stable` among them,
/// and `sphere` is the textbook's sphere.
pub fn race<S>(
    contestants: &[Box<dyn Prepared<S> + '_>],
    stable: usize,
    sphere: &dyn Prepared<f32>,
    rounds: usize,
) -> Vec<Speed> {
    let mut sphere = Runner::new(sphere);
    let mut runners: Vec<_> = contestants.iter().map(|prepared| Runner::new(prepared.as_ref())).collect();
    let count = runners.len();
    for round in 0..rounds {
        sphere.turn();
        for place in 0..count {
            // Nobody always runs behind the same one.
            runners[(place + round) % count].turn();
        }
    }
    let ratios = |of: &[f64], to: &[f64]| quartiles(of.iter().zip(to).map(|(a, b)| a / b).collect());
    runners
        .iter()
        .map(|runner| Speed {
            nanoseconds: 1e9 * quartiles(runner.seconds.clone())[1],
            to_sphere: ratios(&runner.seconds, &sphere.seconds),
            to_stable: ratios(&runner.seconds, &runners[stable].seconds),
        })
        .collect()
}

fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [0.25, 0.5, 0.75].map(|fraction| values[((values.len() - 1) as f64 * fraction).round() as usize])
}
