//! The methods of the tier `Exact`.
//!
//! Fixed point begins on the grid of its own integers, with guards that only certain results pass. Floats begin in
//! doubles with an error bound, which is the second step of fixed point. Rays that these cannot decide are computed in
//! wider and wider numbers, until every sign is certain.

use super::grid::OnGrid;
use super::{In, Listed, Method, holds, whole};
use crate::exact::{Exact, ExactScalar, Precision};
use crate::fast::Guards;
use crate::geometry::Geometry;
use crate::intersection::Intersection;
use crate::line::Place;
use crate::number::{Filtered, Running};
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::solve::{Attempt, Stop};
use crate::vector::Vec3;

impl<S: ExactScalar> Listed<S> for Exact {
    const EXACT_ENDS: bool = true;
    type Methods = (Certain, In<S::Bounded>, In<S::Integer>);
    type Point = S::Integer;
    type Guards = Certainly;

    /// The grid does not know whether an end is certainly in the half-line; its intersection is tested for that.
    #[inline(always)]
    fn ahead<G: Geometry<S>, P: Place<S>>(_: &G, _: &P, _: &Ray<S>) -> Attempt<()> {
        Err(Stop::Unsure)
    }

    fn contains<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, point: Vec3<S>) -> bool {
        let equations = geometry.equations();
        holds::<S, Filtered, G>(&equations, place, point)
            .or_else(|| holds::<S, S::Bounded, G>(&equations, place, point))
            .or_else(|| holds::<S, S::Integer, G>(&equations, place, point))
            .unwrap_or(false)
    }
}

/// On the grid of the type's own integers, if it has one, and where that is unsure in doubles; of both by certain
/// signs.
#[derive(Clone, Copy, Debug)]
pub struct Certain;

impl<S: ExactScalar> Method<S> for Certain {
    #[inline(always)]
    fn nearest<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> Attempt<Intersection<S>> {
        if !starts_in_doubles::<S, P>() {
            return Self::all(geometry, place, ray);
        }
        if G::HAS_FEW_FACTORS && !P::STRETCHES {
            In::<Filtered>::nearest(geometry, place, ray, since)
        } else {
            In::<Running<f64>>::nearest(geometry, place, ray, since)
        }
    }
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        if !starts_in_doubles::<S, P>() {
            match on_the_grid(geometry, place, ray) {
                Err(Stop::Unsure) => {}
                found => return found,
            }
        }
        // The magnitudes of terms bound the errors where these have few factors, otherwise a running bound.
        if G::HAS_FEW_FACTORS && !P::STRETCHES && ray.departure().is_none() {
            In::<Filtered>::all(geometry, place, ray)
        } else {
            In::<Running<f64>>::all(geometry, place, ray)
        }
    }
}

/// True if `Exact` begins in doubles, and not on the grid of the type's own integers: for floats, and for affine
/// placements, for which uncertain decisions may pass the guards of integers.
#[inline(always)]
const fn starts_in_doubles<S: Scalar, P: Place<S>>() -> bool {
    S::RELATIVE || P::STRETCHES
}

/// The precision that an exact result needs.
pub(crate) fn precision<S: ExactScalar, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Precision {
    let is_decided = |found: Attempt<Intersection<S>>| !matches!(whole(found), Err(Stop::Unsure));
    let is_filtered =
        is_decided(Certain::all(geometry, place, ray)) || is_decided(In::<S::Bounded>::all(geometry, place, ray));
    if is_filtered { Precision::Filter } else { Precision::Integers }
}

/// The guards of the grid of `Exact`.
#[derive(Clone, Copy, Debug)]
pub struct Certainly;

impl Guards for Certainly {
    const GUARDED: bool = true;
    const STRICT: bool = true;
}

/// On the grid of the type's own integers, by certain signs.
#[inline(always)]
fn on_the_grid<S: Scalar, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Attempt<Intersection<S>> {
    let intersection = whole(OnGrid::<Certainly>::all(geometry, place, ray))?;
    let (start, end) = (ray.range().start(), ray.range().end());
    // The rounding of `t` must decide neither the order of an end and an end of the range, nor whether an exit is ahead
    // of the surface that the ray departs from. A missing end is infinite.
    let is_certain = |t: S| {
        let is_doubtful = |bound: S| S::are_doubtful(t, bound);
        !t.is_finite()
            || !(is_doubtful(start) || is_doubtful(end) || (ray.departure().is_some() && is_doubtful(S::ZERO)))
    };
    intersection.try_map(|t| is_certain(t).then_some(t)).ok_or(Stop::Unsure)
}
