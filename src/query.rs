//! Floor 5: the questions, asked of any geometry through any placement, as each tier answers them.

use crate::arithmetic::{Arithmetic, Doubled};
use crate::exact::{self, Effort, Exact};
use crate::geometry::Geometry;
use crate::hit::{Crossing, Hit, Hits};
use crate::line::{Local, Place};
use crate::ray::{Range, Ray};
use crate::scalar::certain::Certain;
use crate::scalar::{Plain, Scalar, largest};
use crate::span::Meeting;
use crate::vector::Vec3;

/// How a tier answers the questions.
pub trait Solve<S: Scalar> {
    /// All hits.
    fn hits<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Hits<S>;
    /// The first hit that `accept` takes.
    fn nearest<G: Geometry<S>>(
        geometry: &G,
        place: &impl Place<S>,
        ray: &Ray<S>,
        accept: impl Fn(Crossing) -> bool,
    ) -> Option<Hit<S>>;
    /// True if there is a hit that `accept` takes.
    fn occludes<G: Geometry<S>>(
        geometry: &G,
        place: &impl Place<S>,
        ray: &Ray<S>,
        accept: impl Fn(Crossing) -> bool,
    ) -> bool;
    /// True if the point belongs to the geometry.
    fn contains<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, point: Vec3<S>) -> bool;
}

/// Tiers that compute in rounded numbers.
impl<S: Scalar, T: Arithmetic<S>> Solve<S> for T {
    #[inline]
    fn hits<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Hits<S> {
        match meet_plainly::<S, T, G>(geometry, place, ray) {
            Plain::Miss => Hits::none(),
            Plain::Found(meeting) => meeting.hits(ray.range()),
            Plain::Unclear => apart::<S, T, _>(|| meet::<S, T, G>(geometry, place, ray).hits(ray.range())),
        }
    }

    #[inline]
    fn nearest<G: Geometry<S>>(
        geometry: &G,
        place: &impl Place<S>,
        ray: &Ray<S>,
        accept: impl Fn(Crossing) -> bool,
    ) -> Option<Hit<S>> {
        match meet_plainly::<S, T, G>(geometry, place, ray) {
            Plain::Miss => None,
            Plain::Found(meeting) => meeting.nearest(ray.range(), accept),
            Plain::Unclear => apart::<S, T, _>(|| meet::<S, T, G>(geometry, place, ray).nearest(ray.range(), accept)),
        }
    }

    #[inline]
    fn occludes<G: Geometry<S>>(
        geometry: &G,
        place: &impl Place<S>,
        ray: &Ray<S>,
        accept: impl Fn(Crossing) -> bool,
    ) -> bool {
        if ray.range() == Range::FORWARD && accept(Crossing::Enter) && accept(Crossing::Exit) {
            match meets_ahead_plainly::<S, T, G>(geometry, place, ray) {
                Plain::Miss => return false,
                Plain::Found(()) => return true,
                Plain::Unclear => {}
            }
        }
        // What the signs leave open is decided as for the nearest hit.
        apart::<S, T, _>(|| match meet_plainly::<S, T, G>(geometry, place, ray) {
            Plain::Miss => false,
            Plain::Found(meeting) => meeting.nearest(ray.range(), accept).is_some(),
            Plain::Unclear => occludes::<S, T, G>(geometry, place, ray, accept),
        })
    }

    fn contains<G: Geometry<S>>(geometry: &G, place: &impl Place<S>, point: Vec3<S>) -> bool {
        let (geometry, point, _) = near_one(geometry, place.to_local(point));
        geometry.contains(point)
    }
}

/// The tier that decides by certain signs. (For each of its types: an impl for all of them together would overlap.)
macro_rules! solve_exactly {
    ($S:ty $(, $F:ident: $Bits:path)?) => {
        impl$(<$F: $Bits + Send + Sync + 'static>)? Solve<$S> for Exact {
            #[inline]
            fn hits<G: Geometry<$S>>(geometry: &G, place: &impl Place<$S>, ray: &Ray<$S>) -> Hits<$S> {
                if ray.departure().is_some() {
                    return meet::<$S, Doubled, G>(geometry, place, ray).hits(ray.range());
                }
                exact::hits(&geometry.figure(), place, ray)
            }

            #[inline]
            fn nearest<G: Geometry<$S>>(
                geometry: &G,
                place: &impl Place<$S>,
                ray: &Ray<$S>,
                accept: impl Fn(Crossing) -> bool,
            ) -> Option<Hit<$S>> {
                if ray.departure().is_some() {
                    return meet::<$S, Doubled, G>(geometry, place, ray).nearest(ray.range(), accept);
                }
                exact::nearest(&geometry.figure(), place, ray, accept)
            }

            #[inline]
            fn occludes<G: Geometry<$S>>(
                geometry: &G,
                place: &impl Place<$S>,
                ray: &Ray<$S>,
                accept: impl Fn(Crossing) -> bool,
            ) -> bool {
                Self::nearest(geometry, place, ray, accept).is_some()
            }

            fn contains<G: Geometry<$S>>(geometry: &G, place: &impl Place<$S>, point: Vec3<$S>) -> bool {
                exact::contains(&geometry.figure(), place, point)
            }
        }
    };
}
solve_exactly!(f32);
#[cfg(feature = "fixed")]
solve_exactly!(fixed::FixedI32<F>, F: fixed::types::extra::LeEqU32);

