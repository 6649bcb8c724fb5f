//! What one primitive, and one set of effects, takes of a chip's flash.

use crate::baseline::Figures;
use crate::effects;
use crate::elf::Program;
use std::error::Error;
use std::path::Path;

/// The primitives, as the programs of `sizes` are named.
pub const PRIMITIVES: [&str; 7] = ["sphere", "cylinder", "cone", "capsule", "plane", "disc", "triangle"];

/// Number types and tiers, likewise.
pub const KINDS: [[&str; 2]; 4] = [["f32", "Fast"], ["f32", "Stable"], ["I16F16", "Fast"], ["I16F16", "Stable"]];

/// The name of a figure in a baseline.
pub fn key(primitive: &str, [number, tier]: [&str; 2]) -> String {
    format!("{primitive} | {number} | {tier}")
}

/// Bytes over those of the empty program.
pub fn read(directory: &Path) -> Result<Figures, Box<dyn Error>> {
    let empty = Program::read(&directory.join("empty"))?.bytes;
    let mut figures = Figures::new();
    for primitive in PRIMITIVES {
        for [number, tier] in KINDS {
            let name = format!("{primitive}_{number}_{tier}").to_lowercase();
            let bytes = Program::read(&directory.join(name))?.bytes;
            figures.insert(key(primitive, [number, tier]), bytes.saturating_sub(empty));
        }
    }
    effects::sizes(directory, empty, &mut figures)?;
    Ok(figures)
}
