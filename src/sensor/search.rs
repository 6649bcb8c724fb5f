//! How one obstacle is searched: by a tier, or by the first numbers of a tier alone.

use crate::hit::{Crossing, Hit, Undecided};
use crate::ray::{Range, Ray};
use crate::scalar::Scalar;
use crate::shape::Shape;
use crate::shape::kinds::Kinds;
use crate::tier::Tier;
use core::marker::PhantomData;

mod sealed {
    pub trait Sealed<S> {}
}

/// A way to find the nearest hit of an obstacle: any [`Tier`], or [`Try`] of one. Sealed.
pub trait Search<S: Scalar>: sealed::Sealed<S> {
    #[doc(hidden)]
    /// True if the rounding of a hit next to the end of a range depends on that end.
    const EXACT_ENDS: bool;
    /// The nearest hit.
    ///
    /// # Errors
    ///
    /// [`Undecided`] if [`Try`] does not decide it; never of a tier.
    fn nearest<K: Kinds>(shape: &Shape<S, K>, ray: &Ray<S>) -> Result<Option<Hit<S>>, Undecided>;
}

impl<S: Scalar, T: Tier<S>> sealed::Sealed<S> for T {}

impl<S: Scalar, T: Tier<S>> Search<S> for T {
    const EXACT_ENDS: bool = T::EXACT_ENDS;

    #[inline(always)]
    fn nearest<K: Kinds>(shape: &Shape<S, K>, ray: &Ray<S>) -> Result<Option<Hit<S>>, Undecided> {
        Ok(shape.nearest_at::<T>(ray))
    }
}

/// The first numbers of a tier alone, as in [`Shape::try_nearest_at`]: for the least flash, and the least time of the
/// slowest ray. A ray that these do not decide gives [`Status::Undecided`](super::Status::Undecided).
#[derive(Clone, Copy, Debug)]
pub struct Try<T>(PhantomData<T>);

impl<S: Scalar, T: Tier<S>> sealed::Sealed<S> for Try<T> {}

impl<S: Scalar, T: Tier<S>> Search<S> for Try<T> {
    const EXACT_ENDS: bool = T::EXACT_ENDS;

    #[inline(always)]
    fn nearest<K: Kinds>(shape: &Shape<S, K>, ray: &Ray<S>) -> Result<Option<Hit<S>>, Undecided> {
        shape.try_nearest_at::<T>(ray)
    }
}

/// The first hit within the ray's range that is not the way out of a solid.
#[inline(always)]
pub(super) fn first_entry<S: Scalar, T: Search<S>, K: Kinds>(
    shape: &Shape<S, K>,
    ray: &Ray<S>,
) -> Result<Option<Hit<S>>, Undecided> {
    let (mut ray, end) = (*ray, ray.range().end());
    // Each step leaves an exit behind, and no line has many.
    loop {
        let Some(hit) = T::nearest(shape, &ray)? else { return Ok(None) };
        if hit.crossing != Crossing::Exit || !shape.is_solid() {
            return Ok(Some(hit));
        }
        let Ok(beyond) = Range::new(hit.t.next_up(), end) else { return Ok(None) };
        ray = ray.with_range(beyond);
    }
}
