//! Floor 5: the three questions, asked of any geometry in the world's frame or in a frame of its own.

use crate::hit::{Crossing, Hit, Hits};
use crate::line::Local;
use crate::primitive::Geometry;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::span::Meeting;
use crate::tier::Tier;

/// Where the ray meets the geometry, seen through a placement; in the ray's own `t`.
#[inline]
pub(crate) fn meet<S: Scalar, T: Tier<S>, G: Geometry<S>>(geometry: &G, local: &Local<S>) -> Meeting<S> {
    geometry.scaled(-local.exponent).meet::<T>(&local.line).map_t(|t| local.to_ray(t))
}

/// The ray as an unplaced geometry sees it.
#[inline]
pub(crate) fn unplaced<S: Scalar, G: Geometry<S>>(geometry: &G, ray: &Ray<S>) -> Local<S> {
    Local::in_world(ray, geometry.reach(), |origin| geometry.is_far(origin))
}

#[inline]
pub(crate) fn hits<S: Scalar, T: Tier<S>, G: Geometry<S>>(geometry: &G, ray: &Ray<S>) -> Hits<S> {
    meet::<S, T, G>(geometry, &unplaced(geometry, ray)).hits(ray.range())
}

#[inline]
pub(crate) fn nearest<S: Scalar, T: Tier<S>, G: Geometry<S>>(geometry: &G, ray: &Ray<S>) -> Option<Hit<S>> {
    meet::<S, T, G>(geometry, &unplaced(geometry, ray)).nearest(ray.range(), |_: Crossing| true)
}

/// True if there is a hit that `accept` takes. The signs of the coefficients are asked first.
#[inline]
pub(crate) fn occludes<S: Scalar, T: Tier<S>, G: Geometry<S>>(
    geometry: &G,
    ray: &Ray<S>,
    local: &Local<S>,
    accept: impl Fn(Crossing) -> bool,
) -> bool {
    let scaled = geometry.scaled(-local.exponent);
    if local.is_forward(ray) {
        match scaled.verdict::<T>(&local.line) {
            Some(false) => return false,
            // A yes speaks of the whole half-line and of both sides.
            Some(true)
                if ray.range().end() == S::BUDGET.distance && accept(Crossing::Enter) && accept(Crossing::Exit) =>
            {
                return true;
            }
            _ => {}
        }
    }
    scaled.meet::<T>(&local.line).map_t(|t| local.to_ray(t)).nearest(ray.range(), accept).is_some()
}
