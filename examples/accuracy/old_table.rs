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

First the largest of all 16 primitives, median / worst, and how many hits of some 10,000 to 400,000 are lost or phantom:

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
| framed within 4 or 1000 | as benign, the solid turned anyhow and that far from the world's origin |
| stretched by 1/f to f | as benign, each axis of such a frame (nearby) stretched by a factor of its own between these |

";

fn short(value: f64) -> String {
    match value {
        0.0..10.0 => format!("{value:.2}"),
        10.0..1e5 => format!("{value:.0}"),
        _ => format!("{value:.0e}"),
    }
}

/// A name, and whether a workload belongs to it.
type Kind = (&'static str, fn(&str) -> bool);

/// The kinds of workloads in the summary.
const KINDS: [Kind; 4] = [
    ("well aimed", |name| name == "benign" || name.ends_with(" away") || name == "inside" || name == "zero components"),
    ("grazing", |name| name.starts_with("grazing")),
    ("rims, near axis or generator", |name| name == "rims" || name.contains(" off ")),
    ("on the surface", |name| name == "on the surface"),
];

/// Per tier and number type: what to expect.
fn summary(rows: &[Figures]) -> String {
    let mut text = String::from("| tier | number |");
    for (kind, _) in KINDS {
        write!(text, " {kind} |").expect("a string takes everything");
    }
    text.push_str("\n|---|---|---|---|---|---|\n");
    for group in groups(rows) {
        write!(text, "| {} | `{}` |", group[0].tier, group[0].number).expect("a string takes everything");
        for (_, belongs) in KINDS {
            let of: Vec<_> = group.iter().filter(|row| belongs(&row.workload)).collect();
            let [median, worst] = [0, 2].map(|i| short(of.iter().map(|row| row.errors[i]).fold(0.0, f64::max)));
            let wrong: usize = of.iter().map(|row| row.counts[0] + row.counts[1]).sum();
            let told = if wrong > 0 { format!("; {wrong} wrong") } else { String::new() };
            write!(text, " {median} / {worst}{told} |").expect("a string takes everything");
        }
        text.push('\n');
    }
    text
}

/// The rows of one tier and number type each.
fn groups(rows: &[Figures]) -> Vec<&[Figures]> {
    rows.chunk_by(|a, b| a.tier == b.tier && a.number == b.number).collect()
}

/// The closed solids, whose `t` is well-conditioned.
const CLOSED: [&str; 5] = ["sphere", "cylinder capped", "capsule", "cone capped", "frustum capped"];

/// What is said of placed solids.
const PLACED: &str = "\
## Placed solids

The largest of five closed solids (sphere, capped cylinder, capsule, capped cone, capped frustum), median / 99.9% / worst, for
rays at a point well inside. *Not placed* is the share of the solve alone. What `Exact` is left with is the share of what the
placement stores: a frame is taken at its word, so nothing; a stretched placement stores a rounded inverse. What the other tiers have more
than both is the rounding of the ray on its way into the solid's frame: for floats about half a unit in the median; for
fixed point next to nothing, since the local line is kept in the finest unit that fits, until factors of 1,000
against 1/1,000 leave a direction few bits across.

";

/// Per tier and number type, what placing costs.
fn placed(rows: &[Figures]) -> String {
    let mut workloads: Vec<&str> = vec!["benign"];
    for row in rows {
        if (row.workload.starts_with("framed") || row.workload.starts_with("stretched"))
            && !workloads.contains(&row.workload.as_str())
        {
            workloads.push(&row.workload);
        }
    }
    let mut text = String::from("| tier | number | not placed |");
    for workload in &workloads[1..] {
        write!(text, " {workload} |").expect("a string takes everything");
    }
    text.push_str("\n|---|---|");
    text.push_str(&"---|".repeat(workloads.len()));
    text.push('\n');
    for group in groups(rows) {
        write!(text, "| {} | `{}` |", group[0].tier, group[0].number).expect("a string takes everything");
        for workload in &workloads {
            let of: Vec<_> =
                group.iter().filter(|row| row.workload == **workload && CLOSED.contains(&row.primitive)).collect();
            let [median, most, worst] =
                [0, 1, 2].map(|i| short(of.iter().map(|row| row.errors[i]).fold(0.0, f64::max)));
            let wrong: usize = of.iter().map(|row| row.counts[0] + row.counts[1]).sum();
            let told = if wrong > 0 { format!(" ({wrong} wrong)") } else { String::new() };
            write!(text, " {median} / {most} / {worst}{told} |").expect("a string takes everything");
        }
        text.push('\n');
    }
    text + "\n"
}

/// What is said of the exact tier's integers.
const INTEGERS: &str = "\
## How often integers decide

Rays of a million that the filter of the `Exact` tier cannot decide, so that integers do, over all 16 primitives:

";

/// Per workload, how often the exact tier needs its integers.
fn integers(rows: &[Figures]) -> String {
    let mut text = String::from("| workload | `f32` | `I16F16` |\n|---|---|---|\n");
    let mut workloads: Vec<&str> = vec![];
    for row in rows.iter().filter(|row| row.tier == "Exact") {
        if !workloads.contains(&row.workload.as_str()) {
            workloads.push(&row.workload);
        }
    }
    for workload in workloads {
        write!(text, "| {workload} |").expect("a string takes everything");
        for number in ["f32", "I16F16"] {
            let of: Vec<_> = rows
                .iter()
                .filter(|row| row.tier == "Exact" && row.number == number && row.workload == workload)
                .collect();
            let decided: usize = of.iter().map(|row| row.counts[4]).sum();
            // A row has as many rays, whatever of them fits the type.
            let told = if of.is_empty() {
                String::new()
            } else {
                format!("{:.0}", 1e6 * decided as f64 / (of.len() * super::bounds::RAYS) as f64)
            };
            write!(text, " {told} |").expect("a string takes everything");
        }
        text.push('\n');
    }
    text + "\n"
}

/// The whole document.
pub fn document(rows: &[Figures]) -> String {
    let mut text = format!(
        "{HEAD}{}\n{WORKLOADS}{PLACED}{}{INTEGERS}{}## All rows\n\n",
        summary(rows),
        placed(rows),
        integers(rows)
    );
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
            counts: [lost, phantom, edge, part, _],
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
