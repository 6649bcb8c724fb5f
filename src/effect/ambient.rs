//! Ambient light: light of the same strength from everywhere (Phong, *Illumination for computer generated pictures*,
//! 1975).

use crate::scalar::{Scalar, UnitScalar};
use crate::scene::{Color, Material};
use crate::vector::pairs;

/// The ambient light that a surface of this colour scatters, times `weight`.
pub(super) fn light<S: Scalar>(
    ambient: Color<S>,
    material: &Material<S>,
    color: Color<S>,
    weight: S::Unit,
) -> [S::Unit; 3] {
    let scattered = S::times(weight, material.diffuse);
    pairs(ambient.to_array(), color.to_array()).map(|(ambient, own)| ambient.times(own).times(scattered))
}
