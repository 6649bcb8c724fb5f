//! Adds up the modelled cycles of a program that Unicorn runs. What a block takes is told by `model.py`, once for each
//! block; this library adds it up each time the block is carried out, and is the clock that the program reads.
//!
//! A block is a run of instructions without a branch but for the last. Its last instruction was a taken branch if the
//! next block is not the one that follows in memory.

mod counter;
mod hooks;

pub use counter::{Block, Counter};
