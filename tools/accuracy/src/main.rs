//! What accuracy costs in time: how wrong every tier in every number type is, against exact arithmetic, and how long it
//! takes.
//!
//! ```text
//! cargo run --release -p raylet-accuracy                 # tables and plots, in out/accuracy
//! cargo run --release -p raylet-accuracy -- --quick      # the same of few rays, to look at
//! cargo run --release -p raylet-accuracy -- --write      # renews everything that the repository shows
//! cargo run --release -p raylet-accuracy -- --page f32    # all rows of a number type, as they are stored
//! cargo run --release -p raylet-accuracy -- --bounds --only disc    # renews the bounds of a primitive
//! cargo run --release -p raylet-accuracy -- --check      # fails if a figure of errors is not what is measured
//! cargo run --release -p raylet-accuracy -- --broken     # the rays of which a tier's promise is broken, worst first
//! cargo run --release -p raylet-accuracy -- --search     # the same, searched from the worst random rays uphill
//! cargo run --release -p raylet-accuracy -- rays FILE --solid SOLID    # your own rays: docs/your-rays.md
//! ```
//!
//! | module | what it holds |
//! |---|---|
//! | `time` | times, by ratio to a reference in the same run |
//! | `broken` | rays of which a tier's promise is broken |
//! | `search` | such rays, searched |
//! | `rays` | errors of a file of rays at one solid |
//! | `sweep` | errors against distance and grazing |
//! | `chips` | instructions on microcontrollers, from the firmware's baselines |
//! | `study`, `stored` | all of these; times and sweeps as the repository stores them |
//! | `publish` | the tables and plots that are made of them |

mod broken;
mod chips;
#[cfg(test)]
mod documents_test;
mod publish;
mod rays;
mod search;
mod stored;
mod study;
mod sweep;
mod time;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Parser, Subcommand};
use indicatif::{ProgressBar, ProgressStyle};
use raylet_tables::page::difference;
use raylet_tables::print;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use study::{Study, Times};
use support::figures::{NUMBERS, Rays};
use support::subject::SUBJECTS;
use support::{bounds, figures, in_repository};

/// Measure how wrong each tier is in each number type, and how long it takes.
///
/// Without options everything is measured, which takes minutes, and pages and plots are written to the folder
/// out/accuracy. `rays` measures a solid and rays of your own instead. docs/accuracy.md explains every column.
///
/// Errors: every primitive (sphere, cone, ...) is met by several kinds of seeded rays. What the library answers is
/// compared with exact arithmetic on the very bits that the library received: the error of t, in units in the last
/// place and as a length, and wrong hits and misses. Errors are the same on every machine and in every run.
///
/// Times: of a nearest hit, as a ratio to the textbook's sphere in f32, which is timed by turns with it. They differ
/// from run to run, and no test depends on them. Beside them stand the instructions on four microcontrollers, which are
/// read from data/chips.
///
/// The rows named Textbook are the formulas of most textbooks in the same number type, for comparison with the
/// library's tiers.
#[derive(Parser)]
#[command(version, about, args_conflicts_with_subcommands = true)]
#[expect(clippy::struct_excessive_bools, reason = "switches of a command line")]
struct Options {
    #[command(subcommand)]
    command: Option<Command>,
    /// Measure few rays, and time them in few rounds: some seconds instead of minutes, to look at. The worst errors
    /// come out too small.
    #[arg(short, long, conflicts_with_all = ["write", "check", "document"])]
    quick: bool,
    /// How many rays to measure for each row of the tables; the published ones have 2000. Rows of placed solids take a
    /// quarter of them.
    #[arg(short, long, value_name = "COUNT", conflicts_with_all = ["write", "check", "document", "quick"])]
    rays: Option<usize>,
    /// Print all figures as JSON, and write no documents.
    #[arg(short, long, conflicts_with_all = ["write", "check", "document"])]
    json: bool,
    /// The folder to write the documents and plots to.
    #[arg(short, long, default_value = "out/accuracy", value_name = "FOLDER")]
    output: PathBuf,
    /// Write what was measured into the repository instead of a folder: the bounds that the tests hold the library to
    /// (data/bounds), data/times.tsv and data/sweeps.tsv, docs/plots/ and the tables of the README and of
    /// docs/overview.md, docs/accuracy.md and docs/which-one.md.
    #[arg(short, long, conflicts_with_all = ["check", "document"])]
    write: bool,
    /// Measure nothing, and write the tables and plots of the repository's pages again from the figures in data/: for
    /// use after a change of the chips' figures.
    #[arg(short, long)]
    document: bool,
    /// Measure nothing, and print figures in data/: the rows of a number type or a tier; what benign rays cost; placed
    /// solids by primitive; how often integers decide; surprises, which are rows in which more accuracy costs less, and
    /// combinations that others beat. `all` writes all of these and all plots to the folder of --output.
    #[arg(short, long, value_name = "NAME",
        value_parser = publish::names().into_iter().chain(["all"]).collect::<Vec<_>>(),
        conflicts_with_all = ["write", "document", "check", "json", "quick", "rays"])]
    page: Option<String>,
    /// Measure the errors, not the times, and compare the documents and plots of the repository with what they should
    /// be. Shows the lines that differ, and fails if there are any. Writes nothing.
    #[arg(short, long, conflicts_with = "document", group = "part")]
    check: bool,
    /// Measure the errors, and print each row in which a tier does not keep its promise: how many rays break it, and
    /// the worst of them, by its bits. Fails if there is such a row. Writes nothing.
    #[arg(short, long, conflicts_with_all = ["write", "document", "json", "quick"], group = "part")]
    broken: bool,
    /// Search for rays that break the promise of Stable or Exact. The search starts at the worst random rays of each
    /// row, changes a coordinate or the direction a little, and keeps what makes the error larger. Prints what it finds
    /// as --broken does, and fails if there is any. Writes nothing.
    #[arg(short, long, conflicts_with_all = ["write", "document", "json", "quick"], group = "part")]
    search: bool,
    /// Measure the errors of the primitives that --only names, and write only their rows into data/bounds, no
    /// documents: for a new primitive, whose times are measured later.
    #[arg(long, requires = "only", conflicts_with_all = ["write", "document", "json", "quick"], group = "part")]
    bounds: bool,
    /// Measure this primitive only; may be given several times. Needs --bounds, --check, --broken or --search. (--check
    /// takes the rows that are not measured from data/bounds.)
    #[arg(long, requires = "part", value_name = "PRIMITIVE", value_parser = SUBJECTS)]
    only: Vec<String>,
    /// Measure this number type only; may be given several times. Needs --broken or --search.
    #[arg(long, requires = "part", conflicts_with = "check", value_name = "NUMBER", ignore_case = true,
        value_parser = number(NUMBERS))]
    number: Vec<String>,
}

