//! The plane `y = 0`.

use super::{Geometry, Line, queries, surface_coordinates as coordinates};
use crate::arithmetic::Arithmetic;
use crate::figure::Figure;
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::{Plain, PlainLine, Real, Scalar, UnitScalar, found};
use crate::span::{End, Meeting, Span};
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

/// Where a line crosses `y = 0`: at `t = -oy / dy`, from the front if it descends.
#[inline]
pub(super) fn crossing<S: Scalar, T: Arithmetic<S>>(line: &Line<S>) -> Meeting<S> {
    if line.departure.is_some() {
        // Rule 8: a straight line leaves a plane for good.
        return Meeting::Miss;
    }
    let ([_, y, _], [_, rest, _], [_, dy, _]) = (line.point::<T>(), line.rest::<T>(), line.along::<T>());
    let y = y + rest;
    if dy.is_zero() {
        return if y.is_zero() { Meeting::LiesIn(Span::everywhere()) } else { Meeting::Miss };
    }
    surface_hit(line.t::<T>(-y, dy), dy.is_negative())
}

/// True if the half-line starts off the plane `y = 0` and does not come closer.
#[inline]
pub(super) fn moves_away<S: Scalar, T: Arithmetic<S>>(line: &Line<S>) -> bool {
    let [_, dy, _] = line.along::<T>();
    line.is_clear_of(S::ZERO, false) && !dy.is_negative()
        || line.is_clear_of(S::ZERO, true) && (dy.is_negative() || dy.is_zero())
}

/// The one crossing of a flat surface, from its front or its back.
#[inline]
pub(super) fn surface_hit<S: Scalar>(t: S, from_front: bool) -> Meeting<S> {
    let end = End::new(t, Part::Side);
    Meeting::Surface(if from_front {
        Span::new(end, End::none(S::INFINITY))
    } else {
        Span::new(End::none(-S::INFINITY), end)
    })
}

impl<S: Scalar> Geometry<S> for Plane<S> {
    fn reach(&self) -> S {
        S::ZERO
    }

    /// Never: `-oy / dy` loses nothing however far along the plane the ray starts, and walking there would.
    fn is_far(&self, _: Vec3<S>) -> bool {
        false
    }

    fn scaled(&self, _: i32) -> Self {
        *self
    }

    #[inline(always)]
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>> {
        match S::plain_crossings(*line, [S::ZERO; 2]) {
            Plain::Found([t, _]) => Plain::Found(surface_hit(t, line.direction[1] < S::Unit::ZERO)),
            // A line that stays in one height may lie in the plane.
            Plain::Miss | Plain::Unclear => Plain::Unclear,
        }
    }

    /// Moving away from the plane: no.
    #[inline(always)]
    fn meets_ahead_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<()> {
        let (y, dy) = (line.origin[1], line.direction[1]);
        let moves_away = if y < S::ZERO { dy <= S::Unit::ZERO } else { y > S::ZERO && dy >= S::Unit::ZERO };
        if !S::RELATIVE && line.finer == 0 && moves_away {
            return Plain::Miss;
        }
        let meeting = found!(self.meet_plainly::<T>(line));
        if meeting.nearest(Range::FORWARD, |_| true).is_some() { Plain::Found(()) } else { Plain::Miss }
    }

    #[inline]
    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        crossing::<S, T>(line)
    }

    /// Moving away from the plane: no.
    fn verdict<T: Arithmetic<S>>(&self, line: &Line<S>) -> Option<bool> {
        moves_away::<S, T>(line).then_some(false)
    }

    fn figure(&self) -> Figure<S> {
        Figure::Plane
    }

    fn contains(&self, point: Vec3<S>) -> bool {
        point.y == S::ZERO
    }

    fn bounds(&self) -> (Vec3<S>, Vec3<S>) {
        (Vec3::new(-S::INFINITY, S::ZERO, -S::INFINITY), Vec3::new(S::INFINITY, S::ZERO, S::INFINITY))
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        Vec3 { y: S::ZERO, ..point }
    }

    fn normal(&self, _: Vec3<S>, _: Part) -> UnitVec3<S> {
        UnitVec3::Y
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        (coordinates::repeating(point.x), coordinates::repeating(point.z))
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        coordinates::planar_tangents()
    }
}

queries!(Plane);
