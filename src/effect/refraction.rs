//! Light that passes through a surface: Snell's law, Fresnel's equations (as in Born and Wolf, *Principles of Optics*, 1.5),
//! total reflection.
//!
//! A surface separates what is before it from what is behind it: light that enters is bent by `1 / refraction`, light that leaves
//! by `refraction`. This holds for every surface, since a closed hull may be made of triangles or of a tube with two discs.
//! A lone pane, tube or triangle that is to have the same on both sides has the index 1, and lets light pass straight.

use super::reflection::part;
use super::site::Site;
use crate::hit::Crossing;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::Material;
use crate::vector::{UnitVec3, pairs};

/// What becomes of light at a transparent surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Split<S: Scalar> {
    /// Where the light goes that passes; `None` if all of it is reflected.
    pub(super) through: Option<UnitVec3<S>>,
    /// True if what is behind the surface is another medium than what is before it.
    pub(super) changes_medium: bool,
    /// The part of the ray's light that passes, in `[0, 1]`.
    pub(super) passing: S::Real,
    /// The part that is reflected instead of passing; both together are the material's transmittance.
    pub(super) reflected: S::Real,
}

/// The part of the light that passes or is reflected by Fresnel's equations: what the mirror leaves, at most.
pub(super) fn transmittance<S: Scalar>(material: &Material<S>) -> S::Real {
    let (rest, transmittance) = (S::Real::ONE - part(material.mirror), part(material.transmittance));
    if transmittance < rest { transmittance } else { rest }
}

/// How the light of a ray divides here.
pub(super) fn split<S: Scalar>(material: &Material<S>, site: &Site<S>, crossing: Crossing) -> Split<S> {
    let (zero, one) = (S::Real::ZERO, S::Real::ONE);
    let transmittance = transmittance(material);
    let straight =
        Split { through: Some(-site.to_viewer), changes_medium: false, passing: transmittance, reflected: zero };
    let index = material.refraction.real();
    // A ray that only touches neither enters nor leaves.
    if transmittance.is_zero() || index == one || index <= zero || crossing == Crossing::Touch {
        return straight;
    }
    // How much denser the far side is.
    let denser = if site.from_outside { index } else { one / index };
    let bent = bend(site, site.normal, denser);
    // A bent normal may send a grazing ray to the wrong side; the true one does not.
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

/// The refracted direction, and the part that is reflected; `None` if all is.
fn bend<S: Scalar>(site: &Site<S>, normal: UnitVec3<S>, denser: S::Real) -> Option<(UnitVec3<S>, S::Real)> {
    let (zero, one) = (S::Real::ZERO, S::Real::ONE);
    let cosine = normal.dot(site.to_viewer);
    // A rounded normal may lean away from a ray that grazes.
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
    // Fresnel's equations for light that is not polarised: the mean of both polarisations' reflectances.
    let across = (cosine - denser * refracted) / (cosine + denser * refracted);
    let within = (refracted - denser * cosine) / (refracted + denser * cosine);
    let reflectance = (across * across + within * within).scaled(-1);
    Some((direction, if reflectance < one { reflectance } else { one }))
}
