//! The primitives, a file each.
//!
//! Canonical pose: axis +y, base at the origin, cone apex at the origin. Size is explicit. A primitive is a closed set
//! of points, and knows how a line meets it, its normals, surface coordinates and tangents; nothing of materials or
//! placement.
//!
//! | primitive | constructors |
//! |---|---|
//! | [`Sphere`] | [`new`](Sphere::new) |
//! | [`Cylinder`] | [`infinite`](Cylinder::infinite), [`open`](Cylinder::open), [`capped`](Cylinder::capped) |
//! | [`Capsule`] | [`new`](Capsule::new) |
//! | [`Cone`] | [`double`](Cone::double), [`nappe`](Cone::nappe), [`open`](Cone::open), [`capped`](Cone::capped), [`frustum`](Cone::frustum), [`frustum_open`](Cone::frustum_open) |
//! | [`Plane`], [`Disc`], [`Triangle`] | [`new`](Plane::new), [`new`](Disc::new), [`new`](Triangle::new) |
//!
//! # Degenerate rays
//!
//! | ray | answer |
//! |---|---|
//! | parallel to a cylinder's axis, inside | enters and leaves through the caps |
//! | the same, exactly in the wall | from rim to rim (rule 1: the set is closed), which belong to the side |
//! | parallel to the axis of an open or infinite cylinder, inside | no hit |
//! | the same, in the wall | [`coincident`](crate::Hits::coincident) |
//! | parallel to a cone's generator | one root, `-c/(2k)`, not none |
//! | along a cone's generator | `coincident` for an open or infinite cone; apex to cap for a capped one |
//! | in a cap's plane | enters and leaves where it crosses the side |
//! | through the apex from outside | one touch |
//! | through the apex of a double cone, inside both nappes | leaves one and enters the other at the same `t` |
//! | through the apex of a double cone, outside of both | one touch |
//! | rim to rim, seam to seam | two hits, on the side |
//! | in a plane, disc or triangle | `coincident` |
//! | in the plane of a disc or triangle, touching its rim or a corner | `coincident` over a single point |

use crate::scalar::{Scalar, ValueError};
use core::fmt;

mod capsule;
mod cone;
mod cylinder;
mod disc;
mod outline;
mod plane;
mod queries;
mod sphere;
#[cfg(feature = "serde")]
mod stored;
mod surface_coordinates;
mod triangle;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use plane::Plane;
pub use sphere::Sphere;
pub use triangle::Triangle;

pub(crate) use crate::geometry::Geometry;
pub(crate) use queries::queries;

/// Why a primitive cannot be built: which size, and what is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SizeError {
    /// A radius is not positive (a frustum's may be zero, but not both), not finite or beyond the budget.
    Radius(ValueError),
    /// A height is not positive (a capsule's may be zero), not finite or beyond the budget.
    Height(ValueError),
    /// A slope is not positive, not finite or beyond the budget.
    Slope(ValueError),
    /// A coordinate of a vertex is not finite or beyond the budget.
    Vertex(ValueError),
    /// The vertices lie on a line, or too nearly so for the number type.
    Vertices,
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Radius(error) => write!(f, "the radius {error}"),
            Self::Height(error) => write!(f, "the height {error}"),
            Self::Slope(error) => write!(f, "the slope (radius over height) {error}"),
            Self::Vertex(error) => write!(f, "a coordinate of a vertex {error}"),
            Self::Vertices => f.write_str("the vertices lie on a line, or too nearly so for the number type"),
        }
    }
}

impl core::error::Error for SizeError {}

/// A positive size inside the budget.
fn checked_size<S: Scalar>(size: S, error: fn(ValueError) -> SizeError) -> Result<S, SizeError> {
    // A NaN compares false.
    if size >= S::BUDGET.smallest_size && size <= S::BUDGET.size {
        Ok(size)
    } else {
        Err(error(ValueError::of_size(size, S::BUDGET.smallest_size)))
    }
}

/// A size inside the budget that may be zero.
fn checked_size_or_zero<S: Scalar>(size: S, error: fn(ValueError) -> SizeError) -> Result<S, SizeError> {
    if size == S::ZERO { Ok(S::ZERO) } else { checked_size(size, error) }
}
