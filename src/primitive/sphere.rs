//! The sphere about the origin: `x^2 + y^2 + z^2 = r^2`.

use super::{Geometry, Line, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::hit::Part;
use crate::quadric::{Inside, Quadric};
use crate::scalar::{Real, Scalar};
use crate::span::{Meeting, Span};
use crate::tier::Tier;
use crate::vector::{UnitVec3, Vec3};

/// A ball of the given radius about the origin.
///
/// ```
/// use raylet::{Ray, Sphere, UnitVec3, Vec3};
/// let ball = Sphere::new(1.0_f32)?;
/// // From 4100 away the textbook formula gives 4100 for both ends.
/// let ray = Ray::new(Vec3::new(-4100.0, 0.5, 0.0), UnitVec3::X)?;
/// let hits = ball.hits(&ray);
/// assert_eq!((hits[0].t, hits[1].t), (4099.134, 4100.866));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sphere<S> {
    radius: S,
}

impl<S: Scalar> Sphere<S> {
    /// A sphere of this radius.
    ///
    /// # Errors
    ///
    /// [`SizeError::Radius`] if it is not positive, not finite or beyond the budget.
    pub fn new(radius: S) -> Result<Self, SizeError> {
        Ok(Self { radius: checked_size(radius, SizeError::Radius)? })
    }

    /// The radius.
    pub const fn radius(&self) -> S {
        self.radius
    }
}

/// The interval of a line inside the ball of radius `r` about the origin. `D = a r^2 - |w|^2`.
#[inline]
pub(super) fn ball<S: Scalar, T: Tier<S>>(line: &Line<S>, radius: S) -> Option<Span<S>> {
    let (o, d) = (line.origin, line.direction);
    let r = T::real(radius);
    let a = T::squared_length(d);
    let k = T::dot(o, d);
    let [wx, wy, wz] = T::cross(o, d);
    let discriminant = a * (r * r) - (wx * wx + wy * wy + wz * wz);
    let inside = Quadric { a, k, discriminant }.solve::<S, T>(|| squared_distance::<S, T>(o, radius));
    match inside {
        Inside::Between(span) => Some(span),
        // a > 0: no other case.
        _ => None,
    }
}

/// `c = |o|^2 - r^2`, without cancellation.
fn squared_distance<S: Scalar, T: Tier<S>>(o: [S; 3], radius: S) -> T::Real {
    let ([x, y, z], r) = (o.map(T::real), T::real(radius));
    T::Real::sum_of_products([[x, x], [y, y], [-r, r], [z, z]])
}

impl<S: Scalar> Geometry<S> for Sphere<S> {
    fn reach(&self) -> S {
        self.radius
    }

    fn scaled(&self, e: i32) -> Self {
        Self { radius: self.radius.scaled(e) }
    }

    #[inline]
    fn meet<T: Tier<S>>(&self, line: &Line<S>) -> Meeting<S> {
        if let Some((_, leaving)) = line.departure {
            let (a, k) = (T::squared_length(line.direction), T::dot(line.origin, line.direction));
            let quadric = Quadric { a, k, discriminant: k * k };
            let span = match quadric.solve_departing::<S, T>(leaving) {
                Inside::Between(span) => Some(span),
                _ => None,
            };
            return Meeting::solid(span).departed(leaving, true);
        }
        Meeting::solid(ball::<S, T>(line, self.radius))
    }

    fn contains(&self, point: Vec3<S>) -> bool {
        let [x, y, z] = point.real();
        let r = self.radius.real();
        let c = S::Real::sum_of_products([[x, x], [y, y], [-r, r], [z, z]]);
        c.is_negative() || c.is_zero()
    }

    fn bounds(&self) -> (Vec3<S>, Vec3<S>) {
        let r = self.radius;
        (Vec3::new(-r, -r, -r), Vec3::new(r, r, r))
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        let r = self.radius.real();
        Vec3::round(self.normal(point, part).real().map(|component| component * r))
    }

    fn normal(&self, point: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::new(point).unwrap_or(UnitVec3::Y)
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        (coordinates::azimuth(point), latitude(point))
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        let u = coordinates::around(point);
        let v = UnitVec3::from_real(self.normal(point, part).cross(u)).unwrap_or(UnitVec3::Y);
        (u, v)
    }
}

/// The angle from the lowest point, as a fraction of half a turn.
pub(super) fn latitude<S: Scalar>(point: Vec3<S>) -> S::Unit {
    let [x, y, z] = point.real();
    let from_axis = (x * x + z * z).sqrt();
    let half_turns = S::unit_real(S::turns(from_axis, -y)).times_power_of_two(1);
    coordinates::fraction::<S>(half_turns, S::Real::ONE)
}

queries!(Sphere);
