//! Plane, f32, Stable.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Plane<f32>, Stable);
