//! Written by `bindings/c/generate` from `src/in_f32/solids.rs`.

use crate::make;
use crate::number::Number;
use crate::number::i16f16;
use crate::status::{code, raylet_status};
use crate::storage::{get, pairs, put, raylet_frame, raylet_half_space, raylet_shape, values};
use crate::value::raylet_vec3;
use core::convert::Infallible;
use core::mem::MaybeUninit;
use raylet::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Ellipsoid, HalfSpace, Plane, Polyhedron, Prism, Rectangle,
    Revolved, RoundCone, RoundedCuboid, SizeError, Sphere, Torus, Triangle, Tube,
};

/// The plane y = 0, with its normal along +y.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_plane_i16f16(shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>) -> raylet_status {
    code(make::shape(shape, || Ok::<_, Infallible>(Plane::new())))
}

/// A ball about the origin.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_sphere_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Sphere::new(radius.scalar())))
}

/// A solid cylinder without ends about the y axis.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cylinder_infinite_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cylinder::infinite(radius.scalar())))
}

/// The side of a cylinder about the y axis, from y = 0 up: an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cylinder_open_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cylinder::open(radius.scalar(), height.scalar())))
}

/// A solid cylinder about the y axis, from y = 0 up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cylinder_capped_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cylinder::capped(radius.scalar(), height.scalar())))
}

/// A solid double cone without ends about the y axis, with its apex at the origin. `slope` is radius over height.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_double_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    slope: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cone::double(slope.scalar())))
}

/// The upper half of a double cone.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_nappe_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    slope: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cone::nappe(slope.scalar())))
}

/// The side of a cone from its apex at the origin up: an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_open_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    slope: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cone::open(slope.scalar(), height.scalar())))
}

/// A solid cone from its apex at the origin up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_capped_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    slope: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cone::capped(slope.scalar(), height.scalar())))
}

/// The side of a truncated cone from y = 0 up: an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frustum_open_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    base_radius: i16f16,
    top_radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cone::frustum_open(base_radius.scalar(), top_radius.scalar(), height.scalar())))
}

/// A solid truncated cone from y = 0 up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frustum_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    base_radius: i16f16,
    top_radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cone::frustum(base_radius.scalar(), top_radius.scalar(), height.scalar())))
}

/// A cylinder from y = 0 to `height` with half balls at its ends, which `height` excludes.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_capsule_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Capsule::new(radius.scalar(), height.scalar())))
}

/// The hull of two balls: about the origin, and about (0, height, 0).
#[unsafe(no_mangle)]
pub extern "C" fn raylet_round_cone_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    base_radius: i16f16,
    top_radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || RoundCone::new(base_radius.scalar(), top_radius.scalar(), height.scalar())))
}

/// A box about the origin, by half of its extents.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cuboid_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    half_x: i16f16,
    half_y: i16f16,
    half_z: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Cuboid::new(half_x.scalar(), half_y.scalar(), half_z.scalar())))
}

/// All points no farther than `radius` from a box about the origin, which is given by half of its extents.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_rounded_cuboid_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    half_x: i16f16,
    half_y: i16f16,
    half_z: i16f16,
    radius: i16f16,
) -> raylet_status {
    code(make::shape(shape, || RoundedCuboid::new(half_x.scalar(), half_y.scalar(), half_z.scalar(), radius.scalar())))
}

/// A solid tube about the y axis, from y = 0 up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_tube_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    inner_radius: i16f16,
    outer_radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Tube::new(inner_radius.scalar(), outer_radius.scalar(), height.scalar())))
}

/// A torus about the y axis, in the plane y = 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_torus_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    major_radius: i16f16,
    minor_radius: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Torus::new(major_radius.scalar(), minor_radius.scalar())))
}

/// A disc about the origin in the plane y = 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_disc_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Disc::new(radius.scalar())))
}

/// A disc with a round hole.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_annulus_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    inner_radius: i16f16,
    outer_radius: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Annulus::new(inner_radius.scalar(), outer_radius.scalar())))
}

/// A rectangle about the origin in the plane y = 0, by half of its extents.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_rectangle_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    half_x: i16f16,
    half_z: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Rectangle::new(half_x.scalar(), half_z.scalar())))
}

/// A triangle, anticlockwise as seen from its front.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_triangle_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    a: raylet_vec3<i16f16>,
    b: raylet_vec3<i16f16>,
    c: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::shape(shape, || Triangle::new(a.vector(), b.vector(), c.vector())))
}