/// What an exact answer takes.
pub(crate) fn effort<S: Certain, G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Effort {
    if ray.departure().is_some() {
        return Effort::Filter;
    }
    exact::effort(&geometry.figure(), place, ray)
}

#[inline]
fn localize<S: Scalar, T: Arithmetic<S>, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Option<Local<S>> {
    place.localize(ray, geometry.reach(), |origin| T::COMPENSATES && geometry.is_far(origin))
}

/// Where the ray meets the geometry, if the short way tells.
#[inline(always)]
fn meet_plainly<S: Scalar, T: Arithmetic<S>, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Plain<Meeting<S>> {
    if !T::PLAIN || ray.departure().is_some() {
        return Plain::Unclear;
    }
    let Some(line) = place.plain_line(ray) else { return Plain::Unclear };
    geometry.meet_plainly::<T>(&line)
}

/// Whether the ray meets the geometry, if the short way tells.
#[inline(always)]
fn meets_ahead_plainly<S: Scalar, T: Arithmetic<S>, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Plain<()> {
    if !T::PLAIN || ray.departure().is_some() {
        return Plain::Unclear;
    }
    let Some(line) = place.plain_line(ray) else { return Plain::Unclear };
    geometry.meets_ahead_plainly::<T>(&line)
}

/// Whether the ray meets the geometry: the signs of the coefficients are asked first.
#[inline]
fn occludes<S: Scalar, T: Arithmetic<S>, G: Geometry<S>>(
    geometry: &G,
    place: &impl Place<S>,
    ray: &Ray<S>,
    accept: impl Fn(Crossing) -> bool,
) -> bool {
    let Some(local) = localize::<S, T, G>(geometry, place, ray) else {
        return false;
    };
    let scaled = geometry.scaled(-local.exponent);
    if local.is_forward(ray) {
        match scaled.verdict::<T>(&local.line) {
            Some(false) => return false,
            // A yes speaks of the whole half-line and of both sides.
            Some(true)
                if ray.range().end() == S::BUDGET.distance
                    && accept(Crossing::Enter)
                    && accept(Crossing::Exit)
                    && is_within_reach(geometry, &local) =>
            {
                return true;
            }
            _ => {}
        }
    }
    scaled.meet::<T>(&local.line).map_t(|t| local.to_ray(t)).nearest(ray.range(), accept).is_some()
}

/// The work itself where it is all there is; where a short way went before it, apart from that, so that it stays short.
#[inline(always)]
fn apart<S: Scalar, T: Arithmetic<S>, A>(work: impl FnOnce() -> A) -> A {
    #[cold]
    #[inline(never)]
    fn far<A>(work: impl FnOnce() -> A) -> A {
        work()
    }
    if T::PLAIN { far(work) } else { work() }
}

/// Where the ray meets the geometry, seen through a placement; in the ray's own `t`.
#[inline]
fn meet<S: Scalar, T: Arithmetic<S>, G: Geometry<S>>(geometry: &G, place: &impl Place<S>, ray: &Ray<S>) -> Meeting<S> {
    localize::<S, T, G>(geometry, place, ray).map_or(Meeting::Miss, |local| {
        geometry.scaled(-local.exponent).meet::<T>(&local.line).map_t(|t| local.to_ray(t))
    })
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

/// True if the number type surely holds the `t` of every end (rule 3: one that it does not hold is no hit): the solid is
/// bounded, lengths are those of the world, and line and solid lie within a quarter of the budget.
#[inline]
fn is_within_reach<S: Scalar, G: Geometry<S>>(geometry: &G, local: &Local<S>) -> bool {
    let [x, y, z] =
        local.line.origin.map(|component| component.in_finer_units(-local.line.finer).scaled(local.exponent));
    let farthest = largest([x, y, z, geometry.reach()]);
    let twice = farthest.plus(farthest);
    let (low, high) = geometry.bounds();
    local.is_unstretched()
        && twice.plus(twice) <= S::BUDGET.size
        && low.to_array().iter().chain(&high.to_array()).all(|c| c.is_finite())
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
                T::hits(self, &crate::line::InWorld, ray)
            }
            /// The hit with the smallest `t`.
            pub fn nearest(&self, ray: &crate::ray::Ray<S>) -> Option<crate::hit::Hit<S>> {
                self.nearest_at::<crate::tier::Stable>(ray)
            }
            /// The hit with the smallest `t`, in a chosen accuracy tier.
            pub fn nearest_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> Option<crate::hit::Hit<S>> {
                T::nearest(self, &crate::line::InWorld, ray, |_| true)
            }
            /// True if there is any hit.
            pub fn occludes(&self, ray: &crate::ray::Ray<S>) -> bool {
                self.occludes_at::<crate::tier::Stable>(ray)
            }
            /// True if there is any hit, in a chosen accuracy tier.
            pub fn occludes_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> bool {
                T::occludes(self, &crate::line::InWorld, ray, |_| true)
            }
            /// True if the point belongs to the primitive: inside or on a solid, on an open surface.
            pub fn contains(&self, point: Vec3<S>) -> bool {
                self.contains_at::<crate::tier::Stable>(point)
            }
            /// True if the point belongs to the primitive, in a chosen accuracy tier.
            pub fn contains_at<T: crate::tier::Tier<S>>(&self, point: Vec3<S>) -> bool {
                T::contains(self, &crate::line::InWorld, point)
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
