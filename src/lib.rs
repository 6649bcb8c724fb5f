//! raylet
#![no_std]
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(not(feature = "libm"))]
compile_error!(
    "raylet needs a float backend: enable the feature `libm` (on by default), or `std`, which brings it along"
);
pub mod hit;
pub mod ray;
pub mod scalar;
pub mod vector;

pub use hit::{Crossing, Hit, Hits, Part};
pub use ray::{Departure, Leaving, Range, Ray, RayError};
pub use scalar::Scalar;
pub use vector::{UnitVec3, Vec3};
