//! The quadric of revolution between two planes: `x^2 + z^2 = a y^2 + 2 b y + r^2`.

use super::{Geometry, SizeError, checked_size, checked_size_or_zero, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{Guards, Slab};
use crate::intersection::{End, Intersection};
use crate::outline::{Meridian, SquareOfRadius, has_waist};
use crate::part::Part;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Ring, Scalar, ValueError, found, largest};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};
use core::cmp::Ordering;

/// A quadric of revolution between two planes, closed by flat caps or [open](Self::open):
///
/// `x^2 + z^2 = a y^2 + 2 b y + r^2` with `low <= y <= high`
///
/// | `a` | it is |
/// |---|---|
/// | negative | a spheroid, which is a sphere for -1 |
/// | zero | a paraboloid; a cylinder if `b` is zero too |
/// | positive | a hyperboloid of one sheet, of two sheets, or a cone |
///
/// Where the side ends on the axis there is no cap, or one of a radius of some roundings. A waist or two nappes make it
/// not convex: then a line may have four crossings with it.
///
/// ```
/// use raylet::{Crossing, Part, Ray, Revolved, UnitVec3, Vec3};
/// // A dish of focal length 1: it reflects each ray along its axis to (0, 1, 0).
/// let dish = Revolved::paraboloid(1.0_f32, 0.5)?.open();
/// let ray = Ray::new(Vec3::new(1.0, 5.0, 0.0), -UnitVec3::Y)?;
/// let hit = dish.nearest(&ray).expect("it is in the way");
/// // It comes from within the paraboloid, and leaves it there.
/// assert_eq!((hit.t, hit.part, hit.crossing), (4.75, Part::Side, Crossing::Exit));
/// let normal = dish.surface(&ray, &hit).normal();
/// assert_eq!(normal, UnitVec3::new(Vec3::new(1.0, -2.0, 0.0))?);
/// # Ok::<(), raylet::Error>(())
/// ```
///
/// Source of the conic constant and of the sag: ISO 10110-12.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Revolved<S> {
    pub(super) meridian: Meridian<S>,
}

impl<S: Scalar> Revolved<S> {
    /// The solid of the equation `x^2 + z^2 = a y^2 + 2 b y + r^2` between two heights. Every other constructor rounds
    /// its numbers to these, which are then exact.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a number is not finite or beyond the budget (`a` beyond that of a slope), if the radius `r` is
    /// negative, if the lower height is not below the upper one, if the solid is wider than twice the budget, or if the
    /// right side of the equation is negative at a height between them by more than rounding, or zero at all of them.
    pub fn new(a: S, b: S, radius: S, [low, high]: [S; 2]) -> Result<Self, SizeError> {
        let a = within(a, S::BUDGET.slope, SizeError::Coefficient)?;
        let b = within(b, S::BUDGET.size, SizeError::Coefficient)?;
        let r = checked_size_or_zero(radius, SizeError::Radius)?;
        let [low, high] =
            [within(low, S::BUDGET.size, SizeError::Height)?, within(high, S::BUDGET.size, SizeError::Height)?];
        if low >= high {
            return Err(SizeError::Heights);
        }
        let sign = |value: S| i8::from(value > S::ZERO) - i8::from(value < S::ZERO);
        let has_waist = has_waist([a, b, r, low, high].map(sign));
        let meridian = Meridian { a, b, r, heights: [low, high], is_open: false, has_waist };
        let square = SquareOfRadius::of(&meridian);
        let (least, most) = square.extremes();
        // Twice the budget, since the root is rounded.
        let limit = S::BUDGET.size.real().scaled(1 - square.e);
        // The comparisons are false for NaN.
        let is_outline = least >= -square.doubt() && most > S::Real::ZERO;
        if !is_outline {
            return Err(SizeError::Outline);
        }
        if most > limit * limit {
            return Err(SizeError::Radius(ValueError::BeyondBudget));
        }
        Ok(Self { meridian })
    }

    /// A paraboloid with its vertex at the origin, open to +y: a dish, whose focus is at `(0, focal_length, 0)`.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget.
    pub fn paraboloid(focal_length: S, height: S) -> Result<Self, SizeError> {
        let f = checked_size(focal_length, SizeError::Radius)?;
        Self::new(S::ZERO, f.plus(f), S::ZERO, [S::ZERO, checked_size(height, SizeError::Height)?])
    }

    /// The part of a spheroid about the origin between two heights: its radius at `y = 0`, and its half height.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget, or the heights are not within the
    /// spheroid.
    pub fn spheroid(radius: S, half_height: S, heights: [S; 2]) -> Result<Self, SizeError> {
        let r = checked_size(radius, SizeError::Radius)?;
        let slope = r.real() / checked_size(half_height, SizeError::Height)?.real();
        Self::new(S::round(-(slope * slope)), S::ZERO, r, heights)
    }

