//! Operations on stored numbers.

use super::{Attempt, Numbers, Scalar};
use crate::vector::pairs;

/// Products, lengths and directions.
pub trait Computing: Numbers {
    /// True if the rounding error of a parameter `t` is small relative to a length of this size: at most four units of
    /// the type in the quotient.
    fn resolves(t: Self, size: Self) -> bool;
    /// True if the rounding error of a parameter `t` turns the normal of a surface with this radius of curvature by at
    /// most four units of a direction.
    fn resolves_turn(t: Self, radius: Self) -> bool;
    /// `o . d`; exact for fixed types.
    fn dot(o: [Self; 3], d: [Self::Unit; 3]) -> Self::Real;
    /// `o x d`, the line's Pluecker moment about the origin; exact for fixed types.
    fn cross(o: [Self; 3], d: [Self::Unit; 3]) -> [Self::Real; 3];
    /// `d . e` of two directions; exact for fixed types.
    fn unit_dot(d: [Self::Unit; 3], e: [Self::Unit; 3]) -> Self::Real;
    /// `o + t d`, rounded once (for floats with a further error of the second order).
    fn advance(o: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self; 3];
    /// `o - base + t d`, rounded once (for floats with a further error of the second order).
    fn approach(o: [Self; 3], base: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self; 3];
    /// `o - base + t d`, exact for fixed types.
    fn approach_exactly(o: [Self; 3], base: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self::Real; 3];
    /// [`Computing::approach_exactly`] along these axes, for fixed types to the last bits of the double width.
    fn approach_along(
        o: [Self; 3],
        base: [Self; 3],
        d: [Self::Unit; 3],
        t: Self,
        axes: [[Self::Unit; 3]; 3],
    ) -> [Self::Real; 3];
    /// For fixed types: the normal, of any length, where the ray meets a ball about `centre` on the y axis, or a
    /// cylinder about that axis, of this radius; `t` is rounded. It is along these axes, or along the world's. `None`
    /// where it takes more than one step and integers of the double width, or is not determined.
    fn round_normal(_line: RoundLine<Self>, _solid: RoundSolid<Self>) -> Option<[Self::Real; 3]> {
        None
    }
    /// The vector's direction and its length; `None` for the zero vector and for a vector with a component
    /// that is not finite. Accurate for every length, from the smallest to the largest.
    fn normalize(v: [Self::Real; 3]) -> Option<([Self::Unit; 3], Self::Real)>;
    /// The direction alone, which may differ from that of [`Computing::normalize`] in the last place.
    #[inline]
    fn direction(v: [Self::Real; 3]) -> Option<[Self::Unit; 3]> {
        Self::normalize(v).map(|(direction, _)| direction)
    }
    /// The direction of three coordinates, equal to that of [`Computing::normalize`] or next to it; a miss for the zero
    /// vector.
    #[inline(always)]
    fn direction_of(_: [Self; 3]) -> Attempt<[Self::Unit; 3]> {
        Attempt::Unsure
    }
    /// The direction from one point to another, and the distance, to within two units; infinite beyond the type. `None`
    /// for the same point.
    #[inline]
    fn towards(from: [Self; 3], to: [Self; 3]) -> Option<([Self::Unit; 3], Self)>
    where
        Self: Scalar,
    {
        // A difference beyond the type, which is saturated, is not of the grid.
        let v = pairs(to, from).map(|(to, from)| to.minus(from));
        match Self::direction_of(v) {
            Attempt::Hit(d) => Some((d, Self::round(Self::dot(v, d)))),
            Attempt::Miss => None,
            Attempt::Unsure => {
                let (d, length) = Self::normalize(pairs(to, from).map(|(to, from)| to.real() - from.real()))?;
                Some((d, Self::round(length)))
            }
        }
    }
    /// A component or a channel times a number, rounded to nearest and saturated.
    fn times(component: Self::Unit, by: Self) -> Self::Unit;
    /// This length along a direction: `self` times its component, rounded once.
    fn along(self, component: Self::Unit) -> Self;
    /// The exponent `e` for which `2^-e` brings the largest of the given magnitudes near 1; always zero for fixed
    /// types, whose [`Real`](super::Real) carries its own exponent.
    fn binary_exponent(largest: Self) -> i32;
    /// `self * 2^e`, where `e` comes from [`Computing::binary_exponent`], or the product is known to fit.
    fn scaled(self, e: i32) -> Self;
    /// Three values in the finest unit in which the type holds all of them: numbers that stand for `2^-n` times
    /// themselves, and `n`, which is zero for floats.
    fn finest(values: [Self::Real; 3]) -> ([Self; 3], i32);
}

/// A ray's line and a `t`, the frame's origin, and its axes if it is turned.
#[derive(Clone, Copy, Debug)]
pub struct RoundLine<S: Numbers> {
    /// The ray's origin.
    pub o: [S; 3],
    /// The frame's origin.
    pub base: [S; 3],
    /// The ray's direction.
    pub d: [S::Unit; 3],
    /// The parameter of the hit, rounded.
    pub t: S,
    /// The frame's axes.
    pub axes: Option<[[S::Unit; 3]; 3]>,
    /// True if the line enters at the hit.
    pub enters: bool,
}

/// A ball about a point of the y axis, or a cylinder about the axis.
#[derive(Clone, Copy, Debug)]
pub struct RoundSolid<S> {
    /// The radius.
    pub radius: S,
    /// The height of a ball's centre; `None` for a cylinder.
    pub centre: Option<S>,
}

/// Functions for textures, light and surface coordinates.
pub trait Elementary: Numbers {
    /// The value less the largest integer below it, in `[0, 1)`.
    fn fraction(self) -> Self::Unit;
    /// The angle of the point (x, y) seen from the origin, in turns from the x axis, in `[0, 1)`. Zero at the origin.
    fn turns(y: Self::Real, x: Self::Real) -> Self::Unit;
    /// Sine and cosine of an angle in turns.
    fn sine_cosine(turns: Self::Unit) -> (Self::Unit, Self::Unit);
    /// The number, if it is an integer from 0 to 1023.
    fn small_integer(self) -> Option<u32>;
    /// `base^exponent` for a base in `[0, 1]` and an exponent of at least zero.
    fn power(base: Self::Unit, exponent: Self) -> Self::Unit;
}
