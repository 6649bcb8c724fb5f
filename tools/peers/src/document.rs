//! The figures as Markdown: `docs/peers.md`.

use crate::bars::{Needed, Reached, error_bars, speed_bars};
use crate::entrants::Field;
use crate::environment::Environment;
use crate::measure::Row;
use crate::names::STABLE;
use crate::sizes::PRIMITIVES;
use crate::speed::Speed;
use std::fmt::Write;
use support::workload::{WORKLOADS, Workload};

/// What was compared and how; the figures follow.
fn head(environment: &Environment) -> String {
    let version = |name| environment.version(name);
    let roots = if environment.has_exact_roots {
        "embedded-3dgfx takes its square roots from the standard library here, since parry makes that part of the build. On a chip it takes
`micromath`'s approximations, and its spheres and capsules are then some 1e-2 off. The same program built with
`--no-default-features`, that is, without parry, shows this."
    } else {
        "parry is left out, so that embedded-3dgfx takes its square roots from `micromath`, as on a chip."
    };
    format!(
        "# Beside other libraries

Errors and times of raylet {}, `parry3d` and `parry3d-f64` {}, `embedded-3dgfx` {} and a textbook's formulas, for the same queries and rays in the same number types.
`cargo run --release --manifest-path tools/peers/Cargo.toml -- --write` writes this page; do not edit it. It holds for the commit named here, not for later ones.

Commit {}; {}; {}.

The query is the nearest hit. Errors are those of `t` in units in the last place, against exact arithmetic on the bits that each library received.
*Lost* hits are those of exact arithmetic that a library did not find, *phantom* hits those that exact arithmetic does not have, *wrong* hits those
more than {} units off. The rays and the primitives are those of [accuracy.md](accuracy.md).

Times are those of a loop over a thousand rays, prepared in the library's own types. Each library returns its whole result: a distance
(parry, textbook), a hit with its part and crossing (raylet) or one with point and normal (embedded-3dgfx). The libraries take
turns of some 50 microseconds. The published ratio is the median of the ratios of all rounds; nanoseconds are given for
scale. The processor overlaps independent rays, so that these times are throughputs and not latencies. All is compiled together (`lto = \"fat\"`, one
codegen unit, no `target-cpu`). raylet's square root is that of `libm`, which is an instruction on a host.

parry's cylinder and cone are centred on the origin. Their rays are moved accordingly before the timing, and the reference takes the moved rays. parry computes these two by iteration (GJK) and all others in closed form.

{roots} The triangle of embedded-3dgfx is a mesh of one face.

The textbook's formulas are `k^2 - a c`, and the triangle of Moeller and Trumbore: [tools/peers/src/textbook.rs](../tools/peers/src/textbook.rs).
\n",
        version("raylet"),
        version("parry3d"),
        version("embedded-3dgfx"),
        environment.commit,
        environment.compiler,
        environment.processor,
        crate::errors::WRONG,
    )
}

/// Three digits.
pub fn short(value: f64) -> String {
    match value {
        0.0..10.0 => format!("{value:.2}"),
        10.0..100.0 => format!("{value:.1}"),
        100.0..1e5 => format!("{value:.0}"),
        _ => format!("{value:.0e}"),
    }
}

fn length(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{value:.0e}") }
}

pub fn bold(text: String, is_bold: bool) -> String {
    if is_bold { format!("**{text}**") } else { text }
}

fn bar_cell(reached: Option<&Reached>, needed: Needed, tells_place: bool) -> String {
    reached.map_or("–".into(), |Reached { ratio: [low, median, high], place }| {
        let figure = format!("{} ({}–{})", short(*median), short(*low), short(*high));
        let figure = bold(figure, needed.is_reached(*median));
        if tells_place { format!("{figure} {place}") } else { figure }
    })
}

