//! The triangle.
//!
//! The line passes inside where the three vertices' cross products with it turn the same way (the signed volumes of
//! Segura and Feito, *Algorithms to test ray-triangle intersection*, 2001). The volume of an edge depends on its two
//! end points alone and changes its sign exactly when they are swapped, so that no ray slips between two triangles that
//! share an edge. A volume so small that its rounding could decide is made again in twice the precision, with what the
//! origin's rounding left over: a float ray that has stepped closer to one triangle and not to its larger neighbour is
//! still the same ray. (In the tier `Fast` it does not step, and nothing is made again.)

use super::plane::surface_hit;
use super::{Geometry, Line, SizeError, queries, surface_coordinates as coordinates};
use crate::arithmetic::Arithmetic;
use crate::figure::Figure;
use crate::part::Part;
use crate::scalar::{Plain, PlainLine, Real, Scalar, found, largest};
use crate::span::{End, Meeting, Span};
use crate::vector::{UnitVec3, Vec3, cross};

/// A triangle, its edges included; an open surface whose front is where its vertices run counter-clockwise.
///
/// ```
/// use raylet::{Crossing, Ray, Triangle, UnitVec3, Vec3};
/// let v = Vec3::new;
/// let triangle = Triangle::new(v(0.0_f32, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0))?;
/// let ray = Ray::new(v(0.25, 0.25, 3.0), -UnitVec3::Z)?;
/// assert_eq!(triangle.nearest(&ray).map(|hit| (hit.t, hit.crossing)), Some((3.0, Crossing::Enter)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Triangle<S> {
    vertices: [Vec3<S>; 3],
}

impl<S: Scalar> Triangle<S> {
    /// The triangle with these vertices.
    ///
    /// # Errors
    ///
    /// [`SizeError::Vertices`] if a vertex is not finite or beyond the budget, or if they lie on a line.
    pub fn new(a: Vec3<S>, b: Vec3<S>, c: Vec3<S>) -> Result<Self, SizeError> {
        let triangle = Self { vertices: [a, b, c] };
        if triangle.vertices.iter().all(|vertex| vertex.is_within_budget()) && triangle.unit_normal().is_some() {
            Ok(triangle)
        } else {
            Err(SizeError::Vertices)
        }
    }

    /// The vertices, in the order given.
    pub const fn vertices(&self) -> [Vec3<S>; 3] {
        self.vertices
    }

    /// The edges from the first vertex, of a power of two near 1 so that their products stay in range.
    fn edges(&self) -> [[S::Real; 3]; 2] {
        let [a, b, c] = self.vertices;
        let e = S::binary_exponent(self.reach());
        let [a, b, c] = [a, b, c].map(|vertex| vertex.to_array().map(|component| component.scaled(-e)));
        [difference::<S, S::Real>(b, a, S::real), difference::<S, S::Real>(c, a, S::real)]
    }

    fn unit_normal(&self) -> Option<UnitVec3<S>> {
        let [e1, e2] = self.edges();
        UnitVec3::from_real(cross(e1, e2))
    }

    /// Barycentric weights of the second and the third vertex, for a point of the triangle's plane.
    pub(crate) fn barycentric(&self, point: Vec3<S>) -> (S::Unit, S::Unit) {
        let e = S::binary_exponent(self.reach());
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

fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    R::sum_of_products([[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]])
}

impl<S: Scalar> Geometry<S> for Triangle<S> {
    /// The world's origin: two triangles that share an edge must see the ray from the same place.
    fn reach(&self) -> S {
        let [a, b, c] = self.vertices;
        largest([a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z])
    }

    fn scaled(&self, e: i32) -> Self {
        Self { vertices: self.vertices.map(|v| Vec3::new(v.x.scaled(e), v.y.scaled(e), v.z.scaled(e))) }
    }

    #[inline(always)]
    fn meet_plainly<T: Arithmetic<S>>(&self, line: &PlainLine<S>) -> Plain<Meeting<S>> {
        let (t, from_front) = found!(S::plain_triangle(*line, self.vertices.map(Vec3::to_array)));
        Plain::Found(surface_hit(t, from_front))
    }

