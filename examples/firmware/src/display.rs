//! A picture on any display of `embedded-graphics`, row after row as its pixels are traced: no frame buffer, not even a row.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::primitives::Rectangle;
use raylet::scalar::UnitScalar;
use raylet::{Color, Counters, Picture, Scalar, Work};

/// The nearest colour of five, six and five bits.
pub fn rgb565<S: Scalar>(color: Color<S>) -> Rgb565 {
    let level = |channel: S::Unit, levels| channel.level(levels) as u8;
    Rgb565::new(level(color.red, 31), level(color.green, 63), level(color.blue, 31))
}

/// Draws a picture with its upper left corner at `corner`, each row by one [`DrawTarget::fill_contiguous`], and returns what
/// it cost.
///
/// A display takes the pixels of a row when they are ready, so that its bus waits for them.
///
/// # Errors
///
/// The display's, as soon as it reports one; the rows before are drawn.
pub fn draw<S: Scalar, D: DrawTarget<Color = Rgb565>>(
    picture: &Picture<'_, S>,
    corner: Point,
    display: &mut D,
) -> Result<Counters, D::Error> {
    let mut work = Work::new(());
    let size = picture.size();
    for y in 0..size.height {
        let row = Rectangle::new(corner + Point::new(0, i32::from(y)), Size::new(u32::from(size.width), 1));
        let pixels = picture.row(y, &mut work).map(|pixel| rgb565(pixel.color));
        display.fill_contiguous(&row, pixels)?;
    }
    Ok(work.counters)
}
