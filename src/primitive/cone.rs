//! The cone about the y axis.
//!
//! The quadric, and why no slope is ever rounded, is in `outline`.

use super::cylinder::{between_rims, capped, leaves_slab, open_side};
use super::outline::{CarefulCone, Homogeneous, Outline, Profile};
use super::{
    Geometry, Line, SizeError, checked_size, checked_size_or_zero, queries, surface_coordinates as coordinates,
};
use crate::arithmetic::Arithmetic;
use crate::figure::{self, Figure, Side};
use crate::part::Part;
use crate::quadric::{Inside, Quadric, are_close, plain_slab, slab};
use crate::scalar::{Plain, PlainLine, PlainNappe, Real, Scalar, found, largest};
use crate::span::{End, Meeting, Span};
use crate::vector::{UnitVec3, Vec3};

/// How far a cone reaches, and whether it is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Extent<S> {
    Double,
    Nappe,
    Open(S),
    Capped(S),
}

/// A cone about the y axis: double, one nappe, or cut off at a height, open or with flat caps.
///
/// ```
/// use raylet::{Cone, Crossing, Part, Ray, UnitVec3, Vec3};
/// let cone = Cone::capped(1.0_f32, 1.0)?;
/// // Through the apex, along the axis.
/// let ray = Ray::new(Vec3::new(0.0, -2.0, 0.0), UnitVec3::Y)?;
/// let hits = cone.hits(&ray);
/// assert_eq!((hits[0].t, hits[0].part, hits[0].crossing), (2.0, Part::Side, Crossing::Enter));
/// assert_eq!((hits[1].t, hits[1].part, hits[1].crossing), (3.0, Part::Top, Crossing::Exit));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cone<S> {
    outline: Outline<S>,
    extent: Extent<S>,
}

