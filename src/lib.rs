//! Ray-primitive intersection: the distance `t` of each hit, the part of the surface, and the normal there.
//!
//! `raylet` runs on any machine down to a microcontroller without a floating-point unit. It does not allocate and does
//! not panic. It computes in `f32`, `f64` or fixed point (`FixedI32<F>`, `FixedI64<F>` of the
//! [`fixed`](https://docs.rs/fixed) crate), and its results have the same bits on every chip.
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
//! Coordinates are right-handed: with x to the right and y up, z comes towards the viewer. Lengths are in any unit;
//! angles in degrees.
//!
//! Code that is to run in several number types uses a type alias, `type S = fixed::types::I16F16;`, rather than a
//! parameter: [`Scalar`] has what the library needs, and no arithmetic of its own.
//!
//! # Where to begin
//!
//! - A distance: a [`Shape`] of a primitive, placed by a [`Frame`], and [`Shape::nearest`], as above. Of many shapes:
//!   [`Shapes`].
//! - A picture: [`scene`], then [`Picture`]; on a display: `display` (feature `embedded-graphics`). [`gallery`] has
//!   scenes to try it with.
//! - How accurate: [`tier`], and [which number type and tier to take][which-one].
//! - On a chip: the dependency as on a host (the default features need no `std`), and what any program for the chip
//!   needs: a runtime such as `cortex-m-rt`, its `memory.x`, and `-Tlink.x` for the linker.
//!   [From an empty folder to a program on a chip][firmware] builds one step by step.
//!   [`constant`](mod@constant) puts shapes into flash; [`shape::kinds`] leaves out the code of primitives that a
//!   program does not use.
//!
//! [which-one]: https://github.com/raylet-rs/raylet/blob/main/docs/which-one.md
//! [firmware]: https://github.com/raylet-rs/raylet/blob/main/docs/firmware.md
//!
//! # The contract
//!
//! 1. A solid is a closed set. A line meets a convex solid in one interval, whose ends are the hits:
//!    [`Crossing::Enter`] and [`Crossing::Exit`], or one [`Crossing::Touch`]. Crossings always pair up. (A double cone,
//!    a quadric with a waist, a tube and a torus are not convex: a line may meet them in two intervals.)
//! 2. An open surface, such as a cylinder without caps, reports each point where the line crosses it, with the side
//!    that was hit. An infinite solid reports the ends of its interval that are finite.
//! 3. Hits come sorted by `t`. Ends outside the ray's closed [`Range`] are no hits. If an exit has no enter before it,
//!    the ray starts inside: [`Hits::starts_inside`].
//! 4. `t` is distance, because directions are unit vectors by type ([`UnitVec3`]). Stored components are rounded, and
//!    `t` is the parameter along the direction as stored.
//! 5. A point on an edge between two parts belongs to the side: the rim between side and cap, and the seam between side
//!    and round end. So does the apex. The inner rims of a tube belong to its inner side, the seams of a rounded
//!    cuboid to its faces, and an edge between two faces to the first of them.
//! 6. Degenerate rays have defined results, without NaN: the table is in [`primitive`].
//! 7. Normals are outward unit vectors. [`Surface::normal_towards_ray`] is the normal on the side that the ray comes
//!    from.
//! 8. A ray that starts on a surface needs no epsilon: it says which surface it departs from ([`Departure`]).
//! 9. A one-sided surface ignores crossings from its other side ([`Visible`]).
//! 10. Constructors check their input and return a typed error. Queries on constructed values cannot fail or
//!     panic, and no integer overflows. (Terms of [`Plain`] in floats may be infinite: see there.)
//! 11. Results have the same bits on every machine, for every number type and tier: they are computed by IEEE
//!     arithmetic, integers and `libm` only.
//!
//! In the repository `tests/promises/src/contract.rs` has tests named after rules 1 to 10; for rule 11
//! `tests/promises/src/firmware.rs` and the firmware in `tools/firmware` compare digests of all answers on the host,
//! Cortex-M0+, M3, M4F and RV32IMC.
//!
//! # Words
//!
//! "Primitive" is the word for any of the shapes, "solid" for one that has an inside. How the library is built is in
//! [ARCHITECTURE.md](https://github.com/raylet-rs/raylet/blob/main/ARCHITECTURE.md).
//!
//! # Features
//!
//! | feature | default | what it adds |
//! |---|---|---|
//! | `libm` | yes | square root and other functions of floats; required: a build without it stops with an error message |
//! | `fixed` | yes | fixed-point scalars |
//! | `std` | no | a `Vec` as the list of a [`ShapeTree`] and as the storage of a scene; enables `libm`, and changes no bit of a result |
//! | `embedded-graphics` | no | pictures on displays: see `display` |
//! | `mint` | no | conversions of points and vectors |
//! | `serde` | no | serialisation of vectors, rays, hits, shapes and the parts of scenes, with the exceptions in [docs/overview.md](https://github.com/raylet-rs/raylet/blob/main/docs/overview.md#stored-and-logged); fixed-point numbers as decimal text from which the same bits are read (as their bits in binary formats) |
//! | `defmt` | no | `defmt::Format` for the same values and for errors, in every number type, with the exceptions in that table |
#![no_std]
#![deny(unsafe_code, missing_docs)]
#![warn(missing_debug_implementations)]
// Tests and examples may unwrap; the library has no panic path.
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(any(feature = "std", units))]
extern crate std;

