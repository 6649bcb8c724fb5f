//! What the modelled cycles of `docs/microcontrollers.md` are, and what they show that instructions do not.

use crate::chip::Part;
use crate::cost;
use crate::document::Measured;
use raylet_tables::markdown::{head, row};
use raylet_tables::{Baseline, Figures, SUBJECTS, grouped};
use std::fmt::Write;

const INTRODUCTION: &str = "\
## Modelled cycles

Some instructions take one cycle, others a dozen: divides and roots above all. `.ci/cycles` runs the same programs in Unicorn, with
a clock that adds up the cycles of each instruction by its class. The latencies are in
[tools/cycles/latencies.toml](../tools/cycles/latencies.toml), from the manuals of the Cortex-M0+ (with the multiplier of one cycle), the
Cortex-M3, the Cortex-M4F, and for RV32IMC from that of Hazard3, the core of the RP2350. These cycles are a **model, not a measurement**. The model assumes
memory without wait states, for instructions and data; the flash of many chips is slower. Where a manual gives a range, the model takes its upper end. With one cycle for every
instruction, Unicorn counts as many as QEMU: `.ci/cycles` compares both. The cycles of what users do, and of all other queries, are
in [data/cycles](../data/cycles). They were modelled before the tier `Plain` was added and the solvers of floats were written anew, and not since: `Plain` has none,
and those of `f32` and `f64` belong to the code before.

Cycles per instruction of a nearest hit: the median over all primitives and tiers in the tables below.

";

/// The number types, in the order of the tables.
const NUMBERS: [&str; 4] = ["I16F16", "f32", "I32F32", "f64"];

/// The chip with instructions for the divide and the root of floats.
const FLOATS: &str = "Cortex-M4F";
/// What either takes there, by `tools/cycles/latencies.toml`.
const DIVIDE_OR_ROOT: u64 = 14;

/// The names of nearest hits of a number type, the textbook's left out.
fn nearest_hits<'a>(figures: &'a Figures, number: &'a str) -> impl Iterator<Item = &'a String> {
    figures.keys().filter(move |name| {
        let parts: Vec<_> = name.split(" | ").collect();
        matches!(parts[..], [subject, "nearest", of, tier, "hit"]
            if of == number && SUBJECTS.contains(&subject) && !tier.starts_with("textbook"))
    })
}

fn median(mut ratios: Vec<f64>) -> Option<f64> {
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied()
}

/// The median ratio of figures with the same names.
fn ratio<'a>(of: &Figures, to: &Figures, names: impl Iterator<Item = &'a String>) -> Option<f64> {
    median(names.filter_map(|name| Some(*of.get(name)? as f64 / *to.get(name)? as f64)).collect())
}

/// Instructions and cycles of a nearest hit of a sphere.
fn sphere(Measured { counted, modelled, .. }: &Measured, number: &str, tier: &str) -> Option<[u64; 2]> {
    let figure = |baseline: &Baseline| {
        Part::Cost.figure(baseline, &cost::key("sphere", "nearest", number, tier, "hit")).filter(|figure| *figure > 0)
    };
    Some([figure(counted)?, figure(modelled)?])
}

/// How much of one figure another is: `0.46 times` or `2.17 times`.
fn times([of, to]: [u64; 2]) -> String {
    format!("{:.2} times", of as f64 / to as f64)
}

/// The section.
pub fn section(text: &mut String, chips: &[Measured]) {
    text.push_str(INTRODUCTION);
    head(text, std::iter::once(String::new()).chain(chips.iter().map(|of| of.chip.into())));
    for number in NUMBERS {
        let cells = chips.iter().map(|Measured { counted, modelled, .. }| {
            let (counted, modelled) = (Part::Cost.figures(counted), Part::Cost.figures(modelled));
            ratio(modelled, counted, nearest_hits(counted, number)).map_or("–".into(), |ratio| format!("{ratio:.2}"))
        });
        row(text, std::iter::once(number.to_string()).chain(cells));
    }
    text.push('\n');
    ranges(text, chips);
    if let Some(chip) = chips.iter().find(|of| of.chip == FLOATS) {
        let _ = shown(text, chip);
    }
}

