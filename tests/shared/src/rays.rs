//! Seeded rays that hit, and others that miss.

use crate::digest::Random;
use crate::subject::Subject;
use raylet::tier::Stable;
use raylet::{Ray, Scalar};

/// Rays of each kind at each subject.
pub const RAYS: usize = 64;

/// From 2 to 6 away towards a point near the subject; all hit it, or none does. The same in every number type, but for
/// the rounding of the direction.
#[inline(never)]
pub fn rays<S: Scalar, P: Subject<S>>(subject: &P, hitting: bool) -> [Ray<S>; RAYS] {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    core::array::from_fn(|_| {
        loop {
            let (origin, target) = (random.point::<S>(6), random.point(2));
            let is_away = origin.to_array().iter().any(|c| c.to_f64().abs() > 2.0);
            if !is_away || subject.contains(origin) {
                continue;
            }
            if let Ok(ray) = Ray::towards(origin, target)
                && subject.nearest::<Stable>(&ray).is_some() == hitting
            {
                return ray;
            }
        }
    })
}
