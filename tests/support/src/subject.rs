//! The primitives under test: the crate's shape, the oracle's solid, and where their points are.

use super::described::{ConeExtent, CylinderExtent, Described};
use super::exact_types::Exact;
use super::oracle::{Dyadic, HalfSpace, Revolved, Solid};
use super::random::{Random, add, cross, dot, normalize, scale};
use raylet::Shape;

/// Every primitive of the design, with a name for tables.
pub const SUBJECTS: [&str; 27] = [
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
    "paraboloid",
    "hyperboloid",
    "round cone",
    "tube",
    "plane",
    "disc",
    "annulus",
    "triangle",
    "cuboid",
    "rounded cuboid",
    "rectangle",
    "prism",
    "polyhedron",
    "torus",
];

/// The half extents of the cuboid.
const CUBOID: [f64; 3] = [1.1, 0.85, 0.6];
/// The half extents of the core of the rounded cuboid, and its radius.
const ROUNDED: ([f64; 3], f64) = ([0.8, 0.55, 0.3], 0.3);
/// The corners of the prism.
const PENTAGON: [[f64; 2]; 5] = [[1.2, 0.3], [0.7, -0.9], [-0.5, -1.0], [-1.1, 0.2], [0.1, 1.1]];
/// The box of the polyhedron, and of each half-space a point and the normal.
const BOX: [[f64; 3]; 2] = [[-1.1, -0.7, -0.9], [1.2, 0.8, 1.1]];
const FACETS: [[[f64; 3]; 2]; 2] = [[[0.7, 0.8, 0.3], [0.6, 0.8, 0.3]], [[-0.6, 0.1, 0.9], [-0.7, 0.2, 0.5]]];
/// The major and the minor radius of the torus.
const TORUS: [f64; 2] = [1.1, 0.33];
/// The half extents of the rectangle.
const RECTANGLE: [f64; 2] = [1.3, 0.7];

/// A primitive, as the crate and as the oracle see it.
pub struct Subject<S: Exact> {
    pub name: &'static str,
    pub shape: Shape<S>,
    pub solid: Solid,
    /// Radius at `y = 0` and at `y = height`, for sampling.
    outline: (f64, f64, f64),
}

