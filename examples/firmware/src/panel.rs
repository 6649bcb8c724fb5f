//! A stand-in for a display with a controller of its own (ST7735, ILI9341 and their like) on an SPI bus: it is told a
//! window and then the window's pixels, two bytes each, high byte first. It remembers none of them.

use core::convert::Infallible;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::{IntoStorage, Rgb565};
use embedded_graphics_core::prelude::PointsIter;
use embedded_graphics_core::primitives::Rectangle;

/// What goes over the wire to a controller of this family.
pub trait Bus {
    /// Why nothing went.
    type Error;

    /// Opens a window: its first column and row, its last column and row (the commands `CASET` and `RASET`), and
    /// readies it for pixels (`RAMWR`).
    ///
    /// # Errors
    ///
    /// The bus's own.
    fn window(&mut self, first: [u16; 2], last: [u16; 2]) -> Result<(), Self::Error>;

    /// The window's next pixel.
    ///
    /// # Errors
    ///
    /// The bus's own.
    fn pixel(&mut self, bytes: [u8; 2]) -> Result<(), Self::Error>;
}

/// A display behind a bus.
#[derive(Debug)]
pub struct Panel<B> {
    size: Size,
    /// The bus.
    pub bus: B,
}

impl<B: Bus> Panel<B> {
    /// A display of so many columns and rows.
    pub const fn new(width: u16, height: u16, bus: B) -> Self {
        Self { size: Size::new(width as u32, height as u32), bus }
    }
}

impl<B> OriginDimensions for Panel<B> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<B: Bus> DrawTarget for Panel<B> {
    type Color = Rgb565;
    type Error = B::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), B::Error> {
        for Pixel(point, color) in pixels {
            self.fill_contiguous(&Rectangle::new(point, Size::new(1, 1)), [color])?;
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(&mut self, area: &Rectangle, colors: I) -> Result<(), B::Error> {
        let visible = area.intersection(&Rectangle::new(Point::zero(), self.size));
        let Some(last) = visible.bottom_right() else { return Ok(()) };
        let corner = |point: Point| [point.x as u16, point.y as u16];
        self.bus.window(corner(visible.top_left), corner(last))?;
        for (point, color) in area.points().zip(colors) {
            if visible.contains(point) {
                self.bus.pixel(color.into_storage().to_be_bytes())?;
            }
        }
        Ok(())
    }
}

/// A bus with nothing at its end: what goes over it is folded into a digest (FNV-1a of Fowler, Noll and Vo, 32 bits,
/// over the bytes).
#[derive(Clone, Copy, Debug)]
pub struct Fold(u32);

impl Fold {
    /// The digest of nothing.
    pub const fn new() -> Self {
        Self(0x811c_9dc5)
    }

    /// The digest of all that went.
    pub const fn digest(self) -> u32 {
        self.0
    }

    fn take(&mut self, bytes: [u8; 2]) {
        for byte in bytes {
            self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
    }
}

impl Default for Fold {
    fn default() -> Self {
        Self::new()
    }
}

impl Bus for Fold {
    type Error = Infallible;

    fn window(&mut self, first: [u16; 2], last: [u16; 2]) -> Result<(), Infallible> {
        first.into_iter().chain(last).for_each(|place| self.take(place.to_be_bytes()));
        Ok(())
    }

    fn pixel(&mut self, bytes: [u8; 2]) -> Result<(), Infallible> {
        self.take(bytes);
        Ok(())
    }
}
