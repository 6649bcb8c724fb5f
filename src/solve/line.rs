//! A ray's line in a primitive's frame.

use crate::number::Number;
use crate::part::Part;
use crate::ray::Leaving;

/// A ray's line in a primitive's frame. Its direction may have any length, since `t` is the parameter of the ray as stored.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<N: Number> {
    pub(crate) origin: [N; 3],
    pub(crate) direction: [N; 3],
    /// The part that it departs from at `t = 0`, and the side to which it departs.
    pub(crate) departure: Option<(Part, Leaving)>,
    /// The ray's `t` at the origin, if that was moved.
    pub(crate) start: Option<N::Estimate>,
    /// The same as a number; zero if the origin was not moved.
    pub(crate) moved: N,
    /// The direction has length 1, to one part in 2^19: the ball may be intersected from the point of closest approach.
    pub(crate) is_unit: bool,
}

impl<N: Number> Line<N> {
    /// The line of a ray, from its start.
    #[inline(always)]
    pub(crate) const fn new([origin, direction]: [[N; 3]; 2], departure: Option<(Part, Leaving)>) -> Self {
        Self { origin, direction, departure, start: None, moved: N::ZERO, is_unit: false }
    }

    /// True if it departs from this part.
    #[inline(always)]
    pub(super) fn departs_from(&self, part: Part) -> bool {
        self.departure.is_some_and(|(from, _)| from == part)
    }

    /// The square of the distance by which the origin was moved, times `2^e`.
    #[inline(always)]
    pub(super) fn far(&self, e: i32) -> N {
        (self.moved * self.moved).scaled(e)
    }
}
