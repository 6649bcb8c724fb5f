//! Sphere, f32, Stable.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Sphere<f32>, Stable);
