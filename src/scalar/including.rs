//! Number types that hold the values of others.

use super::{Scalar, UnitScalar};
#[cfg(feature = "fixed")]
use fixed::types::extra::{LeEqU32, LeEqU64, U32};
#[cfg(feature = "fixed")]
use fixed::{FixedI32, FixedI64};

/// A type that holds the values of `S`. The conversion is exact for `S` itself and for types of 32 bits.
pub trait Including<S: Scalar>: Scalar {
    /// A coordinate, size or parameter.
    fn exactly(value: S) -> Self;
    /// A component of a direction.
    fn unit_exactly(value: S::Unit) -> Self::Unit;
}

impl<S: Scalar> Including<S> for f64 {
    #[inline(always)]
    fn exactly(value: S) -> Self {
        value.to_f64()
    }
    #[inline(always)]
    fn unit_exactly(value: S::Unit) -> Self {
        value.to_f64()
    }
}

impl Including<Self> for f32 {
    #[inline(always)]
    fn exactly(value: Self) -> Self {
        value
    }
    #[inline(always)]
    fn unit_exactly(value: Self) -> Self {
        value
    }
}

#[cfg(feature = "fixed")]
impl<F: LeEqU64 + Send + Sync + 'static> Including<Self> for FixedI64<F> {
    #[inline(always)]
    fn exactly(value: Self) -> Self {
        value
    }
    #[inline(always)]
    fn unit_exactly(value: Self::Unit) -> Self::Unit {
        value
    }
}

/// With 32 fraction bits it holds all values of 32-bit types with any number of fraction bits.
#[cfg(feature = "fixed")]
impl<F: LeEqU32 + Send + Sync + 'static> Including<FixedI32<F>> for FixedI64<U32> {
    #[inline(always)]
    fn exactly(value: FixedI32<F>) -> Self {
        Self::from_bits((value.to_bits() as i64) << (32 - F::U32))
    }
    #[inline(always)]
    fn unit_exactly(value: <FixedI32<F> as super::Numbers>::Unit) -> Self::Unit {
        FixedI64::from_bits((value.to_bits() as i64) << 32)
    }
}

/// A value of [`GridScalar::Wider`](super::GridScalar::Wider) in the type of 32 bits: rounded to nearest, ties to even;
/// infinite beyond the type.
#[cfg(feature = "fixed")]
#[inline]
pub(super) fn narrowed<F: LeEqU32 + Send + Sync + 'static>(value: FixedI64<U32>) -> FixedI32<F> {
    let infinite = <FixedI32<F> as Scalar>::INFINITY;
    let (raw, shift) = (value.to_bits(), 32 - F::U32);
    // Ties to even, so that a ray in the opposite direction has the negated ends.
    let odd = (raw >> shift) & 1;
    let units = if shift == 0 { raw } else { raw.saturating_add((1 << (shift - 1)) - 1 + odd) >> shift };
    match i32::try_from(units) {
        Ok(units) if units.unsigned_abs() < i32::MAX as u32 => FixedI32::from_bits(units),
        _ if units < 0 => -infinite,
        _ => infinite,
    }
}

#[cfg(all(units, feature = "fixed"))]
#[path = "../../tests/units/scalar/including.rs"]
mod tests;
