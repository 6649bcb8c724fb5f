//! The sensor of the program `sensor`, by the first numbers of `Fast` over a list, with nothing else in the program: the
//! flash and the stack of a product. It measures once, leaves the distances of all zones in a static, and stops.
#![no_std]
#![no_main]

use core::sync::atomic::{AtomicI32, Ordering};
use raylet::Fast;
use raylet::sensor::{Reading, SensorError, Try};
use semihosting as _;
use shared::sensor::{Number, OBSTACLES, RAYS, ZONES, sensor, zones};

/// The distances of all zones, in 65,536ths of a metre; -1 where nothing was measured.
#[unsafe(no_mangle)]
static DISTANCES: [AtomicI32; RAYS] = [const { AtomicI32::new(0) }; RAYS];

/// The function whose stack is counted.
#[unsafe(no_mangle)]
#[inline(never)]
fn measure() -> Result<(), SensorError> {
    let (zones, sensor) = (zones()?, sensor()?);
    let places = (0..ZONES).flat_map(|row| (0..ZONES).map(move |column| (column, row)));
    for ((column, row), distance) in places.zip(&DISTANCES) {
        let reading: Reading<Number, 1> = sensor.read_at::<Try<Fast>, 1>(&OBSTACLES[..], zones.rays(column, row), 0);
        let measured = reading.returns.first().map_or(-1, |seen| seen.distance.to_bits());
        distance.store(measured, Ordering::Relaxed);
    }
    Ok(())
}

fn run() -> ! {
    let _ = measure();
    loop {
        core::hint::spin_loop();
    }
}

raylet_firmware::starts_with!(run);
