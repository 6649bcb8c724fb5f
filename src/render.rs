//! Floor 9: pixels.
//!
//! No frame buffer is needed: a [`Picture`] gives any pixel when asked, and [`Picture::render`] hands them over one by
//! one, row after row, so that they may go straight to a display.

use crate::effect::{Sight, look};
use crate::part::Part;
use crate::scalar::{Real, Scalar};
use crate::scene::{Color, Counters, Raster, Scene, Size};

/// A scene, seen through its camera at a given size.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a, S: Scalar> {
    scene: &'a Scene<'a, S>,
    raster: Raster<S>,
}

/// One pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel<S: Scalar> {
    /// The mean of its samples, each brought into `[0, 1]` before, so that a highlight keeps its soft edge.
    pub color: Color<S>,
    /// What its middle sample saw: the object and the part of its surface; `None` for the background.
    pub seen: Option<(u32, Part)>,
    /// Which of the first 32 lights reach the point that its middle sample saw, a bit for each.
    pub lit_by: u32,
}

impl<'a, S: Scalar> Picture<'a, S> {
    /// The picture of a scene at this size.
    pub fn new(scene: &'a Scene<'a, S>, size: Size) -> Self {
        Self { scene, raster: scene.camera().raster(size) }
    }

    /// The size of the picture.
    pub const fn size(&self) -> Size {
        self.raster.size()
    }

    /// Traces the pixel in column `x` of row `y`, counted from the upper left; adds what it cost to `counters`.
    pub fn pixel(&self, x: u16, y: u16, counters: &mut Counters) -> Pixel<S> {
        let samples = self.size().samples.max(1);
        let mut sum = [S::Real::ZERO; 3];
        let mut middle = Sight { color: Color::BLACK, seen: None, lit_by: 0 };
        for row in 0..samples {
            for column in 0..samples {
                let Some(ray) = self.raster.ray([x, y], [column, row]) else { continue };
                counters.primary_rays += 1;
                let sight = look(self.scene, &ray, counters);
                if samples == 1 {
                    let color = sight.color.clamped();
                    return Pixel { color, seen: sight.seen, lit_by: sight.lit_by };
                }
                if (column, row) == (samples / 2, samples / 2) {
                    middle = sight;
                }
                for (sum, channel) in sum.iter_mut().zip(sight.color.clamped().to_array()) {
                    *sum = *sum + S::unit_real(channel);
                }
            }
        }
        let count = S::Real::from_int(i32::from(samples) * i32::from(samples));
        let color = sum.map(|sum| S::unit_round(sum / count)).into();
        Pixel { color, seen: middle.seen, lit_by: middle.lit_by }
    }

    /// Traces every pixel, row after row from the upper left, hands each to `each` with its column and row, and returns
    /// what it cost.
    pub fn render(&self, mut each: impl FnMut(u16, u16, Pixel<S>)) -> Counters {
        let mut counters = Counters::default();
        for y in 0..self.size().height {
            for x in 0..self.size().width {
                each(x, y, self.pixel(x, y, &mut counters));
            }
        }
        counters
    }
}
