//! The still life of the gallery, which turns on a display of 160 by 128 pixels in 16 bits each (ST7735).
//!
//! No frame buffer: besides the scene there is one line of pixels. The camera goes around the objects; the lights stay.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size as Area};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::primitives::Rectangle;
use raylet::effect::{Ambient, Diffuse, Effects, Shadows, Specular};
use raylet::scalar::{Real, Ring};
use raylet::scene::{Hierarchy, Observer};
use raylet::shape::kinds::Kinds;
use raylet::tier::Tier;
use raylet::{Camera, Color, Picture, Scalar, Scene, Size, TraceContext, Vec3};

/// Columns of the display.
pub const WIDTH: u16 = 160;
/// Rows of the display.
pub const HEIGHT: u16 = 128;
/// Frames of one turn.
pub const FRAMES: u8 = 36;

/// One line of the display: 320 bytes.
pub type Line = [Rgb565; WIDTH as usize];

/// What is compiled in: the scene calls for no more, and no code of another effect is linked.
pub type Shaded = (Ambient, Diffuse, Specular, Shadows);

/// How many nodes the hierarchy of the still life has.
pub const NODES: usize = Hierarchy::<f32>::nodes_for(14);

/// The camera of a frame; frames repeat after [`FRAMES`]. `None` if the number type does not hold its numbers, which go
/// up to 37.
pub fn camera<S: Scalar>(frame: u8) -> Option<Camera<S>> {
    let [eye, radius, target] = ["4.5", "9.2", "0.6"].map(S::parse);
    let turns = S::Real::from_int(i32::from(frame % FRAMES)) / S::Real::from_int(i32::from(FRAMES));
    let (sine, cosine) = S::sine_cosine(S::unit_round(turns));
    let radius = radius?;
    let eye = Vec3::new(radius.along(sine), eye?, radius.along(cosine));
    let up = Vec3::new(S::ZERO, S::round(S::Real::ONE), S::ZERO);
    Camera::new(eye, Vec3::new(S::ZERO, target?, S::ZERO), up, S::parse("37")?).ok()
}

/// The scene with a little ambient light, which shows the sides that the lamps do not reach: these face the camera half
/// of the time.
pub fn lit<S: Scalar>(scene: Scene<'_, S>) -> Scene<'_, S> {
    scene.with_ambient(Color::from([S::unit_round(S::Real::ONE.scaled(-3)); 3]))
}

/// The picture of a frame.
pub fn picture<'a, S: Scalar>(scene: &'a Scene<'a, S>) -> Picture<'a, S, Shaded> {
    Picture::leaving_out(scene, Size::new(WIDTH, HEIGHT))
}

/// Traces a picture and sends it to the display, line by line. A driver with DMA would send one line while the next is
/// traced into another.
///
/// # Errors
///
/// The first error of the display.
pub fn show<S: Scalar, E: Effects, O: Observer, D: DrawTarget<Color = Rgb565>>(
    picture: &Picture<'_, S, E>,
    line: &mut Line,
    context: &mut TraceContext<O>,
    display: &mut D,
) -> Result<(), D::Error> {
    show_rows(picture, 0..picture.size().height, line, context, display).map(|_| ())
}

/// The same with some of its rows; returns how many.
///
/// # Errors
///
/// The first error of the display.
pub fn show_rows<S: Scalar, E: Effects, T: Tier<S>, K: Kinds, O: Observer, D: DrawTarget<Color = Rgb565>>(
    picture: &Picture<'_, S, E, T, K>,
    rows: impl Iterator<Item = u16>,
    line: &mut Line,
    context: &mut TraceContext<O>,
    display: &mut D,
) -> Result<u16, D::Error> {
    let mut drawn = 0;
    for y in rows {
        picture.line(y, line, context);
        let area = Rectangle::new(Point::new(0, i32::from(y)), Area::new(u32::from(WIDTH), 1));
        display.fill_contiguous(&area, line.iter().copied())?;
        drawn += 1;
    }
    Ok(drawn)
}
