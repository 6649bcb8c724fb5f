//! The convex polyhedron: a box that half-spaces cut.

use super::{Geometry, SizeError, checked_size, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::{Clip, Guards};
use crate::half_space::{CutBox, HalfSpace};
use crate::intersection::{End, Intersection};
use crate::part::{FACES, Part};
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Ring, Scalar, ValueError, found, largest};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3, component, cross, pairs, with_component};

/// A convex polyhedron: what a box and 1 to 16 half-spaces have in common. A solid.
///
/// It borrows its half-spaces, which live as long as the program: a constant, or on a host what
/// [`Box::leak`](https://doc.rust-lang.org/std/boxed/struct.Box.html#method.leak) gives. So a shape, which may be any
/// primitive, is no larger for them. The box bounds it: [`Polyhedron::within`] takes one whose faces may be faces of
/// the solid, and [`Polyhedron::new`] computes one around the solid that half-spaces have in common. It may be empty;
/// then nothing meets it.
///
/// The part [`Part::Facet0`] is the face of the first half-space, and so on; the faces of the box are parts as those of
/// a [`Cuboid`](crate::Cuboid).
///
/// # Edges and corners
///
/// An edge or a corner belongs to the first of its faces: the facets in order, then `Left`, `Right`, `Back`, `Front`,
/// `Base`, `Top`. A ray in the plane of a face enters and leaves through edges of that face. A ray that meets nothing
/// but a point of an edge touches it: one hit.
///
/// # Surface coordinates
///
/// On a facet `u` is the coordinate along the horizontal, counter-clockwise as seen from +y, and `v` that up the slope,
/// both from the origin's projection; each repeats every unit of length. On a horizontal facet `u` is x. On a face of
/// the box they are those of a cuboid.
///
/// A ramp, which is a block that one half-space cuts:
///
/// ```
/// use raylet::{HalfSpace, Part, Polyhedron, Ray, UnitVec3, Vec3};
/// static SLOPE: [HalfSpace<f32>; 1] =
///     [raylet::constant!(HalfSpace::<f32>::const_new(Vec3::new(0.0, 0.0, 0.0), Vec3::new(-1.0, 2.0, 0.0)))];
/// let ramp = Polyhedron::within(Vec3::new(0.0, 0.0, -1.0), Vec3::new(4.0, 2.0, 1.0), &SLOPE)?;
/// let down = Ray::new(Vec3::new(2.0, 5.0, 0.0), -UnitVec3::Y)?;
/// let hits: Vec<_> = ramp.hits(&down).iter().map(|hit| (hit.t, hit.part)).collect();
/// assert_eq!(hits, [(4.0, Part::Facet0), (5.0, Part::Base)]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polyhedron<S: 'static> {
    pub(super) solid: CutBox<S>,
}

impl<S: Scalar> HalfSpace<S> {
    /// The half-space below the plane through a point, with this outward normal of any length.
    ///
    /// # Errors
    ///
    /// [`SizeError::Corner`] if a coordinate of the point is not finite or beyond the budget; [`SizeError::Normal`] if
    /// the largest component of the normal is zero, not finite or, as a slope, beyond the budget.
    pub fn new(point: Vec3<S>, normal: Vec3<S>) -> Result<Self, SizeError> {
        let point = point.checked().map_err(SizeError::Corner)?;
        let [x, y, z] = normal.to_array();
        // A NaN is no component that `largest` would see.
        if let Some(error) = [x, y, z].into_iter().find_map(|c| beyond(c, S::BUDGET.slope)) {
            return Err(SizeError::Normal(error));
        }
        let size = largest([x, y, z]);
        if size < S::BUDGET.smallest_slope {
            return Err(SizeError::Normal(ValueError::of_size(size, S::BUDGET.smallest_slope)));
        }
        Ok(Self { point, normal })
    }
}

/// What is wrong with a number that is to be at most this in magnitude.
fn beyond<S: Scalar>(value: S, most: S) -> Option<ValueError> {
    // The comparison is false for NaN.
    if value.magnitude() <= most {
        None
    } else {
        Some(if value.is_finite() { ValueError::BeyondBudget } else { ValueError::NotFinite })
    }
}

