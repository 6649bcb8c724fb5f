//! Which numbers each tier computes in.
//!
//! A tier is a list of methods. A method is unsure where its numbers do not know a sign, since rounding may have
//! decided it; then the next one repeats the query. "In the world" means not placed; "the grid" is that of
//! `scalar::integers`; "blocks" are integers that each have an exponent.
//!
//! | tier | floats | fixed point |
//! |---|---|---|
//! | `Plain` | plain values | the grid of integers, blocks |
//! | `Fast` | plain values with guards, the robust number | the grid, the robust number |
//! | `Stable` | values with an error bound, the same of a line in double-words, the robust number | the grid, that of the wider type, the robust number |
//! | `Exact` | doubles with an error bound, [`Bounded`](crate::number::Bounded), [`Integer`](crate::number::Integer) | the grid with certain signs, then as floats |

mod exactly;
#[cfg(feature = "fixed")]
mod grid;

pub use exactly::ExactScalar;
pub(crate) use exactly::precision;
#[cfg(feature = "fixed")]
pub use grid::FixedPoint;

use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Geometry;
use crate::intersection::Intersection;
use crate::line::{Needs, Place};
use crate::number::{Guarded, Plain as PlainNumber, Running};
use crate::part::Part;
use crate::query::{Crossed, Solve};
use crate::ray::{Leaving, Ray};
use crate::scalar::{FromScalar, RealOf, Scalar};
use crate::solve::{self, Attempt, Goal, Line, LocalRay, Localize, Of, Stop};
use crate::tier::{Fast, Plain, Stable};
use crate::vector::Vec3;
use core::cmp::Ordering;
use core::marker::PhantomData;

/// A way to compute where a ray meets a geometry.
pub trait Method<S: Scalar> {
    /// The intersection of a ray without departure, inlined into the query. If `since` is given, only the first end at
    /// or after it is needed. Only the first method of a list is called so; the others need only [`Method::all`].
    #[inline(always)]
    fn nearest<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        _since: Option<S>,
    ) -> Attempt<Intersection<S>> {
        Self::all(geometry, place, ray)
    }
    /// The intersection of any ray, by a call of a function that all placements share.
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>>;
    /// [`Solve::ahead`].
    #[inline(always)]
    fn ahead<G: Geometry<S>, P: Place<S>>(_: &G, _: &P, _: &Ray<S>) -> Attempt<()> {
        Err(Stop::Unsure)
    }
}

/// A list of methods.
pub trait Methods<S: Scalar> {
    /// The first of them.
    type First: Method<S>;
    /// The others, in turn.
    fn others<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>>;
}

impl<S: Scalar, A: Method<S>> Methods<S> for (A,) {
    type First = A;

    #[inline(always)]
    fn others<G: Geometry<S>, P: Place<S>>(_: &G, _: &P, _: &Ray<S>) -> Attempt<Intersection<S>> {
        Err(Stop::Unsure)
    }
}

impl<S: Scalar, A: Method<S>, B: Method<S>> Methods<S> for (A, B) {
    type First = A;

    #[inline(always)]
    fn others<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        whole(B::all(geometry, place, ray))
    }
}

impl<S: Scalar, A: Method<S>, B: Method<S>, C: Method<S>> Methods<S> for (A, B, C) {
    type First = A;

    #[inline(always)]
    fn others<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        match whole(B::all(geometry, place, ray)) {
            Err(Stop::Unsure) => <(B, C)>::others(geometry, place, ray),
            found => found,
        }
    }
}

/// The intersection, if both ends of its interval are known: an entry alone is `Unsure`.
#[inline(always)]
pub(super) fn whole<S>(found: Attempt<Intersection<S>>) -> Attempt<Intersection<S>> {
    if let Ok(Intersection::Entered(_)) = found { Err(Stop::Unsure) } else { found }
}

/// The lists of the tiers that every number type has, for floats or for fixed point.
pub trait Tiers<S: Scalar> {
    /// The number in which [`Plain`](crate::tier::Plain) decides whether a point is inside.
    type PlainNumber: Of<S>;
    /// Of [`Plain`](crate::tier::Plain).
    type Plain: Methods<S>;
    /// Of [`Fast`](crate::tier::Fast).
    type Fast: Methods<S>;
    /// Of [`Stable`](crate::tier::Stable).
    type Stable: Methods<S>;
}

/// The tiers of floats.
#[derive(Clone, Copy, Debug)]
pub struct Floats;

impl<S: Scalar + RealOf<S>> Tiers<S> for Floats {
    type PlainNumber = PlainNumber<S>;
    type Plain = (In<PlainNumber<S>>,);
    type Fast = (InBounds<S, false>, In<S::Robust>);
    type Stable = (InBounds<S, true>, InDoubled<S>, In<S::Robust>);
}

/// The method that computes in numbers of the type `N`.
#[derive(Clone, Copy, Debug)]
pub struct In<N>(PhantomData<N>);

