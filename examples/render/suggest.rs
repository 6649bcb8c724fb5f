//! What somebody meant who wrote something else.

/// The name that is most like the word, if any is like it: one that starts with it or that few changes make of it.
pub(crate) fn nearest<'n>(word: &str, names: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let word = word.to_lowercase().replace(['_', ' '], "-");
    let distance = |name: &&'n str| {
        let starts_with = word.len() > 1 && name.starts_with(&word);
        if starts_with { 0 } else { changes(&word, name) }
    };
    let nearest = names.into_iter().min_by_key(distance)?;
    (distance(&nearest) <= nearest.chars().count() / 3).then_some(nearest)
}

/// How many letters must be put in, taken out or replaced to make one word the other (Levenshtein 1965).
fn changes(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, b) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(a != *b);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_name_is_suggested_for_what_is_like_it_and_for_nothing_else() {
        let names = ["still-life", "patterns", "glass", "waves", "water", "quadrics", "raystones"];
        for (word, expected) in [
            ("glas", Some("glass")),
            ("GLASS", Some("glass")),
            ("pattern", Some("patterns")),
            ("still", Some("still-life")),
            ("still_life", Some("still-life")),
            ("wavse", None),
            ("wave", Some("waves")),
            ("teapot", None),
            ("", None),
        ] {
            assert_eq!(nearest(word, names), expected, "{word}");
        }
        assert_eq!(nearest("x", []), None);
    }
}
