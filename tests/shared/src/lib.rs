//! What the host and the chips do alike: the digest of all answers, a picture, and the queries whose cost is measured.
//!
//! | module | what it holds |
//! |---|---|
//! | `bounce` | a ball that bounces on a display, of which only some rows change (feature `displays`) |
//! | `borrowed` | what a prism and a polyhedron borrow |
//! | `digest` | one number for all answers to a fixed set of rays |
//! | `flash` | a scene that is all constants |
//! | `milled` | a part that is drilled and milled: a combination |
//! | `picture` | a scene in flash, and its picture row by row |
//! | `pictured` | the tests that the rays of a picture put to objects |
//! | `subject` | what is measured: solids, unplaced and placed, and the queries |
//! | `textbook` | the formulas that the library is compared with |
//! | `rays` | seeded rays that hit, and others that miss |
//! | `workload` | what users do: solids as they are placed, rays from near and far, departing rays |
//! | `turntable` | the still life on a display (feature `displays`) |
//! | `sensor` | a sensor with zones among twelve obstacles in flash |
//! | `range_sensor`, `returns` | a yard of forty solids, and the 64 zones of a sensor; three returns of each |
#![no_std]

pub mod borrowed;
#[cfg(feature = "displays")]
pub mod bounce;
pub mod digest;
pub mod flash;
pub mod milled;
pub mod picture;
pub mod pictured;
pub mod range_sensor;
pub mod rays;
pub mod returns;
pub mod sensor;
pub mod subject;
pub mod textbook;
#[cfg(feature = "displays")]
pub mod turntable;
pub mod workload;
