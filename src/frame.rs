//! Placement by rotation and translation.

mod constant;

use crate::line::Place;
use crate::number::{difference, dot};
use crate::ray::Ray;
use crate::scalar::{
    FromScalar, GridScalar, Including, LocalLine, Real, Ring, Scalar, UnitScalar, ValueError, with_fault,
};
use crate::vector::{UnitVec3, Vec3, pairs, transposed};
use core::fmt;

/// Placement by rotation and translation: a position and three perpendicular axes.
///
/// The constructors make the axes orthonormal, so that lengths, and with them `t`, are the same in the frame as in the
/// world.
///
/// Coordinates are right-handed: with x to the right and y up, z comes towards the viewer. For a viewer who looks along
/// a frame's z axis ([`Frame::forward`]), with its y axis upwards, its x axis points to the left. A camera that looks
/// along z shows +x on the left of the picture, too.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frame<S: Scalar> {
    position: Vec3<S>,
    /// The frame's x, y and z axes in world coordinates.
    axes: [UnitVec3<S>; 3],
}

impl<S: Scalar> Frame<S> {
    /// A translation to `position`, without a rotation.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] if a coordinate is not finite or beyond the budget.
    pub fn at(position: Vec3<S>) -> Result<Self, FrameError> {
        Self::assembled(position, [UnitVec3::X, UnitVec3::Y, UnitVec3::Z])
    }

