//! The inside test, decided by signs.

use super::end::Of;
use super::flat::is_zero;
use super::form::{Ball, Cone, Form, Homogeneous, Quadric, Tube, Weight};
use crate::equations::{Described, EquationKinds, Equations, Extent};
use crate::number::{Number, cross, difference, dot};
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// True if the point belongs to the closed set. Only the tests for the kinds of equations of the geometry `G` are
/// linked.
pub(crate) fn holds<S: Scalar, N: Of<S>, G: Described>(equations: &Equations<S>, point: [N; 3]) -> Option<bool> {
    let here = Homogeneous { v: point, w: Weight::One };
    let [_, y, _] = point;
    let is_inside = |form: Form<N>, p: Homogeneous<N>| Some(form.at(p).sign()? != Ordering::Greater);
    match *equations {
        Equations::Ball { radius } if G::EQUATIONS.has(EquationKinds::BALL) => {
            is_inside(Form::Ball(Ball { r: N::scalar(radius) }), here)
        }
        Equations::Capsule { radius, height } if G::EQUATIONS.has(EquationKinds::CAPSULE) => {
            let (r, height) = (N::scalar(radius), N::scalar(height));
            let below = y.sign()? == Ordering::Less;
            let above = (y - height).sign()? == Ordering::Greater;
            let [x, _, z] = point;
            let seen = Homogeneous { v: [x, if above { y - height } else { y }, z], w: Weight::One };
            is_inside(if below || above { Form::Ball(Ball { r }) } else { Form::Tube(Tube { r }) }, seen)
        }
        Equations::DoubleCone { slope } if G::EQUATIONS.has(EquationKinds::DOUBLE_CONE) => {
            is_inside(Form::Cone(Cone::slope(N::scalar(slope))), here)
        }
        Equations::Round { side, extent } if G::EQUATIONS.has(EquationKinds::TUBE.and(EquationKinds::CONE)) => {
            let form = Form::of_side::<S, G>(side, N::scalar);
            let outline = match form {
                Form::Ball(ball) => ball.outline(here),
                Form::Tube(tube) => tube.outline(here),
                Form::Cone(cone) => cone.outline(here),
            };
            let (low, high) = match extent {
                Extent::Infinite => (None, None),
                Extent::Open(height) => (Some(S::ZERO), Some(height)),
                Extent::Capped(low, high) => (low, high),
            };
            let outside = |bound: Option<S>, side: Ordering| match bound {
                Some(bound) => Some((y - N::scalar(bound)).sign()? == side),
                None => Some(false),
            };
            if outside(low, Ordering::Less)? || outside(high, Ordering::Greater)? || outline.sign()? == Ordering::Less {
                return Some(false);
            }
            Some(match form.at(here).sign()? {
                Ordering::Less => !matches!(extent, Extent::Open(_)),
                Ordering::Equal => true,
                Ordering::Greater => false,
            })
        }
        Equations::Plane if G::EQUATIONS.has(EquationKinds::PLANE) => Some(y.sign()? == Ordering::Equal),
        Equations::Disc { radius } if G::EQUATIONS.has(EquationKinds::DISC) => {
            Some(y.sign()? == Ordering::Equal && is_inside(Form::Tube(Tube { r: N::scalar(radius) }), here)?)
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
        | Equations::Round { .. }
        | Equations::DoubleCone { .. }
        | Equations::Plane
        | Equations::Disc { .. }
        | Equations::Cuboid { .. }
        | Equations::Rectangle { .. }
        | Equations::Triangle { .. } => Some(false),
    }
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
