//! Makes rays.

use crate::make;
use crate::number::Number;
use crate::status::{code, raylet_status};
use crate::storage::{get, raylet_ray, write};
use crate::value::raylet_vec3;
use core::mem::MaybeUninit;
use raylet::{Ray, UnitVec3};

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
    point: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
    ray: Option<&raylet_ray<f32>>,
    t: f32,
) -> raylet_status {
    code(write(point, || Ok(raylet_vec3::of(get(ray)?.at(t.scalar())))))
}

/// The direction of length 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_ray_direction_f32(
    direction: Option<&mut MaybeUninit<raylet_vec3<f32>>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(write(direction, || Ok(raylet_vec3::of_direction(get(ray)?.direction()))))
}
