//! Prints what a nearest hit, light and shadows cost a pixel of a display in `f32`, in instructions, a line of JSON a
//! picture. Fixed point has a program of its own: of both together RISC-V's start code would not reach `main`.
#![no_std]
#![no_main]

use raylet_firmware::clock;
use raylet_programs::effects;
use semihosting::println;

fn run() -> ! {
    clock::start();
    effects::on_displays::<f32>("f32", &mut |row| println!("{row}"));
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
