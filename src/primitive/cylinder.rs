//! The cylinder about the y axis: `x^2 + z^2 = r^2`.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{Guards, Slab, whole_side};
use crate::intersection::{End, Intersection};
use crate::outline::Extent;
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Scalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};

/// A cylinder about the y axis: infinite, an open side, or closed by flat caps at `y = 0` and `y = height`.
///
/// ```
/// use raylet::{Crossing, Cylinder, Part, Ray, UnitVec3, Vec3};
/// let can = Cylinder::capped(1.0_f32, 2.0)?;
/// let ray = Ray::new(Vec3::new(0.5, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits = can.hits(&ray);
/// assert_eq!((hits[0].t, hits[0].part, hits[0].crossing), (3.0, Part::Top, Crossing::Enter));
/// assert_eq!((hits[1].t, hits[1].part, hits[1].crossing), (5.0, Part::Base, Crossing::Exit));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder<S> {
    pub(super) radius: S,
    pub(super) extent: Extent<S>,
}

impl<S: Scalar> Cylinder<S> {
    /// How far the side reaches.
    pub(crate) const fn extent(&self) -> &Extent<S> {
        &self.extent
    }

    /// An infinite cylinder.
    ///
    /// # Errors
    ///
    /// [`SizeError::Radius`] if the radius is not positive, not finite or beyond the budget.
    pub fn infinite(radius: S) -> Result<Self, SizeError> {
        Ok(Self { radius: checked_size(radius, SizeError::Radius)?, extent: Extent::Infinite })
    }

    /// The side without caps, `0 <= y <= height`: an open surface.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget.
    pub fn open(radius: S, height: S) -> Result<Self, SizeError> {
        let extent = Extent::Open(checked_size(height, SizeError::Height)?);
        Ok(Self { radius: checked_size(radius, SizeError::Radius)?, extent })
    }

    /// A closed solid with flat caps, `0 <= y <= height`.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget.
    pub fn capped(radius: S, height: S) -> Result<Self, SizeError> {
        let extent = Extent::Capped(checked_size(height, SizeError::Height)?);
        Ok(Self { radius: checked_size(radius, SizeError::Radius)?, extent })
    }

    /// The radius.
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// The height; `None` for an infinite cylinder.
    pub const fn height(&self) -> Option<S> {
        self.extent.height()
    }
}

impl<S: Copy> Cylinder<S> {
    /// The cylinder with `f` applied to its sizes.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> Cylinder<R> {
        Cylinder { radius: f(self.radius), extent: self.extent.map(f) }
    }
}

impl<S> Described for Cylinder<S> {
    const EQUATIONS: EquationKinds = EquationKinds::CYLINDER;
}

impl<S: Scalar> Geometry<S> for Cylinder<S> {
    type In<R: Scalar> = Cylinder<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }

    fn largest_coordinate(&self) -> S {
        self.height().map_or(self.radius, |height| self.radius.plus(height))
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
        let inside = found!(line.cylinder(self.radius));
        match self.extent {
            Extent::Double | Extent::Infinite => Attempt::Hit(Intersection::One(found!(whole_side(&inside)))),
            Extent::Open(height) => found!(Slab::new::<T>(line, S::ZERO, height)).rims(&inside),
            Extent::Capped(height) => found!(Slab::new::<T>(line, S::ZERO, height)).clip(&inside),
        }
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        let side = if from == Part::Side {
            found!(line.exit_from_round(false))
        } else {
            found!(found!(line.cylinder(self.radius)).exit())
        };
        let side = End::new(side, Part::Side);
        match self.extent {
            Extent::Double | Extent::Infinite => Attempt::Hit(side),
            Extent::Open(_) => Attempt::Unsure,
            Extent::Capped(height) => found!(Slab::new::<T>(line, S::ZERO, height)).exit(side, from),
        }
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::cylinder(ray, self.radius, self.extent, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Cylinder { radius: self.radius, extent: self.extent }
    }

    fn hull(&self) -> Hull<S> {
        let (low, high) = self.height().map_or((-S::INFINITY, S::INFINITY), |height| (S::ZERO, height));
        Hull::Discs([[low, self.radius], [high, self.radius]])
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        match (part, self.height()) {
            (Part::Base, Some(_)) => Vec3 { y: S::ZERO, ..point },
            (Part::Top, Some(height)) => Vec3 { y: height, ..point },
            (_, height) => {
                let point = height.map_or(point, |height| coordinates::between(point, height));
                coordinates::at_distance(point, |component| self.radius.along(component))
            }
        }
    }

    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Base => -UnitVec3::Y,
            Part::Top => UnitVec3::Y,
            _ => coordinates::outwards(point),
        }
    }

    fn bend(&self, _: Vec3<S>, part: Part) -> S {
        if part == Part::Side { self.radius } else { S::INFINITY }
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        match (part, self.height()) {
            (Part::Side, Some(height)) => {
                (coordinates::azimuth(point), coordinates::fraction::<S>(point.y.real(), height.real()))
            }
            (Part::Side, None) => (coordinates::azimuth(point), coordinates::repeating(point.y)),
            _ => coordinates::planar(point, self.radius.real()),
        }
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        match part {
            Part::Base | Part::Top => coordinates::planar_tangents(),
            _ => (coordinates::around(point), UnitVec3::Y),
        }
    }
}

queries!(Cylinder);
