//! Four balls over a board: the scene of the benchmark Raystones (Lévy, learn-fpga, after Sokolov's tinyraytracer).
//!
//! As there, but for the sky, which is of one colour here, that of the horizon there.

use super::{Stage, all, number, on_y, point};
use crate::{Camera, Color, Material, Rectangle, Scalar, Sphere, Texture};

pub(super) fn build<S: Scalar>() -> Option<Stage<S>> {
    // Diffuse, specular and mirrored light, colour, exponent.
    let material = |[diffuse, specular, mirror]: [f64; 3], color, shine: f64| -> Option<Material<S>> {
        let material = Material { diffuse: number(diffuse)?, ..Material::matte(Color::from_f64(color)) };
        Some(material.with_highlight(number(specular)?, number(shine)?).with_mirror(number(mirror)?))
    };
    let glass = material([0.0, 0.5, 0.1], [0.6, 0.7, 0.8], 125.0)?;
    let materials = [
        material([0.6, 0.3, 0.1], [0.4, 0.4, 0.3], 50.0)?,
        glass.with_refraction(number(0.8)?, number(1.5)?),
        material([0.9, 0.1, 0.0], [0.3, 0.1, 0.1], 10.0)?,
        material([0.0, 10.0, 0.8], [1.0; 3], 142.0)?,
        Material { diffuse: number(1.0)?, ..Material::matte(Color::WHITE) }.with_texture(0),
    ];
    let [ivory, glass, rubber, mirror, board] = [0, 1, 2, 3, 4];
    let ball =
        |radius, [x, y, z]: [f64; 3], material| on_y(Sphere::new(number(radius)?).ok()?, point(x, y, z)?, material);
    let objects = [
        ball(2.0, [-3.0, 0.0, -16.0], ivory)?,
        ball(2.0, [-1.0, -1.5, -12.0], glass)?,
        ball(3.0, [1.5, -0.5, -18.0], rubber)?,
        ball(4.0, [7.0, 5.0, -18.0], mirror)?,
        on_y(Rectangle::new(number(10.0)?, number(10.0)?).ok()?, point(0.0, -4.0, -20.0)?, board)?,
    ];
    let lights = [([-20.0, 20.0, 20.0], 1.5), ([30.0, 50.0, -25.0], 1.8), ([30.0, 20.0, 30.0], 1.7)];
    let [grey, brown] = [[0.3; 3], [0.3, 0.2, 0.1]].map(Color::from_f64);
    let textures = [Texture::Checker { columns: 10, rows: 10, colors: [grey, brown] }];
    let (eye, ahead, up) = (point(0.0, 0.0, 0.0)?, point(0.0, 0.0, -1.0)?, point(0.0, 1.0, 0.0)?);
    Some(Stage {
        textures: all(textures)?,
        background: Color::from_f64([0.1, 0.35, 0.65]),
        camera: Camera::new(eye, ahead, up, number(60.0)?).ok()?,
        ..Stage::new(objects, materials, lights)?
    })
}
