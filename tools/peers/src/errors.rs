//! How wrong the nearest hits of a contestant are, against exact arithmetic on the numbers that it received.

use crate::contestant::Entrant;
use crate::number::Number;
use raylet::Ray;
use support::exact_types::exact_line;
use support::oracle::{self, Answer, Dyadic, Root, Solid};

/// A hit that is farther off than so many units in the last place is wrong, whatever else it is.
pub const WRONG: f64 = 1000.0;

/// What exact arithmetic says of a ray's nearest hit.
pub enum Truth {
    Hit(Root),
    Miss,
    /// The line lies in the surface, so that no point is the nearest: there is no query.
    Undefined,
}

/// The errors of one contestant on one workload.
#[derive(Clone, Debug, PartialEq)]
pub struct Errors {
    /// Rays, and how many of them exact arithmetic hits with.
    pub rays: usize,
    pub hits: usize,
    /// Median, 99.9 % and worst error of `t`, over the hits that were found, in units in the last place.
    pub units: [f64; 3],
    /// The same in lengths; the subjects are of size 1.
    pub lengths: [f64; 3],
    /// Hits of exact arithmetic that were not found.
    pub lost: usize,
    /// Hits that exact arithmetic does not have.
    pub phantom: usize,
    /// Hits that are farther off than [`WRONG`].
    pub wrong: usize,
}

impl Errors {
    /// Answers that are not merely inaccurate.
    pub fn failures(&self) -> usize {
        self.lost + self.phantom + self.wrong
    }
}

fn truth<S: Number>(solid: &Solid, line: &oracle::Line, ray: &Ray<S>) -> Truth {
    let answer = oracle::solve(solid, line);
    if matches!(answer, Answer::Coincident { .. }) {
        return Truth::Undefined;
    }
    let range = ray.range();
    match oracle::hits_in_range(&answer, &range.start().exact(), Some(&range.end().exact())).hits.into_iter().next() {
        Some(hit) => Truth::Hit(hit.t),
        None => Truth::Miss,
    }
}

/// The truth for rays at the subject itself.
pub fn truths<S: Number>(solid: &Solid, rays: &[Ray<S>]) -> Vec<Truth> {
    rays.iter().map(|ray| truth(solid, &exact_line(ray), ray)).collect()
}

/// What is true for a contestant whose primitive stands elsewhere, so that its rays are rounded in their own way.
fn own_truths<S: Number>(entrant: &Entrant<S>, rays: &[Ray<S>]) -> Vec<Truth> {
    let one = |ray| {
        let own = entrant.pose.own_ray(ray);
        truth(&entrant.solid, &entrant.pose.exact_line(&own), &own)
    };
    rays.iter().map(one).collect()
}

/// Judges a contestant; `truths` are those of the subject.
pub fn judge<S: Number>(entrant: &Entrant<S>, rays: &[Ray<S>], truths: &[Truth]) -> Errors {
    let answers = entrant.prepare(rays).distances();
    if entrant.pose.is_same() {
        return compare(&answers, truths);
    }
    compare(&answers, &own_truths(entrant, rays))
}

fn compare<S: Number>(answers: &[Option<S>], truths: &[Truth]) -> Errors {
    let [mut lost, mut phantom, mut hits, mut rays] = [0; 4];
    let (mut units, mut lengths) = (vec![], vec![]);
    for (answer, truth) in answers.iter().zip(truths) {
        rays += usize::from(!matches!(truth, Truth::Undefined));
        hits += usize::from(matches!(truth, Truth::Hit(_)));
        match (answer, truth) {
            (Some(t), Truth::Hit(exact)) if t.is_finite() => {
                units.push(exact.error_in(&t.exact(), &S::unit_at(exact)));
                lengths.push(exact.error_in(&t.exact(), &Dyadic::from(1)));
            }
            // A NaN or an infinity is no place.
            (_, Truth::Hit(_)) => lost += 1,
            (Some(_), Truth::Miss) => phantom += 1,
            (None, Truth::Miss) | (_, Truth::Undefined) => {}
        }
    }
    let wrong = units.iter().filter(|error| **error > WRONG).count();
    Errors { rays, hits, units: quantiles(units), lengths: quantiles(lengths), lost, phantom, wrong }
}

/// Median, 99.9 % and worst.
fn quantiles(mut errors: Vec<f64>) -> [f64; 3] {
    errors.sort_by(f64::total_cmp);
    [0.5, 0.999, 1.0].map(|fraction| match errors.len() {
        0 => 0.0,
        count => errors[((count - 1) as f64 * fraction) as usize],
    })
}
