//! Where does this ray meet that solid, on which part of its surface, and which way does the surface face there?
//!
//! `raylet` answers that on any machine down to a microcontroller without a floating-point unit: no allocation, no
//! panic, fixed capacities, in `f32`, `f64` or fixed point (`FixedI32<F>`, `FixedI64<F>` of the [`fixed`](https://docs.rs/fixed)
//! crate), with nothing in it whose bits would depend on the chip.
//!
//! ```
//! use fixed::types::I16F16;
//! use raylet::{Cylinder, Frame, Part, Ray, Shape, UnitVec3, Vec3};
//!
//! let metres = |x: f64| I16F16::from_num(x);
//! // A lying can, and a time-of-flight sensor that looks at it.
//! let frame = Frame::from_base_and_axis(Vec3::new(metres(-0.5), metres(0.0), metres(3.0)), UnitVec3::X)?;
//! let can = Shape::new(Cylinder::capped(metres(0.25), metres(1.0))?).placed(frame);
//! let sensor = Ray::new(Vec3::ZERO, UnitVec3::Z)?;
//! let hit = can.nearest(&sensor).expect("it looks straight at it");
//! assert_eq!((hit.t, hit.part), (metres(2.75), Part::Side));
//! assert_eq!(can.surface(&sensor, &hit).normal().to_f64(), [0.0, 0.0, -1.0]);
//! # Ok::<(), raylet::Error>(())
//! ```
//!
//! # The contract
//!
//! 1. A bounded solid is a closed set; a line meets a convex one in one interval, whose ends are the hits:
//!    [`Crossing::Enter`] and [`Crossing::Exit`], or one [`Crossing::Touch`]. Crossings always pair up.
//! 2. An open surface reports its own crossings, each with the side it was hit from; an unbounded solid its finite ends.
//! 3. Ends outside the ray's closed [`Range`] are dropped; [`Hits::starts_inside`] tells why an exit stands alone. Hits come
//!    sorted by `t`.
//! 4. `t` is distance: directions are unit vectors by type ([`UnitVec3`]); `t` is the parameter of the direction as stored.
//! 5. The side owns the rim that it shares with a cap, the seam that it shares with a hemisphere, and the apex.
//! 6. Degenerate rays have defined answers, none of them NaN: the table is in [`primitive`].
//! 7. Normals are outward unit vectors; [`Surface::normal_towards_ray`] is the flipped one.
//! 8. Leaving a surface needs no epsilon: a ray says where it departs from ([`Departure`]).
//! 9. One-sided surfaces ignore the crossings seen from the back ([`Visible`]).
//! 10. Bad input gets a typed error at construction; queries on built values cannot fail, panic or overflow.
//! 11. The same bits everywhere, for every number type and tier: IEEE arithmetic, integers and `libm` only.
//!
//! `tests/promises/src/contract.rs` has tests named after rules 1 to 10; for rule 11 `tests/promises/src/firmware.rs` and the firmware in
//! `tools/firmware` compare digests of all answers on the host, Cortex-M0+, M3, M4F and RV32IMC.
//!
//! # Modules
//!
//! Imports run down only. `ARCHITECTURE.md` says more.
//!
//! | layer | module | what it holds |
//! |---|---|---|
//! | 9 | [`render`] | pixels |
//! | 8 | [`effect`] | what makes a hit a colour, a file an effect; which of them a scene calls for |
//! | 7 | [`scene`] | objects, materials, lights, camera, the NFF reader |
//! | 6 | [`shape`], `bounds` | any primitive, placed; its box |
//! | 5 | [`primitive`], [`tier`], `geometry`, `query`, `exact`, `ladder` | a file a primitive: its sizes, equations, normal, surface coordinates, tangents; accuracy tiers, and how each climbs the ladder of numbers |
//! | 4 | `solve`, `figure`, `fast` | the one solver; the equations of a solid; what fast paths share |
//! | 3 | [`ray`], [`frame`], [`affine`], [`hit`], `intersection`, `line` | rays and ranges, placement, hits and hit lists, intervals |
//! | 2 | [`vector`] | [`Vec3`], [`UnitVec3`] |
//! | 1 | [`number`], [`scalar`] | the ladder of computing numbers; the stored number types: `f32`, `f64`, fixed point |
//!
//! # Features
//!
//! | feature | default | what it adds |
//! |---|---|---|
//! | `libm` | yes | the float backend; a build without it fails, and says so |
//! | `fixed` | yes | fixed-point scalars |
//! | `std` | no | scene storage in `Vec`; brings `libm`, and changes no result bit |
//! | `embedded-graphics` | no | pictures on any display, see `display` |
//! | `mint` | no | conversions of points and vectors |
//! | `serde` | no | serialisation of vectors, rays, hits, primitives, placements and shapes; fixed-point numbers as decimal text that comes back to the bit (as their bits in formats that people do not read) |
//! | `defmt` | no | `defmt::Format` for the public value types; in fixed point for vectors, rays, hits, triangles, boxes and frames |
#![no_std]
#![deny(unsafe_code, missing_docs)]
#![warn(missing_debug_implementations)]
// Tests and examples may unwrap; the library has no panic path.
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(not(feature = "libm"))]
compile_error!(
    "raylet needs a float backend: enable the feature `libm` (on by default), or `std`, which brings it along"
);

pub mod affine;
mod bounds;
#[cfg(feature = "embedded-graphics")]
pub mod display;
pub mod effect;
pub mod errata;
mod error;
mod exact;
mod fast;
mod figure;
pub mod frame;
pub mod gallery;
mod geometry;
pub mod hit;
#[cfg(any(feature = "mint", feature = "serde", feature = "defmt"))]
mod interchange;
mod intersection;
mod ladder;
mod line;
pub mod number;
mod part;
pub mod primitive;
mod query;
pub mod ray;
pub mod render;
pub mod scalar;
pub mod scene;
pub mod shape;
mod solve;
pub mod tier;
pub mod vector;

pub use affine::Affine;
pub use effect::{Tracer, Work};
pub use error::Error;
pub use frame::{Frame, FrameError};
pub use geometry::Bounds;
pub use hit::{Crossing, Hit, Hits};
pub use part::Part;
pub use primitive::{Capsule, Cone, Cylinder, Disc, Plane, SizeError, Sphere, Triangle};
pub use ray::{Along, Departure, Leaving, Range, Ray, RayError};
pub use render::{Picture, Pixel};
pub use scalar::{Scalar, ValueError};
pub use scene::{Camera, Color, Counters, Fog, Light, Material, Object, Scene, Size, Texture};
pub use shape::{Placement, Primitive, Shape, Surface, Visible};
pub use tier::{Exact, Fast, Stable, Tier};
pub use vector::{UnitVec3, Vec3};

/// The examples of the README are tests.
#[cfg(all(doctest, feature = "fixed"))]
#[doc = include_str!("../README.md")]
struct Readme;
