//! Of a workload's rays those that hit, and others that miss.

use raylet::scalar::UnitScalar;
use raylet::{Ray, Shape, UnitVec3};
use support::exact_types::Exact;
use support::figures;
use support::placed::{Placed, Placing};
use support::random::{Random, add, normalize, scale};
use support::subject::Subject;
use support::textbook::{self, Place, Plain};
use support::workload::Workload;

/// Rays of each kind.
pub const RAYS: usize = 64;

/// So many rays are drawn to find them.
const DRAWS: usize = 2_000;

/// A row's workload.
#[derive(Clone, Copy)]
pub enum Kind {
    Unplaced(Workload),
    /// Benign rays at solids that are placed so.
    Placed(Placing),
}

impl Kind {
    pub fn name(self) -> String {
        match self {
            Self::Unplaced(workload) => workload.name(),
            Self::Placed(placing) => figures::name(&Workload::Benign.name(), &placing.name()),
        }
    }
}

/// A ray and what it is to meet.
#[derive(Clone, Copy)]
pub struct Query<S: Plain> {
    pub shape: Shape<S>,
    pub place: Option<Place<S::Number>>,
    pub ray: Ray<S>,
}

fn draw<S: Plain + Exact>(subject: &Subject<S>, kind: Kind, random: &mut Random) -> Option<Query<S>> {
    match kind {
        Kind::Unplaced(workload) => {
            Some(Query { shape: subject.shape, place: None, ray: workload.ray(subject, random)? })
        }
        Kind::Placed(placing) => {
            let placed = Placed::new(subject, placing, random)?;
            Some(Query {
                shape: placed.shape,
                place: Some(textbook::place(&placed)),
                ray: placed.ray(subject, Workload::Benign, random)?,
            })
        }
    }
}

/// From the same origin past the solid, by up to a few times its size; `None` if that hits.
fn past<S: Plain + Exact>(query: &Query<S>, random: &mut Random) -> Option<Query<S>> {
    let origin = query.ray.origin().to_f64();
    // A ray that hits is aimed at the solid: a little beside where it hits is past it.
    let hit = query.shape.nearest(&query.ray)?;
    let target = add(origin, scale(query.ray.direction().to_f64(), hit.t.to_f64()));
    let beside = add(target, scale(random.direction(), random.between(1.0, 4.0)));
    let direction = normalize(add(beside, scale(origin, -1.0))).map(S::Unit::from_f64);
    let ray = Ray::new(query.ray.origin(), UnitVec3::from_components(direction).ok()?).ok()?;
    (!query.shape.occludes(&ray)).then_some(Query { ray, ..*query })
}

/// Rays that hit, and rays that miss: the workload's own, and where it has too few misses, others past the solid from
/// the same origins. None where there are too few of a kind.
pub fn queries<S: Plain + Exact>(subject: &Subject<S>, kind: Kind, seed: u64) -> [Vec<Query<S>>; 2] {
    let mut random = Random(seed);
    let [mut hits, mut misses] = [vec![], vec![]];
    for _ in 0..DRAWS {
        if hits.len() == RAYS && misses.len() == RAYS {
            break;
        }
        let Some(query) = draw(subject, kind, &mut random) else { continue };
        let to = if query.shape.occludes(&query.ray) { &mut hits } else { &mut misses };
        if to.len() < RAYS {
            to.push(query);
        }
        // The workloads that are aimed at the solid have no misses of their own.
        if misses.len() < RAYS
            && misses.len() < hits.len()
            && let Some(query) = hits.last().and_then(|hit| past(hit, &mut random))
        {
            misses.push(query);
        }
    }
    [hits, misses].map(|queries| if queries.len() < RAYS { vec![] } else { queries })
}
