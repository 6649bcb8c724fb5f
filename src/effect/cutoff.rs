//! Where paths end: at the maximum depth, or where the remaining rays cannot change a level of the picture.

use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{Color, Fog, Levels, Material, Scene};
use crate::shape::kinds::Kinds;
use crate::tier::Tier;
use crate::vector::pairs;

/// The maximum depth of secondary rays: a path has at most `DEPTH + 1` surfaces.
///
/// If refraction is compiled in, paths branch. Rays then wait in two lists of fixed capacity: at most `DEPTH + 1` rays
/// (the deepest is cast first), and `DEPTH` deferred rays of small weight. In `f32` and 32-bit fixed point that takes
/// at most 33 times 100 bytes of stack. Without refraction a path does not branch, since a mirror reflects one ray for
/// each that it receives, and there is no list. No function is recursive.
pub const DEPTH: u8 = 16;

/// True if no addition of up to `doubt` to the light changes its level in any channel.
pub(super) fn is_settled<S: Scalar>(light: [S::Unit; 3], doubt: [S::Real; 3], levels: Levels) -> bool {
    // The sum of the same terms in another order may be rounded differently.
    let rounding = S::Real::ONE.scaled(S::Real::ROUNDING + 3);
    let level = |channel: S::Real| levels.of(S::unit_round(channel));
    pairs(light.map(S::unit_real), doubt)
        .into_iter()
        .all(|(light, doubt)| doubt.is_zero() || level(light - rounding) == level(light + doubt + rounding))
}

/// Upper bounds, for each channel, of the radiance of any ray of a scene: the brightest shading of any surface, plus
/// what it reflects and transmits down to the maximum depth. `sent_on` returns the fraction of the light that a
/// material reflects and transmits.
pub(super) fn brightest<S: Scalar>(
    scene: &Scene<'_, S, impl Tier<S>, impl Kinds>,
    sent_on: impl Fn(&Material<S>) -> S::Real,
) -> [S::Real; 3] {
    let [sky, fog] = [scene.background(), scene.fog().map_or(Color::BLACK, Fog::color)].map(Color::to_array);
    let lamps = scene.lights().iter().fold(scene.ambient().to_array().map(S::unit_real), |sum, light| {
        pairs(sum, light.strength).map(|(sum, strength)| sum + strength.real())
    });
    // A mixture of two colours is no brighter than the brighter one.
    let air = pairs(sky, fog).map(|(sky, fog)| S::unit_real(if sky > fog { sky } else { fog }));
    (0..=DEPTH).fold(air, |seen, _| {
        scene.materials().iter().fold(seen, |brightest, material| {
            let sent_on = sent_on(material);
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

#[cfg(units)]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../tests/units/effect/cutoff.rs"]
mod tests;
