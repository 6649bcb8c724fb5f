//! `docs/accuracy.md`: what to expect, the plots, and what the figures need a word for. All rows stand on pages of their own.

use super::markdown::{NONE, Table, page, row_ratios, short};
use super::{findings, plots, readme};
use crate::chips::Chip;
use crate::study::Study;
use std::fmt::Write;
use support::figures::{Figures, NUMBERS};

fn head(study: &Study) -> String {
    format!(
        "\
# Accuracy, and what it costs

How wrong is each tier in each number type, and how long does it take? Written by `cargo run --release -p raylet-accuracy -- --write`
(`--json` prints all of it); `tests/promises/src/number_types.rs` holds the library to the errors: in `.ci/long` the test fails if a figure is exceeded, or if
one is more than 5% too large; in its quick form, if one of the first 200 rays of a row is worse than its worst. [Which one do I take?](which-one.md) puts it into advice.

Every row is {} seeded rays at one primitive, of size about 1. The reference is exact arithmetic on the very bits that the library
received. *Median*, *99.9%* and *worst* are errors of `t` in units in the last place: of a float's spacing at `t`, or of the fixed type's
unit; an answer rounded correctly is off by at most .5. *Length* is the same error as a length. *Lost* are hits of exact arithmetic that are
missing, *phantom* hits that it does not have (both together: *wrong*), *edge* hits within one unit of the ray's start on the wrong side of
it, *part* hits on another part or with another crossing. Errors are the same on every machine and in every run.

Times are those of a nearest hit on one machine ({}), as a ratio to the textbook's sphere in `f32` that hits ({} ns), which is timed
before each short batch; the median of several rounds; hit / miss. Misses are the workload's own, and where it is aimed at the solid, rays from
the same origins past it. They vary by a tenth between runs, and nothing is decided by them. Instructions are those of
[microcontrollers.md](microcontrollers.md): hit / miss, of rays from 2 to 6 away, like *benign*; where they stand beside another workload
(in brackets, and in the plots) its rays may take more.

*Textbook* is `k^2 - a c` as everyone writes it first, in the operators of the number type: for fixed point those of the crate `fixed`,
which wrap. It tells `t` alone.

All rows: {}.

",
        raylet_tables::grouped(study.rays as u64),
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
| on the surface | from a point of the side, rounded to the type: one `t` is next to nothing |
| off the axis | nearly parallel to the axis |
| off a generator | nearly parallel to a generator of a cone: a hit may be very far away |
| rims | within a thousandth of a rim, a seam or the apex |
| zero components | directions with one or two zero components |
| framed within 4 or 1000 | as benign, the solid turned anyhow and that far from the world's origin |
| stretched by 1/f to f | as benign, each axis of such a frame (nearby) stretched by a factor of its own between these |

";

/// A name, and whether a workload belongs to it.
type Kind = (&'static str, fn(&str) -> bool);

/// The kinds of workloads in the summary.
const KINDS: [Kind; 4] = [
    ("well aimed", |name| name == "benign" || name.ends_with(" away") || name == "inside" || name == "zero components"),
    ("grazing", |name| name.starts_with("grazing")),
    ("rims, near axis or generator", |name| name == "rims" || name.contains(" off ")),
    ("on the surface", |name| name == "on the surface"),
];

/// The rows of one tier and number type each.
fn groups(rows: &[Figures]) -> Vec<&[Figures]> {
    rows.chunk_by(|a, b| a.tier == b.tier && a.number == b.number).collect()
}

/// The largest median, 99.9 % and worst error of rows, and the sum of the wrong.
fn largest<'a>(rows: impl Iterator<Item = &'a Figures>) -> ([f64; 3], usize) {
    rows.fold(([0.0; 3], 0), |(errors, wrong), row| {
        ([0, 1, 2].map(|i| f64::max(errors[i], row.errors[i])), wrong + row.wrong())
    })
}

/// Per tier and number type: what to expect.
pub fn summary(study: &Study) -> String {
    let mut table = Table::new(&["tier", "number"].into_iter().chain(KINDS.map(|kind| kind.0)).collect::<Vec<_>>(), 6);
    for group in groups(&study.rows) {
        let mut cells = vec![group[0].tier.to_string(), format!("`{}`", group[0].number)];
        for (_, belongs) in KINDS {
            let ([median, _, worst], wrong) = largest(group.iter().filter(|row| belongs(&row.workload)));
            let told = if wrong > 0 { format!("; {wrong} wrong") } else { String::new() };
            cells.push(format!("{} / {}{told}", short(median), short(worst)));
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

/// The closed solids, whose `t` is well-conditioned.
const CLOSED: [&str; 5] = ["sphere", "cylinder capped", "capsule", "cone capped", "frustum capped"];

/// What is said of placed solids.
const PLACED: &str = "\
## Placed solids

The largest of five closed solids (sphere, capped cylinder, capsule, capped cone, capped frustum), median / 99.9% / worst, for
rays at a point well inside. *Not placed* is the share of the solve alone. What `Exact` is left with is the share of what the
placement stores: a frame is taken at its word, so nothing; a stretched placement stores a rounded inverse. What the other tiers have more
than both is that their fast path takes the ray into the frame in the type's own width: some units for floats; for fixed point next to nothing,
for the local line has bits to spare. What the fast path leaves open goes into the frame without rounding.

";

/// Per tier and number type, what placing costs.
fn placed(study: &Study) -> String {
    let mut workloads: Vec<&str> = vec!["benign"];
    let placings = study.workloads("f32", "sphere").into_iter();
    workloads.extend(placings.filter(|name| name.starts_with("framed") || name.starts_with("stretched")));
    let titles = ["tier", "number", "not placed"].into_iter().chain(workloads[1..].iter().copied());
    let mut table = Table::new(&titles.collect::<Vec<_>>(), 2 + workloads.len());
    for group in groups(&study.rows) {
        let mut cells = vec![group[0].tier.to_string(), format!("`{}`", group[0].number)];
        for workload in &workloads {
            let of = group.iter().filter(|row| row.workload == **workload && CLOSED.contains(&row.primitive));
            let (errors, wrong) = largest(of);
            let told = if wrong > 0 { format!(" ({wrong} wrong)") } else { String::new() };
            cells.push(format!("{}{told}", errors.map(short).join(" / ")));
        }
        table.row(&cells);
    }
    table.done()
}

/// What is said of the exact tier's integers.
const INTEGERS: &str = "\
## How often integers decide

Rays of a million that the filter of the `Exact` tier cannot decide, so that integers do, over all 16 primitives:

";

/// Per workload, how often the exact tier needs its integers.
fn integers(study: &Study) -> String {
    let mut table = Table::new(&["workload", "`f32`", "`I16F16`"], 3);
    let mut workloads: Vec<&str> = vec![];
    for row in study.rows.iter().filter(|row| row.tier == "Exact") {
        if !workloads.contains(&row.workload.as_str()) {
            workloads.push(&row.workload);
        }
    }
    for workload in workloads {
        let mut cells = vec![workload.to_string()];
        for number in ["f32", "I16F16"] {
            let is_of = |row: &&Figures| row.tier == "Exact" && row.number == number && row.workload == workload;
            let of: Vec<_> = study.rows.iter().filter(is_of).collect();
            let decided: usize = of.iter().map(|row| row.counts[4]).sum();
            // A row has as many rays, whatever of them fits the type.
            let share = 1e6 * decided as f64 / (of.len() * study.rays) as f64;
            cells.push(if of.is_empty() { NONE.into() } else { format!("{share:.0}") });
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
         One point a number type and tier, one panel a workload. The line is the front of those that nothing beats in both. Sphere, on the host:\n\n\
         ![Error against time, sphere]({})\n\nThe same of other primitives, and against instructions on each chip:\n\n",
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
        rows => format!("**{rows} of them are not explained.**"),
    };
    let mut text = head(study);
    let _ = write!(
        text,
        "## What to expect\n\nThe largest error of all 16 primitives in units in the last place, median / worst, and how many hits of some 10,000 to \
         400,000 are wrong:\n\n{}## What it costs\n\nA benign nearest hit, hit / miss: time on the host, instructions on the chips.\n\n{}{}\
         ## Faster and more accurate\n\nRows (of hits and of misses) in which one tier is both more accurate (99.9 % error, and no more wrong hits or misses) \
         and cheaper than another of the same number type; in brackets the smallest ratio of their costs. On the host a time counts as \
         shorter below nine tenths. {told}\n\n{faster}\
         ## Beaten by another\n\nThe share of rows in which another combination, of any number type, costs no more and is no more wrong as a length, and is better \
         in one of them. A number type that cannot hold a row's rays does not beat there. On the chips, the instructions of benign rays \
         stand for those of every workload.\n\n{}{WORKLOADS}{PLACED}{}{INTEGERS}{}",
        summary(study),
        costs(study),
        pictures(study),
        findings::dominated_everywhere(study),
        placed(study),
        integers(study)
    );
    text.trim_end().to_string() + "\n"
}

/// What is printed at the end of a run.
pub fn printed(study: &Study) -> String {
    format!(
        "Errors of t in units in the last place, the largest of all primitives, median / worst:\n\n{}\
         A sphere, benign: 99.9 % error as a length; times as a ratio to the textbook's in f32 ({} ns), instructions; hit / miss:\n\n{}",
        summary(study),
        study.times.reference_nanoseconds,
        readme::costs(study)
    )
}
