//! The rounded cuboid: all points within a radius of a cuboid about the origin.

use super::{
    Cuboid, Geometry, SizeError, checked_size, checked_size_or_zero, queries, surface_coordinates as coordinates,
};
use crate::equations::{Described, EquationKinds, Equations, axis_of_face};
use crate::geometry::Hull;
use crate::grid::Guards;
use crate::intersection::{End, Intersection, Span};
use crate::part::{Part, face_of};
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Scalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3, component, pairs, with_component};
use core::cmp::Ordering;

/// A cuboid with round edges and corners: all points within the radius of a cuboid about the origin, its core.
///
/// It has the six faces of a [`Cuboid`], each as large as a face of the core and at the distance of the radius from it;
/// the edges and the corners, which are parts of cylinders and balls, are its part `Side`. The seams between them
/// belong to the faces. A core without extent along an axis has faces without area: the solid is round there.
///
/// # Surface coordinates
///
/// On the faces those of the cuboid around it; on edges and corners those of its faces at the sides, of which each has
/// what lies before it, up to the middle of the edges between them. There `v` is the height, and `u` is that of the
/// outline, a rectangle with round corners.
///
/// ```
/// use raylet::{Part, Ray, RoundedCuboid, UnitVec3, Vec3};
/// let soap = RoundedCuboid::new(2.0_f32, 0.5, 1.0, 0.25)?;
/// let ray = Ray::new(Vec3::new(1.5, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits: Vec<_> = soap.hits(&ray).iter().map(|hit| (hit.t, hit.part)).collect();
/// assert_eq!(hits, [(4.25, Part::Top), (5.75, Part::Base)]);
/// // Beside the core: an edge above, an edge below.
/// let ray = Ray::new(Vec3::new(2.15, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits: Vec<_> = soap.hits(&ray).iter().map(|hit| (hit.t, hit.part)).collect();
/// assert_eq!(hits, [(4.3, Part::Side), (5.7, Part::Side)]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundedCuboid<S> {
    /// The half extents of the core.
    pub(super) half: [S; 3],
    pub(super) radius: S,
}

impl<S: Scalar> RoundedCuboid<S> {
    /// All points within `radius` of the cuboid with these half extents along x, y and z, which may be zero.
    ///
    /// # Errors
    ///
    /// [`SizeError::HalfExtent`] if a half extent is negative or not finite, or, with the radius added, beyond the
    /// budget; [`SizeError::Radius`] if the radius is not positive, not finite or beyond the budget.
    pub fn new(half_x: S, half_y: S, half_z: S, radius: S) -> Result<Self, SizeError> {
        let radius = checked_size(radius, SizeError::Radius)?;
        let checked = |half: S| {
            let half = checked_size_or_zero(half, SizeError::HalfExtent)?;
            checked_size(half.plus(radius), SizeError::HalfExtent)?;
            Ok(half)
        };
        Ok(Self { half: [checked(half_x)?, checked(half_y)?, checked(half_z)?], radius })
    }

    /// The rounded cuboid with the outermost points at these half extents, edges of this radius included: those of the
    /// core are smaller by the radius, rounded.
    ///
    /// # Errors
    ///
    /// [`SizeError`] as for [`RoundedCuboid::new`]; a half extent of the core is negative if one of these is less than
    /// the radius.
    ///
    /// ```
    /// use raylet::RoundedCuboid;
    /// assert_eq!(RoundedCuboid::within(2.0_f32, 1.0, 1.0, 0.25)?, RoundedCuboid::new(1.75, 0.75, 0.75, 0.25)?);
    /// let error = RoundedCuboid::within(2.0_f32, 1.0, 0.125, 0.25).unwrap_err();
    /// assert_eq!(error.to_string(), "a half extent is negative");
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn within(half_x: S, half_y: S, half_z: S, radius: S) -> Result<Self, SizeError> {
        let radius = checked_size(radius, SizeError::Radius)?;
        Self::new(half_x.minus(radius), half_y.minus(radius), half_z.minus(radius), radius)
    }

    /// The half extents of the core along x, y and z.
    pub const fn half_extents(&self) -> [S; 3] {
        self.half
    }

    /// The radius of edges and corners.
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// The smallest cuboid around it, rounded.
    fn around(&self) -> Cuboid<S> {
        Cuboid { half: self.half.map(|half| half.plus(self.radius)) }
    }

