//! The primitives under test: the crate's shape, the oracle's solid, and where their points are.

use super::exact_types::Exact;
use super::oracle::{ConeExtent, CylinderExtent, Dyadic, Solid};
use super::random::{Random, add, cross, normalize, scale};
use raylet::{Capsule, Cone, Cylinder, Disc, Plane, Shape, Sphere, Triangle, Vec3};

/// Every primitive of the design, with a name for tables.
pub const SUBJECTS: [&str; 16] = [
    "sphere",
    "cylinder infinite",
    "cylinder open",
    "cylinder capped",
    "capsule",
    "cone double",
    "cone nappe",
    "cone open",
    "cone capped",
    "frustum open",
    "frustum capped",
    "frustum widening",
    "frustum pointed",
    "plane",
    "disc",
    "triangle",
];

/// A primitive, as the crate and as the oracle see it.
pub struct Subject<S: Exact> {
    pub name: &'static str,
    pub shape: Shape<S>,
    pub solid: Solid,
    /// Radius at `y = 0` and at `y = height`, for sampling.
    outline: (f64, f64, f64),
}

fn size<S: Exact>(value: f64) -> S {
    S::from_f64(value).expect("a size that every tested type holds")
}

impl<S: Exact> Subject<S> {
    /// The subject of this name; sizes near 1, not round in binary.
    pub fn new(name: &'static str) -> Self {
        let (r, h, m) = (size::<S>(1.1), size::<S>(1.7), size::<S>(0.8));
        let (r0, r1) = (size::<S>(1.3), size::<S>(0.6));
        let exact = |value: S| value.exact();
        let radius = || exact(r);
        let (wide, tall, steep) = (1.1, 1.7, 0.8);
        let triangle = [[-1.1, 0.0, -0.7], [0.9, 0.3, -0.6], [0.2, -0.2, 1.2]];
        let (shape, solid, outline) = match name {
            "sphere" => (Shape::new(Sphere::new(r).unwrap()), Solid::Sphere { radius: radius() }, (wide, wide, 0.0)),
            "cylinder infinite" => (
                Shape::new(Cylinder::infinite(r).unwrap()),
                Solid::Cylinder { radius: radius(), extent: CylinderExtent::Infinite },
                (wide, wide, tall),
            ),
            "cylinder open" => (
                Shape::new(Cylinder::open(r, h).unwrap()),
                Solid::Cylinder { radius: radius(), extent: CylinderExtent::Open(exact(h)) },
                (wide, wide, tall),
            ),
            "cylinder capped" => (
                Shape::new(Cylinder::capped(r, h).unwrap()),
                Solid::Cylinder { radius: radius(), extent: CylinderExtent::Capped(exact(h)) },
                (wide, wide, tall),
            ),
            "capsule" => (
                Shape::new(Capsule::new(r, h).unwrap()),
                Solid::Capsule { radius: radius(), height: exact(h) },
                (wide, wide, tall),
            ),
            "cone double" => (
                Shape::new(Cone::double(m).unwrap()),
                Solid::Cone { slope: exact(m), extent: ConeExtent::Double },
                (0.0, steep * tall, tall),
            ),
            "cone nappe" => (
                Shape::new(Cone::nappe(m).unwrap()),
                Solid::Cone { slope: exact(m), extent: ConeExtent::Nappe },
                (0.0, steep * tall, tall),
            ),
            "cone open" => (
                Shape::new(Cone::open(m, h).unwrap()),
                Solid::Cone { slope: exact(m), extent: ConeExtent::Open(exact(h)) },
                (0.0, steep * tall, tall),
            ),
            "cone capped" => (
                Shape::new(Cone::capped(m, h).unwrap()),
                Solid::Cone { slope: exact(m), extent: ConeExtent::Capped(exact(h)) },
                (0.0, steep * tall, tall),
            ),
            "frustum open" => (
                Shape::new(Cone::frustum_open(r0, r1, h).unwrap()),
                Solid::Frustum { base_radius: exact(r0), top_radius: exact(r1), height: exact(h), capped: false },
                (1.3, 0.6, tall),
            ),
            "frustum capped" => (
                Shape::new(Cone::frustum(r0, r1, h).unwrap()),
                Solid::Frustum { base_radius: exact(r0), top_radius: exact(r1), height: exact(h), capped: true },
                (1.3, 0.6, tall),
            ),
            "frustum widening" => (
                Shape::new(Cone::frustum(r1, r0, h).unwrap()),
                Solid::Frustum { base_radius: exact(r1), top_radius: exact(r0), height: exact(h), capped: true },
                (0.6, 1.3, tall),
            ),
            "frustum pointed" => (
                Shape::new(Cone::frustum(r0, S::ZERO, h).unwrap()),
                Solid::Frustum { base_radius: exact(r0), top_radius: Dyadic::zero(), height: exact(h), capped: true },
                (1.3, 0.0, tall),
            ),
            "plane" => (Shape::new(Plane::new()), Solid::Plane, (2.0, 0.0, 0.0)),
            "disc" => (Shape::new(Disc::new(r).unwrap()), Solid::Disc { radius: radius() }, (wide, 0.0, 0.0)),
            "triangle" => {
                let vertices = triangle.map(|v| Vec3::from_f64(v).unwrap());
                (
                    Shape::new(Triangle::new(vertices[0], vertices[1], vertices[2]).unwrap()),
                    Solid::Triangle { vertices: vertices.map(|v: Vec3<S>| v.to_array().map(S::exact)) },
                    (0.6, 0.0, 0.0),
                )
            }
            _ => panic!("no subject of this name: {name}"),
        };
        Self { name, shape, solid, outline }
    }

