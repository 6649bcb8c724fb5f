//! Floor 5: the primitives, a file each.
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
//! | rim to rim, seam to seam | two hits, on the side |
//! | in a plane, disc or triangle | `coincident` |

use crate::hit::Part;
use crate::scalar::Scalar;
use crate::span::Meeting;
use crate::tier::Tier;
use crate::vector::{UnitVec3, Vec3};
use core::fmt;

mod capsule;
mod cone;
mod cylinder;
mod disc;
mod plane;
mod sphere;
mod surface_coordinates;
mod triangle;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use plane::Plane;
pub use sphere::Sphere;
pub use triangle::Triangle;

pub(crate) use crate::line::Line;

/// What every primitive knows of itself, in its own frame.
pub(crate) trait Geometry<S: Scalar>: Copy {
    /// A distance from the origin within which the primitive lies; its characteristic size if it is unbounded.
    fn reach(&self) -> S;
    /// True if a point that is several reaches from the origin is far from the surface too; for what is unbounded.
    fn is_far(&self, _: Vec3<S>) -> bool {
        true
    }
    /// The primitive with all lengths multiplied by `2^e`, for an exponent from [`Scalar::binary_exponent`].
    #[must_use]
    fn scaled(&self, e: i32) -> Self;
    /// Where the line meets it.
    fn meet<T: Tier<S>>(&self, line: &Line<S>) -> Meeting<S>;
    /// Whether the half-line `t >= 0` hits it, where the signs of the coefficients say so without a root or a division;
    /// the line departs from nowhere. What is said here must agree with [`Geometry::meet`].
    fn verdict<T: Tier<S>>(&self, _: &Line<S>) -> Option<bool> {
        None
    }
    /// True if the point belongs to the closed set.
    fn contains(&self, point: Vec3<S>) -> bool;
    /// The smallest box, as its lower and upper corner; infinite where the primitive is.
    fn bounds(&self) -> (Vec3<S>, Vec3<S>);
    /// The point of the part that is nearest, or nearly so, to a point close to it.
    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S>;
    /// The outward unit normal at a point of the part.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S>;
    /// Surface coordinates at a point of the part, each in `[0, 1]`.
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit);
    /// The directions in which `u` and `v` grow at a point of the part.
    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>);
}

/// Why a primitive cannot be built: which size, and what is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SizeError {
    /// A radius is not positive (a frustum's may be zero, but not both), not finite or beyond the budget.
    Radius,
    /// A height is not positive (a capsule's may be zero), not finite or beyond the budget.
    Height,
    /// A slope is not positive, not finite or beyond the budget.
    Slope,
    /// A vertex is not finite or beyond the budget, or the vertices lie on a line.
    Vertices,
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Radius => "the radius must be positive and within the number type's budget",
            Self::Height => "the height must be positive and within the number type's budget",
            Self::Slope => "the slope (radius over height) must be positive and within the number type's budget",
            Self::Vertices => "the vertices must be within the number type's budget and must not lie on a line",
        })
    }
}

impl core::error::Error for SizeError {}

/// A positive size inside the budget.
fn checked_size<S: Scalar>(size: S, error: SizeError) -> Result<S, SizeError> {
    // A NaN compares false.
    if size >= S::BUDGET.smallest_size && size <= S::BUDGET.size { Ok(size) } else { Err(error) }
}

/// A size inside the budget that may be zero.
fn checked_size_or_zero<S: Scalar>(size: S, error: SizeError) -> Result<S, SizeError> {
    if size == S::ZERO { Ok(S::ZERO) } else { checked_size(size, error) }
}

/// Gives a primitive the queries of an unplaced, two-sided shape as methods of its own.
macro_rules! queries {
    ($Primitive:ident) => {
        impl<S: Scalar> $Primitive<S> {
            /// All hits, sorted by `t`.
            pub fn hits(&self, ray: &crate::Ray<S>) -> crate::Hits<S> {
                self.hits_at::<crate::Stable>(ray)
            }
            /// All hits, in a chosen accuracy tier.
            pub fn hits_at<T: Tier<S>>(&self, ray: &crate::Ray<S>) -> crate::Hits<S> {
                crate::query::hits::<S, T, _>(self, ray)
            }
            /// The hit with the smallest `t`.
            pub fn nearest(&self, ray: &crate::Ray<S>) -> Option<crate::Hit<S>> {
                self.nearest_at::<crate::Stable>(ray)
            }
            /// The hit with the smallest `t`, in a chosen accuracy tier.
            pub fn nearest_at<T: Tier<S>>(&self, ray: &crate::Ray<S>) -> Option<crate::Hit<S>> {
                crate::query::nearest::<S, T, _>(self, ray)
            }
            /// True if there is any hit.
            pub fn occludes(&self, ray: &crate::Ray<S>) -> bool {
                self.occludes_at::<crate::Stable>(ray)
            }
            /// True if there is any hit, in a chosen accuracy tier.
            pub fn occludes_at<T: Tier<S>>(&self, ray: &crate::Ray<S>) -> bool {
                crate::query::occludes::<S, T, _>(self, ray, &crate::query::unplaced(self, ray), |_| true)
            }
            /// True if the point belongs to the primitive: inside or on a solid, on an open surface.
            pub fn contains(&self, point: Vec3<S>) -> bool {
                Geometry::contains(self, point)
            }
            /// The box that holds it; infinite where the primitive is.
            pub fn bounds(&self) -> crate::Bounds<S> {
                let (low, high) = Geometry::bounds(self);
                crate::Bounds { low, high }
            }
            /// What a hit can be asked for: point, normal, surface coordinates, tangents.
            pub fn surface(&self, ray: &crate::Ray<S>, hit: &crate::Hit<S>) -> crate::Surface<S> {
                crate::Shape::new(*self).surface(ray, hit)
            }
        }
    };
}
pub(crate) use queries;
