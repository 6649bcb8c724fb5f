//! The cuboid: `|x| <= h_x`, `|y| <= h_y`, `|z| <= h_z`.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::frame::Frame;
use crate::geometry::Hull;
use crate::grid::Guards;
use crate::intersection::{End, Intersection, Span};
use crate::line::Needs;
use crate::part::{Part, face_of};
use crate::scalar::{Attempt, GridScalar, InCuboid, Including, LocalLine, Ring, Scalar, UnitScalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3, component, pairs};
use core::cmp::Ordering;

/// A closed cuboid about the origin, given by its half extents along x, y and z.
///
/// Its six faces are parts: `Left` and `Right` at the lowest and highest `x`, `Base` and `Top` at the lowest and
/// highest `y`, `Back` and `Front` at the lowest and highest `z`.
///
/// # Edges and corners
///
/// An edge or a corner belongs to the first of its faces in the order of the axes x, z, y: `Left` and `Right` own all
/// their edges, `Back` and `Front` those that they share with `Base` and `Top`. The four faces at the sides thus own
/// their edges with the base and the top, as the side of a cylinder owns its rims. A ray in the plane of a face enters
/// and leaves through edges of that face; a ray along an edge through its corners. A ray that meets nothing but a point
/// of an edge, or a corner, touches it: one hit.
///
/// # Surface coordinates
///
/// On the faces at the sides `v` grows upwards and `u` counter-clockwise as seen from +y: towards -z on `Right`, -x on
/// `Back`, +z on `Left`, +x on `Front`. On `Base` and `Top` they are x and z, as on the caps of a cylinder. Each runs
/// from 0 to 1 over the face.
///
/// ```
/// use raylet::{Crossing, Cuboid, Part, Ray, UnitVec3, Vec3};
/// let brick = Cuboid::new(2.0_f32, 0.5, 1.0)?;
/// let ray = Ray::new(Vec3::new(1.5, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits = brick.hits(&ray);
/// assert_eq!((hits[0].t, hits[0].part, hits[0].crossing), (4.5, Part::Top, Crossing::Enter));
/// assert_eq!((hits[1].t, hits[1].part, hits[1].crossing), (5.5, Part::Base, Crossing::Exit));
/// // In the plane of the top: through the edges that it shares with the left and the right face, which own them.
/// let ray = Ray::new(Vec3::new(-5.0, 0.5, 0.0), UnitVec3::X)?;
/// let parts: Vec<_> = brick.hits(&ray).into_iter().map(|hit| (hit.t, hit.part)).collect();
/// assert_eq!(parts, [(3.0, Part::Left), (7.0, Part::Right)]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid<S> {
    pub(super) half: [S; 3],
}

impl<S: Scalar> Cuboid<S> {
    /// The cuboid with these half extents along x, y and z.
    ///
    /// # Errors
    ///
    /// [`SizeError::HalfExtent`] if one is not positive, not finite or beyond the budget.
    pub fn new(half_x: S, half_y: S, half_z: S) -> Result<Self, SizeError> {
        let checked = |half| checked_size(half, SizeError::HalfExtent);
        Ok(Self { half: [checked(half_x)?, checked(half_y)?, checked(half_z)?] })
    }

    /// The cuboid whose faces are parallel to the axes of the world, from its lowest to its highest corner, and the
    /// frame that places it. Each face is within one unit in the last place of the largest coordinate.
    ///
    /// # Errors
    ///
    /// [`SizeError::HalfExtent`] if a coordinate of `high` is not larger than that of `low`, or the two are too close
    /// or too far apart; [`SizeError::Corner`] if a coordinate is not finite or beyond the budget.
    ///
    /// ```
    /// use raylet::{Cuboid, Ray, Shape, UnitVec3, Vec3};
    /// let (cuboid, frame) = Cuboid::between(Vec3::new(1.0_f32, 0.0, -1.0), Vec3::new(4.0, 2.0, 1.0))?;
    /// let crate_ = Shape::new(cuboid).placed(frame);
    /// let ray = Ray::new(Vec3::new(0.0, 1.0, 0.0), UnitVec3::X)?;
    /// assert_eq!(crate_.hits(&ray).iter().map(|hit| hit.t).collect::<Vec<_>>(), [1.0, 4.0]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn between(low: Vec3<S>, high: Vec3<S>) -> Result<(Self, Frame<S>), SizeError> {
        let [low, high] = [low.checked(), high.checked()].map(|corner| corner.map_err(SizeError::Corner));
        let corners = pairs(low?.real(), high?.real());
        // Halved before they are added: the sum may be beyond the type.
        let centre = corners.map(|(low, high)| low.scaled(-1) + high.scaled(-1));
        let [x, y, z] = corners.map(|(low, high)| S::round(high.scaled(-1) - low.scaled(-1)));
        Ok((Self::new(x, y, z)?, Frame::within_budget(Vec3::round(centre))))
    }

    /// The half extents along x, y and z.
    pub const fn half_extents(&self) -> [S; 3] {
        self.half
    }
}

