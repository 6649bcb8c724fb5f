//! Lines and solids on a coarse grid, for the tests of the oracle.

use support::oracle::{ConeExtent, CylinderExtent, Dyadic, HalfSpaces, Line, Solid, exact_f64};

/// SplitMix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, bound: u64) -> i64 {
        (self.next() % bound) as i64
    }

    /// Within -bound..=bound.
    pub(crate) fn within(&mut self, bound: i64) -> i64 {
        self.below(2 * bound as u64 + 1) - bound
    }

    /// A line with coordinates in halves from -3 to 3, its direction in small integers; one in four on whole numbers
    /// and along axes and diagonals, where walls and generators are.
    pub(crate) fn line(&mut self) -> Line {
        loop {
            let (origin, direction): ([Dyadic; 3], [Dyadic; 3]) = if self.below(4) == 0 {
                (
                    std::array::from_fn(|_| Dyadic::from(self.within(2))),
                    std::array::from_fn(|_| Dyadic::from(self.within(1))),
                )
            } else {
                (
                    std::array::from_fn(|_| Dyadic::new(self.within(6), -1)),
                    std::array::from_fn(|_| Dyadic::from(self.within(3))),
                )
            };
            if direction.iter().any(|component| !component.is_zero()) {
                return Line::new(origin, direction);
            }
        }
    }
}

pub(crate) fn number(value: f64) -> Dyadic {
    exact_f64(value)
}

pub(crate) fn line(origin: [f64; 3], direction: [f64; 3]) -> Line {
    Line::new(origin.map(number), direction.map(number))
}

pub(crate) fn sphere(radius: f64) -> Solid {
    Solid::Sphere { radius: number(radius) }
}

pub(crate) fn cylinder(radius: f64, extent: CylinderExtent) -> Solid {
    Solid::Cylinder { radius: number(radius), extent }
}

pub(crate) fn capped_cylinder(radius: f64, height: f64) -> Solid {
    cylinder(radius, CylinderExtent::Capped(number(height)))
}

pub(crate) fn cone(slope: f64, extent: ConeExtent) -> Solid {
    Solid::Cone { slope: number(slope), extent }
}

pub(crate) fn frustum(base_radius: f64, top_radius: f64, height: f64, capped: bool) -> Solid {
    Solid::Frustum { base_radius: number(base_radius), top_radius: number(top_radius), height: number(height), capped }
}

pub(crate) fn capsule(radius: f64, height: f64) -> Solid {
    Solid::Capsule { radius: number(radius), height: number(height) }
}

pub(crate) fn triangle(vertices: [[f64; 3]; 3]) -> Solid {
    Solid::Triangle { vertices: vertices.map(|vertex| vertex.map(number)) }
}

pub(crate) fn cuboid(half: [f64; 3]) -> Solid {
    Solid::Cuboid { half: half.map(number) }
}

fn prism(corners: &[[f64; 2]], height: f64) -> Solid {
    let corners: Vec<_> = corners.iter().map(|corner| corner.map(number)).collect();
    Solid::HalfSpaces(HalfSpaces::prism(&corners, &number(height)))
}

fn torus(major: f64, minor: f64) -> Solid {
    Solid::Torus { major: number(major), minor: number(minor) }
}

fn polyhedron(corners: [[f64; 3]; 2], facets: &[[[f64; 3]; 2]]) -> Solid {
    let [low, high] = corners.map(|corner| corner.map(number));
    let facets: Vec<_> = facets.iter().map(|facet| facet.map(|v| v.map(number))).collect();
    Solid::HalfSpaces(HalfSpaces::polyhedron([&low, &high], &facets))
}

/// Solids whose answers are spans.
pub(crate) fn solids() -> Vec<Solid> {
    vec![
        sphere(1.5),
        cylinder(1.0, CylinderExtent::Infinite),
        capped_cylinder(1.0, 2.0),
        capped_cylinder(2.5, 0.5),
        cone(1.0, ConeExtent::Double),
        cone(0.5, ConeExtent::Double),
        cone(1.0, ConeExtent::Nappe),
        cone(0.5, ConeExtent::Nappe),
        cone(1.0, ConeExtent::Capped(number(2.0))),
        cone(2.0, ConeExtent::Capped(number(1.0))),
        frustum(2.0, 1.0, 2.0, true),
        frustum(1.0, 2.0, 1.0, true),
        frustum(1.0, 1.0, 1.5, true),
        frustum(0.0, 1.0, 1.0, true),
        frustum(2.0, 0.0, 2.0, true),
        cuboid([1.0, 2.0, 1.0]),
        cuboid([2.0, 0.5, 1.5]),
        capsule(1.0, 2.0),
        capsule(1.5, 0.0),
        capsule(0.5, 1.0),
        torus(1.5, 0.5),
        torus(2.0, 1.0),
        torus(1.0, 0.75),
        prism(&[[1.0, 0.5], [1.0, -0.5], [0.0, -1.0], [-1.0, -0.5], [-1.0, 1.0]], 2.0),
        polyhedron(
            [[-1.0, 0.0, -1.0], [1.0, 2.0, 0.5]],
            &[[[1.0, 1.0, 0.0], [1.0, 1.0, 0.0]], [[0.0; 3], [-1.0, -1.0, 1.0]]],
        ),
    ]
}

/// Open sides, each with the solid that it becomes by adding caps.
pub(crate) fn open_and_capped() -> Vec<(Solid, Solid)> {
    let mut pairs = vec![];
    for (radius, height) in [(1.0, 2.0), (2.5, 0.5)] {
        pairs.push((cylinder(radius, CylinderExtent::Open(number(height))), capped_cylinder(radius, height)));
    }
    for (slope, height) in [(1.0, 2.0), (0.5, 2.0), (2.0, 1.0)] {
        pairs.push((cone(slope, ConeExtent::Open(number(height))), cone(slope, ConeExtent::Capped(number(height)))));
    }
    for (base, top, height) in [(2.0, 1.0, 2.0), (1.0, 2.0, 1.0), (1.0, 1.0, 1.5), (0.0, 1.0, 1.0), (2.0, 0.0, 2.0)] {
        pairs.push((frustum(base, top, height, false), frustum(base, top, height, true)));
    }
    pairs
}
