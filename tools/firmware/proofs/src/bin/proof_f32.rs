//! Every public query in `f32`, `Plain`, `Fast` and `Stable`: linked without an operation on doubles.
//!
//! But for the making of a camera, which is given here ready made, and of zones and beams from angles: `libm` computes
//! the sine of an angle in doubles.
#![no_std]
#![no_main]

use raylet::Camera;
use raylet::tier::{Fast, Plain, Stable};
use raylet_proofs::input::{any_reference, give};
use raylet_proofs::{everything, pictures, program};

program! {
    give(everything::queries::<f32, Plain>());
    give(everything::queries::<f32, Fast>());
    give(everything::queries::<f32, Stable>());
    give(everything::geometry::<f32>());
    everything::numbers::<f32>();
    give(pictures::pictures(*any_reference::<Camera<f32>>()));
}
