//! Draws a scene that is all constants, in fixed point and in floats, and prints a digest of each picture: those of the
//! host (`tests/promises/src/constants.rs` compares them with the scene made at run time). Nothing of the scene is in
//! RAM but what borrows it.
#![no_std]
#![no_main]

use raylet_firmware::footprint::Footprint;
use semihosting::println;
use shared::flash::{FIXED, SINGLE, digest};

fn run() -> ! {
    let pictures = [digest(&FIXED), digest(&SINGLE)].map(|picture| picture.expect("its indices are good"));
    for (number, picture) in ["I16F16", "f32"].into_iter().zip(pictures) {
        println!("{number}: {:016x}, pixels of each object {:?}", picture.levels, picture.seen);
    }
    println!("{}", Footprint::of_this_program());
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
