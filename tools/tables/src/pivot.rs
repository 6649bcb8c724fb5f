//! Figures with names of several parts as a table: some parts are rows, some are columns.

use crate::markdown::{NONE, Table};
use crate::{CHIPS, Figures, SUBJECTS, grouped};
use std::collections::{BTreeMap, BTreeSet};

/// Where a figure stands: the parts of its row, those of its column, and which figure of that cell it is.
pub type Place<'a> = (Vec<&'a str>, Vec<&'a str>, &'a str);

/// The figures of a cell, by their last part.
pub type Cell<'a> = BTreeMap<&'a str, u64>;

/// Names that have an order of their own; numbers are in theirs, and other names follow by the alphabet.
const ORDER: [&str; 13] = [
    "f32",
    "f64",
    "I16F16",
    "I20F12",
    "I8F24",
    "I32F32",
    "textbook",
    "textbook, VSQRT",
    "Plain",
    "Fast",
    "Stable",
    "Exact",
    "any",
];

/// The parts of a row or a column, in the order of the table.
type Key<'a> = Vec<(usize, &'a str)>;

fn key(parts: Vec<&str>) -> Key<'_> {
    let known = || ORDER.into_iter().chain(SUBJECTS).chain(CHIPS.map(|(_, name)| name));
    let place = |part: &str| known().position(|name| name == part).or(part.parse().ok()).unwrap_or(usize::MAX);
    parts.into_iter().map(|part| (place(part), part)).collect()
}

fn text(key: &Key<'_>) -> String {
    key.iter().map(|(_, part)| *part).collect::<Vec<_>>().join(" ")
}

/// The table; `titles` are those of the rows' parts. `place` says where the figure of a name stands, or that it is left
/// out, and `cell` makes a text of the figures of a cell.
pub fn pivot<'a>(
    titles: &[&str],
    figures: &'a Figures,
    place: impl Fn(&[&'a str]) -> Option<Place<'a>>,
    cell: impl Fn(&Cell<'_>) -> String,
) -> String {
    let mut cells: BTreeMap<(Key<'a>, Key<'a>), Cell<'a>> = BTreeMap::new();
    for (name, figure) in figures {
        let parts: Vec<&str> = name.split(" | ").collect();
        if let Some((row, column, what)) = place(&parts) {
            cells.entry((key(row), key(column))).or_default().insert(what, *figure);
        }
    }
    let rows: BTreeSet<&Key<'_>> = cells.keys().map(|(row, _)| row).collect();
    let columns: BTreeSet<&Key<'_>> = cells.keys().map(|(_, column)| column).collect();
    let names: Vec<_> =
        titles.iter().map(ToString::to_string).chain(columns.iter().map(|column| text(column))).collect();
    let mut table = Table::new(&names, titles.len());
    for row in rows {
        let of = |column: &&Key<'a>| cells.get(&(row.clone(), (*column).clone())).map_or(NONE.into(), &cell);
        let parts = row.iter().map(|(_, part)| (*part).to_string());
        table.row(&parts.chain(columns.iter().map(of)).collect::<Vec<_>>());
    }
    table.done()
}

/// Of a cell the figures of these names, as `1,000 / 200`; those that are missing are left out.
pub fn joined(cell: &Cell<'_>, names: &[&str]) -> String {
    let found: Vec<_> = names.iter().filter_map(|name| cell.get(name)).map(|figure| grouped(*figure)).collect();
    if found.is_empty() { NONE.into() } else { found.join(" / ") }
}

/// The mean and, in brackets, the worst of what users do.
pub fn mean_and_worst(cell: &Cell<'_>) -> String {
    format!("{} ({})", joined(cell, &["mean"]), joined(cell, &["worst"]))
}

/// The figures of several machines, each with the machine's name in front.
pub fn together<'a>(machines: impl IntoIterator<Item = (&'a str, &'a Figures)>) -> Figures {
    let of = |(machine, figures): (&'a str, &'a Figures)| {
        figures.iter().map(move |(name, figure)| (format!("{machine} | {name}"), *figure))
    };
    machines.into_iter().flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_become_rows_and_columns() {
        let figures =
            [("disc | f64 | hit", 1000), ("disc | f32 | hit", 2), ("disc | f32 | miss", 1), ("plane | f32 | hit", 3)];
        let figures: Figures = figures.map(|(name, figure)| (name.to_string(), figure)).into();
        let place = |parts: &[&'static str]| match *parts {
            [solid, number, what] => Some((vec![solid], vec![number], what)),
            _ => None,
        };
        let figures: &'static Figures = Box::leak(Box::new(figures));
        let table = pivot(&["solid"], figures, place, |cell| joined(cell, &["hit", "miss"]));
        assert_eq!(table, "| solid | f32 | f64 |\n|---|---:|---:|\n| plane | 3 | – |\n| disc | 2 / 1 | 1,000 |\n\n",);
    }
}
