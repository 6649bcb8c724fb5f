//! The triangle.
//!
//! The line passes inside if the three signed volumes that it spans with the edges have the same sign (Segura and
//! Feito, *Algorithms to test ray-triangle intersection*, 2001). The volume of an edge depends only on the line and the
//! edge's two end points, and changes its sign exactly when these are swapped, so that no ray passes between two
//! triangles that share an edge. Where rounding may decide the sign of a volume, the grid is unsure and the solver
//! decides (`solve::flat`).

use super::{Geometry, SizeError, queries, surface_coordinates as coordinates};
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::Hull;
use crate::grid::Guards;
use crate::grid::surface_hit;
use crate::intersection::Intersection;
use crate::number::{self, Ring};
use crate::part::Part;
use crate::scalar::{Attempt, FromScalar, GridScalar, Including, LocalLine, Real, Scalar, found, largest};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3, cross, pairs};

/// A triangle, its edges included; an open surface. Its front is the side from which its vertices are in
/// counter-clockwise order.
///
/// ```
/// use raylet::{Crossing, Ray, Triangle, UnitVec3, Vec3};
/// let v = Vec3::new;
/// let triangle = Triangle::new(v(0.0_f32, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0))?;
/// let ray = Ray::new(v(0.25, 0.25, 3.0), -UnitVec3::Z)?;
/// assert_eq!(triangle.nearest(&ray).map(|hit| (hit.t, hit.crossing)), Some((3.0, Crossing::Enter)));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<S> {
    vertices: [Vec3<S>; 3],
}

impl<S: Scalar> Triangle<S> {
    /// The triangle with these vertices.
    ///
    /// # Errors
    ///
    /// [`SizeError::Vertex`] if a vertex is not finite or beyond the budget, [`SizeError::Vertices`] if they lie on a
    /// line.
    pub fn new(a: Vec3<S>, b: Vec3<S>, c: Vec3<S>) -> Result<Self, SizeError> {
        let triangle = Self { vertices: [a, b, c] };
        for vertex in triangle.vertices {
            vertex.checked().map_err(SizeError::Vertex)?;
        }
        let [e1, e2] = triangle.edges();
        if UnitVec3::<S>::from_real(cross(e1, e2)).is_some() { Ok(triangle) } else { Err(SizeError::Vertices) }
    }

    /// The vertices, in the order given.
    pub const fn vertices(&self) -> [Vec3<S>; 3] {
        self.vertices
    }

    /// The edges from the first vertex, scaled by a power of two to lengths near 1, so that their products stay in
    /// range.
    fn edges(&self) -> [[S::Real; 3]; 2] {
        let [a, b, c] = self.vertices;
        let e = S::binary_exponent(self.largest_coordinate());
        let [a, b, c] = [a, b, c].map(|vertex| vertex.to_array().map(|component| component.scaled(-e)));
        [difference::<S, S::Real>(b, a, S::real), difference::<S, S::Real>(c, a, S::real)]
    }

    /// The cross product of the edges, of which each component is rounded once unless nearly all of it cancels: in
    /// floats it includes the rounding errors of the edges, which in a sliver are large relative to its width.
    fn unit_normal(&self) -> Option<UnitVec3<S>> {
        let [e1, e2] = self.edges();
        let normal = cross(e1, e2);
        if !S::RELATIVE {
            return UnitVec3::from_real(normal);
        }
        let [a, b, c] = self.vertices;
        let e = S::binary_exponent(self.largest_coordinate());
        let [a, b, c] = [a, b, c].map(|vertex| vertex.to_array().map(|component| component.scaled(-e).real()));
        let rest = |end: [S::Real; 3]| pairs(end, a).map(|(end, a)| end.plus_with_rest(-a)[1]);
        let (r1, r2) = (rest(b), rest(c));
        let more = pairs(plain_cross(r1, e2), plain_cross(e1, r2)).map(|(x, y)| x + y);
        let normal = pairs(normal, more).map(|(n, more)| n + more);
        // What is left is the rounding of the products of edges and rests.
        let square = |[x, y, z]: [S::Real; 3]| x * x + y * y + z * z;
        let lengths = square(e1) * square(e2);
        if square(normal) >= lengths.scaled(2 * S::Real::ROUNDING + 8) {
            return UnitVec3::from_real(normal);
        }
        self.robust_normal()
    }