/// The bars, and what was reached.
fn bars(rows: &[Row]) -> String {
    let mut text = String::from(
        "## Limits\n\nLimits that were set for raylet's `f32` on a host. A figure in **bold** reaches its limit. Median and quartiles.\n\n\
         | limit on | needed | benign, hits | benign, misses | worst of its workloads |\n|---|---:|---:|---:|---|\n",
    );
    let (mut count, mut reached) = (0, 0);
    for bar in speed_bars(rows) {
        let needed = match bar.needed {
            Needed::AtLeast(least) => format!("at least {least}"),
            Needed::AtMost(most) => format!("at most {most}"),
        };
        count += 1;
        reached += usize::from(bar.worst.as_ref().is_some_and(|worst| bar.needed.is_reached(worst.ratio[1])));
        let [hits, misses] = bar.benign.each_ref().map(|cell| bar_cell(cell.as_ref(), bar.needed, false));
        let worst = bar_cell(bar.worst.as_ref(), bar.needed, true);
        line(&mut text, &[&bar.what, &needed, &hits, &misses, &worst]);
    }
    let _ = writeln!(text, "\nOf these {count} limits, {reached} are reached in their worst workload too.\n");
    text.push_str(
        "`Stable`'s errors (median, 99.9 %, worst, and how many hits are lost, phantom or wrong) beside those of another library. \
         The limit: none is larger in any row of primitive and workload. Errors that differ by less than a hundredth count as equal.\n\n\
         | number | library | rows | none larger, some smaller | all equal | some larger |\n|---|---|---:|---:|---:|---:|\n",
    );
    let bars = error_bars(rows);
    for bar in &bars {
        let larger = bar.larger.len();
        let told = bold(larger.to_string(), larger == 0);
        let [all, smaller, equal] = [bar.smaller + bar.equal + larger, bar.smaller, bar.equal].map(|n| n.to_string());
        line(&mut text, &[&bar.number, bar.peer, &all, &smaller, &equal, &told]);
    }
    let larger: Vec<_> = bars.iter().flat_map(|bar| &bar.larger).collect();
    if !larger.is_empty() {
        text.push_str(
            "\nThe rows in which one of `Stable`'s errors is larger, median / 99.9 % / worst; in brackets how many hits are lost, phantom or wrong:\n\n\
             | number | primitive | workload | `Stable` | library | its errors |\n|---|---|---|---:|---|---:|\n",
        );
        for (ours, theirs) in larger {
            let workload = ours.workload.name();
            let cells = [
                &ours.number,
                ours.primitive,
                &workload,
                &three_errors(ours),
                theirs.contestant,
                &three_errors(theirs),
            ];
            line(&mut text, &cells);
        }
    }
    text + "\n"
}

fn three_errors(row: &Row) -> String {
    let [median, most, worst] = row.errors.units.map(short);
    format!("{median} / {most} / {worst}{}", failures(row))
}

fn failures(row: &Row) -> String {
    let failures = row.errors.failures();
    if failures > 0 { format!(" ({failures})") } else { String::new() }
}

pub fn line(text: &mut String, cells: &[&str]) {
    let _ = writeln!(text, "| {} |", cells.join(" | "));
}

/// The head of a table with a column a contestant.
fn contestants_head(text: &mut String, names: &[&str]) {
    let _ = writeln!(text, "| primitive | rays | {} |", names.join(" | "));
    let _ = writeln!(text, "|---|---|{}", "---:|".repeat(names.len()));
}

/// A line with a cell a contestant: what `cell` makes of its row, or that it has no such primitive.
fn contestants_line(
    text: &mut String,
    rows: &[&Row],
    names: &[&str],
    of: [&str; 2],
    cell: impl Fn(&Row) -> Option<String>,
) {
    let told = names.iter().map(|name| match rows.iter().find(|row| row.contestant == *name) {
        Some(row) => cell(row).unwrap_or("–".into()),
        None => "has none".into(),
    });
    let cells: Vec<String> = of.iter().map(ToString::to_string).chain(told).collect();
    if cells[2..].iter().any(|cell| cell != "–" && cell != "has none") {
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
}

fn of_workload<'a>(rows: &'a [Row], number: &str, primitive: &str, workload: Workload) -> Vec<&'a Row> {
    rows.iter().filter(|row| row.number == number && row.primitive == primitive && row.workload == workload).collect()
}

