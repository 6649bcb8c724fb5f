//! Capsule, f32, Stable.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Capsule<f32>, Stable);
