//! What the frames of the animation `bounce` take: the rows that are drawn, and instructions.

use raylet_tables::{Figures, Outcome};
use std::fs;
use std::path::Path;

/// How many frames the program draws.
const FRAMES: usize = 6;

/// The name of a figure in a baseline.
pub fn key(frame: usize, figure: &str) -> String {
    format!("frame {frame} | {figure}")
}

/// The numbers of all frames that a baseline knows.
pub fn known(figures: &Figures) -> impl Iterator<Item = usize> {
    (0..).take_while(|frame| figures.contains_key(&key(*frame, "rows")))
}

/// What the program printed: `frame 0: 710dc9aa 128 of 128 rows, 9 instructions`, and lines of other things.
///
/// An error if a line about a frame is another, or a frame is missing.
pub fn read(path: &Path) -> Outcome<Figures> {
    let mut figures = Figures::new();
    let text = fs::read_to_string(path)?;
    for line in text.lines().filter(|line| line.starts_with("frame ")) {
        let words: Vec<_> = line.split([' ', ':', ',']).filter(|word| !word.is_empty()).collect();
        let ["frame", frame, _digest, rows, "of", _, "rows", instructions, "instructions"] = words[..] else {
            return Err(format!("no frame of `bounce`: {line}").into());
        };
        let frame = frame.parse()?;
        figures.insert(key(frame, "rows"), rows.parse()?);
        figures.insert(key(frame, "instructions"), instructions.parse()?);
    }
    match known(&figures).count() {
        FRAMES => Ok(figures),
        count => Err(format!("{}: {count} frames of {FRAMES}", path.display()).into()),
    }
}
