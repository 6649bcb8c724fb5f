//! The functions of C in `f32`. (Those in `I16F16` are written from these by `bindings/c/generate`.)

use crate::ask;
use crate::make;
use crate::number::Number;
use crate::status::{code, raylet_status};
use crate::storage::{
    get, pairs, put, raylet_frame, raylet_half_space, raylet_node, raylet_ray, raylet_shape, raylet_shapes,
    raylet_surface, values, write,
};
use crate::value::{raylet_crossing, raylet_hit, raylet_hits, raylet_vec3};
use core::convert::Infallible;
use core::ffi::c_void;
use core::mem::MaybeUninit;
use raylet::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Ellipsoid, Exact, Fast, Frame, HalfSpace, Plain, Plane, Polyhedron,
    Prism, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, SizeError, Sphere, Stable, Torus, Triangle, Tube,
    UnitVec3,
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

/// The quadric of revolution x^2 + z^2 = radius^2 + 2 a y + b y^2, between two heights; `is_open` leaves out its
/// caps.
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

/// A tower that is narrowest between its ends.
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

/// Places a shape by a frame, instead of what placed it before.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_in_frame_f32(
    shape: Option<&mut raylet_shape<f32>>,
    frame: Option<&raylet_frame<f32>>,
) -> raylet_status {
    code(make::in_frame(shape, frame))
}

/// Places a shape by a frame, and stretches it along the axes of the frame by positive factors.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_stretched_f32(
    shape: Option<&mut raylet_shape<f32>>,
    frame: Option<&raylet_frame<f32>>,
    scale: raylet_vec3<f32>,
) -> raylet_status {
    code(make::stretched(shape, frame, scale))
}

/// Places a shape by a matrix: where its origin and its unit vectors along x, y and z go.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_in_matrix_f32(
    shape: Option<&mut raylet_shape<f32>>,
    position: raylet_vec3<f32>,
    x: raylet_vec3<f32>,
    y: raylet_vec3<f32>,
    z: raylet_vec3<f32>,
) -> raylet_status {
    code(make::in_matrix(shape, position, [x, y, z]))
}

/// Moves a shape, however it is placed.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_move_to_f32(
    shape: Option<&mut raylet_shape<f32>>,
    position: raylet_vec3<f32>,
) -> raylet_status {
    code(make::moved(shape, position))
}

/// Makes a shape seen from these sides only: a `raylet_visible`.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_seen_from_f32(shape: Option<&mut raylet_shape<f32>>, visible: u8) -> raylet_status {
    code(make::seen_from(shape, visible))
}

/// The box around a shape along the axes of the world; an infinite shape has the largest or infinite numbers.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_bounds_f32(
    shape: Option<&raylet_shape<f32>>,
    low: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
    high: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(ask::bounds(shape, low, high))
}

/// A frame along the axes of the world.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_at_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    position: raylet_vec3<f32>,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::at(position.vector()))))
}

/// A frame with its y axis along a vector of any length, for a solid whose base is there.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_base_and_axis_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    base: raylet_vec3<f32>,
    axis: raylet_vec3<f32>,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::from_base_and_axis(base.vector(), make::direction(axis)?))))
}

/// The same, for a solid of this height whose middle is there.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_centre_and_axis_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    centre: raylet_vec3<f32>,
    axis: raylet_vec3<f32>,
    height: f32,
) -> raylet_status {
    code(make::frame(frame, || {
        Ok(Frame::from_centre_and_axis(centre.vector(), make::direction(axis)?, height.scalar()))
    }))
}

/// A frame turned about an axis of any length through its position, counter-clockwise as seen from the tip of the
/// axis.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_turned_about_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    position: raylet_vec3<f32>,
    axis: raylet_vec3<f32>,
    degrees: f32,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::turned_about(position.vector(), make::direction(axis)?, degrees.scalar()))))
}

/// A frame turned by the quaternion (x, y, z, w), of any length near 1; its components are in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_quaternion_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    position: raylet_vec3<f32>,
    x: f32,
    y: f32,
    z: f32,
    w: f32,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::from_quaternion(position.vector(), [x, y, z, w].map(Number::unit)))))
}

/// A frame with its y axis from one point to another; the distance between them is the height of a solid that reaches
/// from one to the other.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_between_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    from: raylet_vec3<f32>,
    to: raylet_vec3<f32>,
    height: Option<&mut MaybeUninit<f32>>,
) -> raylet_status {
    code(make::between(frame, from, to, height))
}

/// A frame with its z axis along `forward`, and `up` towards its y axis; both of any length.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_looking_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    position: raylet_vec3<f32>,
    forward: raylet_vec3<f32>,
    up: raylet_vec3<f32>,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::looking(position.vector(), make::direction(forward)?, make::direction(up)?))))
}

