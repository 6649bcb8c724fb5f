//! The low words of a local line in floats, which are the rounding errors of its components; fixed point has none.

use super::Real;
use core::fmt::Debug;

/// The low words of a line, if the number type has any.
pub trait OptionalLowWords<S>: Copy + Debug {
    /// All of them zero.
    const NONE: Self;
    /// Those of the origin; those of the direction are zero.
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
    /// The errors that origin and direction still have with these, in squares of the relative rounding error.
    pub off: [F; 2],
}

impl<F: Real> OptionalLowWords<F> for LowWords<F> {
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

impl<S> OptionalLowWords<S> for () {
    const NONE: Self = ();
    #[inline(always)]
    fn of_origin(_: [S; 3]) -> Self {}
    #[inline(always)]
    fn mirrored(self) -> Self {}
}
