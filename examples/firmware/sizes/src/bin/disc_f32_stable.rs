//! Disc, f32, Stable.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Disc<f32>, Stable);
