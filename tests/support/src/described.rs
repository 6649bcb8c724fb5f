//! A primitive by its sizes, in whatever numbers they are given; and in a number type that holds them, the crate's
//! shape and the oracle's solid.

use super::exact_types::Exact;
use super::oracle::{self, Solid};
use raylet::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, HalfSpace, Plane, Polyhedron, Prism, Rectangle, Revolved,
    RoundCone, RoundedCuboid, Shape, SizeError, Sphere, Torus, Triangle, Tube, ValueError, Vec3,
};

/// How far a cylinder reaches along its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CylinderExtent<N> {
    Infinite,
    Open(N),
    Capped(N),
}

/// How far a cone reaches from its apex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ConeExtent<N> {
    Double,
    Nappe,
    Open(N),
    Capped(N),
}

/// A primitive and its sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Described<N> {
    Sphere {
        radius: N,
    },
    Cylinder {
        radius: N,
        extent: CylinderExtent<N>,
    },
    Cone {
        slope: N,
        extent: ConeExtent<N>,
    },
    Frustum {
        base: N,
        top: N,
        height: N,
        capped: bool,
    },
    Capsule {
        radius: N,
        height: N,
    },
    Revolved {
        a: N,
        b: N,
        radius: N,
        heights: [N; 2],
        capped: bool,
    },
    RoundCone {
        base: N,
        top: N,
        height: N,
    },
    Tube {
        inner: N,
        outer: N,
        height: N,
    },
    Torus {
        major: N,
        minor: N,
    },
    Plane,
    Disc {
        radius: N,
    },
    Annulus {
        inner: N,
        outer: N,
    },
    Cuboid {
        half: [N; 3],
    },
    RoundedCuboid {
        half: [N; 3],
        radius: N,
    },
    Prism {
        corners: [[N; 2]; 5],
        height: N,
    },
    /// Of each half-space a point and the normal.
    Polyhedron {
        corners: [[N; 3]; 2],
        facets: [[[N; 3]; 2]; 2],
    },
    Rectangle {
        half: [N; 2],
    },
    Triangle {
        vertices: [[N; 3]; 3],
    },
}

/// What a size is: the error of the constructor that refuses it.
type Size = fn(ValueError) -> SizeError;

