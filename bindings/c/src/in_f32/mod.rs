//! The functions of C in `f32`. Those in `I16F16` are written from these by `bindings/c/generate`.
//!
//! | module | what it holds |
//! |---|---|
//! | `solids` | solids and open surfaces, in their canonical pose |
//! | `places` | how they are placed; frames |
//! | `rays` | rays |
//! | `hits` | what a shape answers about a ray; the surface at a hit |
//! | `many` | many shapes: a hierarchy, and all crossings in order |

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
