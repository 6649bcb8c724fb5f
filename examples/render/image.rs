//! A picture in memory, and as PPM and PNG.

use png::EncodingError;
use std::error::Error;
use std::fs;
use std::io::{self, Write};

/// Eight bits a channel, row after row from the upper left.
#[derive(Clone, Debug)]
pub(crate) struct Image {
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) pixels: Vec<[u8; 3]>,
    /// True if the levels are in proportion to the light; otherwise they are encoded by sRGB.
    pub(crate) is_linear: bool,
}

/// The formats of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Ppm,
    Png,
}

impl Image {
    /// Fails if there is no memory for it.
    pub(crate) fn black(width: u16, height: u16, is_linear: bool) -> Result<Self, Box<dyn Error>> {
        Ok(Self { width, height, pixels: filled([0; 3], width, height)?, is_linear })
    }

    pub(crate) fn write(&self, format: Format, to: &mut impl Write) -> io::Result<()> {
        match format {
            Format::Ppm => self.write_ppm(to)?,
            Format::Png => self.write_png(to).map_err(|error| match error {
                // As it is: its kind says what to do.
                EncodingError::IoError(error) => error,
                other => io::Error::other(other),
            })?,
        }
        to.flush()
    }

    /// Portable pixmap, binary ("P6").
    fn write_ppm(&self, to: &mut impl Write) -> io::Result<()> {
        write!(to, "P6\n{} {}\n255\n", self.width, self.height)?;
        to.write_all(self.pixels.as_flattened())
    }

    fn write_png(&self, to: &mut impl Write) -> Result<(), EncodingError> {
        let mut encoder = png::Encoder::new(to, u32::from(self.width), u32::from(self.height));
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        if self.is_linear {
            encoder.set_source_gamma(png::ScaledFloat::new(1.0));
        } else {
            encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()
    }
}

/// One value a pixel. Fails if there is no memory for them.
pub(crate) fn filled<T: Clone>(value: T, width: u16, height: u16) -> Result<Vec<T>, Box<dyn Error>> {
    let pixels = usize::from(width) * usize::from(height);
    let mut values = Vec::new();
    values.try_reserve_exact(pixels).map_err(|_| too_large(width, height, pixels * size_of::<T>()))?;
    values.resize(pixels, value);
    Ok(values)
}

/// Fails if pictures of this size need more memory than there is, where the system tells how much there is: most
/// systems hand out more than they have, and end the program that uses it.
pub(crate) fn must_fit(width: u16, height: u16, bytes_a_pixel: usize) -> Result<(), Box<dyn Error>> {
    let bytes = usize::from(width) * usize::from(height) * bytes_a_pixel;
    match available_memory() {
        Some(available) if bytes > available => Err(too_large(width, height, bytes)),
        _ => Ok(()),
    }
}

fn too_large(width: u16, height: u16, bytes: usize) -> Box<dyn Error> {
    let megabytes = bytes.div_ceil(1 << 20);
    format!("{width}x{height} pixels need {megabytes} MB, more memory than there is: give a smaller --size").into()
}

/// In bytes; `None` where the system does not tell.
fn available_memory() -> Option<usize> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<usize>().ok()?.checked_mul(1024)
}
