//! Specular highlights: Phong, *Illumination for computer generated pictures* (1975).

use super::shading_point::{ShadingPoint, Towards};
use crate::scalar::{Scalar, UnitScalar};
use crate::scene::Material;

/// `Ks (R . V)^shine`, with the light's direction mirrored in the normal: `R = 2 (N . L) N - L`.
///
/// A highlight has the colour of the light. It is zero where the mirrored direction points away from the viewer.
pub(super) fn weight<S: Scalar>(material: &Material<S>, site: &ShadingPoint<'_, S>, towards: &Towards<S>) -> S::Unit {
    if material.specular <= S::ZERO {
        return S::Unit::ZERO;
    }
    let both = towards.cosine.times(site.normal.cosine(site.to_viewer));
    // In this order no sum is above 2.
    let cosine = both.minus(towards.direction.cosine(site.to_viewer)).plus(both);
    if cosine <= S::Unit::ZERO {
        return S::Unit::ZERO;
    }
    // Rounded directions may be slightly longer than 1, which a large power would amplify.
    let cosine = if cosine > S::Unit::ONE { S::Unit::ONE } else { cosine };
    S::times(power::<S>(cosine, material.shine), material.specular)
}

/// `base^exponent` for a base in `[0, 1]`: of a small whole exponent by squares, which take less time than a
/// logarithm and an exponential.
fn power<S: Scalar>(base: S::Unit, exponent: S) -> S::Unit {
    let Some(mut left) = exponent.small_integer() else { return S::power(base, exponent) };
    let (mut power, mut square) = (S::Unit::ONE, base);
    while left > 0 {
        if left % 2 == 1 {
            power = power.times(square);
        }
        square = square.times(square);
        left /= 2;
    }
    power
}

#[cfg(units)]
#[path = "../../tests/units/effect/specular.rs"]
mod tests;
