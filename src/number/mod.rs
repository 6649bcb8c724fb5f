//! The numbers that solvers compute in.
//!
//! A solver is generic over a [`Number`] whose sign may be unknown. It runs in the cheapest number first. If that does
//! not know a sign, the solver runs again in the next:
//!
//! | number | sign | used by |
//! |---|---|---|
//! | [`Plain`] | that of the rounded value | `Plain` |
//! | [`Guarded`] | the same, unknown where much of a difference cancels | `Fast` |
//! | stable [`Guarded`] | the same, and an end next to the start is unknown | `Stable`, for spheres, triangles and flat parts in the world |
//! | [`Running`] | unknown if the value is within its error bound of zero | `Stable`, and in doubles `Exact` |
//! | [`Robust`] | that of the rounded value | `Fast` and `Stable`, where the numbers before are unsure |
//! | [`Filtered`] | unknown if a value is small relative to its terms | `Exact`, for spheres and flat primitives |
//! | [`Bounded`] | unknown if the value is within its error bound of zero | `Exact`, where a sign is unknown in the numbers before |
//! | [`Integer`] | always certain | `Exact`, where a sign is unknown in [`Bounded`] |
//!
//! In two numbers nothing is solved: lines are transformed in [`Doubled`], where [`Running`] is unsure in `Stable`, and
//! points and normals are computed in [`Twofold`](crate::scalar::Twofold).

/// The operators of a number with the methods `plus`, `negative` and `times`.
macro_rules! operators {
    ($Number:ty $(, $($parameters:tt)+)?) => {
        impl$(<$($parameters)+>)? core::ops::Add for $Number {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                self.plus(other)
            }
        }
        impl$(<$($parameters)+>)? core::ops::Sub for $Number {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                self.plus(other.negative())
            }
        }
        impl$(<$($parameters)+>)? core::ops::Neg for $Number {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.negative()
            }
        }
        impl$(<$($parameters)+>)? core::ops::Mul for $Number {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                self.times(other)
            }
        }
    };
}
pub(crate) use operators;

mod bounded;
mod doubled;
#[cfg(feature = "libm")]
mod filtered;
mod guarded;
mod integer;
mod limbs;
pub(crate) mod machine;
mod plain;
mod robust;
mod running;
#[cfg(units)]
#[path = "../../tests/units/number.rs"]
mod tests;
pub(crate) mod word;

pub use bounded::Bounded;
pub use doubled::Doubled;
#[cfg(feature = "libm")]
pub use filtered::Filtered;
pub use guarded::Guarded;
#[cfg(feature = "fixed")]
pub(crate) use integer::FIXED_LIMBS;
pub(crate) use integer::FLOAT_LIMBS;
pub use integer::Integer;
pub use limbs::Limbs;
pub use plain::Plain;
pub use robust::Robust;
pub use running::Running;

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// Numbers that can be added and multiplied. A placement needs no other operations.
pub trait Ring: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;

    /// A sum of products, rounded once.
    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let mut sum = Self::ZERO;
        for [a, b] in terms {
            sum = sum + a * b;
        }
        sum
    }
    #[doc(hidden)]
    /// `a . b` of two vectors. A number that knows its error has one bound for all components of a vector, the largest.
    #[inline(always)]
    fn scalar_product<const M: usize>(a: [Self; M], b: [Self; M]) -> Self {
        let mut terms = [[Self::ZERO; 2]; M];
        let mut i = 0;
        while i < M {
            terms[i] = [a[i], b[i]];
            i += 1;
        }
        Self::sum(terms)
    }
    #[doc(hidden)]
    /// `a x b`
    #[inline(always)]
    fn vector_product(a: [Self; 3], b: [Self; 3]) -> [Self; 3] {
        cross(a, b)
    }
    #[doc(hidden)]
    /// `a b - |v|^2`
    #[inline(always)]
    fn less_square(a: Self, b: Self, [x, y, z]: [Self; 3]) -> Self {
        Self::sum([[a, b], [-x, x], [-y, y], [-z, z]])
    }
    /// `self * 2^e`, exactly.
    fn scaled(self, e: i32) -> Self;
}

/// A number whose sign may be unknown.
pub trait Number: Ring {
    /// The type of approximate quotients and square roots.
    type Estimate: Estimate;
    /// A number in which the equation of a torus is as certain: for integers, a longer one.
    type Long: Number<Estimate = Self::Estimate, Long = Self::Long>;
    /// True if an operation is a function call. Code in such numbers is not inlined, since it is called in several
    /// places and runs seldom.
    const IS_WIDE: bool = true;
    /// True if signs of polynomials may decide an order that [`Estimate::compare`] does not know.
    const DECIDES_BY_SIGNS: bool = false;
    /// How the square of the distance by which a line's origin was moved counts among the terms of a difference of
    /// squares: as `2^MOVED` of itself.
    const MOVED: i32 = 0;
    /// True if a triangle is computed from a point of the line next to its first vertex, for a more accurate `t`. (If
    /// it is not, triangles that share an edge compute the same number for it.)
    const STARTS_AT_VERTEX: bool = false;
    /// True if it allows for a direction whose length is only nearly 1.
    const KNOWS_LENGTH: bool = true;
    /// True if the point of closest approach to a ball about the frame's origin is computed from the origin of a moved
    /// line; false if it is taken to be that origin.
    const APPROACHES_AGAIN: bool = true;
    /// True if rays that depart are computed in it; if not, the next number computes them.
    const DEPARTS: bool = true;
    /// True if it may know that a sum of products is zero. A line that lies in a quadric is left to such a number.
    const KNOWS_ZERO: bool = true;

