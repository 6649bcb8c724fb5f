//! Prisms and polyhedra: what half-spaces have in common (Cyrus and Beck, *Generalized Two- and Three-Dimensional
//! Clipping*, 1978; Haines, *Fast Ray-Convex Polyhedron Intersection*, in *Graphics Gems II*, 1991).
//!
//! Along a line the distance from a face's plane, times the length of the normal, is `value + slope t`, positive
//! outside. The facet of a prism over the edge from the corner `a` to `b` has the outward normal
//! `(a_z - b_z, 0, b_x - a_x)`, which is exact in the differences of stored numbers.

use super::attempt::Attempt;
use super::end::{Flat, Fraction, Goal, Of, inwards, solid};
use super::local_ray::LocalRay;
use super::roots::RootOfQuadric;
use super::slabs::Clipped;
use super::surface::Line;
use crate::half_space::{CutBox, HalfSpace};
use crate::intersection::Intersection;
use crate::number::{Number, Ring, difference, dot};
use crate::part::Part;
use crate::polygon::Polygon;
use crate::scalar::{FromScalar, Scalar};
use core::cmp::Ordering;

/// A face along a line: its part, the value at the line's origin, and the slope.
type Along<N> = (Part, [N; 2]);

/// The plane of a prism's facet along the line `p + x d`: the outward normal, from a corner to `p`, and `d`.
#[inline(always)]
pub(super) fn over_edge<S, N: Ring>(
    [[ax, az], [bx, bz]]: [[S; 2]; 2],
    [p, d]: [[N; 3]; 2],
    number: impl Fn(S) -> N,
) -> [[N; 3]; 3] {
    let [ax, az, bx, bz] = [ax, az, bx, bz].map(number);
    [[az - bz, N::ZERO, bx - ax], [p[0] - ax, N::ZERO, p[2] - az], d]
}

/// The same of a half-space.
#[inline(always)]
pub(super) fn half_space<S: Scalar, N: Ring>(
    face: HalfSpace<S>,
    [p, d]: [[N; 3]; 2],
    number: impl Fn(S) -> N + Copy,
) -> [[N; 3]; 3] {
    let [normal, point] = [face.normal(), face.point()].map(|v| v.to_array().map(number));
    [normal, difference(p, point), d]
}

/// The faces of a prism: the facets in order, the base and the top.
#[inline(always)]
fn of_prism<S: Scalar, N: FromScalar<S>>(
    line @ [o, d]: [[N; 3]; 2],
    polygon: Polygon<S>,
    height: S,
) -> impl Iterator<Item = Along<N>> {
    let facets = polygon.edges().map(move |(part, edge)| {
        let [[nx, _, nz], [x, _, z], [dx, _, dz]] = over_edge(edge, line, N::scalar);
        (part, [N::sum([[nx, x], [nz, z]]), N::sum([[nx, dx], [nz, dz]])])
    });
    facets.chain([(Part::Base, [-o[1], -d[1]]), (Part::Top, [o[1] - N::scalar(height), d[1]])])
}

/// The faces of a polyhedron: the facets in order, and those of its box.
#[inline(always)]
fn of_polyhedron<S: Scalar, N: FromScalar<S>>(line: [[N; 3]; 2], solid: CutBox<S>) -> impl Iterator<Item = Along<N>> {
    let ([[x, y, z], [dx, dy, dz]], [low, high]) = (line, solid.corners.map(|corner| corner.map(N::scalar)));
    let facets = solid.facets().map(move |(part, face)| {
        let [normal, from, d] = half_space(face, line, N::scalar);
        (part, [dot(normal, from), dot(normal, d)])
    });
    facets.chain([
        (Part::Left, [low[0] - x, -dx]),
        (Part::Right, [x - high[0], dx]),
        (Part::Back, [low[2] - z, -dz]),
        (Part::Front, [z - high[2], dz]),
        (Part::Base, [low[1] - y, -dy]),
        (Part::Top, [y - high[1], dy]),
    ])
}

/// The prism over the polygon from `y = 0` to this height.
#[inline(always)]
pub(crate) fn prism<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    polygon: Polygon<S>,
    height: S,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    clipped(line, of_prism([line.origin, line.direction], polygon, height), goal)
}

/// The box that half-spaces cut.
#[inline(always)]
pub(crate) fn polyhedron<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    solid: CutBox<S>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    clipped(line, of_polyhedron([line.origin, line.direction], solid), goal)
}

/// What the half-spaces have in common.
#[inline(always)]
fn clipped<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    faces: impl Iterator<Item = Along<N>>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let mut clipped = Clipped::everywhere();
    for (rank, (part, along)) in faces.enumerate() {
        clipped.by_half_space(line, along, (rank, part))?;
    }
    if line.departs() {
        return inwards(&Flat, line, &clipped.exit(), goal.range);
    }
    solid(&Flat, line, &clipped.interval()?, goal)
}

/// True if the point is in the prism.
pub(super) fn is_in_prism<S: Scalar, N: Of<S>>(point: [N; 3], polygon: Polygon<S>, height: S) -> Option<bool> {
    is_in_all(of_prism([point, [N::ZERO; 3]], polygon, height))
}

/// True if the point is in the polyhedron.
pub(super) fn is_in_polyhedron<S: Scalar, N: Of<S>>(point: [N; 3], solid: CutBox<S>) -> Option<bool> {
    is_in_all(of_polyhedron([point, [N::ZERO; 3]], solid))
}

fn is_in_all<N: Number>(faces: impl Iterator<Item = Along<N>>) -> Option<bool> {
    for (_, [value, _]) in faces {
        if value.sign()? == Ordering::Greater {
            return Some(false);
        }
    }
    Some(true)
}

/// The end of a line that lies in the plane of a prism's face; `None` if the number does not know a sign.
pub(super) fn end_in_a_prism<S: Scalar, N: FromScalar<S> + Number>(
    line: &Line<N>,
    polygon: Polygon<S>,
    height: S,
    (enters, departed): (bool, Option<Part>),
) -> Option<RootOfQuadric<N>> {
    end_in_a_face(of_prism([line.origin, line.direction], polygon, height), enters, departed)
}

/// The same of a polyhedron's.
pub(super) fn end_in_a_polyhedron<S: Scalar, N: FromScalar<S> + Number>(
    line: &Line<N>,
    solid: CutBox<S>,
    (enters, departed): (bool, Option<Part>),
) -> Option<RootOfQuadric<N>> {
    end_in_a_face(of_polyhedron([line.origin, line.direction], solid), enters, departed)
}

/// Where the line enters the last of the half-spaces, or leaves the first.
fn end_in_a_face<N: Number>(
    faces: impl Iterator<Item = Along<N>>,
    enters: bool,
    departed: Option<Part>,
) -> Option<RootOfQuadric<N>> {
    let crosses = if enters { Ordering::Less } else { Ordering::Greater };
    let mut last: Option<Fraction<N>> = None;
    for (part, [value, slope]) in faces {
        // It starts in the plane of the face that it departs from, whatever its rounded coordinates.
        let value = if departed == Some(part) { N::ZERO } else { value };
        if slope.sign()? != crosses {
            continue;
        }
        let t = Fraction { n: -value, e: slope };
        last = match last {
            Some(own) if t.order(own)? != crosses.reverse() => Some(own),
            _ => Some(t),
        };
    }
    last.map(RootOfQuadric::at)
}
