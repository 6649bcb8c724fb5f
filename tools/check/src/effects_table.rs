//! What each set of effects costs, as tables of `docs/microcontrollers.md`.

use crate::chip::Part;
use crate::document::Measured;
use crate::effects::{NUMBERS, SETS, key};
use raylet_tables::markdown::{head, row};
use raylet_tables::{Baseline, grouped};
use std::fmt::Write;

const INTRODUCTION: &str = "
## Effects

What a pixel costs with a set of effects compiled in. The picture has 16 by 12 pixels: a ball, a can and a cone on a plane under two lamps. The scenes are in
`tools/firmware/programs/src/effects/stage.rs`; each uses exactly the effects of its set. With none the picture is black, and only
nearest hits are computed.

- *Code* is bytes of flash over those of a program that does nothing. The program finds out which effects a scene uses, and traces such a pixel; it contains all primitives.
- *Cycles* are [modelled](#modelled-cycles), a pixel.
- *Stack* is the most that was measured while a row of pixels is traced, the caller's frames not counted.
- *Among all* is the same picture in a program with every effect compiled in, of which only those of the set are used. CI compares the pictures and the numbers of rays, which
  are equal to the last bit.

An effect that is not in the set leaves no code in the program. `check left-out` looks up the source line of each instruction of these programs, inlined functions
included. It finds no instruction from a file of `src/effect` of an effect that is left out, and some from each file of an effect in the set, except
for diffuse: that is one multiplication, for which the compiler may keep no line.

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
                "more among all",
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
