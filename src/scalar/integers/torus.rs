//! A line and a torus, on the grid of fixed point. The words of the comments are those of [`integers`](super).
//!
//! The equation is that of the solver, for a direction of length 1, with `u` from the line's point closest to the
//! centre: `f = S^2 + (2 R)^2 (y^2 - r^2)`, where `S = u^2 + e` and `y = y_0 + u d_y`. Far away `f > 0`, and there is
//! at most one root between two extremes, where the slope `4 (u^3 + p u + q)` is zero. So the signs of `f` at these, at
//! most three, tell how many roots there are, and separate them. Where a sign is not certain, the line may touch the
//! torus, and the solver decides.
//!
//! A length below `2^FRACTION` is also a fraction, so that the product of two is rounded to a length again.

use super::length::{Divisor, Length, Normalized, Product};
use super::roots::{OnGrid, along};
use crate::scalar::{Attempt, InSide, found};

/// More steps of Newton's method than any root takes that is not close to another one.
const MOST_STEPS: usize = 12;

/// A torus and a line.
struct Along<N: Length> {
    line: OnGrid<N>,
    /// The closest point is at `-k` of the line.
    k: N,
    /// `e`
    constant: N::Product,
    /// `2 R y_0`, `2 R d_y` and `2 R r`.
    height: N,
    rise: N,
    minor: N,
    /// Half of the error bound of the equation is this many binary digits above its lengths.
    doubt: u32,
}

/// The equation at a point of the line.
struct At<N: Length> {
    value: N::Product,
    /// Half the slope.
    slope: N::Product,
    /// The sum of the magnitudes of the numbers that the value is computed from.
    lengths: N::Product,
}

#[inline(always)]
fn size<N: Length>(length: N) -> N {
    if length < N::ZERO { -length } else { length }
}

/// `numerator / divisor`, both in the unit of products, as a length; `None` if it is too large. A divisor is at most 1.
#[inline(always)]
fn quotient<N: Length>(numerator: N::Product, divisor: N::Product) -> Option<N> {
    let divisor = N::Normalized::new(divisor)?.divisor();
    // A quotient that has no room for all of its digits has some fewer.
    let fewer = N::BITS / 8;
    divisor.quotient(numerator, 0).or_else(|| Some(divisor.quotient(numerator, fewer)?.up(fewer)))
}

/// The root of a length.
#[inline(always)]
fn root<N: Length>(square: N) -> Option<N> {
    let square = square.at_unit();
    (N::high(square) > N::ZERO).then(|| N::root(square))
}

/// True if the step after this one, which squares the error, is of no interest.
#[inline(always)]
fn is_short<N: Length>(step: N) -> bool {
    size(step) < N::from(1).up(N::FRACTION / 2 - 3)
}

/// True at points that may be inside, since the sum of the radii is below half of the unit.
#[inline(always)]
fn is_near<N: Length>(u: N) -> bool {
    let half = N::from(1).up(N::FRACTION - 1);
    -half < u && u < half
}

impl<N: Length> Along<N> {
    /// A line that comes near the torus.
    #[inline(always)]
    fn new(o: [N; 3], extra_bits: i32, d: [N; 3], [major, minor]: [N; 2]) -> Attempt<Self> {
        let Some(around) = major.checked_plus(minor) else { return Attempt::Unsure };
        let (line, [around, minor]) = found!(OnGrid::new(o, extra_bits, d, [around, minor], false, false));
        let [x, y, z] = line.point;
        let k = N::nearest(N::dot(line.point, d));
        let [x, y, z] = [x - along(k, d[0]), y - along(k, d[1]), z - along(k, d[2])];
        let major = around - minor;
        let (square, twice) = (N::squared_length([x, y, z]), major + major);
        // Each coordinate is off by 2.6 units at most, so that `f` is off by at most 10 times its lengths; and, in a
        // frame, by another unit or more, which adds 3.5 times the lengths for each.
        let doubt = 5.max(3 + line.framed_bits());
        if square > N::squared_length([around]) + (N::Product::from(around) << doubt) {
            return Attempt::Miss;
        }
        Attempt::Hit(Self {
            line,
            k,
            constant: square - N::squared_length([major, minor]),
            height: along(y, twice),
            rise: along(d[1], twice),
            minor: along(minor, twice),
            doubt,
        })
    }