#[cfg(not(feature = "libm"))]
compile_error!(
    "raylet needs a float backend: enable the feature `libm` (on by default), or `std`, which brings it along"
);

pub mod affine;
mod bounds;
pub mod constant;
#[cfg(feature = "embedded-graphics")]
pub mod display;
pub mod effect;
mod equations;
mod error;
mod exact;
pub mod frame;
pub mod gallery;
mod geometry;
mod grid;
mod half_space;
pub mod hierarchy;
pub mod hit;
#[cfg(any(feature = "mint", feature = "serde", feature = "defmt"))]
mod interchange;
mod intersection;
mod ladder;
mod line;
mod number;
mod outline;
mod part;
mod polygon;
pub mod primitive;
mod query;
#[cfg(units)]
#[path = "../tests/units/random.rs"]
mod random;
pub mod ray;
pub mod render;
pub mod scalar;
pub mod scene;
pub mod sensor;
pub mod shape;
pub mod solids;
mod solve;
pub mod thick;
pub mod tier;
pub mod vector;

pub use affine::Affine;
pub use effect::{TraceContext, Tracer};
pub use error::Error;
pub use frame::{Frame, FrameError};
pub use geometry::Bounds;
pub use hierarchy::{ShapeTree, Shapes};
pub use hit::{Crossing, Hit, Hits};
pub use ladder::ExactScalar;
pub use part::Part;
pub use primitive::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, HalfSpace, Plane, Polyhedron, Prism, Rectangle, Revolved,
    RoundCone, RoundedCuboid, SizeError, Sphere, Torus, Triangle, Tube,
};
pub use ray::{Along, Departure, Leaving, Range, Ray, RayError};
pub use render::{Picture, Pixel};
pub use scalar::{Scalar, ValueError};
pub use scene::{Camera, Color, Counters, Fog, Light, Material, Object, Outline, Scene, Size, Texture};
pub use shape::combination::{Combination, CombinationError};
pub use shape::{Ellipsoid, Placement, Primitive, Shape, Shaped, Surface, Visible};
pub use tier::{Exact, Fast, Plain, Stable, Tier};
pub use vector::{UnitVec3, Vec3};

/// The examples of the README are tests.
#[cfg(all(doctest, feature = "fixed"))]
#[doc = include_str!("../README.md")]
struct Readme;
