//! A pixel: all, i16f16.
#![no_std]
#![no_main]

use fixed::types::I16F16;
use raylet::effect::All;

raylet_sizes::pixel!(I16F16, All);
