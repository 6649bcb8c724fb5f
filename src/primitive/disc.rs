//! The disc in the plane `y = 0`.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
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

/// A disc about the origin in the plane `y = 0`, its rim included; an open surface whose front is +y.
///
/// ```
/// use raylet::{Disc, Ray, UnitVec3, Vec3};
/// let disc = Disc::new(1.0_f32)?;
/// let ray = Ray::new(Vec3::new(1.0, 2.0, 0.0), -UnitVec3::Y)?;
/// assert!(disc.occludes(&ray));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc<S> {
    pub(super) radius: S,
}

impl<S: Scalar> Disc<S> {
    /// A disc of this radius.
    ///
    /// # Errors
    ///
    /// [`SizeError::Radius`] if it is not positive, not finite or beyond the budget.
    pub fn new(radius: S) -> Result<Self, SizeError> {
        Ok(Self { radius: checked_size(radius, SizeError::Radius)? })
    }

    /// The radius.
    pub const fn radius(&self) -> S {
        self.radius
    }
}

impl<S: Copy> Disc<S> {
    /// The disc with `f` applied to its radius.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> Disc<R> {
        Disc { radius: f(self.radius) }
    }
}

impl<S> Described for Disc<S> {
    const EQUATIONS: EquationKinds = EquationKinds::DISC;
}

impl<S: Scalar> Geometry<S> for Disc<S> {
    type In<R: Scalar> = Disc<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }
    fn largest_coordinate(&self) -> S {
        self.radius
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|radius| radius.scaled(e))
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let t = found!(line.disc(self.radius));
        Attempt::Hit(surface_hit(t, line.direction[1] < S::Unit::ZERO))
    }

    const NEEDS: Needs = Needs::Flat;
    const HAS_FEW_FACTORS: bool = true;

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::disc(ray, self.radius, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Disc { radius: self.radius }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Discs([[S::ZERO, self.radius]; 2])
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
        coordinates::planar(point, self.radius.real())
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::planar_tangents()
    }
}

queries!(Disc);
