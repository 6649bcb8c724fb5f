//! Any primitive, and any primitive of a set.

use super::kinds::{Kind, KindSet, Kinds};
use super::queries::Visitor;
use super::{Shape, Surface};
use crate::bounds;
use crate::equations::{Described, EquationKinds, Equations};
use crate::geometry::{Bounds, Geometry, Hull};
use crate::hit::Hit;
use crate::intersection::Intersection;
use crate::part::Part;
use crate::primitive::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Plane, Polyhedron, Prism, Rectangle, Revolved, RoundCone,
    RoundedCuboid, Sphere, Torus, Triangle, Tube,
};
use crate::ray::Ray;
use crate::scalar::{Including, Scalar, UnitScalar};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3};
use core::marker::PhantomData;

/// Defines the enum of all primitives, and passes every call on to the one that it holds.
macro_rules! primitives {
    ($($Variant:ident),+) => {
        /// Any primitive, without allocation or dynamic dispatch.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
        #[non_exhaustive]
        pub enum Primitive<S: Scalar> {
            $(
                #[doc = concat!("A [`", stringify!($Variant), "`].")]
                $Variant($Variant<S>),
            )+
        }

        #[cfg(feature = "defmt")]
        impl<S: Scalar> defmt::Format for Primitive<S> {
            fn format(&self, f: defmt::Formatter<'_>) {
                match self { $(Self::$Variant(primitive) => defmt::Format::format(primitive, f),)+ }
            }
        }

        impl<S: Scalar> Primitive<S> {
            /// Which of the primitives it is.
            pub const fn kind(&self) -> Kind {
                match self { $(Self::$Variant(_) => Kind::$Variant,)+ }
            }
        }

        $(
            impl<S: Scalar> From<$Variant<S>> for Primitive<S> {
                fn from(primitive: $Variant<S>) -> Self {
                    Self::$Variant(primitive)
                }
            }
        )+

        $(
            impl<S: Scalar> $Variant<S> {
                /// The surface at a hit: point, normal, surface coordinates, tangents. See [`Shape::surface`].
                pub fn surface(&self, ray: &Ray<S>, hit: &Hit<S>) -> Surface<S> {
                    Shape::new(*self).surface(ray, hit)
                }
                /// The axis-aligned bounding box: see [`Shape::bounds`].
                pub fn bounds(&self) -> Bounds<S> {
                    bounds::unplaced::<S, Self>(&self.hull())
                }
            }
        )+

        $(
            impl<S: Scalar> $Variant<S> {
                /// The shape of this primitive in its canonical pose, seen from both sides, as [`Shape::of`] makes it;
                /// also for constants. The program does not compile if the primitive is not among the kinds.
                pub const fn into_shape<K: Kinds>(self) -> Shape<S, K> {
                    const {
                        assert!(
                            K::SET.contains(Kind::$Variant),
                            "this primitive is not among the kinds of the shape: name it there"
                        );
                    }
                    Shape::unplaced(Primitive::$Variant(self))
                }
            }
        )+

        /// The kinds of equations of the primitives of a set.
        const fn kind(kinds: KindSet) -> EquationKinds {
            let mut kind = EquationKinds::NONE;
            $(
                if kinds.contains(Kind::$Variant) {
                    kind = kind.and(<$Variant<f32> as Described>::EQUATIONS);
                }
            )+
            kind
        }

        /// Evaluates an expression with the primitive in its own type; another expression for a primitive that is not
        /// among the kinds, which no shape has.
        macro_rules! with {
            ($of:ident, |$primitive:ident| $answer:expr, $none:expr) => {
                // One arm for all that are not among the kinds: an arm for each would take some bytes each time.
                match &$of.primitive {
                    $(Primitive::$Variant($primitive) if K::SET.contains(Kind::$Variant) => $answer,)+
                    _ => $none,
                }
            };
        }

        /// The same for a result of the primitive's own type. Each result is made where it is returned, without a copy.
        macro_rules! map {
            ($of:ident, |$primitive:ident| $answer:expr, $none:expr) => {
                match &$of.primitive {
                    $(
                        Primitive::$Variant($primitive) if K::SET.contains(Kind::$Variant) => {
                            Member { primitive: Primitive::$Variant($answer), kinds: PhantomData }
                        }
                    )+
                    _ => $none,
                }
            };
        }
    };
}