    fn meet<T: Arithmetic<S>>(&self, line: &Line<S>) -> Meeting<S> {
        if line.departure.is_some() {
            return Meeting::Miss;
        }
        let (origin, rest, direction) = (line.point::<T>(), line.rest::<T>(), line.along::<T>());
        let vertices = self.vertices.map(|vertex| vertex.to_array().map(T::real));
        let [a, b, c] = vertices.map(|vertex| difference_of(difference_of(vertex, origin), rest));
        // From the vertices themselves, which are close together however far the ray starts.
        let [va, vb, vc] = vertices;
        let normal = cross(difference_of(vb, va), difference_of(vc, va));
        let (mut facing, mut distance) = (dot(normal, direction), dot(normal, a));
        let nearly = |value: T::Real, v: [T::Real; 3]| value.abs() < (size(normal) * size(v)).times_power_of_two(-4);
        if T::COMPENSATES && (nearly(facing, direction) || nearly(distance, a)) {
            // Nearly in the plane: both are what is left of larger products.
            [facing, distance] = careful_plane(vertices, origin, rest, direction);
        }
        if facing.is_zero() {
            return if distance.is_zero() {
                Self::lies_in::<T>(line, normal, direction, [a, b, c])
            } else {
                Meeting::Miss
            };
        }
        // d . (p x q): the side on which the line passes the edge from p to q, seen along it.
        let [ab, bc, ca] = [(a, b, va, vb), (b, c, vb, vc), (c, a, vc, va)].map(|(p, q, vp, vq)| {
            let volume = dot(direction, cross(p, q));
            // Past an edge so closely that rounding decides. What is asked here is the same for both of its triangles.
            let is_doubtful = T::COMPENSATES && volume.abs() < (size(p) * size(q)).times_power_of_two(-16);
            if is_doubtful { careful_volume(vp, vq, origin, rest, direction) } else { volume }
        });
        let passes = |sign: fn(T::Real) -> bool| !(sign(ab) || sign(bc) || sign(ca));
        let inside = if facing.is_negative() {
            passes(|volume| !volume.is_negative() && !volume.is_zero())
        } else {
            passes(Real::is_negative)
        };
        // The volumes add up to d . n, unless the triangle is smaller than the rounding of its distance: then nothing is
        // known of where the line passes.
        let is_noise = T::COMPENSATES && (ab + bc + ca - facing).abs() > facing.abs().times_power_of_two(-1);
        if inside && !is_noise {
            surface_hit(line.t::<T>(distance, facing), facing.is_negative())
        } else {
            Meeting::Miss
        }
    }

    fn figure(&self) -> Figure<S> {
        Figure::Triangle { vertices: self.vertices.map(Vec3::to_array) }
    }

    fn contains(&self, point: Vec3<S>) -> bool {
        let [a, b, c] = self.vertices.map(|v| difference::<S, S::Real>(v.to_array(), point.to_array(), S::real));
        let normal = cross(difference_of(b, a), difference_of(c, a));
        dot(normal, a).is_zero()
            && [(a, b), (b, c), (c, a)].iter().all(|(p, q)| !dot(normal, cross(*p, *q)).is_negative())
    }

