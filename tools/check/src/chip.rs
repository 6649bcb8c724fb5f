//! The figures of a chip: what was measured, and its baseline, a table of `data/chips` or `data/cycles`.

use clap::{Args, ValueEnum};
use raylet_tables::{Baseline, Figures, Outcome};

/// Which baseline is meant.
#[derive(Args)]
pub struct Chip {
    /// The target, as rustc names it.
    #[arg(long)]
    target: String,
    /// What `rustc --version` says of the compiler that built the programs: another one than the baseline's may be up
    /// to 15 % worse.
    #[arg(long)]
    compiler: String,
    /// Make what was measured the baseline.
    #[arg(long)]
    renew: bool,
    /// What was measured is no instructions, but modelled cycles; which end of the manuals' ranges was taken.
    #[arg(long)]
    cycles: Option<Cycles>,
}

/// Which end of a range of cycles.
#[derive(Clone, Copy, ValueEnum)]
pub enum Cycles {
    /// The most.
    Most,
    /// The least.
    Least,
}

/// The parts of a baseline.
#[derive(Clone, Copy)]
pub enum Part {
    /// Instructions and bytes of stack of a query.
    Cost,
    /// Instructions of what users do, query by query.
    Workload,
    /// Bytes a primitive, and a set of effects.
    Size,
    /// Instructions and bytes of stack a pixel, for each set of effects.
    Effects,
    /// Instructions a pixel, and rays, for each picture of the gallery; not of every chip.
    Gallery,
    /// Instructions a pixel of a display.
    Display,
    /// Instructions of the frames of an animation.
    Frames,
    /// Modelled cycles of a query, with the least of each range; only of chips whose manuals give ranges.
    LeastCost,
}

impl Part {
    const fn name(self) -> &'static str {
        match self {
            Self::Cost => "cost",
            Self::Workload => "workload",
            Self::Size => "size",
            Self::Effects => "effects",
            Self::Gallery => "gallery",
            Self::Display => "display",
            Self::Frames => "frames",
            Self::LeastCost => "cost at least",
        }
    }

    const fn unit(self) -> &'static str {
        match self {
            Self::Cost => "instructions and bytes of stack",
            Self::Workload => "instructions of what users do",
            Self::Size => "bytes",
            Self::Effects => "instructions and bytes of stack",
            Self::Gallery => "instructions and rays",
            Self::Display => "instructions a pixel",
            Self::Frames => "instructions a frame",
            Self::LeastCost => "modelled cycles",
        }
    }

    /// All figures of this part.
    pub fn figures(self, baseline: &Baseline) -> &Figures {
        baseline.part(self.name())
    }

    /// A figure of this part.
    pub fn figure(self, baseline: &Baseline, key: &str) -> Option<u64> {
        baseline.part(self.name()).get(key).copied()
    }
}

/// Where the figures of a target are, and the command that writes them.
fn place(target: &str, cycles: bool) -> (String, String) {
    let (folder, command) = if cycles { ("cycles", ".ci/cycles") } else { ("chips", ".ci/measure") };
    (format!("data/{folder}/{target}.tsv"), format!("{command} --renew {target}"))
}

/// The baseline of a target.
pub fn baseline(target: &str) -> Outcome<Baseline> {
    let (path, renew) = place(target, false);
    Baseline::read(&path, &renew)
}

/// The modelled cycles of a target.
pub fn cycles(target: &str) -> Outcome<Baseline> {
    let (path, renew) = place(target, true);
    Baseline::read(&path, &renew)
}

