//! Ambient light: light of the same strength from everywhere (Phong, *Illumination for computer generated pictures*,
//! 1975).

use crate::scalar::Scalar;
use crate::scene::{Color, Material};
use crate::vector::pairs;

/// The ambient light that a surface of this colour scatters, times `weight`.
pub(super) fn light<S: Scalar>(
    ambient: Color<S>,
    material: &Material<S>,
    color: Color<S>,
    weight: S::Real,
) -> [S::Real; 3] {
    let scattered = material.diffuse.real() * weight;
    pairs(ambient.to_array(), color.to_array())
        .map(|(ambient, own)| S::unit_real(ambient) * S::unit_real(own) * scattered)
}
