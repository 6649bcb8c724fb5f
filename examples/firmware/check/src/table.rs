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
    row(text, titles.iter().cloned());
    let _ = writeln!(text, "|---|{}", "---:|".repeat(titles.len() - 1));
}

#[cfg(test)]
mod tests {
    use crate::grouped::grouped;

    #[test]
    fn thousands_are_grouped() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
    }
}
