//! Diffuse shading: Lambert's cosine law (*Photometria*, 1760).

use super::shading_point::Towards;
use crate::scalar::Scalar;
use crate::scene::Material;

/// `Kd (N . L)`: the fraction of the light, before it is multiplied by the surface's colour.
pub(super) fn weight<S: Scalar>(material: &Material<S>, towards: &Towards<S>) -> S::Unit {
    S::times(towards.cosine, material.diffuse)
}
