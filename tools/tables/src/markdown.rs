//! Tables in Markdown.

use std::fmt::Write;

/// A row.
pub fn row(text: &mut String, cells: impl IntoIterator<Item = String>) {
    let cells: Vec<_> = cells.into_iter().collect();
    let _ = writeln!(text, "| {} |", cells.join(" | "));
}

/// The titles; all columns but the first are figures.
pub fn head(text: &mut String, titles: impl IntoIterator<Item = String>) {
    let titles: Vec<_> = titles.into_iter().collect();
    let figures = "---:|".repeat(titles.len().saturating_sub(1));
    row(text, titles);
    let _ = writeln!(text, "|---|{figures}");
}
