//! Floor 1: numbers whose signs can be trusted, for the exact tier.
//!
//! | room | what it holds |
//! |---|---|
//! | `quick` | the first look of `f32`: doubles that keep the size of what went into them |
//! | `double` | the filter of `f32`: doubles that know their error |
//! | `wide` | the filter of the 32-bit fixed types: 128-bit blocks that know theirs |
//! | `integer` | what decides when the filter cannot tell |

use crate::scalar::{Real, Scalar};
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

#[cfg(feature = "libm")]
mod double;
mod integer;
#[cfg(feature = "libm")]
mod quick;
#[cfg(feature = "fixed")]
mod wide;

/// Limbs of an integer that holds every polynomial of the solvers over `f32`.
///
/// A coordinate spans 277 binary places; a local one, of which a row of an affine inverse is a factor, at most 690. The widest
/// polynomial is a frustum's discriminant `h^2 [(g1 wz - g0 dx)^2 + ...]`, of less than 3,900 places.
const FLOAT_LIMBS: usize = 128;
/// The same over 32-bit fixed types: a local coordinate has 66 places, and the rows of an affine inverse lie up to 124
/// apart; the discriminant spans some 640.
#[cfg(feature = "fixed")]
const FIXED_LIMBS: usize = 32;

/// A number of which the sign is either known for certain or not told.
///
/// Two kinds do: estimates, which know how far they may be off, and integers, which are never off.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// The kind in which quotients and square roots are taken.
    type Estimate: Estimate;

    const ZERO: Self;
    const ONE: Self;

    /// How it compares with zero; `None` if that cannot be told.
    fn sign(self) -> Option<Ordering>;
    /// A sum of products of which most may cancel.
    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let mut sum = Self::ZERO;
        for [a, b] in terms {
            sum = sum + a * b;
        }
        sum
    }
    /// `self * 2^e`, exactly.
    fn scaled(self, e: i32) -> Self;
    /// Three numbers divided by one power of two, and a fourth by its square, whichever keeps them in the estimate's range.
    fn together(values: [Self; 3], square: Self) -> ([Self::Estimate; 3], Self::Estimate);
}

/// An approximate number with a bound on its error.
pub trait Estimate: Number<Estimate = Self> {
    /// `self / other`; `other` must be known not to be zero.
    fn over(self, other: Self) -> Self;
    /// The square root of a number that is known not to be negative.
    fn square_root(self) -> Self;
}

/// A number made from a scalar, exactly.
pub trait FromScalar<S: Scalar>: Number {
    fn scalar(value: S) -> Self;
    fn unit(value: S::Unit) -> Self;
}

/// A scalar that has an exact tier.
pub trait Certain: Scalar {
    /// Whether there is a look that is quicker than the filter.
    const LOOKS_QUICKLY: bool;
    /// The number in double precision, for a type that it holds exactly and that a host computes with.
    #[inline(always)]
    fn in_double(self) -> Option<f64> {
        None
    }
    /// A number of the quick look, and the size of the terms that it is a sum of; `None` as for [`Certain::in_double`].
    #[inline(always)]
    fn in_doubles(_: Self::Quick) -> Option<[f64; 2]> {
        None
    }
    /// What is asked before the filter.
    type Quick: Number<Estimate = Self::Filter> + FromScalar<Self>;
    /// What decides nearly always.
    type Filter: Estimate + FromScalar<Self>;
    /// What decides when the filter cannot tell: wide enough for every polynomial of the solvers.
    type Integer: Number<Estimate = Self::Filter> + FromScalar<Self>;

    /// A plain number of twice the precision.
    type Double: Real;

    /// The exact value.
    fn double(self) -> Self::Double;
    /// The exact value of a component of a direction.
    fn double_unit(value: Self::Unit) -> Self::Double;
    /// A number of the scalar's own kind.
    fn double_real(value: Self::Real) -> Self::Double;
    /// Rounded to nearest; beyond the type's range, [`Scalar::INFINITY`] with the sign.
    fn from_double(value: Self::Double) -> Self;
    /// Rounded to nearest; `None` if the error is too large for that to be within one unit in the last place.
    fn rounded(value: Self::Filter) -> Option<Self>;
}

/// `a . b`
pub(crate) fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
