//! `docs/accuracy.md`: what to expect, the plots, and explanations of unexpected rows. The rows are on pages of their
//! own.

use super::markdown::{NONE, Table, page, row_ratios, short};
use super::{findings, placed, plots, readme};
use crate::chips::Chip;
use crate::study::Study;
use std::fmt::Write;
use support::bounds;
use support::figures::{Figures, NUMBERS};

fn head(study: &Study) -> String {
    format!(
        "\
# Accuracy, and what it costs

How large are the errors of each tier in each number type, and how long does a query take? [Which one do I take?](which-one.md) gives the advice that follows.
[Your own rays](your-rays.md) says how to measure other rays and other solids.

`cargo run --release -p raylet-accuracy -- --write` writes this page; `--json` prints all its figures. `tests/promises/src/number_types.rs` compares the library with the errors.
In `.ci/long` the test fails if a figure is exceeded, or if one is more than 5 % too large. Its quick form fails if one of the first {} rays of a row (placed: {}) is worse than the worst of the row.

Every row is {} seeded rays at one primitive of size about 1; at a placed one {}, each with a placement of its own. The reference is
exact arithmetic on the bits that the library received.

- *Median*, *99.9%* and *worst* are errors of `t` in units in the last place: of a float's spacing at `t`, or of the fixed type's unit. An answer that is rounded correctly is off
  by at most .5. If a hit is nearer to the ray's start than a thousandth of the size, the unit is the spacing at the size, except in `Exact`. *Length* is the same error as a length.
- *Lost* hits are those of exact arithmetic that are missing; *phantom* hits are those that exact arithmetic does not have. *Wrong* counts both.
- *Edge* hits are within one unit of the ray's start, on the wrong side of it; if the ray starts on a surface, hits of that surface itself.
- *Part* hits are on another part or have another crossing. *Broken* rays are those for which the tier does not keep its promise.

Errors are the same on every machine and in every run.

Times are those of a nearest hit on one machine ({}): hit / miss, as a ratio to the textbook's sphere in `f32` that hits ({} ns), which is timed
before each short batch. Each is the median of several rounds. The misses are those of the workload; if all its rays are aimed at the solid, they are rays from
the same origins that pass it. Times vary by a tenth between runs; no advice depends on them alone. Instructions are those of
[microcontrollers.md](microcontrollers.md): hit / miss, of rays from 2 to 6 away, which are like *benign*. In brackets, beside another
workload, they are those of the same benign rays, and the workload's own rays may take more. The plots of chips show each workload at its own cost, the mean of a query.

*Textbook* is the formula `k^2 - a c` of most textbooks in the operators of the number type; for fixed point these are the wrapping operators of the crate `fixed`.
It computes `t` and nothing else.

The rows that are timed: {}. All rows: [data/bounds](../data/bounds).

",
        bounds::QUICK.unplaced,
        bounds::QUICK.placed,
        raylet_tables::grouped(study.rays.unplaced as u64),
        study.rays.placed,
        study.times.machine,
        study.times.reference_nanoseconds,
        NUMBERS.map(|number| format!("[`{number}`]({})", page(number))).join(", ")
    )
}

/// What the workloads are.
const WORKLOADS: &str = "\
## The workloads

| workload | rays |
|---|---|
| benign | from 3 to 8 away, at a point well inside |
| 100 to 1000000 away | from that far, at a point well inside; the solid's size is about 1 |
| grazing 1e-1 to 1e-7 | past the side, by one or two times that fraction inside or outside of touching |
| inside | from a point inside |
| on the surface | from a point of the side, rounded to the type: one `t` is close to 0 |
| off the axis | nearly parallel to the axis |
| off a generator | nearly parallel to a generator of a cone: a hit may be very far away |
| off a plane | at that angle to the plane of a flat primitive or of a cap, aimed at a point of it |
| rims | within a thousandth of a rim, a seam or the apex |
| zero components | directions with one or two zero components |
| departing | from a hit, inwards or outwards, as a departing ray; every fourth is nearly parallel to the surface. The reference treats the start as a point of the surface |
| moved | at the solid in a frame that only moves it: half of the frames within 4 of the world's origin, the others within 1,000 and 1,000,000, or as far as the type reaches |
| turned | at the solid in such a frame with a random rotation |
| stretched by 1/f to f | each axis of such a frame stretched by a factor of its own between these |

