//! A pixel: none, f32.
#![no_std]
#![no_main]

raylet_sizes::pixel!(f32, ());
