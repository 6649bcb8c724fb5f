//! The queries whose instructions and time are measured on the host.

pub mod cost;
