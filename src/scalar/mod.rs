//! The number types.
//!
//! A [`Scalar`] *stores* coordinates, sizes and distances. A [`Real`] *computes* points, normals, shading and the like,
//! and never overflows inside the [`Budget`]. For floats the two are the same type. For fixed point the [`Real`] is an
//! integer mantissa of twice the width with an exponent, so that products are exact and nothing is rounded before a
//! difference is computed.

// All code that depends on the number type is in this folder:
//
// | file | what it holds |
// |---|---|
// | `float` | `f32` and `f64` |
// | `error_free` | sums and products of floats with their rounding errors |
// | `fixed` | `FixedI32<F>` and `FixedI64<F>`, for every `F` |
// | `computing` | operations on stored numbers |
// | `grid` | what fixed-point types have besides: the interface of the grid |
// | `culling` | conservative tests that a ray misses |
// | `attempt` | results on the grid |
// | `integers` | the grid of fixed point: integers of a common unit |
// | `rungs`, `twofold` | conversion between stored numbers and those of `number`; numbers of twice the precision |
// | `summed` | numbers whose sums of products are rounded once |
// | `including` | types that hold the values of others |
// | `scanline` | the directions of the rays of a row of pixels |
// | `slabs` | conservative test of a ray against a box |
// | `block` | integer mantissa and exponent; square root and quotient of integers |
// | `decimal` | decimal text to fixed point, correctly rounded |
// | `elementary` | angle, sine, power, in integers for the fixed types |
// | `written` | how stored numbers are written for `serde` and `defmt` |
// | `constant` | the checks of constructors in constants |
// | `value` | what can be wrong with a value that a constructor is given |
// | `square_root` | the square root of `f32` by instruction, which `core` does not have |

use crate::gallery::Lists;
use crate::ladder::Tiers;
use crate::number::word::Word;
use crate::number::{Limbs, Number, Parts};
use crate::solve::Localize;
use core::fmt::Debug;
use core::ops::{Div, Neg};

mod attempt;
#[cfg(feature = "fixed")]
pub(crate) mod block;
mod computing;
pub(crate) mod constant;
mod culling;
#[cfg(feature = "fixed")]
mod decimal;
#[cfg(feature = "fixed")]
mod elementary;
#[cfg(feature = "libm")]
mod error_free;
#[cfg(feature = "fixed")]
mod fixed;
#[cfg(feature = "libm")]
mod float;
mod grid;
mod including;
mod integers;
mod rungs;
mod scanline;
pub(crate) mod slabs;
#[cfg(feature = "libm")]
mod square_root;
mod summed;
mod twofold;
mod value;
pub(crate) mod written;

pub use crate::number::Ring;
pub use value::ValueError;

pub(crate) use attempt::{Attempt, Crossed, InCuboid, InSide, found};
pub(crate) use computing::{Computing, Elementary, RoundLine, RoundSolid};
pub(crate) use culling::Culling;
pub(crate) use grid::{FinerLine, GridScalar, LocalLine};
pub(crate) use including::Including;
pub(crate) use integers::are_doubtful;
pub(crate) use rungs::{FromScalar, RealOf, ToScalar};
pub(crate) use scanline::Scanline;
pub(crate) use summed::Summed;
pub(crate) use twofold::Twofold;
pub(crate) use value::with_fault;

/// Seals [`Scalar`] and related traits, whose implementations depend on each other.
mod sealed {
    pub trait Sealed {}
}

