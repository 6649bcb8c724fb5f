//! Cylinder, f32, Stable.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Cylinder<f32>, Stable);
