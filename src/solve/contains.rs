//! The inside test, decided by signs.

use super::end::Of;
use super::flat::is_zero;
use super::polyhedra;
use super::quadric::{Ball, Cylinder, Nappe, Profile, Quadric, Revolution, Tangent};
use super::rounded::{piece, region_at};
use super::side::planes_through;
use super::torus::Torus;
use crate::equations::{Described, EquationKinds, Equations};
use crate::number::{Number, cross, difference, dot};
use crate::outline::Extent;
use crate::part::Part;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// True if the point belongs to the closed set. Only the tests for the kinds of equations of the geometry `G` are
/// linked.
pub(crate) fn holds<S: Scalar, N: Of<S>, G: Described>(equations: &Equations<S>, point: [N; 3]) -> Option<bool> {
    let ([x, y, z], no_direction) = (point, [N::ZERO; 3]);
    let in_ball = |o: [N; 3], r: N| is_inside(Ball { o, d: no_direction, r });
    let cylinder = |r: N| Cylinder::along(point, no_direction, r);
    match *equations {
        Equations::Ball { radius } if G::EQUATIONS.has(EquationKinds::BALL) => in_ball(point, N::scalar(radius)),
        Equations::Capsule { radius, height } if G::EQUATIONS.has(EquationKinds::CAPSULE) => {
            let (r, height) = (N::scalar(radius), N::scalar(height));
            if y.sign()? == Ordering::Less {
                in_ball(point, r)
            } else if (y - height).sign()? == Ordering::Greater {
                in_ball([x, y - height, z], r)
            } else {
                is_inside(cylinder(r))
            }
        }
        Equations::RoundCone { radii, height } if G::EQUATIONS.has(EquationKinds::ROUND_CONE) => {
            let ([base, top], h) = (radii.map(N::scalar), N::scalar(height));
            match round_part(y, [base, top], h)? {
                Part::Base => in_ball(point, base),
                Part::Top => in_ball([x, y - h, z], top),
                // Between the seams the cone's other nappe is not reached.
                _ => is_inside(Tangent::along(point, no_direction, [base, h, base - top])),
            }
        }
        Equations::Cylinder { radius, extent } if G::EQUATIONS.has(EquationKinds::CYLINDER) => {
            if is_beyond(planes_through::<S, G>(equations), y)? {
                return Some(false);
            }
            is_in_side(cylinder(N::scalar(radius)), matches!(extent, Extent::Open(_)))
        }
        Equations::Cone { outline, extent } if G::EQUATIONS.has(EquationKinds::CONE) => {
            if is_beyond(planes_through::<S, G>(equations), y)? {
                return Some(false);
            }
            let nappe = Nappe::along(point, no_direction, Profile::of(outline, N::scalar));
            if !matches!(extent, Extent::Double) && nappe.outline()[0].sign()? == Ordering::Less {
                return Some(false);
            }
            is_in_side(nappe, matches!(extent, Extent::Open(_)))
        }
        Equations::Revolved { meridian } if G::EQUATIONS.has(EquationKinds::REVOLVED) => {
            if is_beyond(meridian.heights.map(Some), y)? {
                return Some(false);
            }
            let revolution = Revolution::along(point, no_direction, &meridian, N::scalar);
            is_in_side(revolution, meridian.is_open)
        }
        Equations::Tube { radii: [inner, outer], height } if G::EQUATIONS.has(EquationKinds::TUBE) => Some(
            !is_beyond([Some(S::ZERO), Some(height)], y)?
                && is_inside(cylinder(N::scalar(outer)))?
                && is_outside(cylinder(N::scalar(inner)))?,
        ),
        Equations::Torus { radii } if G::EQUATIONS.has(EquationKinds::TORUS) => {
            let torus = Torus { o: point, d: no_direction, radii: radii.map(N::scalar) };
            Some(torus.value().sign()? != Ordering::Greater)
        }
        Equations::Plane if G::EQUATIONS.has(EquationKinds::PLANE) => Some(y.sign()? == Ordering::Equal),
        Equations::Disc { radius } if G::EQUATIONS.has(EquationKinds::DISC) => {
            Some(y.sign()? == Ordering::Equal && is_inside(cylinder(N::scalar(radius)))?)
        }
        Equations::Annulus { radii: [inner, outer] } if G::EQUATIONS.has(EquationKinds::ANNULUS) => Some(
            y.sign()? == Ordering::Equal
                && is_inside(cylinder(N::scalar(outer)))?
                && is_outside(cylinder(N::scalar(inner)))?,
        ),
        Equations::Triangle { vertices } if G::EQUATIONS.has(EquationKinds::TRIANGLE) => {
            is_in_triangle(point, vertices.map(|vertex| vertex.map(N::scalar)))
        }
        Equations::Cuboid { half } if G::EQUATIONS.has(EquationKinds::CUBOID) => is_between(point, half.map(N::scalar)),
        Equations::RoundedCuboid { half, radius, .. } if G::EQUATIONS.has(EquationKinds::ROUNDED_CUBOID) => {
            let half = half.map(N::scalar);
            let region = region_at(point, half)?;
            is_inside(piece(point, no_direction, half, N::scalar(radius), region))
        }
        Equations::Prism { polygon, height } if G::EQUATIONS.has(EquationKinds::PRISM) => {
            polyhedra::is_in_prism(point, polygon, height)
        }
        Equations::Polyhedron { solid } if G::EQUATIONS.has(EquationKinds::POLYHEDRON) => {
            polyhedra::is_in_polyhedron(point, solid)
        }
        Equations::Rectangle { half: [x, z] } if G::EQUATIONS.has(EquationKinds::RECTANGLE) => {
            is_between(point, [N::scalar(x), N::ZERO, N::scalar(z)])
        }
        // The geometry has no such equations.
        Equations::Ball { .. }
        | Equations::Capsule { .. }
        | Equations::RoundCone { .. }
        | Equations::Cylinder { .. }
        | Equations::Cone { .. }
        | Equations::Revolved { .. }
        | Equations::Tube { .. }
        | Equations::Torus { .. }
        | Equations::Plane
        | Equations::Disc { .. }
        | Equations::Annulus { .. }
        | Equations::Cuboid { .. }
        | Equations::RoundedCuboid { .. }
        | Equations::Prism { .. }
        | Equations::Polyhedron { .. }
        | Equations::Rectangle { .. }
        | Equations::Triangle { .. } => Some(false),
    }
}

