//! The plots, as SVG that reads on light and on dark pages.
//!
//! | module | what it holds |
//! |---|---|
//! | `sheet` | a sheet of panels with a legend; its colours |
//! | `cost` | error against cost, a panel a workload |
//! | `rays` | errors of a file of rays by the share of hits that exceed them, and against cost |
//! | `sweeps` | error against distance and grazing, a line a tier |

mod cost;
pub mod rays;
mod sheet;
mod sweeps;

use crate::study::Study;
use raylet_tables::Outcome;

/// Primitives whose error is plotted against cost: those that the firmware has the textbook of.
pub const COMPARED: [&str; 3] = ["sphere", "cylinder capped", "cone capped"];

/// A name in paths: `cylinder capped` is `cylinder-capped`, `Cortex-M0+` is `cortex-m0plus`.
fn in_path(name: &str) -> String {
    name.to_lowercase().replace(' ', "-").replace('+', "plus")
}

/// The plots that pages of the repository show.
pub const SHOWN: [&str; 3] = ["distance.svg", "grazing.svg", "cost-host-sphere.svg"];

/// All plots, with the names of their files.
pub fn all(study: &Study) -> Outcome<Vec<(String, String)>> {
    let mut files = vec![];
    for primitive in COMPARED {
        for chip in [None].into_iter().chain(study.chips.iter().map(Some)) {
            let machine = chip.map_or("host", |chip| chip.name);
            let name = format!("cost-{}-{}.svg", in_path(machine), in_path(primitive));
            files.push((name, cost::plot(study, chip, primitive)?));
        }
    }
    for sweep in ["distance", "grazing"] {
        files.push((format!("{sweep}.svg"), sweeps::plot(study, sweep)?));
    }
    Ok(files)
}
