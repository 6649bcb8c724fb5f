//! A pixel: none, i16f16.
#![no_std]
#![no_main]

use fixed::types::I16F16;

raylet_sizes::pixel!(I16F16, ());
