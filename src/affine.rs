//! Placement by any invertible matrix: ellipsoids, elliptic cylinders and cones.
//!
//! Only the inverse of the matrix is stored. Each of its rows has its own power of two, so that in fixed point a scale
//! of 1000 along one axis and one of 1/1000 along another both keep all their bits.

use crate::frame::{Frame, FrameError};
use crate::line::Place;
use crate::number::{difference, dot};
use crate::ray::Ray;
use crate::scalar::{FinerLine, FromScalar, GridScalar, Including, Real, Ring, Scalar, ValueError, clamped};
use crate::vector::{UnitVec3, Vec3, cross, pairs, transposed};

/// One row of the inverse: components below 1 and a power of two.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Row<U> {
    components: [U; 3],
    exponent: i32,
}

/// Placement by any invertible affine map. `t` remains the distance in the world, and normals are transformed by the
/// inverse transpose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine<S: Scalar> {
    position: Vec3<S>,
    inverse: [Row<S::Unit>; 3],
}

impl<S: Scalar> Affine<S> {
    /// From the images of the local origin and of the local x, y and z unit vectors (the columns of the matrix).
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] or [`FrameError::Axis`] if a component is not finite or beyond the budget;
    /// [`FrameError::Singular`] if the axes lie in a plane, or so nearly that the inverse is beyond the number type.
    ///
    /// ```
    /// # use raylet::{Affine, Ray, Shape, Sphere, UnitVec3, Vec3};
    /// // An ellipsoid with half-axes 2, 1 and 0.5.
    /// let stretch = Affine::new(
    ///     Vec3::ZERO,
    ///     [Vec3::new(2.0_f32, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 0.5)],
    /// )?;
    /// let egg = Shape::new(Sphere::new(1.0)?).placed(stretch);
    /// let ray = Ray::new(Vec3::new(-10.0, 0.0, 0.0), UnitVec3::X)?;
    /// assert_eq!(egg.nearest(&ray).map(|hit| hit.t), Some(8.0));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn new(position: Vec3<S>, axes: [Vec3<S>; 3]) -> Result<Self, FrameError> {
        let position = position.checked().map_err(FrameError::Position)?;
        for axis in axes {
            axis.checked().map_err(FrameError::Axis)?;
        }
        // Scaled to unit length first, so that the determinant of very short axes does not underflow.
        let mut units = [UnitVec3::<S>::X.real(); 3];
        let mut lengths = [S::Real::ONE; 3];
        for i in 0..3 {
            let (unit, length) = S::normalize(axes[i].real()).ok_or(FrameError::Singular)?;
            units[i] = unit.map(S::unit_real);
            lengths[i] = length;
        }
        let [x, y, z] = units;
        let normals = [cross(y, z), cross(z, x), cross(x, y)];
        let volume = S::Real::sum_of_products([[x[0], normals[0][0]], [x[1], normals[0][1]], [x[2], normals[0][2]]]);
        // A smaller volume may be due to the rounding of the unit components alone.
        if volume.abs() < S::Real::ONE.scaled(-16) {
            return Err(FrameError::Singular);
        }
        let mut rows = [UnitVec3::<S>::X.real(); 3];
        for i in 0..3 {
            rows[i] = normals[i].map(|component| component / volume / lengths[i]);
        }
        Self::from_inverse(position, rows)
    }

    /// A frame stretched along its own axes by the factors `scale` (all positive).
    ///
    /// # Errors
    ///
    /// [`FrameError::Scale`] if a factor is zero, negative, not finite or beyond the budget; [`FrameError::Singular`]
    /// if the inverse is beyond the number type.
    pub fn stretched(frame: Frame<S>, scale: Vec3<S>) -> Result<Self, FrameError> {
        let factors = scale.to_array();
        for factor in factors {
            if !(factor > S::ZERO && factor <= S::BUDGET.size) {
                return Err(FrameError::Scale(ValueError::of_size(factor, S::BUDGET.smallest_size)));
            }
        }
        let axes = [frame.left(), frame.up(), frame.forward()];
        let mut rows = [UnitVec3::<S>::X.real(); 3];
        for i in 0..3 {
            rows[i] = axes[i].real().map(|component| component / factors[i].real());
        }
        Self::from_inverse(frame.position(), rows)
    }

    fn from_inverse(position: Vec3<S>, rows: [[S::Real; 3]; 3]) -> Result<Self, FrameError> {
        let mut inverse = [Row { components: UnitVec3::<S>::X.to_array(), exponent: 0 }; 3];
        for i in 0..3 {
            inverse[i] = Self::row(rows[i]).ok_or(FrameError::Singular)?;
        }
        Ok(Self { position, inverse })
    }

    /// From what a placement has stored, to the bit.
    #[cfg(feature = "serde")]
    pub(crate) fn from_stored(position: Vec3<S>, inverse: [([S::Unit; 3], i32); 3]) -> Result<Self, FrameError> {
        let position = position.checked().map_err(FrameError::Position)?;
        let stored = Self { position, inverse: inverse.map(|(components, exponent)| Row { components, exponent }) };
        // A row is stored in one way only; the volume of what a constructor lets through is larger.
        let [x, y, z] = stored.inverse.map(|row| row.components.map(S::unit_real));
        let [nx, ny, nz] = cross(y, z);
        let volume = S::Real::sum_of_products([[x[0], nx], [x[1], ny], [x[2], nz]]);
        let in_range = |(_, exponent): (_, i32)| exponent.unsigned_abs() <= 2048;
        if inverse.into_iter().all(in_range)
            && pairs(stored.rows(), stored.inverse).into_iter().all(|(row, own)| Self::row(row) == Some(own))
            && volume.abs() > S::Real::ONE.scaled(-36)
        {
            Ok(stored)
        } else {
            Err(FrameError::Singular)
        }
    }

    /// The row as components below 1 and a power of two; `None` for a row that is zero or not finite.
    fn row(v: [S::Real; 3]) -> Option<Row<S::Unit>> {
        let mut largest = v[0].abs();
        for component in [v[1].abs(), v[2].abs()] {
            if component > largest {
                largest = component;
            }
        }
        let (one, half) = (S::Real::ONE, S::Real::ONE.scaled(-1));
        let mut exponent = 0;
        // No scale inside the budget needs more steps; a NaN or an infinity never comes down.
        while largest >= one && exponent < 2048 {
            largest = largest.scaled(-1);
            exponent += 1;
        }
        while largest < half && exponent > -2048 {
            largest = largest.scaled(1);
            exponent -= 1;
        }
        if !(largest >= half && largest < one) {
            return None;
        }
        Some(Row { components: v.map(|c| S::unit_round(c.scaled(-exponent))), exponent })
    }

    /// The images of the local axes, as [`Affine::new`] takes them: the inverse as it is stored, inverted again and
    /// rounded to nearest. A component beyond the number type is [`Scalar::INFINITY`] with its sign.
    ///
    /// ```
    /// # use raylet::{Affine, Vec3};
    /// let axes = [Vec3::new(2.0_f32, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, -0.5, 0.0)];
    /// assert_eq!(Affine::new(Vec3::ZERO, axes)?.axes(), axes);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn axes(&self) -> [Vec3<S>; 3] {
        [UnitVec3::<S>::X, UnitVec3::Y, UnitVec3::Z].map(|axis| Vec3::round(self.image(axis.real())))
    }

    /// A local point in the world, rounded to nearest.
    pub fn point_to_world(&self, point: Vec3<S>) -> Vec3<S> {
        let moved = pairs(self.image(point.real()), self.position.real());
        Vec3::round(moved.map(|(offset, position)| offset + position))
    }

    /// The image of the local origin.
    pub const fn position(&self) -> Vec3<S> {
        self.position
    }

    /// The same map with the image of the local origin at another position; the axes stay as they are, to the bit.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Affine::new`].
    ///
    /// ```
    /// # use raylet::{Affine, Frame, UnitVec3, Vec3};
    /// let turned = Frame::turned_about(Vec3::ZERO, UnitVec3::<f32>::Z, 30.0)?;
    /// let egg = Affine::stretched(turned, Vec3::new(1.0, 2.0, 1.0))?;
    /// let moved = egg.moved_to(Vec3::new(0.0, 0.5, 0.0))?;
    /// assert_eq!((moved.inverse(), moved.position()), (egg.inverse(), Vec3::new(0.0, 0.5, 0.0)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn moved_to(self, position: Vec3<S>) -> Result<Self, FrameError> {
        Ok(Self { position: position.checked().map_err(FrameError::Position)?, ..self })
    }

    /// The inverse applied to a vector that starts at the position.
    #[inline]
    fn vector_to_local(&self, v: [S; 3]) -> [S::Real; 3] {
        self.inverse.map(|row| S::dot(v, row.components).scaled(row.exponent))
    }

    /// The rows of the inverse matrix as they are stored: the components of a row, and the exponent of the power of two
    /// by which they are to be multiplied.
    pub fn inverse(&self) -> [([S::Unit; 3], i32); 3] {
        self.inverse.map(|row| (row.components, row.exponent))
    }

    /// The rows of the inverse, in the computing number.
    fn rows(&self) -> [[S::Real; 3]; 3] {
        self.inverse.map(|row| row.components.map(|c| S::unit_real(c).scaled(row.exponent)))
    }

    /// A world point in local coordinates.
    pub fn point_to_local(&self, point: Vec3<S>) -> Vec3<S> {
        let ([x, y, z], [px, py, pz]) = (point.real(), self.position.real());
        Vec3::round(self.rows().map(|[a, b, c]| S::Real::sum_of_products([[x - px, a], [y - py, b], [z - pz, c]])))
    }

    /// The local coordinates of the ray's point at `t`.
    pub(crate) fn ray_point_to_local(&self, ray: &Ray<S>, t: S) -> Vec3<S> {
        let from_position =
            S::approach(ray.origin().to_array(), self.position.to_array(), ray.direction().to_array(), t);
        Vec3::round(self.vector_to_local(from_position.map(|c| clamped(c, S::BUDGET.coordinate))))
    }

    /// A local normal in the world: the inverse transpose, normalised.
    pub(crate) fn normal_to_world(&self, normal: UnitVec3<S>) -> UnitVec3<S> {
        let (n, rows) = (normal.real(), self.rows());
        let component =
            |i: usize| S::Real::sum_of_products([[n[0], rows[0][i]], [n[1], rows[1][i]], [n[2], rows[2][i]]]);
        UnitVec3::from_real([component(0), component(1), component(2)]).unwrap_or(normal)
    }

    /// The image of a local vector. The inverse is `diag(2^e) C`, where `C` holds the rows' components. The image is
    /// therefore `adj(C) / det(C)` applied to `2^-e v`. (The determinant of `diag(2^e) C` may be beyond the number
    /// type.)
    fn image(&self, v: [S::Real; 3]) -> [S::Real; 3] {
        let [x, y, z] = self.inverse.map(|row| row.components.map(S::unit_real));
        let columns = [cross(y, z), cross(z, x), cross(x, y)];
        let determinant =
            S::Real::sum_of_products([[x[0], columns[0][0]], [x[1], columns[0][1]], [x[2], columns[0][2]]]);
        let [a, b, c] = pairs(v, self.inverse).map(|(v, row)| v.scaled(-row.exponent));
        let component =
            |i: usize| S::Real::sum_of_products([[a, columns[0][i]], [b, columns[1][i]], [c, columns[2][i]]]);
        [component(0), component(1), component(2)].map(|c| c / determinant)
    }

    /// A local tangent in the world, normalised.
    pub(crate) fn tangent_to_world(&self, tangent: UnitVec3<S>) -> UnitVec3<S> {
        UnitVec3::from_real(self.image(tangent.real())).unwrap_or(tangent)
    }

    /// The exponent of the power of two by which the placement, or its rounding, amplifies an error at most. It depends
    /// on how much the axes' lengths differ, and on how far their directions are from perpendicular. `None` for axes
    /// that lie nearly in a plane: the volume that their directions span is less than about 1/8.
    pub(crate) fn sharpness(&self) -> Option<i32> {
        let [x, y, z] = self.inverse.map(|row| row.components.map(S::unit_real));
        let product = |[ax, ay, az]: [S::Real; 3], [bx, by, bz]: [S::Real; 3]| ax * bx + ay * by + az * bz;
        let volume = product(x, cross(y, z));
        let (square, most) = (volume * volume, product(x, x) * product(y, y) * product(z, z));
        let flat = (0..=3).find(|n| square.scaled(2 * n + 1) >= most)?;
        let [a, b, c] = self.inverse.map(|row| row.exponent);
        Some(a.max(b).max(c).saturating_sub(a.min(b).min(c)).saturating_add(flat + 1))
    }
}

