//! The rays: those of `docs/accuracy.md`, and the same sorted into hits and misses for the clock.

use crate::number::Number;
use raylet::{Ray, Vec3};
use support::exact_types::expected;
use support::random::{Random, add, scale};
use support::subject::Subject;
use support::workload::{WORKLOADS, Workload};

/// Fewer rays than this of a kind are no measurement.
const FEWEST: usize = 50;

/// The first rays of a workload; none where it has no sense for the subject.
pub fn drawn<S: Number>(subject: &Subject<S>, workload: Workload, count: usize) -> Vec<Ray<S>> {
    let mut random = Random(seed(workload));
    (0..count).filter_map(|_| workload.ray(subject, &mut random)).collect()
}

/// As `examples/accuracy` seeds them, so that the rays are the same.
fn seed(workload: Workload) -> u64 {
    let place = WORKLOADS.iter().position(|known| *known == workload).unwrap_or(WORKLOADS.len());
    1000 + place as u64
}

/// Of rays at a subject those that hit it and those that miss it, as exact arithmetic tells; each `None` where there
/// are too few. A benign ray never misses: there the misses are the same rays moved aside.
pub fn apart<S: Number>(subject: &Subject<S>, workload: Workload, rays: &[Ray<S>]) -> [Option<Vec<Ray<S>>>; 2] {
    let (hits, mut misses): (Vec<_>, Vec<_>) = rays.iter().partition(|ray| is_hit(subject, ray));
    if workload == Workload::Benign {
        let mut random = Random(seed(workload));
        misses
            .extend(rays.iter().map(|ray| moved_aside(subject, ray, &mut random)).filter(|ray| !is_hit(subject, ray)));
    }
    [hits, misses].map(|rays| (rays.len() >= FEWEST).then_some(rays))
}

fn is_hit<S: Number>(subject: &Subject<S>, ray: &Ray<S>) -> bool {
    !expected(&subject.solid, ray).hits.is_empty()
}

/// The same ray, passing at a distance of one to three times the size of the subject. (Nothing passes a plane: it
/// stays.)
fn moved_aside<S: Number>(subject: &Subject<S>, ray: &Ray<S>, random: &mut Random) -> Ray<S> {
    if subject.name == "plane" {
        return Ray::new(ray.origin(), -ray.direction()).unwrap_or(*ray);
    }
    let across = random.perpendicular(ray.direction().to_array().map(raylet::Scalar::to_f64));
    let origin = add(ray.origin().to_f64(), scale(across, random.between(2.0, 4.0)));
    Vec3::from_f64(origin).ok().and_then(|origin| Ray::new(origin, ray.direction()).ok()).unwrap_or(*ray)
}
