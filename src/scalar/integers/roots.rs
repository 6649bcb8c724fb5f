//! A line and a quadric about the y axis, on the grid of fixed point. The words of the comments are those of
//! [`integers`](super).

use super::framed_bits;
use super::length::{Divisor, Length, Normalized, Product};
use crate::scalar::{Attempt, InSide};

/// The divisor of a line's roots, with its reciprocal.
type DivisorOf<N> = <<N as Length>::Normalized as Normalized<N>>::Divisor;

/// A line on a grid on which its coordinates and the lengths of the quadric have no more than `BITS - 3` bits, before
/// the quadric's proportions are applied to them.
#[derive(Clone, Copy)]
pub(super) struct OnGrid<N> {
    /// The moved origin.
    pub(super) point: [N; 3],
    pub(super) direction: [N; 3],
    /// Lengths are in units of `2^-unit` of the type's unit.
    pub(super) unit: i32,
    /// The ray's `t` at the moved origin: a whole number of the type's units.
    pub(super) start: N,
    /// The origin was in units of `2^-extra_bits` of the type's unit.
    pub(super) extra_bits: i32,
    /// True if signs must be certain (tier `Exact`).
    pub(super) is_strict: bool,
}

/// `length * proportion`, for a proportion of at most 1.
#[inline(always)]
pub(super) fn along<N: Length>(length: N, proportion: N) -> N {
    N::nearest(N::dot([length], [proportion]))
}

impl<N: Length> OnGrid<N> {
    /// The line, and the lengths on its grid. The origin is in units of `2^-extra_bits` of the unit of the lengths.
    /// Unless the line `departs`, it is moved to a point next to the point of the line that is closest to the frame's
    /// origin.
    #[inline(always)]
    pub(super) fn new(
        o: [N; 3],
        extra_bits: i32,
        d: [N; 3],
        [p, q]: [N; 2],
        departs: bool,
        is_strict: bool,
    ) -> Attempt<(Self, [N; 2])> {
        let (Some(p), Some(q)) = (p.refined(extra_bits), q.refined(extra_bits)) else { return Attempt::Unsure };
        if !N::have_room(o) {
            return Attempt::Unsure;
        }
        // The origin is moved to the closest point, with t rounded to a whole unit. The products are exact. The
        // lengths are then as large as the quadric and the line's distance from it, however far away the ray starts.
        let closest =
            if departs { Some(N::ZERO) } else { N::narrowed(-(N::dot(o, d) >> (N::FRACTION + extra_bits as u32))) };
        let Some((start, walk)) = closest.and_then(|start| Some((start, start.refined_time(extra_bits)?))) else {
            return Attempt::Unsure;
        };
        let walked = |i: usize| o[i].at_unit() + N::dot([walk], [d[i]]);
        let near = [walked(0), walked(1), walked(2)];
        let (p, q) = (p.at_unit(), q.at_unit());
        let [x, y, z] = near.map(N::high);
        let zeros = N::zeros([x, y, z, N::high(p), N::high(q)]);
        let unit = zeros as i32 - 5 + extra_bits;
        // Beyond the upper limit of `unit`, next to an apex, a root's quotient would be shifted by more than 2 BITS.
        if zeros < 4 || !(0..=N::BITS as i32 + 2).contains(&unit) {
            return Attempt::Unsure;
        }
        // Truncated towards zero, so that a mirrored line has mirrored points.
        let on_grid = |length: N::Product| {
            let truncated = N::truncated(length.magnitude(), N::BITS + 3 - zeros);
            if N::high(length) < N::ZERO { -truncated } else { truncated }
        };
        let line = Self { point: near.map(on_grid), direction: d, unit, start, extra_bits, is_strict };
        Attempt::Hit((line, [on_grid(p), on_grid(q)]))
    }

    /// The number of bits by which the coordinates are finer than an eighth of the type's unit, and a framed origin
    /// finer than a fourth, after both errors are multiplied by `2^shift`, as the division by `a` does.
    #[inline(always)]
    pub(super) fn spare(&self, shift: i32) -> i32 {
        let spare = self.unit - 3 - shift;
        // The error of a framed origin is half of its own unit.
        if self.extra_bits == 0 { spare } else { spare.min(self.extra_bits - 2 - shift) }
    }

    /// The binary exponent of the error of a coordinate, in units of the grid, that comes from a framed origin.
    #[inline(always)]
    pub(super) fn framed_bits(&self) -> u32 {
        framed_bits(self.extra_bits, self.unit) as u32
    }

    /// The bound of the error of a discriminant, given the sum of the magnitudes of the line's moment and of the
    /// quadric's lengths.
    ///
    /// The rounding of the coordinates, up to 2 units perpendicular to the axis and 3 along it, changes a discriminant
    /// by at most twelve times that sum (6.3 times in all measurements).
    #[inline(always)]
    pub(super) fn doubt(&self, lengths: N::Product) -> N::Product {
        // If strict, 16 times the sum, and 4 times the sum for each unit of error of a framed origin.
        lengths << if self.is_strict { 5.max(3 + self.framed_bits()) } else { 4 }
    }
}

