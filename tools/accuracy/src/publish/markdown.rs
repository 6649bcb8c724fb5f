//! Figures and tables as Markdown.

use crate::chips::{Chip, is_like};
use crate::study::{Cost, Study};
use raylet_tables::grouped;
use std::fmt::Write;
use support::figures::Figures;

/// An error in units in the last place.
pub fn short(value: f64) -> String {
    match value {
        0.0..10.0 => format!("{value:.2}"),
        10.0..1e5 => format!("{value:.0}"),
        _ => format!("{value:.0e}"),
    }
}

/// A length.
pub fn length(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{value:.1e}") }
}

/// A ratio or nanoseconds, to two or three digits.
pub fn few_digits(value: f64) -> String {
    match value {
        0.0..1.0 => format!("{value:.2}"),
        1.0..100.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}

pub const NONE: &str = "–";

/// What a nearest hit takes, as a ratio: of rays that hit / that miss.
pub fn ratios(hit: Option<Cost>, miss: Option<Cost>) -> String {
    pair(hit.map(|cost| few_digits(cost.ratio)), miss.map(|cost| few_digits(cost.ratio)))
}

pub fn nanoseconds(hit: Option<Cost>, miss: Option<Cost>) -> String {
    pair(hit.map(|cost| few_digits(cost.nanoseconds)), miss.map(|cost| few_digits(cost.nanoseconds)))
}

fn pair(hit: Option<String>, miss: Option<String>) -> String {
    match (hit, miss) {
        (None, None) => NONE.into(),
        (hit, miss) => format!("{} / {}", hit.unwrap_or(NONE.into()), miss.unwrap_or(NONE.into())),
    }
}

/// A chip's instructions for a row: hit / miss; in brackets where the firmware has other rays than the row's.
pub fn instructions(chip: &Chip, row: &Figures) -> String {
    let told = chip.instructions(row);
    let text = pair(told.map(|told| grouped(told.hit)), told.map(|told| grouped(told.miss)));
    if told.is_some() && !is_like(row) { format!("({text})") } else { text }
}

/// The time of a row on the host: hit / miss.
pub fn row_ratios(study: &Study, row: &Figures) -> String {
    study.time(row).map_or(NONE.into(), |time| ratios(time.hit, time.miss))
}

/// A table; the first `names` columns are names, the others figures.
pub struct Table {
    text: String,
}

impl Table {
    pub fn new<T: AsRef<str>>(titles: &[T], names: usize) -> Self {
        let mut table = Self { text: String::new() };
        table.row(titles);
        table.text.push('|');
        for column in 0..titles.len() {
            table.text.push_str(if column < names { "---|" } else { "---:|" });
        }
        table.text.push('\n');
        table
    }

    pub fn row<T: AsRef<str>>(&mut self, cells: &[T]) {
        self.text.push('|');
        for cell in cells {
            let _ = write!(self.text, " {} |", cell.as_ref());
        }
        self.text.push('\n');
    }

    pub fn done(self) -> String {
        self.text + "\n"
    }

    /// With columns of even width, which a terminal shows as a table too.
    pub fn aligned(self) -> String {
        let rows: Vec<Vec<&str>> =
            self.text.lines().map(|row| row.trim_matches('|').split('|').map(str::trim).collect()).collect();
        let [titles, rules, rows @ ..] = &rows[..] else { return self.done() };
        let width = |column: usize| {
            let cells = std::iter::once(titles).chain(rows).filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<_> = (0..titles.len()).map(width).collect();
        let mut text = String::new();
        for (index, row) in std::iter::once(titles).chain([rules]).chain(rows).enumerate() {
            text.push('|');
            for ((cell, width), rule) in row.iter().zip(&widths).zip(rules) {
                let _ = match (index == 1, rule.ends_with(':')) {
                    (true, true) => write!(text, "{:->1$}|", ":", width + 2),
                    (true, false) => write!(text, "{:-<1$}|", "", width + 2),
                    (false, true) => write!(text, " {cell:>width$} |"),
                    (false, false) => write!(text, " {cell:<width$} |"),
                };
            }
            text.push('\n');
        }
        text + "\n"
    }
}

/// The page of a number type's rows.
pub fn page(number: &str) -> String {
    format!("accuracy/{}.md", number.to_lowercase())
}

/// A link to a primitive's rows, from a page in docs/.
pub fn link(number: &str, primitive: &str) -> String {
    format!("{}#{}", page(number), primitive.replace(' ', "-"))
}

/// What stands between two marks, replaced; `None` if a mark is missing.
pub fn between_marks(text: &str, name: &str, new: &str) -> Option<String> {
    let start = text.find(&format!("<!-- {name}:"))?;
    let start = start + text[start..].find("-->\n")? + 4;
    let end = start + text[start..].find(&format!("<!-- /{name} -->"))?;
    Some(format!("{}\n{new}{}", &text[..start], &text[end..]))
}
