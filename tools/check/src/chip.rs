//! The figures of a chip: what was measured, and its baseline, a table of `data/chips`.

use clap::Args;
use raylet_tables::{Baseline, Figures, Outcome};

/// Which baseline is meant.
#[derive(Args)]
pub struct Chip {
    /// The target, as rustc names it.
    #[arg(long)]
    target: String,
    /// What `rustc --version` says of the compiler that built the programs: another one than the baseline's may be up to 15 % worse.
    #[arg(long)]
    compiler: String,
    /// Make what was measured the baseline.
    #[arg(long)]
    renew: bool,
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
}

impl Part {
    const fn name(self) -> &'static str {
        match self {
            Self::Cost => "cost",
            Self::Workload => "workload",
            Self::Size => "size",
            Self::Effects => "effects",
            Self::Gallery => "gallery",
        }
    }

    const fn unit(self) -> &'static str {
        match self {
            Self::Cost => "instructions and bytes of stack",
            Self::Workload => "instructions of what users do",
            Self::Size => "bytes",
            Self::Effects => "instructions and bytes of stack",
            Self::Gallery => "instructions and rays",
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

fn path(target: &str) -> String {
    format!("data/chips/{target}.tsv")
}

/// The baseline of a target.
pub fn baseline(target: &str) -> Outcome<Baseline> {
    Baseline::read(&path(target), &format!(".ci/measure --renew {target}"))
}

/// Compares what was measured with the baseline, or makes it the baseline.
pub fn check(chip: &Chip, part: Part, figures: Figures) -> Outcome {
    let Chip { target, compiler, renew } = chip;
    let count = figures.len();
    let now = Baseline::new(target, compiler, part.name(), figures);
    if !renew {
        return baseline(target)?.compare(&now, part.name(), part.unit(), &format!(".ci/measure --renew {target}"));
    }
    if count == 0 {
        return Err("nothing was measured".into());
    }
    // Of another compiler, the other parts follow in the same run.
    let before = baseline(target).unwrap_or_default();
    let parts = before.parts.into_iter().chain(now.parts).collect();
    println!("{target}: {count} figures in {}: the baseline is renewed", part.unit());
    Baseline { parts, ..now }.write(&path(target))
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
}
