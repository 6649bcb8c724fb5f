//! The programs of `tools/firmware/sizes`: one for each row of the tables of sizes, and an empty one.

use crate::sets::{KINDS, NUMBERS, PRIMITIVES, SETS, uses};
use raylet_tables::{Outcome, in_repository};
use std::collections::BTreeMap;
use std::fs;

/// Where cargo looks for the programs; nothing else is there.
const FOLDER: &str = "tools/firmware/sizes/src/bin";

/// The program that does nothing.
pub const EMPTY: &str = "empty";

/// The program that finds the nearest hit of a primitive.
pub fn of_primitive(primitive: &str, [number, tier]: [&str; 2]) -> String {
    format!("{primitive}_{number}_{tier}").to_lowercase()
}

/// The program that traces a pixel with a set of effects.
pub fn of_set(set: &str, number: &str) -> String {
    format!("effects_{set}_{number}").to_lowercase()
}

/// The program that uses chosen kinds.
pub fn of_use(program: &str, number: &str) -> String {
    format!("{program}_{number}").to_lowercase()
}

/// The type of a primitive or an effect: the words of its name with capitals, joined.
fn type_name(name: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    };
    name.split('_').map(capital).collect()
}

/// The type of a set of effects, and what it takes from `raylet::effect`.
fn set_type(name: &str, effects: &str) -> (String, Vec<String>) {
    match name {
        "none" => ("()".into(), vec![]),
        "all" => ("All".into(), vec!["All".into()]),
        _ => {
            let types: Vec<_> = effects.split(", ").map(type_name).collect();
            let comma = if types.len() == 1 { "," } else { "" };
            (format!("({}{comma})", types.join(", ")), types)
        }
    }
}

/// What a program takes from a module, in alphabetical order; `None` if it takes nothing.
fn taken(module: &str, mut names: Vec<String>) -> Option<String> {
    names.sort();
    match &names[..] {
        [] => None,
        [name] => Some(format!("use {module}::{name};\n")),
        names => Some(format!("use {module}::{{{}}};\n", names.join(", "))),
    }
}

/// The text of a program: what it is, the kinds and effects that it names, and the macro of `raylet-sizes` that makes
/// it.
fn text(what: &str, number: Option<&str>, [kinds, effects]: [Vec<String>; 2], program: &str) -> String {
    let number = number.filter(|number| number.starts_with('I')).map(|number| format!("use fixed::types::{number};\n"));
    let taken = [taken("raylet::effect", effects), taken("raylet", kinds)];
    let uses: String = number.into_iter().chain(taken.into_iter().flatten()).collect();
    let gap = if uses.is_empty() { "" } else { "\n" };
    format!("//! {what}.\n#![no_std]\n#![no_main]\n\n{uses}{gap}raylet_sizes::{program};\n")
}

/// The texts of all programs, by name.
fn all() -> BTreeMap<String, String> {
    let mut programs = BTreeMap::from([(EMPTY.into(), text("Nothing", None, Default::default(), "empty!()"))]);
    for primitive in PRIMITIVES {
        for [number, tier] in KINDS {
            let what = format!("The nearest hit: {primitive}, {number}, {tier}");
            let program = format!("nearest!({}<{number}>, {tier})", type_name(primitive));
            programs.insert(
                of_primitive(primitive, [number, tier]),
                text(&what, Some(number), Default::default(), &program),
            );
        }
    }
    for (name, effects) in SETS {
        for number in NUMBERS {
            let what = format!("A pixel: {effects}; {number}");
            let (set, effects) = set_type(name, effects);
            let program = format!("pixel!({number}, {set})");
            programs.insert(of_set(name, number), text(&what, Some(number), [vec![], effects], &program));
        }
    }
    for (of, number) in uses().flat_map(|of| NUMBERS.map(|number| (of, number))) {
        let what = format!("{}: {}; {number}", of.name, of.kinds.join(", "));
        let types: Vec<_> = of.kinds.iter().map(|kind| format!("{kind}<{number}>")).collect();
        let (set, effects) = of.effects.map_or_else(Default::default, |set| set_type(set, set));
        let set = if set.is_empty() { set } else { format!(", {set}") };
        let program = format!("{}!({number}, ({}){set})", of.made_by, types.join(", "));
        let named = of.kinds.iter().map(ToString::to_string).collect();
        programs.insert(of_use(of.program, number), text(&what, Some(number), [named, effects], &program));
    }
    programs
}

/// Writes the programs, and removes those that there were before. A program that is as it should be is not touched, so
/// that cargo does not build it again.
pub fn write() -> Outcome {
    let (folder, programs) = (in_repository(FOLDER), all());
    fs::create_dir_all(&folder)?;
    for file in fs::read_dir(&folder)? {
        let path = file?.path();
        let name = path.file_stem().and_then(|name| name.to_str());
        if !name.is_some_and(|name| programs.contains_key(name)) {
            fs::remove_file(path)?;
        }
    }
    for (name, text) in &programs {
        let path = folder.join(name).with_extension("rs");
        if !fs::read_to_string(&path).is_ok_and(|there| there == *text) {
            fs::write(path, text)?;
        }
    }
    println!("{} programs are in {FOLDER}", programs.len());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_has_a_program_of_its_own() {
        assert_eq!(all().len(), 1 + PRIMITIVES.len() * KINDS.len() + (SETS.len() + uses().count()) * NUMBERS.len());
    }

    #[test]
    fn a_program_uses_what_its_row_names() {
        let programs = all();
        let body = |name: &str| programs[name].split_once("#![no_main]\n\n").map(|(_, body)| body);
        for (name, expected) in [
            ("empty", "raylet_sizes::empty!();\n"),
            ("cone_i16f16_stable", "use fixed::types::I16F16;\n\nraylet_sizes::nearest!(Cone<I16F16>, Stable);\n"),
            ("effects_none_f32", "raylet_sizes::pixel!(f32, ());\n"),
            ("effects_diffuse_f32", "use raylet::effect::Diffuse;\n\nraylet_sizes::pixel!(f32, (Diffuse,));\n"),
            (
                "effects_shadows_f32",
                "use raylet::effect::{Diffuse, Shadows, Specular};\n\n\
                 raylet_sizes::pixel!(f32, (Diffuse, Specular, Shadows));\n",
            ),
            ("effects_all_f32", "use raylet::effect::All;\n\nraylet_sizes::pixel!(f32, All);\n"),
            (
                "range_cylinder_plane_i16f16",
                "use fixed::types::I16F16;\nuse raylet::{Cylinder, Frame, Plane};\n\n\
                 raylet_sizes::range!(I16F16, (Cylinder<I16F16>, Plane<I16F16>, Frame<I16F16>));\n",
            ),
            (
                "picture_sphere_plane_f32",
                "use raylet::{Frame, Plane, Sphere};\n\n\
                 raylet_sizes::picture!(f32, (Sphere<f32>, Plane<f32>, Frame<f32>), ());\n",
            ),
        ] {
            assert_eq!(body(name), Some(expected), "{name}");
        }
    }
}
