//! The plane `y = 0`.

use super::{Geometry, queries, surface_coordinates as coordinates};
use crate::fast::surface_hit;
use crate::figure::Figure;
use crate::geometry::Hull;
use crate::intersection::Intersection;
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::{Plain, PlainLine, Scalar, UnitScalar, found};
use crate::tier::Guards;
use crate::vector::{UnitVec3, Vec3};
use core::marker::PhantomData;

/// The plane `y = 0`, an open surface whose front is +y.
///
/// ```
/// use raylet::{Crossing, Plane, Ray, UnitVec3, Vec3};
/// let ray = Ray::new(Vec3::new(0.0_f32, 2.0, 0.0), -UnitVec3::Y)?;
/// let hit = Plane::new().nearest(&ray);
/// assert_eq!(hit.map(|hit| (hit.t, hit.crossing)), Some((2.0, Crossing::Enter)));
/// # Ok::<(), raylet::RayError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plane<S> {
    scalar: PhantomData<S>,
}

impl<S: Scalar> Plane<S> {
    /// The plane `y = 0`.
    pub const fn new() -> Self {
        Self { scalar: PhantomData }
    }
}

impl<S: Scalar> Geometry<S> for Plane<S> {
    type Doubles = Plane<f64>;

    #[inline(always)]
    fn in_doubles(&self) -> Self::Doubles {
        Plane::new()
    }

    fn reach(&self) -> S {
        S::ZERO
    }

    fn scaled(&self, _: i32) -> Self {
        *self
    }

    #[inline(always)]
    fn meet_plainly<T: Guards>(&self, line: &PlainLine<S>) -> Plain<Intersection<S>> {
        match S::plain_crossings(*line, [S::ZERO; 2]) {
            Plain::Found(([t, _], [off, _])) if S::plain_certain(line, t, off) => {
                Plain::Found(surface_hit(t, line.direction[1] < S::Unit::ZERO))
            }
            // A line that stays in one height may lie in the plane.
            _ => Plain::Unclear,
        }
    }

    /// Moving away from the plane: no.
    #[inline(always)]
    fn meets_ahead_plainly<T: Guards>(&self, line: &PlainLine<S>) -> Plain<()> {
        let (y, dy) = (line.origin[1], line.direction[1]);
        let moves_away = if y < S::ZERO { dy <= S::Unit::ZERO } else { y > S::ZERO && dy >= S::Unit::ZERO };
        if !S::RELATIVE && line.finer == 0 && moves_away {
            return Plain::Miss;
        }
        let meeting = found!(self.meet_plainly::<T>(line));
        if meeting.nearest(Range::FORWARD, |_| true).is_some() { Plain::Found(()) } else { Plain::Miss }
    }

    fn figure(&self) -> Figure<S> {
        Figure::Plane
    }

    fn hull(&self) -> Hull<S> {
        Hull::Discs([[S::ZERO, S::INFINITY]; 2])
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        Vec3 { y: S::ZERO, ..point }
    }

    fn normal(&self, _: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::Y
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        (coordinates::repeating(point.x), coordinates::repeating(point.z))
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::planar_tangents()
    }
}

queries!(Plane);
