//! The C interface of [`raylet`]: `include/raylet.h`, which cbindgen writes from these sources.
//!
//! | module | what it holds |
//! |---|---|
//! | `number` | the number types as C has them |
//! | `value` | structures of C: vectors, hits, crossings |
//! | `storage` | opaque types of stated size, and all unsafe code |
//! | `status` | errors as codes, and their texts |
//! | `make`, `ask` | the functions, generic in the number type and the tier |
//! | `in_f32` | their names in `f32`, with the documentation that the header has |
//! | `in_i16f16` | the same in `I16F16`: written by `bindings/c/generate` from `in_f32` |
#![cfg_attr(target_os = "none", no_std)]
#![deny(missing_docs, unsafe_code)]
#![expect(non_camel_case_types, reason = "names are those of C")]

mod ask;
#[expect(unsafe_code, reason = "exported names")]
mod in_f32;
#[expect(unsafe_code, reason = "exported names")]
mod in_i16f16;
mod make;
#[cfg(feature = "measure")]
#[expect(unsafe_code, reason = "exported names")]
mod measure;
mod number;
#[expect(unsafe_code, reason = "an exported name")]
mod status;
mod storage;
mod value;

pub use in_f32::*;
pub use in_i16f16::*;
pub use number::i16f16;
pub use status::{RAYLET_OK, raylet_error, raylet_fault, raylet_status, raylet_status_text};
pub use value::*;

/// A program needs a handler of panics. No function of this library panics.
#[cfg(all(target_os = "none", feature = "panic-handler"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
