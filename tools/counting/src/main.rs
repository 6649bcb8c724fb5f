//! How many instructions every query takes on this machine, counted by valgrind's callgrind: the same on every run.
//!
//! ```sh
//! .ci/instructions            # compares with data/host.tsv
//! .ci/instructions --renew    # makes what is counted the baseline, and writes the tables of docs/benches.md
//! cargo run --release -p raylet-counting -- --page    # prints all tables of the baseline
//! ```
//!
//! The script installs valgrind and says which compiler built this.

mod callgrind;
mod cost;
mod document;
mod workloads;

use clap::Parser;
use std::error::Error;
use std::process::ExitCode;

#[derive(Parser)]
#[command(about = "Counts the instructions of every query.")]
#[expect(clippy::struct_excessive_bools, reason = "switches of a command line")]
struct Arguments {
    /// What `rustc --version` says of the compiler that built this: another one than the baseline's may be up to 15 %
    /// worse.
    #[arg(long, required_unless_present_any = ["under_valgrind", "page", "document"])]
    compiler: Option<String>,
    /// Make what is counted the baseline, and write the tables of docs/benches.md.
    #[arg(long)]
    renew: bool,
    /// Count nothing, and print all tables of the baseline.
    #[arg(long)]
    page: bool,
    /// Count nothing, and write the tables of docs/benches.md.
    #[arg(long)]
    document: bool,
    /// Only run the queries.
    #[arg(long, hide = true)]
    under_valgrind: bool,
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    if arguments.page {
        return raylet_tables::print(&document::printed()?);
    }
    if arguments.document {
        return document::document();
    }
    let Some(compiler) = &arguments.compiler else {
        callgrind::run_queries();
        return Ok(());
    };
    let now = document::counted(compiler, callgrind::count()?);
    if arguments.renew { document::renew(&now) } else { document::verify(&now) }
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
