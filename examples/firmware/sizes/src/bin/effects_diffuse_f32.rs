//! A pixel: diffuse, f32.
#![no_std]
#![no_main]

use raylet::effect::Diffuse;

raylet_sizes::pixel!(f32, (Diffuse,));