/// A frame with these axes, which are nearly at right angles and right-handed, of any length.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_axes_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    position: raylet_vec3<f32>,
    x: raylet_vec3<f32>,
    y: raylet_vec3<f32>,
    z: raylet_vec3<f32>,
) -> raylet_status {
    code(make::frame(frame, || {
        let axes = [make::direction(x)?, make::direction(y)?, make::direction(z)?];
        Ok(Frame::from_axes(position.vector(), axes))
    }))
}

/// A frame that is given in another one, as a frame in the world.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_to_world_f32(
    frame: Option<&mut MaybeUninit<raylet_frame<f32>>>,
    outer: Option<&raylet_frame<f32>>,
    inner: Option<&raylet_frame<f32>>,
) -> raylet_status {
    code(make::frame(frame, || Ok(get(outer)?.frame_to_world(get(inner)?))))
}

/// A point of the world in the coordinates of a frame.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_point_to_local_f32(
    frame: Option<&raylet_frame<f32>>,
    point: raylet_vec3<f32>,
    out: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(write(out, || Ok(raylet_vec3::of(get(frame)?.point_to_local(point.vector())))))
}

/// A point in the coordinates of a frame in those of the world.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_point_to_world_f32(
    frame: Option<&raylet_frame<f32>>,
    point: raylet_vec3<f32>,
    out: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(write(out, || Ok(raylet_vec3::of(get(frame)?.point_to_world(point.vector())))))
}

/// A ray from a point towards a vector of any length. `t` is distance.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_along_f32(
    ray: Option<&mut MaybeUninit<raylet_ray<f32>>>,
    origin: raylet_vec3<f32>,
    direction: raylet_vec3<f32>,
) -> raylet_status {
    code(make::ray(ray, || Ok(Ray::new(origin.vector(), make::direction(direction)?))))
}

/// A ray from a point with a direction of length 1, whose components are in the unit of directions: as
/// `raylet_surface_normal_f32` gives them.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_in_direction_f32(
    ray: Option<&mut MaybeUninit<raylet_ray<f32>>>,
    origin: raylet_vec3<f32>,
    direction: raylet_vec3<f32>,
) -> raylet_status {
    code(make::ray(ray, || Ok(Ray::new(origin.vector(), make::value(UnitVec3::from_components(direction.units()))?))))
}

/// A ray from a point towards another.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_towards_f32(
    ray: Option<&mut MaybeUninit<raylet_ray<f32>>>,
    origin: raylet_vec3<f32>,
    target: raylet_vec3<f32>,
) -> raylet_status {
    code(make::ray(ray, || Ok(Ray::towards(origin.vector(), target.vector()))))
}

/// The ray from a point to another, which ends there.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_segment_f32(
    ray: Option<&mut MaybeUninit<raylet_ray<f32>>>,
    a: raylet_vec3<f32>,
    b: raylet_vec3<f32>,
) -> raylet_status {
    code(make::ray(ray, || Ok(Ray::segment(a.vector(), b.vector()))))
}

/// Sets the range of `t`; hits outside it are not reported. It is 0 to the largest number if it is not set.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_set_range_f32(ray: Option<&mut raylet_ray<f32>>, start: f32, end: f32) -> raylet_status {
    code(make::in_range(ray, start, end))
}

/// Says that a ray starts on this part of the surface of a shape, so that it does not meet that surface at once.
/// `leaving` is a `raylet_leaving`. `shape` is the index of the shape in its list; for a shape by itself it has no
/// effect.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_departing_f32(
    ray: Option<&mut raylet_ray<f32>>,
    shape: u32,
    part: u8,
    leaving: u8,
) -> raylet_status {
    code(make::departing(ray, shape, part, leaving))
}

/// The point at `t`.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_at_f32(
    ray: Option<&raylet_ray<f32>>,
    t: f32,
    point: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(write(point, || Ok(raylet_vec3::of(get(ray)?.at(t.scalar())))))
}

/// The direction of length 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_direction_f32(
    ray: Option<&raylet_ray<f32>>,
    direction: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(write(direction, || Ok(raylet_vec3::of_direction(get(ray)?.direction()))))
}

/// The nearest visible hit within the range of a ray: 1 and the hit, or 0. In the tier Stable, as all queries whose
/// names name no tier.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest::<_, Stable>(shape, ray, hit))
}

/// As `raylet_nearest_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_plain_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest::<_, Plain>(shape, ray, hit))
}

/// As `raylet_nearest_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_fast_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest::<_, Fast>(shape, ray, hit))
}