/// The most half-spaces.
pub(super) const MOST_FACES: usize = 16;

/// Planes whose normals span a volume of less than `2^LEAST_VOLUME` do not bound a polyhedron: their corner is too far
/// away, or too uncertain.
const LEAST_VOLUME: i32 = -12;

impl<S: Scalar> Polyhedron<S> {
    /// What these half-spaces have in common. Its box, which is computed, is larger by a part.
    ///
    /// # Errors
    ///
    /// [`SizeError::FaceCount`] if there are no half-spaces or more than 16; [`SizeError::Unbounded`] if what they have
    /// in common is not bounded, or only by planes that are nearly parallel, or is empty; [`SizeError::Corner`] if it
    /// reaches beyond the budget.
    ///
    /// ```
    /// use raylet::{HalfSpace, Polyhedron, Ray, UnitVec3, Vec3};
    /// // All points with |x| + |y| + |z| <= 1.
    /// let faces = [1.0, -1.0].map(|x| [1.0, -1.0].map(|y| [1.0, -1.0].map(|z| Vec3::new(x, y, z))));
    /// let face = |normal: &Vec3<f64>| HalfSpace::new(Vec3::new(normal.x, 0.0, 0.0), *normal);
    /// let faces = faces.as_flattened().as_flattened().iter().map(face).collect::<Result<Vec<_>, _>>()?;
    /// let octahedron = Polyhedron::new(faces.leak())?;
    /// let ray = Ray::new(Vec3::new(-3.0, 0.25, 0.25), UnitVec3::X)?;
    /// assert_eq!(octahedron.hits(&ray).iter().map(|hit| hit.t).collect::<Vec<_>>(), [2.5, 3.5]);
    /// // Three of them bound nothing.
    /// let error = Polyhedron::new(&octahedron.half_spaces()[..3]).unwrap_err();
    /// assert_eq!(error.to_string(), "the half-spaces bound no solid, or only by planes that are nearly parallel");
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn new(faces: &'static [HalfSpace<S>]) -> Result<Self, SizeError> {
        if !(1..=MOST_FACES).contains(&faces.len()) {
            return Err(SizeError::FaceCount);
        }
        let (low, high) = around(faces).ok_or(SizeError::Unbounded)?;
        Self::within(low, high, faces)
    }

    /// What the box between these corners and the half-spaces have in common.
    ///
    /// # Errors
    ///
    /// [`SizeError::FaceCount`] if there are no half-spaces or more than 16; [`SizeError::Corner`] if a coordinate is
    /// not finite or beyond the budget; [`SizeError::HalfExtent`] if one of `high` is not larger than that of `low`.
    pub fn within(low: Vec3<S>, high: Vec3<S>, faces: &'static [HalfSpace<S>]) -> Result<Self, SizeError> {
        if !(1..=MOST_FACES).contains(&faces.len()) {
            return Err(SizeError::FaceCount);
        }
        let [low, high] = [low, high].map(|corner| corner.checked().map_err(SizeError::Corner));
        let corners @ [low, high] = [low?.to_array(), high?.to_array()];
        for (low, high) in low.into_iter().zip(high) {
            checked_size(high.minus(low), SizeError::HalfExtent)?;
        }
        Ok(Self { solid: CutBox::new(corners, faces) })
    }

    /// The line's interval in the half-spaces and in the box on the grid.
    #[inline(always)]
    fn clip<T: Guards>(&self, line: &LocalLine<S>, from: Option<Part>) -> Attempt<Clip<S>>
    where
        S: GridScalar,
    {
        let mut clip = Clip::new::<T>(from);
        for (part, face) in self.solid.facets() {
            found!(clip.by(line.half_space(face.point().to_array(), face.normal().to_array()), part));
        }
        let [low, high] = self.solid.corners;
        for (parts, axis) in FACES.into_iter().zip([0, 2, 1]) {
            found!(clip.by_slab(line, axis, [component(low, axis), component(high, axis)], parts));
        }
        Attempt::Hit(clip)
    }

