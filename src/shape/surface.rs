//! The surface at a hit: point, normal, surface coordinates, tangents.
//!
//! Each is computed from the rounded `t` where that is accurate enough; if not, from a corrected `t` (`corrected`), or
//! in the robust number (`exact`).

mod corrected;
mod exact;

use super::combined::Combined;
use super::kinds::{All, Combining, Kind, Kinds, Primitives};
use super::primitive::Member;
use super::{Placement, Shape};
use crate::affine::Affine;
use crate::equations::{Described, EquationKinds, Equations};
use crate::frame::Frame;
use crate::geometry::Geometry;
use crate::hit::{Crossing, Hit};
use crate::ladder;
use crate::primitive::surface_coordinates as coordinates;
use crate::query;
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::{Real, Ring, Scalar, largest};
use crate::solve::{self, Line};
use crate::vector::{UnitVec3, Vec3, pairs};
use corrected::Correction;

/// The surface of a shape at a hit. Its methods compute point, normal, surface coordinates and tangents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<S: Scalar, K: Kinds = All> {
    shape: Shape<S, K>,
    ray: Ray<S>,
    hit: Hit<S>,
    leaf: LeafOf<S, K>,
}

/// What is known of the leaf of a combination; nothing of a primitive.
type LeafOf<S, K> = <<K as Kinds>::Combined<S> as Combined<S>>::Leaf;

impl<S: Scalar, L: Primitives> Surface<S, Combining<'_, L>> {
    /// The index of the leaf that the hit is on; `None` if the shape is a primitive.
    ///
    /// ```
    /// use raylet::{Combination, Cuboid, Ray, Shape, Sphere, UnitVec3, Vec3};
    /// let leaves = [Shape::new(Cuboid::new(1.0_f32, 1.0, 1.0)?), Shape::new(Sphere::new(1.25)?)];
    /// let corners = Combination::difference(&leaves)?;
    /// let shape = corners.shape();
    /// let ray = Ray::new(Vec3::new(-5.0, 0.875, 0.875), UnitVec3::X)?;
    /// let leaf_of = |hit| shape.surface(&ray, &hit).leaf();
    /// // In at the face, out into the ball, in again out of the ball, out at the face.
    /// let leaves: Vec<_> = shape.hits(&ray).into_iter().map(leaf_of).collect();
    /// assert_eq!(leaves, [Some(0), Some(1), Some(1), Some(0)]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn leaf(&self) -> Option<u32> {
        self.leaf.map(|leaf| leaf.index)
    }
}

impl<S: Scalar, K: Kinds> Surface<S, K> {
    #[inline]
    pub(super) const fn new(shape: &Shape<S, K>, ray: &Ray<S>, hit: &Hit<S>, leaf: LeafOf<S, K>) -> Self {
        Self { shape: *shape, ray: *ray, hit: *hit, leaf }
    }

    /// The point in the primitive's own coordinates, on its surface. It is accurate however far away the ray starts.
    pub fn local_point(&self) -> Vec3<S> {
        self.local_point_near(self.rough_local_point())
    }

    fn local_point_near(&self, mut rough: Vec3<S>) -> Vec3<S> {
        if !self.is_resolved(rough) {
            let Some(correction) = self.correction(rough) else { return self.exact_local_point() };
            rough = Vec3::round(correction.local_point());
            if let Some(frame) = self.frame_of_a_ball() {
                rough = frame.vector_to_local(rough);
            }
        }
        self.on_surface(rough)
    }

    fn on_surface(&self, point: Vec3<S>) -> Vec3<S> {
        let (primitive, point, exponent) = query::near_one(&self.shape.member, point);
        query::scaled(primitive.on_surface(point, self.hit.part), exponent)
    }

