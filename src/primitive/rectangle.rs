//! The rectangle in the plane `y = 0`.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{Guards, surface_hit};
use crate::intersection::Intersection;
use crate::line::Needs;
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Scalar, UnitScalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};

/// A rectangle about the origin in the plane `y = 0`, its edges included; an open surface whose front is +y.
///
/// The surface coordinates `u` and `v` are x and z, each from 0 to 1 over the rectangle.
///
/// ```
/// use raylet::{Rectangle, Ray, UnitVec3, Vec3};
/// let table = Rectangle::new(2.0_f32, 1.0)?;
/// // Through a corner.
/// let ray = Ray::new(Vec3::new(2.0, 3.0, -1.0), -UnitVec3::Y)?;
/// assert_eq!(table.nearest(&ray).map(|hit| hit.t), Some(3.0));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle<S> {
    pub(super) half: [S; 2],
}

impl<S: Scalar> Rectangle<S> {
    /// The rectangle with these half extents along x and z.
    ///
    /// # Errors
    ///
    /// [`SizeError::HalfExtent`] if one is not positive, not finite or beyond the budget.
    pub fn new(half_x: S, half_z: S) -> Result<Self, SizeError> {
        let checked = |half| checked_size(half, SizeError::HalfExtent);
        Ok(Self { half: [checked(half_x)?, checked(half_z)?] })
    }

    /// The half extents along x and z.
    pub const fn half_extents(&self) -> [S; 2] {
        self.half
    }
}

impl<S> Described for Rectangle<S> {
    const EQUATIONS: EquationKinds = EquationKinds::RECTANGLE;
}

impl<S: Scalar> Geometry<S> for Rectangle<S> {
    type In<R: Scalar> = Rectangle<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(Rectangle { half: self.half.map(R::exactly) })
    }

    /// The sum of the half extents, which is no less than the half diagonal.
    fn largest_coordinate(&self) -> S {
        let [x, z] = self.half;
        x.plus(z)
    }

    fn scaled(&self, e: i32) -> Self {
        Self { half: self.half.map(|half| half.scaled(e)) }
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let t = found!(line.rectangle(self.half));
        Attempt::Hit(surface_hit(t, line.direction[1] < S::Unit::ZERO))
    }

    const NEEDS: Needs = Needs::Flat;
    const HAS_FEW_FACTORS: bool = true;

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::rectangle(ray, self.half, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Rectangle { half: self.half }
    }

    fn hull(&self) -> Hull<S> {
        let [x, z] = self.half;
        Hull::Cuboid([x, S::ZERO, z])
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        let [x, z] = self.half;
        Vec3::new(coordinates::clamped(point.x, x), S::ZERO, coordinates::clamped(point.z, z))
    }

    fn normal(&self, _: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::Y
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        let [x, z] = self.half.map(S::real);
        (coordinates::across(point.x, x), coordinates::across(point.z, z))
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::planar_tangents()
    }
}

queries!(Rectangle);