impl<S: Exact> Subject<S> {
    /// The subject of this name; sizes near 1, not round in binary.
    pub fn new(name: &'static str) -> Self {
        let (r, h, slope, wide, narrow) = (1.1, 1.7, 0.8, 1.3, 0.6);
        let frustum = |base, top, capped| Described::Frustum { base, top, height: h, capped };
        let quadric = |a, b, radius| Described::Revolved { a, b, radius, heights: [0.0, h], capped: true };
        let (described, outline) = match name {
            "sphere" => (Described::Sphere { radius: r }, (r, r, 0.0)),
            "cylinder infinite" => (Described::Cylinder { radius: r, extent: CylinderExtent::Infinite }, (r, r, h)),
            "cylinder open" => (Described::Cylinder { radius: r, extent: CylinderExtent::Open(h) }, (r, r, h)),
            "cylinder capped" => (Described::Cylinder { radius: r, extent: CylinderExtent::Capped(h) }, (r, r, h)),
            "capsule" => (Described::Capsule { radius: r, height: h }, (r, r, h)),
            "cone double" => (Described::Cone { slope, extent: ConeExtent::Double }, (0.0, slope * h, h)),
            "cone nappe" => (Described::Cone { slope, extent: ConeExtent::Nappe }, (0.0, slope * h, h)),
            "cone open" => (Described::Cone { slope, extent: ConeExtent::Open(h) }, (0.0, slope * h, h)),
            "cone capped" => (Described::Cone { slope, extent: ConeExtent::Capped(h) }, (0.0, slope * h, h)),
            "frustum open" => (frustum(wide, narrow, false), (wide, narrow, h)),
            "frustum capped" => (frustum(wide, narrow, true), (wide, narrow, h)),
            "frustum widening" => (frustum(narrow, wide, true), (narrow, wide, h)),
            "frustum pointed" => (frustum(wide, 0.0, true), (wide, 0.0, h)),
            "paraboloid" => (quadric(0.0, 0.5, 0.0), (0.0, 1.3, h)),
            "hyperboloid" => (quadric(0.9, -0.7, r), (r, 1.2, h)),
            "round cone" => (Described::RoundCone { base: r, top: narrow, height: h }, (r, narrow, h)),
            "tube" => (Described::Tube { inner: narrow, outer: r, height: h }, (r, r, h)),
            "plane" => (Described::Plane, (2.0, 0.0, 0.0)),
            "disc" => (Described::Disc { radius: r }, (r, 0.0, 0.0)),
            "annulus" => (Described::Annulus { inner: narrow, outer: r }, (r, 0.0, 0.0)),
            "triangle" => {
                let vertices = [[-1.1, 0.0, -0.7], [0.9, 0.3, -0.6], [0.2, -0.2, 1.2]];
                (Described::Triangle { vertices }, (0.6, 0.0, 0.0))
            }
            "cuboid" => (Described::Cuboid { half: CUBOID }, (0.0, 0.0, 1.0)),
            "rounded cuboid" => (Described::RoundedCuboid { half: ROUNDED.0, radius: ROUNDED.1 }, (0.0, 0.0, 1.0)),
            "prism" => (Described::Prism { corners: PENTAGON, height: h }, (1.0, 1.0, h)),
            "polyhedron" => (Described::Polyhedron { corners: BOX, facets: FACETS }, (1.0, 1.0, 1.0)),
            "torus" => {
                let [major, minor] = TORUS;
                (Described::Torus { major, minor }, (major, major, 0.0))
            }
            "rectangle" => (Described::Rectangle { half: RECTANGLE }, (RECTANGLE[1], 0.0, 0.0)),
            _ => panic!("no subject of this name: {name}"),
        };
        let sized = described.try_map(|size| S::from_f64(*size)).expect("sizes that every tested type holds");
        let shape = sized.shape().expect("sizes that every tested type holds");
        let solid = sized.solid();
        Self { name, shape, solid, outline }
    }

