//! The still life of the gallery on a display of 128 by 64 pixels, each on or off (SSD1306).
//!
//! So few pixels show outlines and no shades. The camera looks against the light: what is in front is dark and the floor is bright. Without
//! shadows the outlines stay apart from each other.

use raylet::effect::{Diffuse, Specular};
use raylet::{Camera, Picture, Scalar, Scene, Size, Vec3};

/// Columns of the display.
pub const WIDTH: u16 = 128;
/// Rows of the display.
pub const HEIGHT: u16 = 64;

/// The camera, closer than that of the gallery and on the other side. `None` if the number type does not hold its numbers, which go up to 27.
pub fn camera<S: Scalar>() -> Option<Camera<S>> {
    let point = |[x, y, z]: [&str; 3]| Some(Vec3::new(S::parse(x)?, S::parse(y)?, S::parse(z)?));
    let (eye, target) = (point(["1", "3.6", "-9.5"])?, point(["0.1", "0.85", "0"])?);
    Camera::new(eye, target, point(["0", "1", "0"])?, S::parse("27")?).ok()
}

/// The picture, without shadows.
pub fn picture<'a, S: Scalar>(scene: &'a Scene<'a, S>) -> Picture<'a, S, (Diffuse, Specular)> {
    Picture::leaving_out(scene, Size::new(WIDTH, HEIGHT))
}