impl<S: Scalar> Place<S> for Affine<S> {
    type In<R: Scalar> = Affine<R>;

    const STRETCHES: bool = true;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Self::In<R> {
        let inverse = self
            .inverse
            .map(|Row { components, exponent }| Row { components: components.map(R::unit_exactly), exponent });
        Affine { position: self.position.in_type(), inverse }
    }

    #[inline]
    fn finer_line(&self, ray: &Ray<S>, longest: S) -> Option<FinerLine<S>>
    where
        S: GridScalar,
    {
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        FinerLine::stretched(o, d, self.position.to_array(), self.inverse(), longest)
    }

    #[inline(always)]
    fn position(&self) -> Option<Vec3<S>> {
        Some(self.position)
    }
    // A function of its own: it is long, and needed twice for each ray.
    #[inline(never)]
    fn linear<N: FromScalar<S>>(&self, v: [N; 3]) -> [N; 3] {
        applied(self.rows_in(), v)
    }

    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2] {
        let (rows, direction) = (self.rows_in(), ray.direction().to_array().map(N::unit));
        [applied(rows, self.seen_from_position(ray.origin())), applied(rows, direction)]
    }

    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        applied(self.rows_in(), self.seen_from_position(point))
    }

    fn gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3] {
        let rows = self.rows_in().map(|Row { components, exponent }: Row<N>| components.map(|c| c.scaled(exponent)));
        transposed(rows).map(|row| dot(row, gradient))
    }
}

impl<S: Scalar> Affine<S> {
    /// The inverse in other numbers.
    #[inline(always)]
    fn rows_in<N: FromScalar<S>>(&self) -> [Row<N>; 3] {
        self.inverse.map(|Row { components, exponent }| Row { components: components.map(N::unit), exponent })
    }

    /// A point seen from the position.
    #[inline(always)]
    fn seen_from_position<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        let [o, p] = [point, self.position].map(|v| v.to_array().map(N::scalar));
        difference(o, p)
    }
}

/// The rows applied to a vector.
#[inline(always)]
fn applied<N: Ring>(rows: [Row<N>; 3], v: [N; 3]) -> [N; 3] {
    rows.map(|row| N::scalar_product(row.components, v).scaled(row.exponent))
}
