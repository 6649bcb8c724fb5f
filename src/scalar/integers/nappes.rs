//! The interval of a line in one nappe of a cone, from its intersections with the double cone.

use crate::scalar::{Attempt, InSide, found};
use core::ops::Neg;

/// The roots of a line and both nappes of a cone, `a t^2 + 2 k t + c`.
pub(super) trait Roots {
    /// Of a `t`.
    type Length: Copy + PartialOrd + Neg<Output = Self::Length>;

    const ZERO: Self::Length;
    /// A missing end.
    const INFINITY: Self::Length;

    /// The `t` to which the line's origin was moved.
    fn start(&self) -> Self::Length;

    /// Whether the line is steeper than the side, `a < 0`: then it is inside before its first end and after its second.
    fn is_steep(&self) -> bool;

    /// Whether the cone's outline grows along the line.
    fn rises(&self) -> bool;

    /// Whether the point halfway between the ends, at `t = -k / a`, is in the nappe whose outline is positive: the sign
    /// there is that of `Y a - dY k`.
    fn is_middle_inside(&self) -> Attempt<bool>;

    /// The end at the lower root for a positive `a`, and at the higher one for a negative `a`; and true if the interval
    /// ends there, false if it ends somewhere beyond.
    fn first(&self) -> (Self::Length, bool);

    /// The other one.
    fn second(&self) -> (Self::Length, bool);

    /// Where the line is inside the nappe whose outline is positive.
    #[inline(always)]
    fn in_nappe(&self) -> Attempt<InSide<Self::Length>> {
        let (low, high) = if self.is_steep() {
            // A half-line lies in each nappe. Along the one in the upper nappe the outline grows.
            if self.rises() { (self.first(), (Self::INFINITY, true)) } else { ((-Self::INFINITY, true), self.second()) }
        } else if found!(self.is_middle_inside()) {
            (self.first(), self.second())
        } else {
            return Attempt::Miss;
        };
        // An interval that begins or ends somewhere beyond an inaccurate end may be anywhere, or empty.
        if (!low.1 && low.0 > self.start()) || (!high.1 && high.0 < self.start()) {
            return Attempt::Unsure;
        }
        let beyond = |is_end: bool| if is_end { Self::ZERO } else { Self::INFINITY };
        Attempt::Hit(InSide { ends: [low.0, high.0], beyond: [beyond(low.1), beyond(high.1)] })
    }

    /// Where the line is inside both nappes: between its ends, or (`true`) before the first and after the second.
    #[inline(always)]
    fn in_both(&self) -> Attempt<([Self::Length; 2], bool)> {
        match (self.first(), self.second()) {
            ((first, true), (second, true)) if self.is_steep() => Attempt::Hit(([second, first], true)),
            ((first, true), (second, true)) => Attempt::Hit(([first, second], false)),
            _ => Attempt::Unsure,
        }
    }
}
