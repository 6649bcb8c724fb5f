//! The sphere about the origin: `x^2 + y^2 + z^2 = r^2`.

use super::{Geometry, Line, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::arithmetic::Arithmetic;
use crate::figure::Figure;
use crate::part::Part;
use crate::quadric::{Careful, Inside, Quadric};
use crate::scalar::{Plain, PlainLine, Real, Scalar, found};
use crate::span::{End, Meeting, Span};
use crate::vector::{UnitVec3, Vec3, pairs};

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
pub(super) fn ball<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, radius: S) -> Option<Span<S>> {
    let r = T::real(radius);
    let k = line.dot::<T>();
    if !T::COMPENSATES {
        return unit_ball::<S, T>(line, k, r);
    }
    let a = T::squared_length(line.direction);
    let [wx, wy, wz] = line.moment::<T>();
    let quadric = Quadric { a, k, positive: a * (r * r), negative: wx * wx + wy * wy + wz * wz };
    match quadric
        .solve::<S, T>(line, &CarefulBall { o: line.point::<T>(), rest: line.rest::<T>(), d: line.along::<T>(), r })
    {
        Inside::Between(span) => Some(span),
        // a > 0: no other case.
        _ => None,
    }
}

/// The discriminant for a direction that is taken to be exactly unit: `D = r^2 - |o - k d|^2` from the closest approach (Haines,
/// Günther and Akenine-Möller, *Precision Improvements for Ray/Sphere Intersection*, Ray Tracing Gems, 2019).
#[inline]
fn residual<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, k: T::Real, r: T::Real) -> T::Real {
    let [x, y, z] = pairs(line.point::<T>(), line.along::<T>()).map(|(o, d)| o - k * d);
    r * r - (x * x + y * y + z * z)
}

/// The interval in the ball, for a direction that is taken to be exactly unit.
#[inline]
fn unit_ball<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, k: T::Real, r: T::Real) -> Option<Span<S>> {
    let discriminant = residual::<S, T>(line, k, r);
    if discriminant.is_negative() {
        return None;
    }
    let root = discriminant.sqrt();
    let end = |t: T::Real| {
        let t = if line.stretch.is_some() { line.t::<T>(t, T::Real::ONE) } else { T::round(t) };
        End::new(t, Part::Side)
    };
    Some(Span { enter: end(-k - root), exit: end(root - k), touch: root.is_zero() })
}

/// The numbers that the careful coefficients of a ball are made of.
struct CarefulBall<R> {
    o: [R; 3],
    /// What the rounding of `o` left over.
    rest: [R; 3],
    d: [R; 3],
    r: R,
}

impl<R: Real> Careful<R> for CarefulBall<R> {
    #[cold]
    fn k(&self) -> R {
        let ([x, y, z], [u, v, w], [dx, dy, dz]) = (self.o, self.rest, self.d);
        R::sum_of_products([[x, dx], [y, dy], [z, dz], [u, dx], [v, dy], [w, dz]])
    }

    #[cold]
    fn c(&self) -> R {
        let ([x, y, z], [u, v, w], r) = (self.o, self.rest.map(|e| e.times_power_of_two(1)), self.r);
        R::sum_of_products([[x, x], [y, y], [-r, r], [z, z], [x, u], [y, v], [z, w]])
    }

    #[cold]
    fn discriminant(&self) -> R {
        let ([x, y, z], [u, v, w], [dx, dy, dz], r) = (self.o, self.rest, self.d, self.r);
        let [a, ea] = R::sum_with_rest([[dx, dx], [dy, dy], [dz, dz]]);
        let [rr, er] = R::sum_with_rest([[r, r]]);
        let minor =
            |[x, u]: [R; 2], [y, v]: [R; 2], dx: R, dy: R| R::sum_with_rest([[x, dy], [-y, dx], [u, dy], [-v, dx]]);
        let (x, y, z) = ([x, u], [y, v], [z, w]);
        let [[wx, ex], [wy, ey], [wz, ez]] = [minor(y, z, dy, dz), minor(z, x, dz, dx), minor(x, y, dx, dy)];
        let twice = |e: R| -e.times_power_of_two(1);
        R::sum_of_products([
            [a, rr],
            [-wx, wx],
            [-wy, wy],
            [-wz, wz],
            [ea, rr],
            [a, er],
            [twice(ex), wx],
            [twice(ey), wy],
            [twice(ez), wz],
        ])
    }
}

impl<S: Scalar> Geometry<S> for Sphere<S> {
    fn reach(&self) -> S {
        self.radius
    }

    fn scaled(&self, e: i32) -> Self {
        Self { radius: self.radius.scaled(e) }
    }

    #[inline]
    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        if let Some((_, leaving)) = line.departure {
            let (a, k) = (T::squared_length(line.direction), line.dot::<T>());
            let quadric = Quadric { a, k, positive: T::Real::ZERO, negative: T::Real::ZERO };
            let span = match quadric.solve_departing::<S, T>(line, leaving) {
                Inside::Between(span) => Some(span),
                _ => None,
            };
            return Meeting::solid(span).departed(leaving, true);
        }
        Meeting::solid(ball::<S, T>(line, self.radius))
    }

    #[inline(always)]
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>> {
        let [low, high] = found!(S::plain_ball(*line, self.radius, T::COMPENSATES));
        Plain::Found(Meeting::One(Span::new(End::new(low, Part::Side), End::new(high, Part::Side))))
    }

    #[inline(always)]
    fn meets_ahead_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<()> {
        S::plain_ball_ahead(*line, self.radius, T::COMPENSATES)
    }

    /// From outside and moving away: no. From outside and moving closer: as the discriminant says. From inside: yes.
    #[inline]
    fn verdict<T: Arithmetic<S>>(&self, line: &Line<S>) -> Option<bool> {
        let r = T::real(self.radius);
        let [x, y, z] = line.point::<T>();
        let (square, rr) = (x * x + y * y + z * z, r * r);
        let c = square - rr;
        // So close to the surface the sign of c is rounding, and t, which is at least c / 2|o|, may round to zero.
        let grain = T::real(S::BUDGET.smallest_size).times_power_of_two(14);
        if c.abs() < (square + rr).times_power_of_two(-12) || square < grain * grain {
            return None;
        }
        if c.is_negative() {
            return Some(true);
        }
        let k = line.dot::<T>();
        if !k.is_negative() {
            return Some(false);
        }
        if !T::COMPENSATES {
            return Some(!residual::<S, T>(line, k, r).is_negative());
        }
        let [wx, wy, wz] = line.moment::<T>();
        let (positive, negative) = (T::squared_length(line.direction) * rr, wx * wx + wy * wy + wz * wz);
        let discriminant = positive - negative;
        // Grazing: the solver looks closer.
        (discriminant.abs() > positive.times_power_of_two(-3)).then(|| !discriminant.is_negative())
    }

    fn figure(&self) -> Figure<S> {
        Figure::Ball { radius: self.radius }
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
        self.normal(point, part).to_array().map(|component| self.radius.along(component)).into()
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
