//! What was measured when a baseline was made, and how far today's figures are from it.

use crate::{Outcome, Table, in_repository};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// A name for each figure.
pub type Figures = BTreeMap<String, u64>;

/// A figure may be this many hundredths larger than the baseline.
const SLACK: u64 = 2;
/// The same, where the baseline was made with another compiler, which makes other code: of the two that CI may find
/// (rustup's and Debian's) one is up to 5 % better here and as much worse there, a plane in fixed point even 13 %.
const SLACK_BETWEEN_COMPILERS: u64 = 15;
/// And this many at least.
const LEAST_SLACK: u64 = 2;

/// A renewal keeps a stored figure that differs by less than one part in so many.
const NOISE: u64 = 200;

/// So many changes are shown.
const SHOWN: usize = 60;

/// The figures of one machine, in parts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Baseline {
    /// What was measured: a target as rustc names it, or the architecture of a host.
    pub machine: String,
    /// What `rustc --version` said.
    pub compiler: String,
    /// The figures by part: `cost`, `size` and the like.
    pub parts: BTreeMap<String, Figures>,
}

impl Baseline {
    /// A baseline of one part.
    pub fn new(machine: &str, compiler: &str, part: &str, figures: Figures) -> Self {
        let parts = BTreeMap::from([(part.into(), figures)]);
        Self { machine: machine.into(), compiler: compiler.into(), parts }
    }

    /// Reads a table of the repository. `how_to_make` is the command that writes it, for the error.
    pub fn read(path: &str, how_to_make: &str) -> Outcome<Self> {
        let table = Table::read(path, how_to_make)?;
        let note = |name: &str| table.note(name).unwrap_or_default().to_string();
        let mut baseline = Self { machine: note("machine"), compiler: note("compiler"), parts: BTreeMap::new() };
        for row in &table.rows {
            let [part, what, figure] = &row[..] else {
                return Err(format!("{path}: three columns are expected").into());
            };
            let figure = figure.parse().map_err(|error| format!("{path}: {what}: {error}"))?;
            baseline.parts.entry(part.clone()).or_default().insert(what.clone(), figure);
        }
        Ok(baseline)
    }

    /// What is stored after another measurement. A figure within the noise of the stored one is not replaced, so that a
    /// renewal changes only what changed; parts that were not measured stay.
    pub fn renewed(&self, now: &Self) -> Self {
        let mut parts = self.parts.clone();
        for (part, figures) in &now.parts {
            let stored = self.part(part);
            let figure = |(name, now): (&String, &u64)| {
                let kept =
                    stored.get(name).filter(|before| before.abs_diff(*now) <= (*before / NOISE).max(LEAST_SLACK));
                (name.clone(), *kept.unwrap_or(now))
            };
            parts.insert(part.clone(), figures.iter().map(figure).collect());
        }
        Self { parts, machine: now.machine.clone(), compiler: now.compiler.clone() }
    }

    /// Makes it a table of the repository.
    pub fn write(&self, path: &str) -> Outcome {
        let mut table = Table::new(&["part", "what", "figure"])
            .with_note("machine", &self.machine)
            .with_note("compiler", &self.compiler);
        for (part, figures) in &self.parts {
            table
                .rows
                .extend(figures.iter().map(|(what, figure)| vec![part.clone(), what.clone(), figure.to_string()]));
        }
        let path = in_repository(path);
        fs::create_dir_all(path.parent().unwrap_or(&path))?;
        Ok(fs::write(path, table.text())?)
    }

    /// The figures of a part; none if it was not measured.
    pub fn part(&self, part: &str) -> &Figures {
        const NONE: &Figures = &Figures::new();
        self.parts.get(part).unwrap_or(NONE)
    }

    /// Prints what changed in a part, and fails if anything got worse, is new or is gone. `renew` is the command that
    /// makes what was measured the baseline, and `unit` what is counted.
    pub fn compare(&self, now: &Self, part: &str, unit: &str, renew: &str) -> Outcome {
        if self.machine != now.machine {
            let (before, now) = (&self.machine, &now.machine);
            return Err(format!("measured on {now}, the baseline on {before}: they cannot be compared").into());
        }
        if now.part(part).is_empty() {
            return Err("nothing was measured".into());
        }
        let slack = if self.compiler == now.compiler {
            SLACK
        } else {
            println!("built with {}, the baseline with {}", now.compiler, self.compiler);
            SLACK_BETWEEN_COMPILERS
        };
        let changes = changes(self.part(part), now.part(part), slack);
        let faults = changes.iter().filter(|change| change.is_fault()).count();
        let (machine, figures) = (&self.machine, now.part(part).len());
        println!("{machine}: {figures} figures in {unit}, {} changed by more than {slack} %", changes.len());
        if !changes.is_empty() {
            println!("\n| what | before | now | change |\n|---|---|---|---|");
            changes.iter().take(SHOWN).for_each(|change| println!("{}", change.line()));
            if changes.len() > SHOWN {
                println!("and {} more", changes.len() - SHOWN);
            }
            println!("\nIf that is what it should be: {renew}");
        }
        if faults > 0 {
            Err(format!("{machine}: {faults} figures in {unit} are worse, new or gone").into())
        } else {
            Ok(())
        }
    }
}

