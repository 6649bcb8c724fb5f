//! What a number must do here.
//!
//! A [`Scalar`] *stores*: coordinates, sizes, distances. A [`Real`] *computes*: it is the number in which the
//! solvers work, and it never overflows inside the [`Budget`]. For floats the two are the same type. For fixed
//! point the [`Real`] is a block-floating number of twice the width ([`block`]), so that products are exact and
//! nothing is rounded before a difference is taken.
//!
//! Everything in which number types differ stands in this folder and nowhere else:
//!
//! | room | what it holds |
//! |---|---|
//! | `float` | `f32` and `f64`: error-free products and sums, stepping closer, binary scale |
//! | `fixed` | `FixedI32<F>` and `FixedI64<F>`, for every `F` |
//! | `plain` | the usual case of fixed point in plain integers |
//! | `floats` | the usual case of floats, uncompensated |
//! | `separation` | whether a ray surely misses a box |
//! | [`block`] | integer mantissa and exponent; square root and quotient of integers |
//! | `decimal` | decimal text to fixed point, correctly rounded |
//! | `elementary` | angle, sine, power, in integers for the fixed types |
//! | `square_root` | the one hardware instruction that `core` does not give |

use crate::number::word::Word;
use crate::number::{FromScalar, Limbs, Number, Parts, ToScalar};
use core::cmp::Ordering;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

pub mod block;
#[cfg(feature = "fixed")]
mod decimal;
#[cfg(feature = "fixed")]
mod elementary;
#[cfg(feature = "fixed")]
mod fixed;
#[cfg(feature = "libm")]
mod float;
#[cfg(feature = "libm")]
mod floats;
#[cfg(feature = "fixed")]
mod integers;
pub(crate) mod separation;
#[cfg(feature = "libm")]
mod square_root;

#[cfg(feature = "fixed")]
pub use fixed::{DISTANCE_BITS, SIZE_BITS};

/// Keeps [`Scalar`] and its companions closed: their contracts bind several impls together.
mod sealed {
    pub trait Sealed {}
}

/// The largest and smallest values that a number type takes at construction.
///
/// Inside the budget no query overflows, in debug or release; outside it, constructors return an error.
///
/// # Floats
///
/// | type | coordinate | size | slope | distance |
/// |---|---|---|---|---|
/// | `f32` | 2^126 | smallest subnormal to 2^126 | 2^-30 to 2^30 | 2^128 - 2^104 (largest finite) |
/// | `f64` | 2^1022 | smallest subnormal to 2^1022 | 2^-200 to 2^200 | largest finite |
///
/// The coordinate is a quarter of the largest finite float, so that the difference of two points is finite.
/// The robust number has an exponent of its own: no size inside the budget has a square that vanishes.
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
pub struct Budget<S> {
    /// Largest magnitude of a coordinate.
    pub coordinate: S,
    /// Largest radius or height.
    pub size: S,
    /// Smallest radius (and smallest height where a height of zero is no solid).
    pub smallest_size: S,
    /// Largest slope of a cone, radius over height.
    pub slope: S,
    /// Smallest slope of a cone.
    pub smallest_slope: S,
    /// Largest `t`; what lies farther is outside every range.
    pub distance: S,
}