impl<N> Described<N> {
    /// The name in tables.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Cylinder { extent: CylinderExtent::Infinite, .. } => "cylinder infinite",
            Self::Cylinder { extent: CylinderExtent::Open(_), .. } => "cylinder open",
            Self::Cylinder { extent: CylinderExtent::Capped(_), .. } => "cylinder capped",
            Self::Cone { extent: ConeExtent::Double, .. } => "cone double",
            Self::Cone { extent: ConeExtent::Nappe, .. } => "cone nappe",
            Self::Cone { extent: ConeExtent::Open(_), .. } => "cone open",
            Self::Cone { extent: ConeExtent::Capped(_), .. } => "cone capped",
            Self::Frustum { capped: false, .. } => "frustum open",
            Self::Frustum { capped: true, .. } => "frustum capped",
            Self::Capsule { .. } => "capsule",
            Self::Revolved { capped: false, .. } => "revolved open",
            Self::Revolved { capped: true, .. } => "revolved capped",
            Self::RoundCone { .. } => "round cone",
            Self::Tube { .. } => "tube",
            Self::Torus { .. } => "torus",
            Self::Plane => "plane",
            Self::Disc { .. } => "disc",
            Self::Annulus { .. } => "annulus",
            Self::Cuboid { .. } => "cuboid",
            Self::RoundedCuboid { .. } => "rounded cuboid",
            Self::Prism { .. } => "prism",
            Self::Polyhedron { .. } => "polyhedron",
            Self::Rectangle { .. } => "rectangle",
            Self::Triangle { .. } => "triangle",
        }
    }

    /// The same in numbers of another type; `f` makes one of each size.
    ///
    /// # Errors
    ///
    /// What is wrong with the first size that `f` refuses.
    pub fn try_map<M>(&self, f: impl Fn(&N) -> Result<M, ValueError>) -> Result<Described<M>, SizeError> {
        let of = |size: &N, what: Size| f(size).map_err(what);
        let (radius, height) = (SizeError::Radius as Size, SizeError::Height as Size);
        Ok(match self {
            Self::Sphere { radius: r } => Described::Sphere { radius: of(r, radius)? },
            Self::Cylinder { radius: r, extent } => {
                let extent = match extent {
                    CylinderExtent::Infinite => CylinderExtent::Infinite,
                    CylinderExtent::Open(h) => CylinderExtent::Open(of(h, height)?),
                    CylinderExtent::Capped(h) => CylinderExtent::Capped(of(h, height)?),
                };
                Described::Cylinder { radius: of(r, radius)?, extent }
            }
            Self::Cone { slope, extent } => {
                let extent = match extent {
                    ConeExtent::Double => ConeExtent::Double,
                    ConeExtent::Nappe => ConeExtent::Nappe,
                    ConeExtent::Open(h) => ConeExtent::Open(of(h, height)?),
                    ConeExtent::Capped(h) => ConeExtent::Capped(of(h, height)?),
                };
                Described::Cone { slope: of(slope, SizeError::Slope)?, extent }
            }
            Self::Frustum { base, top, height: h, capped } => Described::Frustum {
                base: of(base, radius)?,
                top: of(top, radius)?,
                height: of(h, height)?,
                capped: *capped,
            },
            Self::Capsule { radius: r, height: h } => {
                Described::Capsule { radius: of(r, radius)?, height: of(h, height)? }
            }
            Self::Revolved { a, b, radius: r, heights: [low, high], capped } => Described::Revolved {
                a: of(a, SizeError::Coefficient)?,
                b: of(b, SizeError::Coefficient)?,
                radius: of(r, radius)?,
                heights: [of(low, height)?, of(high, height)?],
                capped: *capped,
            },
            Self::RoundCone { base, top, height: h } => {
                Described::RoundCone { base: of(base, radius)?, top: of(top, radius)?, height: of(h, height)? }
            }
            Self::Tube { inner, outer, height: h } => {
                Described::Tube { inner: of(inner, radius)?, outer: of(outer, radius)?, height: of(h, height)? }
            }
            Self::Torus { major, minor } => Described::Torus { major: of(major, radius)?, minor: of(minor, radius)? },
            Self::Plane => Described::Plane,
            Self::Disc { radius: r } => Described::Disc { radius: of(r, radius)? },
            Self::Annulus { inner, outer } => {
                Described::Annulus { inner: of(inner, radius)?, outer: of(outer, radius)? }
            }
            Self::Cuboid { half: [x, y, z] } => {
                let half = |size| of(size, SizeError::HalfExtent);
                Described::Cuboid { half: [half(x)?, half(y)?, half(z)?] }
            }
            Self::RoundedCuboid { half: [x, y, z], radius: r } => {
                let half = |size| of(size, SizeError::HalfExtent);
                Described::RoundedCuboid { half: [half(x)?, half(y)?, half(z)?], radius: of(r, radius)? }
            }
            Self::Prism { corners, height: h } => {
                let corner = |[x, z]: &[N; 2]| Ok([of(x, SizeError::Corner)?, of(z, SizeError::Corner)?]);
                let [a, b, c, d, e] = corners.each_ref().map(corner);
                Described::Prism { corners: [a?, b?, c?, d?, e?], height: of(h, height)? }
            }
            Self::Polyhedron { corners, facets } => {
                let vector = |[x, y, z]: &[N; 3], what: Size| Ok([of(x, what)?, of(y, what)?, of(z, what)?]);
                let point = |v: &[N; 3]| vector(v, SizeError::Corner);
                let facet = |[p, normal]: &[[N; 3]; 2]| Ok([point(p)?, vector(normal, SizeError::Normal)?]);
                let corners = [point(&corners[0])?, point(&corners[1])?];
                Described::Polyhedron { corners, facets: [facet(&facets[0])?, facet(&facets[1])?] }
            }
            Self::Rectangle { half: [x, z] } => {
                let half = |size| of(size, SizeError::HalfExtent);
                Described::Rectangle { half: [half(x)?, half(z)?] }
            }
            Self::Triangle { vertices: [a, b, c] } => {
                let vertex = |[x, y, z]: &[N; 3]| {
                    let of = |coordinate| of(coordinate, SizeError::Vertex);
                    Ok([of(x)?, of(y)?, of(z)?])
                };
                Described::Triangle { vertices: [vertex(a)?, vertex(b)?, vertex(c)?] }
            }
        })
    }
}

