//! Light between pixels that were traced: a parabola through three of them, by forward differences.
//!
//! Light that is diffused by a smooth surface changes smoothly along a row. The middle one of three pixels tells how
//! far it is from a straight line; a parabola is much closer, as long as it is not far from that line.

use crate::render::Pixel;
use crate::scalar::{Real, Ring, Scalar, UnitScalar};
use crate::scene::Color;
use crate::vector::pairs;

/// The most levels of sRGB that the middle may be off the straight line between the ends.
const OFF: u8 = 1;

/// The fewest columns from the first pixel to the last: of fewer, all are traced.
pub(super) const SHORTEST: u16 = 4;

/// The most columns from the first pixel to the last.
pub(super) const LONGEST: u16 = 64;

/// `1 / n` for all numbers of columns from 1 on, at the index `n`.
#[derive(Clone, Debug)]
pub(super) struct Reciprocals<S: Scalar>([S::Unit; LONGEST as usize + 1]);

impl<S: Scalar> Reciprocals<S> {
    pub(super) fn new() -> Self {
        let mut reciprocals = [S::Unit::ONE; LONGEST as usize + 1];
        for (columns, reciprocal) in (0..).zip(&mut reciprocals).skip(1) {
            *reciprocal = S::unit_round(S::Real::ONE / S::Real::from_int(columns));
        }
        Self(reciprocals)
    }

    fn of(&self, columns: u16) -> S::Unit {
        self.0.get(usize::from(columns)).copied().unwrap_or(S::Unit::ZERO)
    }
}

/// The pixels between two that were traced.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curve<S: Scalar> {
    /// The last pixel that was made.
    pixel: Pixel<S>,
    /// By how much the next one differs from it, and by how much that grows.
    step: [S::Unit; 3],
    growth: [S::Unit; 3],
    /// A channel may leave the range from 0 to 1.
    is_clamped: bool,
}

impl<S: Scalar> Curve<S> {
    /// Through the first, the middle and the last of pixels that are so many columns apart, from [`SHORTEST`] to
    /// [`LONGEST`]; half of them, rounded down, are before the middle. `None` if they see different things, are lit by
    /// different lights, or are too far from a straight line.
    pub(super) fn through(
        [first, middle, last]: [&Pixel<S>; 3],
        columns: u16,
        one_by: &Reciprocals<S>,
    ) -> Option<Self> {
        // Where light is as bright as a pixel can be, it has an edge.
        let are_full = |pixel: &Pixel<S>| pixel.color.to_array().map(|channel| channel >= S::Unit::ONE);
        let full = are_full(first);
        let is_same =
            |pixel: &Pixel<S>| pixel.seen == first.seen && pixel.lit_by == first.lit_by && are_full(pixel) == full;
        if !is_same(middle) || !is_same(last) {
            return None;
        }
        let half = S::unit_round(S::Real::ONE.scaled(-1));
        let [before, after, nth] = [columns / 2, columns.div_ceil(2), columns].map(|columns| one_by.of(columns));
        // The middle is at `n / 2`, or `(n - 1) / 2`: the part of a difference up to there.
        let up_to_middle = |difference: S::Unit| {
            let rest = if columns.is_multiple_of(2) { S::Unit::ZERO } else { difference.times(nth) };
            difference.minus(rest).times(half)
        };
        let ends = pairs(first.color.to_array(), last.color.to_array());
        let chord = Color::<S>::from(ends.map(|(l, r)| l.plus(up_to_middle(r.minus(l)))));
        let levels = pairs(chord.to_srgb888(), middle.color.to_srgb888());
        if levels.into_iter().any(|(chord, middle)| chord.abs_diff(middle) > OFF) {
            return None;
        }
        let is_clamped = levels.into_iter().any(|(_, middle)| !(16..240).contains(&middle));
        // Newton's form through l, m and r at 0, h and n: l + a k + c k (k - h), with a = (m - l) / h,
        // b = (r - m) / (n - h) and c = (b - a) / n.
        let slopes = pairs(ends, middle.color.to_array()).map(|((l, r), m)| {
            let (a, b) = (m.minus(l).times(before), r.minus(m).times(after));
            let bend = b.minus(a);
            let c = bend.times(nth);
            (a.plus(c).minus(up_to_middle(bend)), c.plus(c))
        });
        let (step, growth) = (slopes.map(|(step, _)| step), slopes.map(|(_, growth)| growth));
        Some(Self { pixel: *first, step, growth, is_clamped })
    }

    /// The next pixel.
    #[inline(always)]
    pub(super) fn next(&mut self) -> Pixel<S> {
        self.pixel.color = pairs(self.pixel.color.to_array(), self.step).map(|(color, step)| color.plus(step)).into();
        self.step = pairs(self.step, self.growth).map(|(step, growth)| step.plus(growth));
        let Pixel { color, seen, lit_by } = self.pixel;
        Pixel { color: if self.is_clamped { color.clamped() } else { color }, seen, lit_by }
    }
}

#[cfg(all(units, feature = "fixed"))]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../../tests/units/render/curve.rs"]
mod tests;
