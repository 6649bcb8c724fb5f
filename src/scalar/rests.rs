//! What rounding leaves over of a local line: its low words in floats, nothing in fixed point.

use super::Real;
use core::fmt::Debug;

/// The low words of a line, if the number type has such.
pub trait Rests<S>: Copy + Debug {
    /// None are left.
    const NONE: Self;
    /// Those of the origin, and none of the direction.
    fn of_origin(origin: [S; 3]) -> Self;
    /// Those of the line mirrored in the plane `y = 0`.
    #[must_use]
    fn mirrored(self) -> Self;
}

/// The low words of a float line.
#[derive(Clone, Copy, Debug)]
pub struct LowWords<F> {
    /// Of the origin.
    pub origin: [F; 3],
    /// Of the direction.
    pub direction: [F; 3],
    /// How far off origin and direction are even with these, in squares of the relative rounding error.
    pub off: [F; 2],
}

impl<F: Real> Rests<F> for LowWords<F> {
    const NONE: Self = Self { origin: [F::ZERO; 3], direction: [F::ZERO; 3], off: [F::ZERO; 2] };
    #[inline(always)]
    fn of_origin(origin: [F; 3]) -> Self {
        Self { origin, ..Self::NONE }
    }
    #[inline(always)]
    fn mirrored(self) -> Self {
        let mirrored = |[x, y, z]: [F; 3]| [x, -y, z];
        Self { origin: mirrored(self.origin), direction: mirrored(self.direction), ..self }
    }
}

impl<S> Rests<S> for () {
    const NONE: Self = ();
    #[inline(always)]
    fn of_origin(_: [S; 3]) -> Self {}
    #[inline(always)]
    fn mirrored(self) -> Self {}
}
