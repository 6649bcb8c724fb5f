//! Instructions of what users do, query by query: solids as they are placed, rays from near and from far, departing
//! rays, a range sensor, pictures. The workloads are those of the crate `shared`, which the host is measured with too.

use crate::cost::measure::{MOST_ROUNDS, nothing, run};
use core::hint::black_box;
use core::slice;
use fixed::types::{I16F16, I32F32};
use heapless::Vec;
use raylet::shape::kinds::Combining;
use raylet::thick::ThickRay;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{Combination, Ray, Scalar, Shape, Size};
use raylet_firmware::clock;
use shared::borrowed::Borrowed;
use shared::milled::{self, Few};
use shared::pictured::{BUILT_IN, of_built_in};
use shared::returns::{self, Yard};
use shared::subject::query;
use shared::workload::{Placed, QUERIES, Query, Rays, SENSED, SENSED_EVERY, SOLIDS_BY_NAME, query, sensed};

/// A query is repeated until that took so many instructions: then the grain of the clock is one hundredth.
const ENOUGH: u64 = 100 * clock::GRAIN;

/// So many times a function is called that does nothing.
const LOOPS: u64 = 500;

/// Which solids and rays: of each solid.
const KINDS: [(Placed, Rays); 7] = [
    (Placed::World, Rays::Near),
    (Placed::World, Rays::Far),
    (Placed::Turned, Rays::Near),
    (Placed::Turned, Rays::Far),
    (Placed::Turned, Rays::Departing),
    (Placed::Stretched, Rays::Near),
    (Placed::Stretched, Rays::Far),
];

/// The figures of one workload.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    /// The solid, the range sensor, or the scene of a picture.
    pub of: &'a str,
    /// How a solid is placed, and where the rays begin; nothing for the others.
    pub kind: Option<(Placed, Rays)>,
    /// The number type.
    pub number: &'static str,
    /// The tier.
    pub tier: &'static str,
    /// Instructions a query in the mean, of the 99th of a hundred, and of the worst.
    pub instructions: [u64; 3],
}

/// Takes rows.
pub type Report<'a> = &'a mut dyn FnMut(Row<'_>);

type Queries<S> = Vec<Query<S>, QUERIES>;

/// Instructions of one query.
fn singly<P, I>(subject: &P, input: &I, query: fn(&P, &I)) -> u64 {
    let (inputs, nothing) = (slice::from_ref(input), black_box(nothing::<P, I> as fn(&_, &_)));
    let mut rounds = 1;
    let taken = loop {
        let taken = run(subject, inputs, query, rounds);
        if taken >= ENOUGH || rounds >= MOST_ROUNDS {
            break taken;
        }
        rounds *= 2;
    };
    // A function that does nothing takes less than the grain of the clock.
    let looping = run(subject, inputs, nothing, LOOPS);
    (taken.saturating_sub(looping * rounds / LOOPS) + rounds / 2) / rounds
}

#[inline(never)]
fn tier<S: Scalar, T: Tier<S>>(tests: &Queries<S>) -> [u64; 3] {
    // The compiler must not know which function it is: it would make a copy of the loop for each.
    let query = black_box((|shape, test| query::nearest::<S, T, _>(shape, &test.ray)) as fn(&Shape<S>, &Query<S>));
    spread(tests.iter().map(|test| singly(&test.shape, test, query)))
}

/// What many solids take: all crossings of a yard in order, beside the hits of each of its solids, for the rays of a
/// sensor; all hits of a combination of two solids, beside those of each, for the rays of a picture.
const MANY: [&str; 4] =
    ["crossings of forty solids", "hits of forty solids", "hits of a combination of two", "hits of its two solids"];

/// Figures in the order of [`MANY`].
#[inline(never)]
fn many<S: Scalar, T: Tier<S>>() -> [[u64; 3]; 4] {
    let crossings = |yard: &Yard<S>, ray: &Ray<S>| {
        // By reference, here and below: `black_box` copies what it is given.
        black_box(&returns::crossings::<S, T>(yard.as_slice(), ray));
    };
    let hits_of_each = |yard: &Yard<S>, ray: &Ray<S>| {
        for solid in yard {
            black_box(&solid.hits_at::<T>(ray));
        }
    };
    let yard = returns::yard();
    let [crossings, hits_of_each] = [crossings as fn(&_, &_), hits_of_each]
        .map(|query| spread(returns::rays().step_by(3).map(|ray| singly(&yard, &ray, black_box(query)))));
    let combined = |part: &Shape<S, Combining<'_, Few>>, ray: &Ray<S>| {
        black_box(&part.hits_at::<T>(ray));
    };
    let each = |leaves: &&[Shape<S, Few>], ray: &Ray<S>| {
        for leaf in *leaves {
            black_box(&leaf.hits_at::<T>(ray));
        }
    };
    let parts = milled::leaves::<S>().zip(milled::camera::<S>()).map(|(leaves, camera)| {
        // Plate and slot.
        let two = [leaves[0], leaves[4]];
        let view = camera.raster(Size::new(10, 10));
        let rays = || (0..100).filter_map(|pixel| view.ray([pixel % 10, pixel / 10], [0, 0]));
        let part = Combination::difference(&two).expect("two solids");
        [
            spread(rays().map(|ray| singly(&part.shape(), &ray, black_box(combined as fn(&_, &_))))),
            spread(rays().map(|ray| singly(&two.as_slice(), &ray, black_box(each as fn(&_, &_))))),
        ]
    });
    let [combined, each] = parts.unwrap_or_default();
    [crossings, hits_of_each, combined, each]
}

