//! Points, vectors and directions.

mod constant;
mod operators;

use crate::number::{Estimate, Number, Ring, Robust, dot};
use crate::scalar::{Attempt, FromScalar, Including, Real, Scalar, UnitScalar, ValueError};
use core::ops::Neg;

/// A point or a vector of any length.
///
/// Sums, differences, negatives, multiples and quotients of fixed-point vectors saturate; no operation overflows.
/// Multiples and quotients are rounded to nearest. A quotient by zero is that of the number type's computing number:
/// infinite or NaN for floats, zero for fixed point.
///
/// ```
/// # use raylet::Vec3;
/// let mut v = Vec3::new(1.0_f32, 2.0, 3.0) * 2.0 + Vec3::new(0.0, 0.0, 1.0);
/// v /= 2.0;
/// v -= Vec3::new(1.0, 0.0, 0.0);
/// assert_eq!(v, Vec3::new(0.0, 2.0, 3.5));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct Vec3<S> {
    /// Along the x axis.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub x: S,
    /// Along the y axis, the axis of every canonical solid.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub y: S,
    /// Along the z axis.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub z: S,
}

impl<S: Scalar> Vec3<S> {
    /// The origin.
    pub const ZERO: Self = Self { x: S::ZERO, y: S::ZERO, z: S::ZERO };

    /// The vector with these components.
    #[inline(always)]
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }

    /// From `f64` components, each rounded to nearest.
    ///
    /// # Errors
    ///
    /// [`ValueError::NotFinite`] if a component is not finite; [`ValueError::BeyondType`] if the number type cannot
    /// hold it.
    ///
    /// ```
    /// # use raylet::{ValueError, Vec3};
    /// assert_eq!(Vec3::<f32>::from_f64([1.0, 2.5, -3.0]), Ok(Vec3::new(1.0, 2.5, -3.0)));
    /// assert_eq!(Vec3::<f32>::from_f64([1e39, 0.0, 0.0]), Err(ValueError::BeyondType));
    /// ```
    pub fn from_f64(components: [f64; 3]) -> Result<Self, ValueError> {
        let [x, y, z] = components;
        Ok(Self::new(S::from_f64(x)?, S::from_f64(y)?, S::from_f64(z)?))
    }

    /// The components as `f64`.
    pub fn to_f64(self) -> [f64; 3] {
        self.to_array().map(S::to_f64)
    }

    /// The vector in another type.
    #[inline(always)]
    pub(crate) fn in_type<R: Including<S>>(self) -> Vec3<R> {
        Vec3 { x: R::exactly(self.x), y: R::exactly(self.y), z: R::exactly(self.z) }
    }

    /// The components in order.
    #[inline(always)]
    pub const fn to_array(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }

    /// The components, to compute with.
    #[inline(always)]
    pub fn real(self) -> [S::Real; 3] {
        self.to_array().map(S::real)
    }

    /// Rounds each component to nearest.
    #[inline(always)]
    pub fn round(v: [S::Real; 3]) -> Self {
        v.map(S::round).into()
    }

    /// The vector itself, if it is within the budget; otherwise what is wrong with it.
    #[inline]
    pub(crate) fn checked(self) -> Result<Self, ValueError> {
        if self.is_within_budget() { Ok(self) } else { Err(ValueError::of_point(self.to_array())) }
    }

    /// True if every component is inside the number type's [`Budget`](crate::scalar::Budget).
    #[inline]
    pub fn is_within_budget(self) -> bool {
        // The comparison is false for NaN.
        self.to_array().iter().all(|c| c.magnitude() <= S::BUDGET.coordinate)
    }

    /// The component along a direction. `<S as Scalar>::round` makes a stored number of it; see [`UnitVec3::dot`].
    #[inline(always)]
    pub fn dot(self, direction: UnitVec3<S>) -> S::Real {
        S::dot(self.to_array(), direction.to_array())
    }

    /// The length of the vector, rounded to the scalar.
    pub fn length(self) -> S {
        S::normalize(self.real()).map_or(S::ZERO, |(_, length)| S::round(length))
    }
}