    fn bounds(&self) -> (Vec3<S>, Vec3<S>) {
        let [a, b, c] = self.vertices;
        let least = |x: S, y: S| if y < x { y } else { x };
        let most = |x: S, y: S| if y > x { y } else { x };
        let each = |pick: fn(Vec3<S>) -> S, choose: &dyn Fn(S, S) -> S| choose(choose(pick(a), pick(b)), pick(c));
        (
            Vec3::new(each(|v| v.x, &least), each(|v| v.y, &least), each(|v| v.z, &least)),
            Vec3::new(each(|v| v.x, &most), each(|v| v.y, &most), each(|v| v.z, &most)),
        )
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

    fn uv(&self, point: Vec3<S>, _: Part) -> (S::Unit, S::Unit) {
        self.barycentric(point)
    }

    fn tangents(&self, _: Vec3<S>, _: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        let [e1, e2] = self.edges();
        (UnitVec3::from_real(e1).unwrap_or(UnitVec3::X), UnitVec3::from_real(e2).unwrap_or(UnitVec3::Z))
    }
}

fn difference_of<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The sum of the magnitudes of a vector's components.
fn size<R: Real>(v: [R; 3]) -> R {
    v[0].abs() + v[1].abs() + v[2].abs()
}

/// `a x b` of two vectors, each with what its rounding left over; so is the product.
fn careful_cross<R: Real>([a, ea]: [[R; 3]; 2], [b, eb]: [[R; 3]; 2]) -> [[R; 3]; 2] {
    let minor = |i: usize, j: usize| {
        R::sum_with_rest([[a[i], b[j]], [-a[j], b[i]], [a[i], eb[j]], [-a[j], eb[i]], [ea[i], b[j]], [-ea[j], b[i]]])
    };
    let [x, y, z] = [minor(1, 2), minor(2, 0), minor(0, 1)];
    [[x[0], y[0], z[0]], [x[1], y[1], z[1]]]
}

/// `a - b`, and what its rounding left over.
fn careful_difference<R: Real>(a: [R; 3], b: [R; 3], rest: [R; 3]) -> [[R; 3]; 2] {
    let [x, y, z] = [0, 1, 2].map(|i| R::sum_with_rest([[a[i], R::ONE], [-b[i], R::ONE], [-rest[i], R::ONE]]));
    [[x[0], y[0], z[0]], [x[1], y[1], z[1]]]
}

/// `d . n` and `(v - o) . n` for the normal n of the triangle, held to twice the precision.
#[cold]
fn careful_plane<R: Real>(vertices: [[R; 3]; 3], origin: [R; 3], rest: [R; 3], direction: [R; 3]) -> [R; 2] {
    let [a, b, c] = vertices;
    let nothing = [R::ZERO; 3];
    let [n, e] = careful_cross(careful_difference(b, a, nothing), careful_difference(c, a, nothing));
    let [p, u] = careful_difference(a, origin, rest);
    let d = direction;
    let facing = [[n[0], d[0]], [n[1], d[1]], [n[2], d[2]], [e[0], d[0]], [e[1], d[1]], [e[2], d[2]]];
    let distance = R::sum_of_products([
        [n[0], p[0]],
        [n[1], p[1]],
        [n[2], p[2]],
        [e[0], p[0]],
        [e[1], p[1]],
        [e[2], p[2]],
        [n[0], u[0]],
        [n[1], u[1]],
        [n[2], u[2]],
    ]);
    [R::sum_of_products(facing), distance]
}

/// `d . (p x q)` for the edge from one vertex to another, held to twice the precision, with the opposite sign to the bit
/// for the edge back.
#[cold]
fn careful_volume<R: Real>(from: [R; 3], to: [R; 3], origin: [R; 3], rest: [R; 3], d: [R; 3]) -> R {
    let forwards = from.partial_cmp(&to) != Some(core::cmp::Ordering::Greater);
    let (first, second) = if forwards { (from, to) } else { (to, from) };
    let [m, e] = careful_cross(careful_difference(first, origin, rest), careful_difference(second, origin, rest));
    let volume =
        R::sum_of_products([[d[0], m[0]], [d[1], m[1]], [d[2], m[2]], [d[0], e[0]], [d[1], e[1]], [d[2], e[2]]]);
    if forwards { volume } else { -volume }
}

impl<S: Scalar> Triangle<S> {
    /// The piece of a line of its plane that lies in the triangle: cut off by each edge in turn.
    #[cold]
    fn lies_in<T: Arithmetic<S>>(
        line: &Line<S>,
        normal: [T::Real; 3],
        direction: [T::Real; 3],
        vertices: [[T::Real; 3]; 3],
    ) -> Meeting<S> {
        let mut inside = Span::everywhere();
        let [a, b, c] = vertices;
        for (p, q) in [(a, b), (b, c), (c, a)] {
            // Points x with e . (x - p) >= 0 are on the inner side.
            let inward = cross(normal, difference_of(q, p));
            let (at_origin, slope) = (-dot(inward, p), dot(inward, direction));
            if slope.is_zero() {
                if at_origin.is_negative() {
                    return Meeting::Miss;
                }
                continue;
            }
            let end = End::new(line.t::<T>(-at_origin, slope), Part::Side);
            let half = if slope.is_negative() {
                Span::new(End::none(-S::INFINITY), end)
            } else {
                Span::new(end, End::none(S::INFINITY))
            };
            match inside.intersection(half) {
                Some(rest) => inside = rest,
                None => return Meeting::Miss,
            }
        }
        Meeting::LiesIn(inside)
    }
}

queries!(Triangle);
