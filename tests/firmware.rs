//! The promise: the same bits everywhere. A digest of every answer to a fixed set of rays is the same on the host as the
//! firmware prints on each chip; `.ci/firmware` compares those with the same file.
//!
//! `RAYLET_WRITE_DIGEST=1 cargo test --test firmware` writes the file anew.

#[path = "../examples/firmware/src/digest.rs"]
mod digest;

use std::fmt::Write;

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/firmware/expected/digest.txt");

#[test]
fn the_host_gives_the_bits_of_the_chips() {
    let mut text = String::new();
    digest::all(&mut |number, tier, shape, digest| {
        writeln!(text, "{number} {tier} {shape}: {digest:016x}").expect("a string takes everything");
    });
    if std::env::var_os("RAYLET_WRITE_DIGEST").is_some() {
        std::fs::write(PATH, &text).expect("the file can be written");
    }
    let expected = std::fs::read_to_string(PATH).expect("the expected digests are in the repository");
    for (line, expected) in text.lines().zip(expected.lines()) {
        assert_eq!(line, expected);
    }
    assert_eq!(text, expected);
}
