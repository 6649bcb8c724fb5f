//! The cylinder about the y axis: `x^2 + z^2 = r^2`.

use super::{Geometry, Line, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::arithmetic::Arithmetic;
use crate::figure::{self, Figure, Side};
use crate::part::Part;
use crate::quadric::{Careful, Inside, Quadric, are_close, plain_slab, slab};
use crate::scalar::{Plain, PlainLine, Real, Scalar, UnitScalar, found};
use crate::span::{End, Meeting, Span};
use crate::vector::{UnitVec3, Vec3};

/// How far a cylinder reaches along its axis, and whether it is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Extent<S> {
    Infinite,
    Open(S),
    Capped(S),
}

/// A cylinder about the y axis: infinite, a tube without caps, or closed by flat caps at `y = 0` and `y = height`.
///
/// ```
/// use raylet::{Crossing, Cylinder, Part, Ray, UnitVec3, Vec3};
/// let can = Cylinder::capped(1.0_f32, 2.0)?;
/// let ray = Ray::new(Vec3::new(0.5, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits = can.hits(&ray);
/// assert_eq!((hits[0].t, hits[0].part, hits[0].crossing), (3.0, Part::Top, Crossing::Enter));
/// assert_eq!((hits[1].t, hits[1].part, hits[1].crossing), (5.0, Part::Base, Crossing::Exit));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cylinder<S> {
    radius: S,
    extent: Extent<S>,
}

impl<S: Scalar> Cylinder<S> {
    /// Without ends.
    ///
    /// # Errors
    ///
    /// [`SizeError::Radius`] if the radius is not positive, not finite or beyond the budget.
    pub fn infinite(radius: S) -> Result<Self, SizeError> {
        Ok(Self { radius: checked_size(radius, SizeError::Radius)?, extent: Extent::Infinite })
    }

    /// A tube without caps, `0 <= y <= height`: an open surface.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget.
    pub fn open(radius: S, height: S) -> Result<Self, SizeError> {
        let extent = Extent::Open(checked_size(height, SizeError::Height)?);
        Ok(Self { radius: checked_size(radius, SizeError::Radius)?, extent })
    }

    /// A closed solid with flat caps, `0 <= y <= height`.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget.
    pub fn capped(radius: S, height: S) -> Result<Self, SizeError> {
        let extent = Extent::Capped(checked_size(height, SizeError::Height)?);
        Ok(Self { radius: checked_size(radius, SizeError::Radius)?, extent })
    }

    /// The radius.
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// The height; `None` for an infinite cylinder.
    pub const fn height(&self) -> Option<S> {
        match self.extent {
            Extent::Infinite => None,
            Extent::Open(height) | Extent::Capped(height) => Some(height),
        }
    }
}

/// Where a line is inside the infinite cylinder. `D = a r^2 - w_y^2` with `a = dx^2 + dz^2`.
#[inline]
pub(super) fn tube<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, radius: S) -> Inside<S> {
    let ([x, _, z], [dx, _, dz]) = (line.point::<T>(), line.along::<T>());
    let zero = T::Real::ZERO;
    let a = dx * dx + dz * dz;
    let k = x * dx + z * dz;
    if let Some(leaving) = line.departs_from(Part::Side) {
        return Quadric { a, k, positive: zero, negative: zero }.solve_departing::<S, T>(line, leaving);
    }
    let careful = CarefulTube::of::<S, T>(line, radius);
    if a.is_zero() {
        // Parallel to the axis, or so nearly that a square vanishes, and k with it.
        let c = careful.c();
        return if c.is_zero() {
            Inside::InSurface
        } else if c.is_negative() {
            Inside::Everywhere
        } else {
            Inside::Nowhere
        };
    }
    let r = T::real(radius);
    let wy = z * dx - x * dz;
    let quadric = Quadric { a, k, positive: a * (r * r), negative: wy * wy };
    quadric.solve::<S, T>(line, &careful)
}

/// The numbers that the careful coefficients of a round side are made of: a cylinder's, a capsule's, a disc's rim.
pub(super) struct CarefulTube<R> {
    o: [R; 2],
    /// What the rounding of `o` left over.
    rest: [R; 2],
    d: [R; 2],
    r: R,
}

impl<R: Real> CarefulTube<R> {
    pub(super) fn of<S: Scalar, T: Arithmetic<S, Real = R>>(line: &Line<S>, radius: S) -> Self {
        let ([x, _, z], [u, _, w], [dx, _, dz]) = (line.point::<T>(), line.rest::<T>(), line.along::<T>());
        Self { o: [x, z], rest: [u, w], d: [dx, dz], r: T::real(radius) }
    }
}

impl<R: Real> Careful<R> for CarefulTube<R> {
    #[cold]
    fn k(&self) -> R {
        let ([x, z], [u, w], [dx, dz]) = (self.o, self.rest, self.d);
        R::sum_of_products([[x, dx], [z, dz], [u, dx], [w, dz]])
    }