    /// The normal in the robust number.
    #[cold]
    fn robust_normal(&self) -> Option<UnitVec3<S>> {
        let [a, b, c] = self.vertices.map(|vertex| vertex.to_array().map(<S::Robust as FromScalar<S>>::scalar));
        UnitVec3::from_robust(number::cross(number::difference(b, a), number::difference(c, a)))
    }

    /// Barycentric weights of the second and the third vertex, for a point of the triangle's plane.
    pub(crate) fn barycentric(&self, point: Vec3<S>) -> (S::Unit, S::Unit) {
        let e = S::binary_exponent(self.largest_coordinate());
        let [p, a] = [point, self.vertices[0]].map(|v| v.to_array().map(|component| component.scaled(-e)));
        let (to_point, [e1, e2]) = (difference::<S, S::Real>(p, a, S::real), self.edges());
        let normal = cross(e1, e2);
        let whole = dot(normal, normal);
        let weight = |x, y| coordinates::fraction::<S>(dot(cross(x, y), normal), whole);
        (weight(to_point, e2), weight(e1, to_point))
    }
}

fn difference<S: Scalar, R: Real>(a: [S; 3], b: [S; 3], real: impl Fn(S) -> R) -> [R; 3] {
    [0, 1, 2].map(|i| real(a[i]) - real(b[i]))
}

/// The cross product, rounded by each operation.
fn plain_cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    let minor = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    R::sum_of_products([[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]])
}

impl<S> Described for Triangle<S> {
    const EQUATIONS: EquationKinds = EquationKinds::TRIANGLE;
}

impl<S: Scalar> Geometry<S> for Triangle<S> {
    type In<R: Scalar> = Triangle<R>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(Triangle { vertices: self.vertices.map(Vec3::in_type) })
    }

    /// The largest coordinate of a vertex.
    fn largest_coordinate(&self) -> S {
        let [a, b, c] = self.vertices;
        largest([a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z])
    }

    fn scaled(&self, e: i32) -> Self {
        Self { vertices: self.vertices.map(|v| Vec3::new(v.x.scaled(e), v.y.scaled(e), v.z.scaled(e))) }
    }

    /// Does nothing: the triangle's intersection on the grid itself reduces the bits of the origin if necessary.
    #[inline(always)]
    fn fit(&self, _: &mut LocalLine<S>)
    where
        S: GridScalar,
    {
    }

    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        let (t, from_front) = found!(line.triangle(self.vertices.map(Vec3::to_array)));
        Attempt::Hit(surface_hit(t, from_front))
    }

    const HAS_CONSTANT_BOUNDS: bool = true;
    const HAS_FEW_FACTORS: bool = true;

    #[inline(always)]
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        solve::triangle(ray, self.vertices.map(Vec3::to_array), goal)
    }

    fn equations(&self) -> Equations<S> {
        Equations::Triangle { vertices: self.vertices.map(Vec3::to_array) }
    }

    fn hull(&self) -> Hull<S> {
        Hull::Points(self.vertices)
    }

    fn on_surface(&self, point: Vec3<S>, _: Part) -> Vec3<S> {
        let [nx, ny, nz] = self.normal(point, Part::Side).real();
        let offset = difference::<S, S::Real>(self.vertices[0].to_array(), point.to_array(), S::real);
        let height = dot([nx, ny, nz], offset);
        let [x, y, z] = point.real();
        Vec3::round([x + nx * height, y + ny * height, z + nz * height])
    }

    fn normal(&self, _: Vec3<S>, _: Part) -> UnitVec3<S> {
        self.unit_normal().unwrap_or(UnitVec3::Y)
    }

    fn bend(&self, _: Vec3<S>, _: Part) -> S {
        S::INFINITY
    }

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        self.barycentric(point)
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        let [e1, e2] = self.edges();
        (UnitVec3::from_real(e1).unwrap_or(UnitVec3::X), UnitVec3::from_real(e2).unwrap_or(UnitVec3::Z))
    }
}

queries!(Triangle);
