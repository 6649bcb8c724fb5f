//! Reads a scene and draws it, in fixed point and in floats; each picture goes to a file of the host, what it took to
//! the terminal.
#![no_std]
#![no_main]

use core::ffi::CStr;
use fixed::types::I16F16;
use raylet::{Scalar, TraceContext};
use raylet_firmware::figures::Figures;
use raylet_firmware::footprint::Footprint;
use raylet_firmware::{clock, stack};
use semihosting::fs::File;
use semihosting::io::Write;
use semihosting::println;
use shared::picture::{HEADER, HEIGHT, Storage, picture, row};

/// One picture. Its own frame, so that the stack of the other number type is not counted.
#[inline(never)]
fn render<S: Scalar>(number: &'static str, path: &CStr) {
    stack::paint();
    let mut storage = Storage::<S>::new();
    let view = storage.read().expect("the scene is well-formed and fits into its lists");
    let scene = storage.scene(&view).expect("the reader's lists fit together");
    let picture = picture(&scene);
    let mut file = File::create(path).expect("the host lets a file be written");
    file.write_all(HEADER.as_bytes()).expect("the host lets it be written");
    let (mut context, mut instructions) = (TraceContext::new(()), 0);
    for y in 0..HEIGHT {
        let start = clock::instructions();
        let row = row(&picture, y, &mut context);
        instructions += clock::instructions() - start;
        file.write_all(&row).expect("the host lets it be written");
    }
    let stack = stack::used();
    println!("{}", Figures { number, instructions, counters: context.counters, stack, scene: size_of::<Storage<S>>() });
}

fn run() -> ! {
    clock::start();
    render::<I16F16>("I16F16", c"picture-I16F16.ppm");
    render::<f32>("f32", c"picture-f32.ppm");
    println!("{}", Footprint::of_this_program());
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
