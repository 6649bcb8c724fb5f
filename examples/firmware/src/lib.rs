//! What the firmware programs share, and what the host runs beside them.
#![no_std]

pub mod clock;
pub mod cost;
pub mod digest;
