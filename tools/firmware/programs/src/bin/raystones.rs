//! The benchmark Raystones: its scene, in two number types and three tiers. Prints for each what a pixel takes, how many
//! rays were cast, and a digest of the picture.
#![no_std]
#![no_main]

use core::hint::black_box;
use fixed::types::I16F16;
use raylet::effect::{Diffuse, Reflection, Refraction, Shadows, Specular, Texture};
use raylet::gallery::BuiltIn;
use raylet::tier::{Fast, Plain, Stable, Tier};
use raylet::{Camera, Counters, Picture, Scalar, Size, Vec3};
use raylet_firmware::clock;
use semihosting::println;

/// The benchmark's.
const SIZE: Size = Size::new(40, 20);
/// Between the middles of the outermost rows, in degrees: the benchmark has 60 between their outer edges.
const ANGLE: f64 = 57.488_018;
/// What the scene calls for.
type Shaded = (Diffuse, Specular, Shadows, Reflection, Refraction, Texture);

#[inline(never)]
fn measure<S: Scalar, T: Tier<S>>(name: &str) {
    let mut stage = BuiltIn::Raystones.build::<S>().expect("the number type holds it");
    let at = |y, z| Vec3::from_f64([0.0, y, z]).expect("the number type holds it");
    let angle = S::from_f64(ANGLE).expect("the number type holds it");
    stage.camera = Camera::new(at(0.0, 0.0), at(0.0, -1.0), at(1.0, 0.0), angle).expect("it looks ahead");
    let scene = stage.scene().expect("the lists are those that were built").at_tier::<T>();
    let picture = Picture::<S, Shaded, T>::leaving_out(&scene, SIZE);
    let (start, mut levels) = (clock::instructions(), 0_u32);
    let counters = black_box(&picture).render(|_, _, pixel| {
        let mix = |sum: u32, level: u8| (sum ^ u32::from(level)).wrapping_mul(0x0100_0193);
        levels = pixel.color.to_linear888().into_iter().fold(levels, mix);
    });
    let taken = (clock::instructions() - start) / (u64::from(SIZE.width) * u64::from(SIZE.height));
    println!("{name}\t{taken}\t{}\t{levels:08x}", Counters::rays(&counters));
}

fn run() -> ! {
    clock::start();
    measure::<I16F16, Plain>("I16F16, Plain");
    measure::<I16F16, Fast>("I16F16, Fast");
    measure::<I16F16, Stable>("I16F16, Stable");
    measure::<f32, Plain>("f32, Plain");
    measure::<f32, Fast>("f32, Fast");
    measure::<f32, Stable>("f32, Stable");
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
