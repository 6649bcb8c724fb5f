//! Pictures on displays: a `DrawTarget` of `embedded-graphics`, in its colours from one to 24 bits a pixel.
//!
//! ```
//! use embedded_graphics::{geometry::Point, mock_display::MockDisplay, pixelcolor::Rgb565};
//! # use raylet::{Camera, Color, Light, Material, Object, Picture, Scene, Shape, Size, Sphere, Vec3};
//! # let y = Vec3::new(0.0_f32, 1.0, 0.0);
//! # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 40.0)?;
//! # let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
//! # let materials = [Material::matte(Color::WHITE)];
//! # let lights = [Light::new(Vec3::new(0.0, 9.0, 9.0), 0.5)];
//! # let scene = Scene::new(&objects, &materials, &lights, camera)?;
//! # let mut display = MockDisplay::<Rgb565>::new();
//! let picture = Picture::new(&scene, Size::new(32, 24));
//! let counters = picture.draw(Point::new(8, 4), &mut display)?;
//! assert_eq!(counters.primary_rays, 32 * 24);
//! # Ok::<(), raylet::Error>(())
//! ```
//!
//! # Names that both crates have
//!
//! `embedded_graphics::prelude` exports `Size`, `Pixel` and `Primitive`, and `embedded_graphics::primitives` has
//! `Triangle`, as this crate does. A name that is imported by itself takes precedence over one of a prelude; of two
//! imported by themselves rename one:
//!
//! ```
//! use embedded_graphics::prelude::*;
//! use embedded_graphics::primitives::Triangle as FlatTriangle;
//! use raylet::{Pixel, Primitive, Size as PictureSize, Triangle};
//!
//! let picture = PictureSize::new(160, 128);
//! let screen = Size::new(u32::from(picture.width), u32::from(picture.height));
//! assert_eq!(screen, Size::new(160, 128));
//! # let _: Option<(FlatTriangle, Pixel<f32>, Primitive<f32>, Triangle<f32>)> = None;
//! ```

use crate::effect::{Effects, TraceContext};
use crate::render::{InSpans, Picture, Pixel};
use crate::scalar::{Scalar, UnitScalar};
use crate::scene::{Color, Counters, Observer, encoded, nearest};
use crate::shape::kinds::Kinds;
use crate::tier::Tier;
use core::ops::Range;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};
use embedded_graphics_core::primitives::Rectangle;

/// A pixel format of displays that pictures can be drawn in. Sealed: the colours of `embedded-graphics`.
///
/// Channels are encoded by sRGB, as displays expect it, and dithered in order where there are fewer than eight bits:
/// the mean of four by four pixels is right to a sixteenth of a level, and a colour that is exactly a level is not
/// dithered. Grey and one-bit displays show the luminance `0.2126 R + 0.7152 G + 0.0722 B` (ITU-R BT.709).
/// [`BinaryColor`] is not encoded: the part of the pixels that are on is the luminance, since a pixel is either dark or
/// gives all its light.
pub trait DisplayColor: PixelColor + sealed::Sealed {
    /// The colour in this format, for the pixel in column `x` of row `y`, on which dithering depends.
    fn shown<S: Scalar>(color: Color<S>, x: u16, y: u16) -> Self;
}

/// Bayer's four by four matrix for ordered dithering, *An Optimum Method for Two-Level Rendition of Continuous-Tone
/// Pictures* (1973).
const BAYER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The level of a channel, of so many above black, in the pixel in column `x` of row `y`.
fn dithered(encoded: u32, levels: u8, x: u16, y: u16) -> u8 {
    if levels == u8::MAX {
        return nearest(encoded, 255) as u8;
    }
    // In sixteenths of a level.
    ((nearest(encoded, 16 * u32::from(levels)) + threshold(x, y)) >> 4) as u8
}

/// What is added to a value in sixteenths before it is rounded down, in the pixel in column `x` of row `y`.
fn threshold(x: u16, y: u16) -> u32 {
    u32::from(BAYER[(y & 3) as usize][(x & 3) as usize])
}

/// The luminance of a colour, linear, in 65536ths.
fn luminance<S: Scalar>(color: Color<S>) -> u32 {
    // The weights of BT.709 in 65536ths; their sum is 1.
    const WEIGHTS: [u64; 3] = [13_933, 46_871, 4_732];
    let channels = color.to_array().map(UnitScalar::in_65536ths);
    let sum: u64 = channels.into_iter().zip(WEIGHTS).map(|(channel, weight)| u64::from(channel) * weight).sum();
    (sum >> 16) as u32
}

