//! A solid as all points within a radius of a simple set, its core.

use super::{ThickError, is_rounding};
use crate::frame::Frame;
use crate::geometry::Geometry;
use crate::number::{cross, difference, dot};
use crate::part::Part;
use crate::primitive::Triangle;
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar, largest};
use crate::shape::kinds::Primitives;
use crate::shape::{Placement, Primitive, Shape};
use crate::vector::{UnitVec3, Vec3, pairs};

/// The core of a solid, in its frame.
#[derive(Clone, Copy, Debug)]
pub(super) enum Set<'a, S> {
    /// The segment from the origin to this height; of a sphere the origin.
    Segment(S),
    /// The plane `y = 0`.
    Plane,
    /// The cuboid of these half extents about the origin, which may be zero; of a rectangle that along y is.
    Cuboid([S; 3]),
    /// This triangle.
    Triangle(&'a Triangle<S>),
}

/// A placed core, and how far its solid reaches beyond it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Core<'a, S: Scalar> {
    pub(super) set: Set<'a, S>,
    pub(super) radius: S,
    pub(super) frame: Option<&'a Frame<S>>,
}

impl<'a, S: Scalar> Core<'a, S> {
    pub(super) fn of<K: Primitives>(shape: &'a Shape<S, K>) -> Result<Self, ThickError> {
        let frame = match shape.placement() {
            Placement::World => None,
            Placement::Frame(frame) => Some(frame),
            Placement::Affine(_) => return Err(ThickError::Affine),
        };
        let (set, radius) = match shape.primitive() {
            Primitive::Sphere(sphere) => (Set::Segment(S::ZERO), sphere.radius()),
            Primitive::Capsule(capsule) => (Set::Segment(capsule.height()), capsule.radius()),
            Primitive::Plane(_) => (Set::Plane, S::ZERO),
            Primitive::Cuboid(cuboid) => (Set::Cuboid(cuboid.half_extents()), S::ZERO),
            Primitive::RoundedCuboid(cuboid) => (Set::Cuboid(cuboid.half_extents()), cuboid.radius()),
            Primitive::Rectangle(rectangle) => {
                let [x, z] = rectangle.half_extents();
                (Set::Cuboid([x, S::ZERO, z]), S::ZERO)
            }
            Primitive::Triangle(triangle) => (Set::Triangle(triangle), S::ZERO),
            other => return Err(ThickError::Primitive(other.kind())),
        };
        Ok(Self { set, radius, frame })
    }

    /// At least the distance of any point of the core from the frame's origin.
    fn extent(&self) -> S {
        match self.set {
            Set::Segment(height) => height,
            Set::Plane => S::INFINITY,
            Set::Cuboid([x, y, z]) => x.plus(y).plus(z),
            Set::Triangle(triangle) => triangle.largest_coordinate().plus(triangle.largest_coordinate()),
        }
    }

    fn position(&self) -> Vec3<S> {
        self.frame.map_or(Vec3::ZERO, Frame::position)
    }

    /// The largest magnitude of the numbers that a ball with this centre is computed from.
    pub(super) fn reach(&self, centre: Vec3<S>) -> S {
        let size = if let Set::Plane = self.set { S::ZERO } else { self.extent() };
        largest([largest(centre.to_array()), largest(self.position().to_array()), size, self.radius])
    }

    /// True if a ball at `t` is certainly apart from the solid. It costs a few comparisons, and is true for most balls.
    pub(super) fn is_apart(&self, ray: &Ray<S>, t: S, radius: S) -> bool {
        let centre = if t == S::ZERO { ray.origin() } else { ray.at(t) };
        let within = self.extent().plus(self.radius).plus(radius);
        let from = pairs(centre.to_array(), self.position().to_array()).map(|(c, p)| c.minus(p));
        let gap = largest(from).minus(within);
        within.is_finite() && gap > within.scaled(-3) && !is_rounding(gap, self.reach(centre))
    }

    /// The ray's point at `t` in the frame. That of a ball needs no rotation.
    pub(super) fn local(&self, ray: &Ray<S>, t: S) -> Vec3<S> {
        match (self.frame, self.set) {
            (None, _) => ray.at(t),
            (Some(frame), Set::Segment(height)) if height == S::ZERO => {
                S::approach(ray.origin().to_array(), frame.position().to_array(), ray.direction().to_array(), t).into()
            }
            (Some(frame), _) => frame.ray_point_to_local(ray, t),
        }
    }

