//! The sphere about the origin: `x^2 + y^2 + z^2 = r^2`.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::Guards;
use crate::intersection::{End, Intersection, Span};
use crate::line::{Needs, Place};
use crate::part::Part;
use crate::ray::Ray;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Ring, Scalar, found, largest};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};

/// A sphere about the origin, with its inside: a closed ball.
///
/// ```
/// use raylet::{Ray, Sphere, UnitVec3, Vec3};
/// let ball = Sphere::new(1.0_f32)?;
/// // For a ray that starts 4100 away the textbook formula returns 4100 for both hits.
/// let ray = Ray::new(Vec3::new(-4100.0, 0.5, 0.0), UnitVec3::X)?;
/// let hits = ball.hits(&ray);
/// assert_eq!((hits[0].t, hits[1].t), (4099.134, 4100.866));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S> {
    pub(super) radius: S,
}

impl<S: Scalar> Sphere<S> {
    /// A sphere of this radius.
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

impl<S: Copy> Sphere<S> {
    /// The sphere with `f` applied to its radius.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> Sphere<R> {
        Sphere { radius: f(self.radius) }
    }
}

impl<S> Described for Sphere<S> {
    const EQUATIONS: EquationKinds = EquationKinds::BALL;
}

impl<S: Scalar> Geometry<S> for Sphere<S> {
    type In<R: Scalar> = Sphere<R>;

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
    fn grid_line(&self, place: &impl Place<S>, ray: &Ray<S>) -> Option<LocalLine<S>>
    where
        S: GridScalar,
    {
        place.grid_ball_line(ray)
    }

    /// The line is only translated, and needs no finer units.
    #[inline(always)]
    fn fit(&self, _: &mut LocalLine<S>)
    where
        S: GridScalar,
    {
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let [low, high] = found!(line.ball(self.radius, T::GUARDED, T::STRICT));
        Attempt::Hit(Intersection::One(Span::new(End::new(low, Part::Side), End::new(high, Part::Side))))
    }

    #[inline(always)]
    fn occludes_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<()>
    where
        S: GridScalar,
    {
        line.ball_ahead(self.radius, T::GUARDED)
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, _: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        Attempt::Hit(End::new(found!(line.exit_from_round(true)), Part::Side))
    }

    const NEEDS: Needs = Needs::Translation;
    const HAS_CONSTANT_BOUNDS: bool = true;
    const HAS_FEW_FACTORS: bool = true;

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::ball(ray, self.radius, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Ball { radius: self.radius }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Ball(self.radius)
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        self.normal(point, part).to_array().map(|component| self.radius.along(component)).into()
    }

    fn normal(&self, point: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::new_or(point, UnitVec3::Y)
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        self.radius
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        (coordinates::azimuth(point), latitude(point))
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::tangents_around(point, self.normal(point, part))
    }
}

/// The angle from the lowest point, as a fraction of half a turn.
pub(super) fn latitude<S: Scalar>(point: Vec3<S>) -> S::Unit {
    // Scaled to near 1, so that no square overflows.
    let e = S::binary_exponent(largest([point.x, point.y, point.z]));
    let [x, y, z] = point.to_array().map(|component| component.scaled(-e).real());
    let from_axis = (x * x + z * z).sqrt();
    let half_turns = S::unit_real(S::turns(from_axis, -y)).scaled(1);
    coordinates::fraction::<S>(half_turns, S::Real::ONE)
}

queries!(Sphere);
