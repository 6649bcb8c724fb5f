//! What users do, query by query: the mean, the 99th of a hundred and the worst, and how many the first method of the
//! tier passes on.
//!
//! | module | what it holds |
//! |---|---|
//! | `grazing` | which rays graze a solid |
//! | `pictures` | the tests that the rays of pictures put to objects |

mod grazing;
mod pictures;

use fixed::types::{I8F24, I16F16, I20F12, I32F32};
pub use pictures::PICTURES;
use raylet::Scalar;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use shared::borrowed::Borrowed;
use shared::digest::Bits;
use shared::subject::query;
use shared::workload::{
    PLACEMENTS, Placed, QUERIES, Query, RAYS, Rays, SENSED, SENSED_EVERY, SOLIDS_BY_NAME, query, sensed,
};
use std::hint::black_box;

/// One row to be measured.
pub struct Workload {
    /// The query, in which number type and tier.
    pub name: String,
    /// How many queries.
    pub queries: usize,
    /// How far its answers are off, where the number type has exact ones.
    pub off: Option<Off>,
    run: Box<dyn Fn(usize) + Send + Sync>,
}

/// How far answers are off those of `Exact`, which are exact but for the rounding of `t`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Off {
    /// By how many units in the last place of `t` at most.
    pub units: u64,
    /// How many are hits for misses, misses for hits, or on another part.
    pub wrong: u64,
}

impl Off {
    fn of<S: Scalar + Bits, T: Tier<S>>(queries: &[Query<S>]) -> Self
    where
        Exact: Tier<S>,
    {
        let mut off = Self::default();
        for Query { shape, ray } in queries {
            match (shape.nearest_at::<T>(ray), shape.nearest_at::<Exact>(ray)) {
                // No t is negative, so that their bits are in their order.
                (Some(hit), Some(exact)) if (hit.part, hit.crossing) == (exact.part, exact.crossing) => {
                    off.units = off.units.max(hit.t.bits().abs_diff(exact.t.bits()));
                }
                (None, None) => {}
                _ => off.wrong += 1,
            }
        }
        off
    }
}

impl Workload {
    fn new<S: Scalar, T: Tier<S>>(of: &str, number: &str, tier: &str, queries: Vec<Query<S>>) -> Self {
        // The compiler must not know which function it is: it would make a copy of the call for each.
        let query = black_box(query::nearest::<S, T, raylet::Shape<S>> as fn(&_, &_));
        let count = queries.len();
        let run = move |index: usize| {
            let Query { shape, ray } = &queries[index];
            query(black_box(shape), black_box(ray));
        };
        Self { name: format!("{of} | {number} | {tier}"), queries: count, off: None, run: Box::new(run) }
    }

    /// The same of a number type that has exact answers.
    fn with_exact<S: Scalar + Bits, T: Tier<S>>(of: &str, number: &str, tier: &str, queries: Vec<Query<S>>) -> Self
    where
        Exact: Tier<S>,
    {
        let off = Some(Off::of::<S, T>(&queries));
        Self { off, ..Self::new::<S, T>(of, number, tier, queries) }
    }

    /// One query.
    #[inline]
    pub fn run(&self, index: usize) {
        (self.run)(index);
    }
}

/// What a workload of one solid is called.
pub fn of_solid(solid: &str, placed: Placed, rays: Rays) -> String {
    format!("{solid}, {}, {}", placed.name(), rays.name())
}

/// What the range sensor is called.
pub const RANGE_SENSOR: &str = "range sensor";

/// The queries of one number type, each kind with its name.
fn queries<S: Borrowed>() -> Vec<(String, Vec<Query<S>>)> {
    let mut all = vec![];
    for solid in SOLIDS_BY_NAME {
        for placed in PLACEMENTS {
            for rays in RAYS {
                let queries = (0..QUERIES).filter_map(|index| query(solid, placed, rays, index)).collect();
                all.push((of_solid(solid, placed, rays), queries));
            }
        }
    }
    all.push((RANGE_SENSOR.into(), (0..SENSED).step_by(SENSED_EVERY).filter_map(sensed).take(QUERIES).collect()));
    for (picture, tests) in pictures::tests_of_each() {
        all.push((picture.into(), tests));
    }
    all
}

/// How many rays away from grazing are counted of a solid and a placement: the second most expensive of them is the
/// 99.9 %.
const AWAY: usize = 1_000;

/// Arriving rays, near and far.
pub const ARRIVING: [Rays; 2] = [Rays::Near, Rays::Far];

/// The number types whose rays away from grazing are counted, in `Stable`.
pub const NUMBERS_AWAY: [&str; 4] = ["f32", "f64", "I16F16", "I32F32"];

/// A solid, as it is placed, and arriving rays that do not graze it.
struct Away {
    solid: &'static str,
    placed: Placed,
    rays: Rays,
    indices: Vec<usize>,
}

impl Away {
    fn new(solid: &'static str, placed: Placed, rays: Rays) -> Self {
        let is_away = |index: &usize| {
            query(solid, placed, rays, *index).is_some_and(|query| grazing::grazes(&query) == Some(false))
        };
        let indices: Vec<usize> = (0..100 * AWAY).filter(is_away).take(AWAY).collect();
        assert_eq!(
            indices.len(),
            AWAY,
            "{}: too few rays are known not to graze it (workloads/grazing.rs)",
            of_solid(solid, placed, rays)
        );
        Self { solid, placed, rays, indices }
    }

    /// The same rays in a number type.
    fn workload<S: Borrowed>(&self, number: &str) -> Workload {
        let Self { solid, placed, rays, ref indices } = *self;
        let queries = indices.iter().filter_map(|index| query(solid, placed, rays, *index)).collect();
        Workload::new::<S, Stable>(&of_solid(solid, placed, rays), number, "Stable", queries)
    }
}

/// Rays away from grazing, in each of [`NUMBERS_AWAY`], always in the same order.
pub fn away_from_grazing() -> Vec<Workload> {
    let of_solid = |solid| {
        let placed = move |placed| ARRIVING.map(|rays| Away::new(solid, placed, rays));
        PLACEMENTS.into_iter().flat_map(placed)
    };
    let in_each = |away: Away| {
        let [f32, f64, i16f16, i32f32] = NUMBERS_AWAY;
        let floats = [away.workload::<f32>(f32), away.workload::<f64>(f64)];
        floats.into_iter().chain([away.workload::<I16F16>(i16f16), away.workload::<I32F32>(i32f32)])
    };
    SOLIDS_BY_NAME.into_iter().flat_map(of_solid).flat_map(in_each).collect()
}

macro_rules! number {
    ($all:ident, $S:ty, $number:literal, $new:ident: $($T:ident)+) => {
        for (of, queries) in queries::<$S>() {
            $($all.push(Workload::$new::<$S, $T>(&of, $number, stringify!($T), queries.clone()));)+
        }
    };
}

/// Every workload in every number type and tier, always in the same order.
pub fn all() -> Vec<Workload> {
    let mut all = vec![];
    number!(all, f32, "f32", with_exact: Plain Fast Stable Exact);
    number!(all, I16F16, "I16F16", with_exact: Plain Fast Stable Exact);
    number!(all, f64, "f64", new: Stable);
    number!(all, I32F32, "I32F32", new: Stable);
    number!(all, I8F24, "I8F24", new: Stable);
    number!(all, I20F12, "I20F12", new: Stable);
    all
}
