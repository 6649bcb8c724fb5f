//! Prints what each set of effects costs a pixel, in instructions and in stack, a line of JSON a set.
#![no_std]
#![no_main]

use raylet_firmware::clock;
use raylet_programs::effects;
use semihosting::println;

fn run() -> ! {
    clock::start();
    effects::all(&mut |row| println!("{row}"));
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
