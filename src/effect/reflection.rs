//! Mirrors: Whitted, *An Improved Illumination Model for Shaded Display* (1980).

use super::shading_point::ShadingPoint;
use crate::scalar::{Ring, Scalar};
use crate::scene::Material;
use crate::vector::{UnitVec3, pairs};

/// The fraction of the light that the material reflects as a mirror, clamped to `[0, 1]`.
pub(super) fn weight<S: Scalar>(material: &Material<S>) -> S::Real {
    part(material.mirror)
}

/// A weight clamped to `[0, 1]`, so that the light along a path never grows.
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

/// The direction of the mirrored ray: `2 (N . V) N - V`.
///
/// With a perturbed normal it may point into the surface; then the true normal is used.
pub(super) fn direction<S: Scalar>(site: &ShadingPoint<'_, S>) -> UnitVec3<S> {
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
