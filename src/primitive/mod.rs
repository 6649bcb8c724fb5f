//! The primitives, a file for each.
//!
//! In its canonical pose a primitive has the axis +y and its base at the origin; a sphere and a cuboid have their
//! centre there, and a cone that is given by its slope its apex. Sizes are numbers such as radius and height, not
//! scales. A primitive is a closed set of points. It computes where a line meets it, its normals, surface coordinates
//! and tangents. Placement and material belong to [`Shape`](crate::Shape) and [`Object`](crate::Object).
//!
//! | primitive | constructors |
//! |---|---|
//! | [`Sphere`] | [`new`](Sphere::new) |
//! | [`Cylinder`] | [`infinite`](Cylinder::infinite), [`open`](Cylinder::open), [`capped`](Cylinder::capped) |
//! | [`Capsule`] | [`new`](Capsule::new) |
//! | [`Cone`] | [`double`](Cone::double), [`nappe`](Cone::nappe), [`open`](Cone::open), [`capped`](Cone::capped), [`frustum`](Cone::frustum), [`frustum_open`](Cone::frustum_open) |
//! | [`Cuboid`] | [`new`](Cuboid::new) |
//! | [`Plane`], [`Disc`], [`Rectangle`], [`Triangle`] | [`new`](Plane::new), [`new`](Disc::new), [`new`](Rectangle::new), [`new`](Triangle::new) |
//!
//! # Degenerate rays
//!
//! The *wall* is the surface of the side. A *generator* is a line in a cone's side, through its apex. Rules are those
//! of the [contract](crate#the-contract).
//!
//! | ray | result |
//! |---|---|
//! | parallel to the axis of a capped cylinder, inside | enters and leaves through the caps |
//! | the same, exactly in the wall | two hits, at the rims (the set is closed: rule 1), with the part `Side` (rule 5) |
//! | parallel to the axis of an open or infinite cylinder, inside | no hit |
//! | the same, in the wall | [`coincident`](crate::Hits::coincident) |
//! | parallel to a cone's generator | the quadric has one root, `-c/(2k)` |
//! | along a cone's generator | `coincident` for an open or infinite cone; from apex to cap for a capped one |
//! | in a cap's plane | enters and leaves where it crosses the side |
//! | through the apex from outside | one touch |
//! | through the apex of a double cone, inside both nappes | leaves one nappe and enters the other at the same `t` |
//! | through the apex of a double cone, outside of both | one touch |
//! | from rim to rim, from seam to seam | two hits, with the part `Side` |
//! | in the plane of a cuboid's face, or along its edge | enters and leaves where it crosses the edges of that face or the corners; [`Cuboid`] says which part owns them |
//! | across an edge or a corner of a cuboid from outside | one touch |
//! | in a plane, disc, rectangle or triangle | `coincident` |
//! | in the plane of a disc, rectangle or triangle, touching its rim or a corner | `coincident` over a single point |

use crate::scalar::{Scalar, ValueError, with_fault};
use core::fmt;

mod aperture;
mod capsule;
mod cone;
mod constant;
mod cuboid;
mod cylinder;
mod disc;
#[cfg(feature = "defmt")]
mod logged;
mod plane;
mod queries;
mod rectangle;
mod sphere;
#[cfg(feature = "serde")]
mod stored;
pub(crate) mod surface_coordinates;
mod triangle;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use plane::Plane;
pub use rectangle::Rectangle;
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
    /// A half extent is not positive, not finite or beyond the budget.
    HalfExtent(ValueError),
    /// A coordinate of a vertex is not finite or beyond the budget.
    Vertex(ValueError),
    /// A coordinate of a corner is not finite or beyond the budget.
    Corner(ValueError),
    /// The vertices lie on a line, or too nearly so for the number type.
    Vertices,
}

impl SizeError {
    /// The message; also for constants.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Radius(error) => with_fault!("the radius ", error),
            Self::Height(error) => with_fault!("the height ", error),
            Self::Slope(error) => with_fault!("the slope (radius over height) ", error),
            Self::HalfExtent(error) => with_fault!("a half extent ", error),
            Self::Vertex(error) => with_fault!("a coordinate of a vertex ", error),
            Self::Corner(error) => with_fault!("a coordinate of a corner ", error),
            Self::Vertices => "the vertices lie on a line, or too nearly so for the number type",
        }
    }
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for SizeError {}

/// A positive size inside the budget.
fn checked_size<S: Scalar>(size: S, error: fn(ValueError) -> SizeError) -> Result<S, SizeError> {
    // The comparison is false for NaN.
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
