//! Whether a ray surely misses an axis-aligned box: without a division, by axes that separate the two.
//!
//! A convex set and another are apart if they are so along some axis (Gottschalk, Lin, Manocha, *OBBTree*, 1996). Of a box and a
//! piece of a line these are tried, the cheapest first: those of the box, away from which a ray may lead; the three that are
//! perpendicular to the line and to an edge; and the line's own direction, along which the piece is its range of `t`. With `c` the
//! centre seen from the ray's origin and `h` the half extents:
//!
//! ```text
//! c_x > h_x and d_x <= 0, c_x < -h_x and d_x >= 0  and cyclic, for a range from 0 or later
//! |d_y c_z - d_z c_y| > h_y |d_z| + h_z |d_y|      and cyclic
//! c . d + h . |d| < start,   c . d - h . |d| > end
//! ```
//!
//! The answer must never be "missed" for a ray for which a solid in the box reports a hit, and the solver rounds. Where it says that a
//! ray meets a solid, the point of the ray at that `t` lies next to the solid, nearer than a part of its distance from the origin
//! and of its size: [`MARGIN_BITS`]. The box is made larger by that: here by the part of the distance and by a few units, before
//! (by whoever makes the box) by the part of the size.

/// A box is made larger by the part `2^-MARGIN_BITS` of its size and of its distance.
///
/// `f32` is the coarsest number: a line seen from a frame is off by some units of 2^-24 of its length, and what that moves at a sharp
/// rim, or through a skewed placement, is up to 2^8 times as much (more is given no box).
pub(crate) const MARGIN_BITS: i32 = 14;

/// Defines the test for a float.
#[cfg(feature = "libm")]
macro_rules! separation {
    ($name:ident, $Float:ident) => {
        /// See [`FastPath::misses_box`](crate::scalar::FastPath::misses_box).
        #[inline(always)]
        pub(super) fn $name(
            [ox, oy, oz]: [$Float; 3],
            [dx, dy, dz]: [$Float; 3],
            [start, end]: [$Float; 2],
            [x, y, z]: [$Float; 3],
            half: [$Float; 3],
        ) -> bool {
            const PART: $Float = 1.0 / (1_u32 << MARGIN_BITS) as $Float;
            // Next to zero products vanish: what they lose is less than this.
            const TINY: $Float = 64.0 * $Float::MIN_POSITIVE;
            let (cx, cy, cz) = (x - ox, y - oy, z - oz);
            let (ex, ey, ez) = ($Float::abs(dx), $Float::abs(dy), $Float::abs(dz));
            let margin = ($Float::abs(cx) + $Float::abs(cy) + $Float::abs(cz)) * PART + TINY;
            let [hx, hy, hz] = half.map(|half| half + margin);
            let leaves = |c: $Float, h: $Float, d: $Float| (c > h && d <= 0.0) || (c < -h && d >= 0.0);
            if start >= 0.0 && (leaves(cx, hx, dx) || leaves(cy, hy, dy) || leaves(cz, hz, dz)) {
                return true;
            }
            // A comparison with NaN is false: what overflowed is not missed.
            if $Float::abs(dy * cz - dz * cy) > hy * ez + hz * ey
                || $Float::abs(dz * cx - dx * cz) > hz * ex + hx * ez
                || $Float::abs(dx * cy - dy * cx) > hx * ey + hy * ex
            {
                return true;
            }
            let (middle, reach) = (dx * cx + dy * cy + dz * cz, hx * ex + hy * ey + hz * ez);
            middle + reach < start || middle - reach > end
        }
    };
}
#[cfg(feature = "libm")]
separation!(misses_box_f32, f32);
#[cfg(feature = "libm")]
separation!(misses_box_f64, f64);

#[cfg(feature = "fixed")]
pub(super) use in_integers::{misses_box_32, misses_box_64};

/// For fixed types: numbers of at most 2^30 in magnitude, their products and sums in 64 bits.
#[cfg(feature = "fixed")]
mod in_integers {
    use super::MARGIN_BITS;
    use crate::scalar::integers::product;

