//! Conservative test of a ray against an axis-aligned box, by slabs.
//!
//! A box is the intersection of three slabs, and a line is in each slab for an interval of `t` (Kay and Kajiya, *Ray
//! tracing complex scenes*, 1986). With the centre `c` relative to the ray's origin, the half extents `h` and the
//! direction `d` these are
//!
//! ```text
//! [c_x / d_x - h_x / |d_x|, c_x / d_x + h_x / |d_x|]     and cyclic
//! ```
//!
//! The ray misses if these intervals and its range have no `t` in common. The reciprocals are computed once for each
//! ray. A component of the direction below 2^-16 (2^-20 for floats) is replaced by that value, so that there is no
//! division by zero.
//!
//! The test must never report a miss if a query reports a hit of a solid in the box, although queries round. For a
//! reported hit, the distance of the ray's point at `t` from the solid is less than the fraction `2^-MARGIN_BITS` of
//! its distance from the origin and of its size. The box is enlarged by that: by the fraction of the size when it is
//! built, by the fraction of the distance and a few units here. The error of the reciprocals is less than half of the
//! margin.

use super::Real;

/// A box is enlarged by the fraction `2^-MARGIN_BITS` of its size and of its distance.
///
/// The least accurate number is `f32`: the error of a line in a frame is some units of 2^-24 of its length. At a sharp
/// rim, or in a skewed placement, the error of the hit point is up to 2^8 times as large. (Objects for which it may be
/// larger have no box.)
pub(crate) const MARGIN_BITS: i32 = 14;

/// The values that all tests of a ray against boxes share.
#[derive(Clone, Copy, Debug)]
pub struct Slabs<N, R> {
    pub(super) origin: [N; 3],
    /// The reciprocals of the direction's components: floats as they are, integers as `reciprocal` gives them.
    pub(super) reciprocals: [R; 3],
}

/// For floats.
impl<F: Real> Slabs<F, F> {
    #[inline(always)]
    pub(super) fn new(origin: [F; 3], d: [F; 3]) -> Self {
        let least = F::ONE.scaled(-20);
        let reciprocal = |d: F| {
            let magnitude = d.abs();
            let reciprocal = F::ONE / if magnitude < least { least } else { magnitude };
            if d.is_negative() { -reciprocal } else { reciprocal }
        };
        Self { origin, reciprocals: d.map(reciprocal) }
    }

    /// See [`Culling::misses_box`](crate::scalar::Culling::misses_box).
    #[inline(always)]
    pub(super) fn misses(&self, [start, end]: [F; 2], [x, y, z]: [F; 3], [hx, hy, hz]: [F; 3]) -> bool {
        let ([ox, oy, oz], [ix, iy, iz]) = (self.origin, self.reciprocals);
        let (cx, cy, cz) = (x - ox, y - oy, z - oz);
        // Products close to zero underflow: the error of that is less than the second term.
        let margin = (cx.abs() + cy.abs() + cz.abs()) * F::ONE.scaled(-MARGIN_BITS) + F::SMALLEST.scaled(6);
        let (mut first, mut last) = (start, end);
        for (c, h, reciprocal) in [(cx, hx, ix), (cy, hy, iy), (cz, hz, iz)] {
            let (middle, half_width) = (c * reciprocal, (h + margin) * reciprocal.abs());
            // A comparison with NaN is false.
            if middle - half_width > first {
                first = middle - half_width;
            }
            if middle + half_width < last {
                last = middle + half_width;
            }
        }
        // If a value has overflowed, beyond some 2^106, the result is no miss.
        first > last && first < F::INFINITY && last > -F::INFINITY
    }
}

/// For fixed types: numbers of at most 2^30 in magnitude, their products in 64 bits.
#[cfg(feature = "fixed")]
mod in_integers {
    use super::{MARGIN_BITS, Slabs};
    use crate::number::machine::reciprocal_of_normalized;
    use crate::scalar::integers::product;

    /// Twice the error from halving, shifting and the rounding of `t`.
    const FEW_UNITS: i32 = 8;

    /// Fraction bits of a `t` here.
    const FINER: u32 = 15;

    /// The largest of three.
    #[inline(always)]
    fn largest<T: Ord>([x, y, z]: [T; 3]) -> T {
        x.max(y).max(z)
    }

