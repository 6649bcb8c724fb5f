//! The number types as C has them.

use fixed::FixedI32;
use fixed::types::I16F16;
use fixed::types::extra::U30;
use raylet::ExactScalar;
use raylet::scalar::Unit;

/// A fixed-point number: an integer in units of 2^-16 (`I16F16`). The unit of directions is 2^-30: components of
/// directions and normals, and surface coordinates, are in that. (In `float` both are 1.)
pub type i16f16 = i32;

/// A number as C passes it.
pub trait Number: Copy + 'static {
    /// The number type of the library.
    type Scalar: ExactScalar;

    /// From C.
    fn scalar(self) -> Self::Scalar;
    /// To C.
    fn from_scalar(scalar: Self::Scalar) -> Self;
    /// A component of a unit vector from C.
    fn unit(self) -> Unit<Self::Scalar>;
    /// A component of a unit vector to C.
    fn from_unit(unit: Unit<Self::Scalar>) -> Self;
}

impl Number for f32 {
    type Scalar = f32;

    fn scalar(self) -> f32 {
        self
    }
    fn from_scalar(scalar: f32) -> Self {
        scalar
    }
    fn unit(self) -> f32 {
        self
    }
    fn from_unit(unit: f32) -> Self {
        unit
    }
}

impl Number for i16f16 {
    type Scalar = I16F16;

    fn scalar(self) -> I16F16 {
        I16F16::from_bits(self)
    }
    fn from_scalar(scalar: I16F16) -> Self {
        scalar.to_bits()
    }
    fn unit(self) -> FixedI32<U30> {
        FixedI32::from_bits(self)
    }
    fn from_unit(unit: FixedI32<U30>) -> Self {
        unit.to_bits()
    }
}

/// The scalar of a number.
pub type Of<N> = <N as Number>::Scalar;