/// A number that stores coordinates, sizes and distances.
///
/// Implemented for `f32`, `f64`, `FixedI32<F>` and `FixedI64<F>` for every `F` that `fixed` allows. Sealed.
pub trait Scalar:
    Copy + Debug + Default + PartialEq + PartialOrd + Neg<Output = Self> + Send + Sync + 'static + sealed::Sealed
{
    /// A component of a unit vector, or a colour: the float itself, Q2.30 for 32-bit and Q2.62 for 64-bit fixed types.
    type Unit: UnitScalar;
    /// The number in which solvers compute.
    type Real: Real;
    /// The number in which solvers compute where the fast path is unsure.
    type Robust: FromScalar<Self> + Number<Estimate = Self::Robust> + ToScalar<Self>;

    /// Zero.
    const ZERO: Self;
    /// Beyond every range: `f32::INFINITY`, or the largest raw value of a fixed type.
    const INFINITY: Self;
    /// True if precision is relative to magnitude (floats), so that a change of scale loses nothing.
    const RELATIVE: bool;
    /// What constructors accept.
    const BUDGET: Budget<Self>;

    /// False for NaN and for [`Scalar::INFINITY`] of either sign.
    fn is_finite(self) -> bool;
    /// The exact value: sign, integer and exponent.
    fn parts(self) -> Parts;
    /// The exact value of a unit component.
    fn unit_parts(value: Self::Unit) -> Parts;
    /// Rounded to nearest, ties to even; beyond the type's range, [`Scalar::INFINITY`] with the sign.
    fn from_limbs<W: Word>(value: Limbs<W>) -> Self;
    /// Rounded as [`Scalar::from_limbs`].
    fn from_robust(value: Self::Robust) -> Self;
    /// Rounded as [`Scalar::from_limbs`], to a unit component.
    fn unit_from_robust(value: Self::Robust) -> Self::Unit;
    /// True if the rounding of a parameter `t` is small beside a length of this size: at most four units of the type in the quotient.
    fn resolves(t: Self, size: Self) -> bool;
    /// The exponent of the last place of values below `2^top`.
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

    /// `o . d`; exact for fixed types.
    fn dot(o: [Self; 3], d: [Self::Unit; 3]) -> Self::Real;
    /// `o x d`, the moment of the line about the origin; exact for fixed types.
    fn cross(o: [Self; 3], d: [Self::Unit; 3]) -> [Self::Real; 3];
    /// `d . e` of two directions; exact for fixed types.
    fn unit_dot(d: [Self::Unit; 3], e: [Self::Unit; 3]) -> Self::Real;
    /// `o + t d`, rounded once (floats: but for an error of the second order).
    fn advance(o: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self; 3];
    /// `o - base + t d`, rounded once (floats: but for an error of the second order).
    fn approach(o: [Self; 3], base: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self; 3];
    /// The vector's direction and its length; `None` for the zero vector and for a vector with a component
    /// that is not finite. Right for every length, from the smallest to the largest.
    fn normalize(v: [Self::Real; 3]) -> Option<([Self::Unit; 3], Self::Real)>;

    /// The direction alone, which may be next to the one of [`Scalar::normalize`].
    #[inline]
    fn direction(v: [Self::Real; 3]) -> Option<[Self::Unit; 3]> {
        Self::normalize(v).map(|(direction, _)| direction)
    }
    /// The direction of a vector in this type, as [`Scalar::normalize`] has it or next to that; a miss for the zero vector.
    #[inline(always)]
    fn fast_direction(_: [Self; 3]) -> Attempt<[Self::Unit; 3]> {
        Attempt::Unsure
    }
    /// This length along a direction: `self` times its component, rounded once.
    #[inline(always)]
    fn along(self, component: Self::Unit) -> Self {
        Self::round(self.real() * Self::unit_real(component))
    }

    /// The exponent `e` for which `2^-e` brings the largest of the given magnitudes near 1; always zero for fixed types, whose
    /// [`Real`] carries its own exponent.
    fn binary_exponent(largest: Self) -> i32;
    /// `self * 2^e`, where `e` comes from [`Scalar::binary_exponent`].
    fn scaled(self, e: i32) -> Self;
    /// Three values in the finest unit in which the type holds them: numbers to be read as `2^-n` times themselves,
    /// and `n`; zero for floats, which are as fine as they can be.
    fn finest(values: [Self::Real; 3]) -> ([Self; 3], i32);
    /// The two ends of the line inside the ball of radius `r` about the origin: from its closest approach, or, if `by_moment`, from its
    /// moment.
    ///
    /// This and the other `plain` functions are a short way for the usual case: plain integers for fixed types, for floats
    /// numbers that need no scaling. What they do not answer is left to the solver.
    #[inline(always)]
    fn fast_ball(_: LocalLine<Self>, _r: Self, _by_moment: bool) -> Attempt<[Self; 2]> {
        Attempt::Unsure
    }

    /// Whether that line has an end at `t >= 0`, where no end is beyond the type.
    #[inline(always)]
    fn fast_ball_ahead(_: LocalLine<Self>, _r: Self, _by_moment: bool) -> Attempt<()> {
        Attempt::Unsure
    }

    /// The two ends of the line inside the infinite cylinder of radius `r` about the y axis.
    #[inline(always)]
    fn fast_tube(_: LocalLine<Self>, _r: Self) -> Attempt<[Self; 2]> {
        Attempt::Unsure
    }
    /// Where the line is inside the nappe of a cone that has the radius `base` at `y = 0` and grows by `growth` over `height` (`None`: 1).
    /// Of a cone that ends somewhere only what lies between `y = 0` and `top` is wanted.
    #[inline(always)]
    fn fast_nappe(
        _: LocalLine<Self>,
        _outline: (Self, Self, Option<Self>),
        _top: Option<Self>,
    ) -> Attempt<InNappe<Self>> {
        Attempt::Unsure
    }
    /// Where the line is inside both nappes of a cone of this slope: between its ends, or (`true`) beyond them.
    #[inline(always)]
    fn fast_double_cone(_: LocalLine<Self>, _slope: Self) -> Attempt<([Self; 2], bool)> {
        Attempt::Unsure
    }
    /// Whether the line's point at `t` lies below `y = 0`, between that and the height, or above; unclear where rounding decides.
    #[inline(always)]
    fn fast_seams(_: LocalLine<Self>, _t: Self, _height: Self) -> Attempt<Ordering> {
        Attempt::Unsure
    }
    /// The line seen from the height `y`.
    #[inline(always)]
    fn fast_lowered(_: LocalLine<Self>, _y: Self) -> Attempt<LocalLine<Self>> {
        Attempt::Unsure
    }
    /// Where the line crosses two heights, and how much more than a few units each may be off; a line that stays in one height crosses
    /// neither.
    #[inline(always)]
    fn fast_crossings(_: LocalLine<Self>, _y: [Self; 2]) -> Attempt<([Self; 2], [Self; 2])> {
        Attempt::Unsure
    }

    /// Where the line crosses the disc of radius `r` about the origin in the plane `y = 0`.
    #[inline(always)]
    fn fast_disc(_: LocalLine<Self>, _r: Self) -> Attempt<Self> {
        Attempt::Unsure
    }
    /// Where the line crosses the triangle with these vertices, and whether it comes from where they run counter-clockwise.
    #[inline(always)]
    fn fast_triangle(_: LocalLine<Self>, _vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
        Attempt::Unsure
    }

    /// Whether two ends of the fast path are so close that rounding, and what they may be `off` beside it, decides which comes first.
    #[inline(always)]
    fn are_close(_: &LocalLine<Self>, _: Self, _: Self, _off: Self) -> bool {
        false
    }

    /// Whether an end that may be `off` by so much is good enough.
    #[inline(always)]
    fn is_good(_: &LocalLine<Self>, _: Self, _off: Self) -> bool {
        true
    }

    /// The line from `o` along `d` in the frame with these axes at `position`.
    #[inline(always)]
    fn fast_turned(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _axes: [[Self::Unit; 3]; 3],
    ) -> Option<LocalLine<Self>> {
        None
    }

    /// The line from `o` along `d` in the frame of a matrix, whose inverse has these rows, each to be multiplied by its power of two. `None` where products cancel, whose rounding would be much of the line.
    #[inline(always)]
    fn fast_stretched(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _rows: [([Self::Unit; 3], i32); 3],
    ) -> Option<LocalLine<Self>> {
        None
    }

    /// True only if the ray from `o` along `d` surely misses, within the closed `range` of `t`, the box about `centre` with these half
    /// extents: then no solid in it, found by a solver that rounds, has a hit there either.
    ///
    /// Conservative, and without a division: a ray that passes next to the box is not said to miss it. All numbers within the
    /// [`Budget`] of coordinates, but the range.
    fn misses_box(o: [Self; 3], d: [Self::Unit; 3], range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool;

    /// The value less the largest integer below it, in `[0, 1)`.
    fn fraction(self) -> Self::Unit;
    /// The angle of the point (x, y) seen from the origin, in turns from the x axis, in `[0, 1)`. Zero at the origin.
    fn turns(y: Self::Real, x: Self::Real) -> Self::Unit;
    /// Sine and cosine of an angle in turns.
    fn sine_cosine(turns: Self::Unit) -> (Self::Unit, Self::Unit);
    /// `base^exponent` for a base in `[0, 1]` and an exponent of at least zero.
    fn power(base: Self::Unit, exponent: Self) -> Self::Unit;

    /// A decimal number such as `-12.5` or `1.5e-3`, correctly rounded to nearest, ties to even.
    ///
    /// `None` if the text is no number or its magnitude is beyond the type's range.
    fn parse(text: &str) -> Option<Self> {
        Self::parse_scaled(text, 0)
    }
    /// A decimal number times `2^power`, correctly rounded to nearest, ties to even (once: not the number, and then the product).
    ///
    /// As [`Scalar::parse`]; `None` also if a fixed type's fraction bits and the power add up to less than 0 or more than 64.
    fn parse_scaled(text: &str, power: i32) -> Option<Self>;
    /// The nearest value to an `f64`, for tools on the host; `None` if it is not finite or beyond the range.
    fn from_f64(value: f64) -> Option<Self>;
    /// The value as an `f64`, for tools on the host; rounded for 64-bit fixed types.
    fn to_f64(self) -> f64;
}

/// What plain integers say of a question, see [`Scalar::fast_ball`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attempt<T> {
    /// There is nothing.
    Miss,
    /// The answer.
    Found(T),
    /// It takes more than plain integers.
    Unsure,
}