/// The components, each rounded to the type: they have more bits in fixed point.
///
/// ```
/// use raylet::{UnitVec3, Vec3};
/// assert_eq!(Vec3::from(-UnitVec3::<f32>::Z), Vec3::new(0.0, 0.0, -1.0));
/// ```
impl<S: Scalar> From<UnitVec3<S>> for Vec3<S> {
    fn from(direction: UnitVec3<S>) -> Self {
        Self::round(direction.real())
    }
}

impl<S> From<[S; 3]> for Vec3<S> {
    #[inline(always)]
    fn from([x, y, z]: [S; 3]) -> Self {
        Self { x, y, z }
    }
}

/// A direction: a vector of length 1, by type.
///
/// Its components have more fraction bits than a fixed-point coordinate (30 of 32, 62 of 64). A stored unit vector is
/// unit only to its last bit; `t` is the parameter of the direction *as stored*.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitVec3<S: Scalar> {
    components: [S::Unit; 3],
}

impl<S: Scalar> UnitVec3<S> {
    /// Along the x axis.
    pub const X: Self = Self { components: [S::Unit::ONE, S::Unit::ZERO, S::Unit::ZERO] };
    /// Along the y axis.
    pub const Y: Self = Self { components: [S::Unit::ZERO, S::Unit::ONE, S::Unit::ZERO] };
    /// Along the z axis.
    pub const Z: Self = Self { components: [S::Unit::ZERO, S::Unit::ZERO, S::Unit::ONE] };

    /// The direction of a vector of any non-zero length, within 2.5 units in the last place of its largest component.
    ///
    /// # Errors
    ///
    /// [`ValueError::NoDirection`] for the zero vector, [`ValueError::NotFinite`] for one that is not finite.
    ///
    /// ```
    /// # use raylet::{UnitVec3, ValueError, Vec3};
    /// let tiny = UnitVec3::new(Vec3::new(3e-20_f32, 0.0, 4e-20))?;
    /// let huge = UnitVec3::new(Vec3::new(3e20_f32, 0.0, 4e20))?;
    /// assert_eq!((tiny.x(), tiny.z()), (0.6, 0.8));
    /// assert_eq!((huge.x(), huge.z()), (0.6, 0.8));
    /// assert_eq!(UnitVec3::<f32>::new(Vec3::ZERO), Err(ValueError::NoDirection));
    /// # Ok::<(), ValueError>(())
    /// ```
    #[inline]
    pub fn new(v: Vec3<S>) -> Result<Self, ValueError> {
        Self::of(v).ok_or_else(|| ValueError::of_direction(v.to_array()))
    }

    /// The direction of a vector that has one.
    #[inline]
    fn of(v: Vec3<S>) -> Option<Self> {
        match S::direction_of(v.to_array()) {
            Attempt::Hit(components) => Some(Self { components }),
            Attempt::Miss => None,
            Attempt::Unsure => Self::of_finite(v),
        }
    }

    /// The direction of a vector, or another one where it has none. Not by [`UnitVec3::of`]: LLVM copies the option
    /// twice on its way out, by calls on a Cortex-M0+: a lit picture takes 30 instructions a pixel more with it.
    #[inline]
    pub(crate) fn new_or(v: Vec3<S>, otherwise: Self) -> Self {
        match S::direction_of(v.to_array()) {
            Attempt::Hit(components) => Self { components },
            Attempt::Miss => otherwise,
            Attempt::Unsure => Self::of_finite(v).unwrap_or(otherwise),
        }
    }

    /// The direction of any vector that is finite and has one.
    fn of_finite(v: Vec3<S>) -> Option<Self> {
        if v.to_array().iter().all(|c| c.is_finite()) { Self::from_real(v.real()) } else { None }
    }

