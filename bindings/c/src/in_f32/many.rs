//! Many shapes: a hierarchy, and all crossings in order.

use crate::ask;
use crate::status::{code, raylet_status};
use crate::storage::{raylet_node, raylet_ray, raylet_shape, raylet_shapes};
use crate::value::{raylet_crossing, raylet_hit, raylet_hits};
use core::ffi::c_void;
use core::mem::MaybeUninit;
use raylet::{Exact, Fast, Plain, Stable};

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
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Stable>(shape, hit, shapes, ray))
}

/// As `raylet_shapes_nearest_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_nearest_plain_f32(
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Plain>(shape, hit, shapes, ray))
}

/// As `raylet_shapes_nearest_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_nearest_fast_f32(
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Fast>(shape, hit, shapes, ray))
}

/// As `raylet_shapes_nearest_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shapes_nearest_exact_f32(
    shape: Option<&mut MaybeUninit<u32>>,
    hit: Option<&mut MaybeUninit<raylet_hit<f32>>>,
    shapes: Option<&raylet_shapes<f32>>,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::nearest_of::<_, Exact>(shape, hit, shapes, ray))
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

/// Calls `each` with every shape that a ray hits or starts inside of, in no order; the number of calls. The hits are
/// there until it returns.
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
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::crossings::<_, Stable>(crossings, capacity, list, count, ray))
}

/// As `raylet_crossings_f32`, in the tier Plain.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_crossings_plain_f32(
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::crossings::<_, Plain>(crossings, capacity, list, count, ray))
}

/// As `raylet_crossings_f32`, in the tier Fast.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_crossings_fast_f32(
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::crossings::<_, Fast>(crossings, capacity, list, count, ray))
}

/// As `raylet_crossings_f32`, in the tier Exact.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_crossings_exact_f32(
    crossings: *mut raylet_crossing<f32>,
    capacity: usize,
    list: *const raylet_shape<f32>,
    count: usize,
    ray: Option<&raylet_ray<f32>>,
) -> raylet_status {
    code(ask::crossings::<_, Exact>(crossings, capacity, list, count, ray))
}
