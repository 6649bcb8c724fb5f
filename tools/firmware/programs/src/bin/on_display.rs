//! Prints what a nearest hit, light and shadows cost a pixel of a display, in instructions, a line of JSON a picture.
#![no_std]
#![no_main]

use raylet_firmware::clock;
use raylet_programs::effects;
use semihosting::println;

fn run() -> ! {
    clock::start();
    effects::on_displays(&mut |row| println!("{row}"));
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