    /// The end of the line's interval, the first or the second, for that in the cuboid around it: the same over a face,
    /// and otherwise the end in the cylinder about the edge or the ball about the corner there, if it is beside that.
    fn end_on_grid<T: Guards>(&self, line: &LocalLine<S>, outer: End<S>, leaves: bool) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        let region = found!(line.region(outer.t, self.half));
        if axis_of_face(region).is_some() {
            return Attempt::Hit(outer);
        }
        let [hx, hy, hz] = self.half;
        let from = |side: Ordering, half: S, c: S| match side {
            Ordering::Less => line.relative_to(-half, c),
            Ordering::Equal => Attempt::Hit(c),
            Ordering::Greater => line.relative_to(half, c),
        };
        let ([x, y, z], [side_x, side_y, side_z]) = (line.origin, region);
        let origin = [found!(from(side_x, hx, x)), found!(from(side_y, hy, y)), found!(from(side_z, hz, z))];
        let beside = LocalLine { origin, ..*line };
        // A miss may meet another edge or corner.
        let ends = match region.into_iter().position(|side| side == Ordering::Equal) {
            Some(axis) => match beside.about(axis).cylinder(self.radius) {
                Attempt::Hit(inside) => inside.ends,
                _ => return Attempt::Unsure,
            },
            None => match beside.ball(self.radius, T::GUARDED, T::STRICT) {
                Attempt::Hit(ends) => ends,
                _ => return Attempt::Unsure,
            },
        };
        let [enter, exit] = ends;
        // Next to a tangent the rounding of a framed origin would become more than a tenth of a unit.
        if T::STRICT && exit.minus(enter) < self.radius.scaled(-1) {
            return Attempt::Unsure;
        }
        let t = if leaves { exit } else { enter };
        match line.region(t, self.half) {
            Attempt::Hit(own) if own == region => Attempt::Hit(End::new(t, Part::Side)),
            _ => Attempt::Unsure,
        }
    }

    /// The point of the core that is nearest to a point.
    fn nearest_of_core(&self, point: Vec3<S>) -> Vec3<S> {
        pairs(point.to_array(), self.half).map(|(c, half)| coordinates::clamped(c, half)).into()
    }

    /// The horizontal part of the way from the core to a point of an edge or a corner. Where rounding has put the point
    /// over the face above or below, it is that to the nearest edge.
    fn across(&self, point: Vec3<S>) -> Vec3<S> {
        let Vec3 { x, z, .. } = point - self.nearest_of_core(point);
        if x != S::ZERO || z != S::ZERO {
            return Vec3::new(x, S::ZERO, z);
        }
        let [half_x, _, half_z] = self.half;
        let towards = |c: S| if c < S::ZERO { -self.radius } else { self.radius };
        if half_x.minus(point.x.magnitude()) <= half_z.minus(point.z.magnitude()) {
            Vec3::new(towards(point.x), S::ZERO, S::ZERO)
        } else {
            Vec3::new(S::ZERO, S::ZERO, towards(point.z))
        }
    }

    /// A point on an edge or a corner that is near: the point itself, or, if it is over a face, moved across the
    /// nearest edge of that.
    fn beside_the_faces(&self, point: Vec3<S>) -> Vec3<S> {
        let point = point.to_array();
        let gaps @ [x, y, z] = pairs(point, self.half).map(|(c, half)| half.minus(c.magnitude()));
        if gaps.into_iter().filter(|gap| *gap < S::ZERO).count() >= 2 {
            return point.into();
        }
        // The axis of the face, and the other one along which the nearest edge lies across.
        let face = if x <= y && x <= z {
            0
        } else if y <= z {
            1
        } else {
            2
        };
        let [a, b] = [(face + 1) % 3, (face + 2) % 3];
        let across = if component(gaps, a) <= component(gaps, b) { a } else { b };
        let to = |axis: usize, size: S| if component(point, axis) < S::ZERO { -size } else { size };
        let moved = with_component(point, across, to(across, component(self.half, across)));
        // That of the face gives the direction from the core.
        if component(gaps, face) < S::ZERO {
            return moved.into();
        }
        with_component(moved, face, to(face, component(self.half, face).plus(self.radius))).into()
    }
}

impl<S: Copy> RoundedCuboid<S> {
    /// The rounded cuboid with `f` applied to its sizes.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> RoundedCuboid<R> {
        RoundedCuboid { half: self.half.map(&f), radius: f(self.radius) }
    }
}