    #[inline(always)]
    fn at(&self, u: N) -> At<N> {
        let s = N::nearest(self.constant + N::squared_length([u]));
        let (y, r) = (self.height + along(u, self.rise), self.minor);
        At {
            value: N::squared_length([s]) + N::dot([y - r], [y + r]),
            slope: N::dot([u + u, y], [s, self.rise]),
            lengths: N::Product::from(size(s)) + N::Product::from(size(y)) + N::Product::from(r),
        }
    }

    /// The coefficients `p` and `q` of the slope.
    #[inline(always)]
    fn slope(&self) -> [N; 2] {
        let p = self.constant + (N::squared_length([self.rise]) >> 1);
        [N::nearest(p), N::nearest(N::dot([self.height], [self.rise]) >> 1)]
    }

    /// The value at an extreme, if its sign is certain.
    #[inline(always)]
    fn value(&self, u: N) -> Attempt<N::Product> {
        if !is_near(u) {
            return Attempt::Hit(N::Product::ONE);
        }
        let At { value, lengths, .. } = self.at(u);
        if value.magnitude() > lengths << self.doubt { Attempt::Hit(value) } else { Attempt::Unsure }
    }

    /// The `t` of the root that Newton's method goes to from `u`, if it is accurate.
    #[inline(never)]
    fn root_from(&self, mut u: N) -> Attempt<N> {
        let OnGrid { unit, start, .. } = self.line;
        let spare = self.line.spare(0);
        if spare < 0 || unit as u32 >= N::BITS {
            return Attempt::Unsure;
        }
        for _ in 0..MOST_STEPS {
            if !is_near(u) {
                return Attempt::Unsure;
            }
            let At { value, slope, lengths } = self.at(u);
            let Some(step) = quotient(value >> 1, slope).filter(|step| is_near(*step)) else {
                return Attempt::Unsure;
            };
            u = u - step;
            if !is_short(step) {
                continue;
            }
            // The rounding changes `f` by at most 6.3 times the lengths, as that of a quadric: this is less than half a
            // unit of `t`.
            if slope.magnitude() < (lengths << N::FRACTION) >> spare as u32 {
                return Attempt::Unsure;
            }
            let from_start = u - self.k;
            let t = N::rounded_off(size(from_start).into(), unit as u32);
            return match start.checked_plus(if from_start < N::ZERO { -t } else { t }) {
                Some(t) => Attempt::Hit(t),
                None => Attempt::Unsure,
            };
        }
        Attempt::Unsure
    }

    /// The root beyond the first or the last minimum, where the function is convex: the steps of Newton's method do not
    /// pass it from farther away. It grows faster than the parabola at the minimum, whose root is farther away.
    #[inline(always)]
    fn beyond(&self, minimum: N, value: N::Product, p: N, is_last: bool) -> Attempt<N> {
        let square = N::squared_length([minimum]);
        // A fourth of it, since a divisor is at most 1.
        let bend = (square + square + square + p.at_unit()) >> 1;
        let Some(half) = quotient((-value) >> 2, bend).and_then(root) else { return Attempt::Unsure };
        self.root_from(if is_last { minimum + half } else { minimum - half })
    }
}

/// A third of a length of at least zero, within a hundredth of it, and not above it.
#[inline(always)]
fn third<N: Length>(length: N) -> N {
    length.down(2) + length.down(4) + length.down(6) + length.down(8)
}