/// True if the point is in the plane of the triangle and on the inner side of each edge.
fn is_in_triangle<N: Number>(point: [N; 3], vertices: [[N; 3]; 3]) -> Option<bool> {
    let [a, b, c] = vertices.map(|vertex| difference(vertex, point));
    let normal = cross(difference(vertices[1], vertices[0]), difference(vertices[2], vertices[0]));
    if is_zero(normal)? || dot(normal, a).sign()? != Ordering::Equal {
        return Some(false);
    }
    for (p, q) in [(a, b), (b, c), (c, a)] {
        if dot(normal, cross(p, q)).sign()? == Ordering::Less {
            return Some(false);
        }
    }
    Some(true)
}

/// The part of a round cone at a height; of one whose one ball holds the other, that ball's.
fn round_part<N: Number>(y: N, [base, top]: [N; 2], h: N) -> Option<Part> {
    let k = base - top;
    if (k - h).sign()? != Ordering::Less {
        return Some(Part::Base);
    }
    if (k + h).sign()? != Ordering::Greater {
        return Some(Part::Top);
    }
    if (h * y - base * k).sign()? == Ordering::Less {
        return Some(Part::Base);
    }
    Some(if (h * (y - h) - top * k).sign()? == Ordering::Greater { Part::Top } else { Part::Side })
}

/// True if the equation of the point is not positive.
fn is_inside<N: Number>(at: impl Quadric<N>) -> Option<bool> {
    Some(at.c().sign()? != Ordering::Greater)
}

/// True if the equation of the point is not negative.
fn is_outside<N: Number>(at: impl Quadric<N>) -> Option<bool> {
    Some(at.c().sign()? != Ordering::Less)
}

/// The same as [`is_inside`] for a side; of an open one only the surface counts.
fn is_in_side<N: Number>(at: impl Quadric<N>, is_open: bool) -> Option<bool> {
    Some(match at.c().sign()? {
        Ordering::Less => !is_open,
        Ordering::Equal => true,
        Ordering::Greater => false,
    })
}

/// True if the height is beyond one of the two planes.
fn is_beyond<S: Scalar, N: Of<S>>(planes: [Option<S>; 2], y: N) -> Option<bool> {
    for (plane, beyond) in planes.into_iter().zip([Ordering::Less, Ordering::Greater]) {
        if let Some(height) = plane
            && (y - N::scalar(height)).sign()? == beyond
        {
            return Some(true);
        }
    }
    Some(false)
}

/// True if no coordinate is larger in magnitude than the half extent along its axis.
fn is_between<N: Number>(point: [N; 3], half: [N; 3]) -> Option<bool> {
    for (p, h) in point.into_iter().zip(half) {
        if (p + h).sign()? == Ordering::Less || (p - h).sign()? == Ordering::Greater {
            return Some(false);
        }
    }
    Some(true)
}