/// The largest and smallest values that constructors accept for a number type.
///
/// Inside the budget no query overflows, except that terms of [`Plain`](crate::tier::Plain) in floats may be infinite.
/// Outside it constructors return an error.
///
/// # Floats
///
/// | type | coordinate | size | slope | distance |
/// |---|---|---|---|---|
/// | `f32` | 2^126 | smallest subnormal to 2^126 | 2^-30 to 2^30 | 2^128 - 2^104 (largest finite) |
/// | `f64` | 2^1022 | smallest subnormal to 2^1022 | 2^-200 to 2^200 | largest finite |
///
/// The coordinate is a quarter of the largest finite float, so that the difference of two points is finite.
/// The robust number has a larger exponent, so that the square of no size inside the budget underflows.
///
/// # Fixed point
///
/// | type | coordinate and size | distance | unit |
/// |---|---|---|---|
/// | `FixedI32<F>` | 2^(30-F) | 2^(31-F) less 2 units | 2^-F |
/// | `FixedI64<F>` | 2^(62-F) | 2^(63-F) less 2 units | 2^-F |
///
/// | e.g. | coordinate and size | distance | unit |
/// |---|---|---|---|
/// | `I8F24` | 64 | 127.99999 | 6.0e-8 |
/// | `I16F16` | 16384 | 32767.99997 | 1.5e-5 |
/// | `I20F12` | 262144 | 524287.9995 | 2.4e-4 |
/// | `I32F32` | 1.07e9 | 2.147e9 | 2.3e-10 |
///
/// The coordinate is half of the type's range, so that the difference of two coordinates is a value of the type;
/// the raw numbers stay below 2^31, so that a coordinate times a direction (30 fraction bits), summed over
/// three axes, stays below 2^62 and is exact in 64 bits.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct Budget<S> {
    /// Largest magnitude of a coordinate.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub coordinate: S,
    /// Largest radius or height.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub size: S,
    /// Smallest radius (and smallest height where a height of zero is no solid).
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub smallest_size: S,
    /// Largest slope of a cone, radius over height.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub slope: S,
    /// Smallest slope of a cone.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub smallest_slope: S,
    /// Largest `t`. Hits beyond it are outside every range.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub distance: S,
}

/// The types that belong to a scalar.
pub trait Numbers:
    Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
    + sealed::Sealed
    + written::Written
{
    /// The type of components of unit vectors and of colour channels: the float itself, Q2.30 for 32-bit and Q2.62 for
    /// 64-bit fixed types.
    type Unit: UnitScalar;
    /// The number to compute in.
    type Real: Real + written::ForSerde;
}

/// The type of a direction's components that belongs to the coordinate type `S`.
pub type Unit<S> = <S as Numbers>::Unit;

