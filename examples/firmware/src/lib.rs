//! What the firmware programs share, and what the host runs beside them.
#![no_std]

pub mod clock;
pub mod cost;
pub mod digest;
pub mod figures;
#[cfg(target_os = "none")]
pub mod footprint;
pub mod panel;
pub mod picture;
#[cfg(target_os = "none")]
pub mod stack;
