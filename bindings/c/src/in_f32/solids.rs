//! Makes solids and open surfaces, in their canonical pose.

use crate::make;
use crate::number::Number;
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
pub extern "C" fn raylet_plane_f32(shape: Option<&mut MaybeUninit<raylet_shape<f32>>>) -> raylet_status {
    code(make::shape(shape, || Ok::<_, Infallible>(Plane::new())))
}

/// A ball about the origin.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_sphere_f32(shape: Option<&mut MaybeUninit<raylet_shape<f32>>>, radius: f32) -> raylet_status {
    code(make::shape(shape, || Sphere::new(radius.scalar())))
}

/// A solid cylinder without ends about the y axis.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cylinder_infinite_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius: f32,
) -> raylet_status {
    code(make::shape(shape, || Cylinder::infinite(radius.scalar())))
}

/// The side of a cylinder about the y axis, from y = 0 up: an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cylinder_open_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Cylinder::open(radius.scalar(), height.scalar())))
}

/// A solid cylinder about the y axis, from y = 0 up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cylinder_capped_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Cylinder::capped(radius.scalar(), height.scalar())))
}

/// A solid double cone without ends about the y axis, with its apex at the origin. `slope` is radius over height.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_double_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    slope: f32,
) -> raylet_status {
    code(make::shape(shape, || Cone::double(slope.scalar())))
}

/// The upper half of a double cone.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_nappe_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    slope: f32,
) -> raylet_status {
    code(make::shape(shape, || Cone::nappe(slope.scalar())))
}

/// The side of a cone from its apex at the origin up: an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_open_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    slope: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Cone::open(slope.scalar(), height.scalar())))
}

/// A solid cone from its apex at the origin up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cone_capped_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    slope: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Cone::capped(slope.scalar(), height.scalar())))
}

/// The side of a truncated cone from y = 0 up: an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frustum_open_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    base_radius: f32,
    top_radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Cone::frustum_open(base_radius.scalar(), top_radius.scalar(), height.scalar())))
}

/// A solid truncated cone from y = 0 up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frustum_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    base_radius: f32,
    top_radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Cone::frustum(base_radius.scalar(), top_radius.scalar(), height.scalar())))
}

/// A cylinder from y = 0 to `height` with half balls at its ends, which `height` excludes.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_capsule_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Capsule::new(radius.scalar(), height.scalar())))
}

/// The hull of two balls: about the origin, and about (0, height, 0).
#[unsafe(no_mangle)]
pub extern "C" fn raylet_round_cone_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    base_radius: f32,
    top_radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || RoundCone::new(base_radius.scalar(), top_radius.scalar(), height.scalar())))
}

/// A box about the origin, by half of its extents.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_cuboid_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    half_x: f32,
    half_y: f32,
    half_z: f32,
) -> raylet_status {
    code(make::shape(shape, || Cuboid::new(half_x.scalar(), half_y.scalar(), half_z.scalar())))
}

/// All points no farther than `radius` from a box about the origin, which is given by half of its extents.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_rounded_cuboid_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    half_x: f32,
    half_y: f32,
    half_z: f32,
    radius: f32,
) -> raylet_status {
    code(make::shape(shape, || RoundedCuboid::new(half_x.scalar(), half_y.scalar(), half_z.scalar(), radius.scalar())))
}

/// A solid tube about the y axis, from y = 0 up.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_tube_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    inner_radius: f32,
    outer_radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Tube::new(inner_radius.scalar(), outer_radius.scalar(), height.scalar())))
}

/// A torus about the y axis, in the plane y = 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_torus_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    major_radius: f32,
    minor_radius: f32,
) -> raylet_status {
    code(make::shape(shape, || Torus::new(major_radius.scalar(), minor_radius.scalar())))
}

/// A disc about the origin in the plane y = 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_disc_f32(shape: Option<&mut MaybeUninit<raylet_shape<f32>>>, radius: f32) -> raylet_status {
    code(make::shape(shape, || Disc::new(radius.scalar())))
}

/// A disc with a round hole.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_annulus_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    inner_radius: f32,
    outer_radius: f32,
) -> raylet_status {
    code(make::shape(shape, || Annulus::new(inner_radius.scalar(), outer_radius.scalar())))
}

/// A rectangle about the origin in the plane y = 0, by half of its extents.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_rectangle_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    half_x: f32,
    half_z: f32,
) -> raylet_status {
    code(make::shape(shape, || Rectangle::new(half_x.scalar(), half_z.scalar())))
}

/// A triangle, anticlockwise as seen from its front.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_triangle_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    a: raylet_vec3<f32>,
    b: raylet_vec3<f32>,
    c: raylet_vec3<f32>,
) -> raylet_status {
    code(make::shape(shape, || Triangle::new(a.vector(), b.vector(), c.vector())))
}

