//! The torus about the y axis: all points within a radius of a circle.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::Guards;
use crate::intersection::{End, Intersection, Span};
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Scalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};

/// A torus about the y axis: a solid ring, all points within the minor radius of a circle in the plane `y = 0` about
/// the origin, whose radius is the major radius.
///
/// The minor radius is below the major one, so that there is a hole. All of its surface is [`Part::Side`]. `u` grows
/// around the axis and `v` around the tube, from the outer equator upwards. A line may enter a torus twice. A line that
/// touches the surface from within the solid does not leave it.
///
/// Along a line the equation is of the fourth degree. Its roots are counted and compared by signs of polynomials of its
/// coefficients, as all others are, so that [`Exact`](crate::Exact) is exact.
///
/// ```
/// use raylet::{Crossing, Ray, Torus, UnitVec3, Vec3};
/// let ring = Torus::new(1.0_f32, 0.25)?;
/// let ray = Ray::new(Vec3::new(-3.0, 0.0, 0.0), UnitVec3::X)?;
/// let hits: Vec<_> = ring.hits(&ray).iter().map(|hit| hit.t).collect();
/// assert_eq!(hits, [1.75, 2.25, 3.75, 4.25]);
/// // It lies on the ring from above.
/// let touching = Ray::new(Vec3::new(-3.0, 0.25, 1.0), UnitVec3::X)?;
/// assert_eq!(ring.nearest(&touching).map(|hit| (hit.t, hit.crossing)), Some((3.0, Crossing::Touch)));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus<S> {
    /// The major and the minor radius.
    pub(super) radii: [S; 2],
}

impl<S: Scalar> Torus<S> {
    /// A torus whose tube has the minor radius about a circle of the major radius.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a radius is not positive, not finite or beyond the budget, or the minor radius is not below the
    /// major one.
    pub fn new(major_radius: S, minor_radius: S) -> Result<Self, SizeError> {
        let major = checked_size(major_radius, SizeError::Radius)?;
        let minor = checked_size(minor_radius, SizeError::Radius)?;
        if minor < major { Ok(Self { radii: [major, minor] }) } else { Err(SizeError::Ring) }
    }

    /// The radius of the circle in the middle of the tube.
    pub const fn major_radius(&self) -> S {
        self.radii[0]
    }

    /// The radius of the tube.
    pub const fn minor_radius(&self) -> S {
        self.radii[1]
    }
}

impl<S: Copy> Torus<S> {
    /// The torus with `f` applied to its radii.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> Torus<R> {
        Torus { radii: self.radii.map(f) }
    }
}

impl<S: Scalar> Torus<S> {
    /// The nearest point of the circle in the middle of the tube.
    fn middle(&self, point: Vec3<S>) -> Vec3<S> {
        coordinates::at_distance(Vec3 { y: S::ZERO, ..point }, |c| self.major_radius().along(c))
    }

    /// From the nearest point of that circle to this point.
    fn offset(&self, point: Vec3<S>) -> Vec3<S> {
        let middle = self.middle(point);
        Vec3 { x: point.x.minus(middle.x), y: point.y, z: point.z.minus(middle.z) }
    }
}

impl<S> Described for Torus<S> {
    const EQUATIONS: EquationKinds = EquationKinds::TORUS;
}

impl<S: Scalar> Geometry<S> for Torus<S> {
    type In<R: Scalar> = Torus<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }

    fn largest_coordinate(&self) -> S {
        let [major, minor] = self.radii;
        major.plus(minor)
    }

    #[inline(always)]
    fn radius_about_axis(&self) -> Option<S> {
        // The sum may be rounded down.
        Some(self.largest_coordinate().next_up())
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|radius| radius.scaled(e))
    }

    const HAS_LONG_FORMULAS: bool = true;

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let (first, second) = found!(line.torus(self.radii));
        let [enter, _] = first.ends;
        Attempt::Hit(match (first.are_accurate(), second) {
            ([_, false], _) => Intersection::Entered(End::new(enter, Part::Side)),
            (_, None) => Intersection::One(Span::of_side(first.ends)),
            (_, Some(second)) => Intersection::Two(Span::of_side(first.ends), Span::of_side(second.ends)),
        })
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::torus(ray, self.radii, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Torus { radii: self.radii }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Torus(self.radii)
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        let (middle, minor) = (self.middle(point), self.minor_radius());
        let out = UnitVec3::new_or(self.offset(point), UnitVec3::Y);
        Vec3 { x: middle.x.plus(minor.along(out.x())), y: minor.along(out.y()), z: middle.z.plus(minor.along(out.z())) }
    }

    fn normal(&self, point: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::new_or(self.offset(point), UnitVec3::Y)
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        // Around the tube, or around the hole.
        let [major, minor] = self.radii;
        let hole = major.minus(minor);
        if hole < minor { hole } else { minor }
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        let (offset, outwards) = (self.offset(point).real(), coordinates::outwards(point));
        let [x, _, z] = outwards.real();
        let across = S::Real::sum_of_products([[offset[0], x], [offset[2], z]]);
        (coordinates::azimuth(point), S::turns(offset[1], across))
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::tangents_around(point, self.normal(point, part))
    }
}

queries!(Torus);
