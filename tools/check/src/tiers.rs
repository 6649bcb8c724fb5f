//! Which numbers the tiers link: `Plain` none that is wider than its type, `Fast` none of those of `Exact`.

use crate::faults::none;
use crate::sets::{KINDS, PRIMITIVES};
use crate::{elf, programs};
use raylet_tables::Outcome;
use std::collections::BTreeSet;
use std::path::Path;

/// The numbers that have more digits than the type, or know their error, and the tiers that may link them.
const NUMBERS: [(&str, &[&str]); 7] = [
    ("running", &["Fast", "Stable", "Exact"]),
    ("robust", &["Fast", "Stable", "Exact"]),
    ("limbs", &["Fast", "Stable", "Exact"]),
    ("doubled", &["Stable"]),
    ("filtered", &["Exact"]),
    ("bounded", &["Exact"]),
    ("integer", &["Exact"]),
];

fn file(number: &str) -> String {
    format!("src/number/{number}.rs")
}

/// What is wrong with a program of a tier in which instructions of these files were found.
fn faults(program: &str, tier: &str, found: &BTreeSet<String>) -> Vec<String> {
    let forbidden = NUMBERS.iter().filter(|(_, tiers)| !tiers.contains(&tier)).map(|(number, _)| file(number));
    let found = forbidden.filter(|file| found.contains(file));
    found.map(|file| format!("{program}: there are instructions of {file}, which is not of {tier}")).collect()
}

/// Shows that no program of a tier has an instruction of a number that is not of that tier, and that each number is
/// found in some program.
pub fn check(directory: &Path) -> Outcome {
    let (mut wrong, mut seen) = (Vec::new(), BTreeSet::new());
    for primitive in PRIMITIVES {
        for [number, tier] in KINDS {
            let program = programs::of_primitive(primitive, [number, tier]);
            let found = elf::sources(&directory.join(&program), &["src/number/"])?;
            wrong.extend(faults(&program, tier, &found));
            seen.extend(found);
        }
    }
    for (number, _) in NUMBERS {
        if !seen.contains(&file(number)) {
            wrong.push(format!("no instruction of {} in any program: the line tables prove nothing", file(number)));
        }
    }
    none(&wrong)?;
    println!("{} programs of one tier: no number of another tier is in them", PRIMITIVES.len() * KINDS.len());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_another_tier_is_a_fault() {
        let found = |numbers: &[&str]| numbers.iter().map(|number| file(number)).collect();
        assert!(faults("cone", "Plain", &found(&["plain", "mod"])).is_empty());
        assert!(faults("cone", "Stable", &found(&["running", "doubled", "robust", "limbs"])).is_empty());
        let told = faults("cone", "Plain", &found(&["plain", "limbs"]));
        assert_eq!(told, ["cone: there are instructions of src/number/limbs.rs, which is not of Plain"]);
        assert_eq!(faults("cone", "Plain", &found(&NUMBERS.map(|(number, _)| number))).len(), NUMBERS.len());
    }

    #[test]
    fn a_number_is_there() {
        for (number, _) in NUMBERS {
            assert!(raylet_tables::in_repository(&file(number)).exists(), "{number}");
        }
    }
}
