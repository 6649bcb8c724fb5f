//! The grid of fixed point: integers of a common unit, in which a line meets a primitive in the type's own width. Where
//! that is unsure, the solver decides.

#[cfg(feature = "fixed")]
use super::including::narrowed;
use super::integers::length::{InverseLength, Length};
use super::{Including, Numbers, Scalar};
#[cfg(feature = "fixed")]
use fixed::types::extra::{LeEqU32, LeEqU64, U32};
#[cfg(feature = "fixed")]
use fixed::{FixedI32, FixedI64};

/// A line in a primitive's frame, for the grid.
#[derive(Clone, Copy, Debug)]
pub struct LocalLine<S: Numbers> {
    /// The origin, in units of `2^-extra_bits` of the type's.
    pub origin: [S; 3],
    /// Extra bits of the origin below the type's unit.
    pub extra_bits: i32,
    /// The direction.
    pub direction: [S::Unit; 3],
    /// The ray's `t` at the line's origin.
    pub start: S,
    /// True if the line is accurate enough only to decide a miss.
    pub is_coarse: bool,
    /// True for the tier [`Exact`](crate::tier::Exact): a result that passes the guards is certain, except that `t` is
    /// rounded, by less than a unit.
    pub is_strict: bool,
    /// If given, only the first end at or after this `t` of the ray is needed: an entry is enough, and a line without
    /// such an end may be a miss.
    pub since: Option<S>,
}

impl<S: Numbers + Copy> LocalLine<S> {
    /// The line of a ray in world coordinates.
    #[inline(always)]
    pub(crate) const fn along(origin: [S; 3], direction: [S::Unit; 3], zero: S) -> Self {
        Self { origin, extra_bits: 0, direction, start: zero, is_coarse: false, is_strict: false, since: None }
    }
}

impl<S: Scalar> LocalLine<S> {
    /// Whether no end is needed but the entry at this `t` of the line.
    #[inline(always)]
    pub(crate) fn needs_only(&self, enter: S) -> bool {
        self.since.is_some_and(|since| enter.plus(self.start) >= since)
    }

    /// The line mirrored in the plane `y = 0`.
    #[inline]
    pub(crate) fn mirrored(&self) -> Self {
        let mut line = *self;
        line.origin[1] = -line.origin[1];
        line.direction[1] = -line.direction[1];
        line
    }
}

/// A line in the frame of an affine placement, in fixed point, with a unit of length that is finer than the type's.
#[derive(Clone, Copy, Debug)]
pub struct FinerLine<S: Numbers> {
    /// The line, for a solid that is `2^scale` times as large.
    pub line: LocalLine<S>,
    /// Extra bits of the unit of length below the type's.
    pub scale: i32,
    /// The ray's `t` divided by the line's, in the type's unit over the line's.
    pub inverse_length: InverseLength,
}

/// A fixed-point type, whose lines meet primitives on the grid: its raw integers, and the type of the second attempt.
pub trait GridScalar: Scalar {
    /// The type's integers.
    type Raw: Length;
    /// The type of the second attempt, which holds every value of this one; the type itself if that has none.
    type Wider: GridScalar + Including<Self>;
    /// True if there is such a second attempt.
    const WIDENS: bool = false;

    /// Rounded as [`Scalar::from_limbs`].
    fn narrowed(value: Self::Wider) -> Self;
    /// The raw integer.
    fn to_raw(self) -> Self::Raw;
    /// The number of a raw integer.
    fn from_raw(raw: Self::Raw) -> Self;
    /// The raw integer of a component of a direction.
    fn unit_to_raw(component: Self::Unit) -> Self::Raw;
    /// The component of a raw integer.
    fn unit_from_raw(raw: Self::Raw) -> Self::Unit;
    /// One, if the type holds it.
    fn one() -> Option<Self::Raw>;
}

#[cfg(feature = "fixed")]
impl<F: LeEqU32 + Send + Sync + 'static> GridScalar for FixedI32<F> {
    type Raw = i32;
    type Wider = FixedI64<U32>;
    // With fewer fraction bits the coordinates of usual scenes leave 32 bits enough room. With more the wider type has
    // too few finer bits.
    const WIDENS: bool = F::U32 >= 20 && F::U32 <= 28;

    #[inline]
    fn narrowed(value: Self::Wider) -> Self {
        narrowed(value)
    }
    #[inline(always)]
    fn to_raw(self) -> i32 {
        self.to_bits()
    }
    #[inline(always)]
    fn from_raw(raw: i32) -> Self {
        Self::from_bits(raw)
    }
    #[inline(always)]
    fn unit_to_raw(component: Self::Unit) -> i32 {
        component.to_bits()
    }
    #[inline(always)]
    fn unit_from_raw(raw: i32) -> Self::Unit {
        FixedI32::from_bits(raw)
    }
    #[inline(always)]
    fn one() -> Option<i32> {
        1_i32.checked_shl(F::U32).filter(|one| *one > 0)
    }
}

#[cfg(feature = "fixed")]
impl<F: LeEqU64 + Send + Sync + 'static> GridScalar for FixedI64<F> {
    type Raw = i64;
    type Wider = Self;

    #[inline(always)]
    fn narrowed(value: Self) -> Self {
        value
    }
    #[inline(always)]
    fn to_raw(self) -> i64 {
        self.to_bits()
    }
    #[inline(always)]
    fn from_raw(raw: i64) -> Self {
        Self::from_bits(raw)
    }
    #[inline(always)]
    fn unit_to_raw(component: Self::Unit) -> i64 {
        component.to_bits()
    }
    #[inline(always)]
    fn unit_from_raw(raw: i64) -> Self::Unit {
        FixedI64::from_bits(raw)
    }
    #[inline(always)]
    fn one() -> Option<i64> {
        1_i64.checked_shl(F::U32).filter(|one| *one > 0)
    }
}
