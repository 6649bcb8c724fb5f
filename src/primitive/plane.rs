//! The plane `y = 0`.

use super::{Geometry, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::Guards;
use crate::grid::surface_hit;
use crate::intersection::Intersection;
use crate::line::Needs;
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Scalar, UnitScalar, found};
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
}

impl<S> Described for Plane<S> {
    const EQUATIONS: EquationKinds = EquationKinds::PLANE;
}

impl<S: Scalar> Geometry<S> for Plane<S> {
    type In<R: Scalar> = Plane<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Self::In<R> {
        Plane::new()
    }

    fn bounding_radius(&self) -> S {
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
