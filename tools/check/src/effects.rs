//! What effects cost: instructions, rays and stack of a pixel, by the programs `effects` and `gallery`; bytes, by the
//! programs of `sizes`; and that an effect left out leaves no code.

use crate::elf::{self, Program};
use crate::faults;
use crate::printed::rows;
use crate::programs;
use crate::sets::{NUMBERS, SETS};
use raylet_tables::{Figures, Outcome};
use serde::Deserialize;
use std::collections::BTreeSet;
use std::path::Path;

/// Which source files the code of an effect stands in.
const FILES: [(&str, &[&str]); 11] = [
    ("ambient", &["ambient"]),
    // One multiplication, for which the compiler does not always keep a line: see `TINY`.
    ("diffuse", &["diffuse"]),
    ("specular", &["specular"]),
    ("shadows", &["shadow"]),
    ("reflection", &["reflection", "cutoff"]),
    ("refraction", &["refraction", "reflection", "cutoff"]),
    ("texture", &["texture", "field"]),
    ("bump", &["bump", "field"]),
    ("fog", &["fog"]),
    ("antialiasing", &["antialiasing"]),
    ("outline", &["outline"]),
];

/// A file that may be without instructions of its own.
const TINY: &str = "diffuse";

/// Where these files are.
const FOLDER: &str = "src/effect/";

/// A gallery picture may have been drawn in any number type; these are measured.
pub const GALLERY_FIGURES: [&str; 2] = ["instructions", "rays"];

/// The name of a figure in a baseline.
pub fn key(set: &str, number: &str, figure: &str) -> String {
    format!("{set} | {number} | {figure}")
}

/// The name of a set in another tier than `Stable`.
fn in_tier(set: &str, tier: &str) -> String {
    if tier == "Stable" { set.into() } else { format!("{set}; {tier}") }
}

#[derive(Deserialize)]
struct Measured {
    instructions: u64,
    stack: u64,
    rays: u64,
    levels: u32,
}

#[derive(Deserialize)]
struct Row {
    set: String,
    tier: String,
    number: String,
    /// A scene of the gallery; empty for the four objects that all sets are measured by.
    scene: String,
    alone: Measured,
    /// Not in every tier.
    among_all: Option<Measured>,
}

/// What the program `effects` printed: each set alone, and among all.
///
/// An error if an effect that is compiled in and not called for changes a picture, or casts a ray.
pub fn read(path: &Path) -> Outcome<Figures> {
    let mut figures = Figures::new();
    for Row { set, tier, number, alone, among_all, .. } in rows(path)? {
        let row = in_tier(&set, &tier);
        figures.insert(key(&row, &number, "instructions"), alone.instructions);
        figures.insert(key(&row, &number, "stack"), alone.stack);
        let Some(among_all) = among_all else { continue };
        if (alone.levels, alone.rays) != (among_all.levels, among_all.rays) {
            return Err(format!("{row}, {number}: with all effects compiled in the picture or the rays differ").into());
        }
        figures.insert(key(&row, &number, "instructions among all"), among_all.instructions);
        figures.insert(key(&row, &number, "stack among all"), among_all.stack);
    }
    for (_, set) in SETS {
        if let Some(number) = NUMBERS.iter().find(|number| !figures.contains_key(&key(set, number, "stack"))) {
            return Err(format!("nothing was measured of {set} in {number}").into());
        }
    }
    Ok(figures)
}

/// What the programs `on_display_i16f16` and `on_display_f32` printed.
pub fn read_on_display(path: &Path) -> Outcome<Figures> {
    let row = |Row { set, tier, number, alone, scene, .. }: Row| {
        let of = if scene.is_empty() { set } else { scene };
        (key(&in_tier(&of, &tier), &number, "instructions"), alone.instructions)
    };
    Ok(rows(path)?.into_iter().map(row).collect())
}

#[derive(Deserialize)]
struct Picture {
    scene: String,
    number: String,
    measured: Measured,
}

/// What the program `gallery` printed.
pub fn read_gallery(path: &Path) -> Outcome<Figures> {
    let mut figures = Figures::new();
    for Picture { scene, number, measured } in rows(path)? {
        figures.insert(key(&scene, &number, GALLERY_FIGURES[0]), measured.instructions);
        figures.insert(key(&scene, &number, GALLERY_FIGURES[1]), measured.rays);
    }
    Ok(figures)
}

/// Bytes of a program that traces a pixel with a set of effects, over those of the empty program.
pub fn sizes(directory: &Path, empty: u64, figures: &mut Figures) -> Outcome {
    for (name, set) in SETS {
        for number in NUMBERS {
            let bytes = Program::read(&directory.join(programs::of_set(name, number)))?.bytes;
            figures.insert(key(set, number, "bytes"), bytes.saturating_sub(empty));
        }
    }
    Ok(())
}

/// Shows that no instruction of a program comes from an effect that is not in its set, and that each effect that is has
/// some.
pub fn check_left_out(directory: &Path) -> Outcome {
    let mut faults = Vec::new();
    for (name, set) in SETS {
        for number in NUMBERS {
            let program = programs::of_set(name, number);
            let found = elf::sources(&directory.join(&program), &[FOLDER])?;
            let ours: BTreeSet<_> = FILES.iter().flat_map(|(_, files)| *files).map(|file| path(file)).collect();
            let found: BTreeSet<_> = found.intersection(&ours).cloned().collect();
            let expected = expected(set);
            for file in found.difference(&expected) {
                faults.push(format!("{program}: there are instructions of {file}, which is not among {set}"));
            }
            for file in expected.difference(&found).filter(|file| **file != path(TINY)) {
                faults.push(format!("{program}: no instruction of {file}: the line tables prove nothing"));
            }
        }
    }
    faults::none(&faults)?;
    println!("{} programs with sets of effects: only what was named is in them", SETS.len() * NUMBERS.len());
    Ok(())
}

fn expected(set: &str) -> BTreeSet<String> {
    let files = set.split(", ").flat_map(|effect| FILES.iter().filter(move |(name, _)| *name == effect));
    files.flat_map(|(_, files)| *files).map(|file| path(file)).collect()
}

fn path(file: &str) -> String {
    format!("{FOLDER}{file}.rs")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_effect_brings_its_files() {
        assert!(expected("none").is_empty());
        assert_eq!(expected("diffuse, refraction").len(), 4);
        let every = FILES.iter().flat_map(|(_, files)| *files).collect::<BTreeSet<_>>().len();
        assert_eq!(expected(SETS[SETS.len() - 1].1).len(), every);
    }
}