    /// The point in the world, as close to the surface as the number type allows.
    pub fn point(&self) -> Vec3<S> {
        let rough = self.rough_local_point();
        let resolved = self.is_resolved(rough).then(|| match &self.shape.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => {
                frame.point_to_world(self.local_point_near(rough))
            }
            _ => self.local_point_near(rough),
        });
        // Close to the world's origin floats have smaller units than close to the primitive's origin, and than `t`.
        let is_fine = |point: &Vec3<S>| {
            if !S::RELATIVE {
                return !self.is_far_from_frame(rough);
            }
            let size = largest([point.x, point.y, point.z]);
            [self.hit.t, largest([rough.x, rough.y, rough.z])].into_iter().all(|c| S::resolves(c.plus(c), size))
        };
        let point = if let Some(point) = resolved.filter(is_fine) {
            point
        } else if let Some(Correction { step, .. }) = self.correction(rough) {
            let (one, t) = (S::Real::ONE, self.hit.t.real());
            let along = |(o, d)| S::Real::sum_of_products([[o, one], [t, d], [step, d]]);
            Vec3::round(pairs(self.ray.origin().real(), self.ray.direction().real()).map(along))
        } else {
            return self.exact_point();
        };
        // At the end of the float range the image of a local point may overflow where the ray's own point does not.
        if point.to_array().iter().all(|c| c.is_finite()) { point } else { self.exact_point() }
    }

    /// The point and the normal in the world as the rounded `t` gives them, for pictures of the tiers `Plain` and
    /// `Fast`: the point is off by as much as `t`, and the normal by that over the surface's radius of curvature.
    pub(crate) fn rough(&self) -> (Vec3<S>, UnitVec3<S>) {
        let point = self.ray.at(self.hit.t);
        let normal = if self.is_flat() {
            self.shape.member.normal(Vec3::ZERO, self.hit.part)
        } else {
            let is_placed = !matches!(self.shape.placement, Placement::World);
            self.rounded_local_normal(if is_placed { self.rough_local_point() } else { point })
        };
        let normal = match &self.shape.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => frame.direction_roughly_to_world(normal),
            _ => self.local_normal_to_world(normal),
        };
        let is_turned = <K::Combined<S> as Combined<S>>::is_turned(self.leaf);
        (point, if is_turned { -normal } else { normal })
    }

    /// True if a point of the frame in the world may be off by more than a part of a unit, since the axes are unit and
    /// perpendicular only to their last bits; for fixed point, whose largest coordinates have more bits than the axes.
    fn is_far_from_frame(&self, local: Vec3<S>) -> bool {
        match self.shape.placement {
            Placement::Frame(_) if K::SET.contains(Kind::Frame) => {
                largest([local.x, local.y, local.z]) > S::BUDGET.coordinate.scaled(-3)
            }
            _ => false,
        }
    }

    /// The outward unit normal in the world. For an open surface it points away from the axis, for a flat one to the
    /// front. That of a combination points out of the result: where a leaf is subtracted, into the leaf.
    pub fn normal(&self) -> UnitVec3<S> {
        if <K::Combined<S> as Combined<S>>::is_turned(self.leaf) { -self.own_normal() } else { self.own_normal() }
    }

    /// The outward normal of the primitive.
    fn own_normal(&self) -> UnitVec3<S> {
        let rough = self.rough_local_point();
        if self.needs_exact_normal(rough)
            && let Some(normal) = self.corrected_normal(rough).or_else(|| self.exact_normal())
        {
            return normal;
        }
        self.local_normal_to_world(self.rounded_local_normal(rough))
    }

    /// True if the rounding of `t` may rotate the normal by more than a few units in the last place.
    fn needs_exact_normal(&self, rough: Vec3<S>) -> bool {
        let bend = self.bend(rough);
        self.is_stretched() || !S::resolves_turn(self.hit.t, bend) || !self.is_turned_finely(rough, bend)
    }

    /// False if a rotation spreads the rounding error of a large coordinate to smaller ones, so that the surface curves
    /// more than these resolve; or if the core of a rounded cuboid takes the leading digits of its coordinates.
    fn is_turned_finely(&self, local: Vec3<S>, bend: S) -> bool {
        let is_turned = matches!(self.shape.placement, Placement::Frame(_) if K::SET.contains(Kind::Frame));
        if S::RELATIVE && (is_turned || self.is_about_a_core()) {
            return S::resolves(largest([local.x, local.y, local.z]), bend);
        }
        true
    }

    /// True if the primitive is a rounded cuboid or a torus: all points within a radius of what may be much larger.
    fn is_about_a_core(&self) -> bool {
        Member::<S, K>::EQUATIONS.has(EquationKinds::ROUNDED_CUBOID.and(EquationKinds::TORUS))
            && matches!(self.shape.member.equations(), Equations::RoundedCuboid { .. } | Equations::Torus { .. })
    }

    /// True if the placement changes lengths, and with them the rounding error of `t`.
    const fn is_stretched(&self) -> bool {
        self.affine().is_some()
    }

    const fn affine(&self) -> Option<&Affine<S>> {
        match &self.shape.placement {
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => Some(affine),
            _ => None,
        }
    }

    fn rounded_local_normal(&self, rough: Vec3<S>) -> UnitVec3<S> {
        let (primitive, point, _) = query::near_one(&self.shape.member, rough);
        primitive.normal(point, self.hit.part)
    }

    fn local_normal_to_world(&self, normal: UnitVec3<S>) -> UnitVec3<S> {
        match &self.shape.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => frame.direction_to_world(normal),
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => affine.normal_to_world(normal),
            _ => normal,
        }
    }

    /// True if the rounding error of `t` is small relative to the hit's local coordinates and the surface's radius of
    /// curvature.
    #[inline(always)]
    fn is_resolved(&self, local: Vec3<S>) -> bool {
        let (size, bend) = (largest([local.x, local.y, local.z]), self.bend(local));
        let resolves = |size: S| S::resolves(self.hit.t, size);
        let is_known = !self.is_stretched() && is_finite(local) && resolves(size) && resolves(bend);
        is_known && self.is_turned_finely(local, bend)
    }

    /// The point in the primitive's coordinates, from the rounded `t` alone.
    fn rough_local_point(&self) -> Vec3<S> {
        match &self.shape.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => frame.ray_point_to_local(&self.ray, self.hit.t),
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => {
                affine.ray_point_to_local(&self.ray, self.hit.t)
            }
            _ => self.ray.at(self.hit.t),
        }
    }

    /// The surface's radius of curvature at a local point, infinite where it is flat; zero if the surface is curved and
    /// the point beyond the number type.
    fn bend(&self, point: Vec3<S>) -> S {
        let is_known = is_finite(point) || self.is_flat();
        if is_known { self.shape.member.bend(point, self.hit.part) } else { S::ZERO }
    }

    /// True if the part is flat, so that its normal and its tangents are the same everywhere.
    fn is_flat(&self) -> bool {
        !self.shape.member.bend(Vec3::ZERO, self.hit.part).is_finite()
    }

    /// The frame, if the primitive is a sphere. Its line is then only translated, not rotated, so that local results
    /// are along world axes.
    fn frame_of_a_ball(&self) -> Option<&Frame<S>> {
        match &self.shape.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) && self.is_ball() => Some(frame),
            _ => None,
        }
    }

    /// The equation of the part's surface along a line in the primitive's frame, in these numbers.
    #[inline(always)]
    fn equation<N: Ring>(
        &self,
        equations: &Equations<S>,
        line: &Line<N>,
        number: impl Fn(S) -> N + Copy,
    ) -> solve::Surface<N> {
        solve::surface_of::<S, N, Member<S, K>>(equations, self.hit.part, line, number)
    }

    fn is_ball(&self) -> bool {
        ladder::is_ball::<S, Member<S, K>>(&self.shape.member.equations())
    }

    /// The normal on the side that the ray comes from; the outward normal if the ray only touches.
    pub fn normal_towards_ray(&self) -> UnitVec3<S> {
        let normal = self.normal();
        let facing = self.ray.direction().dot(normal);
        let from_inside = self.hit.crossing != Crossing::Touch && facing > S::Real::ZERO;
        if from_inside { -normal } else { normal }
    }

    /// The cosine of incidence: of the angle between the normal and the ray's way back, from 0 where it grazes to 1
    /// where it meets the surface straight on.
    ///
    /// ```
    /// use raylet::{Plane, Ray, Shape, UnitVec3, Vec3};
    /// let floor = Shape::new(Plane::new());
    /// let ray = Ray::new(Vec3::new(0.0_f32, 3.0, 0.0), UnitVec3::new(Vec3::new(4.0, -3.0, 0.0))?)?;
    /// let hit = floor.nearest(&ray).expect("it looks down");
    /// assert_eq!(floor.surface(&ray, &hit).cosine(), 0.6);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn cosine(&self) -> S {
        S::round(self.ray.direction().dot(self.normal()).abs())
    }

    /// Surface coordinates, each in `[0, 1]`: see [`crate::primitive`].
    pub fn uv(&self) -> (S::Unit, S::Unit) {
        let rough = self.rough_local_point();
        let point = if is_finite(rough) { self.local_point_near(rough) } else { self.coordinates_beyond().0 };
        self.shape.member.uv(point, self.hit.part)
    }

    /// Solid coordinates: where the hit lies in the primitive's bounding box along its x, y and z axes, each in
    /// `[0, 1]`. They belong to points of space, not of the surface, so that a texture over them continues across edges
    /// and rims, as if the solid were carved from it.
    ///
    /// Along an axis on which the primitive is infinite, they repeat every unit of length; where the box is flat they
    /// are zero. (Peachey, *Solid Texturing of Complex Surfaces*, 1985.)
    ///
    /// ```
    /// use raylet::{Cylinder, Ray, Shape, UnitVec3, Vec3};
    /// let can = Shape::new(Cylinder::capped(2.0_f32, 4.0)?);
    /// let ray = Ray::new(Vec3::new(9.0, 1.0, 0.0), -UnitVec3::X)?;
    /// let hit = can.nearest(&ray).expect("it is met");
    /// assert_eq!(can.surface(&ray, &hit).uvw(), [1.0, 0.25, 0.5]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn uvw(&self) -> [S::Unit; 3] {
        let extents = self.shape.member.hull().extents();
        let rough = self.rough_local_point();
        let point =
            if is_finite(rough) { self.local_point_near(rough).to_array() } else { self.coordinates_beyond().1 };
        pairs(point, extents).map(|(c, [low, high])| {
            if !(low.is_finite() && high.is_finite()) {
                return coordinates::repeating(c);
            }
            // Halves: twice the largest size overflows.
            let [c, low, high] = [c, low, high].map(|length| length.real().scaled(-1));
            coordinates::fraction::<S>(c - low, high - low)
        })
    }

    /// The unit directions in the world in which `u` and `v` grow.
    pub fn tangents(&self) -> (UnitVec3<S>, UnitVec3<S>) {
        let rough = self.rough_local_point();
        let (primitive, point, _) = query::near_one(&self.shape.member, rough);
        let mut tangents = primitive.tangents(point, self.hit.part);
        if !self.is_flat()
            && self.needs_exact_normal(rough)
            && let Some(normal) = self.corrected_local_normal(rough).or_else(|| self.exact_local_normal())
        {
            let is_torus = Member::<S, K>::EQUATIONS.has(EquationKinds::TORUS)
                && matches!(self.shape.member.equations(), Equations::Torus { .. });
            tangents = if is_torus { along_a_torus(normal, tangents.0) } else { along_the_surface(normal) };
        }
        let (u, v) = tangents;
        match &self.shape.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => {
                (frame.direction_to_world(u), frame.direction_to_world(v))
            }
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => {
                (affine.tangent_to_world(u), affine.tangent_to_world(v))
            }
            _ => (u, v),
        }
    }

    /// The departure of a ray that leaves from here; `object` is the shape's index in its scene.
    pub const fn departure(&self, object: u32, leaving: Leaving) -> Departure {
        Departure { object, part: self.hit.part, leaving }
    }
}

