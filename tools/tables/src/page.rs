//! Pages that people write, with tables that programs write: what stands between `<!-- NAME: ABOUT -->` and
//! `<!-- /NAME -->`.

use crate::{Outcome, in_repository};
use std::fs;

/// A page with the tables between its marks written anew. `table` is asked for each mark: by its name, with what stands
/// behind the colon and what stands between the marks. A mark without an end is only asked for: it is a claim, and an
/// error if it does not hold.
pub fn filled(page: &str, mut table: impl FnMut(&str, &str, &str) -> Outcome<String>) -> Outcome<String> {
    const OPEN: &str = "<!-- ";
    const CLOSE: &str = "-->\n";
    let (mut text, mut rest) = (String::new(), page);
    while let Some(start) = rest.find(OPEN) {
        let Some(length) = rest[start..].find(CLOSE) else { break };
        let (mark, after) = rest.split_at(start + length + CLOSE.len());
        text.push_str(mark);
        rest = after;
        let inside = &mark[start + OPEN.len()..mark.len() - CLOSE.len()];
        let Some((name, about)) = inside.split_once(':') else { continue };
        let end = rest.find(&format!("{OPEN}/{name} -->"));
        let new = table(name, about.trim(), &rest[..end.unwrap_or(0)])?;
        if let Some(end) = end {
            text.push('\n');
            text.push_str(&new);
            rest = &rest[end..];
        }
    }
    Ok(text + rest)
}

/// A page of the repository with its tables written anew.
pub fn renewed(path: &str, table: impl FnMut(&str, &str, &str) -> Outcome<String>) -> Outcome<String> {
    filled(&fs::read_to_string(in_repository(path))?, table).map_err(|error| format!("{path}: {error}").into())
}

/// Writes a file of the repository, or says whether it is as it should be; `command` writes it.
pub fn put(path: &str, text: &str, verify: bool, command: &str) -> Outcome {
    if !verify {
        fs::write(in_repository(path), text)?;
        println!("written: {path}");
    } else if let Some(lines) = difference(&fs::read_to_string(in_repository(path))?, text) {
        return Err(format!("{path} is not what the figures in data say; `{command}` writes it:\n{lines}").into());
    } else {
        println!("{path} is what the figures in data say");
    }
    Ok(())
}

/// The lines that are only in one of two texts; `None` if they are equal.
pub fn difference(held: &str, wanted: &str) -> Option<String> {
    const SHOWN: usize = 24;
    let lines = |text: &str, other: &str, sign: &str| {
        let other: std::collections::HashSet<&str> = other.lines().collect();
        let only = text.lines().filter(|line| !other.contains(line));
        only.map(|line| format!("{sign} {}", line.chars().take(200).collect::<String>())).collect::<Vec<_>>()
    };
    if held == wanted {
        return None;
    }
    let all = [lines(held, wanted, "-"), lines(wanted, held, "+")].concat();
    let more = if all.len() > SHOWN { format!("\n  and {} more lines", all.len() - SHOWN) } else { String::new() };
    let order = if all.is_empty() { "the same lines in another order" } else { "" };
    Some(all.into_iter().take(SHOWN).collect::<Vec<_>>().join("\n") + &more + order)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_between_marks_is_replaced_and_nothing_else() {
        let page = "# A\n\n<!-- one: by x -->\nold\n<!-- /one -->\n\n<!-- a note -->\n<!-- claim: b -->\nend\n";
        let mut asked = vec![];
        let text = filled(page, |name, about, held| {
            asked.push(format!("{name} {about} {held}"));
            Ok("new\n\n".into())
        });
        assert_eq!(asked, ["one by x old\n", "claim b "]);
        assert_eq!(text.unwrap(), page.replace("old\n", "\nnew\n\n"));
    }

    #[test]
    fn a_claim_that_does_not_hold_is_an_error() {
        assert!(filled("<!-- claim: b -->\n", |_, _, _| Err("no".into())).is_err());
    }

    #[test]
    fn what_differs_is_told() {
        assert_eq!(difference("a\nb\n", "a\nb\n"), None);
        assert_eq!(difference("a\nb\n", "a\nc\n").as_deref(), Some("- b\n+ c"));
        assert!(difference("a\nb\n", "b\na\n").is_some());
    }
}