    /// True for primitives without a curved side.
    pub fn is_flat(&self) -> bool {
        matches!(self.name, "plane" | "disc" | "triangle")
    }

    /// True for cones and frustums.
    pub fn is_cone(&self) -> bool {
        self.name.starts_with("cone") || self.name.starts_with("frustum")
    }

    /// The tangent of the angle between axis and side.
    pub fn slope(&self) -> f64 {
        let (base, top, height) = self.outline;
        (top - base) / height
    }

    /// A point well inside (of a flat primitive: on it).
    pub fn inner_point(&self, random: &mut Random) -> [f64; 3] {
        let (base, top, height) = self.outline;
        let angle = random.between(0.0, std::f64::consts::TAU);
        let around = random.unit().sqrt() * 0.8;
        if self.name == "sphere" {
            return random.direction().map(|c| c * around * base);
        }
        if self.is_flat() {
            // The triangle's centroid is the origin and its plane is tilted.
            let (x, z) = (libm::cos(angle) * around * base, libm::sin(angle) * around * base);
            return [x, 0.0, z];
        }
        let v = random.between(0.1, 0.9);
        let radius = (base + (top - base) * v) * around;
        [libm::cos(angle) * radius, v * height, libm::sin(angle) * radius]
    }

    /// A point of the curved side and the outward normal there.
    pub fn side_point(&self, random: &mut Random) -> ([f64; 3], [f64; 3]) {
        let (base, top, height) = self.outline;
        if self.name == "sphere" {
            let n = random.direction();
            return (n.map(|c| c * base), n);
        }
        let angle = random.between(0.0, std::f64::consts::TAU);
        if self.is_flat() {
            return (self.inner_point(random), [0.0, 1.0, 0.0]);
        }
        let v = random.between(0.1, 0.9);
        let radius = base + (top - base) * v;
        let slope = self.slope();
        let scale = 1.0 / (1.0 + slope * slope).sqrt();
        (
            [libm::cos(angle) * radius, v * height, libm::sin(angle) * radius],
            [libm::cos(angle) * scale, -slope * scale, libm::sin(angle) * scale],
        )
    }

    /// A point of a flat or a cap, and the normal there; `None` for solids that have none.
    pub fn flat_point(&self, random: &mut Random) -> Option<([f64; 3], [f64; 3])> {
        let (base, top, height) = self.outline;
        if let Solid::Triangle { vertices } = &self.solid {
            let [a, b, c] = vertices.each_ref().map(|vertex| vertex.each_ref().map(Dyadic::to_f64));
            let (along, across) = (add(b, scale(a, -1.0)), add(c, scale(a, -1.0)));
            // Folded at its third edge, the parallelogram is the triangle twice.
            let (u, v) = (random.unit(), random.unit());
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            return Some((add(a, add(scale(along, u), scale(across, v))), normalize(cross(along, across))));
        }
        let caps: &[(f64, f64)] = match self.name {
            "plane" | "disc" => &[(base, 0.0)],
            "cone capped" => &[(top, height)],
            "frustum pointed" => &[(base, 0.0)],
            "cylinder capped" | "frustum capped" | "frustum widening" => &[(base, 0.0), (top, height)],
            _ => return None,
        };
        let (radius, y) = random.pick(caps);
        let (angle, around) = (random.between(0.0, std::f64::consts::TAU), random.unit().sqrt() * radius);
        Some(([libm::cos(angle) * around, y, libm::sin(angle) * around], [0.0, 1.0, 0.0]))
    }

    /// A point of a rim (or seam, or the apex), where parts meet.
    pub fn rim_point(&self, random: &mut Random) -> [f64; 3] {
        let (base, top, height) = self.outline;
        let angle = random.between(0.0, std::f64::consts::TAU);
        let upper = random.next() & 1 == 0 && height > 0.0;
        let (radius, y) = if upper { (top, height) } else { (base, 0.0) };
        [libm::cos(angle) * radius, y, libm::sin(angle) * radius]
    }
}
