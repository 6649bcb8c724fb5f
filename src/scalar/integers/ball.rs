//! A line and a ball.

use super::length::{Length, Product};
use super::{framed_bits, leading_zeros, most_bits, radius_grid};
use crate::scalar::{Attempt, found};

/// The closest approach of a line to a ball, for a direction assumed to have length 1: `k = o . d` and
/// `D = r^2 - |o - k d|^2`, so that `t = -k -+ sqrt(D)`.
pub(in crate::scalar) struct ByApproach<N: Length> {
    o: [N; 3],
    rr: N::Product,
    k: N,
    discriminant: N::Product,
    /// The error bound of the discriminant's upper half.
    certain: N,
    /// Lengths are in units of `2^-unit`.
    unit: u32,
}

impl<N: Length> ByApproach<N> {
    /// The origin is in units of `2^-extra_bits` of the radius's.
    #[inline(always)]
    pub(in crate::scalar) fn new(o: [N; 3], extra_bits: i32, d: [N; 3], r: N) -> Attempt<Self> {
        // There is no room here for an origin with more extra bits.
        let (o, extra_bits) = if extra_bits > N::FINER {
            (N::coarser(o, (extra_bits - N::FINER) as u32), N::FINER)
        } else {
            (o, extra_bits)
        };
        // All lengths are converted to the origin's unit, then to a grid on which none has more than BITS - 4 bits.
        let Some(r) = r.refined(extra_bits) else { return Attempt::Unsure };
        let all = o[0].top() | o[1].top() | o[2].top() | r.top();
        // A guarded grid is at least 16 times as fine as the origin, so that its rounding adds nothing.
        if all >> if N::GUARDS_APPROACH { 24 } else { 28 } != 0 {
            return Attempt::Unsure;
        }
        // The unit's exponent has five bits.
        let grid = leading_zeros(all | 1 << 4) - 4;
        let unit = grid + extra_bits as u32;
        // Products with the direction are cut off at the grid: an error of a unit and a half on each axis.
        let [x, y, z] = o.map(|length| length.up(grid));
        let k = N::portion([x, y, z], d);
        let along = |d: N| N::portion([k], [d]);
        let p = [x - along(d[0]), y - along(d[1]), z - along(d[2])];
        let rr = N::squared_length([r.up(grid)]);
        // That changes t by at most a third of a unit, and the error of a framed origin by a tenth.
        let known = if extra_bits == 0 { unit as i32 } else { N::FINER + 1 };
        let certain = if N::GUARDS_APPROACH {
            N::high(rr).down((2 * (known - 3)).clamp(0, 30) as u32) + N::from(2)
        } else {
            N::from(1)
        };
        Attempt::Hit(Self { o: [x, y, z], rr, k, discriminant: rr - N::squared_length(p), certain, unit })
    }

    /// Whether the line meets the ball at all.
    #[inline(always)]
    fn meets(&self) -> Attempt<()> {
        let discriminant = N::high(self.discriminant);
        if discriminant >= self.certain {
            Attempt::Hit(())
        } else if discriminant <= -self.certain {
            Attempt::Miss
        } else {
            Attempt::Unsure
        }
    }

    /// The two ends, in the radius's unit.
    #[inline(always)]
    pub(in crate::scalar) fn ends(self) -> Attempt<[N; 2]> {
        found!(self.meets());
        let root = N::root(self.discriminant);
        let middle = N::from(((1_u32 << self.unit) >> 1) as i32) - self.k;
        Attempt::Hit([(middle - root).down(self.unit), (middle + root).down(self.unit)])
    }

    /// Whether there is an end at `t >= 0`; the same result as that of [`ByApproach::ends`].
    #[inline(always)]
    pub(in crate::scalar) fn meets_ahead(self) -> Attempt<()> {
        found!(self.meets());
        if self.k < N::ZERO {
            return Attempt::Hit(());
        }
        // The line leads away: the far end is at -c / (k + sqrt(D)), and an end within half a unit of the type of zero
        // counts as zero; here within one. (The grid must be so fine that its rounding cannot decide this.) The square
        // of the direction's length may be off by 2^-19.
        let near = self.k.down(N::BITS - 1 - self.unit) + N::high(N::squared_length([self.k])).down(18) + N::from(2);
        let c = N::high(N::squared_length(self.o) - self.rr);
        if self.unit < 4 || (-near <= c && c <= near) {
            Attempt::Unsure
        } else if c < N::ZERO {
            Attempt::Hit(())
        } else {
            Attempt::Miss
        }
    }
}