/// The tangents around the axis and up, on a surface of revolution about the y axis with this outward normal, which
/// leads away from the axis.
fn along_the_surface<S: Scalar>(normal: UnitVec3<S>) -> (UnitVec3<S>, UnitVec3<S>) {
    let [x, _, z] = normal.real();
    let u = UnitVec3::from_real([z, S::Real::ZERO, -x]).unwrap_or(-UnitVec3::Z);
    (u, across(normal, u).unwrap_or(UnitVec3::Y))
}

/// The same on a torus, whose normal leads to the axis on its inner side and along it on top. The first is nearly
/// `around`.
fn along_a_torus<S: Scalar>(normal: UnitVec3<S>, around: UnitVec3<S>) -> (UnitVec3<S>, UnitVec3<S>) {
    let [x, _, z] = normal.real();
    if S::Real::sum_of_products([[x, x], [z, z]]).scaled(6) < S::Real::ONE {
        // The horizontal part is too short to tell the direction.
        let v = across(normal, around).unwrap_or(UnitVec3::Y);
        return (across(v, normal).unwrap_or(around), v);
    }
    let (u, v) = along_the_surface(normal);
    if u.dot(around).is_negative() { (-u, -v) } else { (u, v) }
}

/// The direction perpendicular to both.
fn across<S: Scalar>(a: UnitVec3<S>, b: UnitVec3<S>) -> Option<UnitVec3<S>> {
    UnitVec3::from_real(a.cross(b))
}

fn is_finite<S: Scalar>(point: Vec3<S>) -> bool {
    point.x.is_finite() && point.y.is_finite() && point.z.is_finite()
}
