//! Any bytes as a solid and a ray: see `tests/support/src/fuzz.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    raylet_fuzzed::check_solid(data);
});
