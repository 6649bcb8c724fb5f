//! Floor 4: in which numbers a solver computes.
//!
//! The formulas are the same for all; what differs is how much of each product is kept.

use crate::line::Line;
use crate::scalar::certain::Certain;
use crate::scalar::{Real, Scalar};

/// The numbers of a tier.
pub trait Arithmetic<S: Scalar>: Copy + 'static {
    /// The number in which the tier computes.
    type Real: Real;
    /// True if coefficients that cancel are made again with what their rounding left over, and far rays step closer;
    /// false if the first figures stand.
    const COMPENSATES: bool;
    /// True if the short ways of [`plain_ball`](Scalar::plain_ball) and its like are asked first.
    const PLAIN: bool;

    /// The exact value.
    fn real(value: S) -> Self::Real;
    /// The exact value of a component of a direction.
    fn unit(value: S::Unit) -> Self::Real;
    /// A number of the scalar's own kind.
    fn own(value: S::Real) -> Self::Real;
    /// `o . d`.
    fn dot(o: [S; 3], d: [S::Unit; 3]) -> Self::Real;
    /// `o x d`.
    fn cross(o: [S; 3], d: [S::Unit; 3]) -> [Self::Real; 3];
    /// `d . d`.
    fn squared_length(d: [S::Unit; 3]) -> Self::Real;
    /// Rounded; [`Scalar::INFINITY`] with the sign where the type cannot hold it.
    fn round(value: Self::Real) -> S;
    /// `numerator / denominator`, rounded; [`Scalar::INFINITY`] with the sign where the type cannot hold it.
    fn ratio(numerator: Self::Real, denominator: Self::Real) -> S;
}

/// A line in the numbers of a tier.
impl<S: Scalar> Line<S> {
    #[inline(always)]
    fn in_its_unit<R: Real>(&self, value: R) -> R {
        if S::RELATIVE { value } else { value.times_power_of_two(-self.finer) }
    }

    /// The origin.
    #[inline(always)]
    pub(crate) fn point<T: Arithmetic<S>>(&self) -> [T::Real; 3] {
        self.origin.map(|component| self.in_its_unit(T::real(component)))
    }

    /// What the origin's rounding left over.
    #[inline(always)]
    pub(crate) fn rest<T: Arithmetic<S>>(&self) -> [T::Real; 3] {
        self.rest.map(T::real)
    }

    /// The direction.
    #[inline(always)]
    pub(crate) fn along<T: Arithmetic<S>>(&self) -> [T::Real; 3] {
        self.direction.map(T::unit)
    }

    /// `o . d`.
    #[inline(always)]
    pub(crate) fn dot<T: Arithmetic<S>>(&self) -> T::Real {
        self.in_its_unit(T::dot(self.origin, self.direction))
    }

    /// The moment `o x d`.
    #[inline(always)]
    pub(crate) fn moment<T: Arithmetic<S>>(&self) -> [T::Real; 3] {
        T::cross(self.origin, self.direction).map(|minor| self.in_its_unit(minor))
    }

    /// The parameter `numerator / denominator`, rounded.
    #[inline(always)]
    pub(crate) fn t<T: Arithmetic<S>>(&self, numerator: T::Real, denominator: T::Real) -> S {
        match self.stretch {
            None => T::ratio(numerator, denominator),
            Some(stretch) => T::ratio(numerator, denominator * T::own(stretch)),
        }
    }
}

/// A number of twice the precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Doubled;

impl<S: Certain> Arithmetic<S> for Doubled {
    type Real = S::Double;
    const COMPENSATES: bool = true;
    const PLAIN: bool = false;

    #[inline]
    fn real(value: S) -> S::Double {
        value.double()
    }
    #[inline]
    fn unit(value: S::Unit) -> S::Double {
        S::double_unit(value)
    }
    #[inline]
    fn own(value: S::Real) -> S::Double {
        S::double_real(value)
    }
    #[inline]
    fn dot(o: [S; 3], d: [S::Unit; 3]) -> S::Double {
        let ([x, y, z], [dx, dy, dz]) = (o.map(S::double), d.map(S::double_unit));
        x * dx + y * dy + z * dz
    }
    #[inline]
    fn cross(o: [S; 3], d: [S::Unit; 3]) -> [S::Double; 3] {
        crate::vector::cross(o.map(S::double), d.map(S::double_unit))
    }
    #[inline]
    fn squared_length(d: [S::Unit; 3]) -> S::Double {
        let [dx, dy, dz] = d.map(S::double_unit);
        dx * dx + dy * dy + dz * dz
    }
    #[inline]
    fn round(value: S::Double) -> S {
        S::from_double(value)
    }
    #[inline]
    fn ratio(numerator: S::Double, denominator: S::Double) -> S {
        S::from_double(numerator / denominator)
    }
}
