//! A line and a cuboid.

use super::flat::crossing;
use super::length::{Length, Product};
use crate::scalar::{Attempt, InCuboid, found};

/// A framed component of a direction up to this may have the wrong sign.
const STEP: i32 = 2;

/// A line along one axis, mirrored so that it does not descend: it crosses the planes of the two faces at `t = low / d`
/// and `t = high / d`.
#[derive(Clone, Copy)]
struct Slab<N> {
    axis: usize,
    o: N,
    d: N,
    half: N,
    low: N,
    high: N,
}

impl<N: Length> Slab<N> {
    #[inline(always)]
    fn new(axis: usize, o: N, extra_bits: i32, d: N, half: N) -> Option<Self> {
        let half_beside_o = half.refined_beside(o, extra_bits)?;
        let (o, d) = if d < N::ZERO { (-o, -d) } else { (o, d) };
        Some(Self { axis, o, d, half, low: -half_beside_o - o, high: half_beside_o - o })
    }

    /// Whether a line parallel to the planes is between them; a miss if it is outside them. If it lies in one of them,
    /// the face owns the ends.
    #[inline(always)]
    fn is_between(&self) -> Attempt<()> {
        if self.d != N::ZERO || (self.low < N::ZERO && self.high > N::ZERO) {
            Attempt::Hit(())
        } else if self.low > N::ZERO || self.high < N::ZERO {
            Attempt::Miss
        } else {
            Attempt::Unsure
        }
    }
}

/// The slabs of a cuboid, and the largest change of a difference of their crossings by the rounding of the line.
struct Slabs<N: Length> {
    each: [Slab<N>; 3],
    extra_bits: i32,
    doubt: N::Product,
}

impl<N: Length> Slabs<N> {
    /// The origin is in units of `2^-extra_bits` of the half extents'.
    #[inline(always)]
    fn new(o: [N; 3], extra_bits: i32, d: [N; 3], half: [N; 3]) -> Attempt<Self> {
        let slab = |axis: usize| Slab::new(axis, o[axis], extra_bits, d[axis], half[axis]);
        let (Some(x), Some(y), Some(z)) = (slab(0), slab(1), slab(2)) else {
            return Attempt::Unsure;
        };
        let step = N::from(STEP);
        if extra_bits != 0 && (x.d <= step || y.d <= step || z.d <= step) {
            return Attempt::Unsure;
        }
        if x.d == N::ZERO || y.d == N::ZERO || z.d == N::ZERO {
            found!(x.is_between());
            found!(y.is_between());
            found!(z.is_between());
        }
        // In the world the products are exact. In a frame the errors of origin and direction are each less than two of
        // their units: two products of at most 2 * 2^(BITS - 2), and two of at most 2 * 2^(BITS - 1).
        let doubt = if extra_bits == 0 { N::Product::ZERO } else { N::Product::ONE << (N::BITS + 2) };
        Attempt::Hit(Self { each: [x, y, z], extra_bits, doubt })
    }

    /// Of the planes that `crossed` names, the one that the line crosses after all others, or, unless `is_last`, before
    /// them; then the other two slabs.
    ///
    /// For a line parallel to two planes and between them, `low / 0` and `high / 0` are infinite with the signs of
    /// `low` and `high`, so that its slab is never chosen.
    #[inline(always)]
    fn decisive(&self, crossed: impl Fn(&Slab<N>) -> N, is_last: bool) -> Attempt<[Slab<N>; 3]> {
        let decides = |other: &Slab<N>, own: &Slab<N>| {
            let later = N::minor([crossed(other), crossed(own)], [other.d, own.d]);
            if -self.doubt <= later && later <= self.doubt {
                // Both are infinite: neither is decisive, and `own` is kept.
                let are_infinite = other.d == N::ZERO && own.d == N::ZERO;
                return if are_infinite { Attempt::Hit(false) } else { Attempt::Unsure };
            }
            Attempt::Hit((later > N::Product::ZERO) == is_last)
        };
        let [x, y, z] = self.each;
        let [own, other] = if found!(decides(&y, &x)) { [y, x] } else { [x, y] };
        Attempt::Hit(if found!(decides(&z, &own)) { [z, own, other] } else { [own, other, z] })
    }

    /// The last of the planes by which the line enters a slab; a miss if a slab ends before it.
    #[inline(always)]
    fn entry(&self) -> Attempt<Slab<N>> {
        let [enter, first, second] = found!(self.decisive(|slab| slab.low, true));
        for slab in [first, second] {
            let inside = N::minor([slab.high, enter.low], [slab.d, enter.d]);
            if inside < -self.doubt {
                return Attempt::Miss;
            }
            if inside <= self.doubt {
                return Attempt::Unsure;
            }
        }
        Attempt::Hit(enter)
    }

    /// The first of the planes by which the line leaves a slab, with its axis.
    #[inline(always)]
    fn exit(&self) -> Attempt<(N, usize)> {
        match self.decisive(|slab| slab.high, false) {
            Attempt::Hit([exit, ..]) => {
                Attempt::Hit((found!(crossing(exit.o, self.extra_bits, exit.d, exit.half)), exit.axis))
            }
            // The line has been inside, whatever its rounded coordinates are.
            _ => Attempt::Unsure,
        }
    }
}

/// The interval of the line inside the cuboid with these half extents about the origin.
///
/// The origin is in units of `2^-extra_bits` of the half extents'; the ends are in theirs. See
/// [`LocalLine::since`](crate::scalar::LocalLine) for `since`.
#[inline(always)]
pub(in crate::scalar) fn cuboid<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    half: [N; 3],
    since: Option<N>,
) -> Attempt<InCuboid<N>> {
    let slabs = found!(Slabs::new(o, extra_bits, d, half));
    // A slab that lies behind the start. In a frame that is certain from two units of `t` on: an end that is nearer may
    // be rounded to zero, which counts as a hit.
    let [x, y, z] = slabs.each;
    let least = if extra_bits == 0 { N::ZERO } else { -N::from(2).up(extra_bits as u32) };
    if since.is_some_and(|since| since >= N::ZERO) && (x.high < least || y.high < least || z.high < least) {
        return Attempt::Miss;
    }
    let enter = found!(slabs.entry());
    let first = found!(crossing(enter.o, extra_bits, enter.d, -enter.half));
    let entry_alone = Attempt::Hit(InCuboid { ends: [first, N::MAX], axes: [enter.axis; 2] });
    if since.is_some_and(|since| first >= since) {
        return entry_alone;
    }
    match slabs.exit() {
        Attempt::Hit((second, exit)) if first <= second => {
            Attempt::Hit(InCuboid { ends: [first, second], axes: [enter.axis, exit] })
        }
        // Two ends less than a unit apart may be rounded in the other order.
        _ => entry_alone,
    }
}

/// Where a line that starts on the surface leaves the cuboid, and the axis of that face.
#[inline(always)]
pub(in crate::scalar) fn exit_from_cuboid<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    half: [N; 3],
) -> Attempt<(N, usize)> {
    found!(Slabs::new(o, extra_bits, d, half)).exit()
}

#[cfg(units)]
#[expect(clippy::expect_used, clippy::panic, reason = "a test may panic")]
#[path = "../../../tests/units/scalar/integers/cuboid.rs"]
mod tests;