    #[cold]
    fn c(&self) -> R {
        let ([x, z], [u, w], r) = (self.o, self.rest.map(|e| e.times_power_of_two(1)), self.r);
        R::sum_of_products([[x, x], [-r, r], [z, z], [x, u], [z, w]])
    }

    #[cold]
    fn discriminant(&self) -> R {
        let ([x, z], [u, v], [dx, dz], r) = (self.o, self.rest, self.d, self.r);
        let [a, ea] = R::sum_with_rest([[dx, dx], [dz, dz]]);
        let [rr, er] = R::sum_with_rest([[r, r]]);
        let [w, ew] = R::sum_with_rest([[z, dx], [-x, dz], [v, dx], [-u, dz]]);
        R::sum_of_products([[a, rr], [-w, w], [ea, rr], [a, er], [-ew.times_power_of_two(1), w]])
    }
}

impl<S: Scalar> Geometry<S> for Cylinder<S> {
    fn reach(&self) -> S {
        self.height().map_or(self.radius, |height| self.radius.plus(height))
    }

    fn is_far(&self, origin: Vec3<S>) -> bool {
        if self.height().is_some() {
            return true;
        }
        let ([x, _, z], r) = (origin.real(), self.radius.real().times_power_of_two(2));
        x * x + z * z > r * r
    }

    fn scaled(&self, e: i32) -> Self {
        let extent = match self.extent {
            Extent::Infinite => Extent::Infinite,
            Extent::Open(height) => Extent::Open(height.scaled(e)),
            Extent::Capped(height) => Extent::Capped(height.scaled(e)),
        };
        Self { radius: self.radius.scaled(e), extent }
    }

    #[inline]
    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        let side = match tube::<S, T>(line, self.radius) {
            Inside::Between(span) => span,
            // A line in the wall lies in the surface; in the closed solid it runs from rim to rim.
            Inside::InSurface => match self.extent {
                Extent::Infinite => return Meeting::LiesIn(Span::everywhere()),
                Extent::Open(height) => return lies_in_wall::<S, T>(line, height),
                Extent::Capped(height) => {
                    let through = capped::<S, T>(line, Span::everywhere(), Some(S::ZERO), Some(height));
                    return through.along_the_side();
                }
            },
            Inside::Everywhere => Span::everywhere(),
            // A departing ray parallel to the axis runs in the wall.
            Inside::From(_) | Inside::Until(_) => Span::everywhere(),
            // A ray that departs inwards from a cap's rim has a far end, even if its start is just outside of the side.
            Inside::Nowhere if line.departure.is_some() && matches!(self.extent, Extent::Capped(_)) => {
                let [dx, _, dz] = line.along::<T>();
                if dx.is_zero() && dz.is_zero() {
                    Span::everywhere()
                } else {
                    Span::new(End::none(-S::INFINITY), End::new(S::ZERO, Part::Side))
                }
            }
            Inside::Nowhere | Inside::Beyond(..) => return Meeting::Miss,
        };
        let meeting = match self.extent {
            Extent::Infinite => Meeting::One(side),
            Extent::Open(height) => open_side::<S, T>(line, side, S::ZERO, height),
            Extent::Capped(height) => return capped::<S, T>(line, side, Some(S::ZERO), Some(height)),
        };
        match line.departure {
            Some((_, leaving)) => meeting.departed(leaving, true),
            None => meeting,
        }
    }

    #[inline(always)]
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>> {
        let [low, high] = found!(S::plain_tube(*line, self.radius));
        let side = Span::new(End::new(low, Part::Side), End::new(high, Part::Side));
        let (Extent::Open(height) | Extent::Capped(height)) = self.extent else {
            return Plain::Found(Meeting::One(side));
        };
        let between = found!(plain_slab(line, S::ZERO, height));
        if are_close(&side, &between) {
            return Plain::Unclear;
        }
        Plain::Found(match self.extent {
            Extent::Open(_) => between_rims(side, between),
            _ => Meeting::solid(side.intersection(between)),
        })
    }

    /// Above the top and rising, or below the base and descending: no.
    #[inline]
    fn verdict<T: Arithmetic<S>>(&self, line: &Line<S>) -> Option<bool> {
        let height = self.height()?;
        leaves_slab::<S, T>(line, S::ZERO, height).then_some(false)
    }

    fn figure(&self) -> Figure<S> {
        let extent = match self.extent {
            Extent::Infinite => figure::Extent::Infinite,
            Extent::Open(height) => figure::Extent::Open(height),
            Extent::Capped(height) => figure::Extent::Capped(Some(S::ZERO), Some(height)),
        };
        Figure::Round { side: Side::Straight(self.radius), extent }
    }

    fn contains(&self, point: Vec3<S>) -> bool {
        let [x, _, z] = point.real();
        let r = self.radius.real();
        let c = S::Real::sum_of_products([[x, x], [-r, r], [z, z]]);
        let between = self.height().is_none_or(|height| S::ZERO <= point.y && point.y <= height);
        between && (c.is_zero() || c.is_negative() && !matches!(self.extent, Extent::Open(_)))
    }

    fn bounds(&self) -> (Vec3<S>, Vec3<S>) {
        let r = self.radius;
        let (low, high) = self.height().map_or((-S::INFINITY, S::INFINITY), |height| (S::ZERO, height));
        (Vec3::new(-r, low, -r), Vec3::new(r, high, r))
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        match (part, self.height()) {
            (Part::Base, Some(_)) => Vec3 { y: S::ZERO, ..point },
            (Part::Top, Some(height)) => Vec3 { y: height, ..point },
            (_, height) => {
                let point = height.map_or(point, |height| coordinates::between(point, height));
                coordinates::at_distance(point, |component| self.radius.along(component))
            }
        }
    }

    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Base => -UnitVec3::Y,
            Part::Top => UnitVec3::Y,
            Part::Side => coordinates::outwards(point),
        }
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        match (part, self.height()) {
            (Part::Side, Some(height)) => {
                (coordinates::azimuth(point), coordinates::fraction::<S>(point.y.real(), height.real()))
            }
            (Part::Side, None) => (coordinates::azimuth(point), coordinates::repeating(point.y)),
            _ => coordinates::planar(point, self.radius.real()),
        }
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        match part {
            Part::Side => (coordinates::around(point), UnitVec3::Y),
            Part::Base | Part::Top => coordinates::planar_tangents(),
        }
    }
}

