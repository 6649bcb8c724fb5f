//! Two pictures of the same scene in different number types: how far apart, where, and why.

use crate::image::Image;
use crate::trace::{Sighting, Traced};
use std::error::Error;
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
    /// A pixel that differs by more than one level is explained if it lies on a silhouette, where a change in the last
    /// place may decide which of two colours is seen: see [`is_silhouette`].
    pub(crate) fn between(picture: &Traced, reference: &Traced) -> Result<Self, Box<dyn Error>> {
        let mut image = Image::black(reference.image.width, reference.image.height, true)?;
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
                on_silhouettes += usize::from(is_silhouette(
                    picture.sightings[index],
                    &reference.sightings,
                    usize::from(image.width),
                    index,
                ));
            }
        }
        Ok(Self { image, pixels, differing, by_more_than_one, on_silhouettes, greatest, squared })
    }

    /// Peak signal-to-noise ratio in decibels; infinite for equal pictures.
    fn psnr(&self) -> f64 {
        let mean = self.squared / (3.0 * self.pixels as f64);
        10.0 * (255.0_f64.powi(2) / mean).log10()
    }
}

/// True if the reference shows an edge in the 3x3 pixels around this one, an edge of what was seen here: the object (or
/// the part of it, or the background) must occur there, and where both see the same, so must every change of light. A
/// hole that the reference does not have is no silhouette.
fn is_silhouette(sighting: Sighting, reference: &[Sighting], width: usize, index: usize) -> bool {
    let (x, y) = (index % width, index / width);
    let (seen, lit_by) = sighting;
    let (reference_seen, reference_lit_by) = reference[index];
    let (mut same_thing, mut edge, mut changes) = (false, false, 0);
    let columns = x.saturating_sub(1)..=(x + 1).min(width - 1);
    let rows = y.saturating_sub(1)..=y + 1;
    for neighbour in rows.flat_map(|row| columns.clone().map(move |column| row * width + column)) {
        let Some((neighbour_seen, neighbour_lit_by)) = reference.get(neighbour) else { continue };
        same_thing |= *neighbour_seen == seen;
        edge |= *neighbour_seen != reference_seen;
        changes |= neighbour_lit_by ^ reference_lit_by;
    }
    if seen != reference_seen {
        // The lights that reach one thing say nothing about another.
        return same_thing;
    }
    (lit_by ^ reference_lit_by) & !changes == 0 && (edge || changes != 0)
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
