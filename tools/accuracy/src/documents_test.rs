//! The promise: the tables of the README, docs/overview.md, docs/accuracy.md and docs/which-one.md and the plots show
//! what the repository holds, and what the pages claim of rows holds: the bound table, the times and sweeps of the last
//! `cargo run --release -p raylet-accuracy -- --write`, the firmware's baselines.
//!
//! Nothing is measured here: `tests/promises/src/number_types.rs` holds the library to the bound table.

use crate::publish;
use crate::stored;
use raylet_tables::page::difference;
use support::in_repository;

/// How to renew the documents without measuring.
const RENEW: &str =
    "renew them: cargo run --release -p raylet-accuracy -- --document (--write measures everything anew)";

#[test]
fn the_documents_show_what_the_repository_holds() {
    for (path, wanted) in publish::documents(&stored::study().unwrap()).unwrap() {
        let held = std::fs::read_to_string(in_repository(&path)).unwrap_or_default();
        assert_eq!(difference(&held, &wanted), None, "{path} is not what it should be; {RENEW}");
    }
}

/// What is no longer in the pages can be printed.
#[test]
fn every_page_is_printed() {
    let study = stored::study().unwrap();
    for name in publish::names() {
        let page = publish::printed(&study, name);
        assert!(page.lines().filter(|line| line.starts_with("| ")).count() > 10, "{name}");
    }
    let rows = |name| publish::printed(&study, name);
    assert!(rows("Exact").contains("# Rows of `f32`") && !rows("Exact").contains("| Stable |"));
    assert!(rows("I16F16").contains("| benign | Stable | 4000 | "));
}

/// Primitives whose times on a host have not been measured yet; `--write` measures them. Their instructions are in
/// data/host.tsv.
const NOT_TIMED: [&str; 3] = ["prism", "polyhedron", "torus"];

/// What a number type, a tier or a primitive costs is shown for each: that there is a time counts here, not which.
#[test]
fn no_primitive_or_number_type_is_missing() {
    use support::figures::{NUMBERS, TIERS};
    let study = stored::study().unwrap();
    for number in NUMBERS {
        for primitive in support::subject::SUBJECTS {
            for tier in &TIERS[..4] {
                let row = study.row(number, tier, primitive, "benign");
                let row = row.unwrap_or_else(|| panic!("{number} {tier}, {primitive}: no figures"));
                let is_timed = study.time(row).is_some();
                assert_eq!(is_timed, !NOT_TIMED.contains(&primitive), "{number} {tier}, {primitive}: a time");
            }
        }
    }
    assert_eq!(study.chips.len(), 4);
    assert!(!publish::summary(&study).is_empty());
}
