//! Light between pixels that were traced: a parabola through three of them, by forward differences.
//!
//! Light that is diffused by a smooth surface changes smoothly along a row. The middle one of three pixels tells how
//! far it is from a straight line; a parabola is much closer, as long as it is not far from that line.

use crate::render::Pixel;
use crate::scalar::{Ring, Scalar, UnitScalar};
use crate::scene::Color;
use crate::vector::pairs;

/// The most levels of sRGB that the middle may be off the mean of the ends.
const OFF: u8 = 2;

/// The fewest columns from the first pixel to the last: of fewer, all are traced.
pub(super) const SHORTEST: u16 = 4;

/// The most columns from the first pixel to the last; few where the growth has few digits.
pub(super) fn longest<S: Scalar>() -> u16 {
    let has_digits = S::unit_round(S::Real::ONE.scaled(-28)) > S::Unit::ZERO;
    if has_digits { 32 } else { SHORTEST }
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
    /// Through the first, the middle and the last of pixels that are so many columns apart, a power of two of at least
    /// [`SHORTEST`]. `None` if they see different things, are lit by different lights, or are too far from a straight
    /// line.
    pub(super) fn through([first, middle, last]: [&Pixel<S>; 3], columns: u16) -> Option<Self> {
        let is_same = |pixel: &Pixel<S>| pixel.seen == first.seen && pixel.lit_by == first.lit_by;
        if !is_same(middle) || !is_same(last) {
            return None;
        }
        let power = columns.trailing_zeros() as i32;
        let [half, nth, four_nths] = [1, power, power - 2].map(|power| S::unit_round(S::Real::ONE.scaled(-power)));
        let ends = pairs(first.color.to_array(), last.color.to_array());
        let mean = Color::<S>::from(ends.map(|(first, last)| first.times(half).plus(last.times(half))));
        let levels = pairs(mean.to_srgb888(), middle.color.to_srgb888());
        if levels.into_iter().any(|(mean, middle)| mean.abs_diff(middle) > OFF) {
            return None;
        }
        let is_clamped = levels.into_iter().any(|(_, middle)| !(16..240).contains(&middle));
        // l + (4 m - 3 l - r) (k / n) + 2 (l - 2 m + r) (k / n)^2, with a = (m - l) / n and b = (r - m) / n.
        let slopes = pairs(ends, middle.color.to_array()).map(|((l, r), m)| {
            let (a, b) = (m.minus(l).times(nth), r.minus(m).times(nth));
            let growth = b.minus(a).times(four_nths);
            (a.plus(a).plus(a).minus(b).plus(growth.times(half)), growth)
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
