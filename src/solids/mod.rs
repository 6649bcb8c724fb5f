//! Many solids along one ray: all crossings in order, and which solids the ray is inside of between them.
//!
//! | module | what it holds |
//! |---|---|
//! | `set` | sets of solids |
//! | `start` | what is known of a ray's start: the solids that it is inside of, the surfaces that it departs from |
//! | `crossings` | the crossings of all solids of a list, in order |
//! | `queries` | the nearest crossing, and occlusion |
//!
//! # The order
//!
//! Crossings are ordered by their `t`: in [`Exact`](crate::Exact) by the exact one, in the other tiers by the rounded
//! one. At equal `t` exits come first, then touches, then entries, and among these the solid of the lower index. So a
//! ray that goes from one solid into another that touches it is inside of neither in between, and never of both. An
//! exit at the `t` of its own entry comes after that: each solid's crossings keep their order.
//!
//! # Which solids a point lies in
//!
//! The crossings of a solid alternate, whatever their rounding. So the set of solids that the ray is inside of follows
//! from the list alone, and no coordinate is tested again. A ray that continues from a crossing takes the set along
//! ([`Start`]). A solid that rounding has put behind the new start is left, or entered, at the start: no crossing is
//! lost and none is met twice, and no offset is needed. (A ray that grazes a solid within the rounding of the points of
//! its path may hit it from one of them and miss it from the next.)

mod crossings;
mod queries;
mod set;
mod start;

pub use crossings::{Crossings, CrossingsError, Iter, List, SolidCrossing};
pub use queries::{nearest, occludes};
pub use set::SolidSet;
pub use start::{Start, StartError};