    /// How it compares with zero; `None` if that is unknown.
    fn sign(self) -> Option<Ordering>;
    /// [`Number::sign`] of a difference whose terms have the sum of magnitudes `terms`: a [`Guarded`] number knows it
    /// only if little cancels.
    #[inline(always)]
    fn sign_among(self, _of: Difference, _terms: impl FnOnce() -> Self) -> Option<Ordering> {
        self.sign()
    }
    /// How the crossings of two planes of a cuboid compare. A stable [`Guarded`] number knows that in the world
    /// alone.
    #[inline(always)]
    fn order_of_crossings(t: Self::Estimate, other: Self::Estimate) -> Option<Ordering> {
        t.compare(other)
    }
    /// True if an end at `t` is accurate: if that times `slope` is not small relative to the terms of the sums that it
    /// was computed from. A stable [`Guarded`] number needs this test.
    #[inline(always)]
    fn is_far(_t: Self::Estimate, _slope: Self::Estimate, _terms: impl FnOnce() -> Self) -> bool {
        true
    }
    /// The number rounded to [`Number::Estimate`].
    fn estimate(self) -> Self::Estimate;
    /// The same number.
    fn long(self) -> Self::Long;
    /// `self / other` as such a number, if it may be rounded.
    #[inline(always)]
    fn rounded_quotient(self, _other: Self) -> Option<Self> {
        None
    }
    /// True if its square is less than a rounding of 1, for a number of at most 2^-19; numbers that promise no accuracy
    /// need not know.
    #[inline(always)]
    fn is_negligible_squared(self) -> bool {
        true
    }
    /// The magnitude; only stable [`Guarded`] numbers need it.
    #[inline(always)]
    fn magnitude(self) -> Self {
        self
    }
    /// The rounded value, taken to be exact.
    #[inline(always)]
    fn without_error(self) -> Self {
        self
    }
    /// `work()`: a function of its own in wide numbers, so that it is not copied into each place that needs it.
    fn apart<A>(work: impl FnOnce() -> A) -> A;
}

/// What a difference consists of, for [`Number::sign_among`].
#[derive(Clone, Copy, Debug)]
pub enum Difference {
    /// A discriminant, whose root is taken.
    Squares,
    /// The signed volume that a line spans with an edge.
    Volumes,
    /// Another one, of which only the sign is needed.
    Signs,
    /// The position of a line beside the edge of a rectangle. `Fast` takes the sign of the rounded value.
    Edges,
}

/// [`Number::apart`] of wide numbers.
#[inline(never)]
fn in_a_function<A>(work: impl FnOnce() -> A) -> A {
    work()
}

/// A number of limited precision.
pub trait Estimate: Number<Estimate = Self> {
    /// Above every number of a solver: the parameter of a missing end.
    const INFINITY: Self;
    /// How many binary digits it has.
    const DIGITS: i32;
    /// The value alone, for what approximates others.
    type Rough: Estimate<Rough = Self::Rough>;

    /// The value alone.
    fn rough(self) -> Self::Rough;
    /// A value, taken to be exact.
    fn exactly(value: Self::Rough) -> Self;

    /// `self / other`; `other` must not be zero.
    fn over(self, other: Self) -> Self;
    /// The square root of a number that is not negative.
    fn square_root(self) -> Self;
    /// How it compares with another; `None` if that is unknown.
    fn compare(self, other: Self) -> Option<Ordering>;
    /// True if its rounded magnitude times `2^e` is at most the other rounded number.
    #[inline(always)]
    fn is_within(self, _other: Self, _e: i32) -> bool {
        false
    }
    /// The exponent of the smallest power of two above the magnitude; `None` for zero.
    #[inline(always)]
    fn top(self) -> Option<i32> {
        None
    }
}

/// The parts of a stored number: `(-1)^negative * mantissa * 2^exponent`.
#[derive(Clone, Copy, Debug)]
pub struct Parts {
    /// The integer.
    pub mantissa: u64,
    /// The exponent of the power of two that it is multiplied by.
    pub exponent: i32,
    /// The sign.
    pub negative: bool,
}

impl Parts {
    /// The integer below the magnitude of the number times a power of two, with its sign. It must be below 2^31.
    #[inline(always)]
    pub(crate) fn truncated(self, scale: i32) -> i32 {
        let Self { mantissa, exponent, negative } = self;
        let (left, right) = (exponent + scale, (-exponent - scale).max(0).unsigned_abs());
        // Of most types the mantissa is a word.
        let magnitude = if let Ok(mantissa) = u32::try_from(mantissa) {
            if left >= 0 { mantissa.checked_shl(left as u32) } else { mantissa.checked_shr(right) }
        } else {
            // To the left a product with zero bits would leave the word.
            mantissa.checked_shr(right).map(|magnitude| magnitude as u32)
        };
        let magnitude = magnitude.unwrap_or(0) as i32;
        if negative { -magnitude } else { magnitude }
    }
}

/// `a . b`, with an error bound of each term: [`Ring::scalar_product`] is cheaper, this bound is tighter.
#[inline]
pub(crate) fn dot<N: Ring>(a: [N; 3], b: [N; 3]) -> N {
    N::sum([[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]])
}

/// `a x b`, with an error bound of each component, as [`dot`].
#[inline]
pub(crate) fn cross<N: Ring>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    let minor = |i: usize, j: usize| N::sum([[a[i], b[j]], [-a[j], b[i]]]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// `a - b`
#[inline]
pub(crate) fn difference<N: Ring>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
