//! What a surface does with light.

use super::color::Color;
use super::texture::Waves;
use crate::scalar::{Ring, Scalar};

/// The surface of an object: the eight numbers of an NFF `f` entity, and what that format cannot say.
///
/// A ray that meets it brings back
///
/// - for every light that reaches the point, `strength * (color * diffuse * cos + specular * cos'^shine)`, with the
///   angles of Lambert's law and of Phong, *Illumination for computer generated pictures* (1975);
/// - `mirror` times what the mirrored ray brings back, and `transmittance` times what the refracted ray does (Whitted,
///   *An Improved Illumination Model for Shaded Display*, 1980). Neither is tinted by `color`.
///
/// Where `refraction` is not 1, a part F of the transmitted light goes the way of the mirrored ray instead, by
/// Fresnel's equations: `mirror + transmittance F` is reflected and `transmittance (1 - F)` passes. Their sum is
/// the material's own, `mirror + transmittance`, at every angle; where reflection is total, F is 1.
///
/// Energy is not added up for you: `diffuse + mirror + transmittance` should stay at most 1, and
/// NFF files do not always keep to it. A mirror above 1 counts as 1, and of the transmittance no more counts than the mirror leaves:
/// no path brings back more light than it finds.
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
    /// Index of refraction of the inside over the outside. At 1 (and at 0, which NFF files have where nothing
    /// transmits) light goes straight on: right for a surface with the same on both sides, such as a thin pane.
    pub refraction: S,
    /// Part of the light that is reflected as by a mirror, at least 0 and usually at most 1. NFF has no number of its own
    /// for it: by its custom the highlights' weight Ks is also the mirror's, and its reader sets both.
    pub mirror: S,
    /// Index into the scene's textures; `None` leaves `color` alone.
    pub texture: Option<u32>,
    /// Waves that bend the normal; `None` leaves the surface smooth.
    pub bump: Option<Waves<S>>,
}

impl<S: Scalar> Material<S> {
    /// A dull surface: all diffuse, opaque.
    pub fn matte(color: Color<S>) -> Self {
        let one = S::round(S::Real::ONE);
        Self {
            color,
            diffuse: one,
            specular: S::ZERO,
            shine: S::ZERO,
            transmittance: S::ZERO,
            refraction: one,
            mirror: S::ZERO,
            texture: None,
            bump: None,
        }
    }

    /// The same surface with a highlight of this weight and this cosine power.
    #[must_use]
    pub fn with_highlight(self, specular: S, shine: S) -> Self {
        Self { specular, shine, ..self }
    }

    /// The same surface as a mirror of this weight.
    #[must_use]
    pub fn with_mirror(self, mirror: S) -> Self {
        Self { mirror, ..self }
    }

    /// The same surface with this part of the light passing, into an inside of this index of refraction.
    #[must_use]
    pub fn with_refraction(self, transmittance: S, refraction: S) -> Self {
        Self { transmittance, refraction, ..self }
    }

    /// The same surface with the texture of this index.
    #[must_use]
    pub fn with_texture(self, texture: u32) -> Self {
        Self { texture: Some(texture), ..self }
    }

    /// The same surface with waves.
    #[must_use]
    pub fn with_bump(self, waves: Waves<S>) -> Self {
        Self { bump: Some(waves), ..self }
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
