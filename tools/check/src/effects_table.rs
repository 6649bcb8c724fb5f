//! What each set of effects costs, as tables of `docs/microcontrollers.md`.

use crate::chip::Part;
use crate::document::Measured;
use crate::effects::{NUMBERS, SETS, key};
use raylet_tables::markdown::{head, row};
use raylet_tables::{Baseline, grouped};
use std::fmt::Write;

const INTRODUCTION: &str = "
## Effects

What a pixel costs with a set of effects compiled in: a ball, a can and a cone on a plane under two lamps, 16 by 12 pixels (the
scenes of `tools/firmware/programs/src/effects/stage.rs`; each calls for just what is in its set, and the first is black: nothing but the
nearest hit is looked for). *Code* is what a program takes that finds out what a scene calls for and traces such a pixel, over a
program that does nothing: all primitives are in it. *Cycles* are [modelled](#modelled-cycles), a pixel. *Stack* is what tracing a row takes at most, the caller's frames not counted. *Among all* is the same picture with
every effect compiled in and only these at work: CI compares the pictures and the number of rays, which are equal to the last bit.

An effect that is not in the set leaves nothing behind: `check left-out` looks up where each instruction of these programs comes from,
inlined functions included, and finds none from a file of `src/effect` that is another effect's, and some from each that is its own (but
for diffuse, which is one multiplication: the compiler may keep no line for it).

";

/// Instructions and stack on every chip, bytes of code.
pub fn tables(text: &mut String, chips: &[Measured]) {
    text.push_str(INTRODUCTION);
    for Measured { chip, counted, modelled } in chips {
        for number in NUMBERS {
            let _ = write!(text, "\n### {chip}, {number}\n\n");
            let titles = [
                "effects",
                "code",
                "instructions a pixel",
                "cycles",
                "stack",
                "instructions among all",
                "",
                "stack among all",
            ];
            head(text, titles.map(String::from));
            for (_, set) in SETS {
                row(text, cells(counted, modelled, set, number));
            }
        }
    }
}

fn cells(baseline: &Baseline, modelled: &Baseline, set: &str, number: &str) -> Vec<String> {
    let effect = |figure| Part::Effects.figure(baseline, &key(set, number, figure));
    let show = |figure: Option<u64>| figure.map_or("–".into(), grouped);
    let (alone, among_all) = (effect("instructions"), effect("instructions among all"));
    let more = match (alone, among_all) {
        (Some(alone), Some(among_all)) => {
            format!("{:+.1} %", 100.0 * (among_all as f64 / alone.max(1) as f64 - 1.0))
        }
        _ => "–".into(),
    };
    vec![
        set.into(),
        show(Part::Size.figure(baseline, &key(set, number, "bytes"))),
        show(alone),
        show(Part::Effects.figure(modelled, &key(set, number, "instructions"))),
        show(effect("stack")),
        show(among_all),
        more,
        show(effect("stack among all")),
    ]
}
