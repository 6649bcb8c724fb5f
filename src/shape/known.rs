//! The crossings of a shape by a ray of which more is known than its coordinates: whether it starts inside.

use super::Shape;
use super::kinds::Kinds;
use crate::hit::{Crossing, Hit, HitList};
use crate::part::Part;
use crate::ray::{Range, Ray};
use crate::scalar::{Scalar, largest};
use crate::tier::Tier;

/// The crossings of a shape. If it is a solid, they alternate, beginning with an exit if the ray is inside of it.
/// `None` if the coordinates decide whether it is. Also whether the first crossing was moved to the start.
pub(crate) fn crossings<S: Scalar, T: Tier<S>, K: Kinds>(
    ray: &Ray<S>,
    shape: &Shape<S, K>,
    is_inside: Option<bool>,
) -> (K::Hits<S>, bool) {
    let mut hits = shape.crossings_at::<T>(ray);
    let Some(is_inside) = is_inside else { return (hits, false) };
    if ray.departure().is_some() {
        if let [exit, enter, ..] = *hits
            && (exit.crossing, enter.crossing) == (Crossing::Exit, Crossing::Enter)
            && stays(ray, enter.t)
        {
            // At the apex of a double cone the gap between the nappes may be less than a rounding of the point, and the
            // ray would meet it again and again.
            hits.retain(|hit| *hit != exit && *hit != enter);
        }
        return (hits, false);
    }
    if shape.is_solid() && hits.starts_inside() != is_inside {
        return corrected::<S, T, K>(ray, shape, &hits, is_inside);
    }
    (hits, false)
}

/// True if the point at `t` is the ray's start, but for a rounding of its largest coordinate. (Others may be next to
/// zero, where a float is finer.)
pub(crate) fn stays<S: Scalar>(ray: &Ray<S>, t: S) -> bool {
    let reach = largest(ray.origin().to_array());
    ray.at(t) == ray.origin() || reach.plus(t) == reach
}

/// Across which crossing rounding has moved a start: true for the one behind it, false for the one ahead, whichever is
/// nearer.
pub(crate) fn is_behind<S: Scalar>(start: S, behind: Option<S>, ahead: Option<S>) -> bool {
    match (behind, ahead) {
        (Some(behind), Some(ahead)) => start.minus(behind) <= ahead.minus(start),
        (None, Some(_)) => false,
        (_, None) => true,
    }
}

/// The crossings of a solid whose rounded coordinates contradict what is known: that the ray starts inside of it, or
/// that it does not. Rounding has moved the start across the nearer of the two crossings around it.
#[cold]
fn corrected<S: Scalar, T: Tier<S>, K: Kinds>(
    ray: &Ray<S>,
    shape: &Shape<S, K>,
    hits: &K::Hits<S>,
    is_inside: bool,
) -> (K::Hits<S>, bool) {
    let start = ray.range().start();
    let line = shape.crossings_at::<T>(&ray.with_range(Range::line()));
    // Known to be inside and computed to be outside, the ray has not left at the last exit, or it has entered at the
    // next entry; and so on.
    let (missed, passed) =
        if is_inside { (Crossing::Exit, Crossing::Enter) } else { (Crossing::Enter, Crossing::Exit) };
    let behind = line.iter().rfind(|hit| hit.crossing == missed && hit.t <= start);
    let ahead = hits.iter().position(|hit| hit.crossing == passed);
    let next = ahead.and_then(|ahead| hits.get(ahead)).map(|hit| hit.t);
    let is_behind = is_behind(start, behind.map(|hit| hit.t), next);
    let mut corrected = K::Hits::<S>::none();
    if is_inside {
        corrected.start_inside();
    }
    if is_behind {
        let part = behind.map_or(Part::Side, |hit| hit.part);
        corrected.push(Hit { t: start, part, crossing: missed });
    }
    let skipped = if is_behind { 0 } else { ahead.map_or(0, |ahead| ahead + 1) };
    hits.iter().skip(skipped).for_each(|hit| corrected.push(*hit));
    (corrected, is_behind)
}
