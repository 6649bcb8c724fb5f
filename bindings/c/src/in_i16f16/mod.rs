//! Written by `bindings/c/generate` from `src/in_f32/mod.rs`.

mod hits;
mod many;
mod places;
mod rays;
mod solids;

pub use hits::*;
pub use many::*;
pub use places::*;
pub use rays::*;
pub use solids::*;
