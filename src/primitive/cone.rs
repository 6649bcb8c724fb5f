//! The cone about the y axis.

use super::{Geometry, SizeError, checked_size, checked_size_or_zero, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{Guards, Slab, whole_side};
use crate::intersection::{End, Intersection, Span};
use crate::outline::{Extent, Outline};
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Scalar, ValueError, found, largest};
use crate::solve::{self, Goal, LocalRay, Of, Profile};
use crate::vector::{UnitVec3, Vec3};

/// A cone about the y axis: double (both nappes, infinite), one infinite nappe, or of finite height, open or with flat
/// caps.
///
/// The slope is the radius divided by the distance from the apex along the axis.
///
/// ```
/// use raylet::{Cone, Crossing, Part, Ray, UnitVec3, Vec3};
/// let cone = Cone::capped(1.0_f32, 1.0)?;
/// // Through the apex, along the axis.
/// let ray = Ray::new(Vec3::new(0.0, -2.0, 0.0), UnitVec3::Y)?;
/// let hits = cone.hits(&ray);
/// assert_eq!((hits[0].t, hits[0].part, hits[0].crossing), (2.0, Part::Side, Crossing::Enter));
/// assert_eq!((hits[1].t, hits[1].part, hits[1].crossing), (3.0, Part::Top, Crossing::Exit));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone<S> {
    pub(super) outline: Outline<S>,
    pub(super) extent: Extent<S>,
}

impl<S: Scalar> Cone<S> {
    /// How far the side reaches.
    pub(crate) const fn extent(&self) -> &Extent<S> {
        &self.extent
    }

    /// Two infinite nappes: `x^2 + z^2 = slope^2 y^2`.
    ///
    /// # Errors
    ///
    /// [`SizeError::Slope`] if the slope is not positive, not finite or beyond the budget.
    pub fn double(slope: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_slope(slope)?, extent: Extent::Double })
    }

    /// The infinite nappe above the apex.
    ///
    /// # Errors
    ///
    /// [`SizeError::Slope`] if the slope is not positive, not finite or beyond the budget.
    pub fn nappe(slope: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_slope(slope)?, extent: Extent::Infinite })
    }

    /// The side from the apex up to `y = height`, without a cap: an open surface.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the slope or the height is not positive, not finite or beyond the budget.
    pub fn open(slope: S, height: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_slope(slope)?, extent: Extent::Open(checked_size(height, SizeError::Height)?) })
    }

    /// A closed cone from the apex up to a flat cap at `y = height`, whose radius is exactly `slope * height`.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the slope or the height is not positive, not finite or beyond the budget.
    pub fn capped(slope: S, height: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_slope(slope)?, extent: Extent::Capped(checked_size(height, SizeError::Height)?) })
    }

    /// The side of a truncated cone: radius `base_radius` at `y = 0` and `top_radius` at `y = height`; an open surface.
    /// One radius may be zero, and they may be equal.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the height is not positive, a radius is negative, both are zero, or a size is not finite or
    /// beyond the budget.
    pub fn frustum_open(base_radius: S, top_radius: S, height: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_radii(base_radius, top_radius, height)?, extent: Extent::Open(height) })
    }

    /// A closed truncated cone; sizes as for [`Cone::frustum_open`].
    ///
    /// # Errors
    ///
    /// As for [`Cone::frustum_open`].
    pub fn frustum(base_radius: S, top_radius: S, height: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_radii(base_radius, top_radius, height)?, extent: Extent::Capped(height) })
    }

    /// The height; `None` for an infinite cone.
    pub const fn height(&self) -> Option<S> {
        self.extent.height()
    }

    /// The slope, which is the radius at the height 1; `None` for a frustum, which has two radii instead.
    ///
    /// ```
    /// use raylet::Cone;
    ///
    /// assert_eq!(Cone::double(0.5_f32)?.slope(), Some(0.5));
    /// assert_eq!(Cone::frustum(2.0_f32, 1.0, 4.0)?.slope(), None);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub const fn slope(&self) -> Option<S> {
        match self.outline {
            Outline::Slope(slope) => Some(slope),
            Outline::Radii(..) => None,
        }
    }

    /// The radius at `y = 0`; zero if the apex is there.
    pub const fn base_radius(&self) -> S {
        match self.outline {
            Outline::Slope(_) => S::ZERO,
            Outline::Radii(base, _, _) => base,
        }
    }

    /// The radius at the height, rounded; `None` for an infinite cone.
    pub fn top_radius(&self) -> Option<S> {
        match self.outline {
            Outline::Slope(slope) => self.height().map(|height| S::round(slope.real() * height.real())),
            Outline::Radii(_, top, _) => Some(top),
        }
    }
}