/// A number that stores coordinates, sizes and distances.
///
/// Implemented for `f32`, `f64`, `FixedI32<F>` and `FixedI64<F>` for every `F` that `fixed` allows. Sealed.
pub trait Scalar: Numbers + Computing + Elementary + Culling + Lists {
    /// The number in which the solver computes where the grid is unsure.
    // What is hidden is for the solvers, in whose numbers no user computes.
    #[doc(hidden)]
    type Robust: Localize<Self> + Number<Estimate = Self::Robust> + ToScalar<Self>;
    /// The lists of numbers of the tiers.
    #[doc(hidden)]
    type Tiers: Tiers<Self>;
    /// How the directions of a row of pixels are computed.
    #[doc(hidden)]
    type Scanline: Scanline<Self>;
    /// Zero.
    const ZERO: Self;
    /// One, rounded to the type: [`Scalar::INFINITY`] for a fixed type that cannot hold it.
    const ROUNDED_ONE: Self;
    /// Beyond every range: `f32::INFINITY`, or the largest raw value of a fixed type.
    const INFINITY: Self;
    /// True if precision is relative to the magnitude (floats), so that a change of scale loses no precision.
    const RELATIVE: bool;
    /// The values that constructors accept.
    const BUDGET: Budget<Self>;
    /// False for NaN and for [`Scalar::INFINITY`] of either sign.
    fn is_finite(self) -> bool;
    /// The exact value: sign, integer and exponent.
    #[doc(hidden)]
    fn parts(self) -> Parts;
    /// The exact value of a unit component.
    #[doc(hidden)]
    fn unit_parts(value: Self::Unit) -> Parts;
    /// Rounded to nearest, ties to even; beyond the type's range, [`Scalar::INFINITY`] with the sign.
    #[doc(hidden)]
    fn from_limbs<W: Word>(value: Limbs<W>) -> Self;
    /// Rounded as [`Scalar::from_limbs`].
    #[doc(hidden)]
    fn from_robust(value: Self::Robust) -> Self;
    /// Rounded as [`Scalar::from_limbs`], to a unit component.
    #[doc(hidden)]
    fn unit_from_robust(value: Self::Robust) -> Self::Unit;
    /// Rounded as [`Scalar::from_limbs`], to a unit component.
    #[doc(hidden)]
    fn unit_from_limbs<W: Word>(value: Limbs<W>) -> Self::Unit;
    /// The exponent of the last place of values below `2^top`.
    #[doc(hidden)]
    fn last_place(top: i32) -> i32;
    /// The exact value, to compute with.
    fn real(self) -> Self::Real;
    /// Rounded to nearest; beyond the type's range, [`Scalar::INFINITY`] with the sign.
    fn round(value: Self::Real) -> Self;
    /// The exact value of a unit component.
    fn unit_real(value: Self::Unit) -> Self::Real;
    /// Rounded to nearest, saturated at the limits of the unit type.
    fn unit_round(value: Self::Real) -> Self::Unit;
    /// `self + other`, saturated to [`Scalar::INFINITY`].
    fn plus(self, other: Self) -> Self;
    /// `self - other`, saturated to [`Scalar::INFINITY`].
    fn minus(self, other: Self) -> Self;
    /// The next larger value, for bounds that must not be too small.
    fn next_up(self) -> Self;
    /// The magnitude.
    fn magnitude(self) -> Self;
    /// A decimal number such as `-12.5` or `1.5e-3`, correctly rounded to nearest, ties to even.
    ///
    /// `None` if the text is no number or its magnitude is beyond the type's range.
    fn parse(text: &str) -> Option<Self> {
        Self::parse_scaled(text, 0)
    }
    /// A decimal number times `2^power`, correctly rounded to nearest, ties to even. It is rounded only once, after the
    /// multiplication.
    ///
    /// As [`Scalar::parse`]; `None` also if a fixed type's fraction bits and the power add up to less than 0 or more
    /// than 64.
    fn parse_scaled(text: &str, power: i32) -> Option<Self>;
    /// The nearest value to an `f64`, for tools on the host.
    ///
    /// # Errors
    ///
    /// [`ValueError::NotFinite`], or [`ValueError::BeyondType`] beyond the type's range. A value below half a unit
    /// becomes zero.
    fn from_f64(value: f64) -> Result<Self, ValueError>;
    /// The value as an `f64`, for tools on the host; rounded for 64-bit fixed types.
    fn to_f64(self) -> f64;
}

/// A component of a unit vector or a colour channel. Sealed.
pub trait UnitScalar:
    Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
    + sealed::Sealed
    + written::Written
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;

    /// `self + other`, saturated (fixed: at nearly 2).
    fn plus(self, other: Self) -> Self;
    /// `self - other`, saturated.
    fn minus(self, other: Self) -> Self;
    /// `self * other`, rounded to nearest.
    fn times(self, other: Self) -> Self;
    /// The nearest of `0, 1 / levels, 2 / levels, ... 1`, as its index; values outside are clamped.
    fn level(self, levels: u16) -> u16;
    /// The value in 65536ths, rounded down and clamped to `[0, 1]`. Equal values give equal results in every type.
    fn in_65536ths(self) -> u32;
    /// The nearest value to an `f64`, saturated; NaN gives zero.
    fn from_f64(value: f64) -> Self;
    /// The value as an `f64`.
    fn to_f64(self) -> f64;
}

