//! The readings of the program `sensor` on the chips are the host's. `.ci/sensor` compares them with the same file.
//!
//! `RAYLET_WRITE_EXPECTED=1 cargo test -p raylet-sensors firmware` writes it anew.

use raylet::sensor::Reading;
use shared::sensor::{Number, OBSTACLES, PLACES, Row, ZONES, sensor, zones};
use std::fmt::Write;

#[test]
fn the_host_reads_what_the_chips_do() {
    let (zones, sensor) = (zones().expect("zones"), sensor().expect("a sensor"));
    let mut text = String::new();
    for row in 0..ZONES {
        let readings: Vec<Reading<Number, 1>> =
            (0..ZONES).map(|column| sensor.read(&OBSTACLES[..], zones.rays(column, row), 0)).collect();
        writeln!(text, "{}", Row(&readings)).expect("a string takes everything");
    }
    let path = support::in_repository("examples/firmware/expected/sensor.txt");
    if std::env::var_os("RAYLET_WRITE_EXPECTED").is_some() {
        std::fs::write(&path, &text).expect("the file can be written");
    }
    let expected = std::fs::read_to_string(&path).expect("the expected file is in the repository");
    assert_eq!(text, expected, "RAYLET_WRITE_EXPECTED=1 cargo test -p raylet-sensors firmware");
}

#[test]
fn the_obstacles_in_flash_are_the_ground_and_a_post_at_each_place() {
    assert_eq!(OBSTACLES.len(), PLACES.len() + 1);
    for (post, [right, ahead]) in OBSTACLES[1..].iter().zip(PLACES) {
        let [x, y, z] = post.frame().expect("it is placed").position().to_f64();
        let off = [x - f64::from(right) / 100.0, y, z + f64::from(ahead) / 100.0];
        assert!(off.iter().all(|off| off.abs() < 1e-5), "{off:?}");
    }
}
