//! What is wrong with programs.

use raylet_tables::Outcome;

/// An error with a line for each fault, if there is any.
pub fn none(faults: &[String]) -> Outcome {
    if faults.is_empty() { Ok(()) } else { Err(format!("\n    {}", faults.join("\n    ")).into()) }
}
