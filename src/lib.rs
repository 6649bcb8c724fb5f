//! raylet
#![no_std]
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(not(feature = "libm"))]
compile_error!(
    "raylet needs a float backend: enable the feature `libm` (on by default), or `std`, which brings it along"
);
pub mod scalar;