    /// From the base and the axis of a solid. The frame's y axis is `axis`; the other two are chosen perpendicular to
    /// it, and do not matter for solids of revolution. Turn a cuboid by [`Frame::looking`] or [`Frame::turned_about`].
    ///
    /// The base of a cone is its apex. A cone that stands on its cap is a frustum with a top radius of zero:
    /// [`Cone::frustum`](crate::Cone::frustum).
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Frame::at`].
    pub fn from_base_and_axis(base: Vec3<S>, axis: UnitVec3<S>) -> Result<Self, FrameError> {
        if axis == UnitVec3::Y {
            return Self::at(base);
        }
        // (z, x) with z x x = y.
        let (z, x) = axis.perpendicular();
        Self::assembled(base, [x, axis, z])
    }

    /// From the centre of a solid, its axis and its height: the base is half of the height below the centre, rounded.
    /// This is for solids that stand on their base. Spheres and cuboids are about the origin of their frame: for them
    /// [`Frame::at`] and [`Frame::from_base_and_axis`] take the centre.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] if a coordinate of the centre or of the base is not finite or beyond the budget.
    ///
    /// ```
    /// use raylet::{Cylinder, Frame, Part, Ray, Shape, UnitVec3, Vec3};
    /// let rod = Shape::new(Cylinder::capped(0.5_f32, 4.0)?)
    ///     .placed(Frame::from_centre_and_axis(Vec3::new(0.0, 1.0, 0.0), UnitVec3::X, 4.0)?);
    /// let ray = Ray::new(Vec3::new(-9.0, 1.0, 0.0), UnitVec3::X)?;
    /// assert_eq!(rod.nearest(&ray).map(|hit| (hit.t, hit.part)), Some((7.0, Part::Base)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn from_centre_and_axis(centre: Vec3<S>, axis: UnitVec3<S>, height: S) -> Result<Self, FrameError> {
        let half = height.real().scaled(-1);
        let down = |(c, a): (S::Real, S::Real)| c - half * a;
        Self::from_base_and_axis(Vec3::round(pairs(centre.real(), axis.real()).map(down)), axis)
    }

    /// At `position`, turned about `axis` by this angle in degrees, counter-clockwise for a viewer towards whom the
    /// axis points.
    ///
    /// The axes are those of the world, turned by Rodrigues' formula `v + sin a (k x v) + (1 - cos a) (k (k . v) - v)`,
    /// and accurate to a few units of the number type.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Frame::at`]; [`FrameError::Angle`] if the angle is not between -360 and 360
    /// degrees.
    ///
    /// ```
    /// use raylet::{Frame, UnitVec3, Vec3};
    /// let turned = Frame::turned_about(Vec3::ZERO, UnitVec3::<f64>::Z, 90.0)?;
    /// // The y axis of the solid points to -x.
    /// assert!(turned.up().x() < -0.999_999 && turned.up().y().abs() < 1e-9);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn turned_about(position: Vec3<S>, axis: UnitVec3<S>, degrees: S) -> Result<Self, FrameError> {
        let half_turns = degrees.real().abs() / S::Real::from_int(720);
        // The comparison is false for NaN.
        if !(degrees.is_finite() && half_turns <= S::Real::ONE.scaled(-1)) {
            return Err(FrameError::Angle);
        }
        let (sine, cosine) = S::sine_cosine(S::unit_round(half_turns));
        let (half_sine, half_cosine) = (S::unit_real(sine), S::unit_real(cosine));
        // sin a = 2 sin(a/2) cos(a/2), and 1 - cos a = 2 sin(a/2)^2, in which nothing cancels.
        let (sine, versine) = ((half_sine * half_cosine).scaled(1), (half_sine * half_sine).scaled(1));
        let (sine, k) = (if degrees < S::ZERO { -sine } else { sine }, axis.real());
        let turned = |v: UnitVec3<S>| {
            let (along, cross, v) = (axis.dot(v), axis.cross(v), v.real());
            let component = |i: usize| v[i] + sine * cross[i] + versine * (k[i] * along - v[i]);
            UnitVec3::from_real([component(0), component(1), component(2)]).ok_or(FrameError::Axes)
        };
        Self::straightened(position, turned(UnitVec3::X)?, turned(UnitVec3::Y)?)
    }

    /// At `position`, turned by the quaternion `[x, y, z, w]`, whose real part is `w`, of any length but zero.
    ///
    /// The axes are the columns of the matrix of the quaternion divided by its length (Shoemake, *Animating Rotation
    /// with Quaternion Curves*, 1985). For a length near 1 they are accurate to a few units of the number type; the
    /// components of a short quaternion have fewer bits in fixed point.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Frame::at`]; [`FrameError::Quaternion`] if the quaternion is not finite, or
    /// its length is below 2^-10 or above 2^10.
    ///
    /// ```
    /// use raylet::{Frame, UnitVec3, Vec3};
    /// let half = 0.5_f64.sqrt();
    /// let quarter_about_z = Frame::<f64>::from_quaternion(Vec3::ZERO, [0.0, 0.0, half, half])?;
    /// assert_eq!(quarter_about_z.left(), UnitVec3::Y);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn from_quaternion(position: Vec3<S>, quaternion: [S::Unit; 4]) -> Result<Self, FrameError> {
        let [x, y, z, w] = quaternion.map(S::unit_real);
        let sum = |terms: [[S::Real; 2]; 4]| S::Real::sum_of_products(terms);
        let square = sum([[x, x], [y, y], [z, z], [w, w]]);
        let (least, most) = (S::Real::ONE.scaled(-20), S::Real::ONE.scaled(20));
        // The comparisons are false for NaN.
        if !(square >= least && square <= most) {
            return Err(FrameError::Quaternion);
        }
        let column = |diagonal, [a, b]: [S::Real; 2]| (diagonal / square, a.scaled(1) / square, b.scaled(1) / square);
        let product = |a, b, c, d| S::Real::sum_of_products([[a, b], [c, d]]);
        let (xx, xy, xz) = column(sum([[w, w], [x, x], [-y, y], [-z, z]]), [product(x, y, w, z), product(x, z, -w, y)]);
        let (yy, yx, yz) = column(sum([[w, w], [-x, x], [y, y], [-z, z]]), [product(x, y, -w, z), product(y, z, w, x)]);
        let axis = |components| UnitVec3::from_real(components).ok_or(FrameError::Quaternion);
        Self::straightened(position, axis([xx, xy, xz])?, axis([yx, yy, yz])?)
    }

    /// A frame inside of this one, in the world: where a part is, of a body that this frame places.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] if its position in the world is not finite or beyond the budget.
    ///
    /// ```
    /// use raylet::{Frame, UnitVec3, Vec3};
    /// let robot = Frame::turned_about(Vec3::new(2.0_f32, 0.0, 0.0), UnitVec3::Z, 90.0)?;
    /// let wheel = Frame::from_base_and_axis(Vec3::new(0.5, 0.0, 0.0), UnitVec3::Z)?;
    /// let placed = robot.frame_to_world(&wheel)?;
    /// assert_eq!((placed.position(), placed.up()), (Vec3::new(2.0, 0.5, 0.0), UnitVec3::Z));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn frame_to_world(&self, inner: &Self) -> Result<Self, FrameError> {
        let [left, up] = [inner.left(), inner.up()].map(|axis| self.direction_to_world(axis));
        Self::straightened(self.point_to_world(inner.position), left, up)
    }

    /// From two axes that are perpendicular except for rounding. `up`, the axis of the solids, stays as it is.
    fn straightened(position: Vec3<S>, left: UnitVec3<S>, up: UnitVec3<S>) -> Result<Self, FrameError> {
        let forward = UnitVec3::from_real(left.cross(up)).ok_or(FrameError::Axes)?;
        let left = UnitVec3::from_real(up.cross(forward)).ok_or(FrameError::Axes)?;
        Self::assembled(position, [left, up, forward])
    }

    /// From two end points: the base is at `from`, and the axis points to `to`. Also returns the distance between them,
    /// for the height of the solid.
    ///
    /// Equal points have no axis: the frame is then that of [`Frame::at`], and the height is zero. A
    /// [`Capsule`](crate::Capsule) accepts that height, and is a sphere; the constructors of other solids return an
    /// error for it.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] if a point is not finite or beyond the budget.
    ///
    /// ```
    /// # use raylet::{Cylinder, Frame, Shape, Vec3};
    /// let (frame, height) = Frame::between(Vec3::new(1.0_f32, 0.0, 0.0), Vec3::new(1.0, 0.0, 5.0))?;
    /// let rod = Shape::new(Cylinder::capped(0.25, height)?).placed(frame);
    /// assert_eq!(height, 5.0);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn between(from: Vec3<S>, to: Vec3<S>) -> Result<(Self, S), FrameError> {
        let from = from.checked().map_err(FrameError::Position)?;
        let to = to.checked().map_err(FrameError::Position)?;
        let ([fx, fy, fz], [tx, ty, tz]) = (from.real(), to.real());
        let Some((axis, height)) = S::normalize([tx - fx, ty - fy, tz - fz]) else {
            return Ok((Self::at(from)?, S::ZERO));
        };
        Ok((Self::from_base_and_axis(from, UnitVec3::rotated(axis))?, S::round(height)))
    }

    /// From a position, the direction `forward` of the z axis, and an approximate up direction. The y axis is the part
    /// of `up` that is perpendicular to `forward`, normalised; the x axis is the cross product of y and z.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Frame::at`]; [`FrameError::Axes`] if `up` is parallel to `forward`.
    pub fn looking(position: Vec3<S>, forward: UnitVec3<S>, up: UnitVec3<S>) -> Result<Self, FrameError> {
        let left = UnitVec3::from_real(up.cross(forward)).ok_or(FrameError::Axes)?;
        let up = UnitVec3::from_real(forward.cross(left)).ok_or(FrameError::Axes)?;
        Self::assembled(position, [left, up, forward])
    }

    /// From a position and three axes that are perpendicular only approximately. They are made perpendicular: `up`, the
    /// axis of the solids, stays as it is, and the other two are adjusted.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Frame::at`]; [`FrameError::Axes`] if the three are not nearly a right-handed
    /// frame: an axis may be adjusted by at most 2.5 degrees (a cosine of `1 - 2^-10`).
    pub fn from_left_up_forward(
        position: Vec3<S>,
        left: UnitVec3<S>,
        up: UnitVec3<S>,
        forward: UnitVec3<S>,
    ) -> Result<Self, FrameError> {
        let z = UnitVec3::from_real(left.cross(up)).ok_or(FrameError::Axes)?;
        let x = UnitVec3::from_real(up.cross(z)).ok_or(FrameError::Axes)?;
        let close = S::Real::ONE - S::Real::ONE.scaled(-10);
        if x.dot(left) < close || z.dot(forward) < close {
            return Err(FrameError::Axes);
        }
        Self::assembled(position, [x, up, z])
    }

    /// From a position and three axes that are kept to the bit: x, y and z, perpendicular and right-handed. It needs no
    /// square root, so that it can be called in a constant: see [`mod@crate::constant`].
    ///
    /// # Errors
    ///
    /// [`FrameError::Axes`] if the cosine of an angle between two axes is 2^-18 or more, or the three are left-handed;
    /// [`FrameError::Position`] as for [`Frame::at`].
    ///
    /// ```
    /// # use raylet::{Frame, FrameError, UnitVec3, Vec3};
    /// let turned = Frame::from_axes(Vec3::<f32>::ZERO, [UnitVec3::Y, UnitVec3::Z, UnitVec3::X])?;
    /// assert_eq!(turned.up(), UnitVec3::Z);
    /// let left = Frame::from_axes(Vec3::<f32>::ZERO, [UnitVec3::Y, UnitVec3::X, UnitVec3::Z]);
    /// assert_eq!(left, Err(FrameError::Axes));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn from_axes(position: Vec3<S>, axes: [UnitVec3<S>; 3]) -> Result<Self, FrameError> {
        let [x, y, z] = axes;
        // Far larger than the error of a right angle by rounding.
        let right = S::Real::ONE.scaled(-18);
        let is_right = |a: UnitVec3<S>, b: UnitVec3<S>| a.dot(b).abs() < right;
        let [cx, cy, cz] = x.cross(y);
        let [zx, zy, zz] = z.real();
        // For perpendicular axes it is nearly 1 or -1.
        let volume = S::Real::sum_of_products([[cx, zx], [cy, zy], [cz, zz]]);
        if is_right(x, y) && is_right(y, z) && is_right(z, x) && volume > S::Real::ZERO {
            Self::assembled(position, axes)
        } else {
            Err(FrameError::Axes)
        }
    }

    /// The same axes at another position, to the bit.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Frame::at`].
    ///
    /// ```
    /// # use raylet::{Frame, UnitVec3, Vec3};
    /// let turned = Frame::turned_about(Vec3::ZERO, UnitVec3::<f32>::Z, 30.0)?;
    /// let moved = turned.moved_to(turned.position() + Vec3::new(0.0, 0.5, 0.0))?;
    /// assert_eq!((moved.axes(), moved.position()), (turned.axes(), Vec3::new(0.0, 0.5, 0.0)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn moved_to(self, position: Vec3<S>) -> Result<Self, FrameError> {
        Self::assembled(position, self.axes)
    }

    /// A translation to a position that is within the budget.
    pub(crate) const fn within_budget(position: Vec3<S>) -> Self {
        Self { position, axes: [UnitVec3::X, UnitVec3::Y, UnitVec3::Z] }
    }

    fn assembled(position: Vec3<S>, axes: [UnitVec3<S>; 3]) -> Result<Self, FrameError> {
        Ok(Self { position: position.checked().map_err(FrameError::Position)?, axes })
    }

    /// The frame's origin in the world.
    #[inline]
    pub const fn position(&self) -> Vec3<S> {
        self.position
    }

    /// The direction of the x axis: to the left of a viewer who looks along `forward` with `up` upwards.
    #[inline]
    pub const fn left(&self) -> UnitVec3<S> {
        self.axes[0]
    }

    /// The direction of the y axis, the axis of the solids.
    #[inline]
    pub const fn up(&self) -> UnitVec3<S> {
        self.axes[1]
    }

    /// The direction of the z axis.
    #[inline]
    pub const fn forward(&self) -> UnitVec3<S> {
        self.axes[2]
    }

    /// The directions of the three axes. They are perpendicular, so that the same three are the rows of the inverse.
    #[inline]
    pub const fn axes(&self) -> [UnitVec3<S>; 3] {
        self.axes
    }

    /// A world point in the frame's coordinates.
    pub fn point_to_local(&self, point: Vec3<S>) -> Vec3<S> {
        let ([x, y, z], [px, py, pz]) = (point.real(), self.position.real());
        Vec3::round(self.axes.map(|axis| {
            let [ax, ay, az] = axis.real();
            S::Real::sum_of_products([[x - px, ax], [y - py, ay], [z - pz, az]])
        }))
    }

    /// A direction of the frame in world coordinates.
    pub fn direction_to_world(&self, direction: UnitVec3<S>) -> UnitVec3<S> {
        UnitVec3::from_real(self.vector_to_world(direction.real())).unwrap_or(direction)
    }

    /// The same without making its length 1 again: it is off by some units.
    pub(crate) fn direction_roughly_to_world(&self, direction: UnitVec3<S>) -> UnitVec3<S> {
        let turned = pairs(direction.to_array(), self.axes.map(UnitVec3::to_array));
        let [x, y, z] = turned.map(|(component, axis)| axis.map(|a| a.times(component)));
        UnitVec3::rotated(pairs(pairs(x, y), z).map(|((x, y), z)| x.plus(y).plus(z)))
    }

    /// A vector of the frame in world coordinates.
    pub(crate) fn vector_to_world(&self, v: [S::Real; 3]) -> [S::Real; 3] {
        let a = self.axes.map(UnitVec3::real);
        let component = |i: usize| v[0] * a[0][i] + v[1] * a[1][i] + v[2] * a[2][i];
        [component(0), component(1), component(2)]
    }

    /// A direction of the world in the frame's coordinates.
    pub(crate) fn direction_to_local(&self, direction: UnitVec3<S>) -> UnitVec3<S> {
        UnitVec3::from_real(self.axes.map(|axis| axis.dot(direction))).unwrap_or(direction)
    }

    /// A point of the frame in world coordinates.
    pub fn point_to_world(&self, point: Vec3<S>) -> Vec3<S> {
        let (v, p) = (point.real(), self.position.real());
        let a = self.axes.map(UnitVec3::real);
        let component = |i: usize| {
            S::Real::sum_of_products([[v[0], a[0][i]], [v[1], a[1][i]], [v[2], a[2][i]], [p[i], S::Real::ONE]])
        };
        Vec3::round([component(0), component(1), component(2)])
    }

    /// The ray's point at `t` in the frame's coordinates. The point relative to the frame's origin is rounded once,
    /// before the rotation, so that the result is as accurate far from the world's origin as near it. It is infinite if
    /// that relative point is beyond the type.
    pub(crate) fn ray_point_to_local(&self, ray: &Ray<S>, t: S) -> Vec3<S> {
        let from_position =
            S::approach(ray.origin().to_array(), self.position.to_array(), ray.direction().to_array(), t);
        if from_position.iter().all(|component| component.is_finite()) {
            self.vector_to_local(from_position.into())
        } else {
            [S::INFINITY; 3].into()
        }
    }

    /// The axes in other numbers.
    #[inline(always)]
    fn axes_in<N: FromScalar<S>>(&self) -> [[N; 3]; 3] {
        self.axes.map(|axis| axis.to_array().map(N::unit))
    }

    /// A vector of the world in the frame's coordinates.
    pub(crate) fn vector_to_local(&self, vector: Vec3<S>) -> Vec3<S> {
        Vec3::round(self.axes.map(|axis| S::dot(vector.to_array(), axis.to_array())))
    }
}

