//! The disc in the plane `y = 0`.

use super::cylinder::CarefulTube;
use super::plane::{crossing, moves_away, surface_hit};
use super::{Geometry, Line, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::arithmetic::Arithmetic;
use crate::figure::Figure;
use crate::part::Part;
use crate::quadric::{Inside, Quadric};
use crate::scalar::{Plain, PlainLine, Real, Scalar, UnitScalar, found};
use crate::span::Meeting;
use crate::vector::{UnitVec3, Vec3};

/// A disc about the origin in the plane `y = 0`, its rim included; an open surface whose front is +y.
///
/// ```
/// use raylet::{Disc, Ray, UnitVec3, Vec3};
/// let disc = Disc::new(1.0_f32)?;
/// let ray = Ray::new(Vec3::new(1.0, 2.0, 0.0), -UnitVec3::Y)?;
/// assert!(disc.occludes(&ray));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Disc<S> {
    radius: S,
}

impl<S: Scalar> Disc<S> {
    /// A disc of this radius.
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

impl<S: Scalar> Geometry<S> for Disc<S> {
    fn reach(&self) -> S {
        self.radius
    }

    fn scaled(&self, e: i32) -> Self {
        Self { radius: self.radius.scaled(e) }
    }

    #[inline(always)]
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>> {
        let t = found!(S::plain_disc(*line, self.radius));
        Plain::Found(surface_hit(t, line.direction[1] < S::Unit::ZERO))
    }

    #[inline]
    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        match crossing::<S, T>(line) {
            Meeting::LiesIn(_) => {
                // The chord, by the same quadric as a cylinder's side.
                let ([x, _, z], [dx, _, dz]) = (line.point::<T>(), line.along::<T>());
                let (a, k) = (dx * dx + dz * dz, x * dx + z * dz);
                let (r, wy) = (T::real(self.radius), z * dx - x * dz);
                let quadric = Quadric { a, k, positive: a * (r * r), negative: wy * wy };
                match quadric.solve::<S, T>(line, &CarefulTube::of::<S, T>(line, self.radius)) {
                    Inside::Between(chord) => Meeting::LiesIn(chord),
                    _ => Meeting::Miss,
                }
            }
            meeting => {
                // |p|^2 <= r^2 at p = o - (oy / dy) d, multiplied by dy^2: wx^2 + wz^2 <= (r dy)^2, without a division.
                let [wx, _, wz] = line.moment::<T>();
                let reach = T::real(self.radius) * T::unit(line.direction[1]);
                let (squares, reach) = if S::RELATIVE && reach.abs() < T::Real::ONE.times_power_of_two(-50) {
                    // So nearly in the plane that squares vanish: the crossing itself.
                    let ([x, y, z], [dx, dy, dz], r) = (line.point::<T>(), line.along::<T>(), T::real(self.radius));
                    let t = -y / dy;
                    let (px, pz) = (x + t * dx, z + t * dz);
                    (px * px + pz * pz, r)
                } else {
                    (wx * wx + wz * wz, reach)
                };
                let outside = squares - reach * reach;
                if outside.is_negative() || outside.is_zero() { meeting } else { Meeting::Miss }
            }
        }
    }

    /// Moving away from its plane: no.
    fn verdict<T: Arithmetic<S>>(&self, line: &Line<S>) -> Option<bool> {
        moves_away::<S, T>(line).then_some(false)
    }

    fn figure(&self) -> Figure<S> {
        Figure::Disc { radius: self.radius }
    }

    fn contains(&self, point: Vec3<S>) -> bool {
        let ([x, _, z], r) = (point.real(), self.radius.real());
        let c = S::Real::sum_of_products([[x, x], [-r, r], [z, z]]);
        point.y == S::ZERO && (c.is_negative() || c.is_zero())
    }

    fn bounds(&self) -> (Vec3<S>, Vec3<S>) {
        let r = self.radius;
        (Vec3::new(-r, S::ZERO, -r), Vec3::new(r, S::ZERO, r))
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        Vec3 { y: S::ZERO, ..point }
    }

    fn normal(&self, _: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::Y
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        coordinates::planar(point, self.radius.real())
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::planar_tangents()
    }
}

queries!(Disc);
