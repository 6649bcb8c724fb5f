//! Plain values, of which a difference is known only if little of it cancels.

use super::{Difference, Estimate, Number, Plain, Ring};
use crate::scalar::Real;
use core::cmp::Ordering;

/// A plain value. The sign of a difference ([`Number::sign_among`]) is known if the difference is at least a 4096th of
/// its terms, and that of a volume if it is larger than all rounding; every other sign is that of the rounded value.
///
/// If it is `STABLE`, these differences must be larger, so that the results have the accuracy of the tier `Stable`: a
/// positive difference of squares at least a 64th of its terms, and the slope at an end must not be small
/// ([`Number::is_far`]). Of flat parts in the world, whose coordinates are exact, it need only know signs. Such
/// constant bounds on the errors of spheres and triangles, whose formulas are short, cost half of running ones: a
/// sphere in a frame takes 172 instead of 359 instructions, a triangle 356 instead of 879.
#[derive(Clone, Copy, Debug)]
pub struct Guarded<R, const STABLE: bool = false>(pub(crate) Plain<R>);

/// The exponents of the parts of its terms that a difference must be if it is positive, and if it is negative.
const fn parts(of: Difference, is_stable: bool) -> [i32; 2] {
    match (of, is_stable) {
        (Difference::Squares, false) => [-12, -12],
        (Difference::Squares, true) => [-6, -12],
        (Difference::Volumes, false) => [-20, -20],
        (Difference::Volumes, true) => [-14, -14],
        (Difference::Signs, _) => [-12, -12],
        (Difference::Edges, _) => [-20, -20],
    }
}

impl<R: Real, const STABLE: bool> Guarded<R, STABLE> {
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self(-self.0)
    }
}

operators!(Guarded<R, STABLE>, R: Real, const STABLE: bool);

impl<R: Real, const STABLE: bool> Ring for Guarded<R, STABLE> {
    const ZERO: Self = Self(Plain::ZERO);
    const ONE: Self = Self(Plain::ONE);

    #[inline(always)]
    fn sum<const M: usize>(terms: [[Self; 2]; M]) -> Self {
        Self(Plain::sum(terms.map(|term| term.map(|factor| factor.0))))
    }
    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        Self(self.0.scaled(e))
    }
}

impl<R: Real, const STABLE: bool> Number for Guarded<R, STABLE> {
    type Estimate = Plain<R>;
    type Long = Self;
    const IS_WIDE: bool = false;
    const DEPARTS: bool = false;
    const APPROACHES_AGAIN: bool = STABLE;
    const KNOWS_ZERO: bool = false;
    const MOVED: i32 = if STABLE { -36 } else { -19 };
    const STARTS_AT_VERTEX: bool = STABLE;

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        self.0.sign()
    }
    #[inline(always)]
    fn sign_among(self, of: Difference, terms: impl FnOnce() -> Self) -> Option<Ordering> {
        if !STABLE && matches!(of, Difference::Edges) {
            return self.sign();
        }
        let (value, terms, [positive, negative]) = (self.0.0, terms().0.0, parts(of, STABLE));
        // More than underflow may have lost.
        let terms = if STABLE { terms + R::SMALLEST.scaled(30) } else { terms };
        // False for what is not a number.
        if value > terms.scaled(positive) {
            Some(Ordering::Greater)
        } else if value < -terms.scaled(negative) {
            Some(Ordering::Less)
        } else {
            None
        }
    }
    /// Each is one difference and one quotient of stored numbers, with an error of two roundings.
    #[inline(always)]
    fn order_of_crossings(t: Plain<R>, other: Plain<R>) -> Option<Ordering> {
        if !STABLE {
            return t.compare(other);
        }
        let (difference, doubt) = (t.0 - other.0, (t.0.abs() + other.0.abs() + R::SMALLEST).scaled(-20));
        if difference > doubt {
            Some(Ordering::Greater)
        } else if difference < -doubt {
            Some(Ordering::Less)
        } else {
            None
        }
    }
    #[inline(always)]
    fn is_far(t: Plain<R>, slope: Plain<R>, terms: impl FnOnce() -> Self) -> bool {
        !STABLE || (slope.0 * t.0).abs().scaled(2) > terms().0.0 + R::SMALLEST.scaled(30)
    }
    #[inline(always)]
    fn estimate(self) -> Plain<R> {
        self.0
    }
    #[inline(always)]
    fn long(self) -> Self {
        self
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        Self(Plain(self.0.0.abs()))
    }
    #[inline(always)]
    fn is_negligible_squared(self) -> bool {
        !STABLE || R::ROUNDING > -38 || self.0.0.abs() <= R::ONE.scaled(R::ROUNDING / 2 - 2)
    }
    #[inline(always)]
    fn rounded_quotient(self, other: Self) -> Option<Self> {
        Some(Self(self.0.over(other.0)))
    }
    #[inline(always)]
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        Plain::<R>::apart(work)
    }
}