impl<S: Scalar> Place<S> for Frame<S> {
    type In<R: Scalar> = Frame<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Self::In<R> {
        Frame { position: self.position.in_type(), axes: self.axes.map(UnitVec3::in_type) }
    }

    #[inline]
    fn grid_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>>
    where
        S: GridScalar,
    {
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        LocalLine::turned(o, d, self.position.to_array(), self.axes.map(UnitVec3::to_array))
    }
    #[inline(always)]
    fn passes_axis(&self, ray: &Ray<S>, r: S) -> bool {
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        S::passes_axis(o, d, self.position.to_array(), self.up().to_array(), r)
    }
    #[inline]
    fn grid_ball_line(&self, ray: &Ray<S>) -> Option<LocalLine<S>>
    where
        S: GridScalar,
    {
        let [x, y, z] = pairs(ray.origin().to_array(), self.position.to_array()).map(|(o, p)| o.minus(p));
        let origin = if x.is_finite() && y.is_finite() && z.is_finite() { [x, y, z] } else { return None };
        Some(LocalLine::along(origin, ray.direction().to_array(), S::ZERO))
    }

    #[inline(always)]
    fn position(&self) -> Option<Vec3<S>> {
        Some(self.position)
    }
    #[inline(always)]
    fn linear<N: FromScalar<S>>(&self, v: [N; 3]) -> [N; 3] {
        self.axes_in::<N>().map(|axis| dot(axis, v))
    }
    #[inline(always)]
    fn height_line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [N; 2] {
        let axis = self.up().to_array().map(N::unit);
        [dot(axis, self.ball_point(ray.origin())), dot(axis, ray.direction().to_array().map(N::unit))]
    }

