//! The capsule: a cylinder with round ends, all points within `r` of the segment from the origin to (0, height, 0).

use super::cylinder::{leaves_slab, tube};
use super::sphere::ball;
use super::{
    Geometry, Line, SizeError, checked_size, checked_size_or_zero, queries, surface_coordinates as coordinates,
};
use crate::arithmetic::Arithmetic;
use crate::figure::Figure;
use crate::part::Part;
use crate::quadric::{Inside, slab};
use crate::ray::Leaving;
use crate::scalar::{Plain, PlainLine, Real, Scalar, found};
use crate::span::{End, Meeting, Span};
use crate::vector::{UnitVec3, Vec3};

/// A cylinder with hemispherical caps; its height excludes them. Also: a sphere swept along a segment.
///
/// ```
/// use raylet::{Capsule, Part, Ray, UnitVec3, Vec3};
/// let pill = Capsule::new(1.0_f32, 2.0)?;
/// let ray = Ray::new(Vec3::new(0.0, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits = pill.hits(&ray);
/// assert_eq!((hits[0].t, hits[0].part), (2.0, Part::Top));
/// assert_eq!((hits[1].t, hits[1].part), (6.0, Part::Base));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Capsule<S> {
    radius: S,
    height: S,
}

impl<S: Scalar> Capsule<S> {
    /// A capsule of this radius whose straight side has this height; zero makes it a sphere.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the radius is not positive, the height is negative, or one is not finite or beyond the budget.
    pub fn new(radius: S, height: S) -> Result<Self, SizeError> {
        Ok(Self {
            radius: checked_size(radius, SizeError::Radius)?,
            height: checked_size_or_zero(height, SizeError::Height)?,
        })
    }

    /// The radius of the side and of the ends.
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// The height of the straight side.
    pub const fn height(&self) -> S {
        self.height
    }

    /// The line as the ball at the given end sees it.
    fn seen_from(&self, line: &Line<S>, part: Part) -> Line<S> {
        if part != Part::Top {
            return *line;
        }
        if line.finer == 0 {
            let ([x, y, z], [u, v, w]) = (line.origin, line.rest);
            let [y, rest] = y.minus_with_rest(self.height);
            return Line { origin: [x, y, z], rest: [u, v.plus(rest), w], ..*line };
        }
        let [x, y, z] = [0, 1, 2].map(|i| line.coordinate(i));
        let (origin, finer) = S::finest([x, y - self.height.real(), z]);
        Line { origin, finer, ..*line }
    }

    /// The true end for one of the infinite tube (`None`: the line is parallel to it): on the side between the seams,
    /// which it owns, and on the ball beyond them.
    fn end<T: Arithmetic<S>>(&self, line: &Line<S>, tube: Option<S>, entering: bool) -> Option<End<S>> {
        let rising = line.direction[1] > <S::Unit as crate::scalar::UnitScalar>::ZERO;
        let part = if let Some(tube) = tube {
            // Beyond what the type reaches, the height at the last t that it reaches tells whether a ball ends it before.
            let farthest = S::BUDGET.distance;
            let reached = if tube > farthest {
                farthest
            } else if tube < -farthest {
                -farthest
            } else {
                tube
            };
            let y = line.height_at(reached);
            if y < S::ZERO {
                Part::Base
            } else if y > self.height {
                Part::Top
            } else {
                return Some(End::new(tube, Part::Side));
            }
        } else if rising == entering {
            Part::Base
        } else {
            Part::Top
        };
        let span = ball::<S, T>(&self.seen_from(line, part), self.radius)?;
        Some(End::new(if entering { span.enter.t } else { span.exit.t }, part))
    }

    /// [`Capsule::end`], if the short way tells.
    #[inline]
    fn plain_end<T: Arithmetic<S>>(&self, line: &PlainLine<S>, tube: S, entering: bool) -> Plain<End<S>> {
        let y = found!(S::plain_height(*line, tube, [S::ZERO, self.height]));
        let (part, centre) = if y < S::ZERO {
            (Part::Base, S::ZERO)
        } else if y > self.height {
            (Part::Top, self.height)
        } else {
            return Plain::Found(End::new(tube, Part::Side));
        };
        let [low, high] = found!(S::plain_ball(found!(S::plain_lowered(*line, centre)), self.radius, T::COMPENSATES));
        Plain::Found(End::new(if entering { low } else { high }, part))
    }

    /// The point of the axis's segment nearest to a point of the part.
    fn centre(&self, part: Part) -> Vec3<S> {
        if part == Part::Top { Vec3::new(S::ZERO, self.height, S::ZERO) } else { Vec3::ZERO }
    }
}

impl<S: Scalar> Geometry<S> for Capsule<S> {
    fn reach(&self) -> S {
        self.radius.plus(self.height)
    }

    fn scaled(&self, e: i32) -> Self {
        Self { radius: self.radius.scaled(e), height: self.height.scaled(e) }
    }

    #[inline(always)]
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>> {
        let [low, high] = found!(S::plain_tube(*line, self.radius));
        let enter = found!(self.plain_end::<T>(line, low, true));
        let exit = found!(self.plain_end::<T>(line, high, false));
        Plain::Found(if enter.t > exit.t { Meeting::Miss } else { Meeting::One(Span::new(enter, exit)) })
    }

