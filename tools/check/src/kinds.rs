//! What programs over chosen primitives and placements take of a chip's flash, and that a primitive or a placement that
//! is left out leaves no code.

use crate::elf::{self, Program};
use crate::faults::none;
use crate::programs;
use crate::sets::{NUMBERS, Use, uses};
use raylet_tables::{Figures, Outcome};
use std::collections::BTreeSet;
use std::path::Path;

/// The source files with the code of few kinds: who they belong to, and the number type, if they are of one.
const FILES: [(&str, &[&str], Option<&str>); 34] = [
    ("primitive/sphere", &["Sphere"], None),
    ("primitive/cylinder", &["Cylinder"], None),
    ("primitive/cone", &["Cone"], None),
    ("primitive/capsule", &["Capsule"], None),
    ("primitive/plane", &["Plane"], None),
    ("primitive/disc", &["Disc"], None),
    ("primitive/triangle", &["Triangle"], None),
    ("primitive/cuboid", &["Cuboid", "RoundedCuboid"], None),
    ("primitive/rectangle", &["Rectangle"], None),
    ("primitive/revolved", &["Revolved"], None),
    ("primitive/tube", &["Tube"], None),
    ("primitive/round_cone", &["RoundCone"], None),
    ("primitive/rounded_cuboid", &["RoundedCuboid"], None),
    ("primitive/annulus", &["Annulus"], None),
    ("primitive/prism", &["Prism"], None),
    ("primitive/polyhedron", &["Polyhedron"], None),
    ("primitive/torus", &["Torus"], None),
    ("affine", &["Affine"], None),
    ("solve/revolved", &["Revolved"], None),
    ("solve/tube", &["Tube"], None),
    ("solve/torus", &["Torus"], None),
    ("solve/quartic", &["Torus"], None),
    ("solve/newton", &["Torus"], None),
    ("solve/rounded", &["RoundedCuboid"], None),
    ("solve/side", &["Cylinder", "Cone", "Capsule", "Revolved", "Tube", "RoundCone"], None),
    ("solve/round", &["Sphere", "Cone", "Capsule", "RoundCone"], None),
    ("solve/flat", &["Plane", "Disc", "Annulus", "Rectangle", "Triangle"], None),
    ("solve/slabs", &["Cuboid", "Rectangle", "Prism", "Polyhedron"], None),
    ("solve/polyhedra", &["Prism", "Polyhedron"], None),
    ("scalar/integers/ball", &["Sphere", "Capsule"], Some("I16F16")),
    ("scalar/integers/round", &["Cylinder", "Capsule", "Tube"], Some("I16F16")),
    ("scalar/integers/cone", &["Cone"], Some("I16F16")),
    ("scalar/integers/triangle", &["Triangle"], Some("I16F16")),
    ("scalar/integers/bits32/stretched", &["Affine"], Some("I16F16")),
];

/// Where these files are.
const FOLDERS: [&str; 4] = ["src/primitive/", "src/solve/", "src/scalar/", "src/affine.rs"];

/// The name of a figure in a baseline.
pub fn key(of: &Use, number: &str) -> String {
    format!("{} | {number} | bytes", of.name)
}

/// Bytes of each program, over those of the empty program.
pub fn sizes(directory: &Path, empty: u64, figures: &mut Figures) -> Outcome {
    for of in uses() {
        for number in NUMBERS {
            let bytes = Program::read(&directory.join(programs::of_use(of.program, number)))?.bytes;
            figures.insert(key(of, number), bytes.saturating_sub(empty));
        }
    }
    Ok(())
}

/// The files of [`FILES`] that these kinds need in a number type.
fn files(number: &str, needs: impl Fn(&[&str]) -> bool) -> BTreeSet<String> {
    let own = FILES.iter().filter(|(_, kinds, only)| needs(kinds) && only.is_none_or(|only| only == number));
    own.map(|(file, ..)| format!("src/{file}.rs")).collect()
}

/// What is wrong with a program in which instructions of these files were found.
fn faults(program: &str, number: &str, kinds: &[&str], found: &BTreeSet<String>) -> Vec<String> {
    let named = files(number, |of| of.iter().any(|kind| kinds.contains(kind)));
    let (others, named) = (&files(number, |_| true) - &named, kinds.join(", "));
    let found = others.intersection(found);
    found.map(|file| format!("{program}: there are instructions of {file}, which is not of {named}")).collect()
}

/// Shows that no instruction of a program comes from a kind that it does not name, and that a program of any kind,
/// which names none, has some of each, so that they would be found.
pub fn check_left_out(directory: &Path) -> Outcome {
    let mut wrong = Vec::new();
    for number in NUMBERS {
        let any = programs::of_set("all", number);
        let found = elf::sources(&directory.join(&any), &FOLDERS)?;
        for file in files(number, |_| true).difference(&found) {
            wrong.push(format!("{any}: no instruction of {file}: the line tables prove nothing"));
        }
        for of in uses() {
            let program = programs::of_use(of.program, number);
            let found = elf::sources(&directory.join(&program), &FOLDERS)?;
            wrong.extend(faults(&program, number, of.kinds, &found));
            let own = files(number, |owners| owners.len() == 1 && of.kinds.contains(&owners[0]));
            for file in own.difference(&found) {
                wrong.push(format!("{program}: no instruction of {file}, which is of a kind that it names"));
            }
        }
    }
    none(&wrong)?;
    println!("{} programs with chosen kinds: only what was named is in them", uses().count() * NUMBERS.len());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sets::BALLS;

    fn found(files: &[&str]) -> BTreeSet<String> {
        files.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn what_is_not_named_is_a_fault() {
        let named = found(&["src/primitive/sphere.rs", "src/solve/round.rs", "src/solve/quadratic.rs"]);
        assert!(faults("balls", "f32", BALLS, &named).is_empty());
        let told = faults("balls", "f32", BALLS, &found(&["src/primitive/sphere.rs", "src/primitive/cone.rs"]));
        let cone = "balls: there are instructions of src/primitive/cone.rs, which is not of Sphere, Plane, Frame";
        assert_eq!(told, [cone]);
        // Everything that a program of any kind has, and no chosen kind may have.
        for number in NUMBERS {
            let every = files(number, |_| true);
            for of in uses() {
                assert!(faults(of.program, number, of.kinds, &every).len() > 6, "{} {number}", of.program);
            }
        }
    }

    #[test]
    fn a_file_is_there_and_belongs_to_a_kind() {
        for (file, kinds, _) in FILES {
            let path = raylet_tables::in_repository(&format!("src/{file}.rs"));
            assert!(path.exists() && !kinds.is_empty(), "{file}");
        }
    }
}
