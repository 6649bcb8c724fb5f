//! What the other programs have in common: its size is taken off theirs.
#![no_std]
#![no_main]

raylet_sizes::proofs::program! {
    raylet_sizes::proofs::input::give(raylet_sizes::proofs::input::any_word());
}
