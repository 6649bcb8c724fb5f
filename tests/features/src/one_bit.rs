//! The still life of the gallery on a display of 128 by 64 pixels, each on or off, such as the SSD1306.
//!
//! So few pixels show few shades. The floor and what is behind it are white, so that every solid stands out against
//! them, and the solids keep the shades that tell a ball from a disc. Shadows would join the solids: they are left out.

use fixed::types::I16F16;
use raylet::effect::{Ambient, Diffuse, Specular};
use raylet::gallery::{BuiltIn, Stage};
use raylet::{Camera, Color, Picture, Scene, Vec3};

pub(crate) const WIDTH: u16 = 128;
pub(crate) const HEIGHT: u16 = 64;

/// The still life, a little darker and on a white floor, seen from closer than in the gallery.
pub(crate) fn stage() -> Result<Stage<I16F16>, raylet::Error> {
    let number = I16F16::from_num::<f64>;
    let mut stage = BuiltIn::StillLife.build::<I16F16>().expect("every number type holds it");
    let (eye, target) = (Vec3::from_f64([0.2, 4.2, 9.0])?, Vec3::from_f64([0.2, 0.8, 0.0])?);
    stage.camera = Camera::new(eye, target, Vec3::from_f64([0.0, 1.0, 0.0])?, number(22.5))?;
    stage.background = Color::WHITE;
    for material in &mut stage.materials {
        material.diffuse = number(0.6);
    }
    // The floor's material is the first.
    (stage.materials[0].color, stage.materials[0].diffuse) = (Color::WHITE, number(1.0));
    Ok(stage)
}

/// Ambient light makes the floor white, and lightens the sides that are turned away from the lamps.
pub(crate) fn lit(scene: Scene<'_, I16F16>) -> Scene<'_, I16F16> {
    scene.with_ambient(Color::from_f64([0.4; 3]))
}

/// The picture has ambient, diffuse and specular light. The program has no code for shadows.
pub(crate) fn picture<'a>(scene: &'a Scene<'a, I16F16>) -> Picture<'a, I16F16, (Ambient, Diffuse, Specular)> {
    Picture::leaving_out(scene, raylet::Size::new(WIDTH, HEIGHT))
}
