//! The scene files of this folder, in the Neutral File Format, for programs that cannot read files.
#![no_std]

/// Cylinders, cones and a ball.
pub const TUBES: &str = include_str!("tubes.nff");
/// Concave polygons.
pub const STAR: &str = include_str!("star.nff");
/// Quadrilaterals, flat and with a normal at each corner.
pub const DOME: &str = include_str!("dome.nff");
/// Many lights.
pub const LAMPS: &str = include_str!("lamps.nff");
/// Objects far from the eye and from each other.
pub const FAR: &str = include_str!("far.nff");
