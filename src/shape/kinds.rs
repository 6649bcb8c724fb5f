//! The primitives, placements and combinations as types, which select those that a program is compiled with.

pub use super::kind::{Kind, KindError, KindSet};

use super::Placement;
use super::combined::{Combined, NotCombined};
use crate::affine::Affine;
use crate::frame::Frame;
use crate::hit::{HitList, Hits};
use crate::primitive::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Plane, Polyhedron, Prism, Rectangle, Revolved, RoundCone,
    RoundedCuboid, Sphere, Torus, Triangle, Tube,
};
use crate::scalar::Scalar;
use crate::shape::combination::{Combination, MOST_CROSSINGS};
use core::fmt::Debug;
use core::marker::PhantomData;

mod sealed {
    pub trait Sealed {}
}

/// A primitive or a placement, by its type. Sealed: [`Sphere`], [`Cylinder`], [`Cone`], [`Capsule`], [`Plane`],
/// [`Disc`], [`Triangle`], [`Cuboid`], [`Rectangle`], [`Revolved`], [`Tube`], [`Annulus`], [`RoundCone`],
/// [`RoundedCuboid`], [`Prism`], [`Polyhedron`], [`Torus`], [`Frame`] and [`Affine`], of any number type.
pub trait OfKind: Copy + Debug + PartialEq + sealed::Sealed + 'static {
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
kinds!(Sphere Cylinder Cone Capsule Plane Disc Triangle Cuboid Rectangle Revolved Tube Annulus RoundCone);
kinds!(RoundedCuboid Prism Polyhedron Torus Frame Affine);

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
/// order; or, of a list that holds combinations too, [`Combining`]. Sealed.
///
/// A shape is one of the primitives in the tuple. It is not placed, or is placed by one of the placements in the tuple.
/// What is not in the tuple contributes no instruction to the program: its code runs only after a test of the constant
/// [`SET`](Kinds::SET), and the compiler removes it. On a Cortex-M0+ a picture of spheres and planes takes a ninth to
/// a fifth of the flash that a picture of any primitive takes;
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

    /// The kinds of a primitive among the shapes, and of the leaves of a combination.
    type Leaves: Primitives;

    /// The list of all hits of a ray with a shape of these kinds.
    type Hits<S: Scalar>: HitList<S>;

    /// What a shape holds if it is a combination.
    #[doc(hidden)]
    type Combined<S: Scalar>: Combined<S, Leaves = Self::Leaves, Hits = Self::Hits<S>>;
}

/// [`Kinds`] of primitives alone: [`All`], or a tuple. Every shape of them is a placed primitive. Sealed.
pub trait Primitives: Kinds<Leaves = Self> + 'static {}

/// Every primitive and every placement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct All;

impl sealed::Sealed for All {}

impl Kinds for All {
    const SET: KindSet = KindSet::ALL;

    type Leaves = Self;
    type Hits<S: Scalar> = Hits<S>;
    type Combined<S: Scalar> = NotCombined<Self>;
}

impl Primitives for All {}

/// Primitives and placements of the kinds `L`, and [combinations](Combination) of them, which live for `'a`.
///
/// A list whose shapes are of these kinds holds primitives and combinations, and so do a scene, a hierarchy and a
/// picture of it. Only a program that names this type contains the code of combinations.
///
/// ```
/// use raylet::shape::kinds::Combining;
/// use raylet::{Combination, Cuboid, Cylinder, Frame, Ray, Shape, Shapes, Sphere, UnitVec3, Vec3};
/// use raylet::hierarchy::{Hierarchy, Node};
///
/// let hole = Shape::new(Cylinder::infinite(0.5_f32)?);
/// let leaves = [Shape::new(Cuboid::new(1.0, 1.0, 1.0)?), hole];
/// let drilled = Combination::difference(&leaves)?;
/// let ball = Shape::new(Sphere::new(0.5)?).placed(Frame::at(Vec3::new(0.0, -5.0, 0.0))?);
/// let list: [Shape<f32, Combining<'_>>; 2] = [drilled.shape(), ball.beside_combinations()];
///
/// let mut nodes = [Node::EMPTY; Hierarchy::<f32>::nodes_for(2)];
/// let shapes = Shapes::new(&list, &mut nodes)?;
/// // Down through the hole, to the ball below it.
/// let down = Ray::new(Vec3::new(0.25, 3.0, 0.0), -UnitVec3::Y)?;
/// assert_eq!(shapes.nearest(&down).map(|(shape, _)| shape), Some(1));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Combining<'a, L: Primitives = All>(PhantomData<(&'a (), L)>);

impl<L: Primitives> sealed::Sealed for Combining<'_, L> {}

impl<'a, L: Primitives> Kinds for Combining<'a, L> {
    const SET: KindSet = L::SET;

    type Leaves = L;
    type Hits<S: Scalar> = Hits<S, MOST_CROSSINGS>;
    type Combined<S: Scalar> = Option<&'a Combination<'a, S, L>>;
}

/// Implements [`Kinds`] for the tuple of these, and for every shorter one.
macro_rules! tuples {
    () => {};
    ($First:ident $($Other:ident)*) => {
        impl<$First: OfKind, $($Other: OfKind),*> sealed::Sealed for ($First, $($Other,)*) {}

        impl<$First: OfKind, $($Other: OfKind),*> Kinds for ($First, $($Other,)*) {
            const SET: KindSet = KindSet::of($First::KIND)$(.with($Other::KIND))*;

            type Leaves = Self;
            type Hits<S: Scalar> = Hits<S>;
            type Combined<S: Scalar> = NotCombined<Self>;
        }

        impl<$First: OfKind, $($Other: OfKind),*> Primitives for ($First, $($Other,)*) {}

        tuples!($($Other)*);
    };
}
tuples!(A B C D E F G H I J K L);
