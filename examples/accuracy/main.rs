//! How wrong every tier in every number type is, measured against exact arithmetic.
//!
//! ```text
//! cargo run --release --example accuracy                 # the tables as Markdown
//! cargo run --release --example accuracy -- --json       # the same as JSON
//! cargo run --release --example accuracy -- --write      # renews the bounds, docs/accuracy.md and the README's table
//! ```

#[path = "../../tests/support/mod.rs"]
mod support;

mod document;

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use support::measure::{Figures, TICKS, measure_all};
use support::{bounds, table};

/// How wrong is each tier in each number type? Measured on every primitive and workload, against exact arithmetic on
/// the very bits that the library received. Errors of t in units in the last place.
#[derive(Parser)]
#[command(version, about)]
struct Options {
    /// Rays a row; the published tables have 2000.
    #[arg(short, long, default_value_t = bounds::RAYS)]
    rays: usize,
    /// Print JSON instead of Markdown.
    #[arg(short, long)]
    json: bool,
    /// Write what was measured as the new bounds (tests/support/bounds), as docs/accuracy.md, and into the table of the
    /// README.
    #[arg(short, long)]
    write: bool,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let progress = ProgressBar::new(TICKS as u64);
    progress.set_style(ProgressStyle::with_template("{elapsed} {wide_bar} {pos}/{len} rows, {eta} left")?);
    let rows = measure_all(options.rays, &mut || progress.inc(1));
    progress.finish_and_clear();
    if options.write {
        return write(&rows);
    }
    print!("{}", if options.json { document::json(&rows)? } else { table::document(&rows) });
    Ok(())
}

fn write(rows: &[Figures]) -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let put = |path: &str, text: String| -> Result<(), Box<dyn Error>> {
        std::fs::write(root.join(path), text).map_err(|error| format!("{path} cannot be written: {error}"))?;
        println!("written: {path}");
        Ok(())
    };
    for tier in ["Fast", "Stable", "Exact"] {
        put(&format!("tests/support/bounds/{}.rs", tier.to_lowercase()), bounds::source(tier, rows))?;
    }
    put("docs/accuracy.md", table::document(rows))?;
    let readme = std::fs::read_to_string(root.join("README.md"))?;
    put("README.md", table::in_readme(&readme, rows).ok_or("the README has no marks for its table")?)
}
