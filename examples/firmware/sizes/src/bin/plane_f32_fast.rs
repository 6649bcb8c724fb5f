//! Plane, f32, Fast.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Plane<f32>, Fast);