    /// `2^45 / d`, for a component of a direction with 30 fraction bits: at least 2^15, with a relative error of at
    /// most 2^-15.
    #[inline(always)]
    fn reciprocal(d: i32) -> i32 {
        let magnitude = d.unsigned_abs().max(1 << 14);
        let zeros = magnitude.leading_zeros();
        // 2^63 / (magnitude 2^zeros), below 2^32
        let reciprocal = (reciprocal_of_normalized(magnitude << zeros) >> 1 >> 17_u32.saturating_sub(zeros)) as i32;
        if d < 0 { -reciprocal } else { reciprocal }
    }

    /// True if the slabs and `range` have nothing in common; `c`, `half` and `range` are in one unit, the range with
    /// [`FINER`] fraction bits.
    #[inline(always)]
    fn are_apart(c: [i32; 3], half: [i32; 3], reciprocals: [i32; 3], [start, end]: [i64; 2]) -> bool {
        // The margin is larger than that of floats, since the reciprocals and the least components are coarser.
        let margin = (largest(c.map(i32::abs)) >> (MARGIN_BITS - 1)) + FEW_UNITS;
        let ([cx, cy, cz], [hx, hy, hz], [ix, iy, iz]) = (c, half, reciprocals);
        let (mut first, mut last) = (start, end);
        for (c, h, reciprocal) in [(cx, hx, ix), (cy, hy, iy), (cz, hz, iz)] {
            // Two products of at most 2^61 each.
            let (middle, half_width) = (product(c, reciprocal), product(h + margin, reciprocal.abs()));
            first = first.max(middle - half_width);
            last = last.min(middle + half_width);
        }
        first > last
    }

    impl Slabs<i32, i32> {
        /// From raw numbers; directions have 30 fraction bits.
        #[inline(always)]
        pub(in crate::scalar) fn new(o: [i32; 3], d: [i32; 3]) -> Self {
            // In units of two, so that the difference of any two coordinates in the budget fits.
            Self { origin: o.map(|o| o >> 1), reciprocals: d.map(reciprocal) }
        }

        /// See [`Culling::misses_box`](crate::scalar::Culling::misses_box), for raw numbers.
        #[inline(always)]
        pub(in crate::scalar) fn misses(&self, range: [i32; 2], [x, y, z]: [i32; 3], half: [i32; 3]) -> bool {
            let [ox, oy, oz] = self.origin;
            let c = [(x >> 1) - ox, (y >> 1) - oy, (z >> 1) - oz];
            are_apart(c, half.map(|half| half >> 1), self.reciprocals, range.map(|t| (t as i64) << (FINER - 1)))
        }
    }

    impl Slabs<i64, i32> {
        /// From raw numbers; directions have 62 fraction bits.
        #[inline(always)]
        pub(in crate::scalar) fn new(o: [i64; 3], d: [i64; 3]) -> Self {
            Self { origin: o.map(|o| o >> 1), reciprocals: d.map(|d| reciprocal((d >> 32) as i32)) }
        }

        /// See [`Culling::misses_box`](crate::scalar::Culling::misses_box), for raw numbers.
        #[inline(always)]
        pub(in crate::scalar) fn misses(&self, range: [i64; 2], [x, y, z]: [i64; 3], half: [i64; 3]) -> bool {
            let [ox, oy, oz] = self.origin;
            let c = [(x >> 1) - ox, (y >> 1) - oy, (z >> 1) - oz];
            let half = half.map(|half| half >> 1);
            // In the finest unit in which all of them are below 2^30.
            let bits = 64 - (largest(c.map(i64::unsigned_abs)) | largest(half) as u64).leading_zeros();
            let shift = bits.saturating_sub(30);
            let coarse = |n: i64| (n >> shift) as i32;
            // A `t` farther away than any box has the same effect as infinity.
            let time = |t: i64| (t >> 1 >> shift).clamp(-(1 << 47), 1 << 47) << FINER;
            are_apart(c.map(coarse), half.map(coarse), self.reciprocals, range.map(time))
        }
    }
}

#[cfg(units)]
#[path = "../../tests/units/scalar/slabs.rs"]
mod tests;