/// How much the ranges of the manuals leave open, of the chips whose manuals give some.
fn ranges(text: &mut String, chips: &[Measured]) {
    let less = chips.iter().filter_map(|Measured { chip, modelled, .. }| {
        let (least, most) = (Part::LeastCost.figures(modelled), Part::Cost.figures(modelled));
        let fewer = 100.0 * (1.0 - ratio(least, most, least.keys())?);
        Some(format!("{fewer:.0} % on the {chip}"))
    });
    let less: Vec<_> = less.collect();
    let _ = writeln!(
        text,
        "With the lower end of each range instead, the same queries take fewer cycles, in the median: {}.\n",
        less.join(", ")
    );
}

/// What the cycles of the chip with floats show.
fn shown(text: &mut String, chip: &Measured) -> Option<()> {
    let [float, fixed] = [sphere(chip, "f32", "Fast")?, sphere(chip, "I16F16", "Fast")?];
    let [root, without] = [sphere(chip, "f32", "textbook, VSQRT")?, sphere(chip, "f32", "textbook")?];
    let _ = writeln!(
        text,
        "On the {FLOATS} a divide or a root of floats is one instruction, which takes {DIVIDE_OR_ROOT} cycles. The nearest hit of a sphere in `Fast` takes {} instructions \
         and {} cycles in `f32`, {} and {} in `I16F16`: `f32` takes {} the instructions of fixed point, and {} its cycles. The textbook's sphere \
         with the chip's root takes {} the instructions of the one with `libm`'s, and {} its cycles.\n",
        grouped(float[0]),
        grouped(float[1]),
        grouped(fixed[0]),
        grouped(fixed[1]),
        times([float[0], fixed[0]]),
        times([float[1], fixed[1]]),
        times([root[0], without[0]]),
        times([root[1], without[1]]),
    );
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(figures: &[(&str, u64, u64)]) -> Measured {
        let of = |figure: fn(&(&str, u64, u64)) -> u64| {
            let figures = figures.iter().map(|row| (format!("sphere | nearest | {} | hit", row.0), figure(row)));
            Baseline::new("a", "b", "cost", figures.collect())
        };
        Measured { chip: FLOATS, counted: of(|row| row.1), modelled: of(|row| row.2) }
    }

    #[test]
    fn a_median_is_the_middle() {
        assert_eq!(median(vec![5.0, 1.0, 2.0, 9.0, 3.0]), Some(3.0));
        assert_eq!(median(vec![]), None);
    }

    #[test]
    fn a_median_is_of_what_both_have() {
        let chip = measured(&[("f32 | Fast", 10, 15), ("f32 | Stable", 10, 20), ("f32 | Exact", 10, 30)]);
        let [counted, modelled] = [&chip.counted, &chip.modelled].map(|of| Part::Cost.figures(of));
        assert_eq!(ratio(modelled, counted, nearest_hits(counted, "f32")), Some(2.0));
        assert_eq!(ratio(modelled, counted, nearest_hits(counted, "f64")), None);
    }

    #[test]
    fn the_textbook_is_in_no_median() {
        let chip = measured(&[("f32 | Fast", 1, 1), ("f32 | textbook, VSQRT", 1, 1), ("f32 | textbook", 1, 1)]);
        assert_eq!(nearest_hits(Part::Cost.figures(&chip.counted), "f32").count(), 1);
    }

    #[test]
    fn a_divide_and_a_root_take_what_the_table_of_latencies_says() {
        let table = raylet_tables::in_repository("tools/cycles/latencies.toml");
        let table = std::fs::read_to_string(table).expect("it is in the repository");
        for class in ["float_divide", "float_root"] {
            assert!(table.contains(&format!("\n{class} = {{ cycles = {DIVIDE_OR_ROOT},")), "{class}");
        }
    }

    #[test]
    fn what_is_told_follows_from_the_figures() {
        let mut text = String::new();
        let rows = [("f32 | Fast", 50, 150), ("I16F16 | Fast", 100, 200)];
        let textbook = [("f32 | textbook, VSQRT", 30, 60), ("f32 | textbook", 120, 180)];
        assert!(shown(&mut text, &measured(&[rows, textbook].concat())).is_some());
        for part in [
            "50 instructions and 150 cycles",
            "0.50 times the instructions of fixed point, and 0.75 times",
            "0.25 times the",
            "0.33 times its",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert!(shown(&mut text, &measured(&rows)).is_none(), "without the textbook nothing is told");
    }
}