primitives!(
    Sphere,
    Cylinder,
    Cone,
    Capsule,
    Plane,
    Disc,
    Triangle,
    Cuboid,
    Rectangle,
    Revolved,
    Tube,
    Annulus,
    RoundCone,
    RoundedCuboid,
    Prism,
    Polyhedron,
    Torus
);

impl<S: Scalar> Primitive<S> {
    /// The most crossings that a line can have with the solid; zero of a surface without an inside.
    pub(crate) const fn most_crossings(&self) -> usize {
        match self {
            Self::Sphere(_)
            | Self::Capsule(_)
            | Self::RoundCone(_)
            | Self::Cuboid(_)
            | Self::RoundedCuboid(_)
            | Self::Prism(_)
            | Self::Polyhedron(_) => 2,
            Self::Cylinder(cylinder) => cylinder.extent().most_crossings(),
            Self::Cone(cone) => cone.extent().most_crossings(),
            Self::Revolved(revolved) => revolved.most_crossings(),
            Self::Tube(_) | Self::Torus(_) => 4,
            Self::Plane(_) | Self::Disc(_) | Self::Annulus(_) | Self::Triangle(_) | Self::Rectangle(_) => 0,
        }
    }
}

/// A primitive that is among the kinds `K`.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Member<S: Scalar, K> {
    pub(super) primitive: Primitive<S>,
    kinds: PhantomData<K>,
}

impl<S: Scalar, K: Kinds> Member<S, K> {
    /// The primitive, which must be among the kinds.
    #[inline(always)]
    pub(super) const fn new(primitive: Primitive<S>) -> Self {
        Self { primitive, kinds: PhantomData }
    }
}

impl<S: Scalar, K: Kinds> Described for Member<S, K> {
    const EQUATIONS: EquationKinds = kind(K::SET);
}

impl<S: Scalar, K: Kinds> Member<S, K> {
    /// The answer of a visitor to the primitive in its own type.
    #[inline(always)]
    pub(super) fn visit<V: Visitor<S>>(&self, visitor: V) -> V::Answer {
        with!(self, |p| visitor.visit(p), visitor.none())
    }
}

impl<S: Scalar, K: Kinds> Geometry<S> for Member<S, K> {
    type In<R: Scalar> = Member<R, K>;

    #[inline(always)]
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>> {
        Some(map!(self, |p| p.in_type()?, Member::new(Primitive::Plane(Plane::new()))))
    }
    fn largest_coordinate(&self) -> S {
        with!(self, |p| p.largest_coordinate(), S::ZERO)
    }
    fn scaled(&self, e: i32) -> Self {
        map!(self, |p| p.scaled(e), *self)
    }
    fn lengths(&self) -> S {
        with!(self, |p| p.lengths(), S::ZERO)
    }
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>> {
        with!(self, |p| p.intersect(ray, goal), Err(solve::Stop::Miss))
    }
    fn equations(&self) -> Equations<S> {
        with!(self, |p| p.equations(), Equations::Plane)
    }
    fn hull(&self) -> Hull<S> {
        with!(self, |p| p.hull(), Hull::Ball(S::ZERO))
    }
    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
        with!(self, |p| p.on_surface(point, part), point)
    }
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
        with!(self, |p| p.normal(point, part), UnitVec3::Y)
    }
    fn bend(&self, point: Vec3<S>, part: Part) -> S {
        with!(self, |p| p.bend(point, part), S::INFINITY)
    }
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
        with!(self, |p| p.uv(point, part), (S::Unit::ZERO, S::Unit::ZERO))
    }
    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
        with!(self, |p| p.tangents(point, part), (UnitVec3::X, UnitVec3::Z))
    }
}