impl<S> Described for RoundedCuboid<S> {
    const EQUATIONS: EquationKinds = EquationKinds::ROUNDED_CUBOID;
}

impl<S: Scalar> Geometry<S> for RoundedCuboid<S> {
    type In<R: Scalar> = RoundedCuboid<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }

    /// The sum of the half extents and the radius, which is no less than the distance of a corner.
    fn largest_coordinate(&self) -> S {
        let [x, y, z] = self.half;
        x.plus(y).plus(z).plus(self.radius)
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|size| size.scaled(e))
    }

    /// By the face, the edge or the corner beside which the line enters and leaves the cuboid around it: that of most
    /// rays. The robust number computes the others.
    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let around = found!(self.around().meets_on_grid::<T>(line));
        let (Intersection::Entered(enter) | Intersection::One(Span { enter, .. })) = around else {
            return Attempt::Unsure;
        };
        let enter = found!(self.end_on_grid::<T>(line, enter, false));
        let Intersection::One(Span { exit, .. }) = around else { return Attempt::Hit(Intersection::Entered(enter)) };
        if line.needs_only(enter.t) {
            return Attempt::Hit(Intersection::Entered(enter));
        }
        match self.end_on_grid::<T>(line, exit, true) {
            Attempt::Hit(exit) if enter.t <= exit.t => Attempt::Hit(Intersection::One(Span::new(enter, exit))),
            // The exit is uncertain, or rounding put it before the entry.
            _ => Attempt::Hit(Intersection::Entered(enter)),
        }
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        // The start is in the plane of its face, whatever its coordinate: the grid takes that as it is.
        let around = self.around();
        let starts_in =
            |axis: usize, side: Ordering, plane: S| face_of(axis, side) == from && line.starts_at(axis, plane);
        let is_start = pairs([0, 1, 2], around.half)
            .into_iter()
            .any(|(axis, half)| starts_in(axis, Ordering::Less, -half) || starts_in(axis, Ordering::Greater, half));
        if !is_start {
            return Attempt::Unsure;
        }
        let exit = found!(around.exit_on_grid::<T>(line, from));
        // Nor does it compute the edges of that face.
        let region = found!(line.region(exit.t, self.half));
        let is_beside_start = (0..3).any(|axis| {
            let side = component(region, axis);
            side != Ordering::Equal && face_of(axis, side) == from
        });
        if is_beside_start { Attempt::Unsure } else { self.end_on_grid::<T>(line, exit, true) }
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::rounded_cuboid(ray, self.half, self.radius, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::RoundedCuboid { half: self.half, radius: self.radius, region: [Ordering::Equal; 3] }
    }

    fn hull(&self) -> Hull<S> {
        Hull::RoundedCuboid(self.half, self.radius)
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        if part == Part::Side {
            let point = self.beside_the_faces(point);
            let along = self.normal(point, part).to_array().map(|component| self.radius.along(component));
            return self.nearest_of_core(point) + Vec3::from(along);
        }
        // On the face of the cuboid around it, over the core.
        self.around().on_surface(self.nearest_of_core(point), part)
    }

    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        if part != Part::Side {
            return self.around().normal(point, part);
        }
        let excess = point - self.nearest_of_core(point);
        UnitVec3::new(excess).unwrap_or_else(|_| coordinates::outwards(self.across(point)))
    }

    fn bend(&self, _: Vec3<S>, part: Part) -> S {
        if part == Part::Side { self.radius } else { S::INFINITY }
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        if part != Part::Side {
            return self.around().uv(point, part);
        }
        // Of the face at the side whose outline, a rectangle with round corners, passes below or above.
        let core = self.nearest_of_core(point);
        let outwards = coordinates::outwards(self.across(point));
        let (x, z) = (outwards.x(), outwards.z());
        let [real_x, real_z] = [x, z].map(S::unit_real);
        let (axis, along) = if real_x.abs() >= real_z.abs() { (0, real_x) } else { (2, real_z) };
        let face = face_of(axis, if along.is_negative() { Ordering::Less } else { Ordering::Greater });
        let outline = Vec3::new(core.x.plus(self.radius.along(x)), point.y, core.z.plus(self.radius.along(z)));
        self.around().uv(outline, face)
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        if part != Part::Side {
            return self.around().tangents(point, part);
        }
        coordinates::tangents_around(self.across(point), self.normal(point, part))
    }
}

queries!(RoundedCuboid);
