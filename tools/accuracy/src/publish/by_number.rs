//! The rows that are timed, a page a number type.

use super::markdown::{Table, instructions, length, nanoseconds, row_ratios, short};
use crate::study::Study;
use std::fmt::Write;
use support::figures::{Figures, TIERS};
use support::subject::SUBJECTS;

/// The titles of a row's errors.
pub const ERRORS: [&str; 11] = [
    "hits",
    "median",
    "99.9%",
    "worst",
    "median, length",
    "99.9%, length",
    "worst, length",
    "lost",
    "phantom",
    "edge",
    "part",
];

/// A row's errors.
pub fn error_cells(row: &Figures) -> Vec<String> {
    let [lost, phantom, edge, part, _] = row.counts.map(|count| count.to_string());
    let part = if row.tier == "Textbook" { super::markdown::NONE.into() } else { part };
    let mut cells = vec![row.hits.to_string()];
    cells.extend(row.errors.map(short));
    cells.extend(row.lengths.map(length));
    cells.extend([lost, phantom, edge, part]);
    cells
}

fn errors(rows: &[&Figures]) -> String {
    let mut table = Table::new(&[&["workload", "tier"], &ERRORS[..]].concat(), 2);
    for row in rows {
        table.row(&[vec![row.name(), row.tier.into()], error_cells(row)].concat());
    }
    table.done()
}

fn times(study: &Study, number: &str, primitive: &str, tiers: &[&str]) -> String {
    let titles = tiers.iter().flat_map(|tier| [tier.to_string(), "ns".into()]);
    let mut table = Table::new(&std::iter::once("workload".into()).chain(titles).collect::<Vec<String>>(), 1);
    for workload in study.timed(number, primitive) {
        let mut cells = vec![workload.clone()];
        for tier in tiers {
            let Some(row) = study.row(number, tier, primitive, &workload) else { continue };
            cells.push(row_ratios(study, row));
            cells.push(study.time(row).map_or(String::new(), |time| nanoseconds(time.hit, time.miss)));
        }
        table.row(&cells);
    }
    table.done()
}

/// Of the rays of the firmware, at the primitive and placed.
fn chips(study: &Study, rows: &[&Figures]) -> String {
    let titles: Vec<_> = ["", "tier"].into_iter().chain(study.chips.iter().map(|chip| chip.name)).collect();
    let mut table = Table::new(&titles, 2);
    let mut any = false;
    for place in ["-", "turned", "stretched by 1/30 to 30"] {
        for row in rows.iter().filter(|row| row.workload == "benign" && row.placed == place) {
            let cells: Vec<_> = study.chips.iter().map(|chip| instructions(chip, row)).collect();
            if cells.iter().all(|cell| cell == super::markdown::NONE) {
                continue;
            }
            any = true;
            let place = if row.is_unplaced() { "not placed" } else { place.split(' ').next().unwrap_or(place) };
            table.row(&[vec![place.into(), row.tier.to_string()], cells].concat());
        }
    }
    if any { format!("Instructions of a nearest hit, hit / miss:\n\n{}", table.done()) } else { String::new() }
}

/// The rows of a number type, or of its rows one tier alone.
pub fn page(study: &Study, number: &str, tier: Option<&str>) -> String {
    let mut text = format!(
        "# Rows of `{number}`\n\nTimes are those of {}: hit / miss, as a ratio to the textbook's sphere in `f32` ({} \
         ns), and in nanoseconds.\n\n",
        study.times.machine, study.times.reference_nanoseconds
    );
    let tiers: Vec<_> = TIERS.into_iter().filter(|known| tier.is_none_or(|tier| tier == *known)).collect();
    for primitive in SUBJECTS {
        let mut rows: Vec<&Figures> = vec![];
        for workload in study.timed(number, primitive) {
            rows.extend(tiers.iter().filter_map(|tier| study.row(number, tier, primitive, &workload)));
        }
        if rows.is_empty() {
            continue;
        }
        let tiers: Vec<_> = tiers.iter().copied().filter(|tier| rows.iter().any(|row| row.tier == *tier)).collect();
        let _ = write!(
            text,
            "## {primitive}\n\nErrors of `t`:\n\n{}Times, hit / miss:\n\n{}{}",
            errors(&rows),
            times(study, number, primitive, &tiers),
            chips(study, &rows)
        );
    }
    text
}
