//! Doubles with an error bound: the first number of `Exact` for `f32`, after the fast path.
//!
//! A polynomial is computed twice: once as it is, and once with the magnitudes of its inputs and every sign positive. All rounding errors of
//! the first together are less than a known fraction of the second, so that a value above that has a certain sign (semi-static filter: Burnikel,
//! Funke and Seel, *Exact Geometric Computation Using Cascading*, 2001; Devillers and Pion, *Efficient Exact Geometric Predicates for
//! Delaunay Triangulations*, 2003).

use super::{Estimate, Number, Ring};
use core::cmp::Ordering;

/// A double, and the same polynomial of the magnitudes of its inputs.
#[derive(Clone, Copy, Debug)]
pub struct Filtered {
    value: f64,
    magnitude: f64,
}

/// The sign of a polynomial of smaller inputs is unknown. With inputs of at least 2^-60 no polynomial of the solver underflows.
const SMALLEST: f64 = 1.0 / (1u64 << 60) as f64;

/// No term has more than sixteen factors, and no factor has more than four roundings of 2^-53, including those of the transformation into a
/// frame. Sums add a dozen. Together they are less than 2^-46 of the magnitude.
const DOUBT: f64 = 1.0 / (1u64 << 44) as f64;

impl Filtered {
    /// A stored number.
    #[inline(always)]
    pub(crate) fn of(value: f64) -> Self {
        Self::guarded(value, value.abs())
    }

    /// A number that may underflow gets an infinite magnitude, and so does every result computed from it.
    #[inline(always)]
    fn guarded(value: f64, magnitude: f64) -> Self {
        Self { value, magnitude: if magnitude < SMALLEST && magnitude != 0.0 { f64::INFINITY } else { magnitude } }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self { value: self.value * other.value, magnitude: self.magnitude * other.magnitude }
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
    fn scaled(self, e: i32) -> Self {
        let scale = scale(e);
        Self::guarded(self.value * scale, self.magnitude * scale)
    }
}

impl Number for Filtered {
    type Estimate = Rounded;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        sign(self.value, self.magnitude * DOUBT)
    }

    #[inline(always)]
    fn estimate(self) -> Rounded {
        Rounded { value: self.value, error: self.magnitude * DOUBT }
    }
}

/// The sign of a value with this error bound; `None` if it overflowed, since comparisons with NaN are false.
#[inline(always)]
fn sign(value: f64, error: f64) -> Option<Ordering> {
    if value > error {
        Some(Ordering::Greater)
    } else if value < -error {
        Some(Ordering::Less)
    } else if error == 0.0 {
        // All its terms are zero.
        Some(Ordering::Equal)
    } else {
        None
    }
}

/// A double with an error bound. The bound is twice as large as necessary, which covers the rounding of its own computation.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    value: f64,
    error: f64,
}

impl Rounded {
    /// A stored number.
    #[inline(always)]
    pub(crate) const fn of(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// The value, if its error is at most `2^most(top)`, where `2^top` is just above its magnitude.
    #[inline(always)]
    pub(crate) fn within(self, most: impl Fn(i32) -> i32) -> Option<f64> {
        (self.error <= power_of_two(most(top(self.value)))).then_some(self.value)
    }

    #[inline(always)]
    fn new(value: f64, inherited: f64) -> Self {
        Self { value, error: inherited + value.abs() * f64::EPSILON }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.error + other.error)
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let inherited = self.value.abs() * other.error + self.error * (other.value.abs() + other.error);
        Self::new(self.value * other.value, inherited)
    }

    #[inline(always)]
    fn negative(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

operators!(Rounded);

impl Ring for Rounded {
    const ZERO: Self = Self { value: 0.0, error: 0.0 };
    const ONE: Self = Self { value: 1.0, error: 0.0 };

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        let scale = scale(e);
        Self { value: self.value * scale, error: self.error * scale }
    }
}

impl Number for Rounded {
    type Estimate = Self;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        sign(self.value, self.error)
    }

    #[inline(always)]
    fn estimate(self) -> Self {
        self
    }
}

impl Estimate for Rounded {
    #[inline(always)]
    fn over(self, other: Self) -> Self {
        let inverse = 1.0 / other.value;
        let value = self.value * inverse;
        // (error + |quotient| error') / (|divisor| - error'), where |divisor| - error' is at least half of |divisor|, or the quotient is unknown. The
        // quotient has two further roundings.
        let inherited = 2.0 * ((self.error + value.abs() * other.error) * inverse.abs() + value.abs() * f64::EPSILON);
        let is_known = 2.0 * other.error <= other.value.abs();
        Self::new(value, if is_known { inherited } else { f64::INFINITY })
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        let value = libm::sqrt(self.value);
        // sqrt(a) - sqrt(a - e) <= e / sqrt(a)
        Self::new(value, if self.error == 0.0 { 0.0 } else { self.error / value })
    }

    #[inline(always)]
    fn compare(self, other: Self) -> Option<Ordering> {
        sign(self.value - other.value, self.error + other.error)
    }

    fn top(self) -> Option<i32> {
        None
    }
}

/// The exponent of a power of two just above the magnitude.
#[inline(always)]
fn top(value: f64) -> i32 {
    ((value.to_bits() >> 52) & 0x7ff) as i32 - 1022
}

/// `2^e`; beyond normal numbers NaN, whose sign is unknown.
#[inline(always)]
fn scale(e: i32) -> f64 {
    if (-1022..=1023).contains(&e) { power_of_two(e) } else { f64::NAN }
}

/// `2^e`, for exponents of normal numbers.
#[inline(always)]
fn power_of_two(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}
