//! The solver: where a line meets a solid, decided by signs alone.
//!
//! One algorithm for all tiers. It runs in any [`Number`](crate::number::Number); a number that does not know a sign makes it return
//! `None`, and then the whole is repeated in the next number of the ladder. No two rounded coefficients are ever compared. This is how
//! exact geometric predicates are made (Shewchuk, *Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//! Predicates*, 1997), applied to a whole query instead of one determinant.
//!
//! Where signs are taken at their word ([`Robust`](crate::number::Robust)) they may contradict each other; whatever they are, ends
//! come out sorted and paired.
//!
//! | file | what it holds |
//! |---|---|
//! | `form` | the line, and the quadrics as bilinear forms |
//! | `quadratic` | a quadric along the line; the order of its roots and of planes |
//! | `settle` | ends in the ray's own numbers, and its range |
//! | `round` | balls, capsules, double cones |
//! | `side` | what lies within a side and between planes |
//! | `flat` | planes, discs, triangles |
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
mod surface;
#[cfg(test)]
mod tests;

pub(crate) use contains::holds;
pub(crate) use form::Line;
pub(crate) use settle::Of;
pub(crate) use surface::{correction, gradient, point_at, value};

use crate::figure::Figure;
use crate::intersection::Intersection;
use crate::part::Part;
use crate::ray::{Leaving, Range};
use crate::scalar::Scalar;

/// True where rule 8 of the contract says that a departing ray meets nothing, without any arithmetic: outwards from anything convex,
/// and from anything flat.
#[inline(always)]
pub(crate) fn meets_nothing<S>(figure: &Figure<S>, departure: Option<(Part, Leaving)>) -> bool {
    match (departure, figure) {
        (None, _) => false,
        (_, Figure::Plane | Figure::Disc { .. } | Figure::Triangle { .. }) => true,
        (_, Figure::DoubleCone { .. }) => false,
        (Some((_, leaving)), _) => leaving == Leaving::Outwards,
    }
}

/// How the line meets the figure; `None` if the number cannot tell. A line that departs must not be one that
/// [`meets_nothing`].
///
/// Inlined, so that where the figure is known only its own functions are linked.
#[inline(always)]
pub(crate) fn intersect<S: Scalar, N: Of<S>>(
    figure: &Figure<S>,
    line: &Line<N>,
    range: Range<S>,
) -> Option<Intersection<S>> {
    match *figure {
        Figure::Ball { radius } => round::ball(line, N::scalar(radius), range),
        Figure::Capsule { radius, height } => round::capsule(line, N::scalar(radius), N::scalar(height), range),
        Figure::Round { side, extent } => side::intersect(line, side, extent, range),
        Figure::DoubleCone { slope } => round::double_cone(line, N::scalar(slope), range),
        Figure::Plane => flat::plane(line, range),
        Figure::Disc { radius } => flat::disc(line, N::scalar(radius), range),
        Figure::Triangle { vertices } => flat::triangle(line, vertices.map(|vertex| vertex.map(N::scalar)), range),
    }
}
