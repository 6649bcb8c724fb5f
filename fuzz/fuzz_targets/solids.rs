//! Any bytes as a solid and a ray: see `tests/support/fuzz.rs`.
#![no_main]

#[path = "../../tests/support/mod.rs"]
mod support;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    support::fuzz::check_solid(data);
});