impl<S: Exact> Described<S> {
    /// The crate's shape.
    ///
    /// # Errors
    ///
    /// Those of the primitive's constructor.
    pub fn shape(&self) -> Result<Shape<S>, SizeError> {
        Ok(match *self {
            Self::Sphere { radius } => Shape::new(Sphere::new(radius)?),
            Self::Cylinder { radius, extent } => Shape::new(match extent {
                CylinderExtent::Infinite => Cylinder::infinite(radius)?,
                CylinderExtent::Open(height) => Cylinder::open(radius, height)?,
                CylinderExtent::Capped(height) => Cylinder::capped(radius, height)?,
            }),
            Self::Cone { slope, extent } => Shape::new(match extent {
                ConeExtent::Double => Cone::double(slope)?,
                ConeExtent::Nappe => Cone::nappe(slope)?,
                ConeExtent::Open(height) => Cone::open(slope, height)?,
                ConeExtent::Capped(height) => Cone::capped(slope, height)?,
            }),
            Self::Frustum { base, top, height, capped: true } => Shape::new(Cone::frustum(base, top, height)?),
            Self::Frustum { base, top, height, capped: false } => Shape::new(Cone::frustum_open(base, top, height)?),
            Self::Capsule { radius, height } => Shape::new(Capsule::new(radius, height)?),
            Self::Revolved { a, b, radius, heights, capped } => {
                let revolved = Revolved::new(a, b, radius, heights)?;
                Shape::new(if capped { revolved } else { revolved.open() })
            }
            Self::RoundCone { base, top, height } => Shape::new(RoundCone::new(base, top, height)?),
            Self::Tube { inner, outer, height } => Shape::new(Tube::new(inner, outer, height)?),
            Self::Torus { major, minor } => Shape::new(Torus::new(major, minor)?),
            Self::Plane => Shape::new(Plane::new()),
            Self::Disc { radius } => Shape::new(Disc::new(radius)?),
            Self::Annulus { inner, outer } => Shape::new(Annulus::new(inner, outer)?),
            Self::Cuboid { half: [x, y, z] } => Shape::new(Cuboid::new(x, y, z)?),
            Self::RoundedCuboid { half: [x, y, z], radius } => Shape::new(RoundedCuboid::new(x, y, z, radius)?),
            // A prism borrows its corners for the rest of the program.
            Self::Prism { corners, height } => Shape::new(Prism::new(Vec::from(corners).leak(), height)?),
            Self::Polyhedron { corners: [low, high], facets } => {
                let [a, b] = facets.map(|[point, normal]| HalfSpace::new(point.into(), normal.into()));
                Shape::new(Polyhedron::within(low.into(), high.into(), Vec::from([a?, b?]).leak())?)
            }
            Self::Rectangle { half: [x, z] } => Shape::new(Rectangle::new(x, z)?),
            Self::Triangle { vertices } => {
                let [a, b, c] = vertices.map(Vec3::from);
                Shape::new(Triangle::new(a, b, c)?)
            }
        })
    }

