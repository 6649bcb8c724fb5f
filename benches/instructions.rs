//! How many instructions every query takes on this machine, counted by valgrind's callgrind: the same on every run.
//!
//! ```sh
//! .ci/instructions            # compares with benches/baseline.json
//! .ci/instructions --renew    # makes what is counted the baseline, and writes docs/benches.md
//! ```
//!
//! The script sets how this is compiled; started by `cargo bench` alone, as among all benchmarks, it does nothing.
#![allow(missing_docs)]

mod cost;
mod counting;
#[path = "../examples/firmware/src/digest.rs"]
#[allow(dead_code)]
mod digest;

use clap::Parser;
use counting::baseline::Baseline;
use counting::{callgrind, document};
use std::error::Error;
use std::process::ExitCode;

#[derive(Parser)]
#[command(about = "Counts the instructions of every query.")]
struct Arguments {
    /// What `rustc --version` says of the compiler that built this: another one than the baseline's may be up to 15 % worse.
    #[arg(long)]
    compiler: Option<String>,
    /// Make what is counted the baseline, and write the document.
    #[arg(long)]
    renew: bool,
    /// Only ask the questions.
    #[arg(long, hide = true)]
    under_valgrind: bool,
    /// Cargo says so.
    #[arg(long, hide = true)]
    bench: bool,
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    if arguments.under_valgrind {
        callgrind::ask();
        return Ok(());
    }
    let Some(compiler) = &arguments.compiler else {
        println!("instructions are counted by .ci/instructions");
        return Ok(());
    };
    let now = Baseline::new(compiler, callgrind::count()?);
    if !arguments.renew {
        Baseline::read()?.compare(&now)?;
        return document::verify(&Baseline::read()?);
    }
    println!("{} figures in instructions: the baseline is renewed", now.figures.len());
    now.write()?;
    document::write(&now)
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
