//! A pixel: all, f32.
#![no_std]
#![no_main]

use raylet::effect::All;

raylet_sizes::pixel!(f32, All);
