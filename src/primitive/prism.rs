//! The prism: a convex polygon between two planes.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{Clip, Guards};
use crate::intersection::{End, Intersection};
use crate::part::Part;
use crate::polygon::Polygon;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Ring, Scalar, ValueError, found, largest};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};

/// A convex polygon of 3 to 16 corners between the planes `y = 0` and `y = height`: a solid.
///
/// It borrows its corners, which live as long as the program: a constant, or on a host what
/// [`Box::leak`](https://doc.rust-lang.org/std/boxed/struct.Box.html#method.leak) gives. So a shape, which may be any
/// primitive, is no larger for them.
///
/// It is what lies between the planes and on the inner side of each edge's plane, which contains the two corners as
/// they are stored: two prisms that share an edge leave no gap. The part [`Part::Facet0`] is the face over the edge
/// from the first corner to the second, and so on.
///
/// # Edges and corners
///
/// An edge or a corner belongs to the first of its faces: the facets in order, then base and top. A ray in the plane of
/// a face enters and leaves through edges of that face. A ray that meets nothing but a point of an edge touches it: one
/// hit.
///
/// # Surface coordinates
///
/// On a facet `u` grows from one corner to the next, counter-clockwise as seen from +y, and `v` upwards. On base and
/// top they are x and z over the smallest rectangle around the polygon.
///
/// ```
/// use raylet::{Part, Prism, Ray, UnitVec3, Vec3};
/// // Each corner is x and z, counter-clockwise as seen from +y, which is from +x towards -z.
/// static WEDGE: [[f32; 2]; 3] = [[2.0, 1.0], [2.0, -1.0], [0.0, 0.0]];
/// let wedge = Prism::new(&WEDGE, 1.0)?;
/// let ray = Ray::new(Vec3::new(5.0, 0.5, 0.5), -UnitVec3::X)?;
/// let hits: Vec<_> = wedge.hits(&ray).iter().map(|hit| (hit.t, hit.part)).collect();
/// assert_eq!(hits, [(3.0, Part::Facet0), (4.0, Part::Facet2)]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prism<S: 'static> {
    pub(crate) polygon: Polygon<S>,
    pub(super) height: S,
}

impl<S: Scalar> Prism<S> {
    /// The prism over the polygon with these corners, each as x and z, counter-clockwise as seen from +y.
    ///
    /// # Errors
    ///
    /// [`SizeError`] if there are fewer than 3 corners or more than 16, a coordinate or the height is not finite or
    /// beyond the budget, the height is not positive, or the corners are not those of a convex polygon: each turns to
    /// the left, by at least 1/4000 of a radian.
    ///
    /// ```
    /// use raylet::Prism;
    /// static CLOCKWISE: [[f32; 2]; 3] = [[0.0, 0.0], [2.0, -1.0], [2.0, 1.0]];
    /// let error = Prism::new(&CLOCKWISE, 1.0).unwrap_err();
    /// let message = "the corners do not turn to the left, as seen from +y, once around a convex polygon";
    /// assert_eq!(error.to_string(), message);
    /// ```
    pub fn new(corners: &'static [[S; 2]], height: S) -> Result<Self, SizeError> {
        Ok(Self { polygon: checked(corners)?, height: checked_size(height, SizeError::Height)? })
    }

