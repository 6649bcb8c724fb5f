//! Mirrors: Whitted, *An Improved Illumination Model for Shaded Display* (1980).

use super::site::Site;
use crate::scalar::{Ring, Scalar};
use crate::scene::Material;
use crate::vector::{UnitVec3, pairs};

/// The part of the light that the material reflects as a mirror, brought into `[0, 1]`.
pub(super) fn weight<S: Scalar>(material: &Material<S>) -> S::Real {
    part(material.mirror)
}

/// A weight brought into `[0, 1]`, so that no ray brings back more light than it finds.
pub(super) fn part<S: Scalar>(weight: S) -> S::Real {
    let weight = weight.real();
    if weight >= S::Real::ONE {
        S::Real::ONE
    } else if weight > S::Real::ZERO {
        weight
    } else {
        S::Real::ZERO
    }
}

/// The direction in which the viewer is mirrored: `2 (N . V) N - V`.
///
/// A bent normal may mirror a grazing ray into the surface; such a ray is mirrored in the true normal.
pub(super) fn direction<S: Scalar>(site: &Site<S>) -> UnitVec3<S> {
    let about = |normal: UnitVec3<S>| {
        let cosine = normal.dot(site.to_viewer);
        let twice = cosine + cosine;
        UnitVec3::from_real(pairs(normal.real(), site.to_viewer.real()).map(|(n, v)| twice * n - v))
    };
    about(site.normal)
        .filter(|mirrored| site.normal == site.facing || mirrored.dot(site.facing) > S::Real::ZERO)
        .or_else(|| about(site.facing))
        .unwrap_or(site.facing)
}
