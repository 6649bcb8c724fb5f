//! The methods of the tier `Exact`.
//!
//! Fixed point begins on the grid of its own integers, with guards that only certain results pass. Floats begin in
//! doubles with an error bound, which is the second step of fixed point. Rays that these cannot decide are computed in
//! wider and wider numbers, until every sign is certain.

use super::{In, Listed, Method, holds, whole};
use crate::exact::{Exact, Precision};
use crate::geometry::Geometry;
use crate::intersection::Intersection;
use crate::line::Place;
#[cfg(feature = "libm")]
use crate::number::{Bounded, FLOAT_LIMBS, Integer};
use crate::number::{Filtered, Running};
use crate::query::Crossed;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::solve::{Attempt, Localize, Of, Stop};
use crate::vector::Vec3;
use core::cmp::Ordering;

/// A scalar that has an exact tier: `f32` and every `FixedI32<F>`. Sealed.
pub trait ExactScalar: Scalar {
    // What is hidden is for the solvers.
    #[doc(hidden)]
    /// The first attempt, whose results are certain.
    type First: Method<Self>;
    #[doc(hidden)]
    /// The number that is used where a sign is unknown in doubles.
    type Bounded: Localize<Self>;
    #[doc(hidden)]
    /// The integer that is used where a sign is unknown in [`ExactScalar::Bounded`]. It is wide enough for every
    /// polynomial of the solvers.
    type Integer: Localize<Self>;
    /// The integer that compares roots of two solids: some 2.5 times as long.
    type Order: Of<Self>;
}

#[cfg(feature = "libm")]
impl ExactScalar for f32 {
    type First = InDoubles;
    type Bounded = Bounded<u128>;
    type Integer = Integer<FLOAT_LIMBS>;
    type Order = Integer<{ FLOAT_LIMBS / 2 * 5 }>;
}

impl<S: ExactScalar> Listed<S> for Exact {
    const EXACT_ENDS: bool = true;
    type Methods = (S::First, In<S::Bounded>, In<S::Integer>);
    type Point = S::Integer;

    fn order(a: &impl Crossed<S>, b: &impl Crossed<S>) -> Option<Ordering> {
        compared::<S, S::Bounded>(a, b).or_else(|| compared::<S, S::Order>(a, b))
    }
    fn contains<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, point: Vec3<S>) -> bool {
        let equations = geometry.equations();
        holds::<S, Filtered, G>(&equations, place, point)
            .or_else(|| holds::<S, S::Bounded, G>(&equations, place, point))
            .or_else(|| holds::<S, S::Integer, G>(&equations, place, point))
            .unwrap_or(false)
    }
}

/// How two crossings compare, in numbers of the type `N`.
#[inline(never)]
fn compared<S: ExactScalar, N: Of<S>>(a: &impl Crossed<S>, b: &impl Crossed<S>) -> Option<Ordering> {
    a.root::<N>()?.order(&b.root::<N>()?)
}

/// In doubles with an error bound: that of the magnitudes of terms where these have few factors, otherwise a running
/// one.
#[derive(Clone, Copy, Debug)]
pub struct InDoubles;

impl<S: ExactScalar> Method<S> for InDoubles {
    #[inline(always)]
    fn nearest<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> Attempt<Intersection<S>> {
        if G::HAS_FEW_FACTORS && !P::STRETCHES {
            In::<Filtered>::nearest(geometry, place, ray, since)
        } else {
            In::<Running<f64>>::nearest(geometry, place, ray, since)
        }
    }
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        if G::HAS_FEW_FACTORS && !P::STRETCHES && ray.departure().is_none() {
            In::<Filtered>::all(geometry, place, ray)
        } else {
            In::<Running<f64>>::all(geometry, place, ray)
        }
    }
}

/// The precision that an exact result needs.
pub(crate) fn precision<S: ExactScalar, G: Geometry<S>, P: Place<S>>(
    geometry: &G,
    place: &P,
    ray: &Ray<S>,
) -> Precision {
    let is_decided = |found: Attempt<Intersection<S>>| !matches!(whole(found), Err(Stop::Unsure));
    let is_filtered =
        is_decided(S::First::all(geometry, place, ray)) || is_decided(In::<S::Bounded>::all(geometry, place, ray));
    if is_filtered { Precision::Filter } else { Precision::Integers }
}
