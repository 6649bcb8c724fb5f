//! Triangle, I16F16, Fast.
#![no_std]
#![no_main]

use fixed::types::I16F16;

raylet_sizes::nearest!(Triangle<I16F16>, Fast);