/// Parses the name of one of these number types, which may be written in either case.
fn number<const N: usize>(among: [&'static str; N]) -> impl TypedValueParser<Value = String> {
    PossibleValuesParser::new(among).map(move |given| {
        let named = among.into_iter().find(|name| name.eq_ignore_ascii_case(&given));
        named.map_or(given, String::from)
    })
}

/// What is measured instead of the published tables.
#[derive(Subcommand)]
enum Command {
    Rays(rays::Options),
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
    if let Some(Command::Rays(options)) = &options.command {
        return put(options.output(), rays::run(options)?);
    }
    let root = &in_repository("");
    if options.document {
        return put(root, publish::documents(&stored::study()?)?);
    }
    match options.page.as_deref() {
        Some("all") => return put(&options.output, publish::everything(&stored::study()?)?),
        Some(name) => return print(&publish::printed(&stored::study()?, name)),
        None => {}
    }
    if options.check {
        return check(root, &options.only);
    }
    if options.bounds {
        return put(root, bounds_of(&options.only)?);
    }
    let rays = options.rays.map_or(bounds::RAYS, Rays::new);
    if options.broken {
        return broken::report(&errors(rays, &options.only, &options.number)?);
    }
    if options.search {
        return search(&options.only, &options.number);
    }
    let (rays, rounds) = if options.quick { (Rays::new(40), 3) } else { (rays, 9) };
    let mut study = measure(rays, rounds)?;
    if options.json {
        return print(&study::as_json(&study));
    }
    if options.write {
        if let Ok(before) = stored::times() {
            study.times = stored::renewed(&before, study.times);
        }
        let tier = |tier: &&str| (bounds::path(tier), bounds::table(tier, &study.rows));
        let mut files: Vec<_> = figures::TIERS.iter().map(tier).collect();
        files.push((stored::TIMES.into(), stored::times_table(&study.times)));
        files.push((stored::SWEEPS.into(), stored::sweeps_table(&study.sweeps)));
        put(root, files)?;
        // A claim of a page that does not hold any more is an error: what was measured is written before.
        return put(root, publish::documents(&study)?);
    }
    let mut files = publish::everything(&study)?;
    files.push(("accuracy.json".into(), study::as_json(&study)));
    print(&publish::summary(&study))?;
    put(&options.output, files)
}

/// A bar that shows what is measured, and how long it will take.
fn bar(what: &'static str, length: usize) -> Result<ProgressBar, Box<dyn Error>> {
    let progress = ProgressBar::new(length as u64).with_message(what);
    progress.set_style(ProgressStyle::with_template("{msg:>7} {elapsed} {wide_bar} {pos}/{len} rows, {eta} left")?);
    Ok(progress)
}

/// True if it is one of the names, or if there are none.
fn is_named(names: &[String], name: &str) -> bool {
    names.is_empty() || names.iter().any(|it| it == name)
}

/// How many pairs of a primitive and a number type are named.
fn pairs(only: &[String], numbers: &[String]) -> usize {
    let count = |all: &[&str], names: &[String]| all.iter().filter(|name| is_named(names, name)).count();
    count(&NUMBERS, numbers) * count(&SUBJECTS, only)
}

/// Rays that break a promise, of every primitive and number type or of those named.
fn search(only: &[String], numbers: &[String]) -> Result<(), Box<dyn Error>> {
    let progress = bar("search", pairs(only, numbers) * search::TICKS)?;
    let wanted = |number: &str, primitive: &str| is_named(numbers, number) && is_named(only, primitive);
    let told = search::report(&wanted, &mut || progress.inc(1));
    progress.finish_and_clear();
    told
}

/// The rows of errors, of every primitive and number type or of those named.
fn errors(rays: Rays, only: &[String], numbers: &[String]) -> Result<Vec<figures::Figures>, Box<dyn Error>> {
    let progress = bar("errors", pairs(only, numbers) * figures::ticks())?;
    let wanted = |number: &str, primitive: &str| is_named(numbers, number) && is_named(only, primitive);
    let rows = figures::measure_all(rays, &wanted, &mut || progress.inc(1));
    progress.finish_and_clear();
    Ok(rows)
}

/// The tables of bounds, with the rows of these primitives measured anew.
fn bounds_of(only: &[String]) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let mut rows = bounds::all();
    rows.retain(|row| !only.iter().any(|name| name == row.primitive));
    rows.extend(errors(bounds::RAYS, only, &[])?);
    // A stable sort: workloads stay in order.
    let place = |all: &[&str], name: &str| all.iter().position(|it| *it == name);
    rows.sort_by_key(|row| (place(&NUMBERS, &row.number), place(&SUBJECTS, row.primitive)));
    Ok(figures::TIERS.iter().map(|tier| (bounds::path(tier), bounds::table(tier, &rows))).collect())
}

