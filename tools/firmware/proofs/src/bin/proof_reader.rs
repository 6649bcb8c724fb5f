//! The reader of scenes, in fixed point. (In floats `core` parses the numbers, and its parser has checks of indices.)
#![no_std]
#![no_main]

use fixed::types::{I16F16, I32F32};
use raylet_proofs::{input::give, pictures, program};

program! {
    give(pictures::reader::<I16F16>());
    give(pictures::reader::<I32F32>());
}