    /// The half-spaces.
    pub const fn half_spaces(&self) -> &'static [HalfSpace<S>] {
        self.solid.stored()
    }

    /// The lowest and the highest corner of the box.
    pub const fn corners(&self) -> [Vec3<S>; 2] {
        let [[ax, ay, az], [bx, by, bz]] = self.solid.corners;
        [Vec3::new(ax, ay, az), Vec3::new(bx, by, bz)]
    }
}

/// Unit normal and distance from the origin of a plane.
type PlaneOf<S> = ([<S as crate::scalar::Numbers>::Real; 3], <S as crate::scalar::Numbers>::Real);

fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    R::sum_of_products([[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]])
}

/// A box around what the half-spaces have in common, larger by 1/16; `None` if that is not bounded.
fn around<S: Scalar>(faces: &[HalfSpace<S>]) -> Option<(Vec3<S>, Vec3<S>)> {
    let plane = |face: &HalfSpace<S>| -> PlaneOf<S> {
        let normal = face.unit_normal().real();
        (normal, dot(normal, face.point.real()))
    };
    let planes = || faces.iter().map(plane);
    let least = S::Real::ONE.scaled(LEAST_VOLUME);
    let mut found: Option<[[S::Real; 3]; 2]> = None;
    for (i, (a, at_a)) in planes().enumerate() {
        for (j, (b, at_b)) in planes().enumerate().skip(i + 1) {
            // A direction along both planes that leads out of no half-space.
            let along = cross(a, b);
            let leads_on = |sign: S::Real| {
                let others = planes().enumerate().filter(|(k, _)| *k != i && *k != j);
                others.into_iter().all(|(_, (n, _))| dot(n, along) * sign <= least * least)
            };
            if dot(along, along) >= least * least && (leads_on(S::Real::ONE) || leads_on(-S::Real::ONE)) {
                return None;
            }
            for (c, at_c) in planes().skip(j + 1) {
                let volume = dot(along, c);
                if volume.is_zero() {
                    continue;
                }
                let is_far = volume.abs() < least;
                let (of_a, of_b) = (cross(b, c), cross(c, a));
                let corner = pairs(along, pairs(of_a, of_b)).map(|(of_c, (of_a, of_b))| {
                    S::Real::sum_of_products([[at_a, of_a], [at_b, of_b], [at_c, of_c]]) / volume
                });
                let size = corner.map(S::Real::abs).into_iter().fold(at_a.abs(), |a, b| if a > b { a } else { b });
                // By so much the corner's own rounding may put it outside.
                let doubt = size.scaled(if is_far { -6 } else { S::Real::ROUNDING - LEAST_VOLUME + 4 });
                if planes().any(|(n, at)| dot(n, corner) - at > doubt) {
                    continue;
                }
                if is_far {
                    return None;
                }
                let [low, high] = found.unwrap_or([corner; 2]);
                let least = |a: S::Real, b: S::Real| if b < a { b } else { a };
                found = Some([
                    pairs(low, corner).map(|(low, c)| least(low, c)),
                    pairs(high, corner).map(|(high, c)| -least(-high, -c)),
                ]);
            }
        }
    }
    let [low, high] = found?;
    let margin = pairs(low, high)
        .map(|(low, high)| high - low)
        .into_iter()
        .fold(S::Real::ZERO, |a, b| if a > b { a } else { b })
        .scaled(-4);
    let outwards = |corner: [S::Real; 3], by: S::Real| Vec3::round(corner.map(|c| c + by));
    Some((outwards(low, -margin), outwards(high, margin)))
}

/// The axis that a face of the box is across, and whether it is at the highest coordinate.
const fn face(part: Part) -> (usize, bool) {
    match part {
        Part::Left => (0, false),
        Part::Right => (0, true),
        Part::Base => (1, false),
        Part::Back => (2, false),
        Part::Front => (2, true),
        _ => (1, true),
    }
}

