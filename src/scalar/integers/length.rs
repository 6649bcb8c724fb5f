//! The integers of one width, with the operations that the kernels need.

use core::ops::{Add, BitOr, Neg, Shl, Shr, Sub};

/// A length, a component of a direction, or a `t`: an integer of 32 or 64 bits.
pub trait Length:
    Copy + Ord + From<i32> + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Stretch
{
    /// A product of two, or a sum of such products.
    type Product: Product + From<Self>;
    /// A divisor.
    type Normalized: Normalized<Self>;
    /// How much a square exceeds 1.
    type Excess: Copy;

    /// The bits of a length.
    const BITS: u32;
    /// The fraction bits of a direction.
    const FRACTION: u32 = Self::BITS - 2;
    /// The ends of a cone are accurate below 2 to the power of this.
    const CONE_BITS: u32;
    /// The least number of extra bits of a framed origin below the type's unit: its rounding error is then a hundredth
    /// of a unit, or less.
    const FINER: i32;
    /// True if the closest approach to a ball is unsure next to a tangent. With 32 bits it is not: the grid of a line
    /// far away is so coarse that all of its rays would be left to other methods.
    const GUARDS_APPROACH: bool;
    /// Bits of the moments of a triangle's vertices below the unit of their grid.
    const MOMENT_BITS: u32;
    /// Of a triangle's normal, which is scaled up as a product: the leading zeros that its longest component keeps, and
    /// the number of bits of its lower part. The upper part is a length.
    const NORMAL: (u32, u32);
    /// Zero.
    const ZERO: Self;
    /// The largest number, which stands for infinity.
    const MAX: Self;

    /// The highest 32 bits of the magnitude (for a negative number, of the magnitude less one). The bitwise or of
    /// several has the leading zeros of the longest length.
    fn top(self) -> u32;
    /// The leading zeros of the longest of these; at most `BITS - 1`.
    fn zeros<const M: usize>(lengths: [Self; M]) -> u32;
    /// `self * 2^by`
    fn up(self, by: u32) -> Self;
    /// `self / 2^by`, rounded down.
    fn down(self, by: u32) -> Self;
    /// `self * 2^FRACTION`, which is a product with one.
    fn at_unit(self) -> Self::Product;
    /// `self * 2^by` of a length of at least zero, for `by` from 1 to `BITS - 1`.
    fn raised(self, by: u32) -> Self::Product;
    /// `self + other`, if it has room.
    fn checked_plus(self, other: Self) -> Option<Self>;
    /// `self + other`, or the end of the type next to that.
    fn saturating_plus(self, other: Self) -> Self;
    /// `self - other`, which wraps around at the ends of the type. That of two coordinates within the budget does not.
    fn apart(self, other: Self) -> Self;
    /// Whether they are less than `2^bits` apart.
    fn are_within(self, other: Self, bits: u32) -> bool;

    /// Whether sums of products of these with a direction have room; with 32 bits those of all coordinates have.
    fn have_room(lengths: [Self; 3]) -> bool;
    /// Whether a difference of two products of these has room.
    fn have_products(lengths: [Self; 3]) -> bool;
    /// A length of the type in units of `2^-extra_bits` of its own, if it is then below `2^(BITS - 2)`.
    fn refined(self, extra_bits: i32) -> Option<Self>;
    /// The same beside a coordinate `o` in these units, if differences of products of both with a direction have room.
    fn refined_beside(self, o: Self, extra_bits: i32) -> Option<Self>;
    /// The same for a `t`, if its product with a direction has room.
    fn refined_time(self, extra_bits: i32) -> Option<Self>;
    /// Points of the type relative to a line's origin, which is in units of `2^-extra_bits`, and the leading zeros of
    /// the longest component, if products of the components have room.
    fn seen_from<const M: usize>(
        points: [[Self; 3]; M],
        o: [Self; 3],
        extra_bits: i32,
    ) -> Option<([[Self; 3]; M], u32)>;
    /// A length of the type relative to the coordinate `o`, which is in units of `2^-extra_bits`, if the difference and
    /// its products have room.
    fn relative_to(self, o: Self, extra_bits: i32) -> Option<Self>;
    /// The number of extra bits of a turned line for which the lengths of a solid, `longest` at most, have room too; at
    /// least [`Length::FINER`].
    fn fitting(longest: Self) -> i32;
    /// The coordinates of a point in a unit that is larger by this number of bits.
    fn coarser(point: [Self; 3], bits: u32) -> [Self; 3];
    /// For a line along `d` from a point relative to a frame's origin: a `t`, and the point there in units of
    /// `2^-extra_bits`; `None` if the line is too far away.
    fn placed(from: [Self; 3], d: [Self; 3]) -> Option<(Self, [Self; 3], i32)>;

    /// `a . b`
    fn dot<const M: usize>(a: [Self; M], b: [Self; M]) -> Self::Product;
    /// `a d - b c`
    fn minor(ab: [Self; 2], cd: [Self; 2]) -> Self::Product;
    /// `|v|^2`
    fn squared_length<const M: usize>(v: [Self; M]) -> Self::Product;
    /// `a . d` of lengths below `2^(BITS - 4)` and a direction, within a unit and a half.
    fn portion<const M: usize>(a: [Self; M], d: [Self; M]) -> Self;

    /// The upper half.
    fn high(product: Self::Product) -> Self;
    /// The product as a length, which it fits.
    fn low(product: Self::Product) -> Self;
    /// The product as a length, if it fits one.
    fn narrowed(product: Self::Product) -> Option<Self>;
    /// `product / 2^FRACTION`, rounded to nearest, ties to even, so that a mirrored line has mirrored coordinates.
    fn nearest(product: Self::Product) -> Self;
    /// `product / 2^(FRACTION + extra_bits)`, rounded likewise; infinite if it is beyond the type.
    fn rounded(product: Self::Product, extra_bits: i32) -> Self;
    /// `product / 2^by`, rounded down, for one of at least zero, and `by` from 1 to `BITS - 1`.
    fn truncated(product: Self::Product, by: u32) -> Self;
    /// Whether a product of at least zero is at least `2^(BITS - 2 + by)`.
    fn reaches(product: Self::Product, by: u32) -> bool;
    /// `product / 2^by`, rounded, for one that does not reach this, and `by` of at least 2.
    fn rounded_off(product: Self::Product, by: u32) -> Self;
    /// The square root of a product whose upper half is at least 1.
    fn root(product: Self::Product) -> Self;

    /// `square - 1` for the square of a direction's length; `None` if it is too large.
    fn excess(square: Self::Product) -> Option<Self::Excess>;
    /// `product * e`
    fn share(product: Self::Product, e: Self::Excess) -> Self::Product;
    /// `product / (1 + e)`
    fn without_excess(product: Self::Product, e: Self::Excess) -> Self::Product;
}