impl<S: Scalar> Cone<S> {
    /// Two nappes without ends: `x^2 + z^2 = slope^2 y^2`.
    ///
    /// # Errors
    ///
    /// [`SizeError::Slope`] if the slope is not positive, not finite or beyond the budget.
    pub fn double(slope: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_slope(slope)?, extent: Extent::Double })
    }

    /// The nappe above the apex, without end.
    ///
    /// # Errors
    ///
    /// [`SizeError::Slope`] if the slope is not positive, not finite or beyond the budget.
    pub fn nappe(slope: S) -> Result<Self, SizeError> {
        Ok(Self { outline: checked_slope(slope)?, extent: Extent::Nappe })
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
        match self.extent {
            Extent::Double | Extent::Nappe => None,
            Extent::Open(height) | Extent::Capped(height) => Some(height),
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

fn checked_slope<S: Scalar>(slope: S) -> Result<Outline<S>, SizeError> {
    // A NaN compares false.
    if slope >= S::BUDGET.smallest_slope && slope <= S::BUDGET.slope {
        Ok(Outline::Slope(slope))
    } else {
        Err(SizeError::Slope)
    }
}

fn checked_radii<S: Scalar>(base: S, top: S, height: S) -> Result<Outline<S>, SizeError> {
    let base = checked_size_or_zero(base, SizeError::Radius)?;
    let top = checked_size_or_zero(top, SizeError::Radius)?;
    if base == S::ZERO && top == S::ZERO {
        return Err(SizeError::Radius);
    }
    Ok(Outline::Radii(base, top, checked_size(height, SizeError::Height)?))
}

impl<S: Scalar> Cone<S> {
    /// Where the line is inside both nappes, and the sign of the nappe for a finite interval: see [`NappeTest`].
    #[inline]
    fn both_nappes<T: Arithmetic<S>>(&self, line: &Line<S>) -> (Inside<S>, NappeTest) {
        let profile = Profile::<T::Real>::of(self.outline, T::real);
        let (h, g0, g1) = (profile.h, profile.g0(), profile.g1());
        let (o, d) = (line.point::<T>(), line.along::<T>());
        let ([x, y, z], [dx, dy, dz]) = (o, d);
        let point = Homogeneous { v: o, rest: line.rest::<T>(), is_point: true };
        let direction = Homogeneous { v: d, rest: [T::Real::ZERO; 3], is_point: false };
        let (g, slope) = (g0 + g1 * y, g1 * dy);

        let (round, straight) = (h * h * (x * dx + z * dz), g * slope);
        let mut k = round - straight;
        // Less than a quarter left of either product: the rest is rounding, magnified.
        let far = T::COMPENSATES && largest(line.origin).in_finer_units(-line.finer) > S::FAR;
        if far || T::COMPENSATES && k.abs() < straight.abs().times_power_of_two(-2) {
            k = profile.bilinear(point, direction);
        }
        let (round, straight) = (h * h * (dx * dx + dz * dz), slope * slope);
        let mut a = round - straight;
        if far || T::COMPENSATES && a.abs() < straight.times_power_of_two(-2) {
            a = profile.bilinear(direction, direction);
        }
        let inside = if let Some(leaving) = line.departs_from(Part::Side) {
            Quadric { a, k, positive: T::Real::ZERO, negative: T::Real::ZERO }.solve_departing::<S, T>(line, leaving)
        } else {
            let [wx, wy, wz] = line.moment::<T>();
            let mut minors = [g1 * wz - g0 * dx, g1 * wx + g0 * dz, h * wy].map(|minor| h * minor);
            let squares = |[p, q, r]: [T::Real; 3]| (p * p + q * q, r * r);
            let (mut positive, mut negative) = squares(minors);
            // Aimed close to the apex from afar, the minors are what is left of much larger products.
            let point_terms = h * h * (x * x + z * z) + g * g;
            let apex_terms = h * h * g0 * g0 * (dx * dx + dz * dz);
            let terms = if point_terms > apex_terms { point_terms } else { apex_terms };
            if T::COMPENSATES && positive + negative < terms.times_power_of_two(-4) {
                minors = profile.minors(point, direction).map(|[minor, _]| minor);
                (positive, negative) = squares(minors);
            }
            let quadric = Quadric { a, k, positive, negative };
            quadric.solve::<S, T>(line, &CarefulCone { profile, point, direction })
        };
        // At the vertex t = -k/a the outline is g - g' k/a, which has the sign of the nappe that a finite interval lies in.
        let (p, q) = (g * a, slope * k);
        let vertex = p - q;
        // A touch may be that of the apex, where the outline is zero and its sign is rounding: the apex belongs to both.
        let is_apex = matches!(inside, Inside::Between(Span { touch: true, .. }))
            && vertex.abs() < (p.abs() + q.abs()).times_power_of_two(T::Real::ROUNDING + 3);
        (inside, NappeTest { rising: !slope.is_negative(), upper: is_apex || !vertex.is_negative() })
    }

    /// The interval in the nappe where the outline is positive.
    #[inline]
    fn one_nappe<T: Arithmetic<S>>(&self, line: &Line<S>) -> NappeMeeting<S> {
        let (inside, test) = self.both_nappes::<T>(line);
        let half_line = |from: bool, t: S| {
            let end = End::new(t, Part::Side);
            if from { Span::new(end, End::none(S::INFINITY)) } else { Span::new(End::none(-S::INFINITY), end) }
        };
        let span = match inside {
            Inside::Nowhere => None,
            Inside::Between(span) => test.upper.then_some(span),
            // Steeper than the side: one half-line in each nappe; the outline grows with t if it rises.
            Inside::Beyond(first, second) => Some(half_line(test.rising, if test.rising { second } else { first })),
            // Parallel to a generator: one half-line, in the nappe into which it leads.
            Inside::From(t) => test.rising.then(|| half_line(true, t)),
            Inside::Until(t) => (!test.rising).then(|| half_line(false, t)),
            // Only a line along a generator has f = 0 everywhere; its own apex ends it.
            Inside::InSurface => return NappeMeeting::Generator,
            // Only a line along the axis of a frustum of equal radii has f < 0 everywhere.
            Inside::Everywhere => Some(Span::everywhere()),
        };
        span.map_or(NappeMeeting::Miss, NappeMeeting::In)
    }

    /// The piece of a generator line that lies in the nappe: from the apex on.
    fn generator<T: Arithmetic<S>>(&self, line: &Line<S>) -> Span<S> {
        let profile = Profile::<T::Real>::of(self.outline, T::real);
        let ([_, y, _], [_, dy, _]) = (line.point::<T>(), line.along::<T>());
        let slope = profile.g1() * dy;
        if slope.is_zero() {
            return Span::everywhere();
        }
        let apex = End::new(line.t::<T>(-profile.at(y), slope), Part::Side);
        if slope.is_negative() {
            Span::new(End::none(-S::INFINITY), apex)
        } else {
            Span::new(apex, End::none(S::INFINITY))
        }
    }

    /// Parallel to a generator but for rounding, a line may seem to stay in the nappe for ever where it leaves it: a closed
    /// cone ends at the height of its apex at the latest.
    fn ending_at_the_apex<T: Arithmetic<S>>(&self, line: &Line<S>, mut side: Span<S>, height: S) -> Span<S> {
        if side.enter.t.is_finite() && side.exit.t.is_finite() {
            return side;
        }
        let apex = match self.planes() {
            (None, _) => S::ZERO,
            (_, None) => height,
            _ => return side,
        };
        let ([_, y, _], [_, rest, _], [_, dy, _]) = (line.point::<T>(), line.rest::<T>(), line.along::<T>());
        if dy.is_zero() {
            return side;
        }
        let t = line.t::<T>(T::real(apex) - y - rest, dy);
        let leads_to_the_apex = if apex == height { !dy.is_negative() } else { dy.is_negative() };
        if leads_to_the_apex {
            side.exit = if t < side.exit.t { End::new(t, Part::Side) } else { side.exit };
        } else {
            side.enter = if t > side.enter.t { End::new(t, Part::Side) } else { side.enter };
        }
        side
    }

    /// The planes that cut it off; there is none where the radius is zero, for the apex ends it there.
    fn planes(&self) -> (Option<S>, Option<S>) {
        let low = (self.base_radius() != S::ZERO).then_some(S::ZERO);
        let high = match self.outline {
            Outline::Radii(_, top, _) if top == S::ZERO => None,
            _ => self.height(),
        };
        (low, high)
    }
}

/// Which nappe a line's interval lies in.
struct NappeTest {
    rising: bool,
    upper: bool,
}

/// How a line meets one nappe.
enum NappeMeeting<S> {
    Miss,
    In(Span<S>),
    Generator,
}

impl<S: Scalar> Geometry<S> for Cone<S> {
    fn reach(&self) -> S {
        match (self.outline, self.height()) {
            (Outline::Radii(base, top, height), _) => base.plus(top).plus(height),
            (Outline::Slope(slope), Some(height)) => S::round(slope.real() * height.real()).plus(height),
            // The apex is all there is to be near to: any distance from it may be far.
            (Outline::Slope(_), None) => S::ZERO,
        }
    }

    fn is_far(&self, origin: Vec3<S>) -> bool {
        if self.height().is_some() {
            return true;
        }
        // Near the surface of an infinite cone, however far from the apex, the surface is what counts.
        let profile = Profile::<S::Real>::of(self.outline, S::real);
        let [x, y, z] = origin.real();
        let g = profile.at(y);
        let (round, straight) = (x * x + z * z, g * g);
        (round - straight).abs() > (round + straight).times_power_of_two(-2)
    }

    fn scaled(&self, e: i32) -> Self {
        let outline = match self.outline {
            Outline::Slope(slope) => Outline::Slope(slope),
            Outline::Radii(base, top, height) => Outline::Radii(base.scaled(e), top.scaled(e), height.scaled(e)),
        };
        let extent = match self.extent {
            Extent::Double => Extent::Double,
            Extent::Nappe => Extent::Nappe,
            Extent::Open(height) => Extent::Open(height.scaled(e)),
            Extent::Capped(height) => Extent::Capped(height.scaled(e)),
        };
        Self { outline, extent }
    }

    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        if let Extent::Double = self.extent {
            return self.meet_double::<T>(line);
        }
        let (low, high) = self.planes();
        let side = match (self.one_nappe::<T>(line), self.extent) {
            (NappeMeeting::In(span), Extent::Capped(height)) => self.ending_at_the_apex::<T>(line, span, height),
            (NappeMeeting::In(span), _) => span,
            (NappeMeeting::Generator, Extent::Capped(_)) => {
                return capped::<S, T>(line, self.generator::<T>(line), low, high).along_the_side();
            }
            (NappeMeeting::Generator, _) => {
                let between = slab::<S, T>(line, low, high);
                return between
                    .and_then(|between| self.generator::<T>(line).intersection(between))
                    .map_or(Meeting::Miss, Meeting::LiesIn);
            }
            // A ray that departs inwards has a far end, even if its start is just outside.
            (NappeMeeting::Miss, Extent::Capped(_)) if line.departure.is_some() => {
                Span::new(End::none(-S::INFINITY), End::new(S::ZERO, Part::Side))
            }
            (NappeMeeting::Miss, _) => return Meeting::Miss,
        };
        let meeting = match self.extent {
            Extent::Open(height) => open_side::<S, T>(line, side, S::ZERO, height),
            Extent::Capped(_) => return capped::<S, T>(line, side, low, high),
            Extent::Nappe | Extent::Double => Meeting::One(side),
        };
        match line.departure {
            Some((_, leaving)) => meeting.departed(leaving, true),
            None => meeting,
        }
    }

    #[inline(always)]
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>> {
        let outline = match self.outline {
            Outline::Slope(slope) => (S::ZERO, slope, None),
            Outline::Radii(base, top, height) => (base, top.minus(base), Some(height)),
        };
        if let Extent::Double = self.extent {
            return Plain::Unclear;
        }
        let PlainNappe { ends: [low, high], certain } = found!(S::plain_nappe(*line, outline, self.height()));
        let side = Span::new(End::new(low, Part::Side), End::new(high, Part::Side));
        let (Extent::Open(height) | Extent::Capped(height)) = self.extent else {
            return if certain == [true; 2] { Plain::Found(Meeting::One(side)) } else { Plain::Unclear };
        };
        let mut between = found!(plain_slab(line, S::ZERO, height));
        if let Extent::Capped(_) = self.extent {
            // Where the apex ends it there is no plane.
            let (low, high) = self.planes();
            let is_plane = |part: Part| if part == Part::Base { low.is_some() } else { high.is_some() };
            if !is_plane(between.enter.part) {
                between.enter = End::none(-S::INFINITY);
            }
            if !is_plane(between.exit.part) {
                between.exit = End::none(S::INFINITY);
            }
        }
        // An end that is somewhere beyond must not be asked for.
        if are_close(&side, &between)
            || !(certain[0] || between.enter.t > low)
            || !(certain[1] || between.exit.t < high)
        {
            return Plain::Unclear;
        }
        Plain::Found(match self.extent {
            Extent::Open(_) => between_rims(side, between),
            _ => Meeting::solid(side.intersection(between)),
        })
    }

    /// Above the top and rising, or below the base and descending: no.
    fn verdict<T: Arithmetic<S>>(&self, line: &Line<S>) -> Option<bool> {
        let height = self.height()?;
        leaves_slab::<S, T>(line, S::ZERO, height).then_some(false)
    }

    fn figure(&self) -> Figure<S> {
        let side = match self.outline {
            Outline::Slope(slope) => Side::Slope(slope),
            Outline::Radii(base, top, height) => Side::Radii(base, top, height),
        };
        let extent = match (self.extent, self.outline) {
            (Extent::Double, Outline::Slope(slope)) => return Figure::DoubleCone { slope },
            (Extent::Double | Extent::Nappe, _) => figure::Extent::Infinite,
            (Extent::Open(height), _) => figure::Extent::Open(height),
            (Extent::Capped(_), _) => {
                let (low, high) = self.planes();
                figure::Extent::Capped(low, high)
            }
        };
        Figure::Round { side, extent }
    }

    fn contains(&self, point: Vec3<S>) -> bool {
        let profile = Profile::<S::Real>::of(self.outline, S::real);
        let [x, y, z] = point.real();
        let upper = matches!(self.extent, Extent::Double) || !profile.at(y).is_negative();
        let between = self.height().is_none_or(|height| S::ZERO <= point.y && point.y <= height);
        if !(upper && between) {
            return false;
        }
        let here = Homogeneous { v: [x, y, z], rest: [S::Real::ZERO; 3], is_point: true };
        let c = profile.bilinear(here, here);
        c.is_zero() || c.is_negative() && !matches!(self.extent, Extent::Open(_))
    }

    fn bounds(&self) -> (Vec3<S>, Vec3<S>) {
        let infinite = Vec3::new(S::INFINITY, S::INFINITY, S::INFINITY);
        match (self.height(), self.top_radius()) {
            (Some(height), Some(top)) => {
                let base = self.base_radius();
                let r = if top > base { top } else { base };
                // The radius of a slope's cap is rounded: up to be sure.
                let r = if let Outline::Slope(_) = self.outline { r.next_up() } else { r };
                (Vec3::new(-r, S::ZERO, -r), Vec3::new(r, height, r))
            }
            _ if matches!(self.extent, Extent::Nappe) => (Vec3::new(-S::INFINITY, S::ZERO, -S::INFINITY), infinite),
            _ => (-infinite, infinite),
        }
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        match (part, self.height()) {
            (Part::Base, _) => Vec3 { y: S::ZERO, ..point },
            (Part::Top, Some(height)) => Vec3 { y: height, ..point },
            (_, height) => {
                let profile = Profile::<S::Real>::of(self.outline, S::real);
                let point = height.map_or(point, |height| coordinates::between(point, height));
                let (g1, h) = (profile.g1(), profile.h);
                if g1.abs() > h && !h.is_zero() {
                    // Flatter than 45 degrees: the side is nearest along the axis.
                    let [x, _, z] = point.real();
                    let g = (x * x + z * z).sqrt() * h;
                    let g = if profile.at(point.y.real()).is_negative() { -g } else { g };
                    let y = S::round((g - profile.g0()) / g1);
                    let point = Vec3 { y, ..point };
                    return height.map_or(point, |height| coordinates::between(point, height));
                }
                // So flat that its height is nothing beside its radii: one circle is as near as another.
                let radius = if profile.h.is_zero() {
                    self.base_radius().real()
                } else {
                    (profile.at(point.y.real()) / profile.h).abs()
                };
                coordinates::at_distance(point, |component| S::round(S::unit_real(component) * radius))
            }
        }
    }

    /// On the side `(x / rho, -m, z / rho)`, normalised (on the lower nappe of a double cone `+m`); at the apex the axis,
    /// pointing away from the body.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Base => return -UnitVec3::Y,
            Part::Top => return UnitVec3::Y,
            Part::Side => {}
        }
        let profile = Profile::<S::Real>::of(self.outline, S::real);
        let (g1, h) = (profile.g1(), profile.h);
        let lower = profile.at(point.y.real()).is_negative();
        let slope = if lower { -g1 } else { g1 };
        let axis = if slope.is_negative() { UnitVec3::Y } else { -UnitVec3::Y };
        if point.x == S::ZERO && point.z == S::ZERO {
            return axis;
        }
        let [x, _, z] = coordinates::outwards(point).real();
        UnitVec3::from_real([x * h, -slope, z * h]).unwrap_or(axis)
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        let u = coordinates::azimuth(point);
        match (part, self.height()) {
            (Part::Side, Some(height)) => (u, coordinates::fraction::<S>(point.y.real(), height.real())),
            (Part::Side, None) => (u, coordinates::repeating(point.y)),
            (Part::Base, _) => coordinates::planar(point, self.base_radius().real()),
            (Part::Top, _) => coordinates::planar(point, self.top_radius().unwrap_or(S::ZERO).real()),
        }
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        if part != Part::Side {
            return coordinates::planar_tangents();
        }
        let u = coordinates::around(point);
        let v = UnitVec3::from_real(self.normal(point, part).cross(u)).unwrap_or(UnitVec3::Y);
        (u, v)
    }
}

impl<S: Scalar> Cone<S> {
    fn meet_double<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        let (inside, _) = self.both_nappes::<T>(line);
        let until = |t: S| Span::new(End::none(-S::INFINITY), End::new(t, Part::Side));
        let from = |t: S| Span::new(End::new(t, Part::Side), End::none(S::INFINITY));
        let meeting = match inside {
            Inside::Nowhere => Meeting::Miss,
            Inside::Between(span) => Meeting::One(span),
            Inside::Beyond(first, second) => Meeting::Two(until(first), from(second)),
            Inside::Until(t) => Meeting::One(until(t)),
            Inside::From(t) => Meeting::One(from(t)),
            Inside::Everywhere | Inside::InSurface => Meeting::LiesIn(Span::everywhere()),
        };
        match line.departure {
            Some((_, leaving)) => meeting.departed(leaving, false),
            None => meeting,
        }
    }
}

queries!(Cone);
