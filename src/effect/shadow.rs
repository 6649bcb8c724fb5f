//! Whether a light reaches a point.

use super::{Site, Towards};
use crate::ray::{Departure, Leaving, Range, Ray};
use crate::scalar::Scalar;
use crate::scene::{Counters, Scene};

/// True if anything stands between the point and the light. Casts one ray, with the range `[0, distance]`; no offset
/// keeps it off the surface that it starts on, the [`Departure`] does.
///
/// Surfaces seen from one side only cast a shadow from that side only. A point beyond the number type's budget, from
/// which no ray can start, lies in no shadow.
pub(super) fn is_shadowed<S: Scalar>(
    scene: &Scene<'_, S>,
    site: &Site<S>,
    towards: &Towards<S>,
    counters: &mut Counters,
) -> bool {
    let Ok(ray) = Ray::new(site.point, towards.direction) else { return false };
    let leaving = if site.seen_from_outside { Leaving::Outwards } else { Leaving::Inwards };
    let mut ray = ray.departing(Departure { object: site.on.object, part: site.on.hit.part, leaving });
    if let Ok(range) = Range::new(S::ZERO, towards.distance) {
        ray = ray.with_range(range);
    }
    counters.shadow_rays += 1;
    scene.occludes(&ray, counters)
}
