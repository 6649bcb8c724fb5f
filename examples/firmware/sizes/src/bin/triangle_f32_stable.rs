//! Triangle, f32, Stable.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Triangle<f32>, Stable);
