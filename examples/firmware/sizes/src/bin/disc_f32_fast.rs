//! Disc, f32, Fast.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Disc<f32>, Fast);
