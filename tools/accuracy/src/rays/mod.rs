//! The errors of one's own rays: a solid, a placement and a file of rays, from the same exact arithmetic as the published tables.
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
use std::error::Error;
use std::path::PathBuf;
use support::figures::NUMBERS;

/// Solids and placements, as the help shows them.
fn forms() -> String {
    format!(
        "Solids (axis y; they stand on y = 0, a cone on its apex; a sphere, a cuboid, a rectangle, a disc and a plane are about the origin; the sizes of cuboids and rectangles are half extents):{}\n\n\
         Placements (those of Frame and Affine; `x y z` are the images of the axes):{}\n\n\
         The guide: docs/your-rays.md",
        words::list(&solid::EXAMPLES),
        words::list(&placement::EXAMPLES)
    )
}

/// Measure the errors of your own rays at a solid: the table of the published pages, in every number type and tier.
///
/// Sizes, coordinates and directions are decimal numbers. Each number type rounds them to what it stores, and the exact answer is the one for
/// the stored values. A direction may have any length: it is normalised and then rounded, unless its length is 1 as far as the type
/// tells; then it is kept as it is written. Rays that a number type does not hold are counted apart.
#[derive(Args)]
#[command(after_help = forms())]
pub struct Options {
    /// The file: comma-separated values, a ray a line: ox,oy,oz,dx,dy,dz and if you like start,end of the range of t, and
    /// part,leaving of a ray that departs from the solid, such as top,inwards. A header and lines that begin with # are allowed. `-` is
    /// the standard input.
    #[arg(value_name = "FILE")]
    file: String,
    /// The solid and its sizes, such as 'cylinder capped radius 1 height 2'.
    #[arg(short, long, value_name = "SOLID")]
    solid: String,
    /// Where it stands, such as 'at 1 2 3 axis 0 0 1 stretched 2 1 0.5'. Without it the solid is not placed.
    #[arg(short, long, value_name = "PLACEMENT", default_value = "")]
    placement: String,
    /// This number type only. May be given several times.
    #[arg(short, long, value_name = "NUMBER", value_parser = NUMBERS)]
    number: Vec<String>,
    /// Leave the times out, which differ from run to run.
    #[arg(short, long)]
    errors_only: bool,
    /// Print everything as JSON instead of writing documents.
    #[arg(short, long)]
    json: bool,
    /// The folder that the page rays.md, the plot rays.svg and rays.json are written to.
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
            numbers: NUMBERS.into_iter().filter(is_wanted).collect(),
            is_timed: !self.errors_only,
        })
    }
}

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
        print!("{}", publish::rays_as_json(&task, options.texts(), &outcome));
        return Ok(vec![]);
    }
    print!("{}", publish::rays_summary(&task, options.texts(), &outcome));
    publish::rays_documents(&task, options.texts(), &outcome)
}