/// Where a line is inside a nappe of a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InNappe<S> {
    /// The ends; infinite where there is none.
    pub ends: [S; 2],
    /// Whether the line ends there; otherwise somewhere beyond.
    pub certain: [bool; 2],
}

/// What was found; otherwise the caller's answer is the same miss or doubt. (As `?`, and without closures, which are not surely
/// compiled inline.)
macro_rules! found {
    ($question:expr) => {
        match $question {
            $crate::scalar::Attempt::Found(answer) => answer,
            $crate::scalar::Attempt::Miss => return $crate::scalar::Attempt::Miss,
            $crate::scalar::Attempt::Unsure => return $crate::scalar::Attempt::Unsure,
        }
    };
}
pub(crate) use found;

/// A line for plain integers: `origin` is to be read as `2^-finer` times itself.
#[derive(Clone, Copy, Debug)]
pub struct LocalLine<S: Scalar> {
    /// The origin.
    pub origin: [S; 3],
    /// How much finer the origin's unit is than the type's.
    pub finer: i32,
    /// The direction.
    pub direction: [S::Unit; 3],
    /// The ray's `t` over the line's own, where a placement stretches; not used elsewhere.
    pub pace: S,
    /// True of doubles that stand for numbers of 32 bits: guards may be strict, and yet let nearly all through.
    pub has_spare_bits: bool,
}

