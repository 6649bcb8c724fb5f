//! The surface at a hit whose rounded `t` is corrected by one step.

use super::Surface;
use crate::equations::Equations;
use crate::frame::Frame;
use crate::hit::Crossing;
use crate::ladder;
use crate::line::{InWorld, Place};
use crate::number::dot;
use crate::part::Part;
use crate::scalar::{FromScalar, Real, Ring, RoundLine, RoundSolid, Scalar, Summed, Twofold};
use crate::shape::kinds::{Kind, Kinds};
use crate::shape::primitive::Member;
use crate::shape::{Placement, through};
use crate::solve::{self, Line};
use crate::vector::{UnitVec3, Vec3, pairs};

impl<S: Scalar, K: Kinds> Surface<S, K> {
    /// The error of the rounded `t`, by one Newton step. `None` in fixed point, which has no bits for it, and if the
    /// step is not accurate to a few units.
    #[inline(always)]
    pub(super) fn correction(&self, rough: Vec3<S>) -> Option<Correction<S>> {
        if !S::RELATIVE {
            return None;
        }
        let (shape, equations) = (&self.shape, self.equations());
        // In a frame, and beside a core, the local point is computed in twice the precision: its rounding would be
        // amplified.
        let is_in_world = matches!(shape.placement, Placement::World) && !self.is_about_a_core();
        let (point, direction) = if is_in_world {
            (rough.real().map(Twofold::of), self.ray.direction().real().map(Twofold::of))
        } else {
            let line: Line<Twofold<S::Real>> =
                through!(shape, |_primitive, place| ladder::line::<S, _, Member<S, K>>(&equations, place, &self.ray));
            let t = <Twofold<S::Real> as FromScalar<S>>::scalar(self.hit.t);
            (solve::point_at(&line, t), line.direction)
        };
        let [p, d] = [point, direction].map(|vector| vector.map(|component| component.high));
        let gradient = self.equation(&equations, &Line::at(p), S::real).gradient();
        let (slope, squares, square) = (dot(gradient, d), dot(gradient, gradient), dot(d, d));
        // The line leaves the surface by more than 14 degrees, so that the rounding of the local point changes the
        // result by a few units, and the terms of the equation do not underflow.
        let most = squares * square;
        let is_steep = (slope * slope).scaled(4) >= most && S::round(most).is_finite();
        if !(is_steep && squares >= S::Real::ONE.scaled(-90)) {
            return None;
        }
        let value = self.equation(&equations, &Line::at(point), |size| Twofold::of(size.real())).value();
        let step = -value.high / slope.scaled(1);
        let length = step.abs();
        // The error after the step is about its square over the radius of curvature.
        let radius = self.bend(rough).real().scaled(S::Real::ROUNDING / 2 - 1);
        let is_small = length * length * square <= radius * radius;
        // A step of many units is no correction of a rounding error.
        let is_rounding = length <= self.hit.t.magnitude().real().scaled(S::Real::ROUNDING + 6);
        let correction = Correction { equations, point, direction, step };
        let is_number = correction.local_point().into_iter().all(|component| S::round(component).is_finite());
        (is_small && is_rounding && is_number).then_some(correction)
    }

