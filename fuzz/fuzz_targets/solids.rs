//! Any bytes as a solid and a ray: see `tests/support/src/fuzz.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    support::fuzz::check_solid(data);
});
