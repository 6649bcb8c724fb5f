//! The solver: where a line meets a solid, decided by signs alone.
//!
//! All tiers use the same algorithm. It is generic over the [`Number`](crate::number::Number) that it computes in. If a
//! number does not know a sign, the solver returns [`Stop::Unsure`], and the whole query is repeated in the next wider
//! number. Rounded coefficients are never compared with each other. This is the method of adaptive exact predicates
//! (Shewchuk, *Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*, 1997), applied to a
//! whole query instead of one determinant.
//!
//! In [`Robust`](crate::number::Robust) a sign is that of the rounded value. Such signs may contradict each other; the
//! ends of intervals are sorted and paired nevertheless.
//!
//! | file | what it holds |
//! |---|---|
//! | `attempt` | why there is no result |
//! | `local_ray` | the ray in a primitive's frame, in each number |
//! | `quadric` | the quadrics in coordinates along a line: each equation once |
//! | `quadratic` | a quadric along the line; the order of its roots and of planes |
//! | `roots`, `root_of_hit` | the order of the roots of two equations; which root belongs to a hit |
//! | `end` | the ends of intervals, and their conversion to the ray's number type |
//! | `round` | spheres, capsules and round cones |
//! | `rounded` | rounded cuboids |
//! | `revolved` | quadrics of revolution between two planes |
//! | `side` | cylinders and cones, double, infinite, open or between planes |
//! | `tube` | tubes |
//! | `torus`, `root_of_torus` | tori; their crossings among those of others |
//! | `quartic`, `sturm`, `newton` | the roots of the equation of a torus: counted, ordered, computed |
//! | `flat` | planes, discs, annuli, triangles |
//! | `slabs` | cuboids, rectangles |
//! | `polyhedra` | prisms, polyhedra |
//! | `contains`, `surface` | the inside test; the point of a hit, and its normal |

mod attempt;
#[cfg(units)]
#[path = "../../tests/units/solve/coefficients.rs"]
mod coefficients;
mod contains;
mod end;
mod flat;
mod local_ray;
mod newton;
#[cfg(units)]
#[path = "../../tests/units/solve/order.rs"]
mod order;
mod polyhedra;
mod quadratic;
mod quadric;
mod quartic;
mod revolved;
mod root_of_hit;
mod root_of_torus;
mod roots;
mod round;
mod rounded;
mod side;
mod slabs;
mod sturm;
mod surface;
#[cfg(units)]
#[path = "../../tests/units/solve.rs"]
mod tests;
mod torus;
mod tube;

pub use attempt::{Attempt, Stop};
pub(crate) use contains::holds;
pub use end::{Goal, Of};
pub(crate) use flat::{annulus, disc, plane, triangle};
pub(crate) use local_ray::rounded_ray;
pub use local_ray::{LocalRay, Localize};
pub(crate) use polyhedra::{polyhedron, prism};
pub(crate) use quadric::Profile;
pub(crate) use revolved::revolved;
pub use root_of_hit::Root;
pub(crate) use root_of_hit::root_at;
pub(crate) use round::{ball, capsule, round_cone};
pub(crate) use rounded::{end_at, region_at, rounded_cuboid};
pub(crate) use side::{caps, cone, cylinder};
pub(crate) use slabs::{cuboid, rectangle};
pub(crate) use surface::{Line, Surface, correction, point_at, surface_of};
pub(crate) use torus::torus;
pub(crate) use tube::tube;

use crate::equations::Equations;
use crate::outline::Extent;
use crate::part::Part;
use crate::ray::Leaving;

/// True if rule 8 of the contract implies that a departing ray misses, without any arithmetic: if it departs outwards
/// from a convex solid, or from a flat primitive.
#[inline(always)]
pub(crate) fn meets_nothing<S>(equations: &Equations<S>, departure: Option<(Part, Leaving)>) -> bool {
    match (departure, equations) {
        (None, _) => false,
        (_, equations) if equations.is_flat() => true,
        (_, Equations::Cone { extent: Extent::Double, .. }) => false,
        (Some((Part::Side, _)), Equations::Revolved { meridian }) if meridian.has_waist => false,
        (Some((Part::Inner, _)), Equations::Tube { .. }) | (Some(_), Equations::Torus { .. }) => false,
        (Some((_, leaving)), _) => leaving == Leaving::Outwards,
    }
}
