//! The errors of a sensor's distances, from a seed.

use super::SensorError;
use crate::scalar::{Real, Ring, Scalar};

/// The errors of a sensor: its distances are spread about the true ones, and some measurements are lost.
///
/// A distance `d` is off by a nearly normal error of mean zero and of the standard deviation `s + r d`. Errors depend
/// on the seed, on the number of the measurement and on that of the return, and on nothing else, so that they are the
/// same in any order and on any machine.
///
/// ```
/// use raylet::sensor::Noise;
/// // 15 mm and one in a hundred; one measurement in 64 is lost.
/// let noise = Noise::new(0.015_f32, 0.01, 7)?.losing(1024);
/// let mean = (0..1000).map(|number| noise.of(2.0, number, 0)).sum::<f32>() / 1000.0;
/// assert!((mean - 2.0).abs() < 0.003);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise<S> {
    deviation: S,
    relative: S,
    /// In 65,536ths of all measurements.
    lost: u16,
    seed: u32,
}

/// The uniform numbers of 16 bits that add up to a nearly normal one.
const SUMMANDS: u32 = 12;

impl<S: Scalar> Noise<S> {
    /// No errors.
    pub const NONE: Self = Self { deviation: S::ZERO, relative: S::ZERO, lost: 0, seed: 0 };

    /// Errors of this standard deviation, and of this one relative to the distance.
    ///
    /// # Errors
    ///
    /// [`SensorError::Deviation`] if one of these is negative or not finite.
    pub fn new(deviation: S, relative: S, seed: u32) -> Result<Self, SensorError> {
        // Comparisons are false for NaN.
        if [deviation, relative].into_iter().all(|value| value >= S::ZERO && value.is_finite()) {
            Ok(Self { deviation, relative, lost: 0, seed })
        } else {
            Err(SensorError::Deviation)
        }
    }

    /// The same with this many of 65,536 measurements lost.
    #[must_use]
    pub const fn losing(self, lost: u16) -> Self {
        Self { lost, ..self }
    }

    /// True if the measurement of this number is lost.
    pub fn loses(&self, number: u32) -> bool {
        self.lost > 0 && mixed(self.seed ^ mixed(!number)) >> 16 < u32::from(self.lost)
    }

    /// What is measured instead of a distance: by the measurement of this number, as the return of this index. It is
    /// zero at least.
    pub fn of(&self, distance: S, number: u32, index: usize) -> S {
        if self.deviation == S::ZERO && self.relative == S::ZERO {
            return distance;
        }
        // The sum of twelve uniform numbers has the variance 1 (Irwin and Hall, 1927); in 65,536ths.
        let start = mixed(self.seed ^ mixed(number ^ (index as u32) << 28));
        let sum = (0..SUMMANDS / 2).fold(SUMMANDS / 2, |sum, i| {
            let two = mixed(start.wrapping_add(i));
            sum + (two >> 16) + (two & 0xffff)
        });
        let normal = S::Real::from_int(sum as i32 - (SUMMANDS as i32) * (1 << 15)).scaled(-16);
        let deviation = self.deviation.real() + self.relative.real() * distance.real();
        let measured = S::round(distance.real() + deviation * normal);
        if measured > S::ZERO { measured } else { S::ZERO }
    }
}

/// A permutation of the words whose bits all depend on each other (Ettinger and Wellons, `lowbias32`, 2018).
const fn mixed(word: u32) -> u32 {
    let word = (word ^ (word >> 16)).wrapping_mul(0x7feb_352d);
    let word = (word ^ (word >> 15)).wrapping_mul(0x846c_a68b);
    word ^ (word >> 16)
}
