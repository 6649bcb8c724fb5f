//! Results on the grid of fixed point: certain, or unsure.

use super::Scalar;

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

/// Where a line crosses the plane of a half-space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Crossed<T> {
    /// It comes inside there.
    Enters(T),
    /// It goes outside there.
    Leaves(T),
    /// Nowhere near: the line is inside.
    Inside,
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
