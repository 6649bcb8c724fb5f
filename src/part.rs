//! The parts of a surface.

/// A part of a primitive's surface. Each part can have its own material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// The curved side, or the whole surface of a sphere, plane, disc, rectangle or triangle. Rims, seams and the apex
    /// belong to it.
    Side,
    /// The cap or hemisphere at the lower end of the axis; the lowest face of a cuboid.
    Base,
    /// The cap or hemisphere at the upper end of the axis; the highest face of a cuboid.
    Top,
    /// The face of a cuboid at the lowest `x`.
    Left,
    /// The face of a cuboid at the highest `x`.
    Right,
    /// The face of a cuboid at the lowest `z`.
    Back,
    /// The face of a cuboid at the highest `z`.
    Front,
}

/// The faces of a cuboid perpendicular to the axes x, z and y, at the negative and the positive half extent.
///
/// Faces own shared edges and corners in this order of the axes: an edge or a corner belongs to the first of its faces.
/// The four side faces thus own their edges with base and top, as the side of a cylinder owns its rims.
pub(crate) const FACES: [[Part; 2]; 3] =
    [[Part::Left, Part::Right], [Part::Back, Part::Front], [Part::Base, Part::Top]];