/// What a query costs.
fn times<S: Field>(rows: &[Row]) -> String {
    let number = S::name();
    let mut text = format!(
        "## Time, `{number}`\n\nNanoseconds, and in brackets times the textbook's `f32` sphere at benign rays that hit:\n\n"
    );
    contestants_head(&mut text, S::NAMES);
    let told = |speed: &Option<Speed>| {
        speed.as_ref().map(|speed| format!("{} ({})", short(speed.nanoseconds), short(speed.to_sphere[1])))
    };
    for primitive in PRIMITIVES {
        for workload in [Workload::Benign, Workload::Away(10_000.0), Workload::Grazing(1e-4)] {
            let of = of_workload(rows, &number, primitive, workload);
            for (kind, is_hit) in [("hits", true), ("misses", false)] {
                let rays = format!("{}, {kind}", workload.name());
                contestants_line(&mut text, &of, S::NAMES, [primitive, &rays], |row| {
                    told(if is_hit { &row.hits } else { &row.misses })
                });
            }
        }
    }
    text + "\n"
}

/// The workloads that the table of errors shows.
const SHOWN: [Workload; 8] = [
    Workload::Benign,
    Workload::Away(100.0),
    Workload::Away(10_000.0),
    Workload::Grazing(1e-4),
    Workload::Grazing(1e-7),
    Workload::Inside,
    Workload::OnSurface,
    Workload::Rims,
];

/// How wrong the answers are.
fn errors<S: Field>(rows: &[Row]) -> String {
    let number = S::name();
    let mut text = format!(
        "## Errors, `{number}`\n\nMedian / worst in units in the last place, the worst as a length (the primitives are of size 1), and in brackets \
         how many hits are lost, phantom or wrong:\n\n"
    );
    contestants_head(&mut text, S::NAMES);
    for primitive in PRIMITIVES {
        for workload in SHOWN {
            let of = of_workload(rows, &number, primitive, workload);
            contestants_line(&mut text, &of, S::NAMES, [primitive, &workload.name()], |row| {
                let [median, _, worst] = row.errors.units.map(short);
                Some(format!("{median} / {worst}; {}{}", length(row.errors.lengths[2]), failures(row)))
            });
        }
    }
    text + "\n"
}

/// Everything.
fn all<S: Field>(rows: &[Row]) -> String {
    let number = S::name();
    let mut text = String::new();
    for primitive in PRIMITIVES {
        let _ = writeln!(
            text,
            "<details><summary><code>{number}</code>, {primitive}</summary>\n\n\
             | workload | contestant | hits of rays | median | 99.9 % | worst | median length | worst length | lost | phantom | wrong \
             | hit, ns | to textbook sphere | to `Stable` | miss, ns | to textbook sphere | to `Stable` |\n|---|---|{}",
            "---:|".repeat(15)
        );
        for workload in WORKLOADS {
            for row in of_workload(rows, &number, primitive, workload) {
                let errors = &row.errors;
                let [median, most, worst] = errors.units.map(short);
                let [middle, _, farthest] = errors.lengths.map(length);
                let _ = writeln!(
                    text,
                    "| {} | {} | {} of {} | {median} | {most} | {worst} | {middle} | {farthest} | {} | {} | {} | {} | {} |",
                    workload.name(),
                    row.contestant,
                    errors.hits,
                    errors.rays,
                    errors.lost,
                    errors.phantom,
                    errors.wrong,
                    three_times(&row.hits),
                    three_times(&row.misses),
                );
            }
        }
        text.push_str("\n</details>\n\n");
    }
    text
}

fn three_times(speed: &Option<Speed>) -> String {
    speed.as_ref().map_or("– | – | –".into(), |speed| {
        format!("{} | {} | {}", short(speed.nanoseconds), short(speed.to_sphere[1]), short(speed.to_stable[1]))
    })
}

/// The whole document; `users` is the text of the workloads of users, if parry takes part.
pub fn document(environment: &Environment, rows: &[Row], users: &str) -> String {
    let tables = [times::<f32>(rows), errors::<f32>(rows), times::<f64>(rows), errors::<f64>(rows)].concat();
    format!(
        "{}{users}{}{tables}## All rows\n\n`to {STABLE}` is the library's time over that of `Stable` in the same number type, for the same rays.\n\n{}{}",
        head(environment),
        bars(rows),
        all::<f32>(rows),
        all::<f64>(rows)
    )
}
