//! The words of a solid or a placement: names, each with the numbers that follow it. Commas are blanks.

use super::decimal::Decimal;

/// What is left to read.
pub struct Words<'a> {
    words: std::iter::Peekable<Box<dyn Iterator<Item = &'a str> + 'a>>,
}

impl<'a> Words<'a> {
    pub fn new(text: &'a str) -> Self {
        let words: Box<dyn Iterator<Item = &'a str> + 'a> =
            Box::new(text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty()));
        Self { words: words.peekable() }
    }

    pub fn next(&mut self) -> Option<&'a str> {
        self.words.next()
    }

    pub fn peek(&mut self) -> Option<&'a str> {
        self.words.peek().copied()
    }

    /// So many numbers, which belong to `name`.
    pub fn numbers<const N: usize>(&mut self, name: &str) -> Result<[Decimal<'a>; N], String> {
        let mut numbers = vec![];
        for index in 0..N {
            // A name where a number should be is one that is missing.
            let is_missing = |word: &str| word.chars().all(|c| c.is_ascii_alphabetic() || c == '-') && word != "-";
            let Some(word) = self.peek().filter(|word| !is_missing(word)) else {
                let wanted = if N == 1 { "a number".into() } else { format!("{N} numbers") };
                let found = if index == 0 { "none".into() } else { index.to_string() };
                return Err(format!("`{name}` takes {wanted}, and has {found}"));
            };
            numbers.push(Decimal::parse(word).map_err(|error| format!("{name}: {error}"))?);
            self.next();
        }
        numbers.try_into().map_err(|_| format!("`{name}` takes {N} numbers"))
    }
}
