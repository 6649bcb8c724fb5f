//! Where a ray from outside enters a grown core.

use super::set::{Core, Set};
use super::{ThickError, is_rounding};
use crate::frame::Frame;
use crate::geometry::Geometry;
use crate::hit::{Crossing, Hit};
use crate::part::Part;
use crate::primitive::{Capsule, Plane, RoundedCuboid, Sphere, Triangle};
use crate::ray::{Range, Ray};
use crate::scalar::{Real, Scalar};
use crate::shape::{Primitive, Shape};
use crate::tier::Tier;
use crate::vector::Vec3;

/// The `t` at which a ray enters the core grown by the core's own radius and `radius`. Where its range begins, it is
/// outside.
pub(super) fn entry<S: Scalar, T: Tier<S>>(
    core: &Core<'_, S>,
    ray: &Ray<S>,
    radius: S,
) -> Result<Option<S>, ThickError> {
    let grown = core.radius.plus(radius);
    match core.set {
        Set::Segment(height) if height == S::ZERO => Ok(nearest::<S, T>(Sphere::new(grown)?, core.frame, ray)),
        Set::Segment(height) => Ok(nearest::<S, T>(Capsule::new(grown, height)?, core.frame, ray)),
        Set::Plane => into_slab::<S, T>(core, ray, grown),
        Set::Cuboid([x, y, z]) => Ok(nearest::<S, T>(RoundedCuboid::new(x, y, z, grown)?, core.frame, ray)),
        Set::Triangle(triangle) => into_triangle::<S, T>(core, triangle, ray, grown),
    }
}

/// The first hit of a primitive in a frame.
fn hit<S: Scalar, T: Tier<S>>(
    primitive: impl Into<Primitive<S>>,
    frame: Option<&Frame<S>>,
    ray: &Ray<S>,
) -> Option<Hit<S>> {
    let shape = Shape::new(primitive);
    frame.map_or(shape, |frame| shape.in_frame(*frame)).nearest_at::<T>(ray)
}

/// Its `t`.
fn nearest<S: Scalar, T: Tier<S>>(
    primitive: impl Into<Primitive<S>>,
    frame: Option<&Frame<S>>,
    ray: &Ray<S>,
) -> Option<S> {
    hit::<S, T>(primitive, frame, ray).map(|hit| hit.t)
}

/// The lower of two parameters.
fn first<S: Scalar>(a: Option<S>, b: Option<S>) -> Option<S> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b < a { b } else { a }),
        (a, b) => a.or(b),
    }
}

/// The frame of a core, which is the world's if it is not placed.
fn frame_of<S: Scalar>(core: &Core<'_, S>) -> Result<Frame<S>, ThickError> {
    core.frame.map_or_else(|| Ok(Frame::at(Vec3::ZERO)?), |frame| Ok(*frame))
}

/// A plane grows to the points between two planes. A ray from outside enters by the one that faces it.
fn into_slab<S: Scalar, T: Tier<S>>(core: &Core<'_, S>, ray: &Ray<S>, r: S) -> Result<Option<S>, ThickError> {
    let frame = frame_of(core)?;
    let falls = ray.direction().dot(frame.up()).is_negative();
    let position = S::advance(frame.position().to_array(), frame.up().to_array(), if falls { r } else { -r });
    Ok(nearest::<S, T>(Plane::new(), Some(&frame.moved_to(position.into())?), ray))
}

/// A triangle grows to its copies at the distance `r` on both sides, what is between them, and a capsule about each
/// edge.
fn into_triangle<S: Scalar, T: Tier<S>>(
    core: &Core<'_, S>,
    triangle: &Triangle<S>,
    ray: &Ray<S>,
    r: S,
) -> Result<Option<S>, ThickError> {
    if misses_ball_around::<S, T>(core, triangle, ray, r) {
        return Ok(None);
    }
    if let Some(t) = into_face::<S, T>(core, triangle, ray, r) {
        return Ok(Some(t));
    }
    let to_world = |vertex: Vec3<S>| core.frame.map_or(vertex, |frame| frame.point_to_world(vertex));
    let ([a, b, c], mut entry) = (triangle.vertices().map(to_world), None);
    for (from, to) in [(a, b), (b, c), (c, a)] {
        let (frame, length) = Frame::between(from, to)?;
        if let Ok(edge) = Capsule::new(r, length) {
            entry = first(entry, nearest::<S, T>(edge, Some(&frame), ray));
            continue;
        }
        // It is longer than a capsule may be.
        let middle = frame.point_to_world(Vec3::new(S::ZERO, length.scaled(-1), S::ZERO));
        for (from, to) in [(from, middle), (middle, to)] {
            let (frame, length) = Frame::between(from, to)?;
            entry = first(entry, nearest::<S, T>(Capsule::new(r, length)?, Some(&frame), ray));
        }
    }
    Ok(entry)
}

/// True if the line of the ray misses a ball around a grown triangle; false also if rounding would matter to the ball,
/// or if there is none within the budget.
fn misses_ball_around<S: Scalar, T: Tier<S>>(core: &Core<'_, S>, triangle: &Triangle<S>, ray: &Ray<S>, r: S) -> bool {
    // About the middle of its box. The sum of the half extents is no less than the half diagonal.
    let sides = triangle.hull().extents().map(|side| side.map(|end| end.scaled(-1)));
    let [hx, hy, hz] = sides.map(|[low, high]| high.minus(low));
    let middle = Vec3::from(sides.map(|[low, high]| low.plus(high)));
    let middle = core.frame.map_or(middle, |frame| frame.point_to_world(middle));
    let radius = r.plus(hx).plus(hy).plus(hz);
    // A sixteenth more, for what rounding adds.
    let margin = radius.scaled(-4);
    match (Sphere::new(radius.plus(margin)), Frame::at(middle)) {
        (Ok(ball), Ok(frame)) if !is_rounding(margin, core.reach(middle)) => {
            nearest::<S, T>(ball, Some(&frame), &ray.with_range(Range::line())).is_none()
        }
        _ => false,
    }
}

/// The entry by one of the copies of a triangle: from the front of the one in front of it, or from the back of the one
/// behind it. `None` also for a triangle so narrow that its rounded copy is none: then the capsules hold it, but for
/// some units.
fn into_face<S: Scalar, T: Tier<S>>(core: &Core<'_, S>, triangle: &Triangle<S>, ray: &Ray<S>, r: S) -> Option<S> {
    let n = triangle.normal(Vec3::ZERO, Part::Side).to_array();
    [(r, Crossing::Enter), (-r, Crossing::Exit)].into_iter().find_map(|(r, crossing)| {
        let [a, b, c] = triangle.vertices().map(|vertex| S::advance(vertex.to_array(), n, r).into());
        let hit = hit::<S, T>(Triangle::new(a, b, c).ok()?, core.frame, ray)?;
        (hit.crossing == crossing).then_some(hit.t)
    })
}
