//! Specular highlights: Phong, *Illumination for computer generated pictures* (1975).

use super::shading_point::{ShadingPoint, Towards};
use crate::scalar::{Ring, Scalar, UnitScalar};
use crate::scene::Material;

/// `Ks (R . V)^shine`, with the light's direction mirrored in the normal: `R = 2 (N . L) N - L`.
///
/// A highlight has the colour of the light. It is zero where the mirrored direction points away from the viewer.
pub(super) fn weight<S: Scalar>(material: &Material<S>, site: &ShadingPoint<S>, towards: &Towards<S>) -> S::Real {
    if material.specular <= S::ZERO {
        return S::Real::ZERO;
    }
    let both = towards.cosine * site.normal.dot(site.to_viewer);
    let cosine = both + both - towards.direction.dot(site.to_viewer);
    if cosine <= S::Real::ZERO {
        return S::Real::ZERO;
    }
    // Rounded directions may be slightly longer than 1, which a large power would amplify.
    let cosine = S::unit_round(cosine);
    let cosine = if cosine > S::Unit::ONE { S::Unit::ONE } else { cosine };
    material.specular.real() * S::unit_real(S::power(cosine, material.shine))
}
