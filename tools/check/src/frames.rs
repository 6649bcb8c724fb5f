//! What the frames of the animation `bounce` take, in instructions; the rows that they draw are in its expected output.

use raylet_tables::{Figures, Outcome, in_repository};
use std::fs;
use std::path::Path;

/// What each of the first frames gives on every chip: `710dc9aa 128 of 128 rows`.
const EXPECTED: &str = "examples/firmware/expected/bounce.txt";

/// The name of a frame's figure in a baseline.
pub fn key(frame: usize) -> String {
    format!("frame {frame} | instructions")
}

/// How many rows each frame draws.
pub fn rows() -> Outcome<Vec<u64>> {
    let text = fs::read_to_string(in_repository(EXPECTED))?;
    let rows = |line: &str| match line.split(' ').collect::<Vec<_>>()[..] {
        [_digest, rows, "of", _, "rows"] => Ok(rows.parse()?),
        _ => Err(format!("{EXPECTED}: no frame of `bounce`: {line}").into()),
    };
    text.lines().map(rows).collect()
}

/// What the program printed.
pub fn read(path: &Path) -> Outcome<Figures> {
    parsed(&fs::read_to_string(path)?, rows()?.len())
}

/// Instructions from lines such as `frame 0: 710dc9aa 128 of 128 rows, 9 instructions`, among lines of other things.
///
/// An error if a line about a frame is another, or there are not so many frames.
fn parsed(text: &str, frames: usize) -> Outcome<Figures> {
    let mut figures = Figures::new();
    for line in text.lines().filter(|line| line.starts_with("frame ")) {
        let words: Vec<_> = line.split([' ', ':', ',']).filter(|word| !word.is_empty()).collect();
        let ["frame", frame, _digest, _rows, "of", _, "rows", instructions, "instructions"] = words[..] else {
            return Err(format!("no frame of `bounce`: {line}").into());
        };
        figures.insert(key(frame.parse()?), instructions.parse()?);
    }
    if figures.len() != frames || !(0..frames).all(|frame| figures.contains_key(&key(frame))) {
        return Err(format!("`bounce` printed {} frames, and not the first {frames}", figures.len()).into());
    }
    Ok(figures)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_read_or_refused() {
        let printed =
            "frame 0: 710dc9aa 128 of 128 rows, 9 instructions\nframe 1: 00000001 2 of 128 rows, 7 instructions\n";
        let figures = parsed(&format!("{printed}stack 4 bytes\n"), 2).unwrap();
        assert_eq!(figures.into_iter().collect::<Vec<_>>(), [(key(0), 9), (key(1), 7)]);
        assert_eq!(parsed(printed, 3).unwrap_err().to_string(), "`bounce` printed 2 frames, and not the first 3");
        let error = parsed("frame 0: 9 instructions", 1).unwrap_err().to_string();
        assert_eq!(error, "no frame of `bounce`: frame 0: 9 instructions");
    }

    #[test]
    fn the_first_frame_draws_all_rows() {
        assert_eq!(rows().unwrap().first(), Some(&128));
    }
}