    /// The direction of a vector of `f64` components of any length, each component within half a unit of its last place
    /// and 2^-60 of it: a fixed type has all the fraction bits of a direction, where [`Vec3::from_f64`] first rounds to
    /// those of a coordinate.
    ///
    /// # Errors
    ///
    /// [`ValueError::NoDirection`] for the zero vector, [`ValueError::NotFinite`] for one that is not finite.
    ///
    /// ```
    /// # use raylet::{UnitVec3, ValueError, Vec3};
    /// use fixed::types::I16F16;
    /// let third = [1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0];
    /// let fine = UnitVec3::<I16F16>::from_f64(third)?;
    /// assert!((fine.x().to_num::<f64>() - third[0]).abs() < 2.0_f64.powi(-31));
    /// let coarse = UnitVec3::<I16F16>::new(Vec3::from_f64(third)?)?;
    /// assert!((coarse.x().to_num::<f64>() - third[0]).abs() > 2.0_f64.powi(-20));
    /// # Ok::<(), ValueError>(())
    /// ```
    pub fn from_f64(components: [f64; 3]) -> Result<Self, ValueError> {
        if !components.iter().all(|c| c.is_finite()) {
            return Err(ValueError::NotFinite);
        }
        // In 128 bits and rounded once: for a fixed type of 64 bits a double is too coarse.
        let v = components.map(<Robust<u128> as FromScalar<f64>>::scalar);
        let square = dot(v, v);
        if square.sign().is_none_or(core::cmp::Ordering::is_eq) {
            return Err(ValueError::NoDirection);
        }
        let length = square.square_root();
        Ok(Self { components: v.map(|component| S::unit_from_limbs(component.over(length))) })
    }

    /// The direction of a vector in the computing number.
    #[inline]
    pub fn from_real(v: [S::Real; 3]) -> Option<Self> {
        S::direction(v).map(|components| Self { components })
    }

    /// The direction of a vector in the robust number; `None` for the zero vector.
    pub(crate) fn from_robust(v: [S::Robust; 3]) -> Option<Self> {
        // The largest component just below 1.
        let top = v.iter().filter_map(|component| component.top()).max()?;
        Self::from_real(v.map(|component| S::unit_real(S::unit_from_robust(component.scaled(-top)))))
    }

    /// The direction with these stored components, if their length is 1 within 2^-20; for tables and for tests that
    /// need every bit as given. Anything else should go through [`UnitVec3::new`].
    ///
    /// # Errors
    ///
    /// [`ValueError::NotUnit`] if they have another length, or are not finite.
    ///
    /// ```
    /// # use raylet::{UnitVec3, ValueError};
    /// assert!(UnitVec3::<f32>::from_components([0.6, 0.0, 0.8]).is_ok());
    /// assert_eq!(UnitVec3::<f32>::from_components([0.6, 0.0, 0.9]), Err(ValueError::NotUnit));
    /// ```
    pub fn from_components(components: [S::Unit; 3]) -> Result<Self, ValueError> {
        // The squares of components that are much too large would not fit. Not a negated comparison: NaN must fail.
        let limit = S::Unit::ONE.plus(S::Unit::ONE.times(S::Unit::from_f64(0.25)));
        if !components.iter().all(|c| -limit < *c && *c < limit) {
            return Err(ValueError::NotUnit);
        }
        let error = (S::unit_dot(components, components) - S::Real::ONE).abs();
        if error < S::Real::ONE.scaled(-19) { Ok(Self { components }) } else { Err(ValueError::NotUnit) }
    }

    /// Components that the caller derived from unit vectors by a rotation.
    #[inline(always)]
    pub(crate) const fn rotated(components: [S::Unit; 3]) -> Self {
        Self { components }
    }

    /// The stored components in another type, in which the length is only nearly 1.
    #[inline(always)]
    pub(crate) fn in_type<R: Including<S>>(self) -> UnitVec3<R> {
        UnitVec3 { components: self.components.map(R::unit_exactly) }
    }

    /// Component along the x axis.
    #[inline(always)]
    pub const fn x(self) -> S::Unit {
        self.components[0]
    }

    /// Component along the y axis.
    #[inline(always)]
    pub const fn y(self) -> S::Unit {
        self.components[1]
    }

    /// Component along the z axis.
    #[inline(always)]
    pub const fn z(self) -> S::Unit {
        self.components[2]
    }

