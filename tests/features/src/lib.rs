//! Tests of what the optional features add, and that they change no bit.
#![cfg(test)]

mod display;
mod display_pictures;
mod interchange;
mod one_bit;
mod stored_scene;

#[path = "../examples/glam.rs"]
mod glam_example;
#[path = "../examples/nalgebra.rs"]
mod nalgebra_example;

use std::fmt::Write;

#[test]
fn examples_of_other_vectors_run() {
    glam_example::main().expect("it runs");
    nalgebra_example::main().expect("it runs");
}

/// With every feature the digest of all answers is what it is without (`tests/promises/src/firmware.rs`).
#[test]
fn no_feature_changes_a_bit() {
    let mut text = String::new();
    shared::digest::all(&mut |number, tier, shape, digest| {
        writeln!(text, "{number} {tier} {shape}: {digest:016x}").expect("a string takes everything");
    });
    let expected = raylet_tables::in_repository("examples/firmware/expected/digest.txt");
    assert_eq!(text, std::fs::read_to_string(expected).expect("the file is in the repository"));
}
