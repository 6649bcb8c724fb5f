//! The annulus in the plane `y = 0`: `r^2 <= x^2 + z^2 <= R^2`.

use super::{Geometry, SizeError, checked_radii, queries, surface_coordinates as coordinates};
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
use core::cmp::Ordering;

/// What lies between two circles about the origin in the plane `y = 0`, both circles included; an open surface whose
/// front is +y.
///
/// A ray in its plane is [`coincident`](crate::Hits::coincident) with it from one crossing of the outer circle to the
/// other, also across the hole.
///
/// ```
/// use raylet::{Annulus, Ray, UnitVec3, Vec3};
/// let washer = Annulus::new(0.5_f32, 1.0)?;
/// let down = |x| Ray::new(Vec3::new(x, 2.0, 0.0), -UnitVec3::Y);
/// assert!(washer.occludes(&down(0.5)?) && !washer.occludes(&down(0.25)?));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Annulus<S> {
    /// The inner and the outer radius.
    pub(super) radii: [S; 2],
}

impl<S: Scalar> Annulus<S> {
    /// An annulus of these radii.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a radius is not positive, not finite or beyond the budget, or the inner one is not below the
    /// outer one.
    pub fn new(inner_radius: S, outer_radius: S) -> Result<Self, SizeError> {
        Ok(Self { radii: checked_radii(inner_radius, outer_radius)? })
    }

    /// The inner radius.
    pub const fn inner_radius(&self) -> S {
        self.radii[0]
    }

    /// The outer radius.
    pub const fn outer_radius(&self) -> S {
        self.radii[1]
    }
}

impl<S: Copy> Annulus<S> {
    /// The annulus with `f` applied to its radii.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> Annulus<R> {
        Annulus { radii: self.radii.map(f) }
    }
}

impl<S> Described for Annulus<S> {
    const EQUATIONS: EquationKinds = EquationKinds::ANNULUS;
}

impl<S: Scalar> Geometry<S> for Annulus<S> {
    type In<R: Scalar> = Annulus<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }

    fn largest_coordinate(&self) -> S {
        self.outer_radius()
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|radius| radius.scaled(e))
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let [inner, outer] = self.radii;
        let t = found!(line.disc(outer));
        match line.disc(inner) {
            Attempt::Hit(_) => Attempt::Miss,
            Attempt::Miss => Attempt::Hit(surface_hit(t, line.direction[1] < S::Unit::ZERO)),
            Attempt::Unsure => Attempt::Unsure,
        }
    }

    const NEEDS: Needs = Needs::Flat;
    const HAS_FEW_FACTORS: bool = true;

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::annulus(ray, self.radii, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Annulus { radii: self.radii }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Discs([[S::ZERO, self.outer_radius()]; 2])
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        coordinates::at_circle(Vec3 { y: S::ZERO, ..point }, self.inner_radius(), Ordering::Less)
    }

    fn normal(&self, _: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::Y
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        coordinates::planar(point, self.outer_radius().real())
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::planar_tangents()
    }
}

queries!(Annulus);