/// A number to compute in: a float, or a block-floating integer. Sealed.
///
/// No operation overflows for operands that come from values inside the [`Budget`]. For fixed types sums,
/// differences and products of stored values are exact as long as their bits fit the double width.
pub trait Real:
    Ring + Debug + PartialEq + PartialOrd + Div<Output = Self> + Send + Sync + 'static + sealed::Sealed
{
    /// The relative rounding error of a product is at most `2^ROUNDING`.
    #[doc(hidden)]
    const ROUNDING: i32;
    /// True for a float, false for a block-floating integer, whose operations are function calls.
    #[doc(hidden)]
    const IS_FLOAT: bool;
    /// True if the target has instructions for it; if not, each operation is a function call.
    #[doc(hidden)]
    const HAS_INSTRUCTIONS: bool;
    /// Above every number of a solver.
    #[doc(hidden)]
    const INFINITY: Self;
    /// The smallest normal float; zero for a block, which does not underflow.
    #[doc(hidden)]
    const SMALLEST: Self;

    /// A small integer.
    fn from_int(n: i32) -> Self;
    /// The square root; zero for a negative number.
    fn sqrt(self) -> Self;
    /// The number as a sum of two with half of its bits each, whose products with others of half the bits are exact.
    #[doc(hidden)]
    #[inline(always)]
    fn split(self) -> [Self; 2] {
        [self, Self::ZERO]
    }
    /// The rounded sum, and its rounding error (the low word of a double-word).
    #[doc(hidden)]
    #[inline(always)]
    fn plus_with_rest(self, other: Self) -> [Self; 2] {
        Self::sum_with_rest([[self, Self::ONE], [other, Self::ONE]])
    }
    /// The rounded product, and its rounding error (the low word of a double-word).
    #[doc(hidden)]
    #[inline(always)]
    fn times_with_rest(self, other: Self) -> [Self; 2] {
        Self::sum_with_rest([[self, other]])
    }
    /// The sum of products as a double-word, a rounded value and a low word: about twice the working precision, so that
    /// cancellation loses no accuracy ("Dot2": Ogita, Rump, Oishi, *Accurate Sum and Dot Product*, 2005).
    #[doc(hidden)]
    fn sum_with_rest<const N: usize>(terms: [[Self; 2]; N]) -> [Self; 2];
    /// The sum of products, even if it cancels, with little more error than that of one rounding.
    #[doc(hidden)]
    #[inline]
    fn sum_of_products<const N: usize>(terms: [[Self; 2]; N]) -> Self {
        let [sum, _] = Self::sum_with_rest(terms);
        sum
    }
    /// The magnitude.
    fn abs(self) -> Self;
    /// True below zero.
    fn is_negative(self) -> bool;
    /// True at zero.
    fn is_zero(self) -> bool;
}

/// The largest magnitude of some values.
pub(crate) fn largest<S: Scalar, const N: usize>(values: [S; N]) -> S {
    let mut largest = S::ZERO;
    for value in values {
        let magnitude = value.magnitude();
        if magnitude > largest {
            largest = magnitude;
        }
    }
    largest
}

/// The coordinate, clamped to the limit if it is infinite: infinities of opposite sign would add up to NaN.
pub(crate) fn clamped<S: Scalar>(coordinate: S, limit: S) -> S {
    if coordinate.is_finite() {
        coordinate
    } else if coordinate < S::ZERO {
        -limit
    } else {
        limit
    }
}

/// True if a decimal number is zero before any rounding: if its mantissa has no digit but 0.
pub(crate) fn is_zero_decimal(text: &str) -> bool {
    let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
    !mantissa.bytes().any(|byte| matches!(byte, b'1'..=b'9'))
}

/// True for an optional sign, digits with at most one point, and an optional decimal exponent. Every scalar parses this
/// syntax and no other: `inf` and `1_000` are not numbers.
pub(crate) fn is_decimal(text: &str) -> bool {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).unwrap_or((unsigned, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    digits(whole)
        && digits(fraction)
        && digits(exponent)
        && !exponent.is_empty()
        && !(whole.is_empty() && fraction.is_empty())
}
