//! How long every query takes on this machine.
//!
//! ```sh
//! cargo bench -p raylet-counting                                        # everything
//! cargo bench -p raylet-counting -- nearest                             # one query
//! cargo bench -p raylet-counting -- 'nearest.*sphere.*f32.*Stable'      # a regular expression over what is printed
//! cargo bench -p raylet-counting -- scene                               # cost against work: 1 to 256 spheres
//! ```
//!
//! A sample has 64 rays; the figures are for all of them together, and below in millions of queries a second.
//! Instructions, which do not depend on how busy the machine is, are counted by `.ci/instructions`.

mod cost;

use divan::Bencher;
use divan::counter::ItemsCount;

use cost::{Case, QUERIES};
use std::fmt;

fn main() {
    divan::main();
}

/// A case as divan lists it: the query is in the name of the benchmark.
struct Listed(Case);

impl fmt::Display for Listed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = &self.0.name;
        write!(f, "{}, {}, {}, {}", name.subject, name.number, name.tier, name.rays)
    }
}

fn measure(bencher: Bencher<'_, '_>, Listed(case): &Listed) {
    bencher.counter(ItemsCount::new(QUERIES)).bench_local(|| case.run());
}

/// A benchmark a query, with a row for every primitive, number type, tier and kind of rays.
macro_rules! queries {
    ($($name:ident = $query:literal;)+) => {
        $(
            #[divan::bench(args = primitives($query))]
            fn $name(bencher: Bencher<'_, '_>, case: &Listed) {
                measure(bencher, case);
            }
        )+
    };
}
queries! {
    all_hits = "all hits";
    nearest = "nearest";
    occlusion = "occlusion";
    normal = "normal";
    uv = "uv";
}

fn primitives(query: &'static str) -> impl Iterator<Item = Listed> {
    let formulas = cost::of_textbook().into_iter().filter(move |case| case.name.query == query);
    cost::of_primitives::<true>(&|name| name.query == query).into_iter().chain(formulas).map(Listed)
}

/// Cost against work.
#[divan::bench_group]
mod scene {
    use super::{Bencher, Listed, cost, measure};

    fn scenes(query: &'static str) -> impl Iterator<Item = Listed> {
        cost::of_scenes().into_iter().filter(move |case| case.name.query == query).map(Listed)
    }

    #[divan::bench(args = scenes("nearest"))]
    fn nearest(bencher: Bencher<'_, '_>, case: &Listed) {
        measure(bencher, case);
    }

    #[divan::bench(args = scenes("occlusion"))]
    fn occlusion(bencher: Bencher<'_, '_>, case: &Listed) {
        measure(bencher, case);
    }
}