";

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

/// The times of few rows beside the instructions.
fn costs(study: &Study) -> String {
    let chips = study.chips.iter().map(|chip| chip.name);
    let titles: Vec<_> = ["primitive", "number", "tier", "host"].into_iter().chain(chips).collect();
    let mut table = Table::new(&titles, 3);
    for primitive in plots::COMPARED {
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
    use support::figures::TIERS;
    let all = NUMBERS.iter().flat_map(|number| TIERS.iter().map(move |tier| (*number, *tier)));
    all.filter_map(move |(number, tier)| study.row(number, tier, primitive, "benign"))
}

/// What is said of the exact tier's integers.
const INTEGERS: &str = "\
## How often integers decide

Of a million rays, how many the doubles of the `Exact` tier cannot decide, so that integers decide them; over all 16 primitives:

";

/// Per workload, how often the exact tier needs its integers.
fn integers(study: &Study) -> String {
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

/// The plots, and where the others are.
fn pictures(study: &Study) -> String {
    // From docs/.
    let at = |path: String| path.trim_start_matches("docs/").to_string();
    let mut text = format!(
        "## Error against distance and grazing\n\n\
         ![Error against distance, a line a tier]({})\n\n![Error against grazing, a line a tier]({})\n\n\
         ## Error against cost\n\n\
         Each number type and tier is a point, each workload a panel. The line connects the points that no other point beats in both error and cost. Sphere, on the host:\n\n\
         ![Error against time, sphere]({})\n\nThe same for other primitives, and against instructions on each chip:\n\n",
        at(plots::sweep_path("distance")),
        at(plots::sweep_path("grazing")),
        at(plots::cost_path(None, "sphere"))
    );
    let machines = std::iter::once(None).chain(study.chips.iter().map(|chip| Some(chip.name)));
    let titles = std::iter::once("").chain(plots::COMPARED);
    let mut table = Table::new(&titles.collect::<Vec<_>>(), 4);
    for machine in machines {
        let links = plots::COMPARED.map(|primitive| format!("[plot]({})", at(plots::cost_path(machine, primitive))));
        table.row(&[vec![machine.unwrap_or("host").to_string()], links.to_vec()].concat());
    }
    text.push_str(&table.done());
    text
}

/// The whole page.
pub fn document(study: &Study) -> String {
    let (faster, unexplained) = findings::faster_and_more_accurate(study);
    let told = match unexplained {
        0 => "All of them are explained below the table.".to_string(),
        1 => "**One of them is not explained.**".to_string(),
        rows => format!("**{rows} of them are not explained.**"),
    };
    let mut text = head(study);
    let _ = write!(
        text,
        "## What to expect\n\nThe largest error of all 16 primitives in units in the last place, median / worst, and how many of some 10,000 to \
         400,000 hits are wrong:\n\n{}## What it costs\n\nThe nearest hit of benign rays, hit / miss: time on the host, instructions on the chips.\n\n{}{}\
         ## Faster and more accurate\n\nThe number of rows in which one tier is both more accurate (99.9 % error, and no more wrong hits or misses) \
         and cheaper than another of the same number type; hits and misses count as two rows. In brackets is the smallest ratio of their costs. On the host a time counts as \
         shorter if it is below nine tenths of the other. {told}\n\n{faster}\
         ## Beaten by another\n\nThe share of rows in which another combination of number type and tier costs no more, has no larger error as a length and no more wrong hits, and is better \
         in one of them. A number type that cannot hold a row's rays is not compared in that row. On the chips, the instructions of benign rays \
         are used for every workload.\n\n{}{WORKLOADS}{}{INTEGERS}{}",
        summary(study),
        costs(study),
        pictures(study),
        findings::dominated_everywhere(study),
        placed::section(study),
        integers(study)
    );
    text.trim_end().to_string() + "\n"
}

/// What is printed at the end of a run.
pub fn printed(study: &Study) -> String {
    format!(
        "Errors of t in units in the last place, the largest of all primitives, median / worst:\n\n{}\
         A sphere in a frame, benign: 99.9 % error as a length; times as a ratio to the textbook's in f32 ({} ns), instructions; hit / miss:\n\n{}",
        summary(study),
        study.times.reference_nanoseconds,
        readme::costs(study)
    )
}
