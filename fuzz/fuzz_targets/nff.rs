//! Any bytes as a scene: see `tests/support/src/fuzz/nff.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    raylet_fuzzed::check_nff(data);
});
