//! What the firmware's baselines say: instructions a query on four chips.

use crate::support::figures::Figures;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;

/// The chips, by target.
const CHIPS: [(&str, &str); 4] = [
    ("thumbv6m-none-eabi", "Cortex-M0+"),
    ("thumbv7m-none-eabi", "Cortex-M3"),
    ("thumbv7em-none-eabihf", "Cortex-M4F"),
    ("riscv32imc-unknown-none-elf", "RV32IMC"),
];

/// One chip.
pub struct Chip {
    pub name: &'static str,
    cost: BTreeMap<String, u64>,
}

/// Instructions of a nearest hit, for rays that hit and for rays that miss.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions {
    pub hit: u64,
    pub miss: u64,
}

impl Instructions {
    pub fn both(self) -> [u64; 2] {
        [self.hit, self.miss]
    }
}

/// True if the firmware's rays are like those of the workload: from 2 to 6 away. Other rays may take more (those that graze, those
/// from so far that a short product does not hold them), and for them the same figure is only where it starts.
pub fn is_like(workload: &str) -> bool {
    workload == "benign" || workload.starts_with("framed") || workload.starts_with("stretched")
}

/// A subject of the firmware's, by a row's names.
fn subject(primitive: &str, workload: &str) -> Option<String> {
    let name = match primitive {
        "frustum capped" => "frustum".into(),
        "frustum open" | "frustum widening" | "frustum pointed" => return None,
        _ => primitive.replacen(' ', ", ", 1),
    };
    let place = ["framed", "stretched"].into_iter().find(|place| workload.starts_with(place));
    match place {
        None => Some(name),
        Some(place) if primitive == "cylinder capped" => Some(format!("{name}, {place}")),
        Some(_) => None,
    }
}

impl Chip {
    /// What a row costs; `None` if the firmware does not measure it.
    pub fn instructions(&self, row: &Figures) -> Option<Instructions> {
        let subject = subject(row.primitive, &row.workload)?;
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
pub fn read(root: &Path) -> Result<Vec<Chip>, Box<dyn Error>> {
    CHIPS
        .into_iter()
        .map(|(target, name)| {
            let path = format!("examples/firmware/baseline/{target}.json");
            let text = std::fs::read_to_string(root.join(&path))
                .map_err(|error| format!("{path} cannot be read: {error}; `.ci/measure --renew` makes it"))?;
            let all: serde_json::Value = serde_json::from_str(&text).map_err(|error| format!("{path}: {error}"))?;
            let figures = all["cost"].as_object().ok_or_else(|| format!("{path} has no table `cost`"))?;
            let cost = figures.iter().filter_map(|(name, figure)| Some((name.clone(), figure.as_u64()?))).collect();
            Ok(Chip { name, cost })
        })
        .collect()
}
