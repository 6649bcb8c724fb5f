//! The round cone: two balls about points of the y axis, and all that lies between them.

use super::{
    Capsule, Geometry, SizeError, checked_size, checked_size_or_zero, queries, surface_coordinates as coordinates,
};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{BetweenBalls, Guards};
use crate::intersection::{End, Intersection};
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Ring, Scalar, found, largest};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};
use core::cmp::Ordering;

/// A capsule that tapers: the convex hull of a ball about the origin and another about `(0, height, 0)`.
///
/// The side is the part of the cone that touches both balls, between the circles where it does; base and top are what
/// is left of the balls. With equal radii it is the [`Capsule`]. If one ball holds the other, it is that ball, with its
/// part alone.
///
/// ```
/// use raylet::{Part, Ray, RoundCone, UnitVec3, Vec3};
/// let drop = RoundCone::new(1.0_f32, 0.5, 2.0)?;
/// let ray = Ray::new(Vec3::new(0.0, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits: Vec<_> = drop.hits(&ray).iter().map(|hit| (hit.t, hit.part)).collect();
/// assert_eq!(hits, [(2.5, Part::Top), (6.0, Part::Base)]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundCone<S> {
    /// Of the lower and of the upper ball.
    pub(crate) radii: [S; 2],
    pub(crate) height: S,
}

impl<S: Scalar> RoundCone<S> {
    /// The hull of a ball of `base_radius` about the origin and one of `top_radius` at this height.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a radius is not positive, the height is negative, or one is not finite or beyond the budget.
    pub fn new(base_radius: S, top_radius: S, height: S) -> Result<Self, SizeError> {
        let base = checked_size(base_radius, SizeError::Radius)?;
        let top = checked_size(top_radius, SizeError::Radius)?;
        Ok(Self { radii: [base, top], height: checked_size_or_zero(height, SizeError::Height)? })
    }

    /// The radius of the lower ball.
    pub const fn base_radius(&self) -> S {
        self.radii[0]
    }

    /// The radius of the upper ball.
    pub const fn top_radius(&self) -> S {
        self.radii[1]
    }

    /// The distance between the centres of the balls.
    pub const fn height(&self) -> S {
        self.height
    }

    /// The capsule, if the radii are equal.
    #[inline(always)]
    fn capsule(&self) -> Option<Capsule<S>> {
        let [radius, top] = self.radii;
        (radius == top).then_some(Capsule { radius, height: self.height })
    }

    /// The balls at both ends, on the grid, unless one of them holds the other.
    #[inline(always)]
    fn on_grid<'a, T: Guards>(
        &'a self,
        line: &'a LocalLine<S>,
    ) -> BetweenBalls<'a, S, impl Fn(S) -> Attempt<Ordering> + 'a>
    where
        S: GridScalar,
    {
        let Self { radii, height } = *self;
        let seams = move |t| line.seams_around(t, radii, height, T::GUARDED);
        BetweenBalls { line, seams, radii, height, by_moment: T::GUARDED, is_strict: T::STRICT }
    }

    /// The radius and the centre of a part's ball.
    fn ball(&self, part: Part) -> (S, Vec3<S>) {
        match part {
            Part::Top => (self.radii[1], Vec3::new(S::ZERO, self.height, S::ZERO)),
            _ => (self.radii[0], Vec3::ZERO),
        }
    }

    /// The heights of the circles between the side and the balls, rounded. If one ball holds the other, it has all
    /// heights, and both are infinite.
    pub(crate) fn seams(&self) -> [S; 2] {
        let (side, e) = self.side();
        if side.length.is_zero() {
            return [if side.k.is_negative() { -S::INFINITY } else { S::INFINITY }; 2];
        }
        side.seams().map(|height| S::round(height.scaled(e)))
    }

    /// The radii of both balls, the height, the difference of the radii and the length of the side, divided by `2^e`.
    fn side(&self) -> (Side<S::Real>, i32) {
        let [base, top] = self.radii;
        let e = S::binary_exponent(largest([base, top, self.height]));
        let [base, top, height] = [base, top, self.height].map(|size| size.real().scaled(-e));
        let k = base - top;
        let square = (height - k) * (height + k);
        let length = if square.is_negative() { S::Real::ZERO } else { square.sqrt() };
        (Side { radii: [base, top], height, k, length }, e)
    }
}

/// What a side is computed from.
struct Side<R> {
    radii: [R; 2],
    height: R,
    /// The difference of the radii.
    k: R,
    /// From one tangent point of a generator to the other; zero if one ball holds the other.
    length: R,
}

impl<R: Real> Side<R> {
    /// The heights of the circles at its ends.
    fn seams(&self) -> [R; 2] {
        let ([base, top], sine) = (self.radii, self.k / self.height);
        [base * sine, self.height + top * sine]
    }
}

impl<S: Copy> RoundCone<S> {
    /// The round cone with `f` applied to its sizes.
    #[inline(always)]
    fn map<R>(self, f: impl Fn(S) -> R) -> RoundCone<R> {
        RoundCone { radii: self.radii.map(&f), height: f(self.height) }
    }
}

