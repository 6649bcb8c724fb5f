//! The surface at a hit in the robust number, where one step in the number type is not enough.

use super::Surface;
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Geometry;
use crate::ladder;
use crate::line::{InWorld, Place};
use crate::number::{Estimate, Number};
use crate::part::Part;
use crate::scalar::{FromScalar, Ring, Scalar, clamped};
use crate::shape::kinds::{Kind, Kinds};
use crate::shape::primitive::Member;
use crate::shape::{Placement, through};
use crate::solve::{self, Line};
use crate::vector::{UnitVec3, Vec3};
use core::cmp::Ordering;

impl<S: Scalar, K: Kinds> Surface<S, K> {
    /// The primitive's equations. Those of a rounded cuboid depend on where the hit is beside its core: on the rounded
    /// point where that is accurate, otherwise on the end of the line's interval that rounds to the hit. If there is
    /// none, the hit was made up: its own point counts.
    pub(super) fn equations(&self) -> Equations<S> {
        let equations = self.shape.member.equations();
        let Equations::RoundedCuboid { half, radius, .. } = equations else { return equations };
        if !Member::<S, K>::EQUATIONS.has(EquationKinds::ROUNDED_CUBOID) || self.hit.part != Part::Side {
            return equations;
        }
        let (rough, number) = (self.rough_local_point(), <S::Robust as FromScalar<S>>::scalar);
        let at = |point| solve::region_at(point, half.map(number)).unwrap_or([Ordering::Equal; 3]);
        let region = if self.is_resolved(rough) {
            at(rough.to_array().map(number))
        } else {
            let shape = &self.shape;
            let line: Line<S::Robust> =
                through!(shape, |_primitive, place| ladder::line::<S, _, Member<S, K>>(&equations, place, &self.ray));
            let (t, departed) = (number(self.hit.t), self.ray.departure().map(|departure| departure.part));
            match solve::end_at(half, radius, self.hit.crossing, &line, departed) {
                Some(end) if is_rounding::<S>(t, end.t() - t) => end.region(),
                _ => at(solve::point_at(&line, t)),
            }
        };
        Equations::RoundedCuboid { half, radius, region }
    }

    /// The line, the hit's `t` in the robust number, and whether that is the surface's: if not, the surface is many
    /// units away.
    fn exact_t(&self, equations: &Equations<S>) -> (Line<S::Robust>, S::Robust, bool) {
        let shape = &self.shape;
        let line = through!(shape, |_primitive, place| ladder::line::<S, _, Member<S, K>>(equations, place, &self.ray));
        let t = <S::Robust as FromScalar<S>>::scalar(self.hit.t);
        let from_hit = Line { origin: solve::point_at(&line, t), ..line };
        let correction = solve::correction::<S, _, Member<S, K>>(equations, &self.hit, &from_hit);
        let is_rounding = is_rounding::<S>(t, correction);
        (line, if is_rounding { t + correction } else { t }, is_rounding)
    }

    #[cold]
    pub(super) fn exact_local_point(&self) -> Vec3<S> {
        let (point, is_on_surface) = self.exact_local_coordinates();
        let point = rounded(point);
        if is_on_surface { point } else { self.on_surface(point) }
    }

    /// The hit in the primitive's frame, and whether it is on the surface.
    #[cold]
    fn exact_local_coordinates(&self) -> ([S::Robust; 3], bool) {
        let (_, t, is_on_surface) = self.exact_t(&self.equations());
        let shape = &self.shape;
        let [origin, direction] = through!(shape, |_primitive, place| place.line::<S::Robust>(&self.ray));
        (solve::point_at(&Line { origin, direction }, t), is_on_surface)
    }

    #[cold]
    pub(super) fn exact_point(&self) -> Vec3<S> {
        let (_, t, is_on_surface) = self.exact_t(&self.equations());
        if !is_on_surface {
            let point = match &self.shape.placement {
                Placement::Frame(frame) if K::SET.contains(Kind::Frame) => {
                    frame.point_to_world(self.exact_local_point())
                }
                Placement::Affine(affine) if K::SET.contains(Kind::Affine) => {
                    affine.point_to_world(self.exact_local_point())
                }
                _ => self.exact_local_point(),
            };
            // At the ends of the float range the image may overflow, and then cancel.
            let is_number = |c: S| c <= S::ZERO || c >= S::ZERO;
            return if point.to_array().into_iter().all(is_number) { point } else { self.ray.at(self.hit.t) };
        }
        let [origin, direction] = InWorld.line::<S::Robust>(&self.ray);
        rounded(solve::point_at(&Line { origin, direction }, t))
    }