    #[inline]
    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        if let Some((part, leaving)) = line.departure {
            return self.meet_departing::<T>(line, part, leaving);
        }
        // The balls lie in the infinite tube, and where a line runs in the tube beyond a ball without meeting it,
        // it does not come back to the side: each end of the tube has one true end, or there is none at all.
        let (low, high, touch) = match tube::<S, T>(line, self.radius) {
            Inside::Between(span) => (Some(span.enter.t), Some(span.exit.t), span.touch),
            Inside::Everywhere => (None, None, false),
            // From seam to seam, where the balls touch the line; without a side they touch it at one point.
            Inside::InSurface => {
                let between = slab::<S, T>(line, Some(S::ZERO), Some(self.height));
                let touch = self.height == S::ZERO;
                return Meeting::solid(between.map(|span| Span { touch, ..span })).along_the_side();
            }
            _ => return Meeting::Miss,
        };
        let (Some(enter), Some(exit)) = (self.end::<T>(line, low, true), self.end::<T>(line, high, false)) else {
            return Meeting::Miss;
        };
        if enter.t > exit.t {
            return Meeting::Miss;
        }
        // Both ends on one ball coincide only where the ball is touched.
        let round_touch = enter.part == exit.part
            && enter.part != Part::Side
            && ball::<S, T>(&self.seen_from(line, enter.part), self.radius).is_some_and(|span| span.touch);
        let touch = touch || round_touch;
        // One point, whatever its two roundings.
        Meeting::One(Span { enter, exit: if touch { enter } else { exit }, touch })
    }

    /// Above the top ball and rising, or below the base ball and descending: no.
    fn verdict<T: Arithmetic<S>>(&self, line: &Line<S>) -> Option<bool> {
        leaves_slab::<S, T>(line, -self.radius, self.height.plus(self.radius)).then_some(false)
    }

    fn figure(&self) -> Figure<S> {
        Figure::Capsule { radius: self.radius, height: self.height }
    }

    fn contains(&self, point: Vec3<S>) -> bool {
        let [x, y, z] = point.real();
        let r = self.radius.real();
        let y = if point.y < S::ZERO {
            y
        } else if point.y > self.height {
            y - self.height.real()
        } else {
            S::Real::ZERO
        };
        let c = S::Real::sum_of_products([[x, x], [y, y], [-r, r], [z, z]]);
        c.is_negative() || c.is_zero()
    }

    fn bounds(&self) -> (Vec3<S>, Vec3<S>) {
        let r = self.radius;
        (Vec3::new(-r, -r, -r), Vec3::new(r, self.height.plus(r), r))
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        if part == Part::Side {
            return coordinates::at_distance(point, |component| self.radius.along(component));
        }
        Vec3::from(self.normal(point, part).to_array().map(|component| self.radius.along(component)))
            + self.centre(part)
    }

    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Side => coordinates::outwards(point),
            Part::Base => UnitVec3::new(point).unwrap_or(-UnitVec3::Y),
            Part::Top => UnitVec3::new(point - self.centre(part)).unwrap_or(UnitVec3::Y),
        }
    }

    /// `v` is the length of the outline from the lowest point, as a fraction of the whole.
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        // An eighth of each, so that the whole outline of the largest capsule is a number.
        let [radius, height, y] = [self.radius, self.height, point.y].map(|size| size.real().times_power_of_two(-3));
        // An arc of a quarter turn: r pi / 2, with pi / 2 = 11 / 7 within 1/2000; texture needs no more, but ends must meet.
        let quarter = radius * (S::Real::from_int(11) / S::Real::from_int(7));
        let along = match part {
            Part::Base => S::unit_real(super::sphere::latitude(point)) * quarter.times_power_of_two(1),
            Part::Side => quarter + y,
            Part::Top => {
                height
                    + S::unit_real(super::sphere::latitude(point - self.centre(part))) * quarter.times_power_of_two(1)
            }
        };
        (coordinates::azimuth(point), coordinates::fraction::<S>(along, height + quarter.times_power_of_two(1)))
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        let u = coordinates::around(point);
        let v = UnitVec3::from_real(self.normal(point, part).cross(u)).unwrap_or(UnitVec3::Y);
        (u, v)
    }
}

impl<S: Scalar> Capsule<S> {
    /// Rule 8: outwards nothing; inwards the far end, and `c = 0` on the quadric that the ray left.
    #[cold]
    fn meet_departing<T: Arithmetic<S>>(&self, line: &Line<S>, part: Part, leaving: Leaving) -> Meeting<S> {
        if leaving == Leaving::Outwards {
            return Meeting::Miss;
        }
        let far = match tube::<S, T>(line, self.radius) {
            Inside::Between(span) => Some(if span.exit.t < S::ZERO { S::ZERO } else { span.exit.t }),
            Inside::Nowhere => Some(S::ZERO),
            _ => None,
        };
        let arriving = Line { departure: None, ..*line };
        let mut exit = self.end::<T>(&arriving, far, false).unwrap_or(End::new(S::ZERO, part));
        if exit.part == part && part != Part::Side {
            // Across the ball that it left: the other root.
            let ball_line = self.seen_from(line, part);
            let (a, k) = (T::squared_length(line.direction), ball_line.dot::<T>());
            exit.t = line.t::<T>(k.abs().times_power_of_two(1), a);
        }
        if exit.t < S::ZERO {
            exit.t = S::ZERO;
        }
        Meeting::One(Span::new(End::none(-S::INFINITY), exit))
    }
}

queries!(Capsule);
