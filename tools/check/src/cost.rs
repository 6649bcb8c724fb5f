//! What the programs `cost` and `workloads` printed.

use crate::printed::rows;
use raylet_tables::{Figures, Outcome};
use serde::Deserialize;
use std::path::Path;

#[derive(Deserialize)]
struct Row {
    subject: String,
    query: String,
    number: String,
    tier: String,
    of: String,
    figure: u64,
}

/// The name of a figure in a baseline; `of` is `hit`, `miss` or `stack`.
pub fn key(subject: &str, query: &str, number: &str, tier: &str, of: &str) -> String {
    format!("{subject} | {query} | {number} | {tier} | {of}")
}

/// Reads what the program `cost` printed: a figure a line.
pub fn read(path: &Path) -> Outcome<Figures> {
    let named = |row: Row| (key(&row.subject, &row.query, &row.number, &row.tier, &row.of), row.figure);
    Ok(rows(path)?.into_iter().map(named).collect())
}

#[derive(Deserialize)]
struct WorkloadRow {
    of: String,
    number: String,
    tier: String,
    mean: u64,
    nearly: u64,
    worst: u64,
}

/// Reads what the program `workloads` printed: three figures a line.
pub fn read_workloads(path: &Path) -> Outcome<Figures> {
    let mut figures = Figures::new();
    for row in rows::<WorkloadRow>(path)? {
        for (what, figure) in [("mean", row.mean), ("99 %", row.nearly), ("worst", row.worst)] {
            figures.insert(workload_key(&row.of, &row.number, &row.tier, what), figure);
        }
    }
    Ok(figures)
}

/// The name of a figure of a workload in a baseline; `what` is `mean`, `99 %` or `worst`.
pub fn workload_key(of: &str, number: &str, tier: &str, what: &str) -> String {
    format!("{of} | {number} | {tier} | {what}")
}