    /// The oracle's solid: the same values, exactly.
    pub fn solid(&self) -> Solid {
        let exact = |value: S| value.exact();
        match *self {
            Self::Sphere { radius } => Solid::Sphere { radius: exact(radius) },
            Self::Cylinder { radius, extent } => {
                let extent = match extent {
                    CylinderExtent::Infinite => oracle::CylinderExtent::Infinite,
                    CylinderExtent::Open(height) => oracle::CylinderExtent::Open(exact(height)),
                    CylinderExtent::Capped(height) => oracle::CylinderExtent::Capped(exact(height)),
                };
                Solid::Cylinder { radius: exact(radius), extent }
            }
            Self::Cone { slope, extent } => {
                let extent = match extent {
                    ConeExtent::Double => oracle::ConeExtent::Double,
                    ConeExtent::Nappe => oracle::ConeExtent::Nappe,
                    ConeExtent::Open(height) => oracle::ConeExtent::Open(exact(height)),
                    ConeExtent::Capped(height) => oracle::ConeExtent::Capped(exact(height)),
                };
                Solid::Cone { slope: exact(slope), extent }
            }
            Self::Frustum { base, top, height, capped } => {
                let [base_radius, top_radius, height] = [base, top, height].map(exact);
                Solid::Frustum { base_radius, top_radius, height, capped }
            }
            Self::Capsule { radius, height } => Solid::Capsule { radius: exact(radius), height: exact(height) },
            Self::Revolved { a, b, radius, heights: [low, high], capped } => {
                let [a, b, r, low, high] = [a, b, radius, low, high].map(exact);
                Solid::Revolved(oracle::Revolved { a, b, r, low, high, capped })
            }
            Self::RoundCone { base, top, height } => {
                let [base_radius, top_radius, height] = [base, top, height].map(exact);
                oracle::RoundCone::solid(base_radius, top_radius, height)
            }
            Self::Tube { inner, outer, height } => {
                let [inner, outer, height] = [inner, outer, height].map(exact);
                Solid::Tube { inner, outer, height }
            }
            Self::Torus { major, minor } => Solid::Torus { major: exact(major), minor: exact(minor) },
            Self::Plane => Solid::Plane,
            Self::Disc { radius } => Solid::Disc { radius: exact(radius) },
            Self::Annulus { inner, outer } => Solid::Annulus { inner: exact(inner), outer: exact(outer) },
            Self::Cuboid { half } => Solid::Cuboid { half: half.map(exact) },
            Self::RoundedCuboid { half, radius } => {
                Solid::RoundedCuboid(oracle::RoundedCuboid { half: half.map(exact), radius: exact(radius) })
            }
            Self::Prism { corners, height } => {
                let corners = corners.map(|corner| corner.map(exact));
                Solid::HalfSpaces(oracle::HalfSpaces::prism(&corners, &exact(height)))
            }
            Self::Polyhedron { corners, facets } => {
                let [low, high] = corners.map(|corner| corner.map(exact));
                let facets = facets.map(|facet| facet.map(|v| v.map(exact)));
                Solid::HalfSpaces(oracle::HalfSpaces::polyhedron([&low, &high], &facets))
            }
            Self::Rectangle { half } => Solid::Rectangle { half: half.map(exact) },
            Self::Triangle { vertices } => Solid::Triangle { vertices: vertices.map(|vertex| vertex.map(exact)) },
        }
    }

    /// Its largest radius, height or coordinate of a vertex: what errors next to a ray's start are compared with. Of a
    /// plane, of a nappe and of a double cone, which have no such size, 1.
    pub fn size(&self) -> f64 {
        let largest = |sizes: &[S]| sizes.iter().map(|size| size.to_f64().abs()).fold(0.0, f64::max);
        match *self {
            Self::Sphere { radius }
            | Self::Disc { radius }
            | Self::Cylinder { radius, extent: CylinderExtent::Infinite } => largest(&[radius]),
            Self::Cylinder { radius, extent: CylinderExtent::Open(height) | CylinderExtent::Capped(height) }
            | Self::Capsule { radius, height } => largest(&[radius, height]),
            Self::Cone { slope, extent: ConeExtent::Open(height) | ConeExtent::Capped(height) } => {
                height.to_f64() * slope.to_f64().max(1.0)
            }
            Self::Frustum { base, top, height, .. } => largest(&[base, top, height]),
            Self::RoundCone { base, top, height } => largest(&[base, top, height]),
            Self::Tube { outer, height, .. } => largest(&[outer, height]),
            Self::Torus { major, minor } => major.to_f64() + minor.to_f64(),
            Self::Annulus { outer, .. } => largest(&[outer]),
            // The bounding box of the shape, which is a cylinder.
            Self::Revolved { heights: [low, high], .. } => {
                let bounds = self.shape().map(|shape| shape.bounds().high.x);
                largest(&[low, high, bounds.unwrap_or(high)])
            }
            Self::Plane | Self::Cone { extent: ConeExtent::Double | ConeExtent::Nappe, .. } => 1.0,
            Self::Cuboid { half } => largest(&half),
            Self::RoundedCuboid { half: [x, y, z], radius } => largest(&[x, y, z]) + radius.to_f64(),
            Self::Prism { corners, height } => largest(corners.as_flattened()).max(largest(&[height])),
            Self::Polyhedron { corners, .. } => largest(corners.as_flattened()),
            Self::Rectangle { half } => largest(&half),
            Self::Triangle { vertices } => largest(vertices.as_flattened()),
        }
    }
}
