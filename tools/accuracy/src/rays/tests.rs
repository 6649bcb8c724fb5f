//! The promise: a file of rays at a solid is measured for the values that each number type stores, in every number type
//! and tier; what is wrong with a command or a file is told with its place and a remedy; and docs/your-rays.md shows
//! what the tool prints.

mod answers;
mod guide;
mod json;
mod refusals;
mod written;

use super::Options;
use super::measured::{Extra, Outcome};
use crate::publish;
use clap::Parser;
use support::figures::Figures;

/// The command line of the tool.
fn command(words: &[&str]) -> Options {
    let all = ["raylet-accuracy", "rays"].iter().chain(words);
    let options = crate::Options::try_parse_from(all).unwrap_or_else(|error| panic!("{words:?}: {error}"));
    let Some(crate::Command::Rays(options)) = options.command else { panic!("{words:?} is not `rays`") };
    options
}

/// A solid and a placement, not timed.
fn at(solid: &str, placement: &str) -> Options {
    command(&["my.csv", "--errors-only", "--solid", solid, "--placement", placement])
}

fn measured(options: &Options, text: &str) -> Result<Outcome, String> {
    options.task(text)?.measure(&mut || ())
}

fn json_of(options: &Options, text: &str) -> serde_json::Value {
    let task = options.task(text).unwrap();
    let outcome = task.measure(&mut || ()).unwrap();
    serde_json::from_str(&publish::rays_as_json(&task, options.texts(), &outcome)).unwrap()
}

impl Outcome {
    /// The row of a number type and tier.
    fn row(&self, number: &str, tier: &str) -> (&Figures, &Extra) {
        let mut rows = self.study.rows.iter().zip(&self.extras);
        rows.find(|(row, _)| row.number == number && row.tier == tier).unwrap_or_else(|| panic!("{number} {tier}"))
    }
}
