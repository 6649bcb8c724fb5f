//! Scenes in flash: shapes, objects, materials, lights and cameras in a `const` or a `static`.
//!
//! A constant is computed by the compiler. A value that the constructors refuse then fails the build, and the program
//! contains neither the code of the check nor a copy of the value in RAM.
//!
//! Stable Rust calls no trait method in a constant, so that a constructor that is generic over the number type cannot
//! be called there. Those that check something have a twin for `f32`, `f64`, `FixedI32<F>` and `FixedI64<F>`, whose
//! name is `const_` and that of the constructor. It accepts and refuses the same values and gives the same bits. The
//! number type must be named: `Sphere::<f32>::const_new`. A function without checks is the same in constants and at run
//! time.
//!
//! | value | in a constant |
//! |---|---|
//! | sphere, disc, annulus, tube, torus, capsule, round cone, cuboid, rounded cuboid, rectangle, quadric of revolution, half-space, prism | `const_new` |
//! | polyhedron | `const_within` |
//! | cylinder | `const_infinite`, `const_open`, `const_capped` |
//! | cone | `const_double`, `const_nappe`, `const_open`, `const_capped`, `const_frustum`, `const_frustum_open` |
//! | plane | [`Plane::new`](crate::Plane::new) |
//! | direction | [`UnitVec3::X`](crate::UnitVec3::X) and so on, `const_from_components`, `const_neg` |
//! | frame | `const_at`, `const_from_axes`, `const_from_quaternion` |
//! | shape | `into_shape` of each primitive, [`Shape::in_frame`](crate::Shape::in_frame), [`Shape::seen_from`](crate::Shape::seen_from) |
//! | combination | [`Combination::union`](crate::Combination::union), `intersection`, `difference`, `new`; [`Combination::shape`](crate::Combination::shape), [`Shape::beside_combinations`](crate::Shape::beside_combinations) |
//! | object | [`Object::const_new`](crate::Object::const_new), `with_base`, `with_top` |
//! | material, colour, point light, texture | all of it; a colour by [`Color::new`](crate::Color::new) |
//! | camera | `const_in_frame`, `const_orthographic_in_frame` |
//!
//! Not in a constant, because they need a root or a quotient: the direction of a vector of any length, frames whose
//! axes are computed, affine placements (so [ellipsoids](crate::Ellipsoid) too), [triangles](crate::Triangle) (whose
//! area is checked), [`Polyhedron::new`](crate::Polyhedron::new), whose box is computed,
//! [`Camera::new`](crate::Camera::new), distant lights by direction. Nor is a hierarchy, which is built in RAM.
//! [`Scene::new`](crate::Scene::new) runs in the program: it compares the indices of the objects, and borrows
//! the rest.
//!
//! [`constant!`](crate::constant!) unwraps the result:
//!
//! ```
//! use fixed::types::I16F16;
//! use raylet::{Camera, Color, Cylinder, Frame, Light, Material, Object, Picture, Plane, Scene, Size, UnitVec3, Vec3};
//! use raylet::constant;
//!
//! type N = I16F16;
//! const fn point(x: &str, y: &str, z: &str) -> Vec3<N> {
//!     Vec3::new(N::lit(x), N::lit(y), N::lit(z))
//! }
//! static OBJECTS: [Object<N>; 2] = [
//!     Object::const_new(Plane::new().into_shape(), 0),
//!     Object::const_new(
//!         constant!(Cylinder::<N>::const_capped(N::lit("0.5"), N::lit("1.5")))
//!             .into_shape()
//!             .in_frame(constant!(Frame::<N>::const_at(point("0", "0", "-4")))),
//!         1,
//!     ),
//! ];
//! static MATERIALS: [Material<N>; 2] =
//!     [Material::matte(Color::WHITE), Material::matte(Color::WHITE).with_highlight(N::lit("0.4"), N::lit("30"))];
//! static LIGHTS: [Light<N>; 1] = [Light::new(point("3", "5", "1"), N::lit("0.9"))];
//! // At a height of 1, along -z.
//! static CAMERA: Camera<N> = constant!(Camera::<N>::const_in_frame(
//!     constant!(Frame::<N>::const_from_axes(
//!         point("0", "1", "0"),
//!         [UnitVec3::<N>::X.const_neg(), UnitVec3::Y, UnitVec3::<N>::Z.const_neg()],
//!     )),
//!     N::lit("0.5"),
//! ));
//!
//! let scene = Scene::new(&OBJECTS, &MATERIALS, &LIGHTS, CAMERA)?;
//! let mut seen = [0; 2];
//! Picture::new(&scene, Size::new(16, 12)).render(|_, _, pixel| {
//!     if let Some((object, _)) = pixel.seen {
//!         seen[object as usize] += 1;
//!     }
//! });
//! assert!(seen[0] > 20 && seen[1] > 5, "{seen:?}");
//! # Ok::<(), raylet::Error>(())
//! ```
//!
//! # A helper of your own
//!
//! `constant!` takes no parameter of a `const fn` (error E0435), since the compiler computes its value once, before any
//! call. Where several values are built alike, write a macro. The one below also has the literals of the number type,
//! so that the same source builds for a chip with a floating-point unit and for one without:
//!
//! ```
//! use raylet::{Frame, Shape, Sphere, Vec3, constant};
//!
//! #[cfg(target_abi = "eabihf")] // Cortex-M4F and the like
//! mod number {
//!     pub type S = f32;
//!     macro_rules! n { ($x:literal) => { $x as S } }
//!     pub(crate) use n;
//! }
//! #[cfg(not(target_abi = "eabihf"))]
//! mod number {
//!     pub type S = fixed::types::I16F16;
//!     macro_rules! n { ($x:literal) => { S::lit(stringify!($x)) } }
//!     pub(crate) use n;
//! }
//! use number::{S, n};
//!
//! macro_rules! ball {
//!     ($x:literal, $y:literal, $z:literal) => {
//!         constant!(Sphere::<S>::const_new(n!(0.25)))
//!             .into_shape()
//!             .in_frame(constant!(Frame::<S>::const_at(Vec3::new(n!($x), n!($y), n!($z)))))
//!     };
//! }
//! static BALLS: [Shape<S>; 2] = [ball!(0.5, 0.25, 2), ball!(-0.5, 0.25, 2)];
//! ```
//!
//! # Errors
//!
//! A bad size fails the build, and the compiler says `the radius is negative`:
//!
//! ```compile_fail,E0080
//! use raylet::{Sphere, constant};
//! static BALL: Sphere<f32> = constant!(Sphere::<f32>::const_new(-1.0));
//! ```
//!
//! So do axes that are not perpendicular:
//!
//! ```compile_fail,E0080
//! use raylet::{Frame, UnitVec3, Vec3, constant};
//! const AXES: [UnitVec3<f32>; 3] = [UnitVec3::X, UnitVec3::X, UnitVec3::Z];
//! static SKEW: Frame<f32> = constant!(Frame::<f32>::const_from_axes(Vec3::ZERO, AXES));
//! ```

/// The value of a constructor's result, computed by the compiler; an error fails the build with the error's message.
/// See [`raylet::constant`](mod@crate::constant).
///
/// The argument must be a constant expression: a literal, another constant, or a call of a `const fn` with constant
/// arguments. A parameter of the enclosing function is not constant; [a
/// macro](mod@crate::constant#a-helper-of-your-own) can replace that function.
///
/// ```
/// use raylet::{Capsule, constant};
/// const PILL: Capsule<f32> = constant!(Capsule::<f32>::const_new(0.25, 1.0));
/// assert_eq!(Capsule::new(0.25, 1.0), Ok(PILL));
/// ```
#[macro_export]
macro_rules! constant {
    ($result:expr) => {
        const {
            match $result {
                Ok(value) => value,
                Err(error) => panic!("{}", error.message()),
            }
        }
    };
}
