//! Every small example runs, and finds what it says. `examples/render` has tests of its own, in the repository.
//!
//! `cargo test` builds the examples before it runs tests. `cargo test --test examples` does not: it runs those that
//! the last build left.

use std::env;
use std::process::Command;

/// The example ends without an error, and prints something.
fn runs(name: &str) {
    // This test is `target/debug/deps/examples-<hash>`, an example `target/debug/examples/<name>`.
    let test = env::current_exe().expect("the path of this test");
    let folder = test.ancestors().nth(2).expect("the folder of the build");
    let program = folder.join("examples").join(format!("{name}{}", env::consts::EXE_SUFFIX));
    let output = Command::new(&program)
        .output()
        .unwrap_or_else(|error| panic!("{}: {error}; build it with `cargo build --examples`", program.display()));
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    assert!(!output.stdout.is_empty(), "{name} prints nothing");
}

#[test]
fn a_ball_is_pushed_through_a_gap() {
    runs("character");
}

#[test]
fn many_rays_run_on_all_processors() {
    runs("many_rays");
}

#[test]
fn a_display_of_one_bit_shows_outlines() {
    runs("one_bit");
}

#[test]
fn a_picture_of_ones_own_has_light_and_shadow() {
    runs("own_picture");
}

#[test]
fn what_is_under_the_pointer_is_picked() {
    runs("picking");
}

#[test]
fn the_sensor_sees_the_posts() {
    runs("range");
}

#[test]
fn the_wall_has_its_thickness() {
    runs("thickness");
}

#[test]
fn the_tiers_tell_the_same_part() {
    runs("tiers");
}