    /// In fixed point: the gradient at the exact hit in the primitive's frame, or for a ball along the world's axes. It
    /// is that of a point of which all bits are known, moved along the line to the nearest root of `f + 2 h x + a x^2`;
    /// `None` if two terms of the root's series do not give it to less than a unit of a direction.
    #[inline(never)]
    fn gradient_by_integers(&self) -> Option<[S::Real; 3]> {
        if self.is_stretched() || self.hit.crossing == Crossing::Touch {
            return None;
        }
        let (equations, part) = (self.equations(), self.hit.part);
        // Its polynomial is of the fourth degree: more bits than these integers have.
        if matches!(equations, Equations::Torus { .. }) {
            return None;
        }
        let (o, d, t) = (self.ray.origin().to_array(), self.ray.direction(), self.hit.t);
        if let Some(solid) = round_solid(&equations, part) {
            let frame = match &self.shape.placement {
                Placement::Frame(frame) if K::SET.contains(Kind::Frame) => Some(frame),
                _ => None,
            };
            let base = frame.map_or(Vec3::ZERO, Frame::position).to_array();
            let axes = frame.filter(|_| !self.is_ball()).map(|frame| frame.axes().map(UnitVec3::to_array));
            let enters = self.hit.crossing == Crossing::Enter;
            let line = RoundLine { o, base, d: d.to_array(), t, axes, enters };
            if let Some(gradient) = S::round_normal(line, solid) {
                return Some(gradient);
            }
        }
        let (point, direction) = match &self.shape.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => {
                let (base, axes) = (frame.position().to_array(), frame.axes());
                if self.is_ball() {
                    (S::approach_exactly(o, base, d.to_array(), t), d.real())
                } else {
                    let point = S::approach_along(o, base, d.to_array(), t, axes.map(UnitVec3::to_array));
                    (point, axes.map(|axis| axis.dot(d)))
                }
            }
            _ => (S::approach_exactly(o, [S::ZERO; 3], d.to_array(), t), d.real()),
        };
        let gradient = |point| self.equation(&equations, &Line::at(point), S::real).gradient();
        let value = self.equation(&equations, &Line::at(point.map(Summed)), |size| Summed(size.real())).value();
        let slope = dot(gradient(point), direction);
        if slope.is_zero() || slope.is_negative() != (self.hit.crossing == Crossing::Enter) {
            return None;
        }
        let inverse = S::Real::ONE / slope.scaled(1);
        let step = -value.0 * inverse;
        let bending = self.equation(&equations, &Line { origin: point, direction }, S::real).bending();
        let term = bending * step * inverse;
        // A step of many units is no correction of a rounding error.
        let is_rounding = step.abs() <= S::Real::ONE.scaled(S::last_place(0) + 6);
        // What is left is twice the square of the term, times the step.
        let radius = self.bend(Vec3::round(point)).real();
        let is_accurate = (term * term * step).abs() <= radius.scaled(S::Real::ROUNDING - 3);
        if !(is_rounding && is_accurate) {
            return None;
        }
        let step = step - term * step;
        Some(gradient(pairs(point, direction).map(|(p, d)| p + step * d)))
    }

    pub(super) fn corrected_local_normal(&self, rough: Vec3<S>) -> Option<UnitVec3<S>> {
        if !S::RELATIVE {
            let normal = UnitVec3::from_real(self.gradient_by_integers()?)?;
            return Some(self.frame_of_a_ball().map_or(normal, |frame| frame.direction_to_local(normal)));
        }
        let normal = self.normal_at(&self.correction(rough)?)?;
        Some(self.frame_of_a_ball().map_or(normal, |frame| frame.direction_to_local(normal)))
    }

    /// The normal of a primitive that is not stretched, in the coordinates of its line.
    fn normal_at(&self, correction: &Correction<S>) -> Option<UnitVec3<S>> {
        UnitVec3::from_real(if self.is_about_a_core() {
            self.gradient_at(correction).map(|component| component.high)
        } else {
            self.equation(&correction.equations, &Line::at(correction.local_point()), S::real).gradient()
        })
    }

    /// The gradient in twice the precision.
    fn gradient_at(&self, correction: &Correction<S>) -> [Twofold<S::Real>; 3] {
        let Correction { equations, point, direction, step } = correction;
        let point = pairs(*point, *direction).map(|(p, d)| p + d * Twofold::of(*step));
        self.equation(equations, &Line::at(point), |size: S| Twofold::of(size.real())).gradient()
    }

    pub(super) fn corrected_normal(&self, rough: Vec3<S>) -> Option<UnitVec3<S>> {
        if !S::RELATIVE {
            let gradient = self.gradient_by_integers()?;
            return UnitVec3::from_real(match &self.shape.placement {
                Placement::Frame(frame) if K::SET.contains(Kind::Frame) && !self.is_ball() => {
                    frame.vector_to_world(gradient)
                }
                _ => gradient,
            });
        }
        let correction = self.correction(rough)?;
        let Some(affine) = self.affine() else {
            let normal = self.normal_at(&correction)?;
            let is_local = self.frame_of_a_ball().is_none();
            return Some(if is_local { self.local_normal_to_world(normal) } else { normal });
        };
        UnitVec3::from_real(affine.gradient_to_world(self.gradient_at(&correction)).map(|component| component.high))
    }
}

/// A hit's local point from the rounded `t`, the line's direction in the same coordinates, and the correction of `t`.
pub(super) struct Correction<S: Scalar> {
    /// The primitive's, at the hit.
    equations: Equations<S>,
    point: [Twofold<S::Real>; 3],
    direction: [Twofold<S::Real>; 3],
    pub(super) step: S::Real,
}

impl<S: Scalar> Correction<S> {
    pub(super) fn local_point(&self) -> [S::Real; 3] {
        let Self { point, direction, step, .. } = *self;
        pairs(point, direction).map(|(p, d)| p.high + (p.low + d.high * step))
    }
}

/// The ball or cylinder that a part lies on, if it is one.
fn round_solid<S: Scalar>(equations: &Equations<S>, part: Part) -> Option<RoundSolid<S>> {
    match (*equations, part) {
        (Equations::Ball { radius }, _) | (Equations::Capsule { radius, .. }, Part::Base) => {
            Some(RoundSolid { radius, centre: Some(S::ZERO) })
        }
        (Equations::Capsule { radius, height }, Part::Top) => Some(RoundSolid { radius, centre: Some(height) }),
        (Equations::Capsule { radius, .. }, _) | (Equations::Cylinder { radius, .. }, Part::Side) => {
            Some(RoundSolid { radius, centre: None })
        }
        (Equations::RoundCone { radii: [radius, _], .. }, Part::Base) => {
            Some(RoundSolid { radius, centre: Some(S::ZERO) })
        }
        (Equations::RoundCone { radii: [_, radius], height }, Part::Top) => {
            Some(RoundSolid { radius, centre: Some(height) })
        }
        (Equations::Tube { radii: [_, radius], .. }, Part::Side) => Some(RoundSolid { radius, centre: None }),
        _ => None,
    }
}
