//! Measures raylet beside its peers.
//!
//! ```text
//! cargo run --release --manifest-path tools/peers/Cargo.toml                   # the tables as Markdown
//! cargo run --release --manifest-path tools/peers/Cargo.toml -- --write        # renews docs/peers.md
//! cargo run --release --manifest-path tools/peers/Cargo.toml -- --quick        # a few rays, to see that it works
//! ```

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use raylet_peers::document::document;
use raylet_peers::environment::{self, Environment};
use raylet_peers::json::json;
use raylet_peers::measure::{Plan, TICKS, measure};
use raylet_peers::speed::Effort;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Puts the same rays to raylet, parry3d, embedded-3dgfx and the textbook: how fast is each, and how wrong?
///
/// Prints Markdown: the bars that raylet set itself and whether it reaches them, times, errors against exact
/// arithmetic, and all rows. Errors are the same on every run; times are ratios taken within rounds of some 50
/// microseconds a contestant, so that a busy machine disturbs them little.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Judge this many rays a row; docs/peers.md has 2000.
    #[arg(long, default_value_t = 2000, value_parser = clap::value_parser!(u32).range(1..))]
    rays: u32,
    /// Time this many rounds a row; docs/peers.md has 101.
    #[arg(long, default_value_t = 101, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
    /// 100 rays and 3 rounds, to see that everything works; the times say little.
    #[arg(short, long, conflicts_with_all = ["write", "rays", "rounds"])]
    quick: bool,
    /// Only what users do: placed solids and a range sensor, beside parry3d.
    #[arg(short, long, conflicts_with_all = ["write", "json"])]
    users: bool,
    /// Write the figures to this file as JSON, quartiles of the ratios included, instead of printing Markdown.
    #[arg(short, long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write docs/peers.md instead of printing it.
    #[arg(short, long)]
    write: bool,
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
    // Before the work, not after it.
    let environment = Environment::read()?;
    let (rays, rounds) = if options.quick { (100, 3) } else { (options.rays as usize, options.rounds as usize) };
    let progress = ProgressBar::new((TICKS + of_users::TICKS) as u64);
    progress.set_style(ProgressStyle::with_template("{elapsed} {wide_bar} {pos}/{len} workloads, {eta} left")?);
    let plan = Plan { rays, effort: Effort { rays: rays.min(TIMED), rounds } };
    let users = of_users::section(plan.effort, &mut || progress.inc(1));
    if options.users {
        progress.finish_and_clear();
        print!("{users}");
        return Ok(());
    }
    let rows = measure(plan, &mut || progress.inc(1));
    progress.finish_and_clear();
    if let Some(file) = &options.json {
        put(file, &json(&environment, &rows)?)?;
    }
    if options.write {
        put(&environment::root().join("docs/peers.md"), &document(&environment, &rows, &users))?;
    } else if options.json.is_none() {
        print!("{}", document(&environment, &rows, &users));
    }
    Ok(())
}

/// Without parry there is nobody beside whom the workloads of users could be measured.
#[cfg(not(feature = "parry"))]
mod of_users {
    pub const TICKS: usize = 0;

    pub fn section(_: super::Effort, _: &mut dyn FnMut()) -> String {
        String::new()
    }
}

#[cfg(feature = "parry")]
mod of_users {
    use raylet_peers::measure::beside_the_textbook;
    pub use raylet_peers::users::TICKS;
    use raylet_peers::{users, users_document};

    pub fn section(effort: super::Effort, tick: &mut dyn FnMut()) -> String {
        users_document::section(&beside_the_textbook(effort, |sphere| users::measure(effort, sphere, tick)))
    }
}

fn put(file: &Path, text: &str) -> Result<(), String> {
    std::fs::write(file, text).map_err(|error| format!("{} cannot be written: {error}", file.display()))?;
    println!("written: {}", file.display());
    Ok(())
}
