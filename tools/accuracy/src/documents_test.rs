//! The promise: docs/accuracy.md, docs/accuracy/, docs/which-one.md, docs/plots/ and the tables of the README and of
//! docs/overview.md show what the repository holds: the bound table, the times and sweeps of the last
//! `cargo run --release -p raylet-accuracy -- --write`, the firmware's baselines.
//!
//! Nothing is measured here: `tests/promises/src/number_types.rs` holds the library to the bound table.

use crate::study::Study;
use crate::{difference, publish};
use std::fmt::Write;
use support::in_repository;

/// How to renew the documents without measuring.
const RENEW: &str =
    "renew them: cargo run --release -p raylet-accuracy -- --document (--write measures everything anew)";

#[test]
fn the_documents_show_what_the_repository_holds() {
    let study = Study::committed().unwrap();
    let mut wrong = String::new();
    for (path, wanted) in publish::documents(&study, &in_repository("")).unwrap() {
        let held = std::fs::read_to_string(in_repository(&path)).unwrap_or_default();
        if let Some(lines) = difference::between(&held, &wanted) {
            writeln!(wrong, "{path}:\n{lines}").unwrap();
        }
    }
    assert!(wrong.is_empty(), "documents are not what they should be; {RENEW}\n{wrong}");
}

/// An advice whose ground has gone says so in the document; then it is time to write another.
#[test]
fn every_advice_is_backed_by_its_rows() {
    let text = std::fs::read_to_string(in_repository("docs/which-one.md")).unwrap();
    let broken: Vec<_> = text.lines().filter(|line| line.contains("does not hold any more")).collect();
    assert!(broken.is_empty(), "write another advice (tools/accuracy/src/publish/advice.rs): {broken:#?}");
}

/// What a number type, a tier or a primitive costs is shown for each: that there is a time counts here, not which.
#[test]
fn no_primitive_or_number_type_is_missing() {
    use support::figures::{NUMBERS, TIERS};
    let study = Study::committed().unwrap();
    for number in NUMBERS {
        for primitive in support::subject::SUBJECTS {
            for tier in &TIERS[..4] {
                let row = study.row(number, tier, primitive, "benign");
                let row = row.unwrap_or_else(|| panic!("{number} {tier}, {primitive}: no figures"));
                assert!(study.time(row).is_some(), "{number} {tier}, {primitive}: no time");
            }
        }
    }
    assert_eq!(study.chips.len(), 4);
    assert!(!publish::summary(&study).is_empty());
}
