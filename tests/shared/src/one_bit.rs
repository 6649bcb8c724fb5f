//! The still life of the gallery on a display of 128 by 64 pixels, each on or off (SSD1306).
//!
//! So few pixels hold few shades. The floor and what is behind it are as bright as white, so that every solid stands
//! out against them, and the solids keep the shades that tell a ball from a disc. Without shadows the outlines stay
//! apart from each other.

use raylet::effect::{Ambient, Diffuse, Specular};
use raylet::gallery::{BuiltIn, Stage};
use raylet::{Camera, Color, Picture, Scalar, Scene, Size, Vec3};

/// Columns of the display.
pub const WIDTH: u16 = 128;
/// Rows of the display.
pub const HEIGHT: u16 = 64;

/// The still life, a little darker and on a white floor, seen from closer than in the gallery. `None` if the number
/// type does not hold its numbers, which go up to 100.
pub fn stage<S: Scalar>() -> Option<Stage<S>> {
    let mut stage = BuiltIn::StillLife.build::<S>()?;
    stage.camera = camera()?;
    stage.background = Color::WHITE;
    let (white, darker) = (S::parse("1")?, S::parse("0.6")?);
    for material in &mut stage.materials {
        material.diffuse = darker;
    }
    // The floor's material is the first.
    let floor = stage.materials.first_mut()?;
    (floor.color, floor.diffuse) = (Color::WHITE, white);
    Some(stage)
}

fn camera<S: Scalar>() -> Option<Camera<S>> {
    let point = |[x, y, z]: [&str; 3]| Some(Vec3::new(S::parse(x)?, S::parse(y)?, S::parse(z)?));
    let (eye, target) = (point(["0.2", "4.2", "9"])?, point(["0.2", "0.8", "0"])?);
    Camera::new(eye, target, point(["0", "1", "0"])?, S::parse("22.5")?).ok()
}

/// The scene with ambient light, which makes the floor white and lightens the sides that are turned away from the
/// lamps.
pub fn lit<S: Scalar>(scene: Scene<'_, S>) -> Scene<'_, S> {
    scene.with_ambient(Color::from_f64([0.4; 3]))
}

/// The picture, without shadows.
pub fn picture<'a, S: Scalar>(scene: &'a Scene<'a, S>) -> Picture<'a, S, (Ambient, Diffuse, Specular)> {
    Picture::leaving_out(scene, Size::new(WIDTH, HEIGHT))
}