    /// True for primitives without a curved side.
    pub fn is_flat(&self) -> bool {
        matches!(self.name, "plane" | "disc" | "annulus" | "rectangle" | "triangle")
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

    /// The radius at a fraction of the height, and the tangent of the angle between axis and side there.
    fn side_at(&self, v: f64) -> (f64, f64) {
        let (base, top, height) = self.outline;
        let Solid::Revolved(Revolved { a, b, r, .. }) = &self.solid else {
            return (base + (top - base) * v, self.slope());
        };
        let (y, [a, b, r]) = (v * height, [a, b, r].map(Dyadic::to_f64));
        let radius = ((a * y + 2.0 * b) * y + r * r).sqrt();
        (radius, (a * y + b) / radius)
    }

    /// The radius of the hole of a tube or an annulus; zero of the others.
    fn hole(&self) -> f64 {
        match &self.solid {
            Solid::Tube { inner, .. } | Solid::Annulus { inner, .. } => inner.to_f64(),
            _ => 0.0,
        }
    }

    /// A point well inside (of a flat primitive: on it).
    pub fn inner_point(&self, random: &mut Random) -> [f64; 3] {
        let (base, _, height) = self.outline;
        let angle = random.between(0.0, std::f64::consts::TAU);
        let around = random.unit().sqrt() * 0.8;
        if self.hole() > 0.0 {
            let (y, radius) = (random.between(0.1, 0.9) * height, random.between(1.1 * self.hole(), 0.95 * base));
            return [libm::cos(angle) * radius, y, libm::sin(angle) * radius];
        }
        if self.name == "sphere" {
            return random.direction().map(|c| c * around * base);
        }
        if self.name == "torus" {
            return Self::point_of_torus(angle, random.between(0.0, std::f64::consts::TAU), around).0;
        }
        if let Some((half, _)) = self.core() {
            return half.map(|half| random.between(-0.9, 0.9) * half);
        }
        if let Some((point, _)) = self.face_point_of_half_spaces(random) {
            return point.map(|c| c * 0.95 * random.unit().cbrt());
        }
        if self.is_flat() {
            // The triangle's centroid is the origin and its plane is tilted.
            let (x, z) = (libm::cos(angle) * around * base, libm::sin(angle) * around * base);
            return [x, 0.0, z];
        }
        let v = random.between(0.1, 0.9);
        let radius = self.side_at(v).0 * around;
        [libm::cos(angle) * radius, v * height, libm::sin(angle) * radius]
    }

    /// The point of a torus so far around the axis and around the tube, from the outer equator upwards, at a share of
    /// the minor radius; and the outward normal there.
    fn point_of_torus(angle: f64, around: f64, share: f64) -> ([f64; 3], [f64; 3]) {
        let ([major, minor], [x, z]) = (TORUS, [libm::cos(angle), libm::sin(angle)]);
        let normal = [x * libm::cos(around), libm::sin(around), z * libm::cos(around)];
        (add(scale([x, 0.0, z], major), scale(normal, minor * share)), normal)
    }

    /// The half extents of the cuboid, or of the core of the rounded one, and its radius.
    fn core(&self) -> Option<([f64; 3], f64)> {
        match self.name {
            "cuboid" => Some((CUBOID, 0.0)),
            "rounded cuboid" => Some(ROUNDED),
            _ => None,
        }
    }

    /// The planes of a prism or a polyhedron: normals, and their inner products with points of the planes.
    fn planes(&self) -> Option<Vec<([f64; 3], f64)>> {
        let Solid::HalfSpaces(of) = &self.solid else { return None };
        let plane = |face: &HalfSpace| {
            let [normal, point] = [&face.normal, &face.point].map(|v| v.each_ref().map(Dyadic::to_f64));
            (normal, dot(normal, point))
        };
        Some(of.faces.iter().map(plane).collect())
    }

    /// Where a line from within leaves the planes, and the normal there.
    fn leave(planes: &[([f64; 3], f64)], from: [f64; 3], along: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let crossing = |(normal, at): &([f64; 3], f64)| {
            let slope = dot(*normal, along);
            (slope > 1e-9).then(|| ((at - dot(*normal, from)) / slope, *normal))
        };
        let first = planes.iter().filter_map(crossing).min_by(|a, b| a.0.total_cmp(&b.0));
        let (t, normal) = first.expect("it is bounded");
        (add(from, scale(along, t)), normalize(normal))
    }

    /// A point of a face of a prism or a polyhedron, and the outward normal there.
    fn face_point_of_half_spaces(&self, random: &mut Random) -> Option<([f64; 3], [f64; 3])> {
        // The origin is in the middle of the prism's base.
        let middle = [0.0, if self.name == "prism" { 0.5 * self.outline.2 } else { 0.0 }, 0.0];
        Some(Self::leave(&self.planes()?, middle, random.direction()))
    }

    /// A point of the face across the axis, and the outward normal there.
    fn face_point((half, radius): ([f64; 3], f64), random: &mut Random, axis: usize) -> ([f64; 3], [f64; 3]) {
        let (mut point, mut normal) = (half.map(|half| random.between(-0.9, 0.9) * half), [0.0; 3]);
        normal[axis] = random.sign();
        point[axis] = normal[axis] * (half[axis] + radius);
        (point, normal)
    }

    /// A point of an edge or a corner of the rounded cuboid, and the outward normal there.
    fn rounded_point((half, radius): ([f64; 3], f64), random: &mut Random) -> ([f64; 3], [f64; 3]) {
        let mut normal = random.direction();
        let mut point = [0, 1, 2].map(|axis| half[axis].copysign(normal[axis]));
        // A corner, or an edge along this axis.
        let along = random.below(4);
        if along < 3 {
            normal[along] = 0.0;
            normal = normalize(normal);
            point[along] = random.between(-0.9, 0.9) * half[along];
        }
        (add(point, scale(normal, radius)), normal)
    }

    /// A point of the curved side, or of a face at the sides, and the outward normal there.
    pub fn side_point(&self, random: &mut Random) -> ([f64; 3], [f64; 3]) {
        if let Some(core) = self.core() {
            if core.1 > 0.0 && random.below(2) == 0 {
                return Self::rounded_point(core, random);
            }
            let axis = random.pick(&[0, 2]);
            return Self::face_point(core, random, axis);
        }
        if let Some(found) = self.face_point_of_half_spaces(random) {
            return found;
        }
        let (base, _, height) = self.outline;
        if self.name == "sphere" {
            let n = random.direction();
            return (n.map(|c| c * base), n);
        }
        let angle = random.between(0.0, std::f64::consts::TAU);
        if self.name == "torus" {
            return Self::point_of_torus(angle, random.between(0.0, std::f64::consts::TAU), 1.0);
        }
        if self.is_flat() {
            return (self.inner_point(random), [0.0, 1.0, 0.0]);
        }
        let v = random.between(0.1, 0.9);
        if self.hole() > 0.0 && random.next() & 1 == 0 {
            let [x, z] = [libm::cos(angle), libm::sin(angle)];
            return ([x * self.hole(), v * height, z * self.hole()], [-x, 0.0, -z]);
        }
        let (radius, slope) = self.side_at(v);
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
        if let Some(core) = self.core() {
            return Some(Self::face_point(core, random, 1));
        }
        if let Some(found) = self.face_point_of_half_spaces(random) {
            return Some(found);
        }
        let caps: &[(f64, f64)] = match self.name {
            "plane" | "disc" | "annulus" | "rectangle" => &[(base, 0.0)],
            "cone capped" | "paraboloid" => &[(top, height)],
            "frustum pointed" => &[(base, 0.0)],
            "cylinder capped" | "frustum capped" | "frustum widening" | "hyperboloid" | "tube" => {
                &[(base, 0.0), (top, height)]
            }
            _ => return None,
        };
        let (radius, y) = random.pick(caps);
        let (angle, share) = (random.between(0.0, std::f64::consts::TAU), self.hole() / radius);
        let around = (share * share + (1.0 - share * share) * random.unit()).sqrt() * radius;
        Some(([libm::cos(angle) * around, y, libm::sin(angle) * around], [0.0, 1.0, 0.0]))
    }

    /// A point of a rim (or seam, or the apex), where parts meet; of a torus one of an equator or of the highest or the
    /// lowest circle.
    pub fn rim_point(&self, random: &mut Random) -> [f64; 3] {
        if let Some((half, radius)) = self.core() {
            // At one of the twelve edges, or at a seam beside one.
            let along = random.below(3);
            let mut point = half.map(|half| half * random.sign());
            point[along] *= random.unit();
            if radius > 0.0 {
                let across = (along + 1 + random.below(2)) % 3;
                point[across] += radius.copysign(point[across]);
            }
            return point;
        }
        if let (Some((from, normal)), Some(planes)) = (self.face_point_of_half_spaces(random), self.planes()) {
            // Along the face to its edge.
            return Self::leave(&planes, from, normalize(cross(normal, random.direction()))).0;
        }
        if self.name == "rectangle" {
            let [x, z] = RECTANGLE.map(|half| random.sign() * half);
            let inwards = random.unit();
            return if random.next() & 1 == 0 { [x * inwards, 0.0, z] } else { [x, 0.0, z * inwards] };
        }
        let (base, top, height) = self.outline;
        let angle = random.between(0.0, std::f64::consts::TAU);
        if self.name == "torus" {
            return Self::point_of_torus(angle, random.below(4) as f64 * std::f64::consts::FRAC_PI_2, 1.0).0;
        }
        let upper = random.next() & 1 == 0 && height > 0.0;
        let (radius, y) = if upper { (top, height) } else { (base, 0.0) };
        let radius = if self.hole() > 0.0 && random.next() & 1 == 0 { self.hole() } else { radius };
        [libm::cos(angle) * radius, y, libm::sin(angle) * radius]
    }
}
