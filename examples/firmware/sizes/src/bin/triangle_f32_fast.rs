//! Triangle, f32, Fast.
#![no_std]
#![no_main]

raylet_sizes::nearest!(Triangle<f32>, Fast);