    /// The corners, each as x and z.
    pub const fn corners(&self) -> &'static [[S; 2]] {
        self.polygon.stored()
    }

    /// The height.
    pub const fn height(&self) -> S {
        self.height
    }

    /// The line's interval in the half-spaces on the grid.
    #[inline(always)]
    fn clip<T: Guards>(&self, line: &LocalLine<S>, from: Option<Part>) -> Attempt<Clip<S>>
    where
        S: GridScalar,
    {
        let mut clip = Clip::new::<T>(from);
        for (part, [[ax, az], [bx, bz]]) in self.polygon.edges() {
            let normal = [az.minus(bz), S::ZERO, bx.minus(ax)];
            found!(clip.by(line.half_space([ax, S::ZERO, az], normal), part));
        }
        found!(clip.by_slab(line, 1, [S::ZERO, self.height], [Part::Base, Part::Top]));
        Attempt::Hit(clip)
    }

    /// How far a point is along a facet's edge, from 0 to 1.
    fn along([[ax, az], [bx, bz]]: [[S; 2]; 2], point: Vec3<S>) -> S::Unit {
        // Scaled, so that no square overflows.
        let e = S::binary_exponent(largest([bx.minus(ax), bz.minus(az)]));
        let difference = |a: S, b: S| (b.real() - a.real()).scaled(-e);
        let [dx, dz] = [difference(ax, bx), difference(az, bz)];
        let [px, pz] = [difference(ax, point.x), difference(az, point.z)];
        coordinates::fraction::<S>(px * dx + pz * dz, dx * dx + dz * dz)
    }

    /// The direction of a facet's edge.
    fn edge_direction([[ax, az], [bx, bz]]: [[S; 2]; 2]) -> UnitVec3<S> {
        UnitVec3::from_real([bx.real() - ax.real(), S::Real::ZERO, bz.real() - az.real()]).unwrap_or(UnitVec3::X)
    }

    /// The point of an edge at this part of its length.
    fn at([[ax, az], [bx, bz]]: [[S; 2]; 2], u: S::Unit) -> [S; 2] {
        let u = S::unit_real(u);
        let between = |a: S, b: S| {
            let (a, b) = (a.real(), b.real());
            S::round(S::Real::sum_of_products([[a, S::Real::ONE - u], [b, u]]))
        };
        [between(ax, bx), between(az, bz)]
    }
}

impl<S> Described for Prism<S> {
    const EQUATIONS: EquationKinds = EquationKinds::PRISM;
}

impl<S: Scalar> Geometry<S> for Prism<S> {
    type In<R: Scalar> = Prism<R>;

    /// None: the corners are borrowed.
    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        None
    }

    fn largest_coordinate(&self) -> S {
        largest([self.polygon.largest(), self.height])
    }

    /// Four times as large, so that coordinates of the line leave two bits free: the grid multiplies differences of them.
    #[inline(always)]
    fn lengths(&self) -> S {
        let largest = self.largest_coordinate();
        let twice = largest.plus(largest);
        twice.plus(twice)
    }

    fn scaled(&self, e: i32) -> Self {
        Self { polygon: self.polygon.scaled(e), height: self.height.scaled(e) }
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        found!(self.clip::<T>(line, None)).interval(line)
    }

    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        found!(self.clip::<T>(line, Some(from))).exit()
    }

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::prism(ray, self.polygon, self.height, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Prism { polygon: self.polygon, height: self.height }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Prism(self.polygon, self.height)
    }

    /// Of base and top the point in the smallest rectangle around the polygon, moved to the edge that it is beyond.
    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        let height = |y: S| {
            if y > self.height {
                self.height
            } else if y > S::ZERO {
                y
            } else {
                S::ZERO
            }
        };
        if let Some(edge) = self.polygon.edge(part) {
            let [x, z] = Self::at(edge, Self::along(edge, point));
            return Vec3 { x, y: height(point.y), z };
        }
        let y = if part == Part::Base { S::ZERO } else { self.height };
        let mut inside = Vec3 { y, ..point };
        for (_, edge @ [[ax, az], [bx, bz]]) in self.polygon.edges() {
            let e = S::binary_exponent(largest([bx.minus(ax), bz.minus(az)]));
            let difference = |a: S, b: S| (b.real() - a.real()).scaled(-e);
            let [px, pz] = [difference(ax, inside.x), difference(az, inside.z)];
            if (difference(ax, bx) * pz - difference(az, bz) * px) > S::Real::ZERO {
                let [x, z] = Self::at(edge, Self::along(edge, inside));
                inside = Vec3 { x, y, z };
            }
        }
        inside
    }

    fn normal(&self, _: Vec3<S>, part: Part) -> UnitVec3<S> {
        match self.polygon.edge(part) {
            Some([[ax, az], [bx, bz]]) => {
                let outwards = [az.real() - bz.real(), S::Real::ZERO, bx.real() - ax.real()];
                UnitVec3::from_real(outwards).unwrap_or(UnitVec3::X)
            }
            None if part == Part::Base => -UnitVec3::Y,
            None => UnitVec3::Y,
        }
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        if let Some(edge) = self.polygon.edge(part) {
            return (Self::along(edge, point), coordinates::fraction::<S>(point.y.real(), self.height.real()));
        }
        let [x, z] = self.polygon.extents();
        // Halves: twice the largest size overflows.
        let over = |c: S, [low, high]: [S; 2]| {
            let [c, low, high] = [c, low, high].map(|length| length.real().scaled(-1));
            coordinates::fraction::<S>(c - low, high - low)
        };
        (over(point.x, x), over(point.z, z))
    }

    fn tangents(&self, _: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        match self.polygon.edge(part) {
            Some(edge) => (Self::edge_direction(edge), UnitVec3::Y),
            None => coordinates::planar_tangents(),
        }
    }
}

