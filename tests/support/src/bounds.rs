//! The bound table: tier x primitive x number type x workload, in `data/bounds`, a table a tier.
//!
//! `cargo run --release -p raylet-accuracy -- --write` renews the tables; `tests/promises/src/number_types.rs` holds the library
//! to them.

use super::figures::{Figures, TIERS};
use super::subject::SUBJECTS;
use raylet_tables::Table;

/// Rays a row.
pub const RAYS: usize = 2000;

const COLUMNS: [&str; 15] = [
    "number",
    "primitive",
    "workload",
    "hits",
    "median",
    "p999",
    "worst",
    "median_length",
    "p999_length",
    "worst_length",
    "lost",
    "phantom",
    "edge",
    "part",
    "integers",
];

/// The command that writes the tables.
const WRITTEN_BY: &str = "cargo run --release -p raylet-accuracy -- --write";

/// The file of a tier's rows, from the root of the repository.
pub fn path(tier: &str) -> String {
    format!("data/bounds/{}.tsv", tier.to_lowercase())
}

/// All rows of all tiers, as the repository holds them.
pub fn all() -> Vec<Figures> {
    TIERS.into_iter().flat_map(of).collect()
}

fn of(tier: &'static str) -> Vec<Figures> {
    let path = path(tier);
    let table = Table::read(&path, WRITTEN_BY).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(table.columns, COLUMNS, "{path} has other columns; `{WRITTEN_BY}` writes it anew");
    table.rows.iter().map(|row| figures(tier, row).unwrap_or_else(|| panic!("{path}: {row:?}"))).collect()
}

fn figures(tier: &'static str, row: &[String]) -> Option<Figures> {
    let real = |column: usize| row[column].parse::<f64>().ok();
    let count = |column: usize| row[column].parse::<usize>().ok();
    Some(Figures {
        tier,
        number: row[0].clone(),
        primitive: SUBJECTS.into_iter().find(|name| *name == row[1])?,
        workload: row[2].clone(),
        hits: count(3)?,
        errors: [real(4)?, real(5)?, real(6)?],
        lengths: [real(7)?, real(8)?, real(9)?],
        counts: [count(10)?, count(11)?, count(12)?, count(13)?, count(14)?],
    })
}

/// The table of a tier's rows, as it is stored.
pub fn table(tier: &str, rows: &[Figures]) -> String {
    let mut table = Table::new(&COLUMNS);
    for row in rows.iter().filter(|row| row.tier == tier) {
        let mut cells = vec![row.number.clone(), row.primitive.into(), row.workload.clone(), row.hits.to_string()];
        cells.extend(row.errors.map(|error| format!("{error:.3}")));
        cells.extend(row.lengths.map(|length| format!("{length:.2e}")));
        cells.extend(row.counts.map(|count| count.to_string()));
        table.rows.push(cells);
    }
    table.text()
}
