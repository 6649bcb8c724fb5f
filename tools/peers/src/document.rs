//! The tables of `docs/peers.md`, from `data/peers.tsv`.

use crate::names::{EMBEDDED_3DGFX, EXACT, FAST, PARRY, PLAIN, STABLE, TEXTBOOK};
use crate::sizes::PRIMITIVES;
use crate::stored::{NONE, PATH, WRITTEN_BY};
use raylet_tables::{Outcome, markdown, page};

const PAGE: &str = "docs/peers.md";

/// The contestants, in the order of the tables.
const NAMES: [&str; 7] = [PLAIN, FAST, STABLE, EXACT, PARRY, EMBEDDED_3DGFX, TEXTBOOK];

/// A row of the table in `data`.
struct Row<'a>(&'a [String]);

impl<'a> Row<'a> {
    fn text(&self, column: &str) -> &'a str {
        let place = crate::stored::COLUMNS.iter().position(|name| *name == column);
        place.and_then(|place| self.0.get(place)).map_or(NONE, String::as_str)
    }

    fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or(0.0)
    }

    fn names(&self) -> [&'a str; 3] {
        ["number", "solid", "rays"].map(|column| self.text(column))
    }

    fn is_of_users(&self) -> bool {
        self.text("median") == NONE
    }

    /// Hits that are lost, phantom or far off, in brackets.
    fn wrong(&self) -> String {
        let wrong: f64 = ["lost", "phantom", "wrong"].iter().map(|column| self.number(column)).sum();
        if wrong > 0.0 { format!(" ({wrong})") } else { String::new() }
    }
}

/// A line for each of the rays, a column for each contestant.
fn side_by_side(rows: &[Row<'_>], wanted: impl Fn(&Row<'_>) -> bool, cell: impl Fn(&Row<'_>) -> String) -> String {
    let rows: Vec<_> = rows.iter().filter(|row| wanted(row)).collect();
    let names = NAMES.into_iter().filter(|name| rows.iter().any(|row| row.text("contestant") == *name));
    let names: Vec<_> = names.collect();
    let mut table = markdown::Table::new(&[&["number", "solid", "rays"], &names[..]].concat(), 3);
    let mut seen = vec![];
    for row in &rows {
        if !seen.contains(&row.names()) {
            seen.push(row.names());
            let of = |name: &&str| {
                let found = rows.iter().find(|other| other.names() == row.names() && other.text("contestant") == *name);
                found.map_or(markdown::NONE.into(), |row| cell(row))
            };
            table.row(&row.names().map(String::from).into_iter().chain(names.iter().map(of)).collect::<Vec<_>>());
        }
    }
    table.done()
}

/// Times of users' queries, with wrong answers.
fn users(rows: &[Row<'_>]) -> String {
    let cell = |row: &Row<'_>| format!("{}{}", row.text("hit_ns"), row.wrong());
    side_by_side(rows, |row| row.is_of_users(), cell)
}

/// Times of the nearest hit of benign rays: hit / miss.
fn times(rows: &[Row<'_>]) -> String {
    let wanted = |row: &Row<'_>| row.text("rays") == "benign" && row.text("number") == "f32" && !row.is_of_users();
    side_by_side(rows, wanted, |row| format!("{} / {}", row.text("hit_ns"), row.text("miss_ns")))
}

/// Errors at benign rays and at hard ones: the median / the worst, with wrong hits.
fn errors(rows: &[Row<'_>]) -> String {
    let wanted = |row: &Row<'_>| {
        let is_shown = matches!(row.text("rays"), "benign" | "10000 away" | "grazing 1e-4");
        is_shown && row.text("number") == "f32" && !row.is_of_users()
    };
    side_by_side(rows, wanted, |row| format!("{} / {}{}", row.text("median"), row.text("worst"), row.wrong()))
}

/// In how many rows errors of `Stable` are smaller, equal or larger than those of another.
fn compared(rows: &[Row<'_>]) -> String {
    /// Errors within a hundredth of each other are the same.
    const SAME: f64 = 1.01;
    let figures = |row: &Row<'_>| {
        let errors = ["median", "p999", "worst"].map(|column| row.number(column));
        let wrong: f64 = ["lost", "phantom", "wrong"].iter().map(|column| row.number(column)).sum();
        [errors[0], errors[1], errors[2], wrong]
    };
    let titles = ["number", "library", "rows", "none larger, some smaller", "all equal", "some larger"];
    let mut table = markdown::Table::new(&titles, 2);
    for (number, peer) in
        [("f32", PARRY), ("f32", EMBEDDED_3DGFX), ("f32", TEXTBOOK), ("f64", PARRY), ("f64", TEXTBOOK)]
    {
        let mut counts = [0; 3];
        let of = |name: &'static str| {
            move |row: &&Row<'_>| row.text("contestant") == name && row.text("number") == number && !row.is_of_users()
        };
        for theirs in rows.iter().filter(of(peer)) {
            let Some(ours) = rows.iter().filter(of(STABLE)).find(|row| row.names() == theirs.names()) else { continue };
            let pairs = || figures(ours).into_iter().zip(figures(theirs));
            let kind = if pairs().any(|(own, other)| own > SAME * other) {
                2
            } else {
                usize::from(!pairs().any(|(own, other)| SAME * own < other))
            };
            counts[kind] += 1;
        }
        let cells = [number.to_string(), peer.into(), counts.iter().sum::<usize>().to_string()].into_iter();
        table.row(&cells.chain(counts.map(|count: usize| count.to_string())).collect::<Vec<_>>());
    }
    table.done()
}

/// Writes the tables of the page, or says whether they are as they should be.
pub fn write(verify: bool) -> Outcome {
    let stored = raylet_tables::Table::read(PATH, WRITTEN_BY)?;
    let rows: Vec<_> = stored.rows.iter().map(|row| Row(row)).collect();
    let text = page::renewed(PAGE, |name, _, _| {
        Ok(match name {
            "environment" => {
                stored.notes.iter().map(|(name, value)| format!("- {name}: {value}\n")).collect::<String>() + "\n"
            }
            "users" => users(&rows),
            "times" => times(&rows),
            "errors" => errors(&rows),
            "compared" => compared(&rows),
            _ => return Err(format!("there is no table `{name}`").into()),
        })
    })?;
    page::put(PAGE, &text, verify, WRITTEN_BY)
}

/// All rows.
pub fn printed() -> Outcome<String> {
    let stored = raylet_tables::Table::read(PATH, WRITTEN_BY)?;
    let mut text = String::new();
    for number in ["f32", "f64"] {
        for solid in PRIMITIVES.into_iter().chain(["range sensor"]) {
            let mut table = markdown::Table::new(&stored.columns[2..], 2);
            let rows: Vec<_> =
                stored.rows.iter().filter(|row| row[0] == number && row[1].replace(", ", " ") == solid).collect();
            rows.iter().for_each(|row| table.row(&row[2..]));
            if !rows.is_empty() {
                text += &format!("## {number}, {solid}\n\n{}", table.done());
            }
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_shows_what_is_stored() {
        write(true).unwrap();
    }

    #[test]
    fn all_rows_are_printed() {
        let rows = raylet_tables::Table::read(PATH, WRITTEN_BY).unwrap().rows.len();
        let printed = printed().unwrap();
        assert_eq!(printed.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| rays")).count(), rows);
    }
}
