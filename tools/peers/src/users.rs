//! What users do, beside `parry3d`: placed solids, near and far, and a range sensor, in `f32`.
//!
//! The queries are those of `docs/benches.md`. Both libraries place the solid themselves: parry's `cast_ray` moves the
//! ray into the solid's pose, raylet's shape does the same with its frame. Each query has a solid and a ray of its own.

use crate::contestant::Prepared;
use crate::names::{EXACT, FAST, PARRY, PLAIN, STABLE};
use crate::parry::placed::Posed;
use crate::speed::{Effort, Speed, race};
use raylet::Hit;
use raylet::tier::{Exact, Fast, Plain, Stable};
use shared::workload::{Placed, QUERIES, Query, Rays, SENSED, query, sensed};
use std::hint::black_box;

/// The solids that both libraries have.
const SOLIDS: [&str; 5] = ["sphere", "cylinder, capped", "cone, capped", "capsule", "triangle"];

/// The placements that parry has: nothing is stretched in it.
const PLACEMENTS: [Placed; 3] = [Placed::World, Placed::Moved, Placed::Turned];

/// A distance that is off by more than this is a wrong one. The solids are about as large as the unit ball.
pub const OFF: f32 = 1e-3;

/// One contestant on one workload.
#[derive(Clone, Debug)]
pub struct UserRow {
    /// The solid, or the sensor.
    pub what: String,
    /// How it is placed, and from where the rays come.
    pub rays: String,
    /// Who.
    pub contestant: &'static str,
    /// How many queries.
    pub queries: usize,
    /// Hits for misses, misses for hits, and distances off by more than [`OFF`], against `Exact`.
    pub wrong: usize,
    /// The time a query.
    pub speed: Speed,
}

/// Queries in a library's own types, and how one is answered.
struct Queries<Q, A> {
    queries: Vec<Q>,
    answer: fn(&Q) -> A,
    distance: fn(&A) -> Option<f32>,
}

impl<Q, A> Prepared<f32> for Queries<Q, A> {
    #[inline(never)]
    fn pass(&self) {
        for query in &self.queries {
            black_box((self.answer)(black_box(query)));
        }
    }

    fn distances(&self) -> Vec<Option<f32>> {
        self.queries.iter().map(|query| (self.distance)(&(self.answer)(query))).collect()
    }

    fn rays(&self) -> usize {
        self.queries.len()
    }
}

fn distance_of_hit(hit: &Option<Hit<f32>>) -> Option<f32> {
    hit.map(|hit| hit.t)
}

/// The contestants, in the order of the tables.
pub const NAMES: [&str; 5] = [PLAIN, FAST, STABLE, EXACT, PARRY];

fn prepare(queries: &[Query<f32>]) -> Option<[Box<dyn Prepared<f32>>; 5]> {
    let ours = |answer: fn(&Query<f32>) -> Option<Hit<f32>>| -> Box<dyn Prepared<f32>> {
        Box::new(Queries { queries: queries.to_vec(), answer, distance: distance_of_hit })
    };
    let theirs: Option<Vec<_>> = queries.iter().map(Posed::of).collect();
    Some([
        ours(|query| query.shape.nearest_at::<Plain>(&query.ray)),
        ours(|query| query.shape.nearest_at::<Fast>(&query.ray)),
        ours(|query| query.shape.nearest_at::<Stable>(&query.ray)),
        ours(|query| query.shape.nearest_at::<Exact>(&query.ray)),
        Box::new(Queries { queries: theirs?, answer: Posed::nearest, distance: |t| *t }),
    ])
}

fn wrong(of: &[Option<f32>], exact: &[Option<f32>]) -> usize {
    let is_wrong = |pair: &(&Option<f32>, &Option<f32>)| match pair {
        (Some(t), Some(exact)) => (t - exact).abs() > OFF,
        (None, None) => false,
        _ => true,
    };
    of.iter().zip(exact).filter(is_wrong).count()
}

/// The workloads: what, which rays, and the queries.
fn workloads() -> Vec<(String, String, Vec<Query<f32>>)> {
    let mut all = vec![];
    for solid in SOLIDS {
        for placed in PLACEMENTS {
            for rays in [Rays::Near, Rays::Far] {
                let queries = (0..QUERIES).filter_map(|index| query(solid, placed, rays, index)).collect();
                all.push((solid.into(), format!("{}, {}", placed.name(), rays.name()), queries));
            }
        }
    }
    // parry has no frustum; its six are left out for both.
    let sensed = (0..SENSED).filter_map(sensed).filter(|query| Posed::of(query).is_some()).collect();
    all.push(("range sensor".into(), "64 zones, 34 solids".into(), sensed));
    all
}

/// How often [`measure`] calls `tick`.
pub const TICKS: usize = SOLIDS.len() * PLACEMENTS.len() * 2 + 1;

/// All rows, those of one workload together.
///
/// # Panics
///
/// If a solid is among the workloads that parry does not have: an error of this program.
pub fn measure(effort: Effort, tick: &mut dyn FnMut()) -> Vec<UserRow> {
    let mut rows = vec![];
    for (what, rays, queries) in workloads() {
        let contestants = prepare(&queries).expect("parry has every solid that is chosen");
        let answers = contestants.each_ref().map(|contestant| contestant.distances());
        let [_, _, _, exact, _] = &answers;
        let speeds = race(&contestants, 2, effort.rounds);
        for ((contestant, answers), speed) in NAMES.into_iter().zip(&answers).zip(speeds) {
            let wrong = self::wrong(answers, exact);
            let (what, rays) = (what.clone(), rays.clone());
            rows.push(UserRow { what, rays, contestant, queries: queries.len(), wrong, speed });
        }
        tick();
    }
    rows
}
