//! A pixel: refraction, f32.
#![no_std]
#![no_main]

use raylet::effect::{Diffuse, Reflection, Refraction, Shadows, Specular};

raylet_sizes::pixel!(f32, (Diffuse, Specular, Shadows, Reflection, Refraction));
