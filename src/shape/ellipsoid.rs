//! Ellipsoids: balls that are stretched along the axes of a frame.

use super::Shape;
use crate::affine::Affine;
use crate::frame::{Frame, FrameError};
use crate::primitive::{SizeError, Sphere, checked_size};
use crate::scalar::{Scalar, ValueError};
use crate::vector::Vec3;

/// An ellipsoid about the origin, `(x / a)^2 + (y / b)^2 + (z / c)^2 <= 1`, by its radii `a`, `b` and `c`.
///
/// It is no primitive of its own: [`Ellipsoid::placed`] makes the shape of a unit sphere, stretched by an [`Affine`].
/// So it has all that a placed sphere has, in every tier; its surface coordinates are those of the sphere. What is
/// stored, and what [`Exact`](crate::Exact) decides by, are the components of the frame's axes divided by the radii,
/// each rounded once. The axes of a turned frame are perpendicular only to their last bits, which shows where the ratio
/// of two radii is very large: of the radii 0.001, 1,000 and 1 in `f32` the largest is wrong by up to 1e-3.
///
/// ```
/// use raylet::{Ellipsoid, Frame, Ray, UnitVec3, Vec3};
/// let egg = Ellipsoid::new(1.0_f32, 2.0, 1.0)?;
/// let lying = egg.placed(Frame::from_base_and_axis(Vec3::new(0.0, 1.0, 0.0), UnitVec3::X)?)?;
/// let ray = Ray::new(Vec3::new(-10.0, 1.0, 0.0), UnitVec3::X)?;
/// let ts: Vec<_> = lying.hits(&ray).iter().map(|hit| hit.t).collect();
/// assert_eq!(ts, [8.0, 12.0]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid<S> {
    radii: [S; 3],
}

impl<S: Scalar> Ellipsoid<S> {
    /// The ellipsoid of these radii along x, y and z.
    ///
    /// # Errors
    ///
    /// [`SizeError::Radius`] if one is not positive, not finite or beyond the budget.
    pub fn new(radius_x: S, radius_y: S, radius_z: S) -> Result<Self, SizeError> {
        let checked = |radius| checked_size(radius, SizeError::Radius);
        Ok(Self { radii: [checked(radius_x)?, checked(radius_y)?, checked(radius_z)?] })
    }

    /// The radii along x, y and z.
    pub const fn radii(&self) -> [S; 3] {
        self.radii
    }

    /// Its shape about the position of a frame, with its radii along the frame's axes, seen from both sides.
    /// [`Shape::among`] makes it one of chosen kinds, which must hold spheres and affine placements.
    ///
    /// # Errors
    ///
    /// [`FrameError::Singular`] if an axis divided by a radius is beyond the numbers in which it is stored, and
    /// [`FrameError::Scale`] if the type does not hold the radius 1 of the unit sphere.
    ///
    /// ```
    /// use raylet::{Affine, Ellipsoid, Frame, Plane, Shape, Sphere, Vec3};
    /// type Few = (Sphere<f32>, Plane<f32>, Affine<f32>);
    /// let frame = Frame::at(Vec3::new(0.0, 3.0, 0.0))?;
    /// let egg: Shape<f32, Few> = Ellipsoid::new(1.0, 2.0, 1.0)?.placed(frame)?.among()?;
    /// assert!(egg.contains(Vec3::new(0.0, 4.875, 0.0)) && !egg.contains(Vec3::new(0.0, 5.125, 0.0)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn placed(&self, frame: Frame<S>) -> Result<Shape<S>, FrameError> {
        let unit = Sphere::new(S::ROUNDED_ONE).map_err(|_| FrameError::Scale(ValueError::BeyondType))?;
        Ok(Shape::new(unit).placed(Affine::stretched(frame, Vec3::from(self.radii))?))
    }

    /// Its shape in its canonical pose, about the origin.
    ///
    /// # Errors
    ///
    /// As [`Ellipsoid::placed`].
    pub fn shape(&self) -> Result<Shape<S>, FrameError> {
        self.placed(Frame::at(Vec3::ZERO)?)
    }
}
