//! `docs/benches.md`: the baseline as tables.

use crate::cost::scenes::{FLAKE, OBJECTS, WALKS, subject};
use raylet_tables::markdown::{head, row};
use raylet_tables::{Baseline, Figures, Outcome, SUBJECTS, grouped, in_repository};
use std::env::consts::ARCH;
use std::fmt::Write;
use std::fs;

const PATH: &str = "docs/benches.md";
const BASELINE: &str = "data/host.tsv";
const PART: &str = "cost";
const RENEW: &str = ".ci/instructions --renew";

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
your machine: `cargo bench -p raylet-counting`.

The figures are **instructions, never cycles**, counted by valgrind's callgrind, so that they are the same on every run. Each is the
mean over 64 seeded rays, which start 2 to 6 units away; all of them hit, or all miss. Subjects, rays and questions are those of
[microcontrollers.md](microcontrollers.md): a function that is not inlined asks the question, and what a function takes that does
nothing is subtracted, with the loop. The program is built with `opt-level = 3`, link-time optimisation and one codegen unit, and for any processor of its
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

/// A first cell, and the others.
fn cells(first: &str, others: impl IntoIterator<Item = String>) -> impl Iterator<Item = String> {
    std::iter::once(first.to_string()).chain(others)
}

/// Every subject in every number type and tier.
fn query(text: &mut String, figures: &Figures, title: &str, query: &str) {
    let _ = write!(text, "## {title}\n\nInstructions: hit / miss.\n\n");
    let columns: Vec<_> =
        NUMBERS.iter().flat_map(|(number, tiers)| tiers.iter().map(move |tier| (*number, *tier))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, tier)| format!("`{number}` `{tier}`")).collect();
    head(text, cells("subject", titles));
    for subject in SUBJECTS {
        row(text, cells(subject, columns.iter().map(|(number, tier)| cell(figures, [subject, query, number, tier]))));
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
    head(text, cells("subject", titles));
    for subject in SUBJECTS {
        row(text, cells(subject, columns.iter().map(|(number, query)| cell(figures, [subject, query, number, "any"]))));
    }
    text.push('\n');
}

/// Scenes of ever more spheres.
fn scenes(text: &mut String, figures: &Figures) {
    text.push_str(
        "## Cost against work\n\nInstructions a ray in a scene of small framed spheres, `Stable`: hit / miss. Without a hierarchy a scene \
         asks one object after the other, so the nearest hit costs as much again with each; occlusion stops at the first object found. \
         With one (`Scene::with_hierarchy`) it asks boxes, and the objects in those that the ray does not miss. The last row of \
         each table is what a sphere adds, from the fewest to 256. The 66,430 spheres are a sphere flake: on each sphere nine of a third of \
         its radius.\n",
    );
    for walk in WALKS {
        let _ = write!(text, "\nObjects {walk}:\n\n");
        scenes_by(text, figures, walk);
    }
}

fn scenes_by(text: &mut String, figures: &Figures, walk: &str) {
    let columns: Vec<_> = FEWER_NUMBERS.iter().flat_map(|number| SCENE_QUERIES.map(|query| (*number, query))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, query)| format!("{query}, `{number}`")).collect();
    head(text, cells("spheres", titles));
    let scene = |objects: usize| subject(objects, walk);
    for objects in OBJECTS.into_iter().chain([FLAKE]) {
        let counted: Vec<_> =
            columns.iter().map(|(number, query)| cell(figures, [&scene(objects), query, number, "Stable"])).collect();
        if counted.iter().any(|cell| cell != "–") {
            row(text, cells(&grouped(objects as u64), counted));
        }
    }
    let (fewest, most) = (OBJECTS[0], OBJECTS[OBJECTS.len() - 1]);
    let added = |number: &str, query: &str, kind: &str| {
        let of = |objects| figure(figures, [&scene(objects), query, number, "Stable", kind]);
        match (of(fewest), of(most)) {
            (Some(few), Some(many)) => format!("{:.1}", (many as f64 - few as f64) / (most - fewest) as f64),
            _ => "–".into(),
        }
    };
    let further = columns
        .iter()
        .map(|(number, query)| format!("{} / {}", added(number, query, "hit"), added(number, query, "miss")));
    row(text, cells("each further", further));
}

fn text(baseline: &Baseline) -> String {
    let figures = baseline.part(PART);
    let mut text = INTRODUCTION.to_string();
    let _ = write!(text, "Counted on {} with {}.\n\n", baseline.machine, baseline.compiler);
    query(&mut text, figures, "The nearest hit", "nearest");
    query(&mut text, figures, "Occlusion", "occlusion");
    surface(&mut text, figures);
    scenes(&mut text, figures);
    text
}

/// Makes what was counted the baseline, and writes the document.
pub fn renew(now: &Baseline) -> Outcome {
    println!("{} figures in instructions: the baseline is renewed", now.part(PART).len());
    now.write(BASELINE)?;
    Ok(fs::write(in_repository(PATH), text(now))?)
}

/// An error if a figure got worse, or if the document does not show the baseline.
pub fn verify(now: &Baseline) -> Outcome {
    let baseline = Baseline::read(BASELINE, RENEW)?;
    baseline.compare(now, PART, "instructions", RENEW)?;
    if fs::read_to_string(in_repository(PATH)).is_ok_and(|found| found == text(&baseline)) {
        Ok(())
    } else {
        Err(format!("{PATH} does not show the baseline: {RENEW}").into())
    }
}

/// What was counted on this machine.
pub fn counted(compiler: &str, figures: Figures) -> Baseline {
    Baseline::new(ARCH, compiler, PART, figures)
}