    #[inline]
    fn line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2] {
        let direction = ray.direction().to_array().map(N::unit);
        let (axes, origin) = (self.axes_in::<N>(), self.ball_point(ray.origin()));
        [axes.map(|axis| dot(axis, origin)), axes.map(|axis| dot(axis, direction))]
    }

    #[inline]
    fn point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        let from_position = self.ball_point(point);
        self.axes_in::<N>().map(|axis| dot(axis, from_position))
    }

    #[inline]
    fn ball_line<N: FromScalar<S>>(&self, ray: &Ray<S>) -> [[N; 3]; 2] {
        [self.ball_point(ray.origin()), ray.direction().to_array().map(N::unit)]
    }

    #[inline]
    fn ball_point<N: FromScalar<S>>(&self, point: Vec3<S>) -> [N; 3] {
        let [o, p] = [point, self.position].map(|v| v.to_array().map(N::scalar));
        difference(o, p)
    }

    fn gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3] {
        transposed(self.axes_in::<N>()).map(|row| dot(row, gradient))
    }

    fn ball_gradient_to_world<N: FromScalar<S>>(&self, gradient: [N; 3]) -> [N; 3] {
        gradient
    }
}

/// Why a frame or an affine placement cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FrameError {
    /// A coordinate is not finite or beyond the budget.
    Position(ValueError),
    /// The axes do not span a right-handed frame, or directions are parallel.
    Axes,
    /// The angle is not between -360 and 360 degrees.
    Angle,
    /// The quaternion is not finite, or its length is beyond its limits.
    Quaternion,
    /// The normal of a plane is zero, not finite or beyond the budget.
    Normal(ValueError),
    /// A component of an axis of the matrix is not finite or beyond the budget.
    Axis(ValueError),
    /// A factor of the scale is not positive, not finite or beyond the budget.
    Scale(ValueError),
    /// The matrix has no inverse that the number type could hold.
    Singular,
}

impl FrameError {
    /// The message; also for constants.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Position(error) => with_fault!("a coordinate of the position ", error),
            Self::Axes => {
                "the axes do not span a right-handed frame: two are parallel, or the third points the other way"
            }
            Self::Angle => "the angle must lie between -360 and 360 degrees",
            Self::Quaternion => {
                "the quaternion must be finite and neither nearly zero nor very long; of length 1 in a constant"
            }
            Self::Normal(error) => with_fault!("the normal ", error),
            Self::Axis(error) => with_fault!("a component of an axis of the matrix ", error),
            Self::Scale(error) => with_fault!("a factor of the scale ", error),
            Self::Singular => {
                "the matrix has no inverse that the number type could hold: an axis has no length, or the three lie \
                 in a plane"
            }
        }
    }
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for FrameError {}
