//! Searches for rays that break a tier's promise: from the worst of random rays each step changes one coordinate or the
//! direction a little, and stays where that is worse.

use super::exact_types::Exact as Number;
use super::measure::{Broken, measure_one};
use super::method::{Method, Target};
use super::placed::{Placed, Placing};
use super::random::{Random, add, normalize, scale};
use super::subject::Subject;
use super::workload::Workload;
use raylet::Ray;

/// How long is searched.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Random rays.
    pub rays: usize,
    /// So many of them, the worst, are climbed from.
    pub starts: usize,
    pub steps: usize,
}

/// What was found: how much of its limit the worst ray takes, and the ray if that is more than one.
pub type Found = (f64, Option<Broken>);

/// A ray nearby: one coordinate or the direction moved, by anything between a hundredth and less than a unit.
fn beside<S: Number>(ray: &Ray<S>, random: &mut Random) -> Option<Ray<S>> {
    let finest = if S::name() == "f64" || S::name() == "I32F32" { -16.0 } else { -8.0 };
    let by = 10.0_f64.powf(random.between(finest, -2.0)) * random.sign();
    let (mut origin, mut direction) = (ray.origin().to_f64(), ray.direction().to_f64());
    if random.below(2) == 0 {
        direction = normalize(add(direction, scale(random.direction(), by)));
    } else {
        let axis = random.below(3);
        origin[axis] += by * if random.below(2) == 0 { origin[axis] } else { 1.0 };
    }
    let ray_beside = Workload::rounded((origin, direction))?.with_range(ray.range());
    Some(ray.departure().map_or(ray_beside, |departure| ray_beside.departing(departure)))
}

/// The worst ray of a tier at a row of the tables; `None` where no ray fits it.
pub fn climb<S: Number>(
    method: &Method<S>,
    subject: &Subject<S>,
    (placing, workload): (Option<Placing>, Workload),
    effort: Effort,
    seed: u64,
) -> Option<Found> {
    let mut random = Random(seed);
    let mut all = vec![];
    for _ in 0..effort.rays {
        let placed = match placing {
            None => None,
            Some(placing) => match Placed::new(subject, placing, &mut random) {
                None => continue,
                placed => placed,
            },
        };
        let ray = match &placed {
            None => workload.ray(subject, &mut random),
            Some(placed) => placed.ray(subject, workload, &mut random),
        };
        let Some(ray) = ray else { continue };
        let found = measure_one(method, &Target::of(subject, placed.as_ref()), &ray);
        all.push((found, placed, ray));
    }
    all.sort_by(|(one, ..), (other, ..)| other.0.total_cmp(&one.0));
    all.truncate(effort.starts);
    let mut worst: Option<Found> = None;
    for (mut found, placed, mut ray) in all {
        let target = Target::of(subject, placed.as_ref());
        for _ in 0..effort.steps {
            let Some(next) = beside(&ray, &mut random) else { continue };
            let tried = measure_one(method, &target, &next);
            if tried.0 >= found.0 {
                (found, ray) = (tried, next);
            }
        }
        if worst.as_ref().is_none_or(|worst| found.0 > worst.0) {
            worst = Some(found);
        }
    }
    worst
}
