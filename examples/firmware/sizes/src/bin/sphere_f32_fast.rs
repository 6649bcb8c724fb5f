//! Sphere, f32, Fast.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Sphere<f32>, Fast);
