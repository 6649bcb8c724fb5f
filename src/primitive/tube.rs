//! The tube about the y axis: `r^2 <= x^2 + z^2 <= R^2` between two planes.

use super::{Geometry, SizeError, checked_radii, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{Guards, Slab};
use crate::intersection::{End, Intersection, Span};
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Scalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};
use core::cmp::Ordering;

/// A tube about the y axis, `0 <= y <= height`: a solid with a wall between two radii and flat ends, which are annuli.
///
/// The part [`Part::Inner`] is the inner side; its normal points to the axis, and `u` grows clockwise as seen from +y.
/// A line may enter a tube twice. A line that touches the inner side from within the wall does not leave the wall.
///
/// ```
/// use raylet::{Part, Ray, Tube, UnitVec3, Vec3};
/// let pipe = Tube::new(0.75_f32, 1.0, 4.0)?;
/// let ray = Ray::new(Vec3::new(-3.0, 2.0, 0.0), UnitVec3::X)?;
/// let hits: Vec<_> = pipe.hits(&ray).iter().map(|hit| (hit.t, hit.part)).collect();
/// assert_eq!(hits, [(2.0, Part::Side), (2.25, Part::Inner), (3.75, Part::Inner), (4.0, Part::Side)]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube<S> {
    /// The inner and the outer radius.
    pub(super) radii: [S; 2],
    pub(super) height: S,
}

impl<S: Scalar> Tube<S> {
    /// A tube of these radii and this height.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget, or the inner radius is not below the
    /// outer one.
    pub fn new(inner_radius: S, outer_radius: S, height: S) -> Result<Self, SizeError> {
        let radii = checked_radii(inner_radius, outer_radius)?;
        Ok(Self { radii, height: checked_size(height, SizeError::Height)? })
    }

    /// A tube by its outer radius, the thickness of its wall, and its height. The inner radius is rounded.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget, or the wall is not thinner than the
    /// outer radius, or so thin that the two radii are the same number.
    ///
    /// ```
    /// use raylet::Tube;
    /// assert_eq!(Tube::with_wall(1.0, 0.25, 4.0)?, Tube::new(0.75, 1.0, 4.0)?);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn with_wall(outer_radius: S, wall: S, height: S) -> Result<Self, SizeError> {
        let wall = checked_size(wall, SizeError::Radius)?;
        let outer = checked_size(outer_radius, SizeError::Radius)?;
        if wall >= outer {
            return Err(SizeError::Radii);
        }
        Self::new(outer.minus(wall), outer, height)
    }

    /// The inner radius.
    pub const fn inner_radius(&self) -> S {
        self.radii[0]
    }

    /// The outer radius.
    pub const fn outer_radius(&self) -> S {
        self.radii[1]
    }

    /// The height.
    pub const fn height(&self) -> S {
        self.height
    }
}

impl<S: Copy> Tube<S> {
    /// The tube with `f` applied to its sizes.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> Tube<R> {
        Tube { radii: self.radii.map(&f), height: f(self.height) }
    }
}

impl<S> Described for Tube<S> {
    const EQUATIONS: EquationKinds = EquationKinds::TUBE;
}

impl<S: Scalar> Geometry<S> for Tube<S> {
    type In<R: Scalar> = Tube<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }

    fn largest_coordinate(&self) -> S {
        self.outer_radius().plus(self.height)
    }

    #[inline(always)]
    fn radius_about_axis(&self) -> Option<S> {
        Some(self.outer_radius())
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|size| size.scaled(e))
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let [inner, outer] = self.radii;
        let outer = found!(line.cylinder(outer));
        let slab = found!(Slab::new::<T>(line, S::ZERO, self.height));
        let whole = found!(slab.clip(&outer));
        let gap = match line.cylinder(inner) {
            Attempt::Hit(inner) => slab.clip(&inner),
            Attempt::Miss => Attempt::Miss,
            Attempt::Unsure => Attempt::Unsure,
        };
        match (whole, gap) {
            (_, Attempt::Unsure) => Attempt::Unsure,
            (Intersection::One(whole), Attempt::Hit(Intersection::One(gap))) => less_the_gap(whole, gap),
            (whole, _) => Attempt::Hit(whole),
        }
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::tube(ray, self.radii, self.height, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Tube { radii: self.radii, height: self.height }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Discs([[S::ZERO, self.outer_radius()], [self.height, self.outer_radius()]])
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        let at = |radius: S| coordinates::at_distance(coordinates::between(point, self.height), |c| radius.along(c));
        match part {
            Part::Base => coordinates::at_circle(Vec3 { y: S::ZERO, ..point }, self.inner_radius(), Ordering::Less),
            Part::Top => coordinates::at_circle(Vec3 { y: self.height, ..point }, self.inner_radius(), Ordering::Less),
            Part::Inner => at(self.inner_radius()),
            _ => at(self.outer_radius()),
        }
    }

    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Base => -UnitVec3::Y,
            Part::Top => UnitVec3::Y,
            Part::Inner => -coordinates::outwards(point),
            _ => coordinates::outwards(point),
        }
    }

    fn bend(&self, _: Vec3<S>, part: Part) -> S {
        match part {
            Part::Base | Part::Top => S::INFINITY,
            Part::Inner => self.inner_radius(),
            _ => self.outer_radius(),
        }
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        match part {
            Part::Base | Part::Top => coordinates::planar(point, self.outer_radius().real()),
            // Seen from the axis, the other way around.
            Part::Inner => self.uv(Vec3 { z: S::ZERO.minus(point.z), ..point }, Part::Side),
            _ => (coordinates::azimuth(point), coordinates::fraction::<S>(point.y.real(), self.height.real())),
        }
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        match part {
            Part::Base | Part::Top => coordinates::planar_tangents(),
            Part::Inner => (-coordinates::around(point), UnitVec3::Y),
            _ => (coordinates::around(point), UnitVec3::Y),
        }
    }
}

/// An interval inside the outer side, less that inside the inner side, whose ends on the planes are those of the outer
/// interval.
#[inline(always)]
fn less_the_gap<S: Scalar>(whole: Span<S>, gap: Span<S>) -> Attempt<Intersection<S>> {
    // Of two planes at one point, a touch, and a wall that rounding makes vanish at a rim, the solver decides.
    let vanishes = |own: Part, gap: Part| own == Part::Side && gap != Part::Side;
    let is_thin = vanishes(whole.enter.part, gap.enter.part) || vanishes(whole.exit.part, gap.exit.part);
    if gap.touch || whole.touch || is_thin {
        return Attempt::Unsure;
    }
    // Rounding may have exchanged the ends of a thin wall.
    let first = (gap.enter.part == Part::Side).then(|| {
        let t = if gap.enter.t < whole.enter.t { whole.enter.t } else { gap.enter.t };
        Span::new(whole.enter, End::new(t, Part::Inner))
    });
    let second = (gap.exit.part == Part::Side).then(|| {
        let t = if gap.exit.t > whole.exit.t { whole.exit.t } else { gap.exit.t };
        Span::new(End::new(t, Part::Inner), whole.exit)
    });
    match (first, second) {
        (None, None) => Attempt::Miss,
        (Some(only), None) | (None, Some(only)) => Attempt::Hit(Intersection::One(only)),
        (Some(first), Some(second)) => Attempt::Hit(Intersection::Two(first, second)),
    }
}

queries!(Tube);
