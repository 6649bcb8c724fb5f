//! Which rays may be left out because they cannot change a level of the picture.

use super::reflection::part;
use super::tracer::DEPTH;
use crate::scalar::{Real, Scalar, UnitScalar};
use crate::scene::{Color, Fog, Scene};
use crate::vector::pairs;

/// True if the light has the same level in each channel whether or not something up to `doubt` is added to it.
pub(super) fn is_settled<S: Scalar>(light: [S::Real; 3], doubt: [S::Real; 3], levels: u16) -> bool {
    // In another order the sum may be rounded otherwise.
    let rounding = S::Real::ONE.times_power_of_two(S::Real::ROUNDING + 3);
    let level = |channel: S::Real| S::unit_round(channel).level(levels);
    pairs(light, doubt)
        .into_iter()
        .all(|(light, doubt)| doubt.is_zero() || level(light - rounding) == level(light + doubt + rounding))
}

/// Upper bounds for the light that any ray of a scene brings back in each channel: the brightest of its surfaces, with what can
/// be seen in it, and in that, as often as rays are followed on.
pub(super) fn brightest<S: Scalar>(scene: &Scene<'_, S>) -> [S::Real; 3] {
    let [sky, fog] = [scene.background(), scene.fog().map_or(Color::BLACK, Fog::color)].map(Color::to_array);
    let zero = S::Real::ZERO;
    let lamps = scene
        .lights()
        .iter()
        .fold([zero; 3], |sum, light| pairs(sum, light.strength).map(|(sum, strength)| sum + strength.real()));
    // Fog and surface together are no brighter than the brighter one.
    let air = pairs(sky, fog).map(|(sky, fog)| S::unit_real(if sky > fog { sky } else { fog }));
    (0..=DEPTH).fold(air, |seen, _| {
        scene.materials().iter().fold(seen, |brightest, material| {
            let sent_on = part(material.mirror) + part(material.transmittance);
            let [diffuse, specular] = [material.diffuse, material.specular].map(S::real);
            // Textures only darken.
            let shaded = pairs(lamps, material.color.to_array());
            let shaded = shaded.map(|(lamps, own)| lamps * (S::unit_real(own) * diffuse + specular));
            pairs(brightest, pairs(shaded, seen)).map(|(brightest, (shaded, seen))| {
                let bright = shaded + sent_on * seen;
                if bright > brightest { bright } else { brightest }
            })
        })
    })
}
