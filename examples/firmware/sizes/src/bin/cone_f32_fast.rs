//! Cone, f32, Fast.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Cone<f32>, Fast);
