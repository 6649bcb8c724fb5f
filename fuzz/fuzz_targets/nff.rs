//! Any bytes as a scene: see `tests/support/src/fuzz/nff.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    support::fuzz::check_nff(data);
});