/// Lines in the frame of an affine placement.
pub trait Stretch: Sized {
    /// The line from `o` along `d` in the frame at `position` of a matrix whose inverse has these rows, each to be
    /// multiplied by its power of two, for a solid whose lengths are at most `longest`; `None` if there is no
    /// room for them.
    fn stretched(
        o: [Self; 3],
        d: [Self; 3],
        position: [Self; 3],
        rows: [([Self; 3], i32); 3],
        longest: Self,
    ) -> Option<Stretched<Self>>;
    /// The ray's `t` for a `t` along such a line, which may be infinite; `None` if it is too large.
    fn along_ray(inverse_length: InverseLength, start: Self, t: Self) -> Option<Self>;
}

/// An integer of 64 or 128 bits.
pub trait Product:
    Copy
    + Ord
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + BitOr<Output = Self>
    + Shl<u32, Output = Self>
    + Shr<u32, Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;

    /// The magnitude.
    fn magnitude(self) -> Self;
    /// The leading zeros of a number of at least zero.
    fn zeros(self) -> u32;
    /// The lowest bits, a number of at least zero.
    fn lowest(self, bits: u32) -> Self;
}

/// A divisor: a product, whose unit is `2^-(2 FRACTION)`, by its leading digits.
pub trait Normalized<N: Length>: Copy {
    /// The divisor with its reciprocal.
    type Divisor: Divisor<N>;

    /// A number between 2^-11 and 2 in magnitude.
    fn new(a: N::Product) -> Option<Self>;
    /// The magnitude is at least `2^-shift`, or half of that.
    fn shift(self) -> i32;
    /// `a r^2`
    fn of_square(self, r: N) -> N::Product;
    /// With its reciprocal.
    fn divisor(self) -> Self::Divisor;
}

/// A divisor as its reciprocal: a product with it costs a fourth of a division, and two ends share the reciprocal.
pub trait Divisor<N: Length>: Copy {
    /// The quotient of a number in units of `2^-(FRACTION + unit)`, rounded to nearest; `None` for one so large
    /// that the reciprocal's error would matter.
    fn quotient(self, numerator: N::Product, unit: u32) -> Option<N>;
    /// The same of `y - o`, for an `o` in units of `2^-extra_bits` of those of `y`.
    fn quotient_of_difference(self, y: N, o: N, extra_bits: i32) -> Option<N>;
}

/// The line with a direction of length 1, in a unit of length that is finer than the type's by a power of two. An error
/// of half a unit of an end along it is then at most a fourth of a unit of the ray's own `t`.
#[derive(Debug)]
pub struct Stretched<N> {
    /// The ray's `t` at the origin.
    pub(in crate::scalar) start: N,
    /// In units of `2^-extra_bits` of the finer unit.
    pub(in crate::scalar) origin: [N; 3],
    pub(in crate::scalar) extra_bits: i32,
    pub(in crate::scalar) direction: [N; 3],
    /// The number of bits by which the unit is finer than the type's.
    pub(in crate::scalar) scale: i32,
    pub(in crate::scalar) inverse_length: InverseLength,
}

/// A ratio of lengths, at most a half: `digits * 2^-shift`, or `(digits * 2^32 + below) * 2^-shift` for the types of 64
/// bits.
#[derive(Clone, Copy, Debug)]
pub struct InverseLength {
    /// At least 2^31.
    pub digits: u32,
    /// The digits below these; zero for the types of 32 bits.
    pub below: u32,
    /// From 33 to 62, or from 65 to 126.
    pub shift: u32,
}
