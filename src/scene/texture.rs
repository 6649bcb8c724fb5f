//! Textures and bump maps: colours and heights as functions of the surface coordinates `u` and `v`.

use super::color::Color;
use crate::scalar::Scalar;
use core::fmt;

/// One of the two surface coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Coordinate {
    /// `u`: around the axis, or along x.
    U,
    /// `v`: up along the axis, or along z.
    V,
}

/// A colour for each point of a surface. The material's colour is multiplied by it, so that a white material shows the
/// texture unchanged.
///
/// The texture spans `[0, 1]` in `u` and `v`; on a plane, which is infinite, it repeats every unit of length. There is
/// no interpolation between texels or fields; antialiasing smooths their edges.
///
/// Catmull, *A Subdivision Algorithm for Computer Display of Curved Surfaces* (1974).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(bound = ""))]
#[non_exhaustive]
pub enum Texture<'a, S: Scalar> {
    /// A chessboard of `columns` fields along `u` and `rows` along `v`, each at least 1; the field at (0, 0) has the
    /// first colour. Around an axis, an even number of columns joins without a visible seam. On a plane, where the
    /// coordinates repeat with every unit of length, even numbers make a chessboard too, with fields a `columns`-th of
    /// a unit wide; odd ones join fields of one colour. For larger fields take a rectangle.
    Checker {
        /// Fields along `u`.
        columns: u16,
        /// Fields along `v`.
        rows: u16,
        /// The two colours, each channel in `[0, 1]`.
        colors: [Color<S>; 2],
    },
    /// `count` stripes, at least 1, of alternating colour along a coordinate; the stripe at 0 has the first colour.
    Stripes {
        /// The coordinate along which the colour changes.
        along: Coordinate,
        /// The number of stripes of both colours together.
        count: u16,
        /// The two colours, each channel in `[0, 1]`.
        colors: [Color<S>; 2],
    },
    /// A chessboard in space: so many fields, each at least 1, along each axis of the primitive's bounding box, by the
    /// solid coordinates ([`Surface::uvw`](crate::Surface::uvw)). It continues across edges and rims. The field at (0,
    /// 0, 0) has the first colour.
    Cells {
        /// Fields along x, y and z.
        counts: [u16; 3],
        /// The two colours, each channel in `[0, 1]`.
        colors: [Color<S>; 2],
    },
    /// An image in linear RGB: rows from the top (`v` = 1), each from the left (`u` = 0).
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
            Self::Cells { counts, .. } => counts.contains(&0).then_some(TextureFault::Empty),
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

/// Bump mapping by waves along each surface coordinate, which perturb the normal.
///
/// A wave consists of two parabolic arcs, a hill and a valley. It is close to a sine and costs a fraction of it.
/// The geometry is not changed: silhouettes and shadows do not show the waves. Blinn, *Simulation of Wrinkled Surfaces*
/// (1978).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct Waves<S> {
    /// Whole waves over `u` from 0 to 1; 0 for none.
    pub along_u: u16,
    /// Whole waves over `v` from 0 to 1; 0 for none.
    pub along_v: u16,
    /// The largest slope of each wave, rise over run, usually below 1; 0 leaves the normal unchanged. It is the same
    /// along `u` and `v`, whatever the wavelengths.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub slope: S,
}

impl<S: Scalar> Waves<S> {
    /// True if the waves change any normal.
    pub fn are_visible(&self) -> bool {
        self.slope != S::ZERO && (self.along_u, self.along_v) != (0, 0)
    }
}
