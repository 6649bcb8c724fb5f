//! The primitives, a file for each.
//!
//! In its canonical pose a primitive has the axis +y and its base at the origin; a sphere, a torus and a cuboid have
//! their centre there, a round cone that of its lower ball, and a cone that is given by its slope its apex. Sizes are numbers
//! such as radius and height, not scales. A primitive is a closed set of points. It computes where a line meets it, its
//! normals, surface coordinates and tangents. Placement and material belong to [`Shape`](crate::Shape) and
//! [`Object`](crate::Object).
//!
//! | primitive | constructors |
//! |---|---|
//! | [`Sphere`] | [`new`](Sphere::new) |
//! | [`Cylinder`] | [`infinite`](Cylinder::infinite), [`open`](Cylinder::open), [`capped`](Cylinder::capped) |
//! | [`Capsule`] | [`new`](Capsule::new) |
//! | [`Cone`] | [`double`](Cone::double), [`nappe`](Cone::nappe), [`open`](Cone::open), [`capped`](Cone::capped), [`frustum`](Cone::frustum), [`frustum_open`](Cone::frustum_open) |
//! | [`Revolved`] | [`paraboloid`](Revolved::paraboloid), [`spheroid`](Revolved::spheroid), [`ball_zone`](Revolved::ball_zone), [`cone`](Revolved::cone), [`hyperboloid`](Revolved::hyperboloid), [`tower`](Revolved::tower), [`optical`](Revolved::optical), [`new`](Revolved::new); [`open`](Revolved::open) |
//! | [`RoundCone`] | [`new`](RoundCone::new) |
//! | [`Tube`] | [`new`](Tube::new), [`with_wall`](Tube::with_wall) |
//! | [`Torus`] | [`new`](Torus::new) |
//! | [`Cuboid`] | [`new`](Cuboid::new), [`between`](Cuboid::between) |
//! | [`RoundedCuboid`] | [`new`](RoundedCuboid::new), [`within`](RoundedCuboid::within) |
//! | [`Prism`] | [`new`](Prism::new) |
//! | [`Polyhedron`] | [`new`](Polyhedron::new), [`within`](Polyhedron::within) |
//! | [`Plane`], [`Disc`], [`Annulus`], [`Rectangle`], [`Triangle`] | [`new`](Plane::new), [`new`](Disc::new), [`new`](Annulus::new), [`new`](Rectangle::new), [`new`](Triangle::new) |
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
//! | parallel to the axis of a paraboloid | the quadric has one root, as for a cone's generator |
//! | along a straight line in the side of a hyperboloid or of a double cone | from plane to plane of a capped one; `coincident` for an open one |
//! | through a waist from outside, or from one nappe of a double cone into the other | two intervals |
//! | touching a waist from inside | leaves and enters again at the same `t` |
//! | through the hole of a tube from outside | two intervals |
//! | touching the inner side of a tube from within the wall | one interval: it does not leave the wall |
//! | through a torus on both sides of its hole | two intervals |
//! | touching a torus from outside, also in the plane of its highest circle | one touch, or one on each side |
//! | touching the surface of a torus from within | one interval: it does not leave the solid |
//! | along the inner side of a tube | from rim to rim, with the part `Inner` |
//! | in the plane of a cuboid's face, or along its edge | enters and leaves where it crosses the edges of that face or the corners; [`Cuboid`] says which part owns them |
//! | across an edge or a corner of a cuboid from outside | one touch |
//! | in the plane of a prism's or a polyhedron's face, along its edge, or across one from outside | as of a cuboid; [`Prism`] and [`Polyhedron`] say which part owns an edge |
//! | in the plane of a rounded cuboid's face | enters and leaves at the seams, which belong to the face |
//! | along a rounded cuboid's edge, in its surface | enters and leaves at the corners, with the part `Side` |
//! | in a plane, disc, annulus, rectangle or triangle | `coincident`; across the hole of an annulus too |
//! | in the plane of a disc, annulus, rectangle or triangle, touching its rim or a corner | `coincident` over a single point |

use crate::scalar::{Scalar, ValueError, with_fault};
use core::fmt;