/// The quadric of revolution x^2 + z^2 = a y^2 + 2 b y + radius^2, between two heights; `is_open` leaves out its caps.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_revolved_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    a: f32,
    b: f32,
    radius: f32,
    low: f32,
    high: f32,
    is_open: bool,
) -> raylet_status {
    code(make::shape(shape, || {
        let solid = Revolved::new(a.scalar(), b.scalar(), radius.scalar(), [low.scalar(), high.scalar()])?;
        Ok::<_, SizeError>(if is_open { solid.open() } else { solid })
    }))
}

/// A bowl from its vertex at the origin up, full.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_paraboloid_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    focal_length: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || Revolved::paraboloid(focal_length.scalar(), height.scalar())))
}

/// An ellipsoid of revolution about the origin, between two heights.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_spheroid_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius: f32,
    half_height: f32,
    low: f32,
    high: f32,
) -> raylet_status {
    code(make::shape(shape, || {
        Revolved::spheroid(radius.scalar(), half_height.scalar(), [low.scalar(), high.scalar()])
    }))
}

/// A ball about the origin between two heights.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ball_zone_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius: f32,
    low: f32,
    high: f32,
) -> raylet_status {
    code(make::shape(shape, || Revolved::ball_zone(radius.scalar(), [low.scalar(), high.scalar()])))
}

/// A hyperboloid of one sheet with its waist at the origin, between two heights.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_hyperboloid_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    waist: f32,
    slope: f32,
    low: f32,
    high: f32,
) -> raylet_status {
    code(make::shape(shape, || Revolved::hyperboloid(waist.scalar(), slope.scalar(), [low.scalar(), high.scalar()])))
}

/// A hyperboloid of one sheet by its radii at both ends, its smaller waist, which is at y = 0, and its height.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_tower_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    base_radius: f32,
    waist: f32,
    top_radius: f32,
    height: f32,
) -> raylet_status {
    code(make::shape(shape, || {
        Revolved::tower(base_radius.scalar(), waist.scalar(), top_radius.scalar(), height.scalar())
    }))
}

/// A prism over a convex polygon with 3 to 16 corners, from y = 0 up. `corners` are `count` pairs of x and z,
/// counter-clockwise as seen from +y. They must stay where they are, unchanged, as long as the shape is used: they may
/// lie in flash.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_prism_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    corners: *const f32,
    count: usize,
    height: f32,
) -> raylet_status {
    code(make::shape_of(shape, || Ok(Prism::new(pairs(corners, count)?, height.scalar()))))
}

/// The half-space on the side of a plane that `normal` points away from. `point` is on the plane; `normal` has any
/// length.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_half_space_through_f32(
    half_space: Option<&mut MaybeUninit<raylet_half_space<f32>>>,
    point: raylet_vec3<f32>,
    normal: raylet_vec3<f32>,
) -> raylet_status {
    code(put(half_space, || make::value(HalfSpace::new(point.vector(), normal.vector()))))
}

/// What 1 to 16 half-spaces have in common, which must be bounded. They must stay where they are, unchanged, as long
/// as the shape is used.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_polyhedron_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    faces: *const raylet_half_space<f32>,
    count: usize,
) -> raylet_status {
    code(make::shape_of(shape, || Ok(Polyhedron::new(values(faces, count)?))))
}

/// What a box, from its lowest to its highest corner, has in common with up to 16 half-spaces, which must stay where
/// they are, unchanged, as long as the shape is used.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_polyhedron_within_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    low: raylet_vec3<f32>,
    high: raylet_vec3<f32>,
    faces: *const raylet_half_space<f32>,
    count: usize,
) -> raylet_status {
    code(make::shape_of(shape, || Ok(Polyhedron::within(low.vector(), high.vector(), values(faces, count)?))))
}

/// An ellipsoid about the origin, which places it already: `raylet_ellipsoid_in_frame_f32` turns and moves it.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ellipsoid_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius_x: f32,
    radius_y: f32,
    radius_z: f32,
) -> raylet_status {
    code(put(shape, || {
        let ellipsoid = make::value(Ellipsoid::new(radius_x.scalar(), radius_y.scalar(), radius_z.scalar()))?;
        make::value(make::value(ellipsoid.shape())?.among())
    }))
}

/// An ellipsoid about the origin of a frame, along its axes.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ellipsoid_in_frame_f32(
    shape: Option<&mut MaybeUninit<raylet_shape<f32>>>,
    radius_x: f32,
    radius_y: f32,
    radius_z: f32,
    frame: Option<&raylet_frame<f32>>,
) -> raylet_status {
    code(put(shape, || {
        let ellipsoid = make::value(Ellipsoid::new(radius_x.scalar(), radius_y.scalar(), radius_z.scalar()))?;
        make::value(make::value(ellipsoid.placed(*get(frame)?))?.among())
    }))
}
