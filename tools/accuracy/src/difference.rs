//! How a document differs from what it should be.

/// So many lines are shown.
const SHOWN: usize = 24;

/// The lines that are only in one of the two; `None` if they are equal.
///
/// Lines are matched in order, each with the next equal one nearby: rows of tables change in place.
pub fn between(held: &str, wanted: &str) -> Option<String> {
    if held == wanted {
        return None;
    }
    let (held, wanted): (Vec<_>, Vec<_>) = (held.lines().collect(), wanted.lines().collect());
    let (mut i, mut j) = (0, 0);
    let mut lines = vec![];
    while i < held.len() || j < wanted.len() {
        match (held.get(i), wanted.get(j)) {
            (Some(a), Some(b)) if a == b => (i, j) = (i + 1, j + 1),
            (Some(a), Some(b)) => {
                let near = 200;
                let gone = held[i..].iter().take(near).position(|line| line == b);
                let new = wanted[j..].iter().take(near).position(|line| line == a);
                if gone.is_none_or(|gone| new.is_some_and(|new| new <= gone)) && new.is_some() {
                    lines.push(format!("+ {b}"));
                    j += 1;
                } else if gone.is_some() {
                    lines.push(format!("- {a}"));
                    i += 1;
                } else {
                    lines.push(format!("- {a}"));
                    lines.push(format!("+ {b}"));
                    (i, j) = (i + 1, j + 1);
                }
            }
            (Some(a), None) => {
                lines.push(format!("- {a}"));
                i += 1;
            }
            (None, Some(b)) => {
                lines.push(format!("+ {b}"));
                j += 1;
            }
            (None, None) => break,
        }
    }
    let more = lines.len().saturating_sub(SHOWN);
    // Plots have lines of any length.
    let cut = |line: String| line.chars().take(200).collect::<String>();
    let mut text: Vec<_> = lines.into_iter().take(SHOWN).map(cut).collect();
    if more > 0 {
        text.push(format!("  and {more} more lines"));
    }
    Some(text.join("\n"))
}