/// The outline of a cone of this slope, if that is within the budget.
pub(super) fn checked_slope<S: Scalar>(slope: S) -> Result<Outline<S>, SizeError> {
    // The comparison is false for NaN.
    if slope >= S::BUDGET.smallest_slope && slope <= S::BUDGET.slope {
        Ok(Outline::Slope(slope))
    } else {
        Err(SizeError::Slope(ValueError::of_size(slope, S::BUDGET.smallest_slope)))
    }
}

fn checked_radii<S: Scalar>(base: S, top: S, height: S) -> Result<Outline<S>, SizeError> {
    let base = checked_size_or_zero(base, SizeError::Radius)?;
    let top = checked_size_or_zero(top, SizeError::Radius)?;
    if base == S::ZERO && top == S::ZERO {
        return Err(SizeError::Radius(ValueError::Zero));
    }
    Ok(Outline::Radii(base, top, checked_size(height, SizeError::Height)?))
}

impl<S: Scalar> Cone<S> {
    /// The line's interval between the two heights, if the grid is sure. At an end that is an apex there is no plane.
    #[inline(always)]
    fn grid_slab<T: Guards>(&self, line: &LocalLine<S>, height: S) -> Attempt<Slab<S>>
    where
        S: GridScalar,
    {
        let mut slab = found!(Slab::new::<T>(line, S::ZERO, height));
        if let Extent::Capped(_) = self.extent {
            let (between, [base, top]) = (&mut slab.span, solve::caps(&self.outline));
            let is_plane = |part: Part| if part == Part::Base { base } else { top };
            if !is_plane(between.enter.part) {
                between.enter = End::none(-S::INFINITY);
            }
            if !is_plane(between.exit.part) {
                between.exit = End::none(S::INFINITY);
            }
        }
        Attempt::Hit(slab)
    }
}

impl<S: Copy> Cone<S> {
    /// The cone with `of_slope` applied to its slope, or `of_size` to its sizes.
    #[inline(always)]
    fn map<R>(self, of_slope: impl Fn(S) -> R, of_size: impl Fn(S) -> R) -> Cone<R> {
        Cone { outline: self.outline.map(of_slope, &of_size), extent: self.extent.map(of_size) }
    }
}

impl<S> Described for Cone<S> {
    const EQUATIONS: EquationKinds = EquationKinds::CONE;
}

