//! The tests of what raylet promises: one program, a module a promise, so that what is generic is compiled once for all
//! of them.
//!
//! `cargo test -p raylet-promises laws` runs the tests whose names hold `laws`.
#![cfg(test)]

#[macro_use]
extern crate support;

#[macro_use]
mod named;

mod cameras;
mod changed_rows;
mod chords;
mod constants;
mod contract;
mod contract_departures;
mod contract_refusals;
mod cuboids;
mod effects;
mod effects_ambient;
mod effects_cutoff;
mod effects_light;
mod effects_outline;
mod errata;
mod exact;
mod firmware;
mod frames;
mod frames_composed;
mod gallery;
mod hard_cases;
mod hierarchy;
mod kinds;
mod laws;
mod laws_symmetry;
mod laws_tiers;
mod named_bounds;
mod named_contract;
mod named_double_words;
mod named_judged;
mod named_placed;
mod named_searched;
mod named_surface;
mod named_surface_exact;
mod named_unplaced;
mod named_watertight;
mod nff;
mod nff_as_written;
mod no_overflow;
mod number_types;
mod numbers;
mod oracle;
mod oracle_departing;
mod oracle_drawn;
mod oracle_known;
mod oracle_numbers;
mod oracle_parts;
mod picture;
mod placement;
mod random_sizes;
mod rays;
mod reintersection;
mod shapes;
mod spans;
mod spans_exact;
mod spans_light;
mod spans_shadows;
mod surface;
mod watertight;
mod wider;
mod workloads;
