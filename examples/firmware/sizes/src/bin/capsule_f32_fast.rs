//! Capsule, f32, Fast.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Capsule<f32>, Fast);
