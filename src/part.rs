//! The parts of a surface.

/// A part of a primitive's surface. Each part can have a material of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// The curved side, or the whole surface of a sphere, plane, disc or triangle. Rims, seams and the apex belong to it.
    Side,
    /// The cap or hemisphere at the lower end of the axis.
    Base,
    /// The cap or hemisphere at the upper end of the axis.
    Top,
}
