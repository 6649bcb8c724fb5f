//! The surface at a hit: point, normal, surface coordinates, tangents.

use super::kinds::{All, Kind, Kinds};
use super::primitive::Member;
use super::{Placement, Shape, through};
use crate::affine::Affine;
use crate::equations::{Equations, Side};
use crate::frame::Frame;
use crate::geometry::Geometry;
use crate::hit::{Crossing, Hit};
use crate::ladder;
use crate::line::{InWorld, Place};
use crate::number::{Estimate, Number, dot};
use crate::part::Part;
use crate::primitive::surface_coordinates as coordinates;
use crate::query;
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::{FromScalar, Real, Ring, RoundLine, RoundSolid, Scalar, Summed, Twofold, largest};
use crate::solve::{self, Line};
use crate::vector::{UnitVec3, Vec3, pairs};
use core::cmp::Ordering;

/// The surface of a shape at a hit. Its methods compute point, normal, surface coordinates and tangents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<S: Scalar, K: Kinds = All> {
    shape: Shape<S, K>,
    ray: Ray<S>,
    hit: Hit<S>,
}

impl<S: Scalar, K: Kinds> Surface<S, K> {
    #[inline]
    pub(super) const fn new(shape: &Shape<S, K>, ray: &Ray<S>, hit: &Hit<S>) -> Self {
        Self { shape: *shape, ray: *ray, hit: *hit }
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
        // Close to the world's origin floats have smaller units than close to the primitive's origin.
        let twice = self.hit.t.plus(self.hit.t);
        let is_fine = |point: &Vec3<S>| {
            if S::RELATIVE {
                S::resolves(twice, largest([point.x, point.y, point.z]))
            } else {
                !self.is_far_from_frame(rough)
            }
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
    /// front.
    pub fn normal(&self) -> UnitVec3<S> {
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
    /// more than these resolve.
    fn is_turned_finely(&self, local: Vec3<S>, bend: S) -> bool {
        match self.shape.placement {
            Placement::Frame(_) if S::RELATIVE && K::SET.contains(Kind::Frame) => {
                S::resolves(largest([local.x, local.y, local.z]), bend)
            }
            _ => true,
        }
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

    fn is_ball(&self) -> bool {
        ladder::is_ball::<S, Member<S, K>>(&self.shape.member.equations())
    }

    /// The error of the rounded `t`, by one Newton step. `None` in fixed point, which has no bits for it, and if the
    /// step is not accurate to a few units.
    #[inline(always)]
    fn correction(&self, rough: Vec3<S>) -> Option<Correction<S::Real>> {
        if !S::RELATIVE {
            return None;
        }
        let (shape, part, equations) = (&self.shape, self.hit.part, self.shape.member.equations());
        // In a frame the local point is computed in twice the precision: its rounding would be amplified.
        let (point, direction) = if let Placement::World = shape.placement {
            (rough.real().map(Twofold::of), self.ray.direction().real().map(Twofold::of))
        } else {
            let line: Line<Twofold<S::Real>> =
                through!(shape, |_primitive, place| ladder::line::<S, _, Member<S, K>>(&equations, place, &self.ray));
            let t = <Twofold<S::Real> as FromScalar<S>>::scalar(self.hit.t);
            (solve::point_at(&line, t), line.direction)
        };
        let [p, d] = [point, direction].map(|vector| vector.map(|component| component.high));
        let gradient = solve::gradient::<S, _, Member<S, K>>(&equations, part, p, S::real);
        let (slope, squares, square) = (dot(gradient, d), dot(gradient, gradient), dot(d, d));
        // The line leaves the surface by more than 14 degrees, so that the rounding of the local point changes the
        // result by a few units, and the terms of the equation do not underflow.
        let most = squares * square;
        let is_steep = (slope * slope).scaled(4) >= most && S::round(most).is_finite();
        if !(is_steep && squares >= S::Real::ONE.scaled(-90)) {
            return None;
        }
        let value = solve::value::<S, _, Member<S, K>>(&equations, part, point, |size| Twofold::of(size.real()));
        let step = -value.high / slope.scaled(1);
        let length = step.abs();
        // The error after the step is about its square over the radius of curvature.
        let radius = self.bend(rough).real().scaled(S::Real::ROUNDING / 2 - 1);
        let is_small = length * length * square <= radius * radius;
        // A step of many units is no correction of a rounding error.
        let is_rounding = length <= self.hit.t.magnitude().real().scaled(S::Real::ROUNDING + 6);
        let correction = Correction { point, direction, step };
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
        let (equations, part) = (self.shape.member.equations(), self.hit.part);
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
        let gradient = |point| solve::gradient::<S, _, Member<S, K>>(&equations, part, point, S::real);
        let value = solve::value::<S, _, Member<S, K>>(&equations, part, point.map(Summed), |size| Summed(size.real()));
        let slope = dot(gradient(point), direction);
        if slope.is_zero() || slope.is_negative() != (self.hit.crossing == Crossing::Enter) {
            return None;
        }
        let inverse = S::Real::ONE / slope.scaled(1);
        let step = -value.0 * inverse;
        let bending = solve::bending::<S, _, Member<S, K>>(&equations, part, direction, S::real);
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

    fn corrected_local_normal(&self, rough: Vec3<S>) -> Option<UnitVec3<S>> {
        if !S::RELATIVE {
            let normal = UnitVec3::from_real(self.gradient_by_integers()?)?;
            return Some(self.frame_of_a_ball().map_or(normal, |frame| frame.direction_to_local(normal)));
        }
        let normal = self.gradient_at(self.correction(rough)?.local_point())?;
        Some(self.frame_of_a_ball().map_or(normal, |frame| frame.direction_to_local(normal)))
    }

    fn gradient_at(&self, point: [S::Real; 3]) -> Option<UnitVec3<S>> {
        UnitVec3::from_real(solve::gradient::<S, _, Member<S, K>>(
            &self.shape.member.equations(),
            self.hit.part,
            point,
            S::real,
        ))
    }

    fn corrected_normal(&self, rough: Vec3<S>) -> Option<UnitVec3<S>> {
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
            let normal = self.gradient_at(correction.local_point())?;
            let is_local = self.frame_of_a_ball().is_none();
            return Some(if is_local { self.local_normal_to_world(normal) } else { normal });
        };
        let Correction { point, direction, step } = correction;
        let point = pairs(point, direction).map(|(p, d)| p + d * Twofold::of(step));
        let equations = self.shape.member.equations();
        let gradient =
            solve::gradient::<S, _, Member<S, K>>(&equations, self.hit.part, point, |size: S| Twofold::of(size.real()));
        UnitVec3::from_real(affine.gradient_to_world(gradient).map(|component| component.high))
    }

    /// The line, the hit's `t` in the robust number, and whether that is the surface's: if not, the surface is many
    /// units away.
    fn exact_t(&self, equations: &Equations<S>) -> (Line<S::Robust>, S::Robust, bool) {
        let shape = &self.shape;
        let line = through!(shape, |_primitive, place| ladder::line::<S, _, Member<S, K>>(equations, place, &self.ray));
        let t = <S::Robust as FromScalar<S>>::scalar(self.hit.t);
        let correction =
            solve::correction::<S, _, Member<S, K>>(equations, &self.hit, solve::point_at(&line, t), line.direction);
        // A correction of many units is not one of a rounding error: the tier is `Fast`, or rule 8 has put the hit at
        // the start.
        let most = S::last_place(t.top().unwrap_or(i32::MIN / 2)) + 6;
        let is_rounding = correction.top().is_none_or(|top| top <= most);
        (line, if is_rounding { t + correction } else { t }, is_rounding)
    }

    #[cold]
    fn exact_local_point(&self) -> Vec3<S> {
        let (point, is_on_surface) = self.exact_local_coordinates();
        let point = rounded(point);
        if is_on_surface { point } else { self.on_surface(point) }
    }

    /// The hit in the primitive's frame, and whether it is on the surface.
    #[cold]
    fn exact_local_coordinates(&self) -> ([S::Robust; 3], bool) {
        let (_, t, is_on_surface) = self.exact_t(&self.shape.member.equations());
        let shape = &self.shape;
        let [origin, direction] = through!(shape, |_primitive, place| place.line::<S::Robust>(&self.ray));
        (solve::point_at(&Line { origin, direction }, t), is_on_surface)
    }

    #[cold]
    fn exact_point(&self) -> Vec3<S> {
        let (_, t, is_on_surface) = self.exact_t(&self.shape.member.equations());
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
        let equations = self.shape.member.equations();
        let (line, t, _) = self.exact_t(&equations);
        solve::gradient::<S, _, Member<S, K>>(&equations, self.hit.part, solve::point_at(&line, t), S::Robust::scalar)
    }

    /// The normal at the exact hit; `None` at an apex.
    #[cold]
    fn exact_normal(&self) -> Option<UnitVec3<S>> {
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

    /// The normal on the side that the ray comes from; the outward normal if the ray only touches.
    pub fn normal_towards_ray(&self) -> UnitVec3<S> {
        let normal = self.normal();
        let facing = self.ray.direction().dot(normal);
        let from_inside = self.hit.crossing != Crossing::Touch && facing > S::Real::ZERO;
        if from_inside { -normal } else { normal }
    }

    /// Surface coordinates, each in `[0, 1]`: see [`crate::primitive`].
    pub fn uv(&self) -> (S::Unit, S::Unit) {
        let rough = self.rough_local_point();
        let point = if is_finite(rough) { self.local_point_near(rough) } else { self.coordinates_beyond().0 };
        self.shape.member.uv(point, self.hit.part)
    }

    /// The local point as far as surface coordinates depend on it, and as far as solid coordinates do, where it may be
    /// beyond the number type: coordinates that repeat are less by a whole number, and those that only give an angle
    /// about the axis are less by a factor.
    #[cold]
    fn coordinates_beyond(&self) -> (Vec3<S>, [S; 3]) {
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
            tangents = along_the_surface(normal);
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

    /// The normal at the exact hit in the primitive's frame; `None` at an apex.
    #[cold]
    fn exact_local_normal(&self) -> Option<UnitVec3<S>> {
        let normal = UnitVec3::from_robust(self.exact_gradient())?;
        Some(self.frame_of_a_ball().map_or(normal, |frame| frame.direction_to_local(normal)))
    }

    /// The departure of a ray that leaves from here; `object` is the shape's index in its scene.
    pub const fn departure(&self, object: u32, leaving: Leaving) -> Departure {
        Departure { object, part: self.hit.part, leaving }
    }
}

/// A hit's local point from the rounded `t`, the line's direction in the same coordinates, and the correction of `t`.
struct Correction<R> {
    point: [Twofold<R>; 3],
    direction: [Twofold<R>; 3],
    step: R,
}

impl<R: Real> Correction<R> {
    fn local_point(&self) -> [R; 3] {
        let Self { point, direction, step } = *self;
        pairs(point, direction).map(|(p, d)| p.high + (p.low + d.high * step))
    }
}

/// The tangents around the axis and up, on a surface of revolution about the y axis with this outward normal.
fn along_the_surface<S: Scalar>(normal: UnitVec3<S>) -> (UnitVec3<S>, UnitVec3<S>) {
    let [x, _, z] = normal.real();
    let u = UnitVec3::from_real([z, S::Real::ZERO, -x]).unwrap_or(-UnitVec3::Z);
    let v = UnitVec3::from_real(normal.cross(u)).unwrap_or(UnitVec3::Y);
    (u, v)
}

/// The ball or tube that a part lies on, if it is one.
fn round_solid<S: Scalar>(equations: &Equations<S>, part: Part) -> Option<RoundSolid<S>> {
    match (*equations, part) {
        (Equations::Ball { radius }, _) | (Equations::Capsule { radius, .. }, Part::Base) => {
            Some(RoundSolid { radius, centre: Some(S::ZERO) })
        }
        (Equations::Capsule { radius, height }, Part::Top) => Some(RoundSolid { radius, centre: Some(height) }),
        (Equations::Capsule { radius, .. }, _)
        | (Equations::Round { side: Side::Straight(radius), .. }, Part::Side) => {
            Some(RoundSolid { radius, centre: None })
        }
        _ => None,
    }
}

fn is_finite<S: Scalar>(point: Vec3<S>) -> bool {
    point.x.is_finite() && point.y.is_finite() && point.z.is_finite()
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
    let farthest = S::BUDGET.distance;
    let within = |component: S| {
        if component.is_finite() {
            component
        } else if component < S::ZERO {
            -farthest
        } else {
            farthest
        }
    };
    point.map(S::from_robust).map(within).into()
}
