//! Transmission through a surface: Snell's law, Fresnel's equations (as in Born and Wolf, *Principles of Optics*, 1.5),
//! total reflection.
//!
//! Light is refracted by the ratio of the indices of the media before and behind the interface (see `media`). Behind an
//! open surface lies its own material, since a closed object may consist of triangles, or of an open cylinder and two
//! discs. A single pane, open cylinder or triangle with the same medium on both sides should have the index 1, which
//! does not bend the light.

use super::media::Media;
use super::reflection::part;
use super::shading_point::ShadingPoint;
use crate::hit::Crossing;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::Material;
use crate::vector::{UnitVec3, pairs};

/// How light is divided at a transparent surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Split<S: Scalar> {
    /// The direction of the refracted ray; `None` at total reflection.
    pub(super) through: Option<UnitVec3<S>>,
    /// True if the refracted ray enters another medium.
    pub(super) changes_medium: bool,
    /// The fraction of the light that is transmitted, in `[0, 1]`.
    pub(super) passing: S::Real,
    /// The fraction that is reflected by Fresnel's equations. The sum of both is the material's transmittance.
    pub(super) reflected: S::Real,
}

/// The fraction of the light that is transmitted or reflected by Fresnel's equations: at most `1 - mirror`.
pub(super) fn transmittance<S: Scalar>(material: &Material<S>) -> S::Real {
    let (rest, transmittance) = (S::Real::ONE - part(material.mirror), part(material.transmittance));
    if transmittance < rest { transmittance } else { rest }
}

/// How light is divided at a shading point.
pub(super) fn split<S: Scalar>(
    material: &Material<S>,
    site: &ShadingPoint<'_, S>,
    crossing: Crossing,
    media: Media<'_, S>,
) -> Split<S> {
    let (zero, one) = (S::Real::ZERO, S::Real::ONE);
    let transmittance = transmittance(material);
    let straight =
        Split { through: Some(-site.to_viewer), changes_medium: false, passing: transmittance, reflected: zero };
    let [before, behind] = [media.before, media.behind].map(index);
    // A ray that only touches neither enters nor leaves.
    if transmittance.is_zero() || before == behind || crossing == Crossing::Touch {
        return straight;
    }
    // The index of refraction of the far side relative to the near side.
    let denser = if before == one { behind } else { behind / before };
    let bent = bend(site, site.normal, denser);
    // With a perturbed normal the refracted ray may be on the wrong side of the surface; with the true normal it is
    // not.
    let bent = match bent {
        Some((through, _)) if site.normal != site.facing && through.dot(site.facing) >= zero => {
            bend(site, site.facing, denser)
        }
        bent => bent,
    };
    match bent {
        Some((through, reflectance)) => {
            let reflected = transmittance * reflectance;
            Split { through: Some(through), changes_medium: true, passing: transmittance - reflected, reflected }
        }
        None => Split { through: None, changes_medium: false, passing: zero, reflected: transmittance },
    }
}

/// The index of refraction of a medium; 1 outside of all, and for 0, which NFF files have for opaque materials.
fn index<S: Scalar>(medium: Option<&Material<S>>) -> S::Real {
    let index = medium.map_or(S::Real::ONE, |material| material.refraction.real());
    if index > S::Real::ZERO { index } else { S::Real::ONE }
}

/// The refracted direction, and the fraction that is reflected; `None` at total reflection.
fn bend<S: Scalar>(site: &ShadingPoint<'_, S>, normal: UnitVec3<S>, denser: S::Real) -> Option<(UnitVec3<S>, S::Real)> {
    let (zero, one) = (S::Real::ZERO, S::Real::ONE);
    let cosine = normal.dot(site.to_viewer);
    // For a grazing ray the cosine with a rounded normal may be negative.
    let cosine = if cosine > zero { cosine } else { zero };
    let ratio = one / denser;
    // The square of the refracted ray's cosine: 1 - sin^2 by Snell's law.
    let square = one - ratio * ratio * (one - cosine * cosine);
    if square <= zero {
        return None;
    }
    let refracted = square.sqrt();
    let along = ratio * cosine - refracted;
    let direction =
        UnitVec3::from_real(pairs(normal.real(), site.to_viewer.real()).map(|(n, v)| along * n - ratio * v))?;
    // Fresnel's equations for unpolarised light: the mean of both polarisations' reflectances.
    let across = (cosine - denser * refracted) / (cosine + denser * refracted);
    let within = (refracted - denser * cosine) / (refracted + denser * cosine);
    let reflectance = (across * across + within * within).scaled(-1);
    Some((direction, if reflectance < one { reflectance } else { one }))
}