    /// The gradient of the surface's equation in the primitive's frame, of any length. For a sphere, whose line is not
    /// rotated, it is along the world's axes.
    #[cold]
    fn exact_gradient(&self) -> [S::Robust; 3] {
        let equations = self.equations();
        let (line, t, _) = self.exact_t(&equations);
        self.equation(&equations, &Line::at(solve::point_at(&line, t)), S::Robust::scalar).gradient()
    }

    /// The normal at the exact hit; `None` at an apex.
    #[cold]
    pub(super) fn exact_normal(&self) -> Option<UnitVec3<S>> {
        let gradient = self.exact_gradient();
        let is_ball = self.is_ball();
        let shape = &self.shape;
        let gradient = through!(shape, |_primitive, place| if is_ball {
            place.ball_gradient_to_world(gradient)
        } else {
            place.gradient_to_world(gradient)
        });
        UnitVec3::from_robust(gradient)
    }

    /// The local point as far as surface coordinates depend on it, and as far as solid coordinates do, where it may be
    /// beyond the number type: coordinates that repeat are less by a whole number, and those that only give an angle
    /// about the axis are less by a factor.
    #[cold]
    pub(super) fn coordinates_beyond(&self) -> (Vec3<S>, [S; 3]) {
        let (exact, _) = self.exact_local_coordinates();
        let repeated = exact.map(repeated::<S>);
        let point = self.exact_local_point();
        if exact.iter().all(|component| S::from_robust(*component).is_finite()) {
            return (point, point.to_array());
        }
        if matches!(self.shape.member.equations(), Equations::Plane) {
            return (repeated.into(), repeated);
        }
        if self.hit.part != Part::Side {
            return (point, repeated);
        }
        let ([x, _, z], [_, y, _]) = (exact, repeated);
        // Below the largest coordinate.
        let top = x.top().max(z.top()).unwrap_or(0);
        let room = S::BUDGET.coordinate.real();
        let room = <S::Robust as FromScalar<S>>::scalar(S::round(room)).top().unwrap_or(0) - 1;
        let [x, z] = [x, z].map(|c| S::from_robust(c.scaled((room - top).min(0))));
        (Vec3 { x, y, z }, repeated)
    }

    /// The normal at the exact hit in the primitive's frame; `None` at an apex.
    #[cold]
    pub(super) fn exact_local_normal(&self) -> Option<UnitVec3<S>> {
        let normal = UnitVec3::from_robust(self.exact_gradient())?;
        Some(self.frame_of_a_ball().map_or(normal, |frame| frame.direction_to_local(normal)))
    }
}

/// True for a correction of `t` that may be one of a rounding error. One of many units is not: the tier is `Fast`, or
/// rule 8 has put the hit at the start.
fn is_rounding<S: Scalar>(t: S::Robust, correction: S::Robust) -> bool {
    let most = S::last_place(t.top().unwrap_or(i32::MIN / 2)) + 6;
    correction.top().is_none_or(|top| top <= most)
}

/// The coordinate, less by a whole number if it is beyond the number type.
fn repeated<S: Scalar>(coordinate: S::Robust) -> S {
    let mut rest = coordinate;
    loop {
        let value = S::from_robust(rest);
        // The highest bit of the magnitude, a whole number.
        match rest.top() {
            Some(top) if top > 0 && !value.is_finite() => {
                let highest = S::Robust::ONE.scaled(top - 1);
                rest = if rest.sign() == Some(Ordering::Less) { rest + highest } else { rest - highest };
            }
            _ => return value,
        }
    }
}

/// The point rounded to the number type; coordinates beyond it are clamped to the largest distance.
fn rounded<S: Scalar>(point: [S::Robust; 3]) -> Vec3<S> {
    point.map(|component| clamped(S::from_robust(component), S::BUDGET.distance)).into()
}
