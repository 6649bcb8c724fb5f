//! The parts of a surface.

/// A part of a primitive's surface, so that each can have a material of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// The curved side; the whole of a sphere, plane, disc or triangle. Owns its rims, its seams and the apex.
    Side,
    /// The cap or hemisphere at the lower end of the axis.
    Base,
    /// The cap or hemisphere at the upper end of the axis.
    Top,
}
