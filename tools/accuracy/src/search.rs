//! Searches for rays that break a tier's promise: from the worst random rays of each row uphill.

use std::error::Error;
use support::climb::{Effort, climb};
use support::figures::name;
use support::method::{Measurable, Method};
use support::placed::{Placing, UNPLACED};
use support::subject::{SUBJECTS, Subject};
use support::workload::{FURTHER, WORKLOADS};

use fixed::types::{I16F16, I32F32};

/// From the eight worst of 1,000 rays of each row.
const EFFORT: Effort = Effort { rays: 1_000, starts: 8, steps: 600 };

const PLACES: [Option<Placing>; 3] = [None, Some(Placing::Moved), Some(Placing::Turned)];

/// How often `tick` is called for each primitive of a number type.
pub const TICKS: usize = PLACES.len() * (WORKLOADS.len() + FURTHER.len());

/// Which rows are searched, by number type and primitive.
type Wanted<'a> = &'a dyn Fn(&str, &str) -> bool;

/// A ray that breaks a promise: by how much, and its row and bits.
type Found = (f64, String);

fn of_type<S: Measurable>(wanted: Wanted<'_>, found: &mut Vec<Found>, tick: &mut dyn FnMut()) {
    let methods: Vec<Method<S>> =
        S::methods().into_iter().filter(|method| ["Stable", "Exact"].contains(&method.tier)).collect();
    for primitive in SUBJECTS.into_iter().filter(|primitive| wanted(&S::name(), primitive)) {
        let subject = Subject::<S>::new(primitive);
        for (place, placing) in (0..).zip(PLACES) {
            for (index, workload) in (0..).zip(WORKLOADS.into_iter().chain(FURTHER)) {
                for method in &methods {
                    let seed = 7_000 + 1_000 * place + index;
                    if let Some((by, Some(broken))) = climb(method, &subject, (placing, workload), EFFORT, seed) {
                        let placed = placing.map_or(UNPLACED.into(), Placing::name);
                        let row = name(&workload.name(), &placed);
                        found.push((by, format!("{} {} {primitive}, {row}: {}", method.tier, S::name(), broken.told)));
                    }
                }
                tick();
            }
        }
    }
}

/// Prints them, worst first; an error if there are any.
pub fn report(wanted: Wanted<'_>, tick: &mut dyn FnMut()) -> Result<(), Box<dyn Error>> {
    let mut found = vec![];
    of_type::<f32>(wanted, &mut found, tick);
    of_type::<f64>(wanted, &mut found, tick);
    of_type::<I16F16>(wanted, &mut found, tick);
    of_type::<I32F32>(wanted, &mut found, tick);
    found.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    for (by, told) in &found {
        println!("{by:.2} of the limit: {told}");
    }
    if found.is_empty() { Ok(()) } else { Err(format!("{} rows have a ray that breaks a promise", found.len()).into()) }
}