/// What a thick ray takes against solids that are turned, of rays from near: the name of the figure, and the solid.
const THICK: [(&str, &str); 7] = [
    ("a ball against a sphere", "sphere"),
    ("a ball against a capsule", "capsule"),
    ("a ball against a plane", "plane"),
    ("a ball against a cuboid", "cuboid"),
    ("a ball against a rounded cuboid", "rounded cuboid"),
    ("a ball against a rectangle", "rectangle"),
    ("a ball against a triangle", "triangle"),
];

/// The first contact of a ball of an eighth of the size of the solid.
#[inline(never)]
fn thick<S: Borrowed, T: Tier<S>>(solid: &str) -> [u64; 3] {
    let contact = |shape: &Shape<S>, ball: &ThickRay<S>| {
        black_box(&ball.contact_at::<T, _>(shape));
    };
    let radius = S::from_f64(0.125).unwrap_or(S::ZERO);
    let tests = (0..QUERIES).filter_map(|index| query::<S>(solid, Placed::Turned, Rays::Near, index));
    let tests = tests.filter_map(|Query { shape, ray }| Some((shape, ThickRay::new(ray, radius).ok()?)));
    spread(tests.map(|(shape, ball)| singly(&shape, &ball, black_box(contact as fn(&_, &_)))))
}

/// The mean of some counts, the 99th of a hundred, and the largest.
fn spread(counts: impl Iterator<Item = u64>) -> [u64; 3] {
    let mut counts: Vec<u64, QUERIES> = counts.take(QUERIES).collect();
    counts.sort_unstable();
    let count = counts.len().max(1);
    let mean = (counts.iter().sum::<u64>() + count as u64 / 2) / count as u64;
    let at = |rank: usize| counts.get(rank).copied().unwrap_or_default();
    [mean, at((count * 99).div_ceil(100) - 1), at(count - 1)]
}

/// Every workload in one number type.
macro_rules! number {
    ($report:expr, $S:ty, $number:literal: $($T:ident)+) => {{
        $(
            let rows = many::<$S, $T>();
            for (of, instructions) in MANY.into_iter().zip(rows) {
                $report(Row { of, kind: None, number: $number, tier: stringify!($T), instructions });
            }
        )+
        for (of, solid) in THICK {
            let instructions = thick::<$S, Stable>(solid);
            $report(Row { of, kind: None, number: $number, tier: "Stable", instructions });
        }
        let mut all = |of: &str, kind: Option<(Placed, Rays)>, tests: &Queries<$S>| {
            $($report(Row { of, kind, number: $number, tier: stringify!($T), instructions: tier::<$S, $T>(tests) });)+
        };
        all("range sensor", None, &(0..SENSED).step_by(SENSED_EVERY).filter_map(sensed).take(QUERIES).collect());
        for (scene, of) in BUILT_IN {
            all(of, None, &of_built_in(scene).unwrap_or_default());
        }
        for solid in SOLIDS_BY_NAME {
            for (placed, rays) in KINDS {
                let tests = (0..QUERIES).filter_map(|index| query(solid, placed, rays, index)).collect();
                all(solid, Some((placed, rays)), &tests);
            }
        }
    }};
}

/// Measures everything, always in the same order. The clock must have been started.
pub fn all(report: Report<'_>) {
    number!(report, f32, "f32": Plain Fast Stable Exact);
    number!(report, I16F16, "I16F16": Plain Fast Stable Exact);
    number!(report, I32F32, "I32F32": Stable);
    number!(report, f64, "f64": Stable);
}
