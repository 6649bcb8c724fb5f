//! What can be wrong with a value that a constructor is given.

use super::Scalar;
use core::fmt;

/// What is wrong with a number or a vector. The errors of constructors hold it, and name the value that it concerns.
///
/// ```
/// use fixed::types::I16F16;
/// use raylet::{SizeError, Sphere, ValueError};
/// // A unit of the type is 1.5e-5: a millionth is rounded to zero before a constructor sees it.
/// let error = Sphere::new(I16F16::from_num(1e-6)).unwrap_err();
/// assert_eq!(error, SizeError::Radius(ValueError::Zero));
/// assert_eq!(Sphere::new(-1.0_f32).unwrap_err().to_string(), "the radius is negative");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ValueError {
    /// It is NaN, infinite, or the value of a fixed type that stands for infinity ([`Scalar::INFINITY`]).
    NotFinite,
    /// It is below zero where only other values are allowed.
    Negative,
    /// It is zero where it must not be: it was given as zero, or was below one unit of the number type and rounded to
    /// zero.
    Zero,
    /// It is above zero and below the smallest value of its kind that the [`Budget`](super::Budget) allows.
    BelowBudget,
    /// Its magnitude is beyond the [`Budget`](super::Budget) of the number type.
    BeyondBudget,
    /// Its magnitude is beyond what the number type can hold.
    BeyondType,
    /// Its length is not 1.
    NotUnit,
    /// It is the zero vector, which has no direction.
    NoDirection,
}

impl ValueError {
    /// What is wrong with a size that is not between `least` and the largest of its kind.
    #[cold]
    pub(crate) fn of_size<S: Scalar>(size: S, least: S) -> Self {
        if !size.is_finite() {
            Self::NotFinite
        } else if size < S::ZERO {
            Self::Negative
        } else if size == S::ZERO {
            Self::Zero
        } else if size < least {
            Self::BelowBudget
        } else {
            Self::BeyondBudget
        }
    }

    /// What is wrong with a point or vector that is not within the budget.
    #[cold]
    pub(crate) fn of_point<S: Scalar>(components: [S; 3]) -> Self {
        if components.iter().all(|c| c.is_finite()) { Self::BeyondBudget } else { Self::NotFinite }
    }

    /// What is wrong with a vector that has no direction.
    #[cold]
    pub(crate) fn of_direction<S: Scalar>(components: [S; 3]) -> Self {
        if components.iter().all(|c| c.is_finite()) { Self::NoDirection } else { Self::NotFinite }
    }
}

/// The message of a fault after the name of the value, made without formatting, so that constants can have it.
macro_rules! with_fault {
    ($value:literal, $fault:expr) => {
        match $fault {
            $crate::ValueError::NotFinite => concat!($value, "is not finite"),
            $crate::ValueError::Negative => concat!($value, "is negative"),
            $crate::ValueError::Zero => {
                concat!($value, "is zero, or was below one unit of the number type and was rounded to zero")
            }
            $crate::ValueError::BelowBudget => {
                concat!($value, "is below the least that the number type's budget allows")
            }
            $crate::ValueError::BeyondBudget => concat!($value, "is beyond the number type's budget"),
            $crate::ValueError::BeyondType => concat!($value, "is beyond what the number type can hold"),
            $crate::ValueError::NotUnit => concat!($value, "has a length that is not 1"),
            $crate::ValueError::NoDirection => concat!($value, "has no direction: it is zero"),
        }
    };
}
pub(crate) use with_fault;

impl ValueError {
    /// The message, in a constant too.
    pub const fn message(self) -> &'static str {
        with_fault!("the value ", self)
    }

    /// The message without its subject, to be written after the name of the value.
    ///
    /// ```
    /// # use raylet::{UnitVec3, ValueError};
    /// let error = UnitVec3::<f32>::from_f64([0.0; 3]).unwrap_err();
    /// assert_eq!(error.to_string(), "the value has no direction: it is zero");
    /// assert_eq!(format!("the beam {}", error.predicate()), "the beam has no direction: it is zero");
    /// ```
    pub const fn predicate(self) -> &'static str {
        with_fault!("", self)
    }
}

impl fmt::Display for ValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for ValueError {}