/// True if the half-line starts above or below and never comes back.
#[inline]
pub(super) fn leaves_slab<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, low: S, high: S) -> bool {
    let [_, dy, _] = line.along::<T>();
    line.is_clear_of(high, false) && !dy.is_negative()
        || line.is_clear_of(low, true) && (dy.is_negative() || dy.is_zero())
}

/// The ends of `side` that lie between the rims of an open surface; the rims belong to it.
pub(super) fn open_side<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, side: Span<S>, low: S, high: S) -> Meeting<S> {
    slab::<S, T>(line, Some(low), Some(high)).map_or(Meeting::Miss, |between| between_rims(side, between))
}

/// The ends of `side` that lie in the slab between the rims; the rims belong to it.
#[inline(always)]
pub(super) fn between_rims<S: Scalar>(side: Span<S>, between: Span<S>) -> Meeting<S> {
    let on_surface = |end: End<S>| between.enter.t <= end.t && end.t <= between.exit.t;
    let (enter, exit) = (on_surface(side.enter), on_surface(side.exit));
    if !enter && !exit {
        return Meeting::Miss;
    }
    Meeting::Surface(Span {
        enter: if enter { side.enter } else { End::none(-S::INFINITY) },
        exit: if exit { side.exit } else { End::none(S::INFINITY) },
        touch: side.touch,
    })
}

/// The piece of a line in the wall that lies between the rims.
fn lies_in_wall<S: Scalar, T: Arithmetic<S>>(line: &Line<S>, height: S) -> Meeting<S> {
    slab::<S, T>(line, Some(S::ZERO), Some(height)).map_or(Meeting::Miss, Meeting::LiesIn)
}

/// A convex side closed by planes: rule 1, with the departure of rule 8. A missing plane is infinitely far.
pub(super) fn capped<S: Scalar, T: Arithmetic<S>>(
    line: &Line<S>,
    side: Span<S>,
    low: Option<S>,
    high: Option<S>,
) -> Meeting<S> {
    let [_, dy, _] = line.direction;
    let Some((part, leaving)) = line.departure else {
        return Meeting::solid(slab::<S, T>(line, low, high).and_then(|caps| side.intersection(caps)));
    };
    if leaving == crate::ray::Leaving::Outwards {
        return Meeting::Miss;
    }
    // Inwards: the far end is met, whatever the rounding of the start says. A start on a cap is exactly on its
    // plane, so that the plane's own end is not the far one.
    let (low, high) = match part {
        Part::Base => (None, high),
        Part::Top => (low, None),
        Part::Side => (low, high),
    };
    let caps = slab::<S, T>(line, low, high).unwrap_or(Span::everywhere());
    let exit = if caps.exit.t < side.exit.t { caps.exit } else { side.exit };
    // A ray that leads away from the cap that it is said to enter ends where it starts.
    let astray = match part {
        Part::Base => dy < S::Unit::ZERO,
        Part::Top => dy > S::Unit::ZERO,
        Part::Side => false,
    };
    let exit = if astray { End::new(S::ZERO, part) } else { exit };
    let exit = if exit.t < S::ZERO { End::new(S::ZERO, exit.part) } else { exit };
    Meeting::One(Span::new(End::none(-S::INFINITY), exit))
}

queries!(Cylinder);
