//! Materials.

use super::color::Color;
use super::texture::Waves;
use crate::scalar::Scalar;

/// The material of a surface: the eight numbers of an NFF `f` entity, and properties that this format does not have.
///
/// The radiance of a hit is the sum of
///
/// - for every light that reaches the point, `strength * (color * diffuse * cos + specular * cos'^shine)`, with the
///   angles of Lambert's law and of Phong, *Illumination for computer generated pictures* (1975);
/// - `mirror` times the radiance of the mirrored ray, and `transmittance` times that of the refracted ray (Whitted,
///   *An Improved Illumination Model for Shaded Display*, 1980). Neither is multiplied by `color`.
///
/// If `refraction` is not 1, a fraction F of the transmitted light is reflected instead, by Fresnel's equations: the
/// mirrored ray has the weight `mirror + transmittance F` and the refracted ray `transmittance (1 - F)`. The sum is
/// `mirror + transmittance` at every angle. At total reflection F is 1.
///
/// `diffuse + mirror + transmittance` should be at most 1. That is not checked, and some NFF files exceed it. `mirror`
/// is clamped to 1 and `transmittance` to `1 - mirror`, so that the light along a path never grows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Material<S: Scalar> {
    /// Colour of the surface, each channel in `[0, 1]`.
    pub color: Color<S>,
    /// Diffuse weight, at least 0 and usually at most 1 ("Kd").
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub diffuse: S,
    /// Specular weight, at least 0 and usually at most 1 ("Ks").
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub specular: S,
    /// Phong's cosine power, at least 0: the larger, the smaller the highlight.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub shine: S,
    /// Fraction of the light that is transmitted, at least 0 and usually at most 1. The NFF reader makes objects with a
    /// transmittance above 0 two-sided.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub transmittance: S,
    /// Index of refraction of the medium inside, relative to that outside of all objects. Where solids overlap, the one
    /// that is listed last counts: see [`effect`](crate::effect#glass). At 1 light passes without being bent, as it
    /// should for a surface with the same medium on both sides, such as a thin pane. The same holds for 0, which NFF
    /// files have for opaque materials.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub refraction: S,
    /// Fraction of the light that is reflected as by a mirror, at least 0 and usually at most 1. NFF has no such
    /// number: by its convention the specular weight Ks is also that of the mirror, and the reader sets both.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub mirror: S,
    /// Index into the scene's textures; `None` for `color` everywhere.
    pub texture: Option<u32>,
    /// Waves that perturb the normal (bump mapping); `None` for a smooth surface.
    pub bump: Option<Waves<S>>,
}

impl<S: Scalar> Material<S> {
    /// An opaque diffuse surface.
    pub const fn matte(color: Color<S>) -> Self {
        let one = S::ROUNDED_ONE;
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
    pub const fn with_highlight(self, specular: S, shine: S) -> Self {
        Self { specular, shine, ..self }
    }

    /// The same surface as a mirror of this weight.
    #[must_use]
    pub const fn with_mirror(self, mirror: S) -> Self {
        Self { mirror, ..self }
    }

    /// The same surface with this transmittance and this index of refraction.
    #[must_use]
    pub const fn with_refraction(self, transmittance: S, refraction: S) -> Self {
        Self { transmittance, refraction, ..self }
    }

    /// The same surface with the texture of this index.
    #[must_use]
    pub const fn with_texture(self, texture: u32) -> Self {
        Self { texture: Some(texture), ..self }
    }

    /// The same surface with waves.
    #[must_use]
    pub const fn with_bump(self, waves: Waves<S>) -> Self {
        Self { bump: Some(waves), ..self }
    }

    /// True if light passes through: the transmittance is above 0.
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
