//! The bound table: tier x number type x primitive x placement x workload, in `data/bounds`, a table a tier.
//!
//! `cargo run --release -p raylet-accuracy -- --write` renews the tables; `tests/promises/src/number_types.rs` holds
//! the library to them.

use super::figures::{Figures, Rays, TIERS};
use super::subject::SUBJECTS;
use raylet_tables::Table;

/// Rays a row.
pub const RAYS: Rays = Rays::new(2000);

/// So many of them, the first, in the quick form of the tests.
pub const QUICK: Rays = Rays { unplaced: 100, placed: 40 };

const COLUMNS: [&str; 17] = [
    "number",
    "primitive",
    "placed",
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
    "broken",
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
        placed: row[2].clone(),
        workload: row[3].clone(),
        hits: count(4)?,
        errors: [real(5)?, real(6)?, real(7)?],
        lengths: [real(8)?, real(9)?, real(10)?],
        counts: [count(11)?, count(12)?, count(13)?, count(14)?, count(15)?],
        broken: count(16)?,
        worst: None,
    })
}

/// The table of a tier's rows, as it is stored.
pub fn table(tier: &str, rows: &[Figures]) -> String {
    let mut table = Table::new(&COLUMNS);
    for row in rows.iter().filter(|row| row.tier == tier) {
        let names = [&row.number, row.primitive, &row.placed, &row.workload];
        let mut cells = names.map(String::from).to_vec();
        cells.push(row.hits.to_string());
        cells.extend(row.errors.map(|error| format!("{error:.3}")));
        cells.extend(row.lengths.map(|length| format!("{length:.2e}")));
        cells.extend(row.counts.map(|count| count.to_string()));
        cells.push(row.broken.to_string());
        table.rows.push(cells);
    }
    table.text()
}
