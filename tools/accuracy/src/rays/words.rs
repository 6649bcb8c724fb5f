//! The words of a solid or a placement: names, each with the numbers that follow it. Commas are blanks.

use super::decimal::Decimal;

/// Forms to choose from, a line each, behind `give one of`.
pub fn list(forms: &[&str]) -> String {
    forms.iter().flat_map(|form| ["\n  ", form]).collect()
}

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
            let next = self.peek();
            let Some(word) = next.filter(|word| !is_missing(word)) else {
                let wanted = if N == 1 { "a number".into() } else { format!("{N} numbers") };
                let found = if index == 0 { "none".into() } else { index.to_string() };
                let before = next.map_or(String::new(), |word| format!(" before `{word}`"));
                return Err(format!("`{name}` takes {wanted}, and has {found}{before}"));
            };
            numbers.push(Decimal::parse(word).map_err(|error| format!("{name}: {error}"))?);
            self.next();
        }
        numbers.try_into().map_err(|_| format!("`{name}` takes {N} numbers"))
    }
}
