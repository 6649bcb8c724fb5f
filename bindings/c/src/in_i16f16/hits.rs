//! Written by `bindings/c/generate` from `src/in_f32/hits.rs`.

use crate::ask;
use crate::number::Number;
use crate::number::i16f16;
use crate::status::{code, raylet_status};
use crate::storage::{raylet_ray, raylet_shape, raylet_surface};
use crate::value::{raylet_hit, raylet_hits, raylet_vec3};
use core::mem::MaybeUninit;
use raylet::{Exact, Fast, Plain, Stable};

/// The nearest visible hit within the range of a ray: 1 and the hit, or 0. In the tier Stable, as all queries whose
/// names name no tier.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_i16f16(
    hit: Option<&mut MaybeUninit<raylet_hit<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::nearest::<_, Stable>(hit, shape, ray))
}

/// As `raylet_nearest_i16f16`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_plain_i16f16(
    hit: Option<&mut MaybeUninit<raylet_hit<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::nearest::<_, Plain>(hit, shape, ray))
}

/// As `raylet_nearest_i16f16`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_fast_i16f16(
    hit: Option<&mut MaybeUninit<raylet_hit<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::nearest::<_, Fast>(hit, shape, ray))
}

/// As `raylet_nearest_i16f16`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_nearest_exact_i16f16(
    hit: Option<&mut MaybeUninit<raylet_hit<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::nearest::<_, Exact>(hit, shape, ray))
}

/// The nearest hit by the first numbers of the tier Stable alone: 1 and the hit, 0, or `RAYLET_ERROR_UNDECIDED`. For
/// the least flash, and the least time of the slowest ray.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_try_nearest_i16f16(
    hit: Option<&mut MaybeUninit<raylet_hit<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::try_nearest::<_, Stable>(hit, shape, ray))
}

/// As `raylet_try_nearest_i16f16`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_try_nearest_plain_i16f16(
    hit: Option<&mut MaybeUninit<raylet_hit<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::try_nearest::<_, Plain>(hit, shape, ray))
}

/// As `raylet_try_nearest_i16f16`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_try_nearest_fast_i16f16(
    hit: Option<&mut MaybeUninit<raylet_hit<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::try_nearest::<_, Fast>(hit, shape, ray))
}

/// 1 if a ray hits the shape within its range, or 0.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::occludes::<_, Stable>(shape, ray))
}

/// As `raylet_occludes_i16f16`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_plain_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::occludes::<_, Plain>(shape, ray))
}

/// As `raylet_occludes_i16f16`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_fast_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::occludes::<_, Fast>(shape, ray))
}

/// As `raylet_occludes_i16f16`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_occludes_exact_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::occludes::<_, Exact>(shape, ray))
}

/// 1 if a point is in the closed solid, or 0; 0 of an open surface.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    point: raylet_vec3<i16f16>,
) -> raylet_status {
    code(ask::contains::<_, Stable>(shape, point))
}

/// As `raylet_contains_i16f16`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_plain_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    point: raylet_vec3<i16f16>,
) -> raylet_status {
    code(ask::contains::<_, Plain>(shape, point))
}

/// As `raylet_contains_i16f16`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_fast_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    point: raylet_vec3<i16f16>,
) -> raylet_status {
    code(ask::contains::<_, Fast>(shape, point))
}

/// As `raylet_contains_i16f16`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_contains_exact_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    point: raylet_vec3<i16f16>,
) -> raylet_status {
    code(ask::contains::<_, Exact>(shape, point))
}

/// All visible hits within the range of a ray, sorted by `t`: their number, up to `RAYLET_MOST_HITS`.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_i16f16(
    hits: Option<&mut MaybeUninit<raylet_hits<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::hits::<_, Stable>(hits, shape, ray))
}

/// As `raylet_all_hits_i16f16`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_plain_i16f16(
    hits: Option<&mut MaybeUninit<raylet_hits<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::hits::<_, Plain>(hits, shape, ray))
}

/// As `raylet_all_hits_i16f16`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_fast_i16f16(
    hits: Option<&mut MaybeUninit<raylet_hits<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::hits::<_, Fast>(hits, shape, ray))
}

/// As `raylet_all_hits_i16f16`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_all_hits_exact_i16f16(
    hits: Option<&mut MaybeUninit<raylet_hits<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
) -> raylet_status {
    code(ask::hits::<_, Exact>(hits, shape, ray))
}

/// The surface of a shape at a hit of a ray with it.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_at_i16f16(
    surface: Option<&mut MaybeUninit<raylet_surface<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
    hit: Option<&raylet_hit<i16f16>>,
) -> raylet_status {
    code(ask::surface(surface, shape, ray, hit))
}

/// The point of the hit.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_point_i16f16(
    point: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    surface: Option<&raylet_surface<i16f16>>,
) -> raylet_status {
    code(ask::of_surface(point, surface, |surface| raylet_vec3::of(surface.point())))
}

/// The outward normal, of length 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_normal_i16f16(
    normal: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    surface: Option<&raylet_surface<i16f16>>,
) -> raylet_status {
    code(ask::of_surface(normal, surface, |surface| raylet_vec3::of_direction(surface.normal())))
}

/// The normal on the side that the ray comes from.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_normal_towards_ray_i16f16(
    normal: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    surface: Option<&raylet_surface<i16f16>>,
) -> raylet_status {
    code(ask::of_surface(normal, surface, |surface| raylet_vec3::of_direction(surface.normal_towards_ray())))
}

/// The cosine of the angle between the line of the ray and the normal, from 0 to 1, as a number.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_cosine_i16f16(
    cosine: Option<&mut MaybeUninit<i16f16>>,
    surface: Option<&raylet_surface<i16f16>>,
) -> raylet_status {
    code(ask::of_surface(cosine, surface, |surface| Number::from_scalar(surface.cosine())))
}

/// Surface coordinates, each from 0 to 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_uv_i16f16(
    uv: Option<&mut MaybeUninit<[i16f16; 2]>>,
    surface: Option<&raylet_surface<i16f16>>,
) -> raylet_status {
    code(ask::of_surface(uv, surface, |surface| {
        let (u, v) = surface.uv();
        [u, v].map(Number::from_unit)
    }))
}

/// Where the hit lies in the bounding box of the solid along its axes, each from 0 to 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_uvw_i16f16(
    uvw: Option<&mut MaybeUninit<[i16f16; 3]>>,
    surface: Option<&raylet_surface<i16f16>>,
) -> raylet_status {
    code(ask::of_surface(uvw, surface, |surface| surface.uvw().map(Number::from_unit)))
}

/// The directions in the world in which u and v grow, of length 1, in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_surface_tangents_i16f16(
    along_u: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    along_v: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    surface: Option<&raylet_surface<i16f16>>,
) -> raylet_status {
    code(ask::tangents(along_u, along_v, surface))
}
