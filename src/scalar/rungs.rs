//! Conversion of stored numbers to the computing numbers of [`crate::number`], and back.

use super::{Scalar, Twofold, UnitScalar};
use crate::number::word::Word;
use crate::number::{Bounded, Estimate, Filtered, Integer, Ring, Robust, Rounded};

/// A number made from a scalar, exactly.
pub trait FromScalar<S: Scalar>: Ring {
    /// A coordinate, size or parameter.
    fn scalar(value: S) -> Self;
    /// A component of a direction.
    fn unit(value: S::Unit) -> Self;
}

/// A number that rounds to a scalar.
pub trait ToScalar<S: Scalar>: Estimate {
    /// True if the rounded value of a parameter decides whether it is in a range; false if its exact value does.
    const ROUNDING_DECIDES: bool;
    /// Rounded to nearest, [`Scalar::INFINITY`] with its sign beyond the type; `None` if the error is too large for the result to be
    /// within one unit in the last place.
    fn rounded(self) -> Option<S>;
}

impl<S: Scalar, W: Word> FromScalar<S> for Robust<W> {
    #[inline]
    fn scalar(value: S) -> Self {
        Self::of(value.parts())
    }
    #[inline]
    fn unit(value: S::Unit) -> Self {
        Self::of(S::unit_parts(value))
    }
}

impl<S: Scalar, W: Word> ToScalar<S> for Robust<W> {
    const ROUNDING_DECIDES: bool = true;

    #[inline]
    fn rounded(self) -> Option<S> {
        Some(S::from_limbs(self))
    }
}

impl<S: Scalar, W: Word> FromScalar<S> for Bounded<W> {
    #[inline]
    fn scalar(value: S) -> Self {
        Self::of(value.parts())
    }
    #[inline]
    fn unit(value: S::Unit) -> Self {
        Self::of(S::unit_parts(value))
    }
}

impl<S: Scalar, W: Word> ToScalar<S> for Bounded<W> {
    const ROUNDING_DECIDES: bool = false;

    #[inline]
    fn rounded(self) -> Option<S> {
        self.within(part_of_a_unit::<S>).map(S::from_limbs)
    }
}

impl<S: Scalar, const N: usize> FromScalar<S> for Integer<N> {
    fn scalar(value: S) -> Self {
        Self::of(value.parts())
    }
    fn unit(value: S::Unit) -> Self {
        Self::of(S::unit_parts(value))
    }
}

/// For types of at most 32 bits: a double holds what they store.
impl<S: Scalar> FromScalar<S> for Filtered {
    #[inline(always)]
    fn scalar(value: S) -> Self {
        Self::of(value.to_f64())
    }
    #[inline(always)]
    fn unit(value: S::Unit) -> Self {
        Self::of(value.to_f64())
    }
}

/// As for [`Filtered`].
impl<S: Scalar> FromScalar<S> for Rounded {
    #[inline(always)]
    fn scalar(value: S) -> Self {
        Self::of(value.to_f64())
    }
    #[inline(always)]
    fn unit(value: S::Unit) -> Self {
        Self::of(value.to_f64())
    }
}

impl<S: Scalar> ToScalar<S> for Rounded {
    const ROUNDING_DECIDES: bool = false;

    #[inline(always)]
    fn rounded(self) -> Option<S> {
        let value = self.within(part_of_a_unit::<S>)?;
        let beyond = if value < 0.0 { -S::INFINITY } else { S::INFINITY };
        Some(S::from_f64(value).unwrap_or(beyond))
    }
}

impl<S: Scalar> FromScalar<S> for Twofold<S::Real> {
    #[inline(always)]
    fn scalar(value: S) -> Self {
        Self::of(value.real())
    }
    #[inline(always)]
    fn unit(value: S::Unit) -> Self {
        Self::of(S::unit_real(value))
    }
}

/// The exponent of a 64th of a unit, for values below `2^top`.
fn part_of_a_unit<S: Scalar>(top: i32) -> i32 {
    S::last_place(top) - 6
}
