//! The inside test, decided by signs.

use super::end::Of;
use super::flat::is_zero;
use super::quadric::{Ball, Nappe, Profile, Quadric, Tube};
use super::side::{caps, planes_of};
use crate::equations::{Described, EquationKinds, Equations};
use crate::number::{Number, cross, difference, dot};
use crate::outline::Extent;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// True if the point belongs to the closed set. Only the tests for the kinds of equations of the geometry `G` are
/// linked.
pub(crate) fn holds<S: Scalar, N: Of<S>, G: Described>(equations: &Equations<S>, point: [N; 3]) -> Option<bool> {
    let ([x, y, z], no_direction) = (point, [N::ZERO; 3]);
    let in_ball = |o: [N; 3], r: N| is_inside(Ball { o, d: no_direction, r });
    let tube = |r: N| Tube::along(point, no_direction, r);
    match *equations {
        Equations::Ball { radius } if G::EQUATIONS.has(EquationKinds::BALL) => in_ball(point, N::scalar(radius)),
        Equations::Capsule { radius, height } if G::EQUATIONS.has(EquationKinds::CAPSULE) => {
            let (r, height) = (N::scalar(radius), N::scalar(height));
            if y.sign()? == Ordering::Less {
                in_ball(point, r)
            } else if (y - height).sign()? == Ordering::Greater {
                in_ball([x, y - height, z], r)
            } else {
                is_inside(tube(r))
            }
        }
        Equations::Tube { radius, extent } if G::EQUATIONS.has(EquationKinds::TUBE) => {
            if is_beyond(extent, [true; 2], y)? {
                return Some(false);
            }
            is_in_side(tube(N::scalar(radius)), extent)
        }
        Equations::Cone { outline, extent } if G::EQUATIONS.has(EquationKinds::CONE) => {
            if is_beyond(extent, caps(&outline), y)? {
                return Some(false);
            }
            let nappe = Nappe::along(point, no_direction, Profile::of(outline, N::scalar));
            if !matches!(extent, Extent::Double) && nappe.outline()[0].sign()? == Ordering::Less {
                return Some(false);
            }
            is_in_side(nappe, extent)
        }
        Equations::Plane if G::EQUATIONS.has(EquationKinds::PLANE) => Some(y.sign()? == Ordering::Equal),
        Equations::Disc { radius } if G::EQUATIONS.has(EquationKinds::DISC) => {
            Some(y.sign()? == Ordering::Equal && is_inside(tube(N::scalar(radius)))?)
        }
        Equations::Triangle { vertices } if G::EQUATIONS.has(EquationKinds::TRIANGLE) => {
            let corners = vertices.map(|vertex| vertex.map(N::scalar));
            let [a, b, c] = corners.map(|corner| difference(corner, point));
            let normal = cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
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
        Equations::Cuboid { half } if G::EQUATIONS.has(EquationKinds::CUBOID) => is_between(point, half.map(N::scalar)),
        Equations::Rectangle { half: [x, z] } if G::EQUATIONS.has(EquationKinds::RECTANGLE) => {
            is_between(point, [N::scalar(x), N::ZERO, N::scalar(z)])
        }
        // The geometry has no such equations.
        Equations::Ball { .. }
        | Equations::Capsule { .. }
        | Equations::Tube { .. }
        | Equations::Cone { .. }
        | Equations::Plane
        | Equations::Disc { .. }
        | Equations::Cuboid { .. }
        | Equations::Rectangle { .. }
        | Equations::Triangle { .. } => Some(false),
    }
}

/// True if the equation of the point is not positive.
fn is_inside<N: Number>(at: impl Quadric<N>) -> Option<bool> {
    Some(at.c().sign()? != Ordering::Greater)
}

/// The same for a side; of an open one only the surface counts.
fn is_in_side<S: Copy, N: Number>(at: impl Quadric<N>, extent: Extent<S>) -> Option<bool> {
    Some(match at.c().sign()? {
        Ordering::Less => !matches!(extent, Extent::Open(_)),
        Ordering::Equal => true,
        Ordering::Greater => false,
    })
}

/// True if the height is beyond the planes that cut a side with these caps.
fn is_beyond<S: Scalar, N: Of<S>>(extent: Extent<S>, caps: [bool; 2], y: N) -> Option<bool> {
    for (plane, beyond) in planes_of(extent, caps).into_iter().zip([Ordering::Less, Ordering::Greater]) {
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
