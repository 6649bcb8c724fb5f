//! The capsule: a cylinder with round ends, all points within `r` of the segment from the origin to (0, height, 0).

use super::{Geometry, SizeError, checked_size, checked_size_or_zero, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{BetweenBalls, Guards};
use crate::intersection::{End, Intersection};
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Ring, Scalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};
use core::cmp::Ordering;

/// A cylinder with hemispherical caps, which its height does not include; in other words a sphere swept along a
/// segment.
///
/// ```
/// use raylet::{Capsule, Part, Ray, UnitVec3, Vec3};
/// let pill = Capsule::new(1.0_f32, 2.0)?;
/// let ray = Ray::new(Vec3::new(0.0, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits = pill.hits(&ray);
/// assert_eq!((hits[0].t, hits[0].part), (2.0, Part::Top));
/// assert_eq!((hits[1].t, hits[1].part), (6.0, Part::Base));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule<S> {
    pub(super) radius: S,
    pub(super) height: S,
}

impl<S: Scalar> Capsule<S> {
    /// A capsule of this radius whose straight side has this height. A height of zero makes it a sphere.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the radius is not positive, the height is negative, or one is not finite or beyond the budget.
    pub fn new(radius: S, height: S) -> Result<Self, SizeError> {
        Ok(Self {
            radius: checked_size(radius, SizeError::Radius)?,
            height: checked_size_or_zero(height, SizeError::Height)?,
        })
    }

    /// A capsule of this radius that measures `length` from end to end, its round ends included: its height is
    /// `length - 2 radius`, rounded.
    ///
    /// # Errors
    ///
    /// [`SizeError`] as for [`Capsule::new`]; the height is negative if the length is less than twice the radius.
    ///
    /// ```
    /// use raylet::Capsule;
    /// assert_eq!(Capsule::from_end_to_end(1.0_f32, 5.0)?, Capsule::new(1.0, 3.0)?);
    /// let error = Capsule::from_end_to_end(1.0_f32, 1.5).unwrap_err();
    /// assert_eq!(error.to_string(), "the height is negative");
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn from_end_to_end(radius: S, length: S) -> Result<Self, SizeError> {
        let radius = checked_size(radius, SizeError::Radius)?;
        Self::new(radius, length.minus(radius).minus(radius))
    }

    /// The radius of the side and of the ends.
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// The height of the straight side.
    pub const fn height(&self) -> S {
        self.height
    }

    /// The balls at both ends, on the grid.
    #[inline(always)]
    fn on_grid<'a, T: Guards>(
        &'a self,
        line: &'a LocalLine<S>,
    ) -> BetweenBalls<'a, S, impl Fn(S) -> Attempt<Ordering> + 'a>
    where
        S: GridScalar,
    {
        let seams = |t| line.seams(t, self.height, T::GUARDED);
        let Self { radius, height } = *self;
        BetweenBalls { line, seams, radii: [radius; 2], height, by_moment: T::GUARDED, is_strict: T::STRICT }
    }

    /// The point of the axis's segment nearest to a point of the part.
    fn centre(&self, part: Part) -> Vec3<S> {
        if part == Part::Top { Vec3::new(S::ZERO, self.height, S::ZERO) } else { Vec3::ZERO }
    }
}

impl<S: Copy> Capsule<S> {
    /// The capsule with `f` applied to its sizes.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> Capsule<R> {
        Capsule { radius: f(self.radius), height: f(self.height) }
    }
}

impl<S> Described for Capsule<S> {
    const EQUATIONS: EquationKinds = EquationKinds::CAPSULE;
}

impl<S: Scalar> Geometry<S> for Capsule<S> {
    type In<R: Scalar> = Capsule<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }
    fn largest_coordinate(&self) -> S {
        self.radius.plus(self.height)
    }

    #[inline(always)]
    fn radius_about_axis(&self) -> Option<S> {
        Some(self.radius)
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|size| size.scaled(e))
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        self.on_grid::<T>(line).meets(&found!(line.cylinder(self.radius)))
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        let cylinder = match from {
            Part::Side => found!(line.exit_from_round(false)),
            _ => found!(found!(line.cylinder(self.radius)).exit()),
        };
        self.on_grid::<T>(line).exit([cylinder; 2], from)
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::capsule(ray, [self.radius, self.height], goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Capsule { radius: self.radius, height: self.height }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Balls([[S::ZERO, self.radius], [self.height, self.radius]])
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        if part == Part::Side {
            return coordinates::at_distance(point, |component| self.radius.along(component));
        }
        Vec3::from(self.normal(point, part).to_array().map(|component| self.radius.along(component)))
            + self.centre(part)
    }

    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Base => UnitVec3::new_or(point, -UnitVec3::Y),
            Part::Top => UnitVec3::new_or(point - self.centre(part), UnitVec3::Y),
            _ => coordinates::outwards(point),
        }
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        self.radius
    }

    /// `v` is the length of the outline from the lowest point, as a fraction of the whole.
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        // An eighth of each, so that the length of the outline does not overflow for the largest capsule.
        let [radius, height, y] = [self.radius, self.height, point.y].map(|size| size.real().scaled(-3));
        // An arc of a quarter turn: r pi / 2, with pi / 2 = 11 / 7 within 1/2000. That is accurate enough for textures,
        // and the parts join without a gap.
        let quarter = radius * (S::Real::from_int(11) / S::Real::from_int(7));
        let along = match part {
            Part::Base => S::unit_real(super::sphere::latitude(point)) * quarter.scaled(1),
            Part::Top => height + S::unit_real(super::sphere::latitude(point - self.centre(part))) * quarter.scaled(1),
            _ => quarter + y,
        };
        (coordinates::azimuth(point), coordinates::fraction::<S>(along, height + quarter.scaled(1)))
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::tangents_around(point, self.normal(point, part))
    }
}

queries!(Capsule);