/// The face perpendicular to this axis by which a line along `d` enters or leaves.
#[inline(always)]
fn face<U: UnitScalar>(axis: usize, d: [U; 3], leaves: bool) -> Part {
    face_of(axis, if (component(d, axis) < U::ZERO) == leaves { Ordering::Less } else { Ordering::Greater })
}

impl<S> Described for Cuboid<S> {
    const EQUATIONS: EquationKinds = EquationKinds::CUBOID;
}

impl<S: Scalar> Geometry<S> for Cuboid<S> {
    type In<R: Scalar> = Cuboid<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(Cuboid { half: self.half.map(R::exactly) })
    }

    /// The sum of the half extents, which is no less than the half diagonal.
    fn largest_coordinate(&self) -> S {
        let [x, y, z] = self.half;
        x.plus(y).plus(z)
    }

    fn scaled(&self, e: i32) -> Self {
        Self { half: self.half.map(|half| half.scaled(e)) }
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let InCuboid { ends: [enter, exit], axes } = found!(line.cuboid(self.half));
        let end = |t: S, axis: usize, leaves: bool| End::new(t, face(axis, line.direction, leaves));
        let enter = end(enter, axes[0], false);
        if !exit.is_finite() {
            return Attempt::Hit(Intersection::Entered(enter));
        }
        Attempt::Hit(Intersection::One(Span::new(enter, end(exit, axes[1], true))))
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        // Otherwise it leads along the face on which it starts, or leaves at once, whatever its rounded coordinates
        // are.
        let leads_in = |axis: usize| line.direction[axis] != S::Unit::ZERO && face(axis, line.direction, false) == from;
        if !(0..3).any(leads_in) {
            return Attempt::Unsure;
        }
        let (t, axis) = found!(line.exit_from_cuboid(self.half));
        Attempt::Hit(End::new(t, face(axis, line.direction, true)))
    }

    const NEEDS: Needs = Needs::Flat;

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::cuboid(ray, self.half, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Cuboid { half: self.half }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Cuboid(self.half)
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        let [x, y, z] = self.half;
        let Vec3 { x: px, y: py, z: pz } = point;
        let inside = Vec3::new(coordinates::clamped(px, x), coordinates::clamped(py, y), coordinates::clamped(pz, z));
        match part {
            Part::Left => Vec3 { x: -x, ..inside },
            Part::Right => Vec3 { x, ..inside },
            Part::Base => Vec3 { y: -y, ..inside },
            Part::Back => Vec3 { z: -z, ..inside },
            Part::Front => Vec3 { z, ..inside },
            _ => Vec3 { y, ..inside },
        }
    }

    fn normal(&self, _: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Left => -UnitVec3::X,
            Part::Right => UnitVec3::X,
            Part::Base => -UnitVec3::Y,
            Part::Back => -UnitVec3::Z,
            Part::Front => UnitVec3::Z,
            _ => UnitVec3::Y,
        }
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        let [x, y, z] = self.half.map(S::real);
        match part {
            Part::Left => (coordinates::across(point.z, z), coordinates::across(point.y, y)),
            Part::Right => (coordinates::across(-point.z, z), coordinates::across(point.y, y)),
            Part::Back => (coordinates::across(-point.x, x), coordinates::across(point.y, y)),
            Part::Front => (coordinates::across(point.x, x), coordinates::across(point.y, y)),
            _ => (coordinates::across(point.x, x), coordinates::across(point.z, z)),
        }
    }

    fn tangents(&self, _: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        match part {
            Part::Left => (UnitVec3::Z, UnitVec3::Y),
            Part::Right => (-UnitVec3::Z, UnitVec3::Y),
            Part::Back => (-UnitVec3::X, UnitVec3::Y),
            Part::Front => (UnitVec3::X, UnitVec3::Y),
            _ => coordinates::planar_tangents(),
        }
    }
}

queries!(Cuboid);

#[cfg(all(units, feature = "fixed"))]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../tests/units/primitive/cuboid.rs"]
mod tests;
