//! Why a part of a range sensor cannot be built.

use core::fmt;

/// Why a part of a range sensor cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SensorError {
    /// The least distance is negative or not finite.
    Least,
    /// The greatest distance is not above the least, or is beyond the budget.
    Greatest,
    /// The separation of returns is negative or not finite.
    Separation,
    /// A standard deviation is negative or not finite.
    Deviation,
    /// There is no row of zones, or no column.
    NoZone,
    /// There are more rays than room for them.
    Room,
    /// The angle of a sensor with zones is not between 0 and 180 degrees, or too near to either for the number type.
    Angle,
    /// A sweep has fewer than two beams.
    Beams,
    /// The angle of a sweep is not positive, or more than a whole turn.
    Sweep,
}

impl SensorError {
    /// The message.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Least => "a sensor's least distance must be zero or more",
            Self::Greatest => {
                "a sensor's greatest distance must be above its least, and within the number type's budget"
            }
            Self::Separation => "the separation of a sensor's returns must be zero or more",
            Self::Deviation => "a standard deviation must be zero or more",
            Self::NoZone => "a sensor must have at least one row and one column of zones",
            Self::Room => "the fan has no room for the rays of all zones: give it a larger capacity",
            Self::Angle => "the angle of a sensor's zones must lie between 0 and 180 degrees",
            Self::Beams => "a sweep must have at least two beams",
            Self::Sweep => "the angle of a sweep must be above 0, and at most 360 degrees",
        }
    }
}

impl fmt::Display for SensorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for SensorError {}