mod annulus;
mod aperture;
mod capsule;
mod cone;
mod constant;
mod constant_lists;
mod cuboid;
mod cylinder;
mod disc;
#[cfg(feature = "defmt")]
mod logged;
mod plane;
mod polyhedron;
mod prism;
mod queries;
mod rectangle;
mod revolved;
mod round_cone;
mod rounded_cuboid;
mod sphere;
#[cfg(feature = "serde")]
mod stored;
#[cfg(feature = "serde")]
mod stored_lists;
pub(crate) mod surface_coordinates;
mod torus;
mod triangle;
mod tube;

pub use crate::half_space::HalfSpace;
pub use annulus::Annulus;
pub use capsule::Capsule;
pub use cone::Cone;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use plane::Plane;
pub use polyhedron::Polyhedron;
pub use prism::Prism;
pub use rectangle::Rectangle;
pub use revolved::Revolved;
pub use round_cone::RoundCone;
pub use rounded_cuboid::RoundedCuboid;
pub use sphere::Sphere;
pub use torus::Torus;
pub use triangle::Triangle;
pub use tube::Tube;

pub(crate) use crate::geometry::Geometry;
pub(crate) use queries::queries;

/// Why a primitive cannot be built: which size, and what is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SizeError {
    /// A radius is not positive (a frustum's may be zero, but not both), not finite or beyond the budget.
    Radius(ValueError),
    /// A height is not positive (that of a capsule or a round cone may be zero), not finite or beyond the budget.
    Height(ValueError),
    /// A slope is not positive, not finite or beyond the budget.
    Slope(ValueError),
    /// A half extent is not positive (that of a rounded cuboid's core may be zero), not finite or beyond the budget.
    HalfExtent(ValueError),
    /// A coordinate of a vertex is not finite or beyond the budget.
    Vertex(ValueError),
    /// A coordinate of a corner is not finite or beyond the budget.
    Corner(ValueError),
    /// A coefficient of a quadric of revolution is not finite or beyond the budget.
    Coefficient(ValueError),
    /// The lower height of a quadric of revolution is not below the upper one.
    Heights,
    /// The inner radius of a tube or an annulus is not below the outer one.
    Radii,
    /// The minor radius of a torus is not below the major one.
    Ring,
    /// A quadric of revolution has no radius at a height between its ends, or is no wider than its axis.
    Outline,
    /// The vertices lie on a line, or too nearly so for the number type.
    Vertices,
    /// A polyhedron has no half-space, or more than 16.
    FaceCount,
    /// The largest component of the normal of a half-space is zero, not finite or, as a slope, beyond the budget.
    Normal(ValueError),
    /// What half-spaces have in common is not bounded, or only by planes that are nearly parallel; or it is empty.
    Unbounded,
    /// A prism has fewer than 3 corners, or more than 16.
    CornerCount,
    /// The corners of a prism are not those of a convex polygon, counter-clockwise as seen from +y; or one turns by
    /// less than 1/4000.
    Corners,
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
            Self::Coefficient(error) => with_fault!("a coefficient ", error),
            Self::Heights => "the lower height is not below the upper one",
            Self::Radii => "the inner radius is not below the outer one",
            Self::Ring => "the minor radius is not below the major one",
            Self::Outline => "there is no radius at a height between the ends, or none above zero",
            Self::FaceCount => "there is no half-space, or there are more than 16",
            Self::Normal(error) => with_fault!("the largest component of the normal ", error),
            Self::Unbounded => "the half-spaces bound no solid, or only by planes that are nearly parallel",
            Self::CornerCount => "there are fewer than 3 corners, or more than 16",
            Self::Corners => "the corners do not turn to the left, as seen from +y, once around a convex polygon",
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
pub(crate) fn checked_size<S: Scalar>(size: S, error: fn(ValueError) -> SizeError) -> Result<S, SizeError> {
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

/// An inner and an outer radius.
fn checked_radii<S: Scalar>(inner: S, outer: S) -> Result<[S; 2], SizeError> {
    let [inner, outer] = [checked_size(inner, SizeError::Radius)?, checked_size(outer, SizeError::Radius)?];
    if inner < outer { Ok([inner, outer]) } else { Err(SizeError::Radii) }
}