/// As `raylet_nearest_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_exact_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest::<_, Exact>(shape, ray, hit))
}

/// The nearest hit by the first numbers of the tier Stable alone: 1 and the hit, 0, or `RAYLET_ERROR_UNDECIDED`. For
/// the least flash, and the least time of the slowest ray.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_try_nearest_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::try_nearest::<_, Stable>(shape, ray, hit))
}

/// As `raylet_try_nearest_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_try_nearest_plain_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::try_nearest::<_, Plain>(shape, ray, hit))
}

/// As `raylet_try_nearest_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_try_nearest_fast_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::try_nearest::<_, Fast>(shape, ray, hit))
}

/// 1 if a ray hits the shape within its range, or 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occludes::<_, Stable>(shape, ray))
}

/// As `raylet_occludes_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_plain_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occludes::<_, Plain>(shape, ray))
}

/// As `raylet_occludes_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_fast_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occludes::<_, Fast>(shape, ray))
}

/// As `raylet_occludes_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_exact_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occludes::<_, Exact>(shape, ray))
}

/// 1 if a point is in the closed solid, or 0; 0 of an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_f32(shape: Option<&raylet_shape<f32>>, point: raylet_vec3<f32>) -> raylet_status {
    code(ask::contains::<_, Stable>(shape, point))
}

/// As `raylet_contains_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_plain_f32(
    shape: Option<&raylet_shape<f32>>,
    point: raylet_vec3<f32>,
) -> raylet_status {
    code(ask::contains::<_, Plain>(shape, point))
}

/// As `raylet_contains_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_fast_f32(
    shape: Option<&raylet_shape<f32>>,
    point: raylet_vec3<f32>,
) -> raylet_status {
    code(ask::contains::<_, Fast>(shape, point))
}

/// As `raylet_contains_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_exact_f32(
    shape: Option<&raylet_shape<f32>>,
    point: raylet_vec3<f32>,
) -> raylet_status {
    code(ask::contains::<_, Exact>(shape, point))
}

/// All visible hits within the range of a ray, sorted by `t`: their number, up to `RAYLET_MOST_HITS`.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hits: Option<&mut MaybeUninit<raylet_hits<f32>>>,
) -> raylet_status {
    code(ask::hits::<_, Stable>(shape, ray, hits))
}

/// As `raylet_all_hits_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_plain_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hits: Option<&mut MaybeUninit<raylet_hits<f32>>>,
) -> raylet_status {
    code(ask::hits::<_, Plain>(shape, ray, hits))
}

/// As `raylet_all_hits_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_fast_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hits: Option<&mut MaybeUninit<raylet_hits<f32>>>,
) -> raylet_status {
    code(ask::hits::<_, Fast>(shape, ray, hits))
}

/// As `raylet_all_hits_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_exact_f32(
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hits: Option<&mut MaybeUninit<raylet_hits<f32>>>,
) -> raylet_status {
    code(ask::hits::<_, Exact>(shape, ray, hits))
}

/// The surface of a shape at a hit of a ray with it.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_at_f32(
    surface: Option<&mut MaybeUninit<raylet_surface<f32>>>,
    shape: Option<&raylet_shape<f32>>,
    ray: Option<&raylet_ray<f32>>,
    hit: Option<&raylet_hit<f32>>,
) -> raylet_status {
    code(ask::surface(surface, shape, ray, hit))
}

/// The point of the hit.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_point_f32(
    surface: Option<&raylet_surface<f32>>,
    point: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(ask::of_surface(surface, point, |surface| raylet_vec3::of(surface.point())))
}

/// The outward normal, of length 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_normal_f32(
    surface: Option<&raylet_surface<f32>>,
    normal: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(ask::of_surface(surface, normal, |surface| raylet_vec3::of_direction(surface.normal())))
}

/// The normal on the side that the ray comes from.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_normal_towards_ray_f32(
    surface: Option<&raylet_surface<f32>>,
    normal: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(ask::of_surface(surface, normal, |surface| raylet_vec3::of_direction(surface.normal_towards_ray())))
}

/// The cosine of the angle between the ray and the normal, as a number: positive where the ray meets the outside.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_cosine_f32(
    surface: Option<&raylet_surface<f32>>,
    cosine: Option<&mut MaybeUninit<f32>>,
) -> raylet_status {
    code(ask::of_surface(surface, cosine, |surface| Number::from_scalar(surface.cosine())))
}

/// Surface coordinates, each from 0 to 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_uv_f32(
    surface: Option<&raylet_surface<f32>>,
    uv: Option<&mut MaybeUninit<[f32; 2]>>,
) -> raylet_status {
    code(ask::of_surface(surface, uv, |surface| {
        let (u, v) = surface.uv();
        [u, v].map(Number::from_unit)
    }))
}

