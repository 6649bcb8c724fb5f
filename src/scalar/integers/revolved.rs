//! A line and a quadric of revolution, on the grid of fixed point. The words of the comments are those of
//! [`integers`](super).

use super::length::{Length, Normalized, Product};
use super::roots::{OnGrid, Roots, along, is_steep, other_root};
use crate::scalar::{Attempt, InSide, found};

/// A quadric of revolution: `x^2 + z^2 = a y^2 + 2 b y + r^2`.
#[derive(Clone, Copy)]
pub(in crate::scalar) struct Quadric<N> {
    r: N,
    b: N,
    /// `a / 2^2f`, as a component of a direction: at most 1.
    ratio: N,
    /// The number `f`.
    halvings: u32,
}

impl<N: Length> Quadric<N> {
    /// The number `one` is 1 in the unit of `a`; `None` if `a` has no room.
    #[inline(always)]
    pub(in crate::scalar) fn new([a, b, r]: [N; 3], one: N) -> Option<Self> {
        let fraction = N::BITS - 1 - N::zeros([one]);
        let mut halvings = 0;
        while fraction + 2 * halvings <= N::FRACTION {
            if a.max(-a) <= one.up(2 * halvings) {
                return Some(Self { r, b, ratio: a.up(N::FRACTION - fraction - 2 * halvings), halvings });
            }
            halvings += 1;
        }
        None
    }
}

/// `product * ratio`; the negated product gives the negated result.
#[inline(always)]
fn times<N: Length>(product: N::Product, ratio: N) -> N::Product {
    let size = product.magnitude();
    let below = N::low((size >> 2).lowest(N::BITS - 2));
    let part = (N::dot([N::high(size)], [ratio]) << 2) + (N::dot([below], [ratio]) >> (N::BITS - 4));
    if product < N::Product::ZERO { -part } else { part }
}

/// A line in the coordinates `X = x / 2^f`, `Z = z / 2^f`, in which the quadric is `X^2 + Z^2 = A y^2 + 2 B y + R^2`,
/// with `A` of at most 1. Along the line the difference of the two sides is `a t^2 + 2 k t + c`.
struct Scaled<N: Length> {
    line: OnGrid<N>,
    /// `R` and `B`.
    lengths: [N; 2],
    /// `A`
    ratio: N,
    a: N::Product,
    /// The leading digits of `a`.
    digits: N::Normalized,
}

impl<N: Length> Scaled<N> {
    /// The line of [`OnGrid::new`].
    #[inline(always)]
    fn new(o: [N; 3], extra_bits: i32, d: [N; 3], of: Quadric<N>, departs: bool, is_strict: bool) -> Attempt<Self> {
        let Quadric { r, b, ratio, halvings } = of;
        let (line, [r, b]) = found!(OnGrid::new(o, extra_bits, d, [r, b], departs, is_strict));
        let half = |times: u32| N::from(1).up(N::FRACTION - times);
        let across = |length: N| along(length, half(halvings));
        let ([x, y, z], [dx, dy, dz]) = (line.point, d);
        let (point, direction) = ([across(x), y, across(z)], [across(dx), dy, across(dz)]);
        let [dx, dy, dz] = direction;
        let a = N::squared_length([dx, dz]) - times::<N>(N::squared_length([dy]), ratio);
        let Some(digits) = N::Normalized::new(a) else {
            return Attempt::Unsure;
        };
        let lengths = [across(r), along(b, half(2 * halvings))];
        Attempt::Hit(Self { line: OnGrid { point, direction, ..line }, lengths, ratio, a, digits })
    }

    #[inline(always)]
    fn k(&self) -> N::Product {
        let ([x, y, z], [dx, dy, dz], [_, b]) = (self.line.point, self.line.direction, self.lengths);
        N::dot([x, z], [dx, dz]) - times::<N>(N::dot([y], [dy]), self.ratio) - N::dot([b], [dy])
    }

    /// The discriminant `D = A (Wx^2 + Wz^2) - Wy^2 + R^2 a + B (B dy^2 + 2 (Wx dz - Wz dx))` of the line's Pluecker
    /// moment `W`, and the sum of the lengths of [`OnGrid::doubt`].
    ///
    /// Each component of the moment is off by 2.6 units at most, `R` and `B` by 1.5, so that `D` is off by at most 12
    /// times the sum.
    #[inline(always)]
    fn discriminant(&self) -> (N::Product, N::Product) {
        let ([x, y, z], [dx, dy, dz], [r, b]) = (self.line.point, self.line.direction, self.lengths);
        let w = [N::minor([y, z], [dy, dz]), N::minor([z, x], [dz, dx]), N::minor([x, y], [dx, dy])].map(N::nearest);
        let [wx, wy, wz] = w;
        let round = self.digits.of_square(r);
        let round = if is_steep::<N>(self.a) { -round } else { round };
        let shifted =
            N::squared_length([along(b, dy)]) + (N::dot([b], [N::nearest(N::minor([wx, wz], [dx, dz]))]) << 1);
        let discriminant =
            times::<N>(N::squared_length([wx, wz]), self.ratio) - N::squared_length([wy]) + round + shifted;
        let size = |length: N| N::Product::from(length).magnitude();
        (discriminant, size(wx) + size(wy) + size(wz) + size(r) + size(b))
    }
}

/// Where the line is inside the quadric: in one interval or in two.
///
/// The origin is in units of `2^-extra_bits` of the unit of the lengths; the answer is in that unit.
#[inline(never)]
pub(in crate::scalar) fn quadric<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    of: Quadric<N>,
    is_strict: bool,
) -> Attempt<(InSide<N>, Option<InSide<N>>)> {
    let line = found!(Scaled::new(o, extra_bits, d, of, false, is_strict));
    let (discriminant, lengths) = line.discriminant();
    let is_steep = is_steep::<N>(line.a);
    if is_steep && discriminant < -line.line.doubt(lengths) {
        return Attempt::Hit((InSide { ends: [-N::MAX, N::MAX], beyond: [N::ZERO; 2] }, None));
    }
    let roots = found!(Roots::new(line.line, (line.a, line.digits), || line.k(), discriminant, lengths));
    let (first, second) = (roots.first(), roots.second());
    if !is_steep {
        return Attempt::Hit((found!(roots.between(first, second)), None));
    }
    let until = found!(roots.between((-N::MAX, true), second));
    Attempt::Hit((until, Some(found!(roots.between(first, (N::MAX, true))))))
}

/// Where a line that begins in the side and leads inwards leaves the quadric: the other root of `a t^2 + 2 k t`,
/// whatever its rounded coordinates are; infinite if it does not leave it.
#[inline(never)]
pub(in crate::scalar) fn exit_from_quadric<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    of: Quadric<N>,
    is_strict: bool,
) -> Attempt<N> {
    let line = found!(Scaled::new(o, extra_bits, d, of, true, is_strict));
    let Some((t, is_near)) = other_root(&line.line, line.digits, line.k()) else { return Attempt::Unsure };
    if is_steep::<N>(line.a) {
        // It starts at the second end, behind which it stays inside.
        return if t < -N::from(1) { Attempt::Hit(N::MAX) } else { Attempt::Unsure };
    }
    if N::ZERO < t && is_near { Attempt::Hit(t) } else { Attempt::Unsure }
}
