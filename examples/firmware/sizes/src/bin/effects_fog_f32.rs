//! A pixel: fog, f32.
#![no_std]
#![no_main]

use raylet::effect::{Diffuse, Fog, Shadows, Specular};

raylet_sizes::pixel!(f32, (Diffuse, Specular, Shadows, Fog));