    /// The components in order.
    #[inline(always)]
    pub const fn to_array(self) -> [S::Unit; 3] {
        self.components
    }

    /// The components as `f64`.
    pub fn to_f64(self) -> [f64; 3] {
        self.components.map(UnitScalar::to_f64)
    }

    /// The components, to compute with.
    #[inline(always)]
    pub fn real(self) -> [S::Real; 3] {
        self.components.map(S::unit_real)
    }

    /// The cosine of the angle between two directions, as a number to compute with. [`Scalar::round`] makes a stored
    /// number of it, and has to be called by that name: fixed-point numbers have a `round` of their own.
    ///
    /// ```
    /// # use raylet::{Scalar, UnitVec3, Vec3};
    /// use fixed::types::I16F16;
    /// let slanted = UnitVec3::<I16F16>::from_f64([0.6, 0.0, 0.8])?;
    /// let cosine = <I16F16 as Scalar>::round(slanted.dot(UnitVec3::Z));
    /// assert_eq!(cosine, I16F16::lit("0.8"));
    /// # Ok::<(), raylet::ValueError>(())
    /// ```
    #[inline(always)]
    pub fn dot(self, other: Self) -> S::Real {
        S::unit_dot(self.components, other.components)
    }

    /// The cosine of the angle between two directions, rounded to a component's unit.
    #[inline]
    pub(crate) fn cosine(self, other: Self) -> S::Unit {
        let [x, y, z] = pairs(self.components, other.components).map(|(a, b)| a.times(b));
        x.plus(y).plus(z)
    }

    /// The cross product, whose length is the sine of the angle between the two.
    #[inline]
    pub fn cross(self, other: Self) -> [S::Real; 3] {
        cross(self.real(), other.real())
    }

    /// A direction perpendicular to this one, and a third perpendicular to both: (u, v) with `u x v = self`.
    ///
    /// Duff et al., *Building an Orthonormal Basis, Revisited* (2017), is branchless but divides; here the smallest
    /// component chooses the axis, so that the cross product is never shorter than 0.8.
    pub fn perpendicular(self) -> (Self, Self) {
        let [x, y, z] = self.real().map(Real::abs);
        let helper = if x <= y && x <= z {
            Self::X
        } else if y <= z {
            Self::Y
        } else {
            Self::Z
        };
        let u = Self::from_real(helper.cross(self)).unwrap_or(Self::X);
        let v = Self::from_real(self.cross(u)).unwrap_or(Self::Z);
        (u, v)
    }
}

impl<S: Scalar> Neg for UnitVec3<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { components: self.components.map(Neg::neg) }
    }
}

/// The cross product of two vectors in the computing number, each component as an accurate difference of products.
#[inline]
pub(crate) fn cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    let minor = |i: usize, j: usize| R::sum_of_products([[a[i], b[j]], [-a[j], b[i]]]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// Corresponding components. (An index over axes, as in `[0, 1, 2].map(|i| a[i])`, is checked wherever the compiler
/// does not unroll the loop: a panic that can never happen, but would be linked.)
#[inline(always)]
pub(crate) fn pairs<A, B>([ax, ay, az]: [A; 3], [bx, by, bz]: [B; 3]) -> [(A, B); 3] {
    [(ax, bx), (ay, by), (az, bz)]
}

/// The component along an axis: 0, 1 or 2 for x, y or z.
#[inline(always)]
pub(crate) const fn component<T: Copy>([x, y, z]: [T; 3], axis: usize) -> T {
    match axis {
        0 => x,
        1 => y,
        _ => z,
    }
}

/// The vector with this component along an axis.
#[inline(always)]
pub(crate) const fn with_component<T: Copy>([x, y, z]: [T; 3], axis: usize, c: T) -> [T; 3] {
    match axis {
        0 => [c, y, z],
        1 => [x, c, z],
        _ => [x, y, c],
    }
}

/// Rows as columns.
#[inline(always)]
pub(crate) fn transposed<R>([[a, b, c], [d, e, f], [g, h, i]]: [[R; 3]; 3]) -> [[R; 3]; 3] {
    [[a, d, g], [b, e, h], [c, f, i]]
}
