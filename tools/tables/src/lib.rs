//! The measured tables of the repository: how they are stored (`data/`), compared with what was measured before, and
//! shown.
//!
//! | module | what it holds |
//! |---|---|
//! | `table`, `baseline` | tables of `data`, and figures of one machine |
//! | `markdown`, `pivot` | figures as tables of a page |
//! | `page` | pages with such tables between marks |
//! | `names`, `grouped` | names that several tables have, and figures for people to read |
// Every error is text for whoever runs the tool.
#![expect(clippy::missing_errors_doc, reason = "every error is a file that cannot be read, and says which")]

mod baseline;
mod grouped;
pub mod markdown;
mod names;
pub mod page;
mod pivot;
mod table;

pub use baseline::{Baseline, Figures};
pub use grouped::grouped;
pub use names::{CHIPS, SUBJECTS};
pub use pivot::{Cell, Place, joined, mean_and_worst, pivot, together};
pub use table::Table;

use std::io::Write;
use std::path::{Path, PathBuf};

/// What can go wrong, for people to read.
pub type Outcome<T = ()> = Result<T, Box<dyn std::error::Error>>;

/// Prints a text. A reader that closes the pipe has read enough.
pub fn print(text: &str) -> Outcome {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// A file of the repository, by its path from the root.
pub fn in_repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}
