//! What must not be linked is not; and where it is on purpose, it is found.

use crate::elf::Program;
use crate::faults::none;
use crate::forbidden::Forbidden::{self, Allocator, Doubles, Formatting, Panic};
use raylet_tables::Outcome;
use std::path::Path;

/// A program that contains fewer bytes than this calls nothing of the library, and proves nothing.
const LEAST: u64 = 20_000;

/// The programs, and what must not be in them.
const PROOFS: [(&str, &[Forbidden]); 3] = [
    ("proof_all", &[Panic, Allocator, Formatting]),
    ("proof_f32", &[Panic, Allocator, Formatting, Doubles]),
    ("proof_reader", &[Panic, Allocator, Formatting]),
];

/// The program that does all of it, and what must be found there. (An allocator cannot be linked without the crate
/// `alloc`.)
const FAULTY: (&str, [Forbidden; 3]) = ("faulty", [Panic, Formatting, Doubles]);

/// Looks at all programs.
pub fn check(directory: &Path) -> Outcome {
    let mut faults = Vec::new();
    for (name, forbidden) in PROOFS {
        let program = Program::read(&directory.join(name))?;
        let is_of_raylet = program.symbols.iter().any(|symbol| symbol.name.contains("raylet::"));
        if program.bytes < LEAST || !is_of_raylet {
            faults.push(format!("{name}: nothing of raylet is in it, so that it proves nothing"));
        }
        let before = faults.len();
        for forbidden in forbidden {
            for symbol in program.symbols.iter().filter(|symbol| forbidden.is(&symbol.name)) {
                let mut fault = format!("{name}: {forbidden:?}: {}", symbol.name);
                for caller in &symbol.callers {
                    fault += "\n        in ";
                    fault += caller;
                }
                faults.push(fault);
            }
        }
        let verdict = if faults.len() == before { "without" } else { "NOT without" };
        println!("{name}: {} bytes, {} symbols, {verdict} {forbidden:?}", program.bytes, program.symbols.len());
    }
    let (name, expected) = FAULTY;
    let program = Program::read(&directory.join(name))?;
    for forbidden in expected {
        if !program.symbols.iter().any(|symbol| forbidden.is(&symbol.name)) {
            faults.push(format!("{name}: {forbidden:?} is in it and was not found: the proofs prove nothing"));
        }
    }
    println!("{name}: {expected:?} found, as they should be");
    none(&faults)
}