/// The closest approach of a line to a ball, from its Pluecker moment `w = o x d`: `D = a r^2 - |w|^2`, so that
/// `t = (-k -+ sqrt(D)) / a`.
///
/// `k` is exact; `a = 1 + e` with a small `e`.
pub(in crate::scalar) struct ByMoment<N: Length> {
    d: [N; 3],
    k: N::Product,
    rr: N::Product,
    /// `r^2 - |w|^2`
    residual: N::Product,
    /// Radius and moment are in units of `2^-grid`, `k` of `2^-(FRACTION + extra_bits)`, which is finer by `down` bits.
    grid: i32,
    down: u32,
    extra_bits: i32,
}

impl<N: Length> ByMoment<N> {
    /// The origin is in units of `2^-extra_bits` of the radius's.
    #[inline(always)]
    pub(in crate::scalar) fn new(o: [N; 3], extra_bits: i32, d: [N; 3], r: N) -> Attempt<Self> {
        // The moment is shifted down to the radius's grid.
        let Some((grid, down)) = radius_grid(r, extra_bits).filter(|(grid, _)| *grid >= 4 && N::have_room(o)) else {
            return Attempt::Unsure;
        };
        let ([x, y, z], [dx, dy, dz]) = (o, d);
        let w = [N::minor([y, z], [dy, dz]), N::minor([z, x], [dz, dx]), N::minor([x, y], [dx, dy])];
        let [wx, wy, wz] = w.map(Product::magnitude);
        // Twice the radius or more.
        if N::reaches(wx | wy | wz, down) {
            return Attempt::Miss;
        }
        let on_grid = |minor| N::rounded_off(minor, down);
        let rr = N::squared_length([r.up(grid as u32)]);
        let residual = rr - N::squared_length([on_grid(wx), on_grid(wy), on_grid(wz)]);
        Attempt::Hit(Self { d, k: N::dot(o, d), rr, residual, grid, down, extra_bits })
    }

    /// The upper half of the smallest square of the root, which is at most `2^-most` of the radius's.
    ///
    /// The moment's rounding, half a unit of the grid, then moves `t` by no more than a thirtieth of a unit. The error
    /// of a framed origin, a hundredth of a unit, becomes a sixth of a unit.
    #[inline(always)]
    fn certain(&self, most: i32) -> N {
        let most = most_bits::<N>(self.extra_bits, self.grid).min(most);
        N::high(self.rr).down((2 * (self.grid - 5)).min(most).max(3) as u32)
    }

    /// The two ends, in the radius's unit; with `is_strict` only if it is certain that they exist.
    #[inline(always)]
    pub(in crate::scalar) fn ends(self, is_strict: bool) -> Attempt<[N; 2]> {
        let Some(e) = N::excess(N::squared_length(self.d)) else { return Attempt::Unsure };
        let discriminant = self.residual + N::share(self.rr, e);
        let (upper, certain) = (N::high(discriminant), self.certain(22));
        // Three roundings of the moment, and those of a framed origin.
        let doubt = N::from(1).up(framed_bits(self.extra_bits, self.grid) as u32);
        if upper < certain || (is_strict && upper <= doubt) {
            return if upper < -doubt { Attempt::Miss } else { Attempt::Unsure };
        }
        let root = N::root(discriminant).raised(self.down);
        let end = |numerator| N::rounded(N::without_excess(numerator, e), self.extra_bits);
        let ends = [end(-self.k - root), end(root - self.k)];
        // Rounding may decide whether an end is beyond the type.
        let is_beyond = |t: N| t == N::MAX || t == -N::MAX;
        if is_strict && (is_beyond(ends[0]) || is_beyond(ends[1])) { Attempt::Unsure } else { Attempt::Hit(ends) }
    }

    /// Whether there is an end at `t >= 0`; the same result as that of [`ByMoment::ends`].
    #[inline(always)]
    pub(in crate::scalar) fn meets_ahead(self) -> Attempt<()> {
        // For any length of the direction within the bounds of a unit vector.
        let (residual, certain) = (N::high(self.residual), self.certain(17));
        if residual < certain {
            return if residual < -certain { Attempt::Miss } else { Attempt::Unsure };
        }
        // The line starts so far away that an end may be beyond the type.
        if N::high(self.k).top() >= 1 << 28 {
            return Attempt::Unsure;
        }
        if N::high(self.k) < N::ZERO {
            return Attempt::Hit(());
        }
        // The line leads away: the far end is at (k^2 - D) / -(k + sqrt(D)), and an end within half a unit of the type
        // of zero counts as zero.
        if N::reaches(self.k, self.down) {
            return Attempt::Miss;
        }
        let k = N::rounded_off(self.k, self.down);
        let beyond = N::high(N::squared_length([k]) - self.residual);
        // Two units, or the error of the discriminant from the direction's length.
        let near = k.down(N::FRACTION - self.grid as u32) + N::high(self.rr).down(18) + N::from(2);
        if beyond > near {
            Attempt::Miss
        } else if beyond < -near {
            Attempt::Hit(())
        } else {
            Attempt::Unsure
        }
    }
}
