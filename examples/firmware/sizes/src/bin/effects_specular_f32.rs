//! A pixel: specular, f32.
#![no_std]
#![no_main]

use raylet::effect::{Diffuse, Specular};

raylet_sizes::pixel!(f32, (Diffuse, Specular));
