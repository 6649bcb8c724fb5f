//! The solver: where a line meets a solid, decided by signs alone.
//!
//! All tiers use the same algorithm. It is generic over the [`Number`](crate::number::Number) that it computes in. If a number does not
//! know a sign, the solver returns `None`, and the whole query is repeated in the next wider number. Rounded coefficients are never compared
//! with each other. This is the method of adaptive exact predicates (Shewchuk, *Adaptive Precision Floating-Point Arithmetic and Fast Robust
//! Geometric Predicates*, 1997), applied to a whole query instead of one determinant.
//!
//! In [`Robust`](crate::number::Robust) a sign is that of the rounded value. Such signs may contradict each other; the ends of intervals are sorted
//! and paired nevertheless.
//!
//! | file | what it holds |
//! |---|---|
//! | `form` | the line, and the quadrics as bilinear forms |
//! | `quadratic` | a quadric along the line; the order of its roots and of planes |
//! | `settle` | conversion of ends to the ray's number type, and comparison with its range |
//! | `round` | spheres, capsules, double cones |
//! | `side` | cylinders and cones, infinite, open or between planes |
//! | `flat` | planes, discs, triangles |
//! | `slabs` | cuboids, rectangles |
//! | `contains` | the inside test |
//! | `surface` | the point of a hit, and its normal |

#![expect(clippy::option_option, reason = "an end that is not there, and one that is not known")]

mod contains;
mod flat;
mod form;
mod quadratic;
mod round;
mod settle;
mod side;
mod slabs;
mod surface;
#[cfg(test)]
mod tests;

pub(crate) use contains::holds;
pub(crate) use form::Line;
pub(crate) use settle::Of;
pub(crate) use surface::{bending, correction, gradient, point_at, value};

use crate::equations::{Described, EquationKinds, Equations};
use crate::intersection::Intersection;
use crate::part::Part;
use crate::ray::{Leaving, Range};
use crate::scalar::Scalar;

/// True if rule 8 of the contract implies that a departing ray misses, without any arithmetic: if it departs outwards from a convex
/// solid, or from a flat primitive.
#[inline(always)]
pub(crate) fn meets_nothing<S>(equations: &Equations<S>, departure: Option<(Part, Leaving)>) -> bool {
    match (departure, equations) {
        (None, _) => false,
        (_, Equations::Plane | Equations::Disc { .. } | Equations::Rectangle { .. } | Equations::Triangle { .. }) => {
            true
        }
        (_, Equations::DoubleCone { .. }) => false,
        (Some((_, leaving)), _) => leaving == Leaving::Outwards,
    }
}

/// The intersection of the line with a primitive; `None` if the number does not know a sign. [`meets_nothing`] must be false for a line
/// that departs.
///
/// Only the functions for the kinds of equations of the geometry `G` are linked.
#[inline(always)]
pub(crate) fn intersect<S: Scalar, N: Of<S>, G: Described>(
    equations: &Equations<S>,
    line: &Line<N>,
    range: Range<S>,
) -> Option<Intersection<S>> {
    match *equations {
        Equations::Ball { radius } if G::EQUATIONS.has(EquationKinds::BALL) => {
            round::ball(line, N::scalar(radius), range)
        }
        Equations::Capsule { radius, height } if G::EQUATIONS.has(EquationKinds::CAPSULE) => {
            round::capsule(line, N::scalar(radius), N::scalar(height), range)
        }
        Equations::Round { side, extent } if G::EQUATIONS.has(EquationKinds::TUBE.and(EquationKinds::CONE)) => {
            side::intersect::<S, N, G>(line, side, extent, range)
        }
        Equations::DoubleCone { slope } if G::EQUATIONS.has(EquationKinds::DOUBLE_CONE) => {
            round::double_cone(line, N::scalar(slope), range)
        }
        Equations::Plane if G::EQUATIONS.has(EquationKinds::PLANE) => flat::plane(line, range),
        Equations::Disc { radius } if G::EQUATIONS.has(EquationKinds::DISC) => {
            flat::disc(line, N::scalar(radius), range)
        }
        Equations::Triangle { vertices } if G::EQUATIONS.has(EquationKinds::TRIANGLE) => {
            flat::triangle(line, vertices.map(|vertex| vertex.map(N::scalar)), range)
        }
        Equations::Cuboid { half } if G::EQUATIONS.has(EquationKinds::CUBOID) => {
            slabs::cuboid(line, half.map(N::scalar), range)
        }
        Equations::Rectangle { half } if G::EQUATIONS.has(EquationKinds::RECTANGLE) => {
            slabs::rectangle(line, half.map(N::scalar), range)
        }
        // The geometry has no such equations. (A wildcard arm would cost a test: the compiler does not know that it is unreachable.)
        Equations::Ball { .. }
        | Equations::Capsule { .. }
        | Equations::Round { .. }
        | Equations::DoubleCone { .. }
        | Equations::Plane
        | Equations::Disc { .. }
        | Equations::Cuboid { .. }
        | Equations::Rectangle { .. }
        | Equations::Triangle { .. } => Some(Intersection::Miss),
    }
}
