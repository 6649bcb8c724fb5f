//! What one primitive, and one set of effects, takes of a chip's flash.

use crate::elf::Program;
use crate::{effects, kinds, programs};
use raylet_tables::{Figures, Outcome};
use std::path::Path;

/// The primitives, and any of them as it is placed.
pub const PRIMITIVES: [&str; 10] =
    ["sphere", "cylinder", "cone", "capsule", "plane", "disc", "triangle", "cuboid", "rectangle", SHAPE];

/// Any primitive as it is placed.
pub const SHAPE: &str = "shape";

/// Number types and tiers.
pub const KINDS: [[&str; 2]; 8] = [
    ["f32", "Plain"],
    ["f32", "Fast"],
    ["f32", "Stable"],
    ["f32", "Exact"],
    ["I16F16", "Plain"],
    ["I16F16", "Fast"],
    ["I16F16", "Stable"],
    ["I16F16", "Exact"],
];

/// The name of a figure in a baseline.
pub fn key(primitive: &str, [number, tier]: [&str; 2]) -> String {
    format!("{primitive} | {number} | {tier}")
}

/// Bytes over those of the empty program.
pub fn read(directory: &Path) -> Outcome<Figures> {
    let empty = Program::read(&directory.join(programs::EMPTY))?.bytes;
    let mut figures = Figures::new();
    for primitive in PRIMITIVES {
        for [number, tier] in KINDS {
            let bytes = Program::read(&directory.join(programs::of_primitive(primitive, [number, tier])))?.bytes;
            figures.insert(key(primitive, [number, tier]), bytes.saturating_sub(empty));
        }
    }
    effects::sizes(directory, empty, &mut figures)?;
    kinds::sizes(directory, empty, &mut figures)?;
    Ok(figures)
}
