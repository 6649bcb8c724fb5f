//! The parts of a surface.

use core::cmp::Ordering;

/// A part of a primitive's surface. Each part can have its own material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// The curved side, or the whole surface of a sphere, plane, disc, annulus, rectangle or triangle. Rims, seams and
    /// the apex belong to it. Of a rounded cuboid its edges and corners, without the seams.
    Side,
    /// The cap, or the part of a ball, at the lower end of the axis; the lowest face of a cuboid.
    Base,
    /// The cap, or the part of a ball, at the upper end of the axis; the highest face of a cuboid.
    Top,
    /// The face of a cuboid at the lowest `x`.
    Left,
    /// The face of a cuboid at the highest `x`.
    Right,
    /// The face of a cuboid at the lowest `z`.
    Back,
    /// The face of a cuboid at the highest `z`.
    Front,
    /// The inner side of a tube. Its rims belong to it.
    Inner,
}

impl Part {
    /// Every part.
    pub const EVERY: [Self; 8] =
        [Self::Side, Self::Base, Self::Top, Self::Left, Self::Right, Self::Back, Self::Front, Self::Inner];
}

/// The face of a cuboid perpendicular to this axis, on this side.
pub(crate) const fn face_of(axis: usize, side: Ordering) -> Part {
    let [across_x, across_z, across_y] = FACES;
    let [low, high] = match axis {
        0 => across_x,
        1 => across_y,
        _ => across_z,
    };
    if matches!(side, Ordering::Less) { low } else { high }
}

/// The faces of a cuboid perpendicular to the axes x, z and y, at the negative and the positive half extent.
///
/// Faces own shared edges and corners in this order of the axes: an edge or a corner belongs to the first of its faces.
/// The four side faces thus own their edges with base and top, as the side of a cylinder owns its rims.
pub(crate) const FACES: [[Part; 2]; 3] =
    [[Part::Left, Part::Right], [Part::Back, Part::Front], [Part::Base, Part::Top]];
