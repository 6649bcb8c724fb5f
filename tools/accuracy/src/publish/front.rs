//! Tables of `docs/accuracy.md`: what to expect, and what it costs.

use super::markdown::{NONE, Table, row_ratios, short};
use super::readme;
use crate::chips::Chip;
use crate::study::Study;
use support::figures::{Figures, NUMBERS, TIERS};

/// A name, and whether a workload belongs to it.
pub type Kind = (&'static str, fn(&str) -> bool);

/// The kinds of workloads in the summary.
pub const KINDS: [Kind; 5] = [
    ("well aimed", |name| name == "benign" || name.ends_with(" away") || name == "inside" || name == "zero components"),
    ("grazing", |name| name.starts_with("grazing")),
    ("rims, near axis, generator or plane", |name| name == "rims" || name.contains(" off ")),
    ("on the surface", |name| name == "on the surface"),
    ("departing", |name| name.starts_with("departing")),
];

/// The rows of one tier and number type each.
pub fn groups(rows: &[Figures]) -> Vec<&[Figures]> {
    rows.chunk_by(|a, b| a.tier == b.tier && a.number == b.number).collect()
}

/// The largest median, 99.9 % and worst error of rows, and the sum of the wrong.
pub fn largest<'a>(rows: impl Iterator<Item = &'a Figures>) -> ([f64; 3], usize) {
    rows.fold(([0.0; 3], 0), |(errors, wrong), row| {
        ([0, 1, 2].map(|i| f64::max(errors[i], row.errors[i])), wrong + row.wrong())
    })
}

/// Per tier and number type: what to expect.
pub fn summary(study: &Study) -> String {
    let mut table = Table::new(&["tier", "number"].into_iter().chain(KINDS.map(|kind| kind.0)).collect::<Vec<_>>(), 7);
    for group in groups(&study.rows) {
        let mut cells = vec![group[0].tier.to_string(), format!("`{}`", group[0].number)];
        for (_, belongs) in KINDS {
            let of = group.iter().filter(|row| row.is_unplaced() && belongs(&row.workload));
            let (([median, _, worst], wrong), any) = (largest(of.clone()), of.count() > 0);
            let told = if wrong > 0 { format!("; {wrong} wrong") } else { String::new() };
            cells.push(if any { format!("{} / {}{told}", short(median), short(worst)) } else { NONE.into() });
        }
        table.row(&cells);
    }
    table.done()
}

/// The times of the benign rows of these primitives beside the instructions.
pub fn costs(study: &Study, primitives: &[&'static str]) -> String {
    let chips = study.chips.iter().map(|chip| chip.name);
    let titles: Vec<_> = ["primitive", "number", "tier", "host"].into_iter().chain(chips).collect();
    let mut table = Table::new(&titles, 3);
    for &primitive in primitives {
        for row in ordered(study, primitive) {
            let mut cells = vec![primitive.to_string(), format!("`{}`", row.number), row.tier.to_string()];
            cells.push(row_ratios(study, row));
            cells.extend(study.chips.iter().map(|chip: &Chip| super::markdown::instructions(chip, row)));
            table.row(&cells);
        }
    }
    table.done()
}

/// The benign rows of a primitive, number type by number type.
fn ordered<'a>(study: &'a Study, primitive: &'a str) -> impl Iterator<Item = &'a Figures> {
    let all = NUMBERS.iter().flat_map(|number| TIERS.iter().map(move |tier| (*number, *tier)));
    all.filter_map(move |(number, tier)| study.row(number, tier, primitive, "benign"))
}

/// Of a million rays at all primitives, how many the doubles of the exact tier cannot decide, so that integers decide.
pub fn integers(study: &Study) -> String {
    const SHOWN: [(&str, bool); 4] = [("f32", true), ("f32", false), ("I16F16", true), ("I16F16", false)];
    let mut table = Table::new(&["workload", "`f32`", "`f32`, placed", "`I16F16`", "`I16F16`, placed"], 1);
    let exact: Vec<_> = study.rows.iter().filter(|row| row.tier == "Exact").collect();
    let mut workloads: Vec<&str> = vec![];
    for row in &exact {
        if !workloads.contains(&row.workload.as_str()) {
            workloads.push(&row.workload);
        }
    }
    for workload in workloads {
        let mut cells = vec![workload.to_string()];
        for (number, is_unplaced) in SHOWN {
            let is_of =
                |row: &&&Figures| row.number == number && row.workload == workload && row.is_unplaced() == is_unplaced;
            let of: Vec<_> = exact.iter().filter(is_of).collect();
            let decided: usize = of.iter().map(|row| row.counts[4]).sum();
            // A row has as many rays, whatever of them fits the type.
            let rays = of.len() * if is_unplaced { study.rays.unplaced } else { study.rays.placed };
            cells.push(if of.is_empty() { NONE.into() } else { format!("{:.0}", 1e6 * decided as f64 / rays as f64) });
        }
        table.row(&cells);
    }
    table.done()
}

/// What is printed at the end of a run.
pub fn printed(study: &Study) -> String {
    format!(
        "Errors of t in units in the last place, the largest of all primitives, median / worst:\n\n{}\
         A sphere in a frame, benign: 99.9 % error as a length; times as a ratio to the textbook's in f32 ({} ns), \
         instructions; hit / miss:\n\n{}",
        summary(study),
        study.times.reference_nanoseconds,
        readme::costs(study)
    )
}
