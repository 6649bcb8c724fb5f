//! What a surface does with light.

use super::color::Color;
use crate::scalar::{Real, Scalar};

/// The surface of an object: the eight numbers of an NFF `f` entity.
///
/// Diffuse and specular shading use `color`, `diffuse`, `specular` and `shine`. Mirror rays (weighted by `specular`)
/// and refracted rays (weighted by `transmittance`) are not cast yet: the numbers are kept for them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<S: Scalar> {
    /// Colour of the surface, each channel in `[0, 1]`.
    pub color: Color<S>,
    /// Diffuse weight, at least 0 and usually at most 1 ("Kd").
    pub diffuse: S,
    /// Specular weight, at least 0 and usually at most 1 ("Ks").
    pub specular: S,
    /// Phong's cosine power, at least 0: the larger, the smaller the highlight.
    pub shine: S,
    /// Part of the light that passes through, at least 0 and usually at most 1. Above 0 the object has two sides.
    pub transmittance: S,
    /// Index of refraction of the inside over the outside.
    pub refraction: S,
}

impl<S: Scalar> Material<S> {
    /// A dull surface: all diffuse, opaque.
    pub fn matte(color: Color<S>) -> Self {
        let one = S::round(S::Real::ONE);
        Self { color, diffuse: one, specular: S::ZERO, shine: S::ZERO, transmittance: S::ZERO, refraction: one }
    }

    /// The same surface with a highlight of this weight and this cosine power.
    #[must_use]
    pub fn with_highlight(self, specular: S, shine: S) -> Self {
        Self { specular, shine, ..self }
    }

    /// True if light passes through, so that both sides of the surface are seen.
    pub fn transmits(&self) -> bool {
        self.transmittance > S::ZERO
    }
}

impl<S: Scalar> Default for Material<S> {
    /// White and matte.
    fn default() -> Self {
        Self::matte(Color::WHITE)
    }
}
