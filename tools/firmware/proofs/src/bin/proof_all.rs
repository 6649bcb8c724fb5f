//! Every public query, in every number type and tier: linked without a panic, without an allocator, without formatting.
#![no_std]
#![no_main]

use fixed::types::{I16F16, I32F32};
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet_proofs::input::{Any, give};
use raylet_proofs::{everything, pictures, program, sensors};

#[inline(never)]
fn queries<S: Any, T: Tier<S>>() {
    give(everything::queries::<S, T>());
}

#[inline(never)]
fn the_rest<S: Any>() {
    give(everything::geometry::<S>());
    everything::numbers::<S>();
    everything::host_conversions::<S>();
    give(sensors::angles::<S>());
    give(pictures::any_camera::<S>().and_then(pictures::pictures));
}

program! {
    queries::<f32, Plain>();
    queries::<f32, Fast>();
    queries::<f32, Stable>();
    queries::<f32, Exact>();
    queries::<f64, Plain>();
    queries::<f64, Fast>();
    queries::<f64, Stable>();
    queries::<I16F16, Plain>();
    queries::<I16F16, Fast>();
    queries::<I16F16, Stable>();
    queries::<I16F16, Exact>();
    queries::<I32F32, Plain>();
    queries::<I32F32, Fast>();
    queries::<I32F32, Stable>();
    give((everything::precision::<f32>(), everything::precision::<I16F16>()));
    the_rest::<f32>();
    the_rest::<f64>();
    the_rest::<I16F16>();
    the_rest::<I32F32>();
}
