//! The levels of a picture's channels.

use super::srgb::{STEPS, encoded, nearest_of_255};
use crate::scalar::UnitScalar;

/// The levels that a channel of a picture may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Levels {
    /// 0 to 255, encoded by sRGB.
    Srgb,
    /// Sixteen to each of these: for a sample that is one of several, or that is dithered.
    Fine,
    /// 0 to 255, in proportion to the light.
    Linear,
}

impl Levels {
    /// The nearest level of a channel; values outside of `[0, 1]` are clamped.
    pub(crate) fn of(self, channel: impl UnitScalar) -> u16 {
        match self {
            Self::Srgb => nearest_of_255(channel.in_65536ths()) as u16,
            Self::Fine => ((encoded(channel.in_65536ths()) + STEPS / 32) / (STEPS / 16)) as u16,
            Self::Linear => channel.level(255),
        }
    }
}

/// The nearest of so many levels above black to an encoded channel.
#[cfg(feature = "embedded-graphics")]
pub(crate) fn nearest(encoded: u32, levels: u32) -> u32 {
    let brightest = 255 * STEPS;
    (encoded * levels + brightest / 2) / brightest
}

#[cfg(units)]
#[path = "../../tests/units/scene/levels.rs"]
mod tests;