/// Where the hit lies in the bounding box of the solid along its axes, each from 0 to 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_uvw_f32(
    surface: Option<&raylet_surface<f32>>,
    uvw: Option<&mut MaybeUninit<[f32; 3]>>,
) -> raylet_status {
    code(ask::of_surface(surface, uvw, |surface| surface.uvw().map(Number::from_unit)))
}

/// The directions in the world in which u and v grow, of length 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_tangents_f32(
    surface: Option<&raylet_surface<f32>>,
    along_u: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
    along_v: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
) -> raylet_status {
    code(ask::tangents(surface, along_u, along_v))
}

/// Makes a hierarchy of a list of shapes in the given nodes: `RAYLET_NODES(count)` of them. List and nodes must stay
/// where they are, unchanged, as long as it is used. To move a shape, change the list and build it again.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_build_f32(
    shapes: Option<&mut MaybeUninit<raylet_shapes<f32>>>,
    list: *const raylet_shape<f32>,
    count: usize,
    nodes: *mut raylet_node<f32>,
    node_count: usize,
) -> raylet_status {
    code(ask::build(shapes, list, count, nodes, node_count))
}

/// The nearest hit of a ray with any of the shapes: 1, the index of its shape and the hit; or 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_nearest_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Stable>(shapes, ray, shape, hit))
}

/// As `raylet_shapes_nearest_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_nearest_plain_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Plain>(shapes, ray, shape, hit))
}

/// As `raylet_shapes_nearest_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_nearest_fast_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Fast>(shapes, ray, shape, hit))
}

/// As `raylet_shapes_nearest_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_nearest_exact_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Exact>(shapes, ray, shape, hit))
}

/// 1 if a ray hits any of the shapes within its range, or 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_occlude_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occlude::<_, Stable>(shapes, ray))
}

/// As `raylet_shapes_occlude_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_occlude_plain_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occlude::<_, Plain>(shapes, ray))
}

/// As `raylet_shapes_occlude_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_occlude_fast_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occlude::<_, Fast>(shapes, ray))
}

/// As `raylet_shapes_occlude_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_occlude_exact_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::occlude::<_, Exact>(shapes, ray))
}

/// Calls `each` with every shape that a ray hits, in no order; the number of calls. The hits are there until it
/// returns.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_hits_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    each: Option<extern "C" fn(context: *mut c_void, shape: u32, hits: *const raylet_hits<f32>)>,
    context: *mut c_void,
) -> raylet_status {
    code(ask::hits_of::<_, Stable>(shapes, ray, each, context))
}

/// As `raylet_shapes_hits_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_hits_plain_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    each: Option<extern "C" fn(context: *mut c_void, shape: u32, hits: *const raylet_hits<f32>)>,
    context: *mut c_void,
) -> raylet_status {
    code(ask::hits_of::<_, Plain>(shapes, ray, each, context))
}

/// As `raylet_shapes_hits_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_hits_fast_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    each: Option<extern "C" fn(context: *mut c_void, shape: u32, hits: *const raylet_hits<f32>)>,
    context: *mut c_void,
) -> raylet_status {
    code(ask::hits_of::<_, Fast>(shapes, ray, each, context))
}

/// As `raylet_shapes_hits_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_hits_exact_f32(
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
    each: Option<extern "C" fn(context: *mut c_void, shape: u32, hits: *const raylet_hits<f32>)>,
    context: *mut c_void,
) -> raylet_status {
    code(ask::hits_of::<_, Exact>(shapes, ray, each, context))
}

/// All crossings of a ray with up to `RAYLET_MOST_SOLIDS` solids, in order, and which solids it is inside of between
/// them: their number, up to `capacity` and `RAYLET_MOST_CROSSINGS`. Where solids touch, the order is that of one
/// solid after the other; see the documentation of `raylet::solids`.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_crossings_f32(
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
) -> raylet_status {
    code(ask::crossings::<_, Stable>(list, count, ray, crossings, capacity))
}

/// As `raylet_crossings_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_crossings_plain_f32(
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
) -> raylet_status {
    code(ask::crossings::<_, Plain>(list, count, ray, crossings, capacity))
}

/// As `raylet_crossings_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_crossings_fast_f32(
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
) -> raylet_status {
    code(ask::crossings::<_, Fast>(list, count, ray, crossings, capacity))
}

/// As `raylet_crossings_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_crossings_exact_f32(
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
) -> raylet_status {
    code(ask::crossings::<_, Exact>(list, count, ray, crossings, capacity))
}
