//! Two pictures of the same scene in different number types: how far apart, where, and why.

use crate::image::Image;
use crate::trace::{Sighting, Traced};
use std::fmt;

/// Each level of difference becomes this many in the difference picture.
const AMPLIFICATION: u8 = 32;

/// How a picture differs from a reference.
#[derive(Debug)]
pub(crate) struct Difference {
    /// The difference of each channel, amplified.
    pub(crate) image: Image,
    pixels: usize,
    differing: usize,
    by_more_than_one: usize,
    on_silhouettes: usize,
    greatest: u8,
    squared: f64,
}

impl Difference {
    /// Compares two pictures of the same size.
    ///
    /// A pixel that differs by more than one level is explained if it lies on a silhouette: if in the 3x3 pixels around
    /// it the reference sees more than one object or part of an object, or more than one set of lights. There, a change in the last place
    /// may decide which of two colours is seen.
    pub(crate) fn between(picture: &Traced, reference: &Traced) -> Self {
        let mut image = Image::black(reference.image.width, reference.image.height);
        let pixels = image.pixels.len();
        let (mut differing, mut by_more_than_one, mut on_silhouettes, mut greatest, mut squared) = (0, 0, 0, 0, 0.0);
        for (index, (a, b)) in picture.image.pixels.iter().zip(&reference.image.pixels).enumerate() {
            let levels: [u8; 3] = std::array::from_fn(|channel| a[channel].abs_diff(b[channel]));
            image.pixels[index] = levels.map(|level| level.saturating_mul(AMPLIFICATION));
            let largest = levels.into_iter().max().unwrap_or(0);
            greatest = greatest.max(largest);
            squared += levels.iter().map(|level| f64::from(*level).powi(2)).sum::<f64>();
            differing += usize::from(largest > 0);
            if largest > 1 {
                by_more_than_one += 1;
                on_silhouettes += usize::from(is_silhouette(&reference.sightings, usize::from(image.width), index));
            }
        }
        Self { image, pixels, differing, by_more_than_one, on_silhouettes, greatest, squared }
    }

    /// Peak signal-to-noise ratio in decibels; infinite for equal pictures.
    fn psnr(&self) -> f64 {
        let mean = self.squared / (3.0 * self.pixels as f64);
        10.0 * (255.0_f64.powi(2) / mean).log10()
    }
}

fn is_silhouette(sightings: &[Sighting], width: usize, index: usize) -> bool {
    let (x, y) = (index % width, index / width);
    (y.saturating_sub(1)..=y + 1)
        .flat_map(|row| (x.saturating_sub(1)..=(x + 1).min(width - 1)).map(move |column| row * width + column))
        .filter_map(|neighbour| sightings.get(neighbour))
        .any(|neighbour| *neighbour != sightings[index])
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.differing as f64 / self.pixels as f64;
        write!(
            f,
            "{} of {} pixels differ ({percent:.3}%), {} by more than one level: {} on silhouettes, {} unexplained; \
             greatest difference {} levels, PSNR {:.1} dB",
            self.differing,
            self.pixels,
            self.by_more_than_one,
            self.on_silhouettes,
            self.by_more_than_one - self.on_silhouettes,
            self.greatest,
            self.psnr()
        )
    }
}
