//! Linear RGB colours.

use super::Levels;
use super::srgb::encoded;
use crate::scalar::{Scalar, UnitScalar};

/// A linear RGB colour, without gamma. 0 is black and 1 the brightest level of a display.
///
/// Channels are [`Unit`](crate::scalar::Unit): fixed types have 30 (or 62) fraction bits and saturate just below 2, so
/// that a sum of bright lights does not wrap around.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Color<S: Scalar> {
    /// Red.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub red: S::Unit,
    /// Green.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub green: S::Unit,
    /// Blue.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub blue: S::Unit,
}

impl<S: Scalar> Color<S> {
    /// Black: 0 in each channel.
    pub const BLACK: Self = Self { red: S::Unit::ZERO, green: S::Unit::ZERO, blue: S::Unit::ZERO };
    /// White: 1 in each channel.
    pub const WHITE: Self = Self { red: S::Unit::ONE, green: S::Unit::ONE, blue: S::Unit::ONE };

    /// The colour with these channels.
    pub const fn new(red: S::Unit, green: S::Unit, blue: S::Unit) -> Self {
        Self { red, green, blue }
    }

    /// From `f64` channels, each rounded to nearest; NaN becomes 0.
    pub fn from_f64([red, green, blue]: [f64; 3]) -> Self {
        Self::new(S::Unit::from_f64(red), S::Unit::from_f64(green), S::Unit::from_f64(blue))
    }

    /// The channels in the order red, green, blue.
    pub const fn to_array(self) -> [S::Unit; 3] {
        [self.red, self.green, self.blue]
    }

    /// The sum, channel by channel, saturated.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self::new(self.red.plus(other.red), self.green.plus(other.green), self.blue.plus(other.blue))
    }

    /// The product, channel by channel: light of one colour reflected by a surface of the other.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self::new(self.red.times(other.red), self.green.times(other.green), self.blue.times(other.blue))
    }

    /// Each channel clamped to `[0, 1]`; NaN becomes 0.
    #[must_use]
    pub fn clamped(self) -> Self {
        let [red, green, blue] = self.to_array().map(|channel| {
            if channel >= S::Unit::ONE {
                S::Unit::ONE
            } else if channel > S::Unit::ZERO {
                channel
            } else {
                S::Unit::ZERO
            }
        });
        Self::new(red, green, blue)
    }

    /// Eight-bit levels as displays and picture files store them: encoded by sRGB (IEC 61966-2-1:1999), the nearest of
    /// 0 to 255 for each channel, clamped. Equal colours have the same levels in every number type.
    ///
    /// ```
    /// # use raylet::Color;
    /// assert_eq!(Color::<f32>::from_f64([1.5, 0.5, -1.0]).to_srgb888(), [255, 188, 0]);
    /// ```
    pub fn to_srgb888(self) -> [u8; 3] {
        self.to_array().map(|channel| Levels::Srgb.of(channel) as u8)
    }

    /// Encoded by sRGB in 256ths of an eight-bit level, 0 to 65280: for displays of any depth, before dithering.
    pub fn to_srgb(self) -> [u16; 3] {
        self.to_array().map(|channel| encoded(channel.in_65536ths()) as u16)
    }

    /// Eight-bit levels in proportion to the light, for measuring: the nearest of 0 to 255 for each channel, clamped.
    ///
    /// ```
    /// # use raylet::Color;
    /// assert_eq!(Color::<f32>::from_f64([1.5, 0.5, -1.0]).to_linear888(), [255, 128, 0]);
    /// ```
    pub fn to_linear888(self) -> [u8; 3] {
        self.to_array().map(|channel| Levels::Linear.of(channel) as u8)
    }
}

impl<S: Scalar> From<[S::Unit; 3]> for Color<S> {
    fn from([red, green, blue]: [S::Unit; 3]) -> Self {
        Self::new(red, green, blue)
    }
}
