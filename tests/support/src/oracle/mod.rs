//! The exact oracle: where a line meets a solid, in exact arithmetic.
//!
//! It knows nothing of the crate under test. It is given machine numbers, each of which is a dyadic rational, and it
//! answers with quadratic surds; no decision is made in floating point. Solids stand in the canonical pose: axis +y,
//! base at the origin, cone apex at the origin. Any other pose is for the caller to undo, exactly.
//!
//! - [`dyadic`]: the numbers given, `mantissa * 2^exponent`.
//! - [`algebraic`]: the numbers answered, `(p + s * sqrt(D)) / q`.
//! - [`solids`]: what the solids are, and which points belong to them.
//! - `solve`: where a line meets them; of which `quadric`, `revolved`, `round_cone`, `rounded_cuboid`, `tube`,
//!   `torus`, `half_spaces`, `flat` and `slabs` do the equations.
//! - [`departing`]: where a line that departs from a solid meets it again.
//! - [`expected`]: what of that a ray with a range of `t` must report.
//! - `normal`: which way the surface faces there.

pub mod algebraic;
pub mod departing;
pub mod dyadic;
pub mod expected;
mod flat;
mod half_spaces;
pub mod normal;
mod quadric;
mod revolved;
mod round_cone;
mod rounded_cuboid;
mod slabs;
pub mod solids;
pub mod solve;
mod torus;
mod tube;

pub use algebraic::Root;
pub use departing::{Leaving, solve_departing};
pub use dyadic::{Dyadic, exact_f32, exact_f64, exact_fixed};
pub use expected::{ExpectedCrossing, ExpectedHit, InRange, hits_in_range};
pub use normal::{gradient, normal};
pub use revolved::margin as revolved_margin;
pub use solids::{
    ConeExtent, CylinderExtent, HalfSpace, HalfSpaces, Line, Membership, Part, Revolved, RoundCone, RoundedCuboid,
    Solid, contains, margin,
};
pub use solve::{Answer, Approach, Crossing, End, Span, solve};