/// How a figure changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Change<'a> {
    name: &'a str,
    before: Option<u64>,
    now: Option<u64>,
}

impl Change<'_> {
    /// Only what got better is none.
    fn is_fault(self) -> bool {
        !matches!((self.before, self.now), (Some(before), Some(now)) if now < before)
    }

    fn line(self) -> String {
        let name = self.name.replace(" | ", ", ");
        match (self.before, self.now) {
            (Some(before), Some(now)) => {
                let percent = 100.0 * (now as f64 - before as f64) / before.max(1) as f64;
                format!("| {name} | {before} | {now} | {percent:+.1} % |")
            }
            (Some(before), None) => format!("| {name} | {before} | | gone |"),
            (None, now) => format!("| {name} | | {} | new |", now.unwrap_or_default()),
        }
    }
}

/// What changed by more than so many hundredths; what got worse first.
fn changes<'a>(before: &'a Figures, now: &'a Figures, hundredths: u64) -> Vec<Change<'a>> {
    let slack = |figure: u64| (figure * hundredths / 100).max(LEAST_SLACK);
    let names: BTreeSet<&String> = before.keys().chain(now.keys()).collect();
    let mut changes: Vec<_> = names
        .into_iter()
        .map(|name| Change { name, before: before.get(name).copied(), now: now.get(name).copied() })
        .filter(|change| match (change.before, change.now) {
            (Some(before), Some(now)) => before.abs_diff(now) > slack(before),
            _ => true,
        })
        .collect();
    changes.sort_by_key(|change| !change.is_fault());
    changes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(compiler: &str, figures: &[(&str, u64)]) -> Baseline {
        let figures = figures.iter().map(|(name, figure)| ((*name).to_string(), *figure)).collect();
        Baseline::new("a machine", compiler, "cost", figures)
    }

    fn compare(before: &Baseline, now: &Baseline) -> Outcome {
        before.compare(now, "cost", "instructions", "renew")
    }

    /// Whether the gate lets a figure of 1000 become another.
    fn passes(compiler: &str, now: u64) -> bool {
        compare(&counted("a", &[("query", 1000)]), &counted(compiler, &[("query", now)])).is_ok()
    }

    #[test]
    fn two_percent_pass_and_more_do_not() {
        assert!(passes("a", 1000) && passes("a", 1020));
        assert!(!passes("a", 1021));
        assert!(passes("a", 500), "what got better is no fault");
    }

    #[test]
    fn another_compiler_may_be_fifteen_percent_worse() {
        assert!(passes("b", 1150));
        assert!(!passes("b", 1151));
    }

    #[test]
    fn a_figure_that_comes_or_goes_is_a_fault() {
        let (one, two) = (counted("a", &[("query", 1000)]), counted("a", &[("query", 1000), ("another", 1)]));
        assert!(compare(&one, &two).is_err());
        assert!(compare(&two, &one).is_err());
        assert!(compare(&one, &counted("a", &[])).is_err());
    }

    #[test]
    fn two_more_are_no_change() {
        let before = counted("a", &[("query", 10)]);
        assert!(compare(&before, &counted("a", &[("query", 12)])).is_ok());
        assert!(compare(&before, &counted("a", &[("query", 13)])).is_err());
    }

    #[test]
    fn figures_of_another_machine_are_not_compared() {
        let before = Baseline { machine: "another".into(), ..counted("a", &[("query", 1000)]) };
        assert!(compare(&before, &counted("a", &[("query", 1000)])).is_err());
    }

    #[test]
    fn what_got_worse_comes_first() {
        let figures = |of: &[(&str, u64)]| of.iter().map(|(name, figure)| ((*name).to_string(), *figure)).collect();
        let before: Figures = figures(&[("a", 1000), ("b", 1000), ("c", 1000), ("d", 1000), ("e", 10)]);
        let after: Figures = figures(&[("a", 979), ("b", 980), ("c", 1020), ("d", 1021), ("e", 12)]);
        let names: Vec<_> = changes(&before, &after, SLACK).into_iter().map(|change| change.name).collect();
        assert_eq!(names, ["d", "a"]);
    }

    #[test]
    fn a_renewal_changes_only_what_changed() {
        let before = counted("a", &[("kept", 1000), ("changed", 1000), ("gone", 1)]);
        let now = counted("b", &[("kept", 1005), ("changed", 1006), ("new", 7)]);
        let stored = before.renewed(&now);
        assert_eq!(stored, counted("b", &[("kept", 1000), ("changed", 1006), ("new", 7)]));
        let other = Baseline::new("a machine", "b", "size", Figures::new());
        assert_eq!(before.renewed(&other).part("cost"), before.part("cost"));
    }

    #[test]
    fn the_baselines_in_the_repository_can_be_read() {
        let host = Baseline::read("data/host.tsv", "").expect("it is in the repository");
        assert!(host.part("cost").len() > 700 && host.part("cost").values().all(|figure| *figure > 0));
    }
}
