//! A pixel: bump, i16f16.
#![no_std]
#![no_main]

use fixed::types::I16F16;
use raylet::effect::{Bump, Diffuse, Shadows, Specular};

raylet_sizes::pixel!(I16F16, (Diffuse, Specular, Shadows, Bump));