/// Implements the trait for colours of three channels.
macro_rules! shown_in_color {
    ($($Color:ident),+) => {
        $(
            impl sealed::Sealed for $Color {}
            impl DisplayColor for $Color {
                fn shown<S: Scalar>(color: Color<S>, x: u16, y: u16) -> Self {
                    let [red, green, blue] = color.to_srgb().map(u32::from);
                    let shown = |encoded, levels| dithered(encoded, levels, x, y);
                    Self::new(shown(red, Self::MAX_R), shown(green, Self::MAX_G), shown(blue, Self::MAX_B))
                }
            }
        )+
    };
}
shown_in_color!(Rgb555, Bgr555, Rgb565, Bgr565, Rgb666, Bgr666, Rgb888, Bgr888);

/// Implements the trait for grey.
macro_rules! shown_in_gray {
    ($($Color:ident: $most:literal),+) => {
        $(
            impl sealed::Sealed for $Color {}
            impl DisplayColor for $Color {
                fn shown<S: Scalar>(color: Color<S>, x: u16, y: u16) -> Self {
                    Self::new(dithered(encoded(luminance(color)), $most, x, y))
                }
            }
        )+
    };
}
shown_in_gray!(Gray2: 3, Gray4: 15, Gray8: 255);

impl sealed::Sealed for BinaryColor {}
impl DisplayColor for BinaryColor {
    fn shown<S: Scalar>(color: Color<S>, x: u16, y: u16) -> Self {
        // From a distance the eye takes the mean of the light: a pixel in four is as bright as a quarter of white, not
        // as level 64 of 255.
        let sixteenths = (luminance(color) * 16 + (1 << 15)) >> 16;
        Self::from(sixteenths + threshold(x, y) >= 16)
    }
}

mod sealed {
    pub trait Sealed {}
}

/// Calls `draw` with the first column, the row and the area of each of some rows, as far as they are on the display.
fn each_row<D: DrawTarget>(
    size: crate::Size,
    rows: Range<u16>,
    corner: Point,
    display: &mut D,
    mut draw: impl FnMut([u16; 2], &Rectangle, &mut D) -> Result<(), D::Error>,
) -> Result<(), D::Error> {
    let screen = display.bounding_box();
    for y in rows.start..rows.end.min(size.height) {
        let below = Point::new(corner.x, corner.y.saturating_add(i32::from(y)));
        let area = Rectangle::new(below, Size::new(u32::from(size.width), 1)).intersection(&screen);
        if !area.is_zero_sized() {
            // From 0 to the picture's width, since the area is a part of the row.
            let x = area.top_left.x.saturating_sub(corner.x) as u16;
            draw([x, y], &area, display)?;
        }
    }
    Ok(())
}

/// Draws pixels of a row from a column on.
fn draw_pixels<S: Scalar, D: DrawTarget<Color: DisplayColor>>(
    (x, y): (u16, u16),
    area: &Rectangle,
    display: &mut D,
    pixels: impl Iterator<Item = Pixel<S>>,
) -> Result<(), D::Error> {
    let columns = (x..=u16::MAX).take(area.size.width as usize);
    display.fill_contiguous(area, columns.zip(pixels).map(|(x, pixel)| D::Color::shown(pixel.color, x, y)))
}

