//! Draws the scenes of the gallery, small, and prints what a pixel costs, a line of JSON a scene.
#![no_std]
#![no_main]

use fixed::types::I16F16;
use raylet::gallery::BuiltIn;
use raylet::{Picture, Scalar, Scene, Size};
use raylet_firmware::clock;
use raylet_programs::effects::picture;
use raylet_programs::shown::{File, with_built_in, with_file};
use semihosting::println;

/// As large as a thumbnail.
const SIZE: Size = Size::new(24, 18);

/// As in the gallery, several samples where a pixel's corners differ; but one in a glass of water, where a sample takes
/// some hundred rays.
fn samples(name: &str) -> u8 {
    if name == BuiltIn::Water.name() { 1 } else { 3 }
}

fn print<S: Scalar>(name: &str, number: &str, scene: &Scene<'_, S>) {
    let measured = picture(&Picture::new(scene, SIZE.with_samples(samples(name))));
    println!(r#"{{"scene":"{name}","number":"{number}","measured":{measured}}}"#);
}

fn show<S: Scalar>(number: &'static str) {
    for built_in in BuiltIn::EVERY {
        with_built_in::<S>(built_in, |scene| print(built_in.name(), number, scene));
    }
    for file in File::EVERY {
        with_file::<S>(file, |scene| print(file.name, number, scene));
    }
}

fn run() -> ! {
    clock::start();
    show::<I16F16>("I16F16");
    show::<f32>("f32");
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
