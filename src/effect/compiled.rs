//! The effects as types, which select the effects that a program is compiled with.

use super::set::{Effect, EffectSet};
use core::fmt::Debug;

mod sealed {
    pub trait Sealed {}
}

/// One effect as a type. Sealed: the marker types of this module and no others.
pub trait Marker: Copy + Debug + sealed::Sealed + 'static {
    /// The effect that the type stands for.
    const EFFECT: Effect;
}

/// Defines a marker type for each effect.
macro_rules! markers {
    ($($Name:ident: $room:literal,)+) => {
        $(
            #[doc = concat!("[`Effect::", stringify!($Name), "`] as a type: ", $room)]
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
            pub struct $Name;

            impl sealed::Sealed for $Name {}

            impl Marker for $Name {
                const EFFECT: Effect = Effect::$Name;
            }
        )+
    };
}
markers! {
    Ambient: "light from everywhere, as [`Scene::with_ambient`](crate::Scene::with_ambient) says (Phong 1975).",
    Diffuse: "light that a matte surface scatters (Lambert 1760).",
    Specular: "highlights (Phong 1975).",
    Shadows: "one ray towards each light that could add something (Appel 1968).",
    Reflection: "mirrors, followed ray by ray (Whitted 1980).",
    Refraction: "light through transparent objects (Snell's law, Fresnel's equations).",
    Texture: "colours from [`scene::Texture`](crate::scene::Texture) (Catmull 1974).",
    Bump: "normals from [`scene::Waves`](crate::scene::Waves) (Blinn 1978).",
    Fog: "distance takes light away, as [`scene::Fog`](crate::scene::Fog) says.",
    Antialiasing: "more rays where a pixel's corners differ (Whitted 1980).",
    Outline: "lines around what is seen, as [`scene::Outline`](crate::scene::Outline) says (Saito and Takahashi 1990).",
}

/// The set of effects that a tracer is compiled with: a tuple of up to eleven marker types, in any order. Sealed.
///
/// An effect that is not in the tuple contributes no instruction to the program: its code runs only after a test of the
/// constant [`SET`](Effects::SET), and the compiler removes it.
///
/// ```
/// use raylet::effect::{All, Diffuse, EffectSet, Effects, Shadows};
/// assert_eq!(<(Shadows, Diffuse)>::SET.to_string(), "diffuse, shadows");
/// assert_eq!((All::SET, <()>::SET), (EffectSet::ALL, EffectSet::EMPTY));
/// ```
pub trait Effects: Copy + Debug + sealed::Sealed + 'static {
    /// The set.
    const SET: EffectSet;
}

/// Every effect.
pub type All = (Ambient, Diffuse, Specular, Shadows, Reflection, Refraction, Texture, Bump, Fog, Antialiasing, Outline);

/// Implements [`Effects`] for the tuple of these, and for every shorter one.
macro_rules! tuples {
    () => {
        impl sealed::Sealed for () {}

        impl Effects for () {
            const SET: EffectSet = EffectSet::EMPTY;
        }
    };
    ($First:ident $($Other:ident)*) => {
        impl<$First: Marker, $($Other: Marker),*> sealed::Sealed for ($First, $($Other,)*) {}

        impl<$First: Marker, $($Other: Marker),*> Effects for ($First, $($Other,)*) {
            const SET: EffectSet = EffectSet::of($First::EFFECT)$(.with($Other::EFFECT))*;
        }

        tuples!($($Other)*);
    };
}
tuples!(A B C D E F G H I J L);