    /// What halving, shifting and the rounding of `t` leave over, and as much again.
    const FEW_UNITS: i32 = 8;

    /// The largest of three.
    #[inline(always)]
    fn largest<T: Ord>([x, y, z]: [T; 3]) -> T {
        x.max(y).max(z)
    }

    /// True if an axis separates the box from the line within `range`, which is in units of 2^-30 of those of `c` and `h`.
    #[inline(always)]
    fn is_apart(c: [i32; 3], half: [i32; 3], d: [i32; 3], [start, end]: [i64; 2]) -> bool {
        let ([cx, cy, cz], [dx, dy, dz]) = (c, d);
        let [ex, ey, ez] = d.map(i32::abs);
        let margin = (largest(c.map(i32::abs)) >> MARGIN_BITS) + FEW_UNITS;
        let [hx, hy, hz] = half.map(|half| half + margin);
        let leaves = |c, h: i32, d| (c > h && d <= 0) || (c < -h && d >= 0);
        if start >= 0 && (leaves(cx, hx, dx) || leaves(cy, hy, dy) || leaves(cz, hz, dz)) {
            return true;
        }
        // Two products of less than 2^61 each.
        if (product(dy, cz) - product(dz, cy)).abs() > product(hy, ez) + product(hz, ey)
            || (product(dz, cx) - product(dx, cz)).abs() > product(hz, ex) + product(hx, ez)
            || (product(dx, cy) - product(dy, cx)).abs() > product(hx, ey) + product(hy, ex)
        {
            return true;
        }
        // Of a unit vector: at most twice 2^30 times 2^30, both together.
        let middle = product(dx, cx) + product(dy, cy) + product(dz, cz);
        let reach = product(hx, ex) + product(hy, ey) + product(hz, ez);
        middle + reach < start || middle - reach > end
    }

    /// See [`FastPath::misses_box`](crate::scalar::FastPath::misses_box), for raw numbers; directions have 30 fraction bits.
    #[inline(always)]
    pub(in crate::scalar) fn misses_box_32(
        o: [i32; 3],
        d: [i32; 3],
        range: [i32; 2],
        centre: [i32; 3],
        half: [i32; 3],
    ) -> bool {
        let ([ox, oy, oz], [x, y, z]) = (o, centre);
        // In units of two, so that the difference of any two coordinates in the budget fits.
        let c = [(x >> 1) - (ox >> 1), (y >> 1) - (oy >> 1), (z >> 1) - (oz >> 1)];
        is_apart(c, half.map(|half| half >> 1), d, range.map(|t| (t as i64) << 29))
    }

    /// See [`FastPath::misses_box`](crate::scalar::FastPath::misses_box), for raw numbers; directions have 62 fraction bits.
    #[inline(always)]
    pub(in crate::scalar) fn misses_box_64(
        o: [i64; 3],
        d: [i64; 3],
        range: [i64; 2],
        centre: [i64; 3],
        half: [i64; 3],
    ) -> bool {
        let ([ox, oy, oz], [x, y, z]) = (o, centre);
        let c = [(x >> 1) - (ox >> 1), (y >> 1) - (oy >> 1), (z >> 1) - (oz >> 1)];
        let half = half.map(|half| half >> 1);
        // In the finest unit in which all of them are below 2^30.
        let bits = 64 - (largest(c.map(i64::unsigned_abs)) | largest(half) as u64).leading_zeros();
        let shift = bits.saturating_sub(30);
        let coarse = |n: i64| (n >> shift) as i32;
        // What lies farther than any box is as good as infinite.
        let time = |t: i64| ((t >> 1 >> shift).clamp(-(1 << 32), 1 << 32)) << 30;
        let [start, end] = range.map(time);
        is_apart(c.map(coarse), half.map(coarse), d.map(|d| (d >> 32) as i32), [start, end])
    }
}

#[cfg(test)]
mod tests;
