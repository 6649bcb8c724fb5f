//! The plane `y = 0`.

use super::{Geometry, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::frame::{Frame, FrameError};
use crate::geometry::Hull;
use crate::grid::Guards;
use crate::grid::surface_hit;
use crate::intersection::Intersection;
use crate::line::Needs;
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Scalar, UnitScalar, ValueError, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};
use core::marker::PhantomData;

/// The plane `y = 0`, an open surface whose front is +y.
///
/// ```
/// use raylet::{Crossing, Plane, Ray, UnitVec3, Vec3};
/// let ray = Ray::new(Vec3::new(0.0_f32, 2.0, 0.0), -UnitVec3::Y)?;
/// let hit = Plane::new().nearest(&ray);
/// assert_eq!(hit.map(|hit| (hit.t, hit.crossing)), Some((2.0, Crossing::Enter)));
/// # Ok::<(), raylet::RayError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane<S> {
    scalar: PhantomData<S>,
}

impl<S: Scalar> Plane<S> {
    /// The plane `y = 0`.
    pub const fn new() -> Self {
        Self { scalar: PhantomData }
    }

    /// The plane of the points `p` with `normal . p = distance`, its front towards the normal, and the frame that
    /// places it. The normal may have any length but zero.
    ///
    /// # Errors
    ///
    /// [`FrameError::Normal`] if the normal is zero, not finite or beyond the budget; [`FrameError::Position`] if
    /// the distance from the origin is.
    ///
    /// ```
    /// use raylet::{Plane, Ray, Shape, UnitVec3, Vec3};
    /// // 3 x + 4 y = 10, at a distance of 2 from the origin.
    /// let (plane, frame) = Plane::from_equation(Vec3::new(3.0_f32, 4.0, 0.0), 10.0)?;
    /// let ramp = Shape::new(plane).placed(frame);
    /// let ray = Ray::new(Vec3::new(0.0, 5.0, 0.0), -UnitVec3::Y)?;
    /// assert_eq!(ramp.nearest(&ray).map(|hit| hit.t), Some(2.5));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn from_equation(normal: Vec3<S>, distance: S) -> Result<(Self, Frame<S>), FrameError> {
        let axis = normal.checked().and_then(UnitVec3::new).map_err(FrameError::Normal)?;
        let length = normal.dot(axis);
        if !distance.is_finite() {
            return Err(FrameError::Position(ValueError::NotFinite));
        }
        let away = distance.real() / length;
        Ok((Self::new(), Frame::from_base_and_axis(Vec3::round(axis.real().map(|c| c * away)), axis)?))
    }
}

impl<S> Described for Plane<S> {
    const EQUATIONS: EquationKinds = EquationKinds::PLANE;
}

impl<S: Scalar> Geometry<S> for Plane<S> {
    type In<R: Scalar> = Plane<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(Plane::new())
    }

    fn largest_coordinate(&self) -> S {
        S::ZERO
    }

    fn scaled(&self, _: i32) -> Self {
        *self
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        match line.crossing(S::ZERO) {
            Attempt::Hit(t) => Attempt::Hit(surface_hit(t, line.direction[1] < S::Unit::ZERO)),
            // A line parallel to the plane may lie in it.
            _ => Attempt::Unsure,
        }
    }

    /// False if the line leads away from the plane.
    #[inline(always)]
    fn occludes_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<()>
    where
        S: GridScalar,
    {
        let (y, dy) = (line.origin[1], line.direction[1]);
        let moves_away = if y < S::ZERO { dy <= S::Unit::ZERO } else { y > S::ZERO && dy >= S::Unit::ZERO };
        if !S::RELATIVE && line.extra_bits == 0 && moves_away {
            return Attempt::Miss;
        }
        found!(self.meets_on_grid::<T>(line)).occlusion()
    }

    const NEEDS: Needs = Needs::Height;
    const HAS_FEW_FACTORS: bool = true;

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::plane(ray, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Plane
    }

    fn hull(&self) -> Hull<S> {
        Hull::Discs([[S::ZERO, S::INFINITY]; 2])
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        Vec3 { y: S::ZERO, ..point }
    }

    fn normal(&self, _: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::Y
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        (coordinates::repeating(point.x), coordinates::repeating(point.z))
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::planar_tangents()
    }
}

queries!(Plane);
