//! Floor 5: the three questions, asked of any geometry in the world's frame or in a frame of its own.

use crate::geometry::Geometry;
use crate::hit::{Crossing, Hit, Hits};
use crate::line::Local;
use crate::ray::Ray;
use crate::scalar::{Scalar, largest};
use crate::span::Meeting;
use crate::tier::Tier;
use crate::vector::Vec3;

/// Where the ray meets the geometry, seen through a placement; in the ray's own `t`.
#[inline]
pub(crate) fn meet<S: Scalar, T: Tier<S>, G: Geometry<S>>(geometry: &G, local: &Local<S>) -> Meeting<S> {
    geometry.scaled(-local.exponent).meet::<T>(&local.line).map_t(|t| local.to_ray(t))
}

/// The geometry and a point of its frame, multiplied by the power of two that brings the larger of them near 1, so that
/// no square overflows; and its exponent. Fixed types need none.
#[inline]
pub(crate) fn near_one<S: Scalar, G: Geometry<S>>(geometry: &G, point: Vec3<S>) -> (G, Vec3<S>, i32) {
    let exponent = S::binary_exponent(largest([point.x, point.y, point.z, geometry.reach()]));
    (geometry.scaled(-exponent), scaled(point, -exponent), exponent)
}

/// The point times `2^e`.
#[inline]
pub(crate) fn scaled<S: Scalar>(point: Vec3<S>, e: i32) -> Vec3<S> {
    point.to_array().map(|component| component.scaled(e)).into()
}

/// True if the point of the geometry's frame belongs to it.
#[inline]
pub(crate) fn contains<S: Scalar, G: Geometry<S>>(geometry: &G, point: Vec3<S>) -> bool {
    let (geometry, point, _) = near_one(geometry, point);
    geometry.contains(point)
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

/// True if the number type surely holds the `t` of every end (rule 3: one that it does not hold is no hit): the solid is
/// bounded, lengths are those of the world, and line and solid lie within a quarter of the budget.
#[inline]
fn is_within_reach<S: Scalar, G: Geometry<S>>(geometry: &G, local: &Local<S>) -> bool {
    let [x, y, z] = local.line.origin.map(|component| component.scaled(local.exponent));
    let farthest = largest([x, y, z, geometry.reach()]);
    let twice = farthest.plus(farthest);
    let (low, high) = geometry.bounds();
    local.is_unstretched()
        && twice.plus(twice) <= S::BUDGET.size
        && low.to_array().iter().chain(&high.to_array()).all(|c| c.is_finite())
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
                if ray.range().end() == S::BUDGET.distance
                    && accept(Crossing::Enter)
                    && accept(Crossing::Exit)
                    && is_within_reach(geometry, local) =>
            {
                return true;
            }
            _ => {}
        }
    }
    scaled.meet::<T>(&local.line).map_t(|t| local.to_ray(t)).nearest(ray.range(), accept).is_some()
}

/// Gives a primitive the queries of an unplaced, two-sided shape as methods of its own.
macro_rules! queries {
    ($Primitive:ident) => {
        impl<S: Scalar> $Primitive<S> {
            /// All hits, sorted by `t`.
            pub fn hits(&self, ray: &crate::ray::Ray<S>) -> crate::hit::Hits<S> {
                self.hits_at::<crate::tier::Stable>(ray)
            }
            /// All hits, in a chosen accuracy tier.
            pub fn hits_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> crate::hit::Hits<S> {
                crate::query::hits::<S, T, _>(self, ray)
            }
            /// The hit with the smallest `t`.
            pub fn nearest(&self, ray: &crate::ray::Ray<S>) -> Option<crate::hit::Hit<S>> {
                self.nearest_at::<crate::tier::Stable>(ray)
            }
            /// The hit with the smallest `t`, in a chosen accuracy tier.
            pub fn nearest_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> Option<crate::hit::Hit<S>> {
                crate::query::nearest::<S, T, _>(self, ray)
            }
            /// True if there is any hit.
            pub fn occludes(&self, ray: &crate::ray::Ray<S>) -> bool {
                self.occludes_at::<crate::tier::Stable>(ray)
            }
            /// True if there is any hit, in a chosen accuracy tier.
            pub fn occludes_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> bool {
                crate::query::occludes::<S, T, _>(self, ray, &crate::query::unplaced(self, ray), |_| true)
            }
            /// True if the point belongs to the primitive: inside or on a solid, on an open surface.
            pub fn contains(&self, point: Vec3<S>) -> bool {
                crate::query::contains(self, point)
            }
            /// The box that holds it; infinite where the primitive is.
            pub fn bounds(&self) -> crate::geometry::Bounds<S> {
                let (low, high) = crate::geometry::Geometry::bounds(self);
                crate::geometry::Bounds { low, high }
            }
        }
    };
}
pub(crate) use queries;