impl<S> Described for Polyhedron<S> {
    const EQUATIONS: EquationKinds = EquationKinds::POLYHEDRON;
}

impl<S: Scalar> Geometry<S> for Polyhedron<S> {
    type In<R: Scalar> = Polyhedron<R>;

    /// None: the half-spaces are borrowed.
    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        None
    }

    fn largest_coordinate(&self) -> S {
        let [[ax, ay, az], [bx, by, bz]] = self.solid.corners;
        largest([ax, ay, az, bx, by, bz])
    }

    /// Four times as large, so that coordinates of the line leave two bits free: the grid multiplies differences of them.
    #[inline(always)]
    fn lengths(&self) -> S {
        let largest = self.largest_coordinate();
        let twice = largest.plus(largest);
        twice.plus(twice)
    }

    fn scaled(&self, e: i32) -> Self {
        Self { solid: self.solid.scaled(e) }
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
        solve::polyhedron(ray, self.solid, goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Polyhedron { solid: self.solid }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Box(self.solid)
    }

    /// The point moved to the plane of the face, along its normal; then into the box.
    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        let [low, high] = self.solid.corners;
        let on = if let Some(face) = self.solid.facet(part) {
            let (n, p) = (face.unit_normal().real(), point.real());
            let height = dot(n, pairs(face.point.real(), p).map(|(on, c)| on - c));
            pairs(p, n).map(|(c, n)| S::round(c + n * height))
        } else {
            let (axis, is_high) = face(part);
            with_component(point.to_array(), axis, component(if is_high { high } else { low }, axis))
        };
        let clamped = pairs(on, pairs(low, high)).map(|(c, (low, high))| {
            let c = if c > high { high } else { c };
            if c < low { low } else { c }
        });
        clamped.into()
    }

    fn normal(&self, _: Vec3<S>, part: Part) -> UnitVec3<S> {
        if let Some(face) = self.solid.facet(part) {
            return face.unit_normal();
        }
        match part {
            Part::Left => -UnitVec3::X,
            Part::Right => UnitVec3::X,
            Part::Base => -UnitVec3::Y,
            Part::Back => -UnitVec3::Z,
            Part::Front => UnitVec3::Z,
            _ => UnitVec3::Y,
        }
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        if self.solid.facet(part).is_some() {
            let (u, v) = self.tangents(point, part);
            return (coordinates::repeating(S::round(point.dot(u))), coordinates::repeating(S::round(point.dot(v))));
        }
        let [low, high] = self.solid.corners;
        // Halves: twice the largest size overflows.
        let halves = |axis: usize| [point.to_array(), low, high].map(|of| component(of, axis).real().scaled(-1));
        let share = |axis: usize| {
            let [c, low, high] = halves(axis);
            coordinates::fraction::<S>(c - low, high - low)
        };
        let against = |axis: usize| {
            let [c, low, high] = halves(axis);
            coordinates::fraction::<S>(high - c, high - low)
        };
        match part {
            Part::Left => (share(2), share(1)),
            Part::Right => (against(2), share(1)),
            Part::Back => (against(0), share(1)),
            Part::Front => (share(0), share(1)),
            _ => (share(0), share(2)),
        }
    }

    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        if self.solid.facet(part).is_some() {
            let normal = self.normal(point, part);
            let u = UnitVec3::from_real(UnitVec3::<S>::Y.cross(normal)).unwrap_or(UnitVec3::X);
            return (u, UnitVec3::from_real(normal.cross(u)).unwrap_or(UnitVec3::Y));
        }
        match part {
            Part::Left => (UnitVec3::Z, UnitVec3::Y),
            Part::Right => (-UnitVec3::Z, UnitVec3::Y),
            Part::Back => (-UnitVec3::X, UnitVec3::Y),
            Part::Front => (UnitVec3::X, UnitVec3::Y),
            _ => coordinates::planar_tangents(),
        }
    }
}

queries!(Polyhedron);
