//! A line and a cuboid, as with 32 bits.

use super::{Digits, crossings, minor, refined, upper_bits};
use crate::scalar::{Attempt, InCuboid, found};

/// A line along one axis, mirrored so that it does not descend: it crosses the planes of the two faces at `t = low / d` and `t = high / d`.
#[derive(Clone, Copy)]
struct Slab {
    axis: usize,
    o: i64,
    d: i64,
    half: i64,
    low: i64,
    high: i64,
}

impl Slab {
    /// The origin is in units of `2^-finer` of the half extent's. `None` if there is no room for the products.
    #[inline(always)]
    fn new(axis: usize, o: i64, finer: i32, d: i64, half: i64) -> Option<Self> {
        let reach = refined(half, finer)?;
        if (upper_bits(o) | upper_bits(reach)) >> 28 != 0 {
            return None;
        }
        let (o, d) = if d < 0 { (-o, -d) } else { (o, d) };
        Some(Self { axis, o, d, half, low: -reach - o, high: reach - o })
    }
}

/// How `a / d_a` compares with `b / d_b`, times `d_a d_b`.
#[inline(always)]
fn difference(a: i64, d_a: i64, b: i64, d_b: i64) -> i128 {
    minor([Digits::new(a), Digits::new(b)], [Digits::new(d_a), Digits::new(d_b)])
}

/// The slabs of a cuboid, and by how much the rounding of the line may move a difference of their crossings.
struct Slabs {
    each: [Slab; 3],
    finer: i32,
    doubt: i128,
}

impl Slabs {
    #[inline(always)]
    fn new(o: [i64; 3], finer: i32, d: [i64; 3], half: [i64; 3]) -> Attempt<Self> {
        let slab = |axis: usize| Slab::new(axis, o[axis], finer, d[axis], half[axis]);
        let (Some(x), Some(y), Some(z)) = (slab(0), slab(1), slab(2)) else {
            return Attempt::Unsure;
        };
        // The direction of a framed line is off by a unit: it may lead the other way.
        if finer != 0 && (x.d <= 1 || y.d <= 1 || z.d <= 1) {
            return Attempt::Unsure;
        }
        // In the world the products are exact. A framed origin is off by less than two of its units, and the direction by less than one: two products
        // of at most 2 2^62, and two of at most 2^62.
        let doubt = if finer == 0 { 0 } else { 1_i128 << 65 };
        Attempt::Found(Self { each: [x, y, z], finer, doubt })
    }

    /// The last of the planes by which the line enters a slab; a miss if a slab ends before it.
    #[inline(always)]
    fn entry(&self) -> Attempt<Slab> {
        let mut last: Option<Slab> = None;
        for slab in self.each {
            if slab.d == 0 {
                if slab.low > 0 || slab.high < 0 {
                    return Attempt::Miss;
                }
                // In the plane of a face, which owns the ends.
                if slab.low == 0 || slab.high == 0 {
                    return Attempt::Unsure;
                }
                continue;
            }
            last = match last {
                None => Some(slab),
                Some(own) => {
                    let later = difference(slab.low, slab.d, own.low, own.d);
                    if later.abs() <= self.doubt {
                        return Attempt::Unsure;
                    }
                    Some(if later > 0 { slab } else { own })
                }
            };
        }
        let Some(enter) = last else { return Attempt::Unsure };
        for slab in self.each {
            if slab.axis != enter.axis && slab.d != 0 {
                let inside = difference(slab.high, slab.d, enter.low, enter.d);
                if inside < -self.doubt {
                    return Attempt::Miss;
                }
                if inside <= self.doubt {
                    return Attempt::Unsure;
                }
            }
        }
        Attempt::Found(enter)
    }

    /// The first of the planes by which the line leaves a slab, with its axis.
    #[inline(always)]
    fn exit(&self) -> Attempt<(i64, usize)> {
        let mut first: Option<Slab> = None;
        for slab in self.each {
            if slab.d == 0 {
                // In the plane of a face, which owns the end.
                if slab.low >= 0 || slab.high <= 0 {
                    return Attempt::Unsure;
                }
                continue;
            }
            first = match first {
                None => Some(slab),
                Some(own) => {
                    let later = difference(slab.high, slab.d, own.high, own.d);
                    if later.abs() <= self.doubt {
                        return Attempt::Unsure;
                    }
                    Some(if later < 0 { slab } else { own })
                }
            };
        }
        let Some(exit) = first else { return Attempt::Unsure };
        let [t, _] = found!(crossings(exit.o, self.finer, exit.d, [exit.half; 2]));
        Attempt::Found((t, exit.axis))
    }
}

/// The interval of the line inside the cuboid with these half extents about the origin.
///
/// The origin is in units of `2^-finer` of the half extents'; the ends are in theirs. See [`LocalLine::since`](crate::scalar::LocalLine) for
/// `since`.
#[inline(always)]
pub(in crate::scalar) fn cuboid(
    o: [i64; 3],
    finer: i32,
    d: [i64; 3],
    half: [i64; 3],
    since: Option<i64>,
) -> Attempt<InCuboid<i64>> {
    let slabs = found!(Slabs::new(o, finer, d, half));
    // A slab that lies behind the start. In a frame that is certain of two units of `t`: one that is nearer may be rounded to zero, which counts.
    let [x, y, z] = slabs.each;
    let least = if finer == 0 { 0 } else { -(2 << (finer & 0x1f)) };
    if since.is_some_and(|since| since >= 0) && (x.high < least || y.high < least || z.high < least) {
        return Attempt::Miss;
    }
    let enter = found!(slabs.entry());
    let [first, _] = found!(crossings(enter.o, finer, enter.d, [-enter.half; 2]));
    if since.is_some_and(|since| first >= since) {
        return Attempt::Found(InCuboid { ends: [first, i64::MAX], axes: [enter.axis; 2] });
    }
    let (second, exit) = found!(slabs.exit());
    // Two ends less than a unit apart may be rounded in the other order.
    if first > second {
        return Attempt::Unsure;
    }
    Attempt::Found(InCuboid { ends: [first, second], axes: [enter.axis, exit] })
}

/// Where a line that starts on the surface leads out of the cuboid, and the axis of that face.
#[inline(always)]
pub(in crate::scalar) fn exit_from_cuboid(
    o: [i64; 3],
    finer: i32,
    d: [i64; 3],
    half: [i64; 3],
) -> Attempt<(i64, usize)> {
    found!(Slabs::new(o, finer, d, half)).exit()
}