    /// From the nearest point of the core to the ray's point at `t`.
    pub(super) fn offset(&self, ray: &Ray<S>, t: S) -> Offset<S> {
        let local = self.local(ray, t);
        let Vec3 { x, y, z } = local;
        let offset = match self.set {
            Set::Segment(height) => Vec3 { y: beyond(y, S::ZERO, height), ..local },
            Set::Plane => Vec3::new(S::ZERO, y, S::ZERO),
            Set::Cuboid([hx, hy, hz]) => Vec3::new(beyond(x, -hx, hx), beyond(y, -hy, hy), beyond(z, -hz, hz)),
            Set::Triangle(triangle) => Vec3::round(from_triangle::<S>(local.real(), triangle)),
        };
        let is_ball = matches!(self.set, Set::Segment(height) if height == S::ZERO);
        let frame = if is_ball { None } else { self.frame };
        // Along an axis it needs no root, and the axis is the direction to the bit.
        let axes = frame.map_or([UnitVec3::X, UnitVec3::Y, UnitVec3::Z], Frame::axes);
        let mut along = pairs(offset.to_array(), axes).into_iter().filter(|(length, _)| *length != S::ZERO);
        match (along.next(), along.next()) {
            (None, _) => Offset { length: S::ZERO, direction: None },
            (Some((length, axis)), None) => {
                let axis = if length < S::ZERO { -axis } else { axis };
                Offset { length: length.magnitude(), direction: Some(axis) }
            }
            _ => {
                let direction = UnitVec3::new(offset).ok();
                let to_world = |direction| frame.map_or(direction, |frame| frame.direction_to_world(direction));
                Offset { length: offset.length(), direction: direction.map(to_world) }
            }
        }
    }

    /// The normal of a ball whose centre is in the core: of the directions in which the solid is left the soonest, one
    /// that leads most along `along`.
    pub(super) fn outwards(&self, along: UnitVec3<S>) -> UnitVec3<S> {
        let [x, y, z] = self.frame.map_or(along.real(), |frame| rotated(frame, along.real()));
        let zero = S::Real::ZERO;
        let towards = |normal: UnitVec3<S>, cosine: S::Real| if cosine.is_negative() { -normal } else { normal };
        let local = match self.set {
            Set::Segment(height) if height != S::ZERO => UnitVec3::from_real([x, zero, z]).unwrap_or(UnitVec3::X),
            Set::Segment(_) => return along,
            Set::Plane => towards(UnitVec3::Y, y),
            // Along the axes along which it has no extent.
            Set::Cuboid(half) => {
                let axes = pairs(half, pairs([UnitVec3::X, UnitVec3::Y, UnitVec3::Z], [x, y, z]));
                let mut thin = axes.into_iter().filter(|(half, _)| *half == S::ZERO).map(|(_, of_axis)| of_axis);
                match (thin.next(), thin.next()) {
                    (None, _) => return along,
                    (Some((axis, cosine)), None) => towards(axis, cosine),
                    (Some((axis, _)), _) => {
                        let across = pairs(half, [x, y, z]).map(|(half, c)| if half == S::ZERO { c } else { zero });
                        UnitVec3::from_real(across).unwrap_or(axis)
                    }
                }
            }
            Set::Triangle(triangle) => {
                let normal = triangle.normal(Vec3::ZERO, Part::Side);
                towards(normal, dot(normal.real(), [x, y, z]))
            }
        };
        self.frame.map_or(local, |frame| frame.direction_to_world(local))
    }
}

/// A vector of the world: its length and its direction, if it has one.
pub(super) struct Offset<S: Scalar> {
    pub(super) length: S,
    pub(super) direction: Option<UnitVec3<S>>,
}

/// A vector of the world in the frame.
fn rotated<S: Scalar>(frame: &Frame<S>, vector: [S::Real; 3]) -> [S::Real; 3] {
    frame.axes().map(|axis| dot(axis.real(), vector))
}

/// How far a value lies beyond the nearer of two bounds; zero between them.
fn beyond<S: Scalar>(value: S, low: S, high: S) -> S {
    if value < low {
        value.minus(low)
    } else if value > high {
        value.minus(high)
    } else {
        S::ZERO
    }
}

/// The vector to `p` from the point of a triangle that is nearest to it: from its projection, if that lies within all
/// three edges; otherwise from the nearest of the edges' nearest points.
fn from_triangle<S: Scalar>(p: [S::Real; 3], triangle: &Triangle<S>) -> [S::Real; 3] {
    // Scaled to near 1, so that no product overflows.
    let e = S::binary_exponent(triangle.largest_coordinate());
    let [a, b, c] = triangle.vertices().map(|vertex| vertex.real().map(|component| component.scaled(-e)));
    let p = p.map(|component| component.scaled(-e));
    let edges = [(a, b), (b, c), (c, a)];
    let n = cross(difference(b, a), difference(c, a));
    let is_within = |(from, to): ([S::Real; 3], [S::Real; 3])| {
        !dot(cross(n, difference(to, from)), difference(p, from)).is_negative()
    };
    if edges.into_iter().all(is_within) {
        let height = dot(n, difference(p, a)) / dot(n, n);
        return n.map(|component| (component * height).scaled(e));
    }
    let mut nearest: Option<(S::Real, [S::Real; 3])> = None;
    for (from, to) in edges {
        let (along, beside) = (difference(to, from), difference(p, from));
        let share = dot(beside, along) / dot(along, along);
        let (zero, one) = (S::Real::ZERO, S::Real::ONE);
        let share = if share < zero {
            zero
        } else if share > one {
            one
        } else {
            share
        };
        let offset = pairs(beside, along).map(|(beside, along)| beside - along * share);
        let square = dot(offset, offset);
        if nearest.is_none_or(|(least, _)| square < least) {
            nearest = Some((square, offset));
        }
    }
    nearest.map_or(difference(p, a), |(_, offset)| offset).map(|component| component.scaled(e))
}
