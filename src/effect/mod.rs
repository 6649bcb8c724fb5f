//! What makes a hit a colour, a file an effect.
//!
//! | room | what it does |
//! |---|---|
//! | `diffuse` | light that a matte surface scatters (Lambert 1760) |
//! | `specular` | highlights (Phong 1975) |
//! | `shadow` | whether a light reaches the point at all (Appel 1968) |
//! | `reflection` | mirrors (Whitted 1980) |
//! | `refraction` | light through surfaces: Snell, Fresnel, total reflection |
//! | `texture` | colours over the surface coordinates (Catmull 1974) |
//! | `bump` | normals that lean (Blinn 1978) |
//! | `fog` | distance takes light away (Beer 1852) |
//! | `antialiasing` | more rays where a pixel's corners differ (Whitted 1980) |
//! | `set`, `compiled` | the effects by name, and as types |
//! | `called_for` | which of them a scene calls for, and the refusal if one is missing |
//! | `tracer`, `cutoff` | from a ray to a colour; where paths end |
//! | `field` | the unit interval in equal fields, for patterns and waves |
//! | `site`, `work` | the point that is shaded; what is counted and remembered |
//!
//! There is no ambient light: what no lamp reaches, nothing is mirrored in and nothing is seen through is black.
//!
//! # Only what a scene calls for
//!
//! *At build time*: a [`Tracer`] and a [`Picture`](crate::Picture) have their effects as a type parameter, [`All`] by
//! default. An effect that is not in the tuple is no instruction in the program.
//!
//! *At scene build*: [`Scene::effects`](crate::Scene::effects) says what materials, lights and fog call for. A picture of a scene
//! that calls for an effect that is not compiled in is refused ([`EffectError`]) and never rendered wrongly in silence.
//!
//! *At each hit*: no shadow ray goes towards a light behind the surface or one that would add nothing; no normal is
//! computed for a shadow test, nor where nothing is shaded; no surface coordinates without a texture or waves; no ray goes on whose
//! light cannot change a level.
//!
//! # The cut-off
//!
//! A ray sent on by a mirror or by glass carries a weight: the product of all weights on its way. In a chain of mirrors the path ends
//! as soon as the ray that would go on, were it as bright as the scene can be anywhere, could not change an eight-bit level of any
//! channel. Where paths divide, rays of a weight below 2^-7 are put aside; once all others are cast, these are, the strongest
//! first, until the same holds for all that are left. So what is left out changes no level, whatever the scene, as long as its
//! numbers are in their documented ranges (colours up to 1, strengths of at least 0). On a display, and in a pixel of several samples
//! for each sample, that holds in steps of 1/4080; such a step may still decide whether a pixel's corners differ.
//!
//! # Glass
//!
//! [`Material`](crate::Material) tells how light divides. A ray that enters an object departs from its surface inwards, one that leaves
//! departs outwards (see [`Departure`](crate::Departure)): no offset, and no ray that finds the surface again that it has just
//! left. Transparent objects cast full shadows, and a lamp is not seen through them as a caustic.

mod antialiasing;
mod bump;
mod called_for;
mod compiled;
mod cutoff;
mod diffuse;
mod field;
mod fog;
mod reflection;
mod refraction;
mod set;
mod shadow;
mod site;
mod specular;
mod texture;
mod tracer;
mod work;

pub(crate) use antialiasing::differ;
pub use called_for::EffectError;
pub use compiled::{
    All, Antialiasing, Bump, Diffuse, Effects, Fog, Marker, Reflection, Refraction, Shadows, Specular, Texture,
};
pub use cutoff::DEPTH;
pub use set::{Effect, EffectSet, Iter};
pub use tracer::Tracer;
pub use work::Work;

use crate::part::Part;
use crate::scalar::Scalar;
use crate::scene::Color;

/// What a ray sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight<S: Scalar> {
    /// The colour.
    pub color: Color<S>,
    /// The object that the ray met first and the part of its surface; `None` for the background.
    pub seen: Option<(u32, Part)>,
    /// Which of the first 32 lights add something to the colour of that point, a bit for each, the first light in the lowest; 0 where
    /// nothing is shaded, as on a perfect mirror.
    pub lit_by: u32,
}
