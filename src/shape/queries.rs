//! The queries of a shape, each computed with the primitive and the placement in their own types.

use super::Visible;
use crate::geometry::Geometry;
use crate::hit::{Hit, Hits, Undecided};
use crate::ladder;
use crate::ladder::ExactScalar;
use crate::line::Place;
use crate::query;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::tier::{Precision, Tier};
use crate::vector::Vec3;
use core::marker::PhantomData;

/// What is done with a primitive in its own type.
pub(super) trait Visitor<S: Scalar> {
    type Answer;
    /// The answer for a primitive. It is one function for each primitive and placement.
    fn visit<G: Geometry<S>>(self, geometry: &G) -> Self::Answer;
    /// The answer for a primitive that is not among the kinds, which no shape has.
    fn none(self) -> Self::Answer;
}

/// The nearest hit.
pub(super) struct Nearest<'a, S: Scalar, T, P>(&'a P, &'a Ray<S>, Visible, PhantomData<T>);

impl<'a, S: Scalar, T, P> Nearest<'a, S, T, P> {
    #[inline(always)]
    pub(super) const fn new(place: &'a P, ray: &'a Ray<S>, visible: Visible) -> Self {
        Self(place, ray, visible, PhantomData)
    }
}

impl<S: Scalar, T: Tier<S>, P: Place<S>> Visitor<S> for Nearest<'_, S, T, P> {
    type Answer = Option<Hit<S>>;

    #[inline(always)]
    fn visit<G: Geometry<S>>(self, geometry: &G) -> Option<Hit<S>> {
        query::nearest::<S, T, G, P>(geometry, self.0, self.1, self.2.reported())
    }
    #[inline(always)]
    fn none(self) -> Option<Hit<S>> {
        None
    }
}

/// The nearest hit, if the first method decides it.
pub(super) struct TryNearest<'a, S: Scalar, T, P>(&'a P, &'a Ray<S>, Visible, PhantomData<T>);

impl<'a, S: Scalar, T, P> TryNearest<'a, S, T, P> {
    #[inline(always)]
    pub(super) const fn new(place: &'a P, ray: &'a Ray<S>, visible: Visible) -> Self {
        Self(place, ray, visible, PhantomData)
    }
}

impl<S: Scalar, T: Tier<S>, P: Place<S>> Visitor<S> for TryNearest<'_, S, T, P> {
    type Answer = Result<Option<Hit<S>>, Undecided>;

    #[inline(always)]
    fn visit<G: Geometry<S>>(self, geometry: &G) -> Self::Answer {
        query::try_nearest::<S, T, G, P>(geometry, self.0, self.1, self.2.reported())
    }
    #[inline(always)]
    fn none(self) -> Self::Answer {
        Ok(None)
    }
}

/// Whether there is a hit.
pub(super) struct Occludes<'a, S: Scalar, T, P>(&'a P, &'a Ray<S>, Visible, PhantomData<T>);

impl<'a, S: Scalar, T, P> Occludes<'a, S, T, P> {
    #[inline(always)]
    pub(super) const fn new(place: &'a P, ray: &'a Ray<S>, visible: Visible) -> Self {
        Self(place, ray, visible, PhantomData)
    }
}

impl<S: Scalar, T: Tier<S>, P: Place<S>> Visitor<S> for Occludes<'_, S, T, P> {
    type Answer = bool;

    #[inline(always)]
    fn visit<G: Geometry<S>>(self, geometry: &G) -> bool {
        query::occludes::<S, T, G, P>(geometry, self.0, self.1, self.2.reported())
    }
    #[inline(always)]
    fn none(self) -> bool {
        false
    }
}

/// All hits.
pub(super) struct AllHits<'a, S: Scalar, T, P>(&'a P, &'a Ray<S>, PhantomData<T>);

impl<'a, S: Scalar, T, P> AllHits<'a, S, T, P> {
    #[inline(always)]
    pub(super) const fn new(place: &'a P, ray: &'a Ray<S>) -> Self {
        Self(place, ray, PhantomData)
    }
}

impl<S: Scalar, T: Tier<S>, P: Place<S>> Visitor<S> for AllHits<'_, S, T, P> {
    type Answer = Hits<S>;

    #[inline(always)]
    fn visit<G: Geometry<S>>(self, geometry: &G) -> Hits<S> {
        query::hits::<S, T, G, P>(geometry, self.0, self.1)
    }
    #[inline(always)]
    fn none(self) -> Hits<S> {
        Hits::none()
    }
}

/// Whether a point belongs to it.
pub(super) struct Contains<'a, S: Scalar, T, P>(&'a P, Vec3<S>, PhantomData<T>);

impl<'a, S: Scalar, T, P> Contains<'a, S, T, P> {
    #[inline(always)]
    pub(super) const fn new(place: &'a P, point: Vec3<S>) -> Self {
        Self(place, point, PhantomData)
    }
}

impl<S: Scalar, T: Tier<S>, P: Place<S>> Visitor<S> for Contains<'_, S, T, P> {
    type Answer = bool;

    #[inline(always)]
    fn visit<G: Geometry<S>>(self, geometry: &G) -> bool {
        T::contains(geometry, self.0, self.1)
    }
    #[inline(always)]
    fn none(self) -> bool {
        false
    }
}

/// The precision that an exact result needs.
pub(super) struct NeededPrecision<'a, S: Scalar, P> {
    pub(super) place: &'a P,
    pub(super) ray: &'a Ray<S>,
}

impl<S: ExactScalar, P: Place<S>> Visitor<S> for NeededPrecision<'_, S, P> {
    type Answer = Precision;

    #[inline(always)]
    fn visit<G: Geometry<S>>(self, geometry: &G) -> Precision {
        ladder::precision(geometry, self.place, self.ray)
    }
    #[inline(always)]
    fn none(self) -> Precision {
        Precision::Filter
    }
}
