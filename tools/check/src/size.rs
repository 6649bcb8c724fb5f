//! What one primitive, and one set of effects, takes of a chip's flash.

use crate::elf::Program;
use crate::sets::{KINDS, PRIMITIVES};
use crate::{effects, kinds, programs};
use raylet_tables::{Figures, Outcome};
use std::path::Path;

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
