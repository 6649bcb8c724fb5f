//! Words and their places. Line breaks are white space, except that they end a comment.

use super::error::Place;

/// A run of characters between white space and comments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word<'t> {
    pub(super) text: &'t str,
    pub(super) place: Place,
}

/// The rest of a text, and the place of its first character.
#[derive(Clone, Debug)]
pub(super) struct Lexer<'t> {
    rest: &'t str,
    place: Place,
}

impl<'t> Lexer<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        // Some editors put a byte order mark in front.
        let rest = text.strip_prefix('\u{feff}').unwrap_or(text);
        Self { rest, place: Place { line: 1, column: 1 } }
    }

    /// The next word, without taking it.
    pub(super) fn peek(&self) -> Option<Word<'t>> {
        self.clone().next()
    }

    /// Where the next character stands.
    pub(super) fn place(&self) -> Place {
        self.place
    }

    /// The bytes that are left.
    pub(super) fn remaining(&self) -> usize {
        self.rest.len()
    }

    fn skip_spaces_and_comments(&mut self) {
        let mut comment = false;
        let mut characters = self.rest.chars();
        while let Some(character) = characters.next() {
            match character {
                // A single carriage return ends a line too; followed by a line feed the two are one line end.
                '\n' | '\r' => comment = false,
                '#' => comment = true,
                other if comment || other.is_whitespace() => {}
                _ => return,
            }
            let ends_line = character == '\n' || character == '\r' && !characters.as_str().starts_with('\n');
            self.place = if ends_line {
                Place { line: self.place.line.saturating_add(1), column: 1 }
            } else {
                Place { column: self.place.column.saturating_add(1), ..self.place }
            };
            self.rest = characters.as_str();
        }
    }
}

impl<'t> Iterator for Lexer<'t> {
    type Item = Word<'t>;

    fn next(&mut self) -> Option<Word<'t>> {
        self.skip_spaces_and_comments();
        let [end, columns] = end_of_word(self.rest);
        let (text, rest) = self.rest.split_at_checked(end).filter(|(text, _)| !text.is_empty())?;
        let place = self.place;
        let columns = u32::try_from(columns).unwrap_or(u32::MAX);
        self.place.column = place.column.saturating_add(columns);
        self.rest = rest;
        Some(Word { text, place })
    }
}

/// How many bytes and how many characters there are up to the end of the word.
fn end_of_word(text: &str) -> [usize; 2] {
    let bytes = text.as_bytes();
    let end = bytes.iter().position(|byte| !byte.is_ascii_graphic() || *byte == b'#').unwrap_or(bytes.len());
    // Nearly all words are ASCII, with one byte for each character.
    if matches!(bytes.get(end), None | Some(b' ' | b'\t' | b'\n' | b'\r' | b'#')) {
        return [end; 2];
    }
    let end = text.find(|c: char| c.is_whitespace() || c == '#').unwrap_or(text.len());
    [end, text.get(..end).map_or(0, |word| word.chars().count())]
}

#[cfg(units)]
#[path = "../../../tests/units/scene/nff/lexer.rs"]
mod tests;
