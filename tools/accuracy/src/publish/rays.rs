//! The page, the plot and the JSON of a file of rays.

use super::by_number::{ERRORS, error_cells};
use super::markdown::{NONE, Table, row_ratios, short};
use super::plots;
use crate::rays::measured::{Extra, Hit, Outcome, Task, Worst};
use crate::study::{lines, row_as_json};
use serde_json::{Value, json};
use std::error::Error;
use std::fmt::Write;
use support::figures::Figures;

/// Columns of the table that hold errors of hits: a row without hits has none.
const OF_HITS: std::ops::Range<usize> = 1..7;

/// What is measured, in a line.
fn about(task: &Task<'_>, texts: [&str; 2]) -> String {
    let [solid, placement] = texts;
    let placed = if task.placement.is_some() { format!("placed `{placement}`") } else { "not placed".into() };
    format!("{} rays of `{}` at `{solid}`, {placed}.", task.lines.len(), task.file)
}

/// The table of the published pages, a row a number type and tier.
fn errors(outcome: &Outcome) -> String {
    let is_timed = !outcome.study.times.rows.is_empty();
    let mut titles = vec!["number", "tier", "rays", "not held"];
    titles.extend(ERRORS);
    titles.push("broken");
    titles.extend(is_timed.then_some("host"));
    let mut table = Table::new(&titles, 2);
    for (row, extra) in outcome.study.rows.iter().zip(&outcome.extras) {
        let mut cells = vec![row.number.clone(), row.tier.into(), extra.rays.to_string(), extra.not_held.to_string()];
        let mut errors = error_cells(row);
        if row.hits == 0 {
            errors[OF_HITS].fill(NONE.into());
        }
        cells.extend(errors);
        cells.push(row.broken.to_string());
        cells.extend(is_timed.then(|| row_ratios(&outcome.study, row)));
        table.row(&cells);
    }
    table.aligned()
}

/// Hits with their part and crossing.
fn hits(hits: &[Hit]) -> String {
    let hit = |hit: &Hit| match &hit.surface {
        Some([part, crossing]) => format!("{} ({part}, {crossing})", hit.t),
        None => hit.t.to_string(),
    };
    if hits.is_empty() { "no hit".into() } else { hits.iter().map(hit).collect::<Vec<_>>().join(", ") }
}

/// The worst ray of each row.
fn worst(outcome: &Outcome) -> String {
    let mut table = Table::new(&["number", "tier", "line", "error", "answer", "exact"], 2);
    for (row, extra) in outcome.study.rows.iter().zip(&outcome.extras) {
        let Some(Worst { line, error, hits: answer, exact }) = &extra.worst else { continue };
        let error = error.map_or("wrong".into(), short);
        table.row(&[row.number.clone(), row.tier.into(), line.to_string(), error, hits(answer), hits(exact)]);
    }
    table.aligned()
}

/// What the number types that have no row were refused for.
fn left_out(outcome: &Outcome) -> String {
    let mut text = String::new();
    for (number, why) in &outcome.left_out {
        let _ = writeln!(text, "Not measured in `{number}`: {why}.\n");
    }
    text
}

/// What is printed.
pub fn printed(task: &Task<'_>, texts: [&str; 2], outcome: &Outcome) -> String {
    format!(
        "{}\n\n{}{}Worst ray of each row:\n\n{}",
        about(task, texts),
        left_out(outcome),
        errors(outcome),
        worst(outcome)
    )
}

/// What the columns mean.
const LEGEND: &str = "\
The exact answers are those for the solid, the placement and the rays as each number type stores them. *Rays* are those
that the type holds, *not held* those with a coordinate or a start of their range beyond it. *Median*, *99.9%* and
*worst* are errors of `t` in units in the last place, *length* the same as lengths. *Lost* are hits that are missing,
*phantom* hits that do not exist, *edge* hits within one unit of the range's start on its wrong side, *part* hits on
another part or with another crossing, *broken* rays of which the tier does not keep its promise.";

/// The page, the plot, and everything as JSON, with their paths in the folder of the output.
pub fn documents(
    task: &Task<'_>,
    texts: [&str; 2],
    outcome: &Outcome,
) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let times = &outcome.study.times;
    let timed = if times.rows.is_empty() {
        String::new()
    } else {
        format!(
            " *Host* is the time of a nearest hit, of rays that hit / that miss, as a ratio to the textbook's sphere \
             in `f32` ({} ns on {}).",
            times.reference_nanoseconds, times.machine
        )
    };
    let page = format!(
        "# Errors of your rays\n\n{}\n\n{LEGEND}{timed}\n\n{}{}\
         ![Errors by the share of hits that exceed them](rays.svg)\n\n## Worst rays\n\n\
         The ray of each row with a wrong hit, or with the largest error. *Line* is that of the file.\n\n{}",
        about(task, texts),
        left_out(outcome),
        errors(outcome),
        worst(outcome)
    );
    Ok(vec![
        ("rays.md".into(), page.trim_end().to_string() + "\n"),
        ("rays.svg".into(), plots::rays::plot(task, outcome)?),
        ("rays.json".into(), as_json(task, texts, outcome)),
    ])
}

fn hits_as_json(hits: &[Hit]) -> Value {
    let hit = |hit: &Hit| {
        let surface = |index: usize| hit.surface.as_ref().map(|surface| surface[index].as_str());
        json!({ "t": hit.t, "part": surface(0), "crossing": surface(1) })
    };
    hits.iter().map(hit).collect()
}

/// A row as in the JSON of the published tables, and what a file of rays has beside.
fn row(outcome: &Outcome, row: &Figures, extra: &Extra) -> Value {
    let mut value = row_as_json(&outcome.study, row);
    let worst = extra.worst.as_ref().map(|worst| {
        json!({
            "line": worst.line, "error": worst.error,
            "hits": hits_as_json(&worst.hits), "exact": hits_as_json(&worst.exact),
        })
    });
    // Those of chips are counted of other rays.
    value.as_object_mut().map(|fields| fields.remove("instructions"));
    value["rays"] = extra.rays.into();
    value["not_held"] = extra.not_held.into();
    value["worst_ray"] = worst.unwrap_or(Value::Null);
    if row.hits == 0 {
        for name in ["median", "p999", "worst", "median_length", "p999_length", "worst_length"] {
            value[name] = Value::Null;
        }
    }
    value
}

/// Everything, one object a row.
pub fn as_json(task: &Task<'_>, [solid, placement]: [&str; 2], outcome: &Outcome) -> String {
    let placement = task.placement.map(|_| placement);
    let times = &outcome.study.times;
    let is_timed = !times.rows.is_empty();
    let rows = outcome.study.rows.iter().zip(&outcome.extras).map(|(figures, extra)| row(outcome, figures, extra));
    let left_out = outcome.left_out.iter().map(|(number, why)| json!({ "number": number, "why": why }));
    format!(
        "{{\n\"file\": {},\n\"solid\": {},\n\"placement\": {},\n\"rays\": {},\n\"machine\": {},\n\
         \"reference_nanoseconds\": {},\n\"rows\": [\n{}\n],\n\"not_measured\": [\n{}\n]}}\n",
        json!(task.file),
        json!(solid),
        json!(placement),
        task.lines.len(),
        json!(is_timed.then_some(&times.machine)),
        json!(is_timed.then_some(times.reference_nanoseconds)),
        lines(rows),
        lines(left_out)
    )
}
