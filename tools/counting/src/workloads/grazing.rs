//! Which rays graze a solid. Without them the most expensive rays are those that a user cannot foresee.

use raylet::scalar::UnitScalar;
use raylet::{Primitive, Vec3};
use shared::workload::Query;

/// A depth below the surface in radii there, an angle in radians, and ten times a distance of the start from the
/// surface in sizes. What is less is grazing.
const GRAZING: f64 = 1e-2;

/// A line in the primitive's coordinates.
#[derive(Clone, Copy)]
struct Line {
    origin: [f64; 3],
    /// Of length 1.
    direction: [f64; 3],
}

/// A side: the square of its radius at the height `y` is `a y^2 + 2 b y + r^2`.
#[derive(Clone, Copy)]
struct Side {
    a: f64,
    b: f64,
    r: f64,
}

impl Side {
    /// A cylinder or a cone: the radius at the height 0, and how fast it grows.
    fn straight(base: f64, slope: f64) -> Self {
        Self { a: slope * slope, b: base * slope, r: base }
    }

    fn square_at(self, y: f64) -> f64 {
        (self.a * y + 2.0 * self.b) * y + self.r * self.r
    }
}

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn of_length_1(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

impl Line {
    fn of(query: &Query<f64>) -> Self {
        let (ray, placement) = (&query.ray, query.shape.placement());
        let (from, d) = (ray.origin(), ray.direction().to_array().map(UnitScalar::to_f64));
        let origin = placement.point_to_local(from).to_array();
        let ahead = placement.point_to_local(from + Vec3::from(d)).to_array();
        let d = minus(ahead, origin);
        let length = dot(d, d).sqrt();
        Self { origin, direction: d.map(|c| c / length) }
    }

    /// Whether it is nearly parallel to the plane with this unit normal.
    fn is_parallel_to(self, normal: [f64; 3]) -> bool {
        dot(self.direction, normal).abs() < GRAZING.sin()
    }

    /// The sign of the discriminant of the line with a side whose radii are `scale` times as large: whether it meets
    /// that.
    fn meets(self, side: Side, scale: f64) -> bool {
        let ([x, y, z], [dx, dy, dz]) = (self.origin, self.direction);
        let square = scale * scale;
        let a = dx * dx + dz * dz - square * side.a * dy * dy;
        let k = x * dx + z * dz - square * (side.a * y + side.b) * dy;
        let c = x * x + z * z - square * side.square_at(y);
        k * k >= a * c
    }

    fn grazes_side(self, side: Side) -> bool {
        let ([x, y, z], [dx, dy, dz]) = (self.origin, self.direction);
        let to_axis = libm::atan2(libm::hypot(dx, dz), dy.abs());
        let to_generator = (to_axis - libm::atan(side.a.max(0.0).sqrt())).abs();
        let to_surface = (libm::hypot(x, z) - side.square_at(y).max(0.0).sqrt()).abs();
        self.meets(side, 1.0 - GRAZING) != self.meets(side, 1.0 + GRAZING)
            || to_axis.min(to_generator) < GRAZING
            || to_surface < GRAZING / 10.0
    }

    fn grazes_ball(self, height: f64, radius: f64) -> bool {
        let from = minus(self.origin, [0.0, height, 0.0]);
        let k = dot(from, self.direction);
        let distance = (dot(from, from) - k * k).max(0.0).sqrt();
        (distance / radius - 1.0).abs() < GRAZING
    }
}

impl Line {
    /// Any of the planes, of the cylinders about the edges and of the balls about the corners.
    fn grazes_rounded(self, [hx, hy, hz]: [f64; 3], radius: f64) -> bool {
        let corners = (0..8).map(|i| {
            let sign = |bit: i32, h: f64| if i & bit == 0 { h } else { -h };
            minus(self.origin, [sign(1, hx), sign(2, hy), sign(4, hz)])
        });
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let is_near = |distance: f64| (distance / radius - 1.0).abs() < GRAZING;
        axes.iter().any(|n| self.is_parallel_to(*n))
            || corners.into_iter().any(|from| {
                let ([x, y, z], [dx, dy, dz]) = (from, self.direction);
                let w = [y * dz - z * dy, z * dx - x * dz, x * dy - y * dx];
                let of_edge = |axis: usize| (w[axis].abs(), libm::sqrt(1.0 - self.direction[axis].powi(2)));
                is_near(libm::sqrt(dot(w, w)))
                    || [0, 1, 2].into_iter().map(of_edge).any(|(w, across)| across < GRAZING || is_near(w / across))
            })
    }
}

impl Line {
    /// Whether it enters a torus of a slightly larger minor radius another number of times than one of a slightly smaller
    /// one: the distance from the middle circle is compared with both at the ends of many small steps.
    fn grazes_torus(self, major: f64, minor: f64) -> bool {
        let (closest, reach) = (-dot(self.origin, self.direction), major + 2.0 * minor);
        let point = |t: f64| [0, 1, 2].map(|i| self.origin[i] + t * self.direction[i]);
        let off = |t: f64| {
            let [x, y, z] = point(t);
            libm::hypot(libm::hypot(x, z) - major, y) / minor
        };
        const STEPS: i32 = 2_000;
        let of_steps = (-STEPS..=STEPS).map(|step| off(closest + f64::from(step) / f64::from(STEPS) * reach));
        let all: Vec<f64> = of_steps.collect();
        let entries = |limit: f64| all.windows(2).filter(|pair| pair[0] > limit && pair[1] <= limit).count();
        entries(1.0 - GRAZING) != entries(1.0 + GRAZING) || (off(0.0) - 1.0).abs() < GRAZING / 10.0
    }
}

/// Whether the query's ray grazes one of the surfaces that its solid is made of, or starts next to it; `None` for a
/// solid that is not listed here.
pub fn grazes(query: &Query<f64>) -> Option<bool> {
    let line = Line::of(query);
    let is_level = || line.is_parallel_to([0.0, 1.0, 0.0]);
    Some(match query.shape.primitive() {
        Primitive::Sphere(sphere) => line.grazes_ball(0.0, sphere.radius()),
        Primitive::Cylinder(cylinder) => line.grazes_side(Side::straight(cylinder.radius(), 0.0)) || is_level(),
        Primitive::Capsule(capsule) => {
            let (r, h) = (capsule.radius(), capsule.height());
            line.grazes_side(Side::straight(r, 0.0)) || line.grazes_ball(0.0, r) || line.grazes_ball(h, r)
        }
        Primitive::Cone(cone) => {
            let base = cone.base_radius();
            let of_radii = || Some((cone.top_radius()? - base) / cone.height()?);
            let slope = cone.slope().or_else(of_radii).unwrap_or_default();
            line.grazes_side(Side::straight(base, slope)) || cone.height().is_some() && is_level()
        }
        Primitive::Revolved(revolved) => {
            let (a, b, r) = revolved.coefficients();
            line.grazes_side(Side { a, b, r }) || is_level()
        }
        Primitive::RoundCone(cone) => {
            let [r, top, h] = [cone.base_radius(), cone.top_radius(), cone.height()];
            let k = r - top;
            let cosine = (1.0 - k * k / (h * h)).sqrt();
            let side = Side::straight(r / cosine, -k / (h * cosine));
            line.grazes_side(side) || line.grazes_ball(0.0, r) || line.grazes_ball(h, top)
        }
        Primitive::Tube(tube) => {
            let sides = [tube.inner_radius(), tube.outer_radius()].map(|radius| Side::straight(radius, 0.0));
            sides.into_iter().any(|side| line.grazes_side(side)) || is_level()
        }
        Primitive::Disc(_) | Primitive::Annulus(_) | Primitive::Rectangle(_) => is_level(),
        Primitive::Plane(_) => is_level() || line.origin[1].abs() < GRAZING / 10.0,
        Primitive::Cuboid(_) => {
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].iter().any(|n| line.is_parallel_to(*n))
        }
        Primitive::RoundedCuboid(cuboid) => line.grazes_rounded(cuboid.half_extents(), cuboid.radius()),
        Primitive::Prism(prism) => {
            let corners = prism.corners();
            let next = corners.iter().cycle().skip(1);
            let mut sides = corners.iter().zip(next).map(|([ax, az], [bx, bz])| of_length_1([az - bz, 0.0, bx - ax]));
            sides.any(|n| line.is_parallel_to(n)) || is_level()
        }
        Primitive::Polyhedron(polyhedron) => {
            let mut facets = polyhedron.half_spaces().iter().map(|face| face.unit_normal().to_f64());
            let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter();
            facets.any(|n| line.is_parallel_to(n)) || axes.any(|n| line.is_parallel_to(n))
        }
        Primitive::Torus(torus) => line.grazes_torus(torus.major_radius(), torus.minor_radius()),
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.vertices().map(Vec3::to_array);
            let ([p, q, r], [x, y, z]) = (minus(b, a), minus(c, a));
            let n = [q * z - r * y, r * x - p * z, p * y - q * x];
            let length = dot(n, n).sqrt();
            line.is_parallel_to(n.map(|c| c / length))
        }
        // A primitive may be added.
        _ => return None,
    })
}