queries!(Prism);

/// The most corners of a polygon.
pub(super) const MOST_CORNERS: usize = 16;

/// The product of the directions of two edges at a corner, each divided by its larger component, is at least
/// `2^LEAST_TURN`: then rounding does not decide whether a polygon is convex.
pub(super) const LEAST_TURN: i32 = -12;

/// The polygon with these corners, if it is convex.
fn checked<S: Scalar>(corners: &'static [[S; 2]]) -> Result<Polygon<S>, SizeError> {
    if !(3..=MOST_CORNERS).contains(&corners.len()) {
        return Err(SizeError::CornerCount);
    }
    for coordinate in corners.as_flattened() {
        // The comparison is false for NaN.
        let is_within = coordinate.magnitude() <= S::BUDGET.size;
        if !is_within {
            let is_finite = coordinate.is_finite();
            let error = if is_finite { ValueError::BeyondBudget } else { ValueError::NotFinite };
            return Err(SizeError::Corner(error));
        }
    }
    let polygon = Polygon::new(corners);
    // Each corner turns to the left, and the directions of the edges come around once.
    let mut reversals = 0;
    for ((_, [from, corner]), (_, [_, to])) in polygon.edges().zip(polygon.edges().cycle().skip(1)) {
        let (Some(before), Some(after)) = (direction(from, corner), direction(corner, to)) else {
            return Err(SizeError::Corners);
        };
        let turn = before[1] * after[0] - before[0] * after[1];
        // Not the negated comparison: NaN must fail.
        let is_left = turn >= S::Real::ONE.scaled(LEAST_TURN);
        if !is_left {
            return Err(SizeError::Corners);
        }
        reversals += (is_first_half(before) != is_first_half(after)) as u32;
    }
    if reversals == 2 { Ok(polygon) } else { Err(SizeError::Corners) }
}

/// The direction of an edge, divided by the magnitude of its larger component; `None` if the edge is too short.
fn direction<S: Scalar>([ax, az]: [S; 2], [bx, bz]: [S; 2]) -> Option<[S::Real; 2]> {
    let length = largest([bx.minus(ax), bz.minus(az)]);
    if length < S::BUDGET.smallest_size {
        return None;
    }
    let [x, z] = [bx.real() - ax.real(), bz.real() - az.real()];
    let largest = if x.abs() > z.abs() { x.abs() } else { z.abs() };
    Some([x / largest, z / largest])
}

/// True for a direction towards -z, or along +x: for one half of all directions.
fn is_first_half<R: Real>([x, z]: [R; 2]) -> bool {
    z.is_negative() || z.is_zero() && !x.is_negative()
}
