//! Everything that the proofs exclude: what `check proofs` must find here, or it proves nothing elsewhere.
#![no_std]
#![no_main]

use core::fmt::Write;
use raylet_proofs::input::{any_word, give};
use raylet_proofs::program;

struct Printer;

impl Write for Printer {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        give(text);
        Ok(())
    }
}

program! {
    // A panic: an index out of bounds.
    give([1_u8, 2, 3][any_word() as usize]);
    // An operation on doubles.
    give(f64::from_bits(any_word()) * f64::from_bits(any_word()));
    // Formatting.
    give(write!(Printer, "{}", any_word()));
}
