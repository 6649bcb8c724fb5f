//! raylet
#![no_std]
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(not(feature = "libm"))]
compile_error!(
    "raylet needs a float backend: enable the feature `libm` (on by default), or `std`, which brings it along"
);

pub mod affine;
pub mod effect;
pub mod frame;
pub mod hit;
mod line;
pub mod primitive;
mod quadric;
mod query;
pub mod ray;
pub mod render;
pub mod scalar;
pub mod scene;
pub mod shape;
mod span;
pub mod tier;
pub mod vector;

pub use affine::Affine;
pub use frame::{Frame, FrameError};
pub use hit::{Crossing, Hit, Hits, Part};
pub use primitive::{Capsule, Cone, Cylinder, Disc, Plane, SizeError, Sphere, Triangle};
pub use ray::{Departure, Leaving, Range, Ray, RayError};
pub use render::{Picture, Pixel};
pub use scalar::Scalar;
pub use scene::{Camera, Color, Counters, Light, Material, Object, Scene, Size};
pub use shape::{Bounds, Placement, Primitive, Shape, Surface, Visible};
pub use tier::{Stable, Tier};
pub use vector::{UnitVec3, Vec3};
