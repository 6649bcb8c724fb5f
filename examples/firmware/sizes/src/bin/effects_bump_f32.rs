//! A pixel: bump, f32.
#![no_std]
#![no_main]

use raylet::effect::{Bump, Diffuse, Shadows, Specular};

raylet_sizes::pixel!(f32, (Diffuse, Specular, Shadows, Bump));
