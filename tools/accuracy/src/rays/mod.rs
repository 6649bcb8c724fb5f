//! The errors of one's own rays: a solid, a placement and a file of rays, from the same exact arithmetic as the
//! published tables.
//!
//! | module | what it holds |
//! |---|---|
//! | `solid`, `placement` | the solid and its placement, as they are written on the command line |
//! | `csv` | the file |
//! | `words`, `decimal` | what they are written in |
//! | `measured` | a row for each number type and way to answer |
//!
//! `publish::rays` makes the page, the plot and the JSON. The guide is docs/your-rays.md.

mod csv;
mod decimal;
pub mod measured;
mod placement;
mod solid;
#[cfg(test)]
mod tests;
mod words;

use crate::publish;
use clap::Args;
use measured::{Outcome, Task};
use raylet_tables::print;
use std::error::Error;
use std::path::PathBuf;
use support::figures::NUMBERS;

/// Solids and placements, as the help shows them.
fn forms() -> String {
    format!(
        "Example:\n  \
         raylet-accuracy rays tools/accuracy/examples/rays.csv --solid 'sphere radius 2' --placement 'at 1 2 3'\n\n\
         Solids: take one of these, with your own sizes. The axis of a solid is the y axis. Cylinders, capsules and\n\
         frustums stand on y = 0, a cone stands on its apex, the origin. A sphere, a cuboid, a rectangle, a disc\n\
         and a plane have their centre at the origin. The sizes of cuboids and rectangles are half extents. A slope\n\
         is the radius divided by the height.{}\n\n\
         Placements: take one of these, with your own numbers. `at` is the position. `axis`, `left`, `up` and\n\
         `forward` are the directions that the solid is turned to, `stretched` the factors along its own axes, and\n\
         `x`, `y`, `z` the vectors that its axes become.{}\n\n\
         The guide, with all columns of the table: docs/your-rays.md",
        words::list(&solid::EXAMPLES),
        words::list(&placement::EXAMPLES)
    )
}

/// Measure the errors of your own rays at a solid, in every number type and tier.
///
/// The table has the columns of docs/accuracy.md. It is printed, and written to the folder out/accuracy with a plot.
///
/// Sizes, coordinates and directions are decimal numbers. Each number type rounds them to what it stores, and the exact
/// answer is the one for the stored values: what is measured is the library's error, without that of rounding your
/// numbers. Rays that a number type cannot hold are counted in a column of their own.
///
/// A direction may have any length but zero. It is normalised and then rounded; but if its length is already 1, as far
/// as the number type can tell, it is taken as you wrote it.
#[derive(Args)]
#[command(after_help = forms())]
pub struct Options {
    /// The file of rays, comma-separated, one ray a line; `-` reads standard input.
    ///
    /// The columns are ox,oy,oz,dx,dy,dz: the origin and the direction. They may be followed by start,end: the range of
    /// t in which hits count; then by part,leaving for a ray that starts on the solid: the part that it leaves, and to
    /// which side, such as top,inwards. Cells of these four columns may be empty. A header, empty lines and lines that
    /// begin with # are allowed.
    #[arg(value_name = "FILE")]
    file: String,
    /// The solid and its sizes, such as 'cylinder capped radius 1 height 2'.
    #[arg(short, long, value_name = "SOLID")]
    solid: String,
    /// Where the solid stands, such as 'at 1 2 3 axis 0 0 1 stretched 2 1 0.5'. Without it, it stands in its own frame.
    #[arg(short, long, value_name = "PLACEMENT", default_value = "", hide_default_value = true)]
    placement: String,
    /// Measure this number type only; may be given several times. By default all are measured but I8F24 and I20F12.
    #[arg(short, long, value_name = "NUMBER", ignore_case = true, value_parser = crate::number(ALL_NUMBERS))]
    number: Vec<String>,
    /// Measure no times. What is printed and written is then the same in every run.
    #[arg(short, long)]
    errors_only: bool,
    /// Print all figures as JSON, and write no files.
    #[arg(short, long)]
    json: bool,
    /// The folder to write the page rays.md, the plot rays.svg and the figures rays.json to.
    #[arg(short, long, default_value = "out/accuracy", value_name = "FOLDER")]
    output: PathBuf,
}

impl Options {
    /// The folder of the output.
    pub fn output(&self) -> &std::path::Path {
        &self.output
    }

    /// The solid and the placement, as they were given.
    fn texts(&self) -> [&str; 2] {
        [self.solid.trim(), self.placement.trim()]
    }

    /// What is to be measured, of the file's text.
    fn task<'a>(&'a self, text: &'a str) -> Result<Task<'a>, String> {
        let is_wanted = |number: &&str| crate::is_named(&self.number, number);
        let solid = solid::parse(&self.solid).map_err(|error| format!("--solid: {error}"))?;
        let placement = placement::parse(&self.placement).map_err(|error| format!("--placement: {error}"))?;
        let lines = csv::parse(&self.file, text)?;
        csv::check_parts(&self.file, &lines, solid.name(), solid::parts(&solid))?;
        Ok(Task {
            file: &self.file,
            solid,
            placement,
            lines,
            numbers: if self.number.is_empty() {
                NUMBERS.to_vec()
            } else {
                ALL_NUMBERS.into_iter().filter(is_wanted).collect()
            },
            is_timed: !self.errors_only,
        })
    }
}

/// The number types that may be named: those of the tables, and other splits of 32 bits.
const ALL_NUMBERS: [&str; 6] = ["f32", "f64", "I16F16", "I32F32", "I8F24", "I20F12"];

/// Prints what was measured; the documents that are to be written, none with `--json`.
pub fn run(options: &Options) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let text = csv::read(&options.file)?;
    let task = options.task(&text)?;
    if task.is_timed && cfg!(debug_assertions) {
        eprintln!("note: times of a build without --release say little");
    }
    let progress = crate::bar("rays", task.lines.len() * task.numbers.len())?;
    let outcome: Result<Outcome, String> = task.measure(&mut || progress.inc(1));
    progress.finish_and_clear();
    let outcome = outcome?;
    if options.json {
        print(&publish::rays_as_json(&task, options.texts(), &outcome))?;
        return Ok(vec![]);
    }
    print(&publish::rays_summary(&task, options.texts(), &outcome))?;
    publish::rays_documents(&task, options.texts(), &outcome)
}