impl<S: Scalar, E: Effects, T: Tier<S>, K: Kinds> InSpans<'_, S, E, T, K> {
    /// Draws the picture, as [`Picture::draw`].
    ///
    /// ```
    /// use embedded_graphics::{geometry::Point, mock_display::MockDisplay, pixelcolor::Rgb565};
    /// # use raylet::{Camera, Color, Light, Material, Object, Picture, Scene, Shape, Size, Sphere, Vec3};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 40.0)?;
    /// # let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
    /// # let materials = [Material::matte(Color::WHITE)];
    /// # let scene = Scene::new(&objects, &materials, &[], camera)?.with_ambient(Color::WHITE);
    /// let picture = Picture::new(&scene, Size::new(64, 64));
    /// let [mut display, mut other] = [(); 2].map(|()| MockDisplay::<Rgb565>::new());
    /// let counters = picture.in_spans().draw(Point::zero(), &mut display)?;
    /// picture.draw(Point::zero(), &mut other)?;
    /// assert_eq!(display, other);
    /// assert!(counters.primary_rays < 64 * 64 / 8);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The first error of the display. Rows before it are drawn.
    pub fn draw<D: DrawTarget<Color: DisplayColor>>(
        &self,
        corner: Point,
        display: &mut D,
    ) -> Result<Counters, D::Error> {
        let mut context = TraceContext::new(());
        self.draw_rows(0..self.size().height, corner, display, &mut context)?;
        Ok(context.counters)
    }

    /// Draws some rows of the picture, as [`Picture::draw_rows`].
    ///
    /// # Errors
    ///
    /// The first error of the display. Rows before it are drawn.
    pub fn draw_rows<D: DrawTarget<Color: DisplayColor>, O: Observer>(
        &self,
        rows: Range<u16>,
        corner: Point,
        display: &mut D,
        context: &mut TraceContext<O>,
    ) -> Result<(), D::Error> {
        let finely = self.picture().finely();
        each_row(self.size(), rows, corner, display, |[x, y], area, display| {
            draw_pixels((x, y), area, display, self.row_of(&finely, [x, y], context))
        })
    }
}

impl<S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Picture<'_, S, E, T, K> {
    /// Draws the picture with its upper left corner at `corner`, and returns the counters of rays and tests. It needs
    /// no buffer for the frame or for a row: each pixel is sent as it is traced. Pixels off the display are not traced.
    ///
    /// # Errors
    ///
    /// The first error of the display. Rows before it are drawn.
    pub fn draw<D: DrawTarget<Color: DisplayColor>>(
        &self,
        corner: Point,
        display: &mut D,
    ) -> Result<Counters, D::Error> {
        let mut context = TraceContext::new(());
        self.draw_rows(0..self.size().height, corner, display, &mut context)?;
        Ok(context.counters)
    }

    /// Draws some rows of the picture, whose upper left corner is at `corner`, each row by one
    /// [`DrawTarget::fill_contiguous`]. Adds rays and tests to `context`. Rows beyond the last are ignored.
    ///
    /// Rows do not depend on each other: two processors may each draw a part of the picture, with a [`TraceContext`] of
    /// its own.
    ///
    /// # Errors
    ///
    /// The first error of the display. Rows before it are drawn.
    pub fn draw_rows<D: DrawTarget<Color: DisplayColor>, O: Observer>(
        &self,
        rows: Range<u16>,
        corner: Point,
        display: &mut D,
        context: &mut TraceContext<O>,
    ) -> Result<(), D::Error> {
        let finely = self.finely();
        each_row(self.size(), rows, corner, display, |[x, y], area, display| {
            draw_pixels((x, y), area, display, finely.row_from(x, y, context))
        })
    }

    /// Traces row `y` into a buffer, for instance to send it to a display by DMA while the next row is traced into
    /// another buffer. Adds rays and tests to `context`. Returns the number of pixels written: at most the length of
    /// the buffer and the picture's width, and 0 beyond the last row.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// # use raylet::{Camera, Color, Light, Material, Object, Picture, Scene, Shape, Size, Sphere, Vec3, TraceContext};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 40.0)?;
    /// # let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
    /// # let materials = [Material::matte(Color::WHITE)];
    /// # let lights = [Light::new(Vec3::new(0.0, 9.0, 9.0), 0.5)];
    /// # let scene = Scene::new(&objects, &materials, &lights, camera)?.with_background(Color::WHITE);
    /// let picture = Picture::new(&scene, Size::new(32, 24));
    /// let (mut line, mut context) = ([Rgb565::BLACK; 32], TraceContext::new(()));
    /// assert_eq!(picture.line(0, &mut line, &mut context), 32);
    /// assert_eq!(line[0], Rgb565::WHITE);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn line<C: DisplayColor, O: Observer>(&self, y: u16, buffer: &mut [C], context: &mut TraceContext<O>) -> usize {
        if y >= self.size().height {
            return 0;
        }
        let (mut pixels, finely) = (0, self.finely());
        for (x, (own, pixel)) in (0..=u16::MAX).zip(buffer.iter_mut().zip(finely.row(y, context))) {
            *own = C::shown(pixel.color, x, y);
            pixels += 1;
        }
        pixels
    }
}
