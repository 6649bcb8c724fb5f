//! What is measured on the chips.
//!
//! | module | what it holds |
//! |---|---|
//! | `cost` | instructions and stack of a query: every primitive, number type and tier, beside the textbook's formulas |
//! | `effects` | instructions and stack of a pixel, with each set of effects |
//! | `worst` | the ray that takes the most instructions, by a search |
//! | `shown` | the scenes of the gallery |
#![no_std]

pub mod cost;
pub mod effects;
pub mod shown;
mod stack;
pub mod workloads;
pub mod worst;
