//! Tables of text: notes, a line of column names, and rows, with tabs between the cells.

use crate::{Outcome, in_repository};
use std::fs;

/// A table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// Names and values that concern all rows: lines `# name: value`.
    pub notes: Vec<(String, String)>,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// As many cells as columns in each.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without notes and rows.
    pub fn new(columns: &[&str]) -> Self {
        Self { notes: vec![], columns: columns.iter().map(ToString::to_string).collect(), rows: vec![] }
    }

    /// The table with a note.
    pub fn with_note(mut self, name: &str, value: &str) -> Self {
        self.notes.push((name.into(), value.into()));
        self
    }

    /// The value of a note.
    pub fn note(&self, name: &str) -> Option<&str> {
        self.notes.iter().find(|(note, _)| note == name).map(|(_, value)| value.as_str())
    }

    /// Reads a table of the repository. `how_to_make` is the command that writes it, for the error.
    pub fn read(path: &str, how_to_make: &str) -> Outcome<Self> {
        let text = fs::read_to_string(in_repository(path))
            .map_err(|error| format!("{path} cannot be read: {error}; `{how_to_make}` writes it"))?;
        Self::parse(&text).map_err(|error| format!("{path}: {error}; `{how_to_make}` writes it anew").into())
    }

    /// The table that a text holds.
    fn parse(text: &str) -> Result<Self, String> {
        let mut table = Self::default();
        for (index, line) in text.lines().enumerate() {
            if let Some(note) = line.strip_prefix("# ") {
                let (name, value) = note.split_once(": ").ok_or(format!("line {}: a note has no value", index + 1))?;
                table.notes.push((name.into(), value.into()));
                continue;
            }
            let cells: Vec<String> = line.split('\t').map(String::from).collect();
            if table.columns.is_empty() {
                table.columns = cells;
            } else if cells.len() == table.columns.len() {
                table.rows.push(cells);
            } else {
                return Err(format!("line {}: {} cells in {} columns", index + 1, cells.len(), table.columns.len()));
            }
        }
        if table.columns.is_empty() { Err("it has no columns".into()) } else { Ok(table) }
    }

    /// The text that holds the table.
    pub fn text(&self) -> String {
        let notes = self.notes.iter().map(|(name, value)| format!("# {name}: {value}\n"));
        let rows = std::iter::once(&self.columns).chain(&self.rows).map(|cells| cells.join("\t") + "\n");
        notes.chain(rows).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_comes_back() {
        let mut table = Table::new(&["what", "figure"]).with_note("compiler", "rustc 1: of 2020");
        table.rows.push(vec!["a, b".into(), "3".into()]);
        assert_eq!(Table::parse(&table.text()).as_ref(), Ok(&table));
        assert_eq!(table.note("compiler"), Some("rustc 1: of 2020"));
    }

    #[test]
    fn what_is_not_a_table_is_an_error() {
        for (text, told) in [
            ("", "it has no columns"),
            ("a\tb\n1\n", "line 2: 1 cells in 2 columns"),
            ("# a\n", "line 1: a note has no value"),
        ] {
            assert_eq!(Table::parse(text), Err(told.into()));
        }
    }
}