impl<S: Scalar, N: Localize<S>> Method<S> for In<N> {
    #[inline(always)]
    fn nearest<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> Attempt<Intersection<S>> {
        let local = N::local_ray(place, ray, G::NEEDS, None);
        let goal = Goal { range: ray.range(), since };
        // An affine map takes so long that a call adds little, and a program has less code with it.
        if P::STRETCHES { intersect(geometry, &local, goal) } else { geometry.intersect(&local, goal) }
    }
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        if !N::DEPARTS && ray.departure().is_some() {
            return Err(Stop::Unsure);
        }
        let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
        let local = if N::IS_WIDE {
            transformed::<S, N, P>(place, ray, G::NEEDS, departure)
        } else {
            N::local_ray(place, ray, G::NEEDS, departure)
        };
        intersect(geometry, &local, Goal { range: ray.range(), since: None })
    }
}

/// The ray in the frame, in a number that is seldom needed: one function for all geometries, not inlined.
#[inline(never)]
fn transformed<S: Scalar, N: Localize<S>, P: Place<S>>(
    place: &P,
    ray: &Ray<S>,
    needs: Needs,
    departure: Option<(Part, Leaving)>,
) -> LocalRay<N> {
    N::local_ray(place, ray, needs, departure)
}

/// The same, in double-words.
#[inline(never)]
fn rounded<S: Scalar + RealOf<S>, P: Place<S>>(
    place: &P,
    ray: &Ray<S>,
    needs: Needs,
    departure: Option<(Part, Leaving)>,
) -> LocalRay<Running<S>> {
    solve::rounded_ray::<S, S, P>(place, ray, needs, departure)
}

/// The intersection: one function for all placements, not inlined.
#[inline(never)]
fn intersect<S: Scalar, N: Of<S>, G: Geometry<S>>(
    geometry: &G,
    ray: &LocalRay<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    geometry.intersect(ray, goal)
}

/// The method that computes in values whose error bounds are constant ([`Guarded`]) where that is enough, and otherwise
/// in values with running bounds ([`Running`]).
///
/// The constant bounds of `Stable` are enough for short formulas ([`Geometry::HAS_CONSTANT_BOUNDS`]) and for flat parts
/// in the world, those of `Fast` for all. (Without an FPU a cuboid in the world takes a third of the instructions of
/// running bounds.) Neither is enough in an affine map: with a stretch of 30 a difference that passes these bounds may
/// have lost its digits, and hits with chords of 20 to 400 units in the last place were lost.
#[derive(Clone, Copy, Debug)]
pub struct InBounds<R, const STABLE: bool>(PhantomData<R>);

impl<R, const STABLE: bool> InBounds<R, STABLE> {
    const fn are_constant<S: Scalar, G: Geometry<S>, P: Place<S>>() -> bool {
        let is_flat = matches!(G::NEEDS, Needs::Flat | Needs::Height);
        !P::STRETCHES && !G::HAS_LONG_FORMULAS && (G::HAS_CONSTANT_BOUNDS || !STABLE || is_flat && P::IS_WORLD)
    }
}

impl<S: Scalar + RealOf<S>, const STABLE: bool> Method<S> for InBounds<S, STABLE> {
    #[inline(always)]
    fn nearest<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> Attempt<Intersection<S>> {
        if Self::are_constant::<S, G, P>() {
            In::<Guarded<S, STABLE>>::nearest(geometry, place, ray, since)
        } else {
            In::<Running<S, STABLE>>::nearest(geometry, place, ray, since)
        }
    }
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        // The `t` of an exit next to the start is accurate only if the line is: of 191 exits from turned capsules this
        // method decided 35, and the next one, whose line is transformed in double-words, 158.
        if STABLE && ray.departure().is_some() && matches!(G::NEEDS, Needs::All | Needs::Flat) {
            return Err(Stop::Unsure);
        }
        // A departing ray may leave along a generator, where nothing in its equation has a constant bound: hits of open
        // cones were lost.
        if Self::are_constant::<S, G, P>() && ray.departure().is_none() {
            In::<Guarded<S, STABLE>>::all(geometry, place, ray)
        } else {
            In::<Running<S, STABLE>>::all(geometry, place, ray)
        }
    }
}

/// The method that computes in values with a running bound, for a line that is transformed in double-words and then
/// rounded.
///
/// The transformation causes most of the error of a line: of the rays near a turned capsule the first method is unsure
/// for 7 %, and this one for 1 %. It calls the same functions as [`InBounds`] in [`Running`], so that it adds no code
/// for a solid.
#[derive(Clone, Copy, Debug)]
pub struct InDoubled<R>(PhantomData<R>);

impl<S: Scalar + RealOf<S>> Method<S> for InDoubled<S> {
    #[inline(always)]
    fn all<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        let departure = ray.departure().map(|departure| (departure.part, departure.leaving));
        let local = rounded::<S, P>(place, ray, G::NEEDS, departure);
        intersect(geometry, &local, Goal { range: ray.range(), since: None })
    }
}

