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
    /// The cap, or the part of a ball, at the lower end of the axis; the lowest face of a cuboid or a prism.
    Base,
    /// The cap, or the part of a ball, at the upper end of the axis; the highest face of a cuboid or a prism.
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
    /// The face of a prism over the edge from its first corner to the second, or that of the first half-space of a
    /// polyhedron; the others are numbered in turn.
    Facet0,
    /// Facet 1 of a prism or a polyhedron.
    Facet1,
    /// Facet 2 of a prism or a polyhedron.
    Facet2,
    /// Facet 3 of a prism or a polyhedron.
    Facet3,
    /// Facet 4 of a prism or a polyhedron.
    Facet4,
    /// Facet 5 of a prism or a polyhedron.
    Facet5,
    /// Facet 6 of a prism or a polyhedron.
    Facet6,
    /// Facet 7 of a prism or a polyhedron.
    Facet7,
    /// Facet 8 of a prism or a polyhedron.
    Facet8,
    /// Facet 9 of a prism or a polyhedron.
    Facet9,
    /// Facet 10 of a prism or a polyhedron.
    Facet10,
    /// Facet 11 of a prism or a polyhedron.
    Facet11,
    /// Facet 12 of a prism or a polyhedron.
    Facet12,
    /// Facet 13 of a prism or a polyhedron.
    Facet13,
    /// Facet 14 of a prism or a polyhedron.
    Facet14,
    /// Facet 15 of a prism or a polyhedron.
    Facet15,
}

impl Part {
    /// Every part.
    pub const EVERY: [Self; 24] = [
        Self::Side,
        Self::Base,
        Self::Top,
        Self::Left,
        Self::Right,
        Self::Back,
        Self::Front,
        Self::Inner,
        Self::Facet0,
        Self::Facet1,
        Self::Facet2,
        Self::Facet3,
        Self::Facet4,
        Self::Facet5,
        Self::Facet6,
        Self::Facet7,
        Self::Facet8,
        Self::Facet9,
        Self::Facet10,
        Self::Facet11,
        Self::Facet12,
        Self::Facet13,
        Self::Facet14,
        Self::Facet15,
    ];

    /// The facet of this number; `None` if it is 16 or more.
    ///
    /// ```
    /// use raylet::Part;
    /// assert_eq!(Part::facet(2), Some(Part::Facet2));
    /// assert_eq!(Part::facet(16), None);
    /// ```
    pub const fn facet(number: usize) -> Option<Self> {
        let first = Self::Facet0 as usize;
        if number < Self::EVERY.len() - first { Some(Self::EVERY[first + number]) } else { None }
    }

    /// All facets, in order.
    #[inline]
    pub(crate) fn facets() -> impl Iterator<Item = Self> + Clone {
        Self::EVERY.into_iter().filter(|part| part.facet_number().is_some())
    }

    /// The number of a facet; `None` for any other part.
    pub const fn facet_number(self) -> Option<usize> {
        (self as usize).checked_sub(Self::Facet0 as usize)
    }
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