/// The quadric of revolution x^2 + z^2 = a y^2 + 2 b y + radius^2, between two heights; `is_open` leaves out its caps.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_revolved_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    a: i16f16,
    b: i16f16,
    radius: i16f16,
    low: i16f16,
    high: i16f16,
    is_open: bool,
) -> raylet_status {
    code(make::shape(shape, || {
        let solid = Revolved::new(a.scalar(), b.scalar(), radius.scalar(), [low.scalar(), high.scalar()])?;
        Ok::<_, SizeError>(if is_open { solid.open() } else { solid })
    }))
}

/// A bowl from its vertex at the origin up, full.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_paraboloid_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    focal_length: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Revolved::paraboloid(focal_length.scalar(), height.scalar())))
}

/// An ellipsoid of revolution about the origin, between two heights.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_spheroid_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
    half_height: i16f16,
    low: i16f16,
    high: i16f16,
) -> raylet_status {
    code(make::shape(shape, || {
        Revolved::spheroid(radius.scalar(), half_height.scalar(), [low.scalar(), high.scalar()])
    }))
}

/// A ball about the origin between two heights.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ball_zone_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius: i16f16,
    low: i16f16,
    high: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Revolved::ball_zone(radius.scalar(), [low.scalar(), high.scalar()])))
}

/// A hyperboloid of one sheet with its waist at the origin, between two heights.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_hyperboloid_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    waist: i16f16,
    slope: i16f16,
    low: i16f16,
    high: i16f16,
) -> raylet_status {
    code(make::shape(shape, || Revolved::hyperboloid(waist.scalar(), slope.scalar(), [low.scalar(), high.scalar()])))
}

/// A hyperboloid of one sheet by its radii at both ends, its smaller waist, which is at y = 0, and its height.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_tower_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    base_radius: i16f16,
    waist: i16f16,
    top_radius: i16f16,
    height: i16f16,
) -> raylet_status {
    code(make::shape(shape, || {
        Revolved::tower(base_radius.scalar(), waist.scalar(), top_radius.scalar(), height.scalar())
    }))
}

/// A prism over a convex polygon with 3 to 16 corners, from y = 0 up. `corners` are `count` pairs of x and z,
/// counter-clockwise as seen from +y. They must stay where they are, unchanged, as long as the shape is used: they may
/// lie in flash.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_prism_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    corners: *const i16f16,
    count: usize,
    height: i16f16,
) -> raylet_status {
    code(make::shape_of(shape, || Ok(Prism::new(pairs(corners, count)?, height.scalar()))))
}

/// The half-space on the side of a plane that `normal` points away from. `point` is on the plane; `normal` has any
/// length.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_half_space_through_i16f16(
    half_space: Option<&mut MaybeUninit<raylet_half_space<i16f16>>>,
    point: raylet_vec3<i16f16>,
    normal: raylet_vec3<i16f16>,
) -> raylet_status {
    code(put(half_space, || make::value(HalfSpace::new(point.vector(), normal.vector()))))
}

/// What 1 to 16 half-spaces have in common, which must be bounded. They must stay where they are, unchanged, as long
/// as the shape is used.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_polyhedron_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    faces: *const raylet_half_space<i16f16>,
    count: usize,
) -> raylet_status {
    code(make::shape_of(shape, || Ok(Polyhedron::new(values(faces, count)?))))
}

/// What a box, from its lowest to its highest corner, has in common with up to 16 half-spaces, which must stay where
/// they are, unchanged, as long as the shape is used.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_polyhedron_within_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    low: raylet_vec3<i16f16>,
    high: raylet_vec3<i16f16>,
    faces: *const raylet_half_space<i16f16>,
    count: usize,
) -> raylet_status {
    code(make::shape_of(shape, || Ok(Polyhedron::within(low.vector(), high.vector(), values(faces, count)?))))
}

/// An ellipsoid about the origin, which places it already: `raylet_ellipsoid_in_frame_i16f16` turns and moves it.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ellipsoid_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius_x: i16f16,
    radius_y: i16f16,
    radius_z: i16f16,
) -> raylet_status {
    code(put(shape, || {
        let ellipsoid = make::value(Ellipsoid::new(radius_x.scalar(), radius_y.scalar(), radius_z.scalar()))?;
        make::value(make::value(ellipsoid.shape())?.among())
    }))
}

/// An ellipsoid about the origin of a frame, along its axes.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ellipsoid_in_frame_i16f16(
    shape: Option<&mut MaybeUninit<raylet_shape<i16f16>>>,
    radius_x: i16f16,
    radius_y: i16f16,
    radius_z: i16f16,
    frame: Option<&raylet_frame<i16f16>>,
) -> raylet_status {
    code(put(shape, || {
        let ellipsoid = make::value(Ellipsoid::new(radius_x.scalar(), radius_y.scalar(), radius_z.scalar()))?;
        make::value(make::value(ellipsoid.placed(*get(frame)?))?.among())
    }))
}