/// A tier as a list of methods.
pub trait Listed<S: Scalar> {
    /// The list.
    type Methods: Methods<S>;
    /// The number that decides whether a point is inside.
    type Point: Of<S>;
    /// True if the exact `t` of an end, not the rounded one, decides whether it lies in the ray's range.
    const EXACT_ENDS: bool = false;
    /// [`Solve::SHADES_ROUGHLY`].
    const SHADES_ROUGHLY: bool = false;
    /// [`Solve::order`].
    #[inline(always)]
    fn order(_: &impl Crossed<S>, _: &impl Crossed<S>) -> Option<Ordering> {
        None
    }
    /// The inside test; the number of [`Listed::Point`] decides it.
    fn contains<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, point: Vec3<S>) -> bool {
        holds::<S, Self::Point, G>(&geometry.equations(), place, point).unwrap_or(false)
    }
}

impl<S: Scalar> Listed<S> for Plain {
    type Methods = <S::Tiers as Tiers<S>>::Plain;
    type Point = <S::Tiers as Tiers<S>>::PlainNumber;
    const SHADES_ROUGHLY: bool = true;
}

impl<S: Scalar> Listed<S> for Fast {
    type Methods = <S::Tiers as Tiers<S>>::Fast;
    type Point = S::Robust;
    const SHADES_ROUGHLY: bool = true;
}

impl<S: Scalar> Listed<S> for Stable {
    type Methods = <S::Tiers as Tiers<S>>::Stable;
    type Point = S::Robust;
}

impl<S: Scalar, T: Listed<S>> Solve<S> for T {
    const EXACT_ENDS: bool = <T as Listed<S>>::EXACT_ENDS;
    const SHADES_ROUGHLY: bool = <T as Listed<S>>::SHADES_ROUGHLY;

    #[inline(always)]
    fn first<G: Geometry<S>, P: Place<S>>(
        geometry: &G,
        place: &P,
        ray: &Ray<S>,
        since: Option<S>,
    ) -> Attempt<Intersection<S>> {
        // The grid of fixed point tests this itself.
        if S::RELATIVE && passes(geometry, place, ray) {
            return Err(Stop::Miss);
        }
        <T::Methods as Methods<S>>::First::nearest(geometry, place, ray, since)
    }
    #[inline(always)]
    fn all_by_first<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<Intersection<S>> {
        if S::RELATIVE && ray.departure().is_none() && passes(geometry, place, ray) {
            return Err(Stop::Miss);
        }
        <T::Methods as Methods<S>>::First::all(geometry, place, ray)
    }
    #[inline(always)]
    fn others<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Intersection<S> {
        <T::Methods as Methods<S>>::others(geometry, place, ray).unwrap_or(Intersection::Miss)
    }
    #[inline(always)]
    fn ahead<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> Attempt<()> {
        <T::Methods as Methods<S>>::First::ahead(geometry, place, ray)
    }
    #[inline(always)]
    fn order(a: &impl Crossed<S>, b: &impl Crossed<S>) -> Option<Ordering> {
        <T as Listed<S>>::order(a, b)
    }
    fn contains<G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, point: Vec3<S>) -> bool {
        <T as Listed<S>>::contains(geometry, place, point)
    }
}

/// True if the line certainly misses a geometry about the y axis, since its distance from the axis is larger than the
/// geometry's radius. That decides most tests of a picture or a range sensor: in `Stable` a sensor's test in `f32`
/// takes 192 instead of 406 instructions on a host on average, and one that hits takes some 40 more.
#[inline(always)]
fn passes<S: Scalar, G: Geometry<S>, P: Place<S>>(geometry: &G, place: &P, ray: &Ray<S>) -> bool {
    geometry.radius_about_axis().is_some_and(|r| place.passes_axis(ray, r))
}

/// The ray's line in the primitive's frame.
#[inline]
pub(crate) fn line<S: Scalar, N: FromScalar<S>, G: Described>(
    equations: &Equations<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
) -> Line<N> {
    let [origin, direction] = if is_ball::<S, G>(equations) { place.ball_line::<N>(ray) } else { place.line::<N>(ray) };
    Line { origin, direction }
}

/// The inside test, computed in numbers of the type `N`; `None` if they do not know a sign.
fn holds<S: Scalar, N: Of<S>, G: Described>(
    equations: &Equations<S>,
    place: &impl Place<S>,
    point: Vec3<S>,
) -> Option<bool> {
    debug_assert!(G::EQUATIONS.has(equations.kind()));
    let point = if is_ball::<S, G>(equations) { place.ball_point::<N>(point) } else { place.point::<N>(point) };
    solve::holds::<S, N, G>(equations, point)
}

/// True for a ball; a constant for a geometry that has none.
#[inline(always)]
pub(crate) const fn is_ball<S, G: Described>(equations: &Equations<S>) -> bool {
    G::EQUATIONS.has(EquationKinds::BALL) && matches!(equations, Equations::Ball { .. })
}

#[cfg(units)]
#[path = "../tests/units/ladder.rs"]
mod tests;
