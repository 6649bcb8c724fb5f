//! Triangle, I16F16, Stable.
#![no_std]
#![no_main]

use fixed::types::I16F16;

raylet_sizes::nearest!(Triangle<I16F16>, Stable);
