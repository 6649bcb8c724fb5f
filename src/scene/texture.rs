//! Patterns on a surface: colours and heights over its coordinates `u` and `v`.

use super::color::Color;
use crate::scalar::Scalar;
use core::fmt;

/// Which of the two surface coordinates counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Coordinate {
    /// `u`: around the axis, or along x.
    U,
    /// `v`: up along the axis, or along z.
    V,
}

/// A colour for each point of a surface, by which the material's colour is multiplied: a white material shows the
/// texture as it is.
///
/// Spread over `[0, 1]` in `u` and `v` (see [`crate::primitive`]); on a plane, which has no end, once for each unit of
/// length. No interpolation: edges are sharp, and antialiasing is what softens them.
///
/// Catmull, *A Subdivision Algorithm for Computer Display of Curved Surfaces* (1974).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Texture<'a, S: Scalar> {
    /// A chessboard of `columns` fields along `u` and `rows` along `v`, each at least 1; the field at (0, 0) has the
    /// first colour. An even number of columns closes without a seam around an axis.
    Checker {
        /// Fields along `u`.
        columns: u16,
        /// Fields along `v`.
        rows: u16,
        /// The two colours, each channel in `[0, 1]`.
        colors: [Color<S>; 2],
    },
    /// `count` stripes, at least 1, that follow each other along a coordinate; the stripe at 0 has the first colour.
    Stripes {
        /// Along which coordinate the colour changes.
        along: Coordinate,
        /// Stripes of either colour, counted together.
        count: u16,
        /// The two colours, each channel in `[0, 1]`.
        colors: [Color<S>; 2],
    },
    /// An image, linear in light: rows from the top (`v` = 1), each from the left (`u` = 0).
    Image {
        /// Pixels in a row, at least 1.
        width: u16,
        /// Rows, at least 1.
        height: u16,
        /// Red, green and blue from 0 to 255: `width * height` of them.
        pixels: &'a [[u8; 3]],
    },
}

impl<S: Scalar> Texture<'_, S> {
    /// What is wrong with it, if anything is.
    pub(super) fn fault(&self) -> Option<TextureFault> {
        match *self {
            Self::Checker { columns, rows, .. } => (columns == 0 || rows == 0).then_some(TextureFault::Empty),
            Self::Stripes { count, .. } => (count == 0).then_some(TextureFault::Empty),
            Self::Image { width, height, .. } if width == 0 || height == 0 => Some(TextureFault::Empty),
            Self::Image { width, height, pixels } => {
                let wanted = u32::from(width) * u32::from(height);
                (u32::try_from(pixels.len()) != Ok(wanted)).then_some(TextureFault::Pixels { wanted })
            }
        }
    }
}

/// What can be wrong with a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum TextureFault {
    /// A count, a width or a height is 0.
    Empty,
    /// The image's list has another length than its width times its height.
    Pixels {
        /// The length that it should have.
        wanted: u32,
    },
}

impl fmt::Display for TextureFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("its counts, width and height must be at least 1"),
            Self::Pixels { wanted } => write!(f, "its width and height call for {wanted} pixels"),
        }
    }
}

/// Heights on a surface: waves along each surface coordinate, by which its normal leans to and fro.
///
/// A wave is made of two arcs of a parabola, a hill and a valley: near a sine, at a fraction of its cost.
/// The surface itself stays smooth: outline and shadow do not show the waves. Blinn, *Simulation of Wrinkled Surfaces*
/// (1978).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Waves<S> {
    /// Whole waves over `u` from 0 to 1; 0 for none.
    pub along_u: u16,
    /// Whole waves over `v` from 0 to 1; 0 for none.
    pub along_v: u16,
    /// The steepest slope of each wave, rise over run, usually below 1; 0 leaves the normal alone. The same in
    /// directions `u` and `v`, however long the waves are.
    pub slope: S,
}

impl<S: Scalar> Waves<S> {
    /// True if they bend any normal.
    pub fn are_visible(&self) -> bool {
        self.slope != S::ZERO && (self.along_u, self.along_v) != (0, 0)
    }
}
