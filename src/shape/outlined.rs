//! What a shape looks like from a point: whether the rays from there that see it lie within one angle of any plane.
//!
//! All rays that meet a convex set do: of three rays in a plane through the eye the one in between meets the segment
//! between the points where the others enter.

use super::kind::Kind;
use super::kinds::Kinds;
use super::placement::Placement;
use super::{Shape, Visible};
use crate::equations::Equations;
use crate::geometry::Geometry;
use crate::outline::Extent;
use crate::part::Part;
use crate::scalar::{Scalar, largest};
use crate::vector::Vec3;

/// Which rays from a point, in a plane through that point, see a shape and its parts first. The point must be outside
/// of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outlined {
    /// A plane that is seen from both sides: those that see it, and those that do not, each lie within one angle.
    Plane,
    /// Those that see it lie within one angle. They all see its side.
    Side,
    /// The same, but there may be several parts.
    Parts,
    /// The same, and those that see each of its parts, which are flat, lie within one angle.
    Facets,
    /// Those that see it lie within one angle, and so do those that see this cap. All others see its side.
    Cap(Part),
    /// All that is not known to be one of these.
    Other,
}

impl<S: Scalar, K: Kinds> Shape<S, K> {
    /// True if its side is that of a ball or of a cylinder. Seen from far away, the sine of the angle between the
    /// normal and the direction to the eye then changes by the same amount from each column of a row to the next.
    pub(crate) fn is_round(&self) -> bool {
        let is_round = matches!(self.member.equations(), Equations::Ball { .. } | Equations::Cylinder { .. });
        is_round && self.combined().is_none() && !matches!(self.own().1, Placement::Affine(_))
    }

    /// What it looks like from this point.
    pub(crate) fn outlined_from(&self, eye: Vec3<S>) -> Outlined {
        if self.combined().is_some() || self.visible() == Visible::Inside {
            return Outlined::Other;
        }
        let (_, placement) = self.own();
        let eye = match placement {
            Placement::World => eye,
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => frame.point_to_local(eye),
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => affine.point_to_local(eye),
            _ => return Outlined::Other,
        };
        match self.member.equations() {
            Equations::Plane if self.visible() == Visible::Both => Outlined::Plane,
            Equations::Ball { .. }
            | Equations::Disc { .. }
            | Equations::Rectangle { .. }
            | Equations::Triangle { .. }
            | Equations::Cylinder { extent: Extent::Infinite, .. }
            | Equations::Cone { extent: Extent::Infinite, .. } => Outlined::Side,
            Equations::Cuboid { .. } | Equations::Prism { .. } | Equations::Polyhedron { .. } => Outlined::Facets,
            Equations::Capsule { .. } | Equations::RoundCone { .. } | Equations::RoundedCuboid { .. } => {
                Outlined::Parts
            }
            Equations::Cylinder { extent: Extent::Capped(height), .. }
            | Equations::Cone { extent: Extent::Capped(height), .. } => between_caps([S::ZERO, height], eye),
            Equations::Revolved { meridian } if !meridian.has_waist && !meridian.is_open => {
                between_caps(meridian.heights, eye)
            }
            _ => Outlined::Other,
        }
    }
}

/// A solid of revolution with caps at these heights.
fn between_caps<S: Scalar>([low, high]: [S; 2], eye: Vec3<S>) -> Outlined {
    // Close to its plane a cap is seen at a grazing angle, and the eye's coordinates are rounded: a few units.
    let farthest = largest(eye.to_array());
    let unit = farthest.next_up().minus(farthest);
    let close = (0..8).fold(high.minus(low).scaled(-6), |close, _| close.plus(unit));
    match (eye.y < low.plus(close), eye.y > high.minus(close)) {
        (false, false) => Outlined::Side,
        (true, false) => Outlined::Cap(Part::Base),
        (false, true) => Outlined::Cap(Part::Top),
        (true, true) => Outlined::Other,
    }
}