/// Compares what was measured with the baseline, or makes it the baseline.
pub fn check(chip: &Chip, part: Part, mut figures: Figures) -> Outcome {
    let Chip { target, compiler, renew, cycles } = chip;
    let (path, command) = place(target, cycles.is_some());
    let (part, unit) = match (cycles, part) {
        (None, _) => (part, part.unit()),
        (Some(Cycles::Most), _) => (part, Part::LeastCost.unit()),
        (Some(Cycles::Least), Part::Cost) => (Part::LeastCost, Part::LeastCost.unit()),
        (Some(Cycles::Least), _) => return Err(format!("{} has no least cycles", part.name()).into()),
    };
    if cycles.is_some() {
        figures = of_model(figures);
    }
    let count = figures.len();
    let now = Baseline::new(target, compiler, part.name(), figures);
    if !renew {
        return Baseline::read(&path, &command)?.compare(&now, part.name(), unit, &command);
    }
    if count == 0 {
        return Err("nothing was measured".into());
    }
    // Of another compiler, the other parts follow in the same run.
    println!("{target}: {count} figures in {unit}: the baseline is renewed");
    Baseline::read(&path, &command).unwrap_or_default().renewed(&now).write(&path)
}

/// What is stored of modelled cycles: of nearest hits, means of what users do and pixels, three digits of each. The
/// model is no finer.
fn of_model(figures: Figures) -> Figures {
    let is_stored = |name: &str| {
        let parts: Vec<_> = name.split(" | ").collect();
        match parts[..] {
            [_, query, _, _, what] => query == "nearest" && what != "stack",
            [_, _, _, what] => what == "mean",
            [.., what] => what == "instructions",
            [] => false,
        }
    };
    let rounded = |figure: u64| {
        let unit = 10_u64.pow(figure.max(1).ilog10().saturating_sub(2));
        (figure + unit / 2) / unit * unit
    };
    figures.into_iter().filter(|(name, _)| is_stored(name)).map(|(name, figure)| (name, rounded(figure))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use raylet_tables::CHIPS;

    #[test]
    fn every_chip_has_a_baseline_with_every_part() {
        for (target, _) in CHIPS {
            let baseline = baseline(target).expect("it is in the repository");
            assert_eq!(baseline.machine, target);
            for part in [Part::Cost, Part::Workload, Part::Size, Part::Effects] {
                assert!(!baseline.part(part.name()).is_empty(), "{target}: {}", part.name());
            }
        }
    }

    #[test]
    fn what_has_cycles_has_instructions_and_no_stack() {
        for (target, _) in CHIPS {
            let (instructions, cycles) = (baseline(target).expect("it is there"), cycles(target).expect("so is this"));
            assert_eq!(cycles.machine, target);
            for part in [Part::Cost, Part::Workload, Part::Effects] {
                // To model cycles takes hours: what is new may have none yet.
                let counted = part.figures(&instructions);
                for name in part.figures(&cycles).keys() {
                    assert!(counted.contains_key(name), "{target}: {}: {name}", part.name());
                }
            }
            let least = Part::LeastCost.figures(&cycles);
            assert!(least.is_empty() || least.keys().eq(Part::Cost.figures(&cycles).keys()), "{target}");
        }
    }

    #[test]
    fn the_least_cycles_are_not_more_than_the_most() {
        for (target, _) in CHIPS {
            let cycles = cycles(target).expect("it is in the repository");
            for (name, least) in Part::LeastCost.figures(&cycles) {
                let most = Part::Cost.figure(&cycles, name).unwrap_or_default();
                assert!(*least <= most, "{target}: {name}");
            }
        }
    }

    #[test]
    fn three_digits_of_what_is_shown_are_stored() {
        let names = [
            ("disc | nearest | f32 | Fast | hit", 12_345),
            ("disc | nearest | f32 | Fast | stack", 1),
            ("disc | uv | f32 | any | hit", 1),
            ("sensor | f32 | Fast | mean", 999),
            ("sensor | f32 | Fast | worst", 1),
            ("none | f32 | instructions", 1_995_001),
            ("none | f32 | stack", 1),
        ];
        let stored = of_model(names.map(|(name, figure)| (name.to_string(), figure)).into());
        assert_eq!(stored.into_values().collect::<Vec<_>>(), [12_300, 2_000_000, 999]);
    }
}
