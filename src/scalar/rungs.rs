//! Conversion of stored numbers to the computing numbers of [`crate::number`], and back.

use super::{Real, Scalar, Twofold, UnitScalar};
#[cfg(feature = "libm")]
use crate::number::Filtered;
use crate::number::word::Word;
use crate::number::{Bounded, Doubled, Estimate, Guarded, Integer, Plain, Ring, Robust, Running};

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
    /// A parameter, exactly.
    fn of(value: S) -> Self;
    /// The parameter of the ray for one of a line whose origin was moved to `start`.
    #[inline(always)]
    fn whole(self, start: Option<Self>) -> Self {
        match start {
            Some(start) => self + start,
            None => self,
        }
    }
    /// Rounded to nearest, [`Scalar::INFINITY`] with its sign beyond the type; `None` if the error is too large for the
    /// result to be within one unit in the last place.
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
    fn of(value: S) -> Self {
        Self::of(value.parts())
    }
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
    fn of(value: S) -> Self {
        Self::of(value.parts())
    }
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
#[cfg(feature = "libm")]
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

/// A real number in which those of a scalar type are computed: the type's own, or a wider one.
pub trait RealOf<S: Scalar>: Real {
    /// A coordinate, size or parameter, exactly.
    fn of(value: S) -> Self;
    /// A component of a direction, exactly.
    fn of_unit(value: S::Unit) -> Self;
    /// Rounded to nearest, [`Scalar::INFINITY`] with its sign beyond the type.
    fn rounded(self) -> S;
}

#[cfg(feature = "libm")]
impl RealOf<f32> for f32 {
    #[inline(always)]
    fn of(value: f32) -> Self {
        value
    }
    #[inline(always)]
    fn of_unit(value: f32) -> Self {
        value
    }
    #[inline(always)]
    fn rounded(self) -> f32 {
        self
    }
}

/// For `f64` itself, and for types of at most 32 bits.
#[cfg(feature = "libm")]
impl<S: Scalar> RealOf<S> for f64 {
    #[inline(always)]
    fn of(value: S) -> Self {
        value.to_f64()
    }
    #[inline(always)]
    fn of_unit(value: S::Unit) -> Self {
        value.to_f64()
    }
    #[inline(always)]
    fn rounded(self) -> S {
        S::from_f64(self).unwrap_or(if self < 0.0 { -S::INFINITY } else { S::INFINITY })
    }
}

#[cfg(feature = "fixed")]
impl<F: fixed::types::extra::LeEqU32 + Send + Sync + 'static> RealOf<fixed::FixedI32<F>> for super::block::Block64 {
    #[inline(always)]
    fn of(value: fixed::FixedI32<F>) -> Self {
        value.real()
    }
    #[inline(always)]
    fn of_unit(value: <fixed::FixedI32<F> as super::Numbers>::Unit) -> Self {
        fixed::FixedI32::<F>::unit_real(value)
    }
    #[inline(always)]
    fn rounded(self) -> fixed::FixedI32<F> {
        Scalar::round(self)
    }
}

#[cfg(feature = "fixed")]
impl<F: fixed::types::extra::LeEqU64 + Send + Sync + 'static> RealOf<fixed::FixedI64<F>> for super::block::Block128 {
    #[inline(always)]
    fn of(value: fixed::FixedI64<F>) -> Self {
        value.real()
    }
    #[inline(always)]
    fn of_unit(value: <fixed::FixedI64<F> as super::Numbers>::Unit) -> Self {
        fixed::FixedI64::<F>::unit_real(value)
    }
    #[inline(always)]
    fn rounded(self) -> fixed::FixedI64<F> {
        Scalar::round(self)
    }
}

impl<S: Scalar, R: RealOf<S>> FromScalar<S> for Plain<R> {
    #[inline(always)]
    fn scalar(value: S) -> Self {
        Self(R::of(value))
    }
    #[inline(always)]
    fn unit(value: S::Unit) -> Self {
        Self(R::of_unit(value))
    }
}

impl<S: Scalar, R: RealOf<S>> ToScalar<S> for Plain<R> {
    const ROUNDING_DECIDES: bool = true;

    #[inline(always)]
    fn of(value: S) -> Self {
        Self(R::of(value))
    }
    #[inline(always)]
    fn rounded(self) -> Option<S> {
        Some(self.0.rounded())
    }
}

impl<S: Scalar, R: RealOf<S>, const STABLE: bool> FromScalar<S> for Guarded<R, STABLE> {
    #[inline(always)]
    fn scalar(value: S) -> Self {
        Self(Plain::scalar(value))
    }
    #[inline(always)]
    fn unit(value: S::Unit) -> Self {
        Self(Plain::unit(value))
    }
}

impl<S: Scalar, R: RealOf<S>, const STABLE: bool> FromScalar<S> for Running<R, STABLE> {
    #[inline(always)]
    fn scalar(value: S) -> Self {
        Self::exact(R::of(value))
    }
    #[inline(always)]
    fn unit(value: S::Unit) -> Self {
        Self::exact(R::of_unit(value))
    }
}

/// In doubles the exact value of a parameter of a narrower type decides, and has so many bits that its rounding does
/// not matter.
impl<S: Scalar, R: RealOf<S>, const STABLE: bool> ToScalar<S> for Running<R, STABLE> {
    const ROUNDING_DECIDES: bool = size_of::<S>() == size_of::<R>();

    #[inline(always)]
    fn of(value: S) -> Self {
        Self::exact(R::of(value))
    }
    #[inline(always)]
    fn whole(self, start: Option<Self>) -> Self {
        match start {
            // A missing end has no error, which a sum of infinities would lose.
            Some(start) if self.value.abs() < R::INFINITY => self + start,
            _ => self,
        }
    }
    #[inline(always)]
    fn rounded(self) -> Option<S> {
        // A unit in the last place is between one and two roundings of the value. Bounds are a few times as large as
        // errors.
        let most = match (<Self as ToScalar<S>>::ROUNDING_DECIDES, STABLE) {
            (true, true) => R::from_int(32),
            (true, false) => R::ONE.scaled(-R::ROUNDING - 12),
            (false, _) => R::ONE.scaled(22),
        };
        // Not the comparison of the two, since both may be infinite.
        (self.value.abs() * most - self.error >= R::ZERO).then(|| self.value.rounded())
    }
}

impl<S: Scalar, R: RealOf<S>> FromScalar<S> for Doubled<R> {
    #[inline(always)]
    fn scalar(value: S) -> Self {
        Self::exact(R::of(value))
    }
    #[inline(always)]
    fn unit(value: S::Unit) -> Self {
        Self::exact(R::of_unit(value))
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
