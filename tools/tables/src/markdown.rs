//! Tables in Markdown.

use std::fmt::Write;

/// What stands where there is no figure.
pub const NONE: &str = "–";

/// A table; the first `names` columns are names, the others figures.
pub struct Table {
    text: String,
}

impl Table {
    /// A table with these titles.
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

    /// Adds a row.
    pub fn row<T: AsRef<str>>(&mut self, cells: &[T]) {
        self.text.push('|');
        for cell in cells {
            let _ = write!(self.text, " {} |", cell.as_ref());
        }
        self.text.push('\n');
    }

    /// The text, with an empty line at its end.
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
