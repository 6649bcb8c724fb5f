//! Outlines: a line around whatever is seen.

use super::color::Color;
use crate::scalar::Scalar;

/// A line of one colour around whatever the eye sees: for displays of few shades, and for drawings.
///
/// A pixel shows the line if the ray `width` pixels to its right, or the one `width` pixels below it, sees something
/// else (Saito and Takahashi, *Comprehensible Rendering of 3-D Shapes*, 1990): nothing, or another material; or another
/// object, part or side of the same material, if the surface bends by more than 29 degrees or jumps by more than the
/// rays are apart. So triangles of one surface have no line between them, nor have a cylinder and a hemisphere that
/// continues it. The line begins `width` pixels left of a thing and above it, and is the last `width` pixels of it on
/// its right and at its lower end.
///
/// What mirrors and glass show has no outline. Fog does not veil the line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Outline<S: Scalar> {
    /// Colour of the line, each channel in `[0, 1]`.
    pub color: Color<S>,
    /// Width of the line in pixels. A thing that is narrower may have a gap in its line; at 0 there is no line.
    pub width: u8,
}

impl<S: Scalar> Outline<S> {
    /// A line of this colour, one pixel wide.
    pub const fn new(color: Color<S>) -> Self {
        Self { color, width: 1 }
    }

    /// The same line of so many pixels.
    #[must_use]
    pub const fn with_width(self, width: u8) -> Self {
        Self { width, ..self }
    }
}
