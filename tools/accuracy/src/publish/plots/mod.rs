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
use std::error::Error;

/// Primitives whose error is plotted against cost: those that the firmware has the textbook of.
pub const COMPARED: [&str; 3] = ["sphere", "cylinder capped", "cone capped"];

/// A name in paths: `cylinder capped` is `cylinder-capped`, `Cortex-M0+` is `cortex-m0plus`.
pub fn in_path(name: &str) -> String {
    name.to_lowercase().replace(' ', "-").replace('+', "plus")
}

/// The path of a plot of error against cost; on the host if no chip is named.
pub fn cost_path(chip: Option<&str>, primitive: &str) -> String {
    format!("docs/plots/cost-{}-{}.svg", chip.map_or("host".into(), in_path), in_path(primitive))
}

/// The path of a plot of a sweep.
pub fn sweep_path(sweep: &str) -> String {
    format!("docs/plots/{sweep}.svg")
}

/// All plots, with their paths.
pub fn all(study: &Study) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let mut files = vec![];
    for primitive in COMPARED {
        files.push((cost_path(None, primitive), cost::plot(study, None, primitive)?));
        for chip in &study.chips {
            files.push((cost_path(Some(chip.name), primitive), cost::plot(study, Some(chip), primitive)?));
        }
    }
    for sweep in ["distance", "grazing"] {
        files.push((sweep_path(sweep), sweeps::plot(study, sweep)?));
    }
    Ok(files)
}
