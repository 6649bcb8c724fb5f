//! `docs/microcontrollers.md`: the baselines as tables.

use crate::chip::{self, Part};
use crate::{cost, cycles, effects, effects_table, kinds, marks, size};
use raylet_tables::markdown::{head, row};
use raylet_tables::{Baseline, CHIPS, Outcome, SUBJECTS, grouped, in_repository};
use std::fmt::Write;
use std::fs;

/// The subjects that the textbook is compared with.
const COMPARED: [&str; 3] = ["sphere", "cylinder, capped", "cone, capped"];

/// Number types, and their tiers.
const NUMBERS: [(&str, &[&str]); 4] = [
    ("I16F16", &["Plain", "Fast", "Stable", "Exact"]),
    ("f32", &["Plain", "Fast", "Stable", "Exact"]),
    ("I32F32", &["Plain", "Fast", "Stable"]),
    ("f64", &["Plain", "Fast", "Stable"]),
];

/// A chip, and what it takes.
pub struct Measured {
    /// Its name.
    pub chip: &'static str,
    /// In instructions and bytes.
    pub counted: Baseline,
    /// In modelled cycles.
    pub modelled: Baseline,
}

const INTRODUCTION: &str = "\
# On microcontrollers

Flash, stack, instructions and modelled cycles on four chips: Cortex-M0+, Cortex-M3, Cortex-M4F and RV32IMC.