/// Along the line the quadric is `a t^2 + 2 k t + c`, with ends at `t = (-k -+ sqrt(D)) / a`, `D = k^2 - a c`.
pub(super) struct Roots<N: Length> {
    pub(super) line: OnGrid<N>,
    pub(super) k: N::Product,
    root: N,
    divisor: DivisorOf<N>,
    is_steep: bool,
    /// The largest `t` from the moved origin at which an end is accurate enough.
    farthest: N,
}

/// Whether the line is steeper than the side, so that `a < 0`: then it is inside before the first end and after the
/// second.
#[inline(always)]
pub(super) fn is_steep<N: Length>(a: N::Product) -> bool {
    N::high(a) < N::ZERO
}

impl<N: Length> Roots<N> {
    /// Of a line with this `a`, of which `digits` are the leading ones, and this discriminant; `lengths` are those of
    /// [`OnGrid::doubt`].
    #[inline(always)]
    pub(super) fn new(
        line: OnGrid<N>,
        (a, digits): (N::Product, N::Normalized),
        k: impl FnOnce() -> N::Product,
        discriminant: N::Product,
        lengths: N::Product,
    ) -> Attempt<Self> {
        let doubt = line.doubt(lengths);
        if discriminant < -doubt && !is_steep::<N>(a) {
            return Attempt::Miss;
        }
        if line.is_strict && discriminant <= doubt {
            return Attempt::Unsure;
        }
        // The rounding changes t by less than half a unit (by a sixth in all measurements), if the root is not small
        // relative to the lengths.
        let spare = line.spare(digits.shift());
        let Some(lengths) = N::narrowed(lengths >> 2) else { return Attempt::Unsure };
        if N::high(discriminant) <= N::ZERO || spare < 0 {
            return Attempt::Unsure;
        }
        let root = N::root(discriminant);
        if root.down(2) < lengths.down(spare.min(31) as u32) {
            return Attempt::Unsure;
        }
        let k = k();
        let divisor = digits.divisor();
        // Farther away the rounding of a turned direction matters: an error of 2^-(BITS - 1) times t, which a small
        // root enlarges as well.
        let (bits, more) = (N::CONE_BITS as i32, N::zeros([root]) as i32 - N::zeros([lengths]) as i32 + 3);
        let bits = if line.extra_bits == 0 { bits } else { (bits + 4 - more).min(bits).max(0) };
        let farthest = N::from(1).up(bits as u32).down(digits.shift() as u32);
        Attempt::Hit(Self { line, k, root, divisor, is_steep: is_steep::<N>(a), farthest })
    }

    /// The end with this numerator, and true; or a `t` that the end lies beyond, and false.
    #[inline(always)]
    fn end(&self, numerator: N::Product) -> (N, bool) {
        let (OnGrid { start, unit, .. }, farthest) = (self.line, self.farthest);
        match self.divisor.quotient(numerator, unit as u32) {
            Some(t) if -farthest < t && t < farthest => match start.checked_plus(t) {
                Some(t) => (t, true),
                None => (start.saturating_plus(t), false),
            },
            _ if (N::high(numerator) < N::ZERO) == self.is_steep => (start.saturating_plus(farthest), false),
            _ => (start.saturating_plus(-farthest), false),
        }
    }

    /// The end at the lower root for a positive `a`, and at the higher one for a negative `a`.
    #[inline(always)]
    pub(super) fn first(&self) -> (N, bool) {
        self.end(-self.k - self.root.at_unit())
    }

    /// The other one.
    #[inline(always)]
    pub(super) fn second(&self) -> (N, bool) {
        self.end(self.root.at_unit() - self.k)
    }

    /// The interval between two ends, if it is certain that they are ends of one.
    #[inline(always)]
    pub(super) fn between(&self, low: (N, bool), high: (N, bool)) -> Attempt<InSide<N>> {
        let start = self.line.start;
        // An interval of which an end is only known to lie beyond a `t` on the wrong side may be anywhere, or empty.
        if (!low.1 && low.0 > start) || (!high.1 && high.0 < start) {
            return Attempt::Unsure;
        }
        let beyond = |is_end: bool| if is_end { N::ZERO } else { N::MAX };
        Attempt::Hit(InSide { ends: [low.0, high.0], beyond: [beyond(low.1), beyond(high.1)] })
    }
}

/// The `t` of the other root of a line that starts on the quadric, `-2 k / a`, whatever its rounded coordinates are,
/// and whether that is near enough to be accurate; `None` if it has no room.
#[inline(always)]
pub(super) fn other_root<N: Length>(line: &OnGrid<N>, digits: N::Normalized, k: N::Product) -> Option<(N, bool)> {
    // The rounding of the coordinates changes t by at most a fourth of a unit.
    if line.spare(digits.shift()) < 3 {
        return None;
    }
    let t = digits.divisor().quotient(-(k << 1), line.unit as u32)?;
    Some((t, t < N::from(1).up(N::CONE_BITS).down(digits.shift() as u32)))
}
