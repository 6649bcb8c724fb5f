//! A pixel: texture, f32.
#![no_std]
#![no_main]

use raylet::effect::{Diffuse, Shadows, Specular, Texture};

raylet_sizes::pixel!(f32, (Diffuse, Specular, Shadows, Texture));
