//! Errors in a scene file, with their place.

use crate::scene::camera::CameraError;
use core::fmt;

/// A place in a text. Lines and columns are counted from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Place {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
}

/// Why a text could not be read as a scene, and where reading stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NffError {
    /// The word at fault, or the end of the text.
    pub place: Place,
    /// What is wrong with it.
    pub reason: Reason,
}

/// An error in a scene file. The field `what` of a variant describes the value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Reason {
    /// A word that is not the name of an entity.
    UnknownEntity,
    /// A replacement character (U+FFFD), which `String::from_utf8_lossy` puts in place of bytes that are not UTF-8. In
    /// comments it is allowed.
    NotText,
    /// The text ends inside an entity.
    Ended {
        /// The value that should come next.
        what: &'static str,
    },
    /// A word that should be a number.
    NotANumber {
        /// The value that it should give.
        what: &'static str,
    },
    /// A number that should be whole and at least 1, and at most 65535 for a resolution or 2^32 - 1 for a count.
    NotACount {
        /// The value that it should give.
        what: &'static str,
    },
    /// A number that the number type cannot hold.
    BeyondType {
        /// The value that it gives.
        what: &'static str,
    },
    /// A coordinate or size beyond the [`Budget`](crate::scalar::Budget) of the number type.
    BeyondBudget {
        /// The value that it gives.
        what: &'static str,
    },
    /// A negative number where none is allowed.
    Negative {
        /// The value that it gives.
        what: &'static str,
    },
    /// A colour channel outside 0 to 1.
    Color {
        /// The value that it gives.
        what: &'static str,
    },
    /// A radius of zero.
    ZeroRadius {
        /// The value that it gives.
        what: &'static str,
    },
    /// A normal of length zero.
    ZeroNormal,
    /// One radius of a cone is negative and the other is not.
    MixedRadii,
    /// Both ends of a cone or cylinder are the same point.
    ZeroLength,
    /// A cone or cylinder that the number type cannot hold: too long, or too wide for its length.
    Proportions,
    /// Fewer than three corners.
    TooFewCorners,
    /// The text is too short for the number of corners of a polygon.
    EndsBeforeCorners {
        /// The number of corners in the text.
        corners: u32,
    },
    /// A polygon has more corners than [`Stores::corners`](super::Stores::corners).
    TooManyCorners {
        /// The length of that slice.
        room: usize,
    },
    /// A store is full.
    Full {
        /// The name of the store.
        store: &'static str,
    },
    /// A keyword of the view is missing.
    MissingInView {
        /// The keyword.
        keyword: &'static str,
    },
    /// A keyword of the view is given twice.
    TwiceInView {
        /// The keyword.
        keyword: &'static str,
    },
    /// No camera can be built from the values of the view.
    Camera(CameraError),
    /// A second view.
    SecondView,
    /// A second background.
    SecondBackground,
    /// The text has no view.
    NoView,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownEntity => f.write_str("this starts no entity: expected one of v, b, l, f, c, s, p, pp or #"),
            Self::NotText => f.write_str("this is no UTF-8 text: remove it, or move it into a comment behind a #"),
            Self::Ended { what } => write!(f, "the text ends where {what} should be: complete the entity"),
            Self::NotANumber { what } => write!(f, "{what} should be a number such as -12.5 or 1.5e-3"),
            Self::NotACount { what } => write!(f, "{what} should be a whole number, at least 1 and not too large"),
            Self::BeyondType { what } => {
                write!(f, "{what} is beyond the number type: give a smaller number or take a wider type")
            }
            Self::BeyondBudget { what } => {
                write!(
                    f,
                    "{what} is beyond the number type's budget: read the text at a smaller nff::Scale or take a wider \
                     type"
                )
            }
            Self::Negative { what } => write!(f, "{what} is negative: give 0 or more"),
            Self::Color { what } => write!(f, "{what} is outside 0 to 1"),
            Self::ZeroRadius { what } => write!(f, "{what} is zero: give a size, negative to show the inside only"),
            Self::ZeroNormal => f.write_str("a normal has the length zero: give it a direction"),
            Self::MixedRadii => {
                f.write_str("one radius is negative and the other is not: make both negative to show the inside only")
            }
            Self::ZeroLength => f.write_str("both ends of the cone or cylinder are the same point: move one"),
            Self::Proportions => f.write_str(
                "the cone or cylinder is too long, or too wide for its length, for the number type: take a wider type",
            ),
            Self::TooFewCorners => f.write_str("a polygon has at least three corners"),
            Self::EndsBeforeCorners { corners } => {
                write!(f, "the text ends before {corners} corners: correct their number")
            }
            Self::TooManyCorners { room } => {
                write!(f, "the polygon has more corners than there is room for ({room}): give more scratch corners")
            }
            Self::Full { store } => write!(f, "no more room for {store}: give their store a larger capacity"),
            Self::MissingInView { keyword } => write!(f, "the view ends here but lacks \"{keyword}\": add it"),
            Self::TwiceInView { keyword } => write!(f, "the view has \"{keyword}\" twice: remove one"),
            Self::Camera(error) => write!(f, "{error}"),
            Self::SecondView => f.write_str("a second view: a scene has one, remove the other"),
            Self::SecondBackground => f.write_str("a second background: a scene has one, remove the other"),
            Self::NoView => f.write_str("the text ends without a view: add a \"v\" entity"),
        }
    }
}

impl fmt::Display for NffError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.place.line, self.place.column, self.reason)
    }
}

impl core::error::Error for NffError {}