/// A component of a unit vector or a colour channel. Sealed.
pub trait UnitScalar:
    Copy + Debug + Default + PartialEq + PartialOrd + Neg<Output = Self> + Send + Sync + 'static + sealed::Sealed
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
    /// The nearest value to an `f64`, saturated; NaN gives zero.
    fn from_f64(value: f64) -> Self;
    /// The value as an `f64`.
    fn to_f64(self) -> f64;
}

/// The number in which solvers compute: a float, or a block-floating integer. Sealed.
///
/// No operation overflows for operands that come from values inside the [`Budget`]. For fixed types sums,
/// differences and products of stored values are exact as long as their bits fit the double width.
pub trait Real:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Send
    + Sync
    + 'static
    + sealed::Sealed
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// The exponent of the relative rounding of a product.
    const ROUNDING: i32;

    /// A small integer.
    fn from_int(n: i32) -> Self;
    /// The square root; zero for a negative number.
    fn sqrt(self) -> Self;
    /// The sum of products as a rounded value and the rest that rounding left over: about twice the working
    /// precision, so that cancellation costs nothing ("Dot2": Ogita, Rump, Oishi, *Accurate Sum and Dot Product*, 2005).
    fn sum_with_rest<const N: usize>(terms: [[Self; 2]; N]) -> [Self; 2];
    /// The sum of products, rounded once, or nearly so, however much of it cancels.
    #[inline]
    fn sum_of_products<const N: usize>(terms: [[Self; 2]; N]) -> Self {
        let [sum, _] = Self::sum_with_rest(terms);
        sum
    }
    /// The magnitude.
    fn abs(self) -> Self;
    /// `self * 2^n`, exactly.
    fn times_power_of_two(self, n: i32) -> Self;
    /// True below zero.
    fn is_negative(self) -> bool;
    /// True at zero.
    fn is_zero(self) -> bool;
}

/// Largest of some magnitudes.
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

/// True if a decimal number is zero before any rounding: if its mantissa has no digit but 0.
pub(crate) fn is_zero_decimal(text: &str) -> bool {
    let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
    !mantissa.bytes().any(|byte| matches!(byte, b'1'..=b'9'))
}

/// True for an optional sign, digits with at most one point, and an optional decimal exponent: the number syntax
/// that every scalar parses, without the words and separators that some parsers add.
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
