//! Prints raylet's nearest hit of each hard case, in the tier `Stable` and a number type (`f32` or `f64`): the case's
//! name, a tab, and the distance, or `none`. `data/cases/judge.py` says how many are wrong.

use raylet::Stable;
use std::process::ExitCode;
use support::exact_types::Exact;
use support::hard_case::check::of_type;
use support::hard_case::classes;

fn answers<S: Exact>() {
    for case in classes().iter().flat_map(|(_, cases)| *cases) {
        if let Some((shape, _, ray, _)) = of_type::<S>(case) {
            let hit = shape.nearest_at::<Stable>(&ray).map(|hit| format!("{:?}", hit.t.to_f64()));
            println!("{}\t{}", case.name, hit.unwrap_or_else(|| "none".into()));
        }
    }
}

fn main() -> ExitCode {
    match std::env::args().nth(1).as_deref() {
        Some("f32") => answers::<f32>(),
        Some("f64") => answers::<f64>(),
        _ => {
            eprintln!("usage: answers f32|f64");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