    /// The part of a ball about the origin between two heights.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the radius is not positive, not finite or beyond the budget, or the heights are not within the
    /// ball.
    ///
    /// ```
    /// use raylet::{Part, Ray, Revolved, UnitVec3, Vec3};
    /// let hemisphere = Revolved::ball_zone(1.0_f32, [0.0, 1.0])?;
    /// let ray = Ray::new(Vec3::new(0.5, -2.0, 0.0), UnitVec3::Y)?;
    /// assert_eq!(hemisphere.nearest(&ray).map(|hit| (hit.t, hit.part)), Some((2.0, Part::Base)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn ball_zone(radius: S, heights: [S; 2]) -> Result<Self, SizeError> {
        Self::new(S::ZERO.minus(one::<S>()), S::ZERO, checked_size(radius, SizeError::Radius)?, heights)
    }

    /// The part of a cone about the origin between two heights of any sign; both nappes if their signs differ. The
    /// square of the slope is rounded.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the slope is not positive, or a number is not finite or beyond the budget.
    pub fn cone(slope: S, heights: [S; 2]) -> Result<Self, SizeError> {
        Self::hyperboloid(S::ZERO, slope, heights)
    }

    /// The part of a hyperboloid of one sheet between two heights: `x^2 + z^2 = waist^2 + slope^2 y^2`, where the waist
    /// is the radius at `y = 0` and the slope that of the cone which it approaches. The square of the slope is rounded.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if the slope is not positive, or a number is not finite or beyond the budget.
    pub fn hyperboloid(waist: S, slope: S, heights: [S; 2]) -> Result<Self, SizeError> {
        let m = within_slopes(slope)?;
        Self::new(S::round(m.real() * m.real()), S::ZERO, waist, heights)
    }

    /// A cooling tower: a hyperboloid of one sheet by its radii at both ends, by its smaller waist between them, and by
    /// its height. The waist is at `y = 0`; [`heights`](Self::heights) says where the ends are.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget, or the waist is larger than a radius
    /// or equal to both.
    ///
    /// ```
    /// use raylet::Revolved;
    /// let tower = Revolved::tower(5.0_f64, 3.0, 5.0, 16.0)?;
    /// assert_eq!((tower.heights(), tower.radius_at(8.0)), ([-8.0, 8.0], 5.0));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn tower(base_radius: S, waist: S, top_radius: S, height: S) -> Result<Self, SizeError> {
        let [base, w, top] = [base_radius, waist, top_radius];
        for radius in [base, w, top] {
            checked_size(radius, SizeError::Radius)?;
        }
        checked_size(height, SizeError::Height)?;
        if base < w || top < w || base == w && top == w {
            return Err(SizeError::Outline);
        }
        // Scaled so that no square overflows.
        let e = S::binary_exponent(largest([base, w, top, height]));
        let [base, w, top, height] = [base, w, top, height].map(|length| length.real().scaled(-e));
        // sqrt(r^2 - w^2) is m times the distance from the waist.
        let [below, above] = [base, top].map(|r| ((r - w) * (r + w)).sqrt());
        let m = (below + above) / height;
        let heights = [-(below / m), above / m].map(|y| S::round(y.scaled(e)));
        Self::new(S::round(m * m), S::ZERO, waist, heights)
    }

    /// A surface of optics, as lens makers give it: its vertex is at the origin, where its radius of curvature is
    /// `radius_of_curvature`, and it opens to +y up to a diameter. Its conic constant is -1 for a paraboloid, 0 for a
    /// sphere, below -1 for a hyperboloid. It is the solid between its vertex and the plane through its rim:
    /// [`open`](Self::open) makes a surface of it. (A plane surface, of curvature 0, is a [`Disc`](super::Disc).)
    ///
    /// The height `s` of the rim, the sag, is rounded: with curvature `c`, conic constant `k` and half diameter `h` it
    /// is `c h^2 / (1 + sqrt(1 - (1 + k) c^2 h^2))`.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if a size is not positive, not finite or beyond the budget, or the surface is nowhere as wide as
    /// the diameter.
    ///
    /// ```
    /// use raylet::Revolved;
    /// let parabolic = Revolved::optical(2.0_f64, -1.0, 4.0)?;
    /// assert_eq!(parabolic, Revolved::paraboloid(1.0, 1.0)?);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn optical(radius_of_curvature: S, conic_constant: S, diameter: S) -> Result<Self, SizeError> {
        let r = checked_size(radius_of_curvature, SizeError::Radius)?;
        let h = checked_size(diameter, SizeError::Radius)?.real().scaled(-1);
        let a = S::ZERO.minus(one::<S>().plus(conic_constant));
        let (c, one) = (h / r.real(), S::Real::ONE);
        let square = one + a.real() * c * c;
        if square.is_negative() {
            return Err(SizeError::Outline);
        }
        let sag = S::round(c * h / (one + square.sqrt()));
        Self::new(a, r, S::ZERO, [S::ZERO, checked_size(sag, SizeError::Height)?])
    }

    /// The side alone, without caps: an open surface.
    #[must_use]
    pub const fn open(self) -> Self {
        Self { meridian: Meridian { is_open: true, ..self.meridian } }
    }

    /// The coefficients `a` and `b` and the radius `r` of the equation.
    pub const fn coefficients(&self) -> (S, S, S) {
        (self.meridian.a, self.meridian.b, self.meridian.r)
    }

    /// The lower and the upper height.
    pub const fn heights(&self) -> [S; 2] {
        self.meridian.heights
    }

    /// True if it is a surface without caps.
    pub const fn is_open(&self) -> bool {
        self.meridian.is_open
    }

    /// The radius at a height, rounded; zero where there is none.
    pub fn radius_at(&self, y: S) -> S {
        let square = SquareOfRadius::of(&self.meridian);
        S::round(square.radius_at(y.real()))
    }

    /// The exponent of the largest of its lengths and of the coordinates of a point.
    fn exponent_at(&self, point: Vec3<S>) -> i32 {
        let Meridian { b, r, .. } = self.meridian;
        S::binary_exponent(largest([point.x, point.y, point.z, b, r]))
    }

    /// The interval of an arriving line between the planes, on the grid. A solid that ends at the origin by itself has
    /// no cap there: a plane as far beyond it takes the place of that plane.
    #[inline(always)]
    fn grid_slab<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Slab<S>>
    where
        S: GridScalar,
    {
        let Meridian { a, r, heights: [low, high], .. } = self.meridian;
        let has_apex = r == S::ZERO && a <= S::ZERO;
        let beyond = |height: S, other: S| if has_apex && height == S::ZERO { -other } else { height };
        Slab::new::<T>(line, beyond(low, high), beyond(high, low))
    }

    /// The most crossings that a line can have with the solid; zero of an open surface.
    pub(crate) const fn most_crossings(&self) -> usize {
        match (self.is_open(), self.meridian.has_waist) {
            (true, _) => 0,
            (false, true) => 4,
            (false, false) => 2,
        }
    }
}

