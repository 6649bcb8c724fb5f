//! Cylinder, f32, Fast.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Cylinder<f32>, Fast);