| section | what it holds |
|---|---|
| [Whole uses](#whole-uses) | flash and stack of a range sensor and of pictures |
| [How it is measured](#how-it-is-measured) | what the figures mean, and what checks them |
| [Modelled cycles](#modelled-cycles) | the model, and what cycles show that instructions do not |
| [The marks](#the-marks) | limits that the library was written to reach |
| [The nearest hit, beside the textbook](#the-nearest-hit-beside-the-textbook) | three primitives in every number type and tier, on all chips |
| What users do: [M0+](#what-users-do-cortex-m0), [M3](#what-users-do-cortex-m3), [M4F](#what-users-do-cortex-m4f), [RV32IMC](#what-users-do-rv32imc) | the mean and the worst of single queries |
| All primitives: [M0+](#cortex-m0), [M3](#cortex-m3), [M4F](#cortex-m4f), [RV32IMC](#rv32imc) | instructions, cycles and stack of every query |
| [Flash](#flash) | bytes of a program with one primitive |
| [Effects](#effects) | instructions, cycles, stack and flash of a pixel |

";

const METHOD: &str = "\
## How it is measured

Unless a table says otherwise, the figures are **instructions, not cycles**: a chip takes one or more cycles for each, depending on its pipeline and on its
memory. Cycles are [modelled](#modelled-cycles). QEMU counts the instructions (`-icount shift=0`: its clock advances by one nanosecond an instruction), so that
the counts are the same on every run. The programs of the M0+ run on QEMU's Cortex-M3, which executes all instructions of an M0+.

Unless a table says otherwise, a figure is the mean over 64 seeded rays that start 2 to 6 units away; all of them hit, or all miss. The queries of the sections *What users do* are
described in [benches.md](benches.md). Each query is a call of a function that is not inlined; the cost of the loop and of a call of an empty function is
subtracted. The programs are built with `opt-level = 3`, link-time optimisation and one codegen unit.

The *textbook* is the formula `k^2 - a c` as it is usually written: for floats with `libm`'s square root, for fixed point with the
operators of the crate `fixed` in the same type, wrapping where a square overflows. The tables here show its cost; its errors are in
[accuracy.md](accuracy.md). On the Cortex-M4F a second row, *VSQRT*, has the textbook with the chip's instruction for the square root, which raylet uses too.

The documentation of `raylet::tier` says what the tiers promise.

`.ci/measure --renew` and `.ci/cycles --renew` write this page; do not edit it. `.ci/measure` fails if a figure gets more than 2 % worse: `.ci/run` calls it for the
M0+, `.ci/long` for all four. `.ci/cycles` does the same for modelled cycles, and `.ci/long` calls it.

";

/// The figure for rays that hit, or for both kinds.
pub fn cell(baseline: &Baseline, subject: &str, query: &str, number: &str, tier: &str) -> String {
    let figure = |rays| Part::Cost.figure(baseline, &cost::key(subject, query, number, tier, rays)).map(grouped);
    match (figure("hit"), figure("miss")) {
        (Some(hit), Some(miss)) => format!("{hit} / {miss}"),
        (Some(hit), None) => hit,
        _ => "–".into(),
    }
}

/// The tests of a range sensor, as a subject.
const SENSOR: &str = "range sensor";

/// The subjects whose stack is measured: the sensor has rays that the first numbers of floats cannot decide.
fn stacked() -> impl Iterator<Item = &'static str> {
    SUBJECTS.into_iter().chain([SENSOR])
}

/// What the uses of the library take: a shape of any primitive and placement, and pictures of them.
fn whole_uses(text: &mut String, chips: &[Measured]) {
    text.push_str(
        "## Whole uses\n\nIn `Stable`. *Flash* is bytes over those of a program that does nothing, built with `opt-level = 3`, the fastest profile and not the smallest. *Stack* is the most bytes that were measured: no bound is proved. \
         A ray that the first numbers of a tier cannot decide needs the stack of wider ones; the sensor has such rays, and a simple picture may have none. \
         Instructions and [modelled cycles](#modelled-cycles) are means.\n\n\
         - The *range sensor* tests a `Shape`, which may be any primitive in any placement. Instructions and cycles are those of one test, of one of 64 zones against one of forty solids, 1 to 200 metres away and most of them upright; most tests miss. \
         They are means over every 27th pair of a zone and a solid; the sections *What users do* have the worst of these too. The stack is the largest of all nearest hits that are measured.\n\
         - The *picture* is that of the section [Effects](#effects), and its shapes may be any primitive too. Instructions and cycles are those of a pixel; with all effects, pixels at edges have several samples.\n\
         - Rows that name primitives are programs that name them as well (`Shape<S, K>`): spheres and planes, or cylinders and planes, in frames or not placed. They contain no code of other primitives and placements. Only their flash is measured.\n\n",
    );
    head(text, ["use", "number", "chip", "flash", "stack", "instructions", "cycles"].map(String::from));
    for number in effects::NUMBERS {
        for Measured { chip, counted: baseline, modelled } in chips {
            let cost = |baseline: &Baseline, subject: &str, of: &str| {
                Part::Cost.figure(baseline, &cost::key(subject, "nearest", number, "Stable", of))
            };
            let deepest = stacked().filter_map(|subject| cost(baseline, subject, "stack")).max();
            let flash = Part::Size.figure(baseline, &size::key(size::SHAPE, [number, "Stable"]));
            let mut line = |of: &str, figures: [Option<u64>; 4]| {
                let figures = figures.map(|figure| figure.map_or("–".into(), grouped));
                row(text, [of, number, chip].map(String::from).into_iter().chain(figures));
            };
            let sensor = |figures| cost(figures, SENSOR, "hit");
            line(SENSOR, [flash, deepest, sensor(baseline), sensor(modelled)]);
            let ends = [("picture, no effects", effects::SETS.first()), ("picture, all effects", effects::SETS.last())];
            for (name, set) in ends.into_iter().filter_map(|(name, set)| Some((name, set?.1))) {
                let figure = |what: &str| Part::Effects.figure(baseline, &effects::key(set, number, what));
                let flash = Part::Size.figure(baseline, &effects::key(set, number, "bytes"));
                let cycles = Part::Effects.figure(modelled, &effects::key(set, number, "instructions"));
                line(name, [flash, figure("stack"), figure("instructions"), cycles]);
            }
            for of in &kinds::USES {
                line(of.name, [Part::Size.figure(baseline, &kinds::key(of, number)), None, None, None]);
            }
        }
    }
    text.push('\n');
}

/// A few primitives on all chips, beside the textbook.
fn comparison(text: &mut String, chips: &[Measured]) {
    text.push_str("## The nearest hit, beside the textbook\n\nInstructions, and [modelled cycles](#modelled-cycles): hit / miss.\n\n");
    let titles = chips.iter().flat_map(|Measured { chip, .. }| [(*chip).to_string(), "cycles".into()]);
    head(text, ["", "number", "tier"].map(String::from).into_iter().chain(titles));
    for subject in COMPARED {
        for (number, tiers) in NUMBERS {
            for tier in ["textbook", "textbook, VSQRT"].iter().chain(tiers) {
                let figures = chips.iter().flat_map(|Measured { counted, modelled, .. }| [counted, modelled]);
                let cells: Vec<_> = figures.map(|of| cell(of, subject, "nearest", number, tier)).collect();
                if cells.iter().any(|cell| cell != "–") {
                    let names = [subject, number, tier].map(String::from);
                    row(text, names.into_iter().chain(cells));
                }
            }
        }
    }
}

/// What users do, on one chip.
fn workloads(text: &mut String, chip: &str, baseline: &Baseline) {
    const KINDS: [(&str, &str); 10] = [
        ("I16F16", "Plain"),
        ("I16F16", "Fast"),
        ("I16F16", "Stable"),
        ("I16F16", "Exact"),
        ("f32", "Plain"),
        ("f32", "Fast"),
        ("f32", "Stable"),
        ("f32", "Exact"),
        ("I32F32", "Stable"),
        ("f64", "Stable"),
    ];
    let _ = write!(
        text,
        "\n## What users do: {chip}\n\nInstructions of a nearest hit. Each of a hundred queries is counted by itself: the mean (the worst).\n\n"
    );
    head(text, std::iter::once(String::new()).chain(KINDS.map(|(number, tier)| format!("{number} {tier}"))));
    let names: std::collections::BTreeSet<_> =
        Part::Workload.figures(baseline).keys().filter_map(|key| key.split(" | ").next()).collect();
    for of in names {
        let cells = KINDS.map(|(number, tier)| {
            let figure =
                |what| Part::Workload.figure(baseline, &cost::workload_key(of, number, tier, what)).map(grouped);
            match (figure("mean"), figure("worst")) {
                (Some(mean), Some(worst)) => format!("{mean} ({worst})"),
                _ => "–".into(),
            }
        });
        row(text, std::iter::once(of.to_string()).chain(cells));
    }
}

/// Every primitive on one chip.
fn one_chip(text: &mut String, Measured { chip, counted: baseline, modelled }: &Measured) {
    let _ = write!(text, "\n## {chip}\n\nThe nearest hit, in instructions: hit / miss.\n\n");
    let kinds: Vec<_> =
        NUMBERS.iter().flat_map(|(number, tiers)| tiers.iter().map(move |tier| (*number, *tier))).collect();
    let nearest = |text: &mut String, figures: &Baseline| {
        let titles = kinds.iter().map(|(number, tier)| format!("{number} {tier}"));
        head(text, std::iter::once(String::new()).chain(titles));
        for subject in SUBJECTS {
            let cells = kinds.iter().map(|(number, tier)| cell(figures, subject, "nearest", number, tier));
            row(text, std::iter::once(subject.to_string()).chain(cells));
        }
    };
    nearest(text, baseline);
    text.push_str("\nThe same in [modelled cycles](#modelled-cycles): hit / miss.\n\n");
    nearest(text, modelled);
    text.push_str(
        "\nThe stack of a nearest hit: the most bytes that these rays take, the caller's frames not counted. A ray that the first numbers of a tier pass on takes more than the others, \
         and not every row has one: plan with the largest figure of the column, and with a margin, since no bound is proved.\n\n",
    );
    let titles = kinds.iter().map(|(number, tier)| format!("{number} {tier}"));
    head(text, std::iter::once(String::new()).chain(titles));
    for subject in stacked() {
        let cells = kinds.iter().map(|(number, tier)| {
            let key = cost::key(subject, "nearest", number, tier, "stack");
            Part::Cost.figure(baseline, &key).map_or("–".into(), grouped)
        });
        row(text, std::iter::once(subject.to_string()).chain(cells));
    }
    text.push_str("\nThe other queries in `Stable`, in instructions: hit / miss. Normals and surface coordinates (uv) are computed at a known hit.\n\n");
    let queries = ["all hits", "occlusion", "normal", "uv"];
    let numbers = ["I16F16", "f32"];
    let titles = numbers.iter().flat_map(|number| queries.iter().map(move |query| format!("{number} {query}")));
    head(text, std::iter::once(String::new()).chain(titles));
    for subject in SUBJECTS {
        let cells = numbers.iter().flat_map(|number| {
            queries.iter().map(move |query| {
                let tier = if matches!(*query, "normal" | "uv") { "any" } else { "Stable" };
                cell(baseline, subject, query, number, tier)
            })
        });
        row(text, std::iter::once(subject.to_string()).chain(cells));
    }
}

/// Bytes of flash.
fn sizes(text: &mut String, chips: &[Measured]) {
    text.push_str(
        "\n## Flash\n\nBytes of code and constants of a program that computes the nearest hit of one primitive, over those of a program that does nothing. \
         `shape` is a `Shape`, which may be any primitive in any placement. Primitives share code, such as the arithmetic of the number type; each row counts it.\n\n",
    );
    let titles = chips.iter().map(|Measured { chip, .. }| (*chip).to_string());
    head(text, ["", "number", "tier"].map(String::from).into_iter().chain(titles));
    for primitive in size::PRIMITIVES {
        for [number, tier] in size::KINDS {
            let figures = chips.iter().map(|Measured { counted, .. }| {
                Part::Size.figure(counted, &size::key(primitive, [number, tier])).map_or("–".into(), grouped)
            });
            row(text, [primitive, number, tier].map(String::from).into_iter().chain(figures));
        }
    }
}

fn text() -> Outcome<String> {
    let mut chips = Vec::new();
    for (target, chip) in CHIPS {
        chips.push(Measured { chip, counted: chip::baseline(target)?, modelled: chip::cycles(target)? });
    }
    let mut text = INTRODUCTION.to_string();
    whole_uses(&mut text, &chips);
    text.push_str(METHOD);
    if let Some(Measured { counted, .. }) = chips.first() {
        let _ = write!(text, "Compiler: {}.\n\n", counted.compiler);
    }
    cycles::section(&mut text, &chips);
    marks::table(&mut text, &chips);
    comparison(&mut text, &chips);
    for Measured { chip, counted, .. } in &chips {
        workloads(&mut text, chip, counted);
    }
    for chip in &chips {
        one_chip(&mut text, chip);
    }
    sizes(&mut text, &chips);
    effects_table::tables(&mut text, &chips);
    Ok(text)
}

/// Writes the document, or says whether it is as it should be.
pub fn write(verify: bool) -> Outcome {
    put("docs/microcontrollers.md", &text()?, verify)
}

/// Writes a document, or says whether it is as it should be.
pub fn put(path: &str, text: &str, verify: bool) -> Outcome {
    if !verify {
        fs::write(in_repository(path), text)?;
        println!("{path} is written");
    } else if fs::read_to_string(in_repository(path))? != text {
        return Err(format!("{path} is not what the baselines say: .ci/measure --document").into());
    } else {
        println!("{path} is what the baselines say");
    }
    Ok(())
}
