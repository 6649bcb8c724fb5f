//! Light that a matte surface scatters alike in all directions: Lambert's cosine law (*Photometria*, 1760).

use super::site::Towards;
use crate::scalar::Scalar;
use crate::scene::Material;

/// `Kd (N . L)`: the part of the light, before the surface's colour.
pub(super) fn weight<S: Scalar>(material: &Material<S>, towards: &Towards<S>) -> S::Real {
    material.diffuse.real() * towards.cosine
}
