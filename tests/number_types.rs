//! The promise: every number type agrees with exact arithmetic, within the bounds of this table.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod support;

use fixed::types::{I16F16, I32F32};
use support::exact_types::{Exact, expected, same_crossing, same_part};
use support::random::Random;
use support::subject::{SUBJECTS, Subject};
use support::workload::{WORKLOADS, Workload};

/// What was measured over one row.
#[derive(Default)]
struct Row {
    rays: usize,
    errors: Vec<f64>,
    lost: usize,
    phantom: usize,
    wrong_part: usize,
}

fn measure<S: Exact>(subject: &Subject<S>, workload: Workload, rays: usize, seed: u64) -> Option<Row> {
    let mut random = Random(seed);
    let mut row = Row::default();
    for _ in 0..rays {
        let Some(ray) = workload.ray(subject, &mut random) else { continue };
        row.rays += 1;
        let (want, got) = (expected(&subject.solid, &ray), subject.shape.hits(&ray));
        if want.hits.len() != got.len() {
            row.lost += want.hits.len().saturating_sub(got.len());
            row.phantom += got.len().saturating_sub(want.hits.len());
            continue;
        }
        for (want, got) in want.hits.iter().zip(&got) {
            let error = want.t.error_in(&got.t.exact(), &S::unit_at(&want.t));
            if !same_part(got.part, want.part) || !same_crossing(got.crossing, want.crossing) {
                row.wrong_part += 1;
            }
            row.errors.push(error);
        }
    }
    row.errors.sort_by(f64::total_cmp);
    (row.rays > 0).then_some(row)
}

fn table<S: Exact>(rays: usize) {
    println!("\n{}", S::name());
    println!(
        "{:18} {:22} {:>7} {:>9} {:>9} {:>10} {:>6} {:>6} {:>6}",
        "primitive", "workload", "hits", "median", "99.9%", "worst", "lost", "phantm", "part"
    );
    for name in SUBJECTS {
        let subject = Subject::<S>::new(name);
        for (index, workload) in WORKLOADS.into_iter().enumerate() {
            let Some(row) = measure(&subject, workload, rays, 1000 + index as u64) else { continue };
            let at = |fraction: f64| {
                if row.errors.is_empty() {
                    f64::NAN
                } else {
                    row.errors[((row.errors.len() - 1) as f64 * fraction) as usize]
                }
            };
            println!(
                "{:18} {:22} {:7} {:9.3} {:9.2} {:10.2} {:6} {:6} {:6}",
                name,
                workload.name(),
                row.errors.len(),
                at(0.5),
                at(0.999),
                at(1.0),
                row.lost,
                row.phantom,
                row.wrong_part
            );
        }
    }
}

#[test]
fn print_table() {
    table::<f32>(2000);
    table::<I16F16>(2000);
    table::<I32F32>(2000);
    table::<f64>(2000);
}
