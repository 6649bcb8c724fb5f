//! The figures as Markdown: `docs/accuracy.md`, and the few rows that the README shows.

use super::measure::Figures;
use std::fmt::Write;

/// What stands above the tables.
const HEAD: &str = "\
# Accuracy

How wrong is each tier in each number type? Written by `cargo run --release --example accuracy -- --write` (`--json` prints the same as JSON);
`tests/number_types.rs` holds the library to it: the test fails if a figure is exceeded, or if one is more than 5% too large.

Every row is 2,000 seeded rays at one primitive. The reference is exact arithmetic on the very bits that the library
received. *Median*, *99.9%* and *worst* are errors of `t` in units in the last place: of a float's spacing at `t`, or of the fixed type's
unit; an answer rounded correctly is off by at most .5. *Lost* are hits of exact arithmetic that are missing, *phantom* hits that it
does not have, *edge* hits within one unit of the ray's start on the wrong side of it, *part* hits on another part
or with another crossing.

";

/// What the workloads are.
const WORKLOADS: &str = "\
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

";

fn short(value: f64) -> String {
    if value < 10.0 { format!("{value:.2}") } else { format!("{value:.0}") }
}

fn is_grazing(workload: &str) -> bool {
    workload.starts_with("grazing") || workload == "on the surface"
}

/// Per tier and number type: what to expect.
fn summary(rows: &[Figures]) -> String {
    let mut text = String::from(
        "| tier | number | median, largest | worst away from grazing | wrong away from grazing | worst grazing or on the surface | wrong there |\n|---|---|---|---|---|---|---|\n",
    );
    for group in groups(rows) {
        let first = &group[0];
        let figures = |grazing: bool| {
            let of: Vec<_> = group.iter().filter(|row| is_grazing(&row.workload) == grazing).collect();
            let worst = of.iter().map(|row| row.errors[2]).fold(0.0, f64::max);
            let wrong: usize = of.iter().map(|row| row.counts[0] + row.counts[1]).sum();
            let hits: usize = of.iter().map(|row| row.hits).sum();
            (short(worst), format!("{wrong} of {hits}"))
        };
        let median = group.iter().map(|row| row.errors[0]).fold(0.0, f64::max);
        let ((worst, wrong), (worst_grazing, wrong_grazing)) = (figures(false), figures(true));
        writeln!(
            text,
            "| {} | `{}` | {} | {worst} | {wrong} | {worst_grazing} | {wrong_grazing} |",
            first.tier,
            first.number,
            short(median)
        )
        .expect("a string takes everything");
    }
    text
}

/// The rows of one tier and number type each.
fn groups(rows: &[Figures]) -> Vec<&[Figures]> {
    rows.chunk_by(|a, b| a.tier == b.tier && a.number == b.number).collect()
}

/// The whole document.
pub fn document(rows: &[Figures]) -> String {
    let mut text = format!("{HEAD}{}\n{WORKLOADS}", summary(rows));
    for group in groups(rows) {
        let first = &group[0];
        writeln!(
            text,
            "<details><summary>{}, <code>{}</code></summary>\n\n| primitive | workload | hits | median | 99.9% | worst | lost | phantom | edge | part |\n|---|---|---|---|---|---|---|---|---|---|",
            first.tier, first.number
        )
        .expect("a string takes everything");
        for Figures {
            primitive,
            workload,
            hits,
            errors: [median, most, worst],
            counts: [lost, phantom, edge, part],
            ..
        } in group
        {
            let [median, most, worst] = [median, most, worst].map(|value| short(*value));
            writeln!(
                text,
                "| {primitive} | {workload} | {hits} | {median} | {most} | {worst} | {lost} | {phantom} | {edge} | {part} |"
            )
            .expect("a string takes everything");
        }
        text.push_str("\n</details>\n\n");
    }
    text
}

/// The README with its table written anew; `None` if it has no place for one.
pub fn in_readme(readme: &str, rows: &[Figures]) -> Option<String> {
    const HEADER: &str = "|---|---|---|---|---|---|---|\n";
    let start = readme.find(HEADER)? + HEADER.len();
    let end = readme.find("<!-- /bounds -->")?;
    let mut lines = String::new();
    for primitive in ["sphere", "cylinder capped", "cone capped"] {
        for workload in ["benign", "10000 away", "grazing 1e-4", "grazing 1e-7"] {
            write!(lines, "| {primitive} | {workload} |").ok()?;
            for (tier, number) in
                [("Fast", "f32"), ("Stable", "f32"), ("Exact", "f32"), ("Stable", "I16F16"), ("Exact", "I16F16")]
            {
                let row = rows.iter().find(|row| {
                    row.tier == tier && row.number == number && row.primitive == primitive && row.workload == workload
                })?;
                let wrong = row.counts[0] + row.counts[1];
                let told = if wrong > 0 { format!(" ({wrong})") } else { String::new() };
                write!(lines, " {} / {}{told} |", short(row.errors[0]), short(row.errors[2])).ok()?;
            }
            lines.push('\n');
        }
    }
    Some(format!("{}{lines}{}", &readme[..start], &readme[end..]))
}