/// A point of a sweep has fewer rays than a row.
fn sweeps(rays: usize) -> Result<Vec<study::Point>, Box<dyn Error>> {
    let progress = bar("sweeps", sweep::TICKS)?;
    let points = sweep::measure(rays.div_ceil(4), &mut || progress.inc(1));
    progress.finish_and_clear();
    Ok(points)
}

fn times(rounds: usize) -> Result<Times, Box<dyn Error>> {
    let progress = bar("times", time::TICKS)?;
    let times = time::measure(rounds, &mut || progress.inc(1));
    progress.finish_and_clear();
    Ok(times)
}

fn measure(rays: Rays, rounds: usize) -> Result<Study, Box<dyn Error>> {
    if cfg!(debug_assertions) {
        eprintln!("note: times of a build without --release say little");
    }
    let chips = chips::read()?;
    let rows = errors(rays, &[], &[])?;
    let sweeps = sweeps(rays.unplaced)?;
    let times = times(rounds)?;
    Ok(Study::new(rays, rows, times, sweeps, chips))
}

/// Measures the errors anew and compares the documents with what they should be.
fn check(root: &Path, only: &[String]) -> Result<(), Box<dyn Error>> {
    let committed = stored::study()?;
    let measured = errors(bounds::RAYS, only, &[])?;
    let is_measured = |row: &figures::Figures| only.is_empty() || only.iter().any(|name| name == row.primitive);
    let mut fresh = measured.iter();
    let rows = committed.rows.iter().filter_map(|row| if is_measured(row) { fresh.next() } else { Some(row) });
    let mut rows: Vec<_> = rows.cloned().collect();
    rows.extend(fresh.cloned());
    let sweeps = if only.is_empty() { sweeps(bounds::RAYS.unplaced)? } else { committed.sweeps };
    let study = Study::new(bounds::RAYS, rows, committed.times, sweeps, committed.chips);
    let mut files = publish::documents(&study)?;
    files.push((stored::SWEEPS.into(), stored::sweeps_table(&study.sweeps)));
    let mut wrong = 0;
    for (path, wanted) in &files {
        let held = std::fs::read_to_string(root.join(path)).unwrap_or_default();
        if let Some(lines) = difference(&held, wanted) {
            println!("{path} (- as it is, + as measured):\n{lines}");
            wrong += 1;
        }
    }
    if wrong > 0 {
        let all = files.len();
        return Err(format!(
            "{wrong} of {all} documents are not what is measured; if the library is right, renew them: \
             cargo run --release -p raylet-accuracy -- --write"
        )
        .into());
    }
    println!("{} rows of errors and {} documents are as measured", measured.len(), files.len());
    Ok(())
}

/// Writes files into a folder.
fn put(folder: &Path, files: Vec<(String, String)>) -> Result<(), Box<dyn Error>> {
    for (path, text) in files {
        let path = folder.join(path);
        let told = |error| format!("{} cannot be written: {error}", path.display());
        std::fs::create_dir_all(path.parent().unwrap_or(folder)).map_err(told)?;
        std::fs::write(&path, text).map_err(told)?;
        print(&format!("written: {}\n", path.strip_prefix(in_repository("")).unwrap_or(&path).display()))?;
    }
    Ok(())
}