impl<S: Scalar> Geometry<S> for Cone<S> {
    type In<R: Scalar> = Cone<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(self.map(R::exactly, R::exactly))
    }

    fn largest_coordinate(&self) -> S {
        match (self.outline, self.height()) {
            (Outline::Radii(base, top, height), _) => base.plus(top).plus(height),
            (Outline::Slope(slope), Some(height)) => S::round(slope.real() * height.real()).plus(height),
            // An infinite cone from its apex has no characteristic size.
            (Outline::Slope(_), None) => S::ZERO,
        }
    }

    #[inline(always)]
    fn radius_about_axis(&self) -> Option<S> {
        match self.outline {
            Outline::Radii(base, top, _) => Some(if base > top { base } else { top }),
            // The product of a slope and a height would cost too much in fixed point.
            Outline::Slope(_) if S::RELATIVE => self.top_radius(),
            Outline::Slope(_) => None,
        }
    }

    fn scaled(&self, e: i32) -> Self {
        self.map(|slope| slope, |size| size.scaled(e))
    }

    #[inline(always)]
    fn lengths(&self) -> S {
        match self.outline {
            Outline::Radii(base, top, height) => base.plus(top).plus(height),
            Outline::Slope(_) => self.height().unwrap_or(S::ZERO),
        }
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        if let (Extent::Double, Outline::Slope(slope)) = (self.extent, self.outline) {
            let ([first, second], beyond) = found!(line.double_cone(slope));
            let (first, second) = (End::new(first, Part::Side), End::new(second, Part::Side));
            return Attempt::Hit(if beyond {
                let (until, from) = (End::none(-S::INFINITY), End::none(S::INFINITY));
                Intersection::Two(Span::new(until, first), Span::new(second, from))
            } else {
                Intersection::One(Span::new(first, second))
            });
        }
        let inside = found!(line.nappe(self.outline));
        match self.extent {
            Extent::Double | Extent::Infinite => Attempt::Hit(Intersection::One(found!(whole_side(&inside)))),
            Extent::Open(height) => found!(self.grid_slab::<T>(line, height)).rims(&inside),
            Extent::Capped(height) => found!(self.grid_slab::<T>(line, height)).clip(&inside),
        }
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        match self.extent {
            Extent::Open(_) => return Attempt::Unsure,
            Extent::Double => {
                // The chord stays in the nappe in which it begins. The lower nappe is the mirror image of the upper
                // one.
                let line = if line.origin[1] < S::ZERO { line.mirrored() } else { *line };
                let exit = found!(line.exit_from_nappe(self.outline));
                return Attempt::Hit(End::new(exit, Part::Side));
            }
            Extent::Infinite | Extent::Capped(_) => {}
        }
        let (side, is_certain) = if from == Part::Side {
            (found!(line.exit_from_nappe(self.outline)), true)
        } else {
            let inside = found!(line.nappe(self.outline));
            (inside.ends[1], inside.are_accurate()[1])
        };
        let side = End::new(side, Part::Side);
        let Extent::Capped(height) = self.extent else { return Attempt::Hit(side) };
        let slab = found!(self.grid_slab::<T>(line, height));
        // An end of the nappe that is not certain must be cut off by the slab. The error of an end that follows from
        // the rounded coordinates of a start on a cap may be some units larger than promised for floats.
        if is_certain || slab.span.exit.t < side.t { slab.exit(side, from) } else { Attempt::Unsure }
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::cone(ray, self.outline, self.extent, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Cone { outline: self.outline, extent: self.extent }
    }

    fn hull(&self) -> Hull<S> {
        match (self.extent, self.outline) {
            (Extent::Double, _) => Hull::Discs([[-S::INFINITY, S::INFINITY], [S::INFINITY; 2]]),
            (_, Outline::Radii(base, top, height)) => Hull::Discs([[S::ZERO, base], [height, top]]),
            (_, Outline::Slope(slope)) => Hull::Cone { slope, height: self.height().unwrap_or(S::INFINITY) },
        }
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        match (part, self.height()) {
            (Part::Base, _) => Vec3 { y: S::ZERO, ..point },
            (Part::Top, Some(height)) => Vec3 { y: height, ..point },
            (_, height) => {
                let profile = Profile::of(self.outline, S::real);
                let mut point = height.map_or(point, |height| coordinates::between(point, height));
                let (g1, h) = (profile.growth, profile.h);
                if g1.abs() > h && !h.is_zero() {
                    // Flatter than 45 degrees: the nearest point of the side is found by moving along the axis, unless
                    // that leads beyond a rim.
                    let [x, _, z] = point.real();
                    let g = (x * x + z * z).sqrt() * h;
                    let g = if profile.at(point.y.real()).is_negative() { -g } else { g };
                    let moved = Vec3 { y: S::round((g - profile.base * h) / g1), ..point };
                    point = height.map_or(moved, |height| coordinates::between(moved, height));
                    if point.y == moved.y {
                        return moved;
                    }
                }
                // The frustum is so flat that its height rounds to zero relative to its radii: any circle between them
                // may be chosen.
                let radius = if profile.h.is_zero() {
                    self.base_radius().real()
                } else {
                    (profile.at(point.y.real()) / profile.h).abs()
                };
                coordinates::at_distance(point, |component| S::round(S::unit_real(component) * radius))
            }
        }
    }

    /// On the side `(x / rho, -m, z / rho)`, normalised, with the distance `rho` from the axis and the slope `m` (on
    /// the lower nappe of a double cone `+m`). At the apex it is the axis, pointing away from the body.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Base => return -UnitVec3::Y,
            Part::Top => return UnitVec3::Y,
            _ => {}
        }
        let profile = Profile::of(self.outline, S::real);
        let (g1, h) = (profile.growth, profile.h);
        let lower = profile.at(point.y.real()).is_negative();
        let slope = if lower { -g1 } else { g1 };
        let axis = if slope.is_negative() { UnitVec3::Y } else { -UnitVec3::Y };
        if point.x == S::ZERO && point.z == S::ZERO {
            return axis;
        }
        let [x, _, z] = coordinates::outwards(point).real();
        UnitVec3::from_real([x * h, -slope, z * h]).unwrap_or(axis)
    }

    fn bend(&self, point: Vec3<S>, part: Part) -> S {
        if part == Part::Side { largest([point.x, point.z]) } else { S::INFINITY }
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        let u = coordinates::azimuth(point);
        match (part, self.height()) {
            (Part::Base, _) => coordinates::planar(point, self.base_radius().real()),
            (Part::Top, _) => coordinates::planar(point, self.top_radius().unwrap_or(S::ZERO).real()),
            (_, Some(height)) => (u, coordinates::fraction::<S>(point.y.real(), height.real())),
            (_, None) => (u, coordinates::repeating(point.y)),
        }
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        if part != Part::Side {
            return coordinates::planar_tangents();
        }
        coordinates::tangents_around(point, self.normal(point, part))
    }
}

queries!(Cone);
