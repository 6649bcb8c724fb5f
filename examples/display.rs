//! The still life of the gallery on a display of 128 by 64 pixels, each on or off, such as the SSD1306. It needs the
//! feature `embedded-graphics`.
//!
//! So few pixels show few shades. The floor and what is behind it are white, so that every solid stands out against
//! them, and the solids keep the shades that tell a ball from a disc. Shadows would join the solids: they are left out.

use embedded_graphics::prelude::*;
use embedded_graphics::{pixelcolor::BinaryColor, primitives::Rectangle};
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

/// In the place of a display's driver.
pub(crate) struct Screen(pub(crate) [[bool; WIDTH as usize]; HEIGHT as usize]);

impl Dimensions for Screen {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::zero(), Size::new(WIDTH.into(), HEIGHT.into()))
    }
}

impl DrawTarget for Screen {
    type Color = BinaryColor;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, color) in pixels {
            self.0[y as usize][x as usize] = color.is_on();
        }
        Ok(())
    }
}

pub(crate) fn main() -> Result<(), raylet::Error> {
    let stage = stage()?;
    let scene = lit(stage.scene()?);
    let mut screen = Screen([[false; WIDTH as usize]; HEIGHT as usize]);
    let Ok(_) = picture(&scene).draw(Point::zero(), &mut screen);
    // Two rows a line, since characters are twice as high as wide.
    for rows in screen.0.chunks(2) {
        let line = rows[0].iter().zip(&rows[1]).map(|(upper, lower)| match (upper, lower) {
            (true, true) => '█',
            (true, false) => '▀',
            (false, true) => '▄',
            (false, false) => ' ',
        });
        println!("{}", line.collect::<String>());
    }
    Ok(())
}