/// One, in the number type.
fn one<S: Scalar>() -> S {
    S::round(S::Real::ONE)
}

/// A number of any sign and of at most this magnitude. A negative zero is stored as zero.
fn within<S: Scalar>(value: S, most: S, error: fn(ValueError) -> SizeError) -> Result<S, SizeError> {
    // The comparison is false for NaN.
    if value.magnitude() <= most {
        Ok(value.plus(S::ZERO))
    } else {
        Err(error(ValueError::of_size(value.magnitude(), S::ZERO)))
    }
}

/// A positive slope inside the budget.
fn within_slopes<S: Scalar>(slope: S) -> Result<S, SizeError> {
    super::cone::checked_slope(slope).map(|_| slope)
}

/// `a y + b`, half the growth of the square of the radius, and the coordinates of the point; all divided by `2^e`.
fn gradient_and_point<S: Scalar>(meridian: &Meridian<S>, point: Vec3<S>, e: i32) -> [S::Real; 4] {
    let [x, y, z] = point.to_array().map(|c| c.real().scaled(-e));
    [meridian.a.real() * y + meridian.b.real().scaled(-e), x, y, z]
}

impl<S> Described for Revolved<S> {
    const EQUATIONS: EquationKinds = EquationKinds::REVOLVED;
}

impl<S: Scalar> Geometry<S> for Revolved<S> {
    type In<R: Scalar> = Revolved<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(Revolved { meridian: self.meridian.map(R::exactly, R::exactly) })
    }

    fn largest_coordinate(&self) -> S {
        let [low, high] = self.meridian.heights;
        SquareOfRadius::of(&self.meridian).largest_radius().plus(largest([low, high]))
    }

    fn scaled(&self, e: i32) -> Self {
        Self { meridian: self.meridian.map(|ratio| ratio, |length| length.scaled(e)) }
    }

    /// Without the radii of the caps, which no kernel of the grid computes.
    #[inline(always)]
    fn lengths(&self) -> S {
        let Meridian { b, r, heights, .. } = self.meridian;
        largest(heights).plus(b.magnitude()).plus(r)
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let slab = found!(self.grid_slab::<T>(line));
        let (first, second) = found!(line.quadric(&self.meridian));
        let Some(second) = second else {
            return if self.is_open() { slab.rims(&first) } else { slab.clip(&first) };
        };
        if self.is_open() {
            return Attempt::Unsure;
        }
        match (slab.clip(&first), slab.clip(&second)) {
            (Attempt::Unsure, _) | (_, Attempt::Unsure) => Attempt::Unsure,
            (Attempt::Miss, only) | (only, Attempt::Miss) => only,
            (Attempt::Hit(Intersection::One(first)), Attempt::Hit(Intersection::One(second))) => {
                Attempt::Hit(Intersection::in_order(first, second))
            }
            _ => Attempt::Unsure,
        }
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        if self.is_open() {
            return Attempt::Unsure;
        }
        let (side, is_accurate) = if from == Part::Side {
            (found!(line.exit_from_quadric(&self.meridian)), true)
        } else {
            match found!(line.quadric(&self.meridian)) {
                (inside, None) => (inside.ends[1], inside.are_accurate()[1]),
                // It may enter again.
                _ => return Attempt::Unsure,
            }
        };
        // Also next to an apex, as in the solver: the side's end follows from a start that is not on the side.
        let [low, high] = self.meridian.heights;
        let slab = found!(Slab::new::<T>(line, low, high));
        if is_accurate || slab.span.exit.t < side {
            slab.exit(End::new(side, Part::Side), from)
        } else {
            Attempt::Unsure
        }
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::revolved(ray, &self.meridian, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Revolved { meridian: self.meridian }
    }

    /// A cylinder around it: larger than its convex hull.
    fn hull(&self) -> Hull<S> {
        let radius = SquareOfRadius::of(&self.meridian).largest_radius();
        Hull::Discs(self.meridian.heights.map(|height| [height, radius]))
    }

    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        let [low, high] = self.meridian.heights;
        let in_cap = |y: S| coordinates::at_circle(Vec3 { y, ..point }, self.radius_at(y), Ordering::Greater);
        match part {
            Part::Base => return in_cap(low),
            Part::Top => return in_cap(high),
            _ => {}
        }
        let between = |y: S| if y < low { low } else { y };
        let between = |y: S| if y > high { high } else { between(y) };
        let square_of_radius = SquareOfRadius::of(&self.meridian);
        let mut point = Vec3 { y: between(point.y), ..point };
        let (mut radius, e) = (square_of_radius.radius_at(point.y.real()), self.exponent_at(point));
        let [growth, x, y, z] = gradient_and_point(&self.meridian, point, e);
        let square = x * x + z * z;
        if growth * growth > square {
            // Flatter than 45 degrees: the nearest point is found by moving along the axis, by a step of Newton's,
            // unless that leads beyond a rim.
            let r = radius.scaled(-e);
            let moved = S::round((y + (square - r * r) / growth.scaled(1)).scaled(e));
            point.y = between(moved);
            if point.y == moved {
                return point;
            }
            radius = square_of_radius.radius_at(point.y.real());
        }
        coordinates::at_distance(point, |component| S::round(S::unit_real(component) * radius))
    }

    /// On the side half the gradient of the equation, `(x, -(a y + b), z)`, normalised; where that is zero, at the apex
    /// of a cone, the axis, pointing away from the body.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        match part {
            Part::Base => return -UnitVec3::Y,
            Part::Top => return UnitVec3::Y,
            _ => {}
        }
        let [growth, x, _, z] = gradient_and_point(&self.meridian, point, self.exponent_at(point));
        let gradient = [x, -growth, z];
        let is_at_top = point.y > S::ZERO || self.meridian.heights[1] <= S::ZERO;
        UnitVec3::from_real(gradient).unwrap_or(if is_at_top { UnitVec3::Y } else { -UnitVec3::Y })
    }

    /// With the length `g` of half the gradient, the radii of curvature are `g` around the axis and
    /// `g^3 / |b^2 - a r^2|` along the meridian.
    fn bend(&self, point: Vec3<S>, part: Part) -> S {
        if part != Part::Side {
            return S::INFINITY;
        }
        let (Meridian { a, b, r, .. }, e) = (self.meridian, self.exponent_at(point));
        let [growth, x, _, z] = gradient_and_point(&self.meridian, point, e);
        let (a, [b, r]) = (a.real(), [b, r].map(|length| length.real().scaled(-e)));
        let square = x * x + growth * growth + z * z;
        let (g, along) = (square.sqrt(), (b * b - a * r * r).abs());
        let least = if along > square { g * (square / along) } else { g };
        S::round(least.scaled(e))
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        let [low, high] = self.meridian.heights;
        match part {
            Part::Base => coordinates::planar(point, self.radius_at(low).real()),
            Part::Top => coordinates::planar(point, self.radius_at(high).real()),
            _ => {
                let [low, y, high] = [low, point.y, high].map(|y| y.real().scaled(-1));
                (coordinates::azimuth(point), coordinates::fraction::<S>(y - low, high - low))
            }
        }
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        if part != Part::Side {
            return coordinates::planar_tangents();
        }
        coordinates::tangents_around(point, self.normal(point, part))
    }
}

queries!(Revolved);
