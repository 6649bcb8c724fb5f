//! Doubles with an error bound: the first number of `Exact` for spheres and flat primitives, after the grid of fixed
//! point.
//!
//! A polynomial is computed twice: once as it is, and once with the magnitudes of its inputs and every sign positive.
//! All rounding errors of the first together are less than a known fraction of the second, so that a value above that
//! has a certain sign (semi-static filter: Burnikel, Funke and Seel, *Exact Geometric Computation Using Cascading*,
//! 2001; Devillers and Pion, *Efficient Exact Geometric Predicates for Delaunay Triangulations*, 2003).

use super::{Number, Ring, Running};
use core::cmp::Ordering;

/// A double, and the same polynomial of the magnitudes of its inputs.
#[derive(Clone, Copy, Debug)]
pub struct Filtered {
    value: f64,
    magnitude: f64,
}

/// No term has more than sixteen factors, and no factor has more than four roundings of 2^-53, including those of the
/// transformation into a frame. Sums add a dozen. Together they are less than 2^-46 of the magnitude.
const DOUBT: f64 = 1.0 / (1u64 << 44) as f64;

/// The roundings in a number.
const ROUNDINGS: f64 = (1u64 << 53) as f64;

/// Above all that underflow may have lost: a product of up to four stored numbers does not underflow, and one of more
/// has factors that are at least as small.
const LEAST: f64 = f64::from_bits((1023 - 700) << 52);

impl Filtered {
    /// A stored number.
    #[inline(always)]
    pub(crate) const fn of(value: f64) -> Self {
        Self { value, magnitude: value.abs() }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        // Zero is certain for stored numbers only: a product may have underflowed.
        Self { value: self.value * other.value, magnitude: self.magnitude * other.magnitude + f64::MIN_POSITIVE }
    }

    #[inline(always)]
    fn negative(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

operators!(Filtered);

impl Ring for Filtered {
    const ZERO: Self = Self { value: 0.0, magnitude: 0.0 };
    const ONE: Self = Self { value: 1.0, magnitude: 1.0 };

    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        let [a, b] = terms[0];
        let (mut value, mut magnitude) = (a.value * b.value, a.magnitude * b.magnitude);
        let mut i = 1;
        while i < M {
            let [a, b] = terms[i];
            value += a.value * b.value;
            magnitude += a.magnitude * b.magnitude;
            i += 1;
        }
        Self { value, magnitude: magnitude + f64::MIN_POSITIVE }
    }
    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        Self { value: self.value.scaled(e), magnitude: self.magnitude.scaled(e) + f64::MIN_POSITIVE }
    }
}

impl Number for Filtered {
    type Estimate = Running<f64>;
    type Long = Self;
    const IS_WIDE: bool = false;
    const DEPARTS: bool = false;
    const KNOWS_ZERO: bool = false;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        let doubt = self.magnitude * DOUBT + LEAST;
        // Comparisons are false for what is not a number.
        if self.value > doubt {
            Some(Ordering::Greater)
        } else if self.value < -doubt {
            Some(Ordering::Less)
        } else if self.magnitude == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
    #[inline(always)]
    fn long(self) -> Self {
        self
    }
    #[inline(always)]
    fn estimate(self) -> Running<f64> {
        Running { value: self.value, error: (self.magnitude * DOUBT + LEAST) * ROUNDINGS }
    }
    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        super::Plain::<f64>::apart(work)
    }
}
