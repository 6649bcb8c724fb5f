//! What was counted when the baseline was made, and how far today's figures are from it.

use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::env::consts::ARCH;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// A name for each figure.
pub type Figures = BTreeMap<String, u64>;

/// A figure may be this many hundredths larger than the baseline.
const SLACK: u64 = 2;
/// The same, where the baseline was made with another compiler, which makes other code.
const SLACK_BETWEEN_COMPILERS: u64 = 15;
/// And this many instructions at least.
const LEAST_SLACK: u64 = 2;

/// So many changes are shown.
const SHOWN: usize = 60;

/// The baseline.
pub struct Baseline {
    /// The architecture that it was counted on.
    pub architecture: String,
    /// What `rustc --version` said.
    pub compiler: String,
    /// Instructions a query.
    pub figures: Figures,
}

fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/baseline.json")
}

impl Baseline {
    /// One of this machine.
    pub fn new(compiler: &str, figures: Figures) -> Self {
        Self { architecture: ARCH.into(), compiler: compiler.into(), figures }
    }

    /// The one in the repository.
    pub fn read() -> Result<Self, Box<dyn Error>> {
        let path = path();
        let text = fs::read_to_string(&path)
            .map_err(|error| format!("{}: {error}; make it with `.ci/instructions --renew`", path.display()))?;
        let value: Value = serde_json::from_str(&text)?;
        let word = |name: &str| value[name].as_str().unwrap_or_default().to_string();
        let figures = value["instructions"].as_object().into_iter().flatten();
        let figures = figures.filter_map(|(name, figure)| Some((name.clone(), figure.as_u64()?))).collect();
        Ok(Self { architecture: word("architecture"), compiler: word("compiler"), figures })
    }

    /// Makes it the one in the repository.
    pub fn write(&self) -> Result<(), Box<dyn Error>> {
        let Self { architecture, compiler, figures } = self;
        let value = json!({ "architecture": architecture, "compiler": compiler, "instructions": figures });
        Ok(fs::write(path(), serde_json::to_string_pretty(&value)? + "\n")?)
    }

    /// Says what changed; an error if anything got worse, is new or is gone.
    pub fn compare(&self, now: &Self) -> Result<(), Box<dyn Error>> {
        if self.architecture != now.architecture {
            let (before, now) = (&self.architecture, &now.architecture);
            return Err(format!("counted on {now}, the baseline on {before}: they cannot be compared").into());
        }
        let slack = if self.compiler == now.compiler {
            SLACK
        } else {
            println!("built with {}, the baseline with {}", now.compiler, self.compiler);
            SLACK_BETWEEN_COMPILERS
        };
        let changes = changes(&self.figures, &now.figures, slack);
        let faults = changes.iter().filter(|change| change.is_fault()).count();
        println!("{} figures in instructions, {} changed by more than {slack} %", now.figures.len(), changes.len());
        if !changes.is_empty() {
            println!("\n| what | before | now | change |\n|---|---|---|---|");
            changes.iter().take(SHOWN).for_each(|change| println!("{}", change.line()));
            if changes.len() > SHOWN {
                println!("and {} more", changes.len() - SHOWN);
            }
            println!("\nIf that is what it should be: .ci/instructions --renew");
        }
        if faults > 0 { Err(format!("{faults} figures are worse, new or gone").into()) } else { Ok(()) }
    }
}

/// How a figure changed.
#[derive(Clone, Copy)]
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
    let names: std::collections::BTreeSet<&String> = before.keys().chain(now.keys()).collect();
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
