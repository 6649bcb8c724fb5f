//! For the tests on chips: loops of queries in Rust, to compare with the same loops in C.

use crate::number::{Number, i16f16};
use crate::storage::{get, raylet_ray, raylet_shape};
use core::hint::black_box;

/// How many of so many queries find a hit.
fn found<N: Number>(shape: Option<&raylet_shape<N>>, ray: Option<&raylet_ray<N>>, times: u32) -> u32 {
    let (Ok(shape), Ok(ray)) = (get(shape), get(ray)) else { return 0 };
    (0..times).filter(|_| black_box(black_box(shape).nearest(black_box(ray))).is_some()).count() as u32
}

#[unsafe(no_mangle)]
extern "C" fn raylet_measured_f32(shape: Option<&raylet_shape<f32>>, ray: Option<&raylet_ray<f32>>, times: u32) -> u32 {
    found(shape, ray, times)
}

#[unsafe(no_mangle)]
extern "C" fn raylet_measured_i16f16(
    shape: Option<&raylet_shape<i16f16>>,
    ray: Option<&raylet_ray<i16f16>>,
    times: u32,
) -> u32 {
    found(shape, ray, times)
}