/// The largest root of `v^3 + p v = q` for a `q` of at least zero.
#[inline(always)]
fn largest_root<N: Length>(p: N, q: N) -> Option<N> {
    // Both are above it, or the next step leads there: the root of q, if p is not negative, rounded up to a power of
    // two, and, if all roots are real, 2 sqrt(-p / 3).
    let mut v = N::from(1).up(N::FRACTION - (N::zeros([q]) - 2) / 3);
    if p < N::ZERO {
        let bound = root(third(-p) - p - p.down(7))?;
        v = v.max(bound);
    }
    for _ in 0..MOST_STEPS {
        let square = N::squared_length([v]);
        let value = along(v, N::nearest(square + p.at_unit())) - q;
        // Both are divided by four, since a divisor is at most 1.
        let step = quotient(value.at_unit() >> 2, (square + square + square + p.at_unit()) >> 2)?;
        if !is_near(step) {
            return None;
        }
        v = v - step;
        if is_short(step) {
            return Some(v);
        }
    }
    None
}

/// Where the line is inside a torus with these radii, the major and the minor one: in one interval or in two, or its
/// entry alone, if other ends are inaccurate. If `since` is given, only the first end at or after it is needed.
///
/// The origin is in units of `2^-extra_bits` of the unit of the lengths; the answer is in that unit.
#[inline(never)]
pub(in crate::scalar) fn torus<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    radii: [N; 2],
    since: Option<N>,
) -> Attempt<(InSide<N>, Option<InSide<N>>)> {
    let along = found!(Along::new(o, extra_bits, d, radii));
    let [p, q] = along.slope();
    let Some(largest) = largest_root(p, size(q)) else { return Attempt::Unsure };
    let extreme = if q > N::ZERO { -largest } else { largest };
    // The others are the roots of the quotient: half of -extreme -+ sqrt(rest).
    let square = N::squared_length([extreme]);
    let rest = -(square + square + square) - (p.at_unit() << 2);
    let unclear = N::from(1).up(N::FRACTION - 22);
    let inside = |ends: [N; 2]| InSide { ends, beyond: [N::ZERO; 2] };
    let is_enough = |enter: N| since.is_some_and(|since| enter >= since);
    let entered = |enter: N| InSide { ends: [enter, N::MAX], beyond: [N::ZERO, N::MAX] };
    let (first, last, between) = if N::high(rest) < -unclear {
        (extreme, extreme, None)
    } else if N::high(rest) < unclear {
        return Attempt::Unsure;
    } else {
        let root = N::root(rest);
        let [low, high] = [(-extreme - root).down(1), (root - extreme).down(1)];
        if q > N::ZERO { (extreme, high, Some(low)) } else { (low, extreme, Some(high)) }
    };
    let at_first = found!(along.value(first));
    let Some(between) = between else {
        if at_first > N::Product::ZERO {
            return Attempt::Miss;
        }
        let enter = found!(along.beyond(first, at_first, p, false));
        if !is_enough(enter)
            && let Attempt::Hit(exit) = along.beyond(first, at_first, p, true)
            && enter <= exit
        {
            return Attempt::Hit((inside([enter, exit]), None));
        }
        return Attempt::Hit((entered(enter), None));
    };
    let at_last = found!(along.value(last));
    let [meets_first, meets_last] = [at_first, at_last].map(|value| value < N::Product::ZERO);
    if !meets_first && !meets_last {
        return Attempt::Miss;
    }
    // Between the extremes Newton's method goes from the inflection to the root without passing it.
    let Some(inflection) = root(third(-p)) else { return Attempt::Unsure };
    let leaves_between = found!(along.value(between)) > N::Product::ZERO;
    let enter = found!(if meets_first { along.beyond(first, at_first, p, false) } else { along.root_from(inflection) });
    if is_enough(enter) {
        return Attempt::Hit((entered(enter), None));
    }
    let last_exit = || along.beyond(last, at_last, p, true);
    let has_two = meets_first && meets_last && leaves_between;
    let first_exit = if meets_first && leaves_between { along.root_from(-inflection) } else { last_exit() };
    let second = if has_two { [along.root_from(inflection), last_exit()] } else { [first_exit; 2] };
    if let (Attempt::Hit(exit), [Attempt::Hit(again), Attempt::Hit(last)]) = (first_exit, second)
        && enter <= exit
        && exit <= again
        && again <= last
    {
        return Attempt::Hit((inside([enter, exit]), has_two.then(|| inside([again, last]))));
    }
    Attempt::Hit((entered(enter), None))
}
