//! `docs/benches.md`: the baseline as tables.

use super::baseline::{Baseline, Figures};
use super::grouped::grouped;
use crate::cost::scenes::{OBJECTS, WALKS, subject};
use std::error::Error;
use std::fmt::Write;
use std::fs;

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/benches.md");

/// The subjects, as they are named beside the firmware.
const SUBJECTS: [&str; 16] = [
    "sphere",
    "cylinder, infinite",
    "cylinder, open",
    "cylinder, capped",
    "capsule",
    "cone, double",
    "cone, nappe",
    "cone, open",
    "cone, capped",
    "frustum",
    "plane",
    "disc",
    "triangle",
    "cylinder, capped, as a shape",
    "cylinder, capped, framed",
    "cylinder, capped, stretched",
];

/// Number types, and their tiers.
const NUMBERS: [(&str, &[&str]); 4] = [
    ("f32", &["Fast", "Stable", "Exact"]),
    ("f64", &["Fast", "Stable"]),
    ("I16F16", &["Fast", "Stable", "Exact"]),
    ("I32F32", &["Fast", "Stable"]),
];

/// The number types of the scenes, and of normals and surface coordinates.
const FEWER_NUMBERS: [&str; 2] = ["f32", "I16F16"];

/// The queries of the scenes.
const SCENE_QUERIES: [&str; 2] = ["nearest", "occlusion"];

const INTRODUCTION: &str = "\
# On the host

What a query costs on an ordinary computer, in instructions, and how that grows with the objects of a scene. Written by
`.ci/instructions --renew`; do not edit. `.ci/instructions` fails if a figure gets more than 2 % worse. How long a query takes on
your machine: `cargo bench --bench queries`.

The figures are **instructions, never cycles**, counted by valgrind's callgrind, so that they are the same on every run. Each is the
mean over 64 seeded rays, which start 2 to 6 units away; all of them hit, or all miss. Subjects, rays and questions are those of
[microcontrollers.md](microcontrollers.md): a function that is not inlined asks the question, and what a function takes that does
nothing is subtracted, with the loop. The program is built with `opt-level = 3`, one codegen unit, and for any processor of its
architecture.

";

fn figure(figures: &Figures, name: [&str; 5]) -> Option<u64> {
    figures.get(&name.join(" | ")).copied()
}

/// The figure for rays that hit, or for both kinds.
fn cell(figures: &Figures, [subject, query, number, tier]: [&str; 4]) -> String {
    let grouped = |kind| figure(figures, [subject, query, number, tier, kind]).map(grouped);
    match (grouped("hit"), grouped("miss")) {
        (Some(hit), Some(miss)) => format!("{hit} / {miss}"),
        (Some(hit), None) => hit,
        _ => "–".into(),
    }
}

fn row(text: &mut String, first: &str, cells: impl IntoIterator<Item = String>) {
    let cells: Vec<_> = cells.into_iter().collect();
    let _ = writeln!(text, "| {first} | {} |", cells.join(" | "));
}

fn head(text: &mut String, first: &str, titles: &[String]) {
    row(text, first, titles.iter().cloned());
    let _ = writeln!(text, "|---|{}", "---:|".repeat(titles.len()));
}

/// Every subject in every number type and tier.
fn query(text: &mut String, figures: &Figures, title: &str, query: &str) {
    let _ = write!(text, "## {title}\n\nInstructions: hit / miss.\n\n");
    let columns: Vec<_> =
        NUMBERS.iter().flat_map(|(number, tiers)| tiers.iter().map(move |tier| (*number, *tier))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, tier)| format!("`{number}` `{tier}`")).collect();
    head(text, "subject", &titles);
    for subject in SUBJECTS {
        row(text, subject, columns.iter().map(|(number, tier)| cell(figures, [subject, query, number, tier])));
    }
    text.push('\n');
}

/// What a hit is asked for.
fn surface(text: &mut String, figures: &Figures) {
    text.push_str(
        "## Normal and surface coordinates\n\nInstructions at a hit that is known; no tier changes them.\n\n",
    );
    let columns: Vec<_> =
        FEWER_NUMBERS.iter().flat_map(|number| ["normal", "uv"].map(|query| (*number, query))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, query)| format!("{query}, `{number}`")).collect();
    head(text, "subject", &titles);
    for subject in SUBJECTS {
        row(text, subject, columns.iter().map(|(number, query)| cell(figures, [subject, query, number, "any"])));
    }
    text.push('\n');
}

/// Scenes of ever more spheres.
fn scenes(text: &mut String, figures: &Figures) {
    text.push_str(
        "## Cost against work\n\nInstructions a ray in a scene of small framed spheres, `Stable`: hit / miss. Without a hierarchy a scene \
         asks one object after the other, so the nearest hit costs as much again with each; occlusion stops at the first object found. \
         With one (`Scene::with_hierarchy`) it asks boxes, and the objects in those that the ray does not miss. The last row of \
         each table is what a sphere adds, from the fewest to the most.\n",
    );
    for walk in WALKS {
        let _ = write!(text, "\nObjects {walk}:\n\n");
        scenes_by(text, figures, walk);
    }
}

fn scenes_by(text: &mut String, figures: &Figures, walk: &str) {
    let columns: Vec<_> = FEWER_NUMBERS.iter().flat_map(|number| SCENE_QUERIES.map(|query| (*number, query))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, query)| format!("{query}, `{number}`")).collect();
    head(text, "spheres", &titles);
    let scene = |objects: usize| subject(objects, walk);
    for objects in OBJECTS {
        let cells = columns.iter().map(|(number, query)| cell(figures, [&scene(objects), query, number, "Stable"]));
        row(text, &objects.to_string(), cells);
    }
    let (fewest, most) = (OBJECTS[0], OBJECTS[OBJECTS.len() - 1]);
    let added = |number: &str, query: &str, kind: &str| {
        let of = |objects| figure(figures, [&scene(objects), query, number, "Stable", kind]);
        match (of(fewest), of(most)) {
            (Some(few), Some(many)) => format!("{:.1}", (many as f64 - few as f64) / (most - fewest) as f64),
            _ => "–".into(),
        }
    };
    let cells = columns
        .iter()
        .map(|(number, query)| format!("{} / {}", added(number, query, "hit"), added(number, query, "miss")));
    row(text, "each further", cells);
}

fn text(baseline: &Baseline) -> String {
    let mut text = INTRODUCTION.to_string();
    let _ = write!(text, "Counted on {} with {}.\n\n", baseline.architecture, baseline.compiler);
    query(&mut text, &baseline.figures, "The nearest hit", "nearest");
    query(&mut text, &baseline.figures, "Occlusion", "occlusion");
    surface(&mut text, &baseline.figures);
    scenes(&mut text, &baseline.figures);
    text
}

/// Writes the document.
pub fn write(baseline: &Baseline) -> Result<(), Box<dyn Error>> {
    Ok(fs::write(PATH, text(baseline))?)
}

/// An error if the document does not show the baseline.
pub fn verify(baseline: &Baseline) -> Result<(), Box<dyn Error>> {
    if fs::read_to_string(PATH).is_ok_and(|found| found == text(baseline)) {
        Ok(())
    } else {
        Err("docs/benches.md does not show the baseline: .ci/instructions --renew".into())
    }
}
