//! Cone, f32, Stable.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Cone<f32>, Stable);
