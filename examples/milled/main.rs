//! A drilled and milled part, a combination of eight solids, in fixed point: `cargo run --release --example milled`.
//! Writes `out/milled.png`, or the file that is named.

#[path = "../../tests/shared/src/milled.rs"]
mod milled;

use fixed::types::I16F16;
use milled::{Few, OPERATIONS, camera, leaves};
use raylet::{Color, Combination, Light, Material, Object, Picture, Plane, Scene, Shape, Size, Vec3};
use std::error::Error;
use std::fs::{File, create_dir_all};
use std::path::PathBuf;

const SIZE: Size = Size::new(480, 360).with_samples(3);

fn main() -> Result<(), Box<dyn Error>> {
    let path = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "out/milled.png".into()));
    let leaves = leaves::<I16F16>().ok_or("the number type does not hold its sizes")?;
    let part = Combination::new(&leaves, &OPERATIONS)?;
    let floor = Shape::<I16F16, Few>::of(Plane::new());
    let objects = [Object::new(floor.beside_combinations(), 0), Object::new(part.shape(), 1)];

    let matte = |grey| Material::matte(Color::from_f64(grey));
    let number = I16F16::from_num::<f64>;
    let steel = matte([0.62, 0.66, 0.72]).with_highlight(number(0.5), number(40.0));
    let materials = [matte([0.75, 0.70, 0.62]), steel];
    let lights = [([-5.0, 9.0, 4.0], 0.75), ([6.0, 5.0, 7.0], 0.3)];
    let lights = lights.map(|(at, strength)| Light::new(Vec3::from_f64(at).unwrap_or(Vec3::ZERO), number(strength)));
    let scene = Scene::new(&objects, &materials, &lights, camera().ok_or("the camera is beyond the number type")?)?
        .with_background(Color::from_f64([0.30, 0.42, 0.55]))
        .with_ambient(Color::from_f64([0.12; 3]));

    let picture = Picture::new(&scene, SIZE);
    let mut bytes = Vec::new();
    let counters = picture.render(|_, _, pixel| bytes.extend(pixel.color.to_srgb888()));
    if let Some(folder) = path.parent() {
        create_dir_all(folder)?;
    }
    let mut encoder = png::Encoder::new(File::create(&path)?, SIZE.width.into(), SIZE.height.into());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.write_header()?.write_image_data(&bytes)?;
    println!(
        "{}x{} pixels in I16F16: {} rays, {} intersection tests",
        SIZE.width,
        SIZE.height,
        counters.rays(),
        counters.intersection_tests
    );
    println!("written: {}", path.display());
    Ok(())
}
