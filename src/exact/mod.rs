//! Floor 4: the exact tier's solver.
//!
//! One algorithm, in two kinds of numbers. It asks for signs only; a *filter*, a number of twice the precision that knows
//! how far it may be off, answers nearly always. Where it cannot tell, the same algorithm runs again in integers wide
//! enough for everything, and those can always tell. This is how exact geometric predicates are made (Shewchuk, *Adaptive
//! Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*, 1997; Fortune and Van Wyk, *Static Analysis
//! Yields Efficient Exact Integer Arithmetic for Computational Geometry*, 1996), applied to the whole query instead of one
//! determinant.
//!
//! | room | what it holds |
//! |---|---|
//! | `plain` | the usual ray of `f32`, in plain doubles |
//! | `form` | the line, and the quadrics as bilinear forms |
//! | `solve` | a quadric along the line; the order of its roots and of planes; ends and the ray's range |
//! | `round` | balls, sides, caps, cones, capsules |
//! | `flat` | planes, discs, triangles |
//! | `found` | what was found, as hits |
//! | `contains` | the inside test |

mod contains;
mod flat;
mod form;
mod found;
#[cfg(feature = "libm")]
mod plain;
mod round;
mod solve;

use crate::figure::Figure;
use crate::hit::{Crossing, Hit, Hits};
use crate::line::Place;
use crate::ray::Ray;
use crate::scalar::certain::Certain;
use crate::vector::Vec3;
use form::Line;
use found::Found;
use solve::Of;

/// The tier that is never wrong: hit, miss, touch, part, order, pairing and inside or outside are those of exact
/// arithmetic on the given numbers, always; `t` is within one unit in the last place of the exact value.
///
/// The given numbers are those that ray, primitive and placement *store*. A placed solid is one whose frame or
/// affine inverse is taken at its word, to the last bit.
///
/// Exists for `f32` and for every `FixedI32<F>`. For `f64` and the 64-bit fixed types it does not compile rather than
/// promise less:
///
/// ```compile_fail
/// use raylet::{Ray, Sphere, UnitVec3, Vec3, tier::Exact};
/// let ray = Ray::new(Vec3::new(0.0_f64, 0.0, 3.0), -UnitVec3::Z).unwrap();
/// Sphere::new(1.0).unwrap().hits_at::<Exact>(&ray);
/// ```
///
/// A filter of twice the precision decides nearly always; where it cannot tell, integers that are wide enough for
/// everything do, at some hundred times the cost. [`Shape::effort`](crate::Shape::effort) tells which it was.
///
/// A ray that [departs](crate::Departure) starts on its surface by decree and not by its coordinates: what it meets
/// follows rule 8 of the contract, from the same formulas as `Stable` in numbers of twice the precision. On a placed solid
/// such a ray is rounded on its way into the frame as in `Stable`: its `t` was measured up to 13 units off.
///
/// ```
/// use raylet::{Crossing, Ray, Sphere, UnitVec3, Vec3, tier::Exact};
/// // One part in ten million inside the sphere's silhouette.
/// let ray = Ray::new(Vec3::new(-2.0_f32, 0.99999994, 0.0), UnitVec3::X)?;
/// let hits = Sphere::new(1.0)?.hits_at::<Exact>(&ray);
/// assert_eq!((hits[0].t, hits[1].t), (1.9996548, 2.0003452));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Exact;

/// Which numbers an exact answer took.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Effort {
    /// Those of twice the precision.
    Filter,
    /// Wide integers too.
    Integers,
}

fn find<S: Certain, N: Of<S>>(figure: &Figure<S>, place: &impl Place<S>, ray: &Ray<S>) -> Option<Found<S>> {
    let [origin, direction] = place.line::<N>(ray);
    let line = Line { origin, direction };
    let range = ray.range();
    match *figure {
        Figure::Ball { radius } => round::ball(&line, N::scalar(radius), range),
        Figure::Capsule { radius, height } => round::capsule(&line, N::scalar(radius), N::scalar(height), range),
        Figure::Round { side, extent } => round::round(&line, side, extent, range),
        Figure::DoubleCone { slope } => round::double_cone(&line, N::scalar(slope), range),
        Figure::Plane => flat::plane(&line, range),
        Figure::Disc { radius } => flat::disc(&line, N::scalar(radius), range),
        Figure::Triangle { vertices } => flat::triangle(&line, vertices.map(|vertex| vertex.map(N::scalar)), range),
    }
}

/// All hits in the ray's range.
#[inline]
pub(crate) fn hits<S: Certain>(figure: &Figure<S>, place: &impl Place<S>, ray: &Ray<S>) -> Hits<S> {
    let (found, _) = meet(figure, place, ray);
    found.hits(ray.range())
}

/// The first hit in the ray's range that `accept` takes.
#[inline]
pub(crate) fn nearest<S: Certain>(
    figure: &Figure<S>,
    place: &impl Place<S>,
    ray: &Ray<S>,
    accept: impl Fn(Crossing) -> bool,
) -> Option<Hit<S>> {
    let (found, _) = meet(figure, place, ray);
    found.nearest(accept)
}

/// What the answer takes.
pub(crate) fn effort<S: Certain>(figure: &Figure<S>, place: &impl Place<S>, ray: &Ray<S>) -> Effort {
    let (_, effort) = meet(figure, place, ray);
    effort
}

/// How the ray's line meets the figure, and what it took to know.
#[inline(always)]
fn meet<S: Certain>(figure: &Figure<S>, place: &impl Place<S>, ray: &Ray<S>) -> (Found<S>, Effort) {
    #[cfg(feature = "libm")]
    if S::LOOKS_QUICKLY
        && let Some(found) = plain::find(figure, place.line::<S::Quick>(ray), ray.range())
    {
        return (found, Effort::Filter);
    }
    meet_by_filters(figure, place, ray)
}

/// Apart from the plain look, so that this stays short.
#[inline(never)]
fn meet_by_filters<S: Certain>(figure: &Figure<S>, place: &impl Place<S>, ray: &Ray<S>) -> (Found<S>, Effort) {
    if S::LOOKS_QUICKLY
        && let Some(found) = find::<S, S::Quick>(figure, place, ray)
    {
        return (found, Effort::Filter);
    }
    match find::<S, S::Filter>(figure, place, ray) {
        Some(found) => (found, Effort::Filter),
        None => (meet_in_integers(figure, place, ray), Effort::Integers),
    }
}

#[cold]
#[inline(never)]
fn meet_in_integers<S: Certain>(figure: &Figure<S>, place: &impl Place<S>, ray: &Ray<S>) -> Found<S> {
    // Integers know every sign: there is always an answer.
    let found = find::<S, S::Integer>(figure, place, ray);
    debug_assert!(found.is_some());
    found.unwrap_or(Found::Miss)
}

/// True if the point belongs to the figure.
pub(crate) fn contains<S: Certain>(figure: &Figure<S>, place: &impl Place<S>, point: Vec3<S>) -> bool {
    contains::holds(figure, place.point::<S::Filter>(point))
        .or_else(|| contains::holds(figure, place.point::<S::Integer>(point)))
        .unwrap_or(false)
}
