//! Whether a light reaches a point: one ray towards it (Appel, *Some Techniques for Shading Machine Renderings of Solids*,
//! 1968).

use super::site::{Site, Towards};
use super::work::Work;
use crate::ray::Range;
use crate::scalar::Scalar;
use crate::scene::{Observer, Scene};
use crate::tier::Tier;

/// True if anything stands between the point and the light of this index.
///
/// Casts one ray, with the range `[0, distance]`, and is content with any object on it, the one that cast the last
/// shadow of this light first; no point or normal is computed. Every object that is seen casts the full shadow,
/// transparent ones too: how glass bends and gathers light is not followed, and a scene file means the same
/// whether or not refraction is compiled in. Surfaces seen from one side only cast a shadow from that side only. A
/// point beyond the number type's budget, from which no ray can start, lies in no shadow.
pub(super) fn is_shadowed<S: Scalar, T: Tier<S>, O: Observer>(
    scene: &Scene<'_, S, T>,
    site: &Site<S>,
    light: u32,
    towards: &Towards<S>,
    work: &mut Work<O>,
) -> bool {
    let Some(mut ray) = site.ray(towards.direction, false) else { return false };
    if let Ok(range) = Range::new(S::ZERO, towards.distance) {
        ray = ray.with_range(range);
    }
    work.counters.shadow_rays += 1;
    if let Some(last) = work.last_occluder(light)
        && scene.stands_on(last, &ray, &mut work.counters, &mut work.observer)
    {
        return true;
    }
    let occluder = scene.occluder(&ray, &mut work.counters, &mut work.observer);
    work.remember_occluder(light, occluder);
    occluder.is_some()
}