impl<S> Described for RoundCone<S> {
    const EQUATIONS: EquationKinds = EquationKinds::ROUND_CONE.and(EquationKinds::CAPSULE);
}

impl<S: Scalar> Geometry<S> for RoundCone<S> {
    type In<R: Scalar> = RoundCone<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly))
    }

    fn largest_coordinate(&self) -> S {
        largest(self.radii).plus(self.height)
    }

    #[inline(always)]
    fn radius_about_axis(&self) -> Option<S> {
        Some(largest(self.radii))
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|size| size.scaled(e))
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        match self.capsule() {
            Some(capsule) => capsule.meets_on_grid::<T>(line),
            None => self.on_grid::<T>(line).meets(&found!(line.nappe_around(self.radii, self.height))),
        }
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        if let Some(capsule) = self.capsule() {
            return capsule.exit_on_grid::<T>(line, from);
        }
        let side = if from == Part::Side {
            [found!(line.exit_from_nappe_around(self.radii, self.height)); 2]
        } else {
            let inside = found!(line.nappe_around(self.radii, self.height));
            [inside.ends[1], if inside.are_accurate()[1] { inside.ends[1] } else { S::INFINITY }]
        };
        self.on_grid::<T>(line).exit(side, from)
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::round_cone(ray, self.radii, self.height, goal)
    }

    fn equations(&self) -> Equations<S> {
        match self.capsule() {
            Some(capsule) => capsule.equations(),
            None => Equations::RoundCone { radii: self.radii, height: self.height },
        }
    }

    fn hull(&self) -> Hull<S> {
        let [base, top] = self.radii;
        Hull::Balls([[S::ZERO, base], [self.height, top]])
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        if let Some(capsule) = self.capsule() {
            return capsule.on_surface(point, part);
        }
        if part != Part::Side {
            let (radius, centre) = self.ball(part);
            let along = self.normal(point, part).to_array().map(|component| radius.along(component));
            return Vec3::from(along) + centre;
        }
        let (side, e) = self.side();
        let Side { radii: [base, _], height, k, length } = side;
        if length.is_zero() {
            return self.on_surface(point, if k.is_negative() { Part::Top } else { Part::Base });
        }
        let [low, high] = side.seams();
        let y = point.y.real().scaled(-e);
        let y = if y < low { low } else { y };
        let y = if y > high { high } else { y };
        let radius = ((base * height - k * y) / length).scaled(e);
        let point = Vec3 { y: S::round(y.scaled(e)), ..point };
        coordinates::at_distance(point, |component| S::round(S::unit_real(component) * radius))
    }

    /// On the side its sine with the axis is the difference of the radii over the height.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        if let Some(capsule) = self.capsule() {
            return capsule.normal(point, part);
        }
        match part {
            Part::Base => UnitVec3::new_or(point, -UnitVec3::Y),
            Part::Top => UnitVec3::new_or(point - self.ball(part).1, UnitVec3::Y),
            _ => {
                let (Side { k, length, .. }, _) = self.side();
                let [x, _, z] = coordinates::outwards(point).real();
                UnitVec3::from_real([x * length, k, z * length]).unwrap_or(UnitVec3::Y)
            }
        }
    }

    fn bend(&self, _: Vec3<S>, part: Part) -> S {
        let [base, top] = self.radii;
        match part {
            Part::Base => base,
            Part::Top => top,
            _ => {
                if base < top {
                    base
                } else {
                    top
                }
            }
        }
    }

    /// `v` is the length of the outline from the lowest point, as a fraction of the whole.
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        if let Some(capsule) = self.capsule() {
            return capsule.uv(point, part);
        }
        let (side, e) = self.side();
        let Side { radii: [base, top], height, k, length } = side;
        // Half a turn is 22 / 7 within 1/2000, which is accurate enough for textures, and the parts join without a gap.
        let half_turn = S::Real::from_int(22) / S::Real::from_int(7);
        let latitude = |of: Vec3<S>| S::unit_real(super::sphere::latitude(of));
        // The latitude of the seams on both balls, from pole to pole.
        let seam = if length.is_zero() {
            if k.is_negative() { S::Real::ZERO } else { S::Real::ONE }
        } else {
            latitude(Vec3::new(S::round(length), S::round(k), S::ZERO))
        };
        let (lower, upper) = (base * half_turn * seam, top * half_turn * (S::Real::ONE - seam));
        let along = match part {
            Part::Base => latitude(point) * base * half_turn,
            Part::Top => lower + length + (latitude(point - self.ball(part).1) - seam) * top * half_turn,
            // From the seam, along the side.
            _ => lower + (point.y.real().scaled(-e) - side.seams()[0]) * height / length,
        };
        (coordinates::azimuth(point), coordinates::fraction::<S>(along, lower + length + upper))
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::tangents_around(point, self.normal(point, part))
    }
}

queries!(RoundCone);
