//! Any bytes as a scene: see `tests/support/fuzz/nff.rs`.
#![no_main]

#[path = "../../tests/support/mod.rs"]
mod support;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    support::fuzz::check_nff(data);
});
