//! Measures raylet beside its peers.
//!
//! ```text
//! cargo run --release --manifest-path tools/peers/Cargo.toml               # all rows that are stored
//! cargo run --release --manifest-path tools/peers/Cargo.toml -- --write    # measures, renews data/peers.tsv and docs
//! cargo run --release --manifest-path tools/peers/Cargo.toml -- --quick    # a few rays, to see that it works
//! ```

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use raylet_peers::document;
use raylet_peers::environment::Environment;
use raylet_peers::measure::{Plan, TICKS, measure};
use raylet_peers::speed::Effort;
use raylet_peers::stored::{self, PATH};
use raylet_tables::{in_repository, print};
use std::error::Error;
use std::process::ExitCode;

/// Puts the same rays to raylet, parry3d, embedded-3dgfx and the textbook: how fast is each, and how wrong?
///
/// Without options prints all rows that are stored in data/peers.tsv: times, and errors against exact arithmetic.
/// Errors are the same on every run; times are ratios taken within rounds of some 50 microseconds a contestant, so that
/// a busy machine disturbs them little.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Measure 100 rays in 3 rounds, to see that everything works, and print the rows; the times say little.
    #[arg(short, long, conflicts_with = "write")]
    quick: bool,
    /// Measure 2000 rays a row in 101 rounds, and write data/peers.tsv and the tables of docs/peers.md.
    #[arg(short, long)]
    write: bool,
    /// Measure nothing, and write the tables of docs/peers.md.
    #[arg(short, long, conflicts_with_all = ["write", "quick"])]
    document: bool,
}

/// Rays of a kind that are timed: few enough for the innermost cache, too many to be learnt by heart.
const TIMED: usize = 1000;

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
    if options.document {
        return document::write(false);
    }
    if !options.quick && !options.write {
        return print(&document::printed()?);
    }
    // Before the work, not after it.
    let environment = Environment::read()?;
    let (rays, rounds) = if options.quick { (100, 3) } else { (2000, 101) };
    let progress = ProgressBar::new((TICKS + of_users::TICKS) as u64);
    progress.set_style(ProgressStyle::with_template("{elapsed} {wide_bar} {pos}/{len} workloads, {eta} left")?);
    let plan = Plan { rays, effort: Effort { rays: rays.min(TIMED), rounds } };
    let users = of_users::rows(plan.effort, &mut || progress.inc(1));
    let rows = measure(plan, &mut || progress.inc(1));
    progress.finish_and_clear();
    let table = stored::table(&environment, &rows, users).text();
    if options.quick {
        return print(&table);
    }
    std::fs::write(in_repository(PATH), table).map_err(|error| format!("{PATH} cannot be written: {error}"))?;
    println!("written: {PATH}");
    document::write(false)
}

/// Without parry there is nobody beside whom the workloads of users could be measured.
#[cfg(not(feature = "parry"))]
mod of_users {
    pub const TICKS: usize = 0;

    pub fn rows(_: super::Effort, _: &mut dyn FnMut()) -> Vec<Vec<String>> {
        vec![]
    }
}

#[cfg(feature = "parry")]
mod of_users {
    pub use raylet_peers::users::TICKS;
    use raylet_peers::{stored, users};

    pub fn rows(effort: super::Effort, tick: &mut dyn FnMut()) -> Vec<Vec<String>> {
        stored::of_users(&users::measure(effort, tick))
    }
}
