//! The number types as NumPy has them.

use fixed::types::I16F16;
use raylet::scalar::Unit;
use raylet::{Exact, Scalar, Stable, Tier};

/// A number of an array.
pub trait Number: numpy::Element + Copy + Send + Sync + Default {
    /// The number type of the library.
    type Scalar: Scalar + Send + Sync;
    /// Its best tier, and whether that is `Exact`.
    type Best: Tier<Self::Scalar>;
    const HAS_EXACT: bool;
    /// What stands for a miss.
    const NONE: Self;

    fn scalar(self) -> Self::Scalar;
    fn from_scalar(scalar: Self::Scalar) -> Self;
    /// A component of a unit vector.
    fn from_unit(unit: Unit<Self::Scalar>) -> Self;
}

impl Number for f32 {
    type Scalar = f32;
    type Best = Exact;
    const HAS_EXACT: bool = true;
    const NONE: Self = f32::NAN;

    fn scalar(self) -> f32 {
        self
    }
    fn from_scalar(scalar: f32) -> Self {
        scalar
    }
    fn from_unit(unit: f32) -> Self {
        unit
    }
}

impl Number for f64 {
    type Scalar = f64;
    type Best = Stable;
    const HAS_EXACT: bool = false;
    const NONE: Self = f64::NAN;

    fn scalar(self) -> f64 {
        self
    }
    fn from_scalar(scalar: f64) -> Self {
        scalar
    }
    fn from_unit(unit: f64) -> Self {
        unit
    }
}

/// `I16F16` as its bits.
impl Number for i32 {
    type Scalar = I16F16;
    type Best = Exact;
    const HAS_EXACT: bool = true;
    const NONE: Self = i32::MIN;

    fn scalar(self) -> I16F16 {
        I16F16::from_bits(self)
    }
    fn from_scalar(scalar: I16F16) -> Self {
        scalar.to_bits()
    }
    fn from_unit(unit: Unit<I16F16>) -> Self {
        unit.to_bits()
    }
}
