//! Which rays may be left out because they cannot change a level of the picture.

use super::reflection::part;
use super::tracer::DEPTH;
use crate::scalar::{Real, Scalar, UnitScalar};
use crate::scene::{Color, Fog, Scene};
use crate::vector::pairs;

/// The weight below which rays are left out at first, as a power of two.
const FIRST: i32 = -14;
/// Where an attempt with less than this weight would follow, no ray is left out.
const LAST: i32 = -30;

/// The weight below which rays are left out, attempt by attempt.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cutoff {
    /// As a power of two; `None` to leave out none.
    power: Option<i32>,
}

impl Cutoff {
    /// The first attempt's.
    pub(super) fn first(uncut: bool) -> Self {
        Self { power: if uncut { None } else { Some(FIRST) } }
    }

    /// The weight.
    pub(super) fn weight<S: Scalar>(self) -> S::Real {
        self.power.map_or(S::Real::ZERO, |power| S::Real::ONE.times_power_of_two(power))
    }

    /// The next attempt's; `None` if this one's light has the same level in each channel whether or not `foregone` is added
    /// to it.
    ///
    /// What is left out is about proportional to the weight below which it is: the next attempt leaves out so little that it
    /// should be settled.
    pub(super) fn next<S: Scalar>(self, light: [S::Real; 3], foregone: [S::Real; 3], levels: u16) -> Option<Self> {
        let power = self.power?;
        let mut doubt = foregone.map(|foregone| foregone + foregone.times_power_of_two(-4));
        let mut next = power;
        while !is_settled::<S>(light, doubt, levels) {
            if next <= LAST {
                return Some(Self { power: None });
            }
            next -= 1;
            doubt = doubt.map(|doubt| doubt.times_power_of_two(-1));
        }
        // One more, for it is only about proportional.
        (next < power).then_some(Self { power: Some(next - 1) })
    }
}

/// True if the light has the same level in each channel whether or not `doubt` is added to it.
pub(super) fn is_settled<S: Scalar>(light: [S::Real; 3], doubt: [S::Real; 3], levels: u16) -> bool {
    // Rounded sums only grow with what is added to them, but by a little more or less than that.
    let rounding = S::Real::ONE.times_power_of_two(S::Real::ROUNDING + 3);
    let level = |channel: S::Real| S::unit_round(channel).level(levels);
    pairs(light, doubt)
        .into_iter()
        .all(|(light, doubt)| doubt.is_zero() || level(light) == level(light + doubt + rounding))
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
