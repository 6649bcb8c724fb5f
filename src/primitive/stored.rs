//! Primitives as they are stored: by constructor and sizes, which the constructor checks when they are read.

use super::stored_lists::Kept;
use super::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Plane, Polyhedron, Prism, Rectangle, Revolved, RoundCone,
    RoundedCuboid, SizeError, Sphere, Torus, Triangle, Tube,
};
use crate::half_space::HalfSpace;
use crate::outline::{Extent, Outline};
use crate::scalar::Scalar;
use crate::scalar::written;
use crate::vector::Vec3;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Round<S> {
    #[serde(with = "written")]
    radius: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Long<S> {
    #[serde(with = "written")]
    radius: S,
    #[serde(with = "written")]
    height: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
#[expect(clippy::struct_field_names, reason = "a reader of a file should see that these are halves")]
struct Boxed<S> {
    #[serde(with = "written")]
    half_x: S,
    #[serde(with = "written")]
    half_y: S,
    #[serde(with = "written")]
    half_z: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Flat<S> {
    #[serde(with = "written")]
    half_x: S,
    #[serde(with = "written")]
    half_z: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Polygonal<S: 'static> {
    corners: Kept<[S; 2]>,
    #[serde(with = "written")]
    height: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Cut<S: 'static> {
    low: Vec3<S>,
    high: Vec3<S>,
    half_spaces: Kept<HalfSpace<S>>,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
enum AnyCylinder<S> {
    Infinite(Round<S>),
    Open(Long<S>),
    Capped(Long<S>),
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Radii<S> {
    #[serde(with = "written")]
    base_radius: S,
    #[serde(with = "written")]
    top_radius: S,
    #[serde(with = "written")]
    height: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Sloped<S> {
    #[serde(with = "written")]
    slope: S,
    #[serde(with = "written")]
    height: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
enum AnyCone<S> {
    Double {
        #[serde(with = "written")]
        slope: S,
    },
    Nappe {
        #[serde(with = "written")]
        slope: S,
    },
    Open(Sloped<S>),
    Capped(Sloped<S>),
    FrustumOpen(Radii<S>),
    Frustum(Radii<S>),
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Quadric<S> {
    #[serde(with = "written")]
    a: S,
    #[serde(with = "written")]
    b: S,
    #[serde(with = "written")]
    radius: S,
    #[serde(with = "written")]
    low: S,
    #[serde(with = "written")]
    high: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
enum AnyRevolved<S> {
    Open(Quadric<S>),
    Capped(Quadric<S>),
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Smooth<S> {
    #[serde(with = "written")]
    half_x: S,
    #[serde(with = "written")]
    half_y: S,
    #[serde(with = "written")]
    half_z: S,
    #[serde(with = "written")]
    radius: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Hollow<S> {
    #[serde(with = "written")]
    inner_radius: S,
    #[serde(with = "written")]
    outer_radius: S,
    #[serde(with = "written")]
    height: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct Ring<S> {
    #[serde(with = "written")]
    inner_radius: S,
    #[serde(with = "written")]
    outer_radius: S,
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
struct TwoRadii<S> {
    #[serde(with = "written")]
    major_radius: S,
    #[serde(with = "written")]
    minor_radius: S,
}

/// Implements both traits of a primitive by the form in which it is stored.
macro_rules! stored {
    ($Primitive:ident, $Stored:ty, |$primitive:ident| $to:expr, |$stored:pat_param| $from:expr) => {
        impl<S: Scalar> Serialize for $Primitive<S> {
            fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
                let $primitive = self;
                let stored: $Stored = $to;
                stored.serialize(serializer)
            }
        }

        impl<'de, S: Scalar> Deserialize<'de> for $Primitive<S> {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let $stored = <$Stored>::deserialize(deserializer)?;
                let built: Result<Self, SizeError> = $from;
                built.map_err(|error| D::Error::custom(format_args!("{}: {error}", stringify!($Primitive))))
            }
        }
    };
}

stored!(Sphere, Round<S>, |sphere| Round { radius: sphere.radius() }, |Round { radius }| Sphere::new(radius));
stored!(Disc, Round<S>, |disc| Round { radius: disc.radius() }, |Round { radius }| Disc::new(radius));
stored!(
    Capsule,
    Long<S>,
    |capsule| Long { radius: capsule.radius(), height: capsule.height() },
    |Long { radius, height }| Capsule::new(radius, height)
);
stored!(
    Cuboid,
    Boxed<S>,
    |cuboid| {
        let [half_x, half_y, half_z] = cuboid.half_extents();
        Boxed { half_x, half_y, half_z }
    },
    |Boxed { half_x, half_y, half_z }| Cuboid::new(half_x, half_y, half_z)
);
stored!(
    RoundedCuboid,
    Smooth<S>,
    |cuboid| {
        let [half_x, half_y, half_z] = cuboid.half_extents();
        Smooth { half_x, half_y, half_z, radius: cuboid.radius() }
    },
    |Smooth { half_x, half_y, half_z, radius }| RoundedCuboid::new(half_x, half_y, half_z, radius)
);
stored!(
    Rectangle,
    Flat<S>,
    |rectangle| {
        let [half_x, half_z] = rectangle.half_extents();
        Flat { half_x, half_z }
    },
    |Flat { half_x, half_z }| Rectangle::new(half_x, half_z)
);
stored!(Triangle, [Vec3<S>; 3], |triangle| triangle.vertices(), |[a, b, c]| Triangle::new(a, b, c));
stored!(
    Cylinder,
    AnyCylinder<S>,
    |cylinder| {
        let radius = cylinder.radius();
        match cylinder.extent {
            Extent::Double | Extent::Infinite => AnyCylinder::Infinite(Round { radius }),
            Extent::Open(height) => AnyCylinder::Open(Long { radius, height }),
            Extent::Capped(height) => AnyCylinder::Capped(Long { radius, height }),
        }
    },
    |stored| match stored {
        AnyCylinder::Infinite(Round { radius }) => Cylinder::infinite(radius),
        AnyCylinder::Open(Long { radius, height }) => Cylinder::open(radius, height),
        AnyCylinder::Capped(Long { radius, height }) => Cylinder::capped(radius, height),
    }
);
stored!(
    Cone,
    AnyCone<S>,
    |cone| match (cone.outline, cone.extent) {
        (Outline::Slope(slope), Extent::Infinite) => AnyCone::Nappe { slope },
        (Outline::Slope(slope), Extent::Open(height)) => AnyCone::Open(Sloped { slope, height }),
        (Outline::Slope(slope), Extent::Capped(height)) => AnyCone::Capped(Sloped { slope, height }),
        (Outline::Radii(base_radius, top_radius, height), Extent::Open(_)) => {
            AnyCone::FrustumOpen(Radii { base_radius, top_radius, height })
        }
        (Outline::Slope(slope), Extent::Double) => AnyCone::Double { slope },
        // The extent of a frustum is open or capped.
        (Outline::Radii(base_radius, top_radius, height), _) => {
            AnyCone::Frustum(Radii { base_radius, top_radius, height })
        }
    },
    |stored| match stored {
        AnyCone::Double { slope } => Cone::double(slope),
        AnyCone::Nappe { slope } => Cone::nappe(slope),
        AnyCone::Open(Sloped { slope, height }) => Cone::open(slope, height),
        AnyCone::Capped(Sloped { slope, height }) => Cone::capped(slope, height),
        AnyCone::FrustumOpen(Radii { base_radius, top_radius, height }) => {
            Cone::frustum_open(base_radius, top_radius, height)
        }
        AnyCone::Frustum(Radii { base_radius, top_radius, height }) => Cone::frustum(base_radius, top_radius, height),
    }
);
stored!(
    Revolved,
    AnyRevolved<S>,
    |revolved| {
        let ((a, b, radius), [low, high]) = (revolved.coefficients(), revolved.heights());
        let quadric = Quadric { a, b, radius, low, high };
        if revolved.is_open() { AnyRevolved::Open(quadric) } else { AnyRevolved::Capped(quadric) }
    },
    |stored| {
        let built = |Quadric { a, b, radius, low, high }| Revolved::new(a, b, radius, [low, high]);
        match stored {
            AnyRevolved::Open(quadric) => built(quadric).map(Revolved::open),
            AnyRevolved::Capped(quadric) => built(quadric),
        }
    }
);
stored!(
    RoundCone,
    Radii<S>,
    |cone| {
        let [base_radius, top_radius] = cone.radii;
        Radii { base_radius, top_radius, height: cone.height }
    },
    |Radii { base_radius, top_radius, height }| RoundCone::new(base_radius, top_radius, height)
);
stored!(
    Tube,
    Hollow<S>,
    |tube| {
        let [inner_radius, outer_radius] = tube.radii;
        Hollow { inner_radius, outer_radius, height: tube.height }
    },
    |Hollow { inner_radius, outer_radius, height }| Tube::new(inner_radius, outer_radius, height)
);
stored!(
    Annulus,
    Ring<S>,
    |annulus| {
        let [inner_radius, outer_radius] = annulus.radii;
        Ring { inner_radius, outer_radius }
    },
    |Ring { inner_radius, outer_radius }| Annulus::new(inner_radius, outer_radius)
);
stored!(
    Torus,
    TwoRadii<S>,
    |torus| TwoRadii { major_radius: torus.major_radius(), minor_radius: torus.minor_radius() },
    |TwoRadii { major_radius, minor_radius }| Torus::new(major_radius, minor_radius)
);
stored!(
    Prism,
    Polygonal<S>,
    |prism| Polygonal { corners: Kept(prism.corners()), height: prism.height() },
    |Polygonal { corners, height }| Prism::new(corners.0, height)
);
stored!(
    Polyhedron,
    Cut<S>,
    |polyhedron| {
        let [low, high] = polyhedron.corners();
        Cut { low, high, half_spaces: Kept(polyhedron.half_spaces()) }
    },
    |Cut { low, high, half_spaces }| {
        // As the constructor of a half-space would.
        let checked = |face: &HalfSpace<S>| HalfSpace::new(face.point(), face.normal()).map(|_| ());
        half_spaces.0.iter().try_for_each(checked).and_then(|()| Polyhedron::within(low, high, half_spaces.0))
    }
);
stored!(Plane, (), |_plane| (), |()| Ok(Plane::new()));
