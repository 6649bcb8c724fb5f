//! The primitives and placements as types, which select those that a program is compiled with.

pub use super::kind::{Kind, KindError, KindSet};

use super::Placement;
use crate::affine::Affine;
use crate::frame::Frame;
use crate::primitive::{Capsule, Cone, Cuboid, Cylinder, Disc, Plane, Rectangle, Sphere, Triangle};
use crate::scalar::Scalar;
use core::fmt::Debug;

mod sealed {
    pub trait Sealed {}
}

/// A primitive or a placement, by its type. Sealed: [`Sphere`], [`Cylinder`], [`Cone`], [`Capsule`], [`Plane`],
/// [`Disc`], [`Triangle`], [`Cuboid`], [`Rectangle`], [`Frame`] and [`Affine`], of any number type.
pub trait OfKind: Copy + Debug + PartialEq + sealed::Sealed {
    /// The kind of its values.
    const KIND: Kind;
}

macro_rules! kinds {
    ($($Name:ident)+) => {
        $(
            impl<S: Scalar> sealed::Sealed for $Name<S> {}

            impl<S: Scalar> OfKind for $Name<S> {
                const KIND: Kind = Kind::$Name;
            }
        )+
    };
}
kinds!(Sphere Cylinder Cone Capsule Plane Disc Triangle Cuboid Rectangle Frame Affine);

/// What [`Shape::placed`](super::Shape::placed) takes. Sealed: [`Frame`], [`Affine`] and [`Placement`].
pub trait Places<S: Scalar>: Into<Placement<S>> + sealed::Sealed {
    /// The kinds that it may be.
    const KINDS: KindSet;
}

impl<S: Scalar> Places<S> for Frame<S> {
    const KINDS: KindSet = KindSet::of(Kind::Frame);
}

impl<S: Scalar> Places<S> for Affine<S> {
    const KINDS: KindSet = KindSet::of(Kind::Affine);
}

impl<S: Scalar> sealed::Sealed for Placement<S> {}

impl<S: Scalar> Places<S> for Placement<S> {
    const KINDS: KindSet = KindSet::of(Kind::Frame).with(Kind::Affine);
}

/// The primitives and placements that a shape may have: [`All`], or a tuple of up to twelve of their types, in any
/// order. Sealed.
///
/// A shape is one of the primitives in the tuple. It is not placed, or is placed by one of the placements in the tuple.
/// What is not in the tuple contributes no instruction to the program: its code runs only after a test of the constant
/// [`SET`](Kinds::SET), and the compiler removes it. On a Cortex-M0+ a picture of spheres and planes takes a quarter to
/// two fifths of the flash that a picture of any primitive takes;
/// [docs/microcontrollers.md](https://github.com/raylet-rs/raylet/blob/main/docs/microcontrollers.md) has the figures.
///
/// The number type of a primitive in the tuple has no effect.
///
/// ```
/// use raylet::shape::kinds::{Kind, Kinds};
/// use raylet::{Camera, Frame, Material, Object, Picture, Plane, Scene, Shape, Size, Sphere, Vec3};
///
/// type Few = (Sphere<f32>, Plane<f32>, Frame<f32>);
/// assert!(Few::SET.contains(Kind::Plane) && !Few::SET.contains(Kind::Cone));
///
/// let floor = Shape::<f32, Few>::of(Plane::new());
/// let ball = Shape::<f32, Few>::of(Sphere::new(1.0)?).placed(Frame::at(Vec3::new(0.0, 1.0, 0.0))?);
/// // The scene and the picture have the kinds of the objects.
/// let objects = [Object::new(floor, 0), Object::new(ball, 0)];
/// let camera = Camera::new(Vec3::new(0.0, 2.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0)?;
/// let materials = [Material::default()];
/// let scene = Scene::new(&objects, &materials, &[], camera)?;
/// assert_eq!(Picture::new(&scene, Size::new(8, 6)).render(|_, _, _| {}).primary_rays, 48);
/// # Ok::<(), raylet::Error>(())
/// ```
///
/// A primitive or a placement that is not in the tuple does not compile. `cargo build` reports the error, and not
/// `cargo check`, since it depends on the types for which generic code is compiled:
///
/// ```compile_fail,E0080
/// # use raylet::{Cone, Plane, Shape, Sphere};
/// let cone = Shape::<f32, (Sphere<f32>, Plane<f32>)>::of(Cone::double(1.0_f32)?);
/// # Ok::<(), raylet::Error>(())
/// ```
///
/// ```compile_fail,E0080
/// # use raylet::{Frame, Shape, Sphere, Vec3};
/// let ball = Shape::<f32, (Sphere<f32>,)>::of(Sphere::new(1.0_f32)?).placed(Frame::at(Vec3::ZERO)?);
/// # Ok::<(), raylet::Error>(())
/// ```
pub trait Kinds: Copy + Debug + PartialEq + sealed::Sealed {
    /// The set.
    const SET: KindSet;
}

/// Every primitive and every placement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct All;

impl sealed::Sealed for All {}

impl Kinds for All {
    const SET: KindSet = KindSet::ALL;
}

/// Implements [`Kinds`] for the tuple of these, and for every shorter one.
macro_rules! tuples {
    () => {};
    ($First:ident $($Other:ident)*) => {
        impl<$First: OfKind, $($Other: OfKind),*> sealed::Sealed for ($First, $($Other,)*) {}

        impl<$First: OfKind, $($Other: OfKind),*> Kinds for ($First, $($Other,)*) {
            const SET: KindSet = KindSet::of($First::KIND)$(.with($Other::KIND))*;
        }

        tuples!($($Other)*);
    };
}
tuples!(A B C D E F G H I J K L);
