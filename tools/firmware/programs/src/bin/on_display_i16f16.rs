//! Prints what a nearest hit, light and shadows cost a pixel of a display in `I16F16`, in instructions, a line of JSON a
//! picture. Floats have a program of their own: of both together RISC-V's start code would not reach `main`.
#![no_std]
#![no_main]

use fixed::types::I16F16;
use raylet_firmware::clock;
use raylet_programs::effects;
use semihosting::println;

fn run() -> ! {
    clock::start();
    effects::on_displays::<I16F16>("I16F16", &mut |row| println!("{row}"));
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
