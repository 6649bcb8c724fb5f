//! What the baselines say: instructions a query on four chips and on the host, and bytes of programs on the chips.

use raylet_tables::{Baseline, CHIPS, Outcome};
use support::figures::Figures;

/// One chip.
pub struct Chip {
    pub name: &'static str,
    cost: raylet_tables::Figures,
    workloads: raylet_tables::Figures,
    sizes: raylet_tables::Figures,
}

/// Instructions of a nearest hit, for rays that hit and for rays that miss.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions {
    pub hit: u64,
    pub miss: u64,
}

/// True if the firmware's rays are like those of the workload: from 2 to 6 away. Other rays may take more (those that
/// graze, those from so far that a short product does not hold them), and for them the same figure is only where it
/// starts.
pub fn is_like(row: &Figures) -> bool {
    row.workload == "benign"
}

/// A subject of the firmware's.
fn subject(row: &Figures) -> Option<String> {
    let name = match row.primitive {
        "frustum capped" => "frustum".into(),
        "frustum open" | "frustum widening" | "frustum pointed" => return None,
        primitive => primitive.replacen(' ', ", ", 1),
    };
    if row.is_unplaced() {
        return Some(name);
    }
    // The firmware's frames turn; none only moves.
    let places = [("turned", "framed"), ("stretched", "stretched")];
    let (_, place) = places.into_iter().find(|(placed, _)| row.placed.starts_with(placed))?;
    Some(format!("{name}, {place}"))
}

impl Chip {
    fn new(name: &'static str, baseline: &Baseline) -> Self {
        let part = |part: &str| baseline.part(part).clone();
        Self { name, cost: part("cost"), workloads: part("workload"), sizes: part("size") }
    }

    /// What a workload's nearest hits take in the mean; `None` if the firmware does not measure it.
    pub fn of_workload(&self, workload: &str, number: &str, tier: &str) -> Option<u64> {
        self.workloads.get(&format!("{workload} | {number} | {tier} | mean")).copied()
    }

    /// Bytes of a program that finds the nearest hit of a row's primitive, not placed, in its number type and tier;
    /// `None` if there is none.
    pub fn flash(&self, row: &Figures) -> Option<u64> {
        let primitive = row.primitive.split(' ').next()?;
        self.sizes.get(&format!("{primitive} | {} | {}", row.number, row.tier)).copied()
    }

    /// What a row costs; `None` if the firmware does not measure it.
    pub fn instructions(&self, row: &Figures) -> Option<Instructions> {
        let subject = subject(row)?;
        let figure = |tier: &str, rays: &str| {
            self.cost.get(&format!("{subject} | nearest | {} | {tier} | {rays}", row.number)).copied()
        };
        let of = |tier: &str| Some(Instructions { hit: figure(tier, "hit")?, miss: figure(tier, "miss")? });
        if row.tier == "Textbook" {
            // With the chip's own square root, where it has one.
            return of("textbook, VSQRT").or_else(|| of("textbook"));
        }
        of(row.tier)
    }
}

/// The baselines of all chips.
pub fn read() -> Outcome<Vec<Chip>> {
    CHIPS
        .into_iter()
        .map(|(target, name)| {
            let baseline = Baseline::read(&format!("data/chips/{target}.tsv"), ".ci/measure --renew")?;
            Ok(Chip::new(name, &baseline))
        })
        .collect()
}

/// The same of the host, where bytes are not counted.
pub fn host() -> Outcome<Chip> {
    Ok(Chip::new("host", &Baseline::read("data/host.tsv", ".ci/instructions --renew")?))
}
