//! Results on the grid of fixed point: certain, or unsure.

use super::Scalar;
#[cfg(feature = "fixed")]
use core::ops::Neg;

/// A result on the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attempt<T> {
    /// The line misses.
    Miss,
    /// The result.
    Hit(T),
    /// A guard fails: the solver decides.
    Unsure,
}

/// The interval of a line inside an infinite cylinder, or a nappe of a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InSide<S> {
    /// The ends; infinite for a missing end.
    pub ends: [S; 2],
    /// For each end, how much farther the interval may extend: zero if the end is accurate, infinite if that is not
    /// known.
    pub beyond: [S; 2],
}

impl<S: Scalar> InSide<S> {
    /// For each end, whether it is accurate.
    #[inline(always)]
    pub(crate) fn are_accurate(&self) -> [bool; 2] {
        self.beyond.map(|beyond| beyond == S::ZERO)
    }

    /// The exit, if it is accurate.
    #[inline(always)]
    pub(crate) fn exit(&self) -> Attempt<S> {
        if self.are_accurate()[1] { Attempt::Hit(self.ends[1]) } else { Attempt::Unsure }
    }
}

/// The outline of a nappe about the y axis: a cone through two circles.
#[derive(Clone, Copy, Debug)]
pub struct NappeOutline<S> {
    /// The radius at `y = 0`.
    pub base: S,
    /// The radius at `y = height`.
    pub top: S,
    /// `None` for 1.
    pub height: Option<S>,
}

/// The interval of a line inside a cuboid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InCuboid<S> {
    /// The ends; the second is infinite if it was not computed: it is uncertain, or not needed.
    pub ends: [S; 2],
    /// For each end, the axis perpendicular to its face: 0, 1 or 2 for x, y or z.
    pub axes: [usize; 2],
}

/// Like `?`: the result, or a return from the calling function with [`Attempt::Miss`] or [`Attempt::Unsure`]. (A macro,
/// since closures are not always inlined.)
macro_rules! found {
    ($attempt:expr) => {
        match $attempt {
            $crate::scalar::Attempt::Hit(answer) => answer,
            $crate::scalar::Attempt::Miss => return $crate::scalar::Attempt::Miss,
            $crate::scalar::Attempt::Unsure => return $crate::scalar::Attempt::Unsure,
        }
    };
}
pub(crate) use found;

/// Whether the line hits a triangle, and whether from the front, by the signed volume that it spans with each edge, and
/// the error bound of the volumes. All three are negative for a hit from the front, and positive for one from the back.
/// They are computed one after the other: a miss is often decided by the first two.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn within_edges_in_turn<E, V: Copy + PartialOrd + Neg<Output = V>>(
    [first, second, third]: [E; 3],
    doubt: V,
    volume: impl Fn(E) -> V,
) -> Attempt<bool> {
    let side = |edge: E| {
        let volume = volume(edge);
        (volume > doubt) as i32 - (volume < -doubt) as i32
    };
    let (first, second) = (side(first), side(second));
    if first * second < 0 {
        return Attempt::Miss;
    }
    let third = side(third);
    if third * first < 0 || third * second < 0 {
        Attempt::Miss
    } else if first * second * third != 0 {
        Attempt::Hit(third < 0)
    } else {
        Attempt::Unsure
    }
}
