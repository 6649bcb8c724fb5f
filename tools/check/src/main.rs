//! Looks at what the firmware programs are made of and at what they print, and says whether it got worse.
//!
//! ```sh
//! check programs                                   # writes the programs that `check size` and `check left-out` read
//! check proofs DIRECTORY                           # what must not be linked is not
//! check cost --target TARGET OUTPUT [--renew]      # instructions a query, against the baseline
//! check size --target TARGET DIRECTORY [--renew]   # bytes a primitive, against the baseline
//! check left-out DIRECTORY                         # an effect, a kind or a tier that is left out leaves no code
//! check effects --target TARGET OUTPUT [--renew]   # instructions and stack a pixel, against the baseline
//! check gallery --target TARGET OUTPUT [--renew]   # instructions a pixel of the gallery, against the baseline
//! check cost --cycles most ...                     # the same of modelled cycles (least: the other end of ranges)
//! check document [--verify]                        # the tables of docs/microcontrollers.md and docs/gallery.md
//! check page CHIP                                  # prints every table of a chip, such as Cortex-M3
//! ```

mod chip;
mod cost;
mod document;
mod effects;
mod elf;
mod faults;
mod forbidden;
mod frames;
mod kinds;
mod printed;
mod programs;
mod proofs;
mod sets;
mod size;
mod tiers;

use chip::{Chip, Part};
use clap::{Parser, Subcommand};
use raylet_tables::Outcome;
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(Parser)]
#[command(about = "Looks at what the firmware programs are made of and at what they print.")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Writes the programs of `tools/firmware/sizes`, which `size` and `left-out` read when they are built.
    Programs,
    /// Shows that no panic, no allocator, no formatting and no operation on doubles was linked where none may be.
    Proofs {
        /// Where cargo put the programs: `target/TARGET/release`.
        programs: PathBuf,
    },
    /// Compares instructions a query with the baseline.
    Cost {
        #[command(flatten)]
        chip: Chip,
        /// What the program `cost` printed.
        output: PathBuf,
    },
    /// Compares bytes a primitive with the baseline.
    Size {
        #[command(flatten)]
        chip: Chip,
        /// Where cargo put the programs: `target/TARGET/release`.
        programs: PathBuf,
    },
    /// Shows that an effect, a primitive, a placement or a tier that is left out leaves no code.
    LeftOut {
        /// Where cargo put the programs: `target/TARGET/release`.
        programs: PathBuf,
    },
    /// Compares what sets of effects cost a pixel with the baseline.
    Effects {
        #[command(flatten)]
        chip: Chip,
        /// What the program `effects` printed.
        output: PathBuf,
    },
    /// Compares what users' queries cost with the baseline.
    Workloads {
        #[command(flatten)]
        chip: Chip,
        /// What the program `workloads` printed.
        output: PathBuf,
    },
    /// Compares what the pictures of the gallery cost with the baseline.
    Gallery {
        #[command(flatten)]
        chip: Chip,
        /// What the program `gallery` printed.
        output: PathBuf,
    },
    /// Compares what pixels of a display cost with the baseline.
    Display {
        #[command(flatten)]
        chip: Chip,
        /// What the programs `on_display_i16f16` and `on_display_f32` printed.
        output: PathBuf,
    },
    /// Compares what the frames of the animation `bounce` take with the baseline.
    Frames {
        #[command(flatten)]
        chip: Chip,
        /// What the program `bounce` printed.
        output: PathBuf,
    },
    /// Prints every table of a chip.
    Page {
        /// Its name or its target: Cortex-M0+, Cortex-M3, Cortex-M4F, RV32IMC.
        chip: String,
    },
    /// Writes the tables of the pages from the baselines.
    Document {
        /// Only say whether it is as it should be.
        #[arg(long)]
        verify: bool,
    },
}

fn run(command: &Command) -> Outcome {
    match command {
        Command::Programs => programs::write(),
        Command::Proofs { programs } => proofs::check(programs),
        Command::Cost { chip, output } => chip::check(chip, Part::Cost, cost::read(output)?),
        Command::Workloads { chip, output } => chip::check(chip, Part::Workload, cost::read_workloads(output)?),
        Command::Size { chip, programs } => chip::check(chip, Part::Size, size::read(programs)?),
        Command::LeftOut { programs } => {
            effects::check_left_out(programs)?;
            kinds::check_left_out(programs)?;
            tiers::check(programs)
        }
        Command::Effects { chip, output } => chip::check(chip, Part::Effects, effects::read(output)?),
        Command::Gallery { chip, output } => chip::check(chip, Part::Gallery, effects::read_gallery(output)?),
        Command::Display { chip, output } => chip::check(chip, Part::Display, effects::read_on_display(output)?),
        Command::Frames { chip, output } => chip::check(chip, Part::Frames, frames::read(output)?),
        Command::Page { chip } => raylet_tables::print(&document::printed(chip)?),
        Command::Document { verify } => document::write(*verify),
    }
}

fn main() -> ExitCode {
    match run(&Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
