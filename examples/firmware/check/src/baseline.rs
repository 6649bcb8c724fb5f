//! What was measured when the baseline was made, and how far today's figures are from it.

use crate::{Chip, Outcome};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// A name for each figure.
pub type Figures = BTreeMap<String, u64>;

/// A figure may be this many hundredths larger than the baseline. Another compiler makes other code: of the two that CI may find
/// (rustup's and Debian's) one is up to 5 % better here and as much worse there, a plane in fixed point even 13 %.
const SLACK: u64 = 2;
/// The same, where the baseline was made with another compiler.
const SLACK_BETWEEN_COMPILERS: u64 = 15;
/// And this many instructions or bytes at least.
const LEAST_SLACK: u64 = 2;

/// So many changes are shown.
const SHOWN: usize = 60;

/// The parts of a baseline.
#[derive(Clone, Copy)]
pub enum Part {
    /// Instructions a query.
    Cost,
    /// Bytes a primitive, and a set of effects.
    Size,
    /// Instructions and bytes of stack a pixel, for each set of effects.
    Effects,
    /// Instructions a pixel, and rays, for each picture of the gallery.
    Gallery,
}

/// A baseline: one for each target.
#[derive(Default, Serialize, Deserialize)]
pub struct Baseline {
    /// What `rustc --version` said.
    pub compiler: String,
    /// Instructions a query.
    pub cost: Figures,
    /// Bytes a primitive, and a set of effects.
    pub size: Figures,
    /// Instructions and bytes of stack a pixel, for each set of effects.
    #[serde(default)]
    pub effects: Figures,
    /// Instructions a pixel, and rays, for each picture of the gallery; empty for chips on which it is not drawn.
    #[serde(default)]
    pub gallery: Figures,
}

/// Where the baselines stand.
fn path(target: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../baseline/{target}.json"))
}

impl Baseline {
    /// The baseline of a target.
    pub fn read(target: &str) -> Result<Self, Box<dyn Error>> {
        let path = path(target);
        let text = fs::read_to_string(&path)
            .map_err(|error| format!("{}: {error}; make it with `.ci/measure --renew`", path.display()))?;
        Ok(serde_json::from_str(&text)?)
    }

    fn part(&mut self, part: Part) -> &mut Figures {
        match part {
            Part::Cost => &mut self.cost,
            Part::Size => &mut self.size,
            Part::Effects => &mut self.effects,
            Part::Gallery => &mut self.gallery,
        }
    }

    fn write(&self, target: &str) -> Outcome {
        let path = path(target);
        fs::create_dir_all(path.parent().unwrap_or(Path::new(".")))?;
        Ok(fs::write(path, serde_json::to_string_pretty(self)? + "\n")?)
    }
}

/// How a figure changed.
#[derive(Debug, PartialEq, Eq)]
enum Change<'a> {
    Worse(&'a str, u64, u64),
    Better(&'a str, u64, u64),
    New(&'a str, u64),
    Gone(&'a str, u64),
}

impl Change<'_> {
    fn is_fault(&self) -> bool {
        !matches!(self, Self::Better(..))
    }

    fn line(&self) -> String {
        let percent = |before: u64, after: u64| 100.0 * (after as f64 - before as f64) / before.max(1) as f64;
        match *self {
            Self::Worse(name, before, after) | Self::Better(name, before, after) => {
                let change = percent(before, after);
                format!("| {} | {before} | {after} | {change:+.1} % |", name.replace(" | ", ", "))
            }
            Self::New(name, after) => format!("| {} | | {after} | new |", name.replace(" | ", ", ")),
            Self::Gone(name, before) => format!("| {} | {before} | | gone |", name.replace(" | ", ", ")),
        }
    }
}

/// What changed by more than so many hundredths; what got worse first.
fn changes<'a>(before: &'a Figures, after: &'a Figures, hundredths: u64) -> Vec<Change<'a>> {
    let slack = |figure: u64| (figure * hundredths / 100).max(LEAST_SLACK);
    let mut changes = Vec::new();
    for (name, &now) in after {
        match before.get(name) {
            None => changes.push(Change::New(name, now)),
            Some(&was) if now > was + slack(was) => changes.push(Change::Worse(name, was, now)),
            Some(&was) if now + slack(was) < was => changes.push(Change::Better(name, was, now)),
            Some(_) => {}
        }
    }
    let gone = before.iter().filter(|(name, _)| !after.contains_key(*name));
    changes.extend(gone.map(|(name, &was)| Change::Gone(name, was)));
    changes.sort_by_key(|change| !change.is_fault());
    changes
}

/// Compares what was measured with the baseline, or makes it the baseline.
pub fn check(chip: &Chip, part: Part, figures: &Figures) -> Outcome {
    if figures.is_empty() {
        return Err("nothing was measured".into());
    }
    let what = match part {
        Part::Cost => "instructions",
        Part::Size => "bytes",
        Part::Effects => "instructions and bytes of stack",
        Part::Gallery => "instructions and rays",
    };
    if chip.renew {
        // Made anew with another compiler, the other part follows in the same run.
        let mut baseline = Baseline::read(&chip.target).unwrap_or_default();
        baseline.compiler.clone_from(&chip.compiler);
        baseline.part(part).clone_from(figures);
        println!("{}: {} figures in {what}: the baseline is renewed", chip.target, figures.len());
        return baseline.write(&chip.target);
    }
    let mut baseline = Baseline::read(&chip.target)?;
    let slack = if baseline.compiler == chip.compiler {
        SLACK
    } else {
        println!("built with {}, the baseline with {}", chip.compiler, baseline.compiler);
        SLACK_BETWEEN_COMPILERS
    };
    let changes = changes(baseline.part(part), figures, slack);
    let faults = changes.iter().filter(|change| change.is_fault()).count();
    println!("{}: {} figures in {what}, {} changed by more than {slack} %", chip.target, figures.len(), changes.len());
    if !changes.is_empty() {
        println!("\n| what | before | now | change |\n|---|---|---|---|");
        changes.iter().take(SHOWN).for_each(|change| println!("{}", change.line()));
        if changes.len() > SHOWN {
            println!("and {} more", changes.len() - SHOWN);
        }
        println!("\nIf that is what it should be: .ci/measure --renew {}", chip.target);
    }
    if faults > 0 {
        Err(format!("{}: {faults} figures in {what} are worse, new or gone", chip.target).into())
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figures(of: &[(&str, u64)]) -> Figures {
        of.iter().map(|(name, figure)| ((*name).to_string(), *figure)).collect()
    }

    #[test]
    fn two_percent_are_no_change_and_what_got_worse_comes_first() {
        let before = figures(&[("a", 1000), ("b", 1000), ("c", 1000), ("d", 1000), ("e", 10)]);
        let after = figures(&[("a", 979), ("b", 980), ("c", 1020), ("d", 1021), ("e", 12)]);
        assert_eq!(changes(&before, &after, SLACK), [Change::Worse("d", 1000, 1021), Change::Better("a", 1000, 979)]);
    }

    #[test]
    fn a_figure_that_comes_or_goes_is_a_fault() {
        let (before, after) = (figures(&[("a", 1)]), figures(&[("b", 1)]));
        assert!(changes(&before, &after, SLACK).iter().all(Change::is_fault));
        assert_eq!(changes(&before, &after, SLACK).len(), 2);
    }
}
