//! A pixel: antialiasing, f32.
#![no_std]
#![no_main]

use raylet::effect::{Antialiasing, Diffuse, Shadows, Specular};

raylet_sizes::pixel!(f32, (Diffuse, Specular, Shadows, Antialiasing));
