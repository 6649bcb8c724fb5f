//! Effects: from a hit to a colour. Each effect has a file.
//!
//! | module | what it does |
//! |---|---|
//! | `ambient` | light from everywhere (Phong 1975) |
//! | `diffuse` | diffuse shading (Lambert 1760) |
//! | `specular` | specular highlights (Phong 1975) |
//! | `shadow` | whether a light reaches the shading point (Appel 1968) |
//! | `reflection` | mirror reflection (Whitted 1980) |
//! | `refraction` | transmission through surfaces: Snell, Fresnel, total reflection |
//! | `texture` | colours as functions of the surface coordinates (Catmull 1974) |
//! | `bump` | bump mapping: perturbed normals (Blinn 1978) |
//! | `fog` | attenuation by distance (Beer 1852) |
//! | `antialiasing` | adaptive supersampling where a pixel's corners differ (Whitted 1980) |
//! | `outline` | lines where neighbouring rays see different things (Saito and Takahashi 1990) |
//! | `set`, `compiled` | the effects as values, and as types |
//! | `called_for` | which effects a scene needs, and the error if one is missing |
//! | `tracer` | what a ray sees |
//! | `paths`, `cutoff` | the rays of a path, and in which order they are cast; where paths end |
//! | `shading` | the light at the first interface that a ray meets, and the rays from there |
//! | `media` | the media along a path; what lies on the two sides of an interface |
//! | `field` | the unit interval in equal fields, for patterns and waves |
//! | `shading_point`, `trace_context` | the shading point; the trace context: counters and a shadow cache |
//!
//! Without ambient light a surface that no light reaches and that neither reflects nor transmits is black.
//!
//! # Only what a scene needs
//!
//! *At compile time*: [`Tracer`] and [`Picture`](crate::Picture) have their effects as a type parameter, [`All`] by
//! default. A program contains no instruction of an effect that is not in this tuple.
//!
//! *When a picture is made*: [`Scene::effects`](crate::Scene::effects) returns the effects that materials, lights,
//! fog and outline need. If one of them is not compiled in, the picture is rejected with an [`EffectError`], since it
//! would be wrong without it.
//!
//! *At each hit*: no shadow ray is cast towards a light that is behind the surface or would contribute nothing. No
//! normal is computed for a shadow test, or where nothing is shaded. Surface coordinates are computed only for a
//! texture or waves. No secondary ray is cast whose light cannot change the result. An outline casts a second ray
//! beside a pixel only if the first sees no edge.
//!
//! # The cut-off
//!
//! A secondary ray has a weight: the product of the reflectances and transmittances along its path. In a chain of
//! mirrors the path ends if the next ray could not change an eight-bit level of any channel, even with the largest
//! radiance that is possible in the scene. Where paths branch, rays with a weight below 2^-7 are deferred. After all
//! others they are cast in order of decreasing weight, until all that are left together could not change a level.
//! Therefore the rays that are left out change no level in any scene whose numbers are in their documented ranges
//! (colours up to 1, strengths of at least 0). Levels are encoded by sRGB, or linear for
//! [`Picture::in_linear_levels`](crate::Picture::in_linear_levels). For a display, and for each sample of a pixel with
//! several samples, they are a sixteenth as large; the mean of a pixel's samples is off by at most a sixteenth of a
//! level, which may round it to the next level, and such a difference may still decide whether a pixel's corners
//! differ.
//!
//! # Glass
//!
//! [`Material`](crate::Material) defines how light is divided. A path carries along which transparent solids it is
//! inside of and which surfaces its next ray departs from (see [`Departure`](crate::Departure)), so that no ray hits a
//! surface again that it starts on, without any offset. Surfaces that the number type cannot tell apart are one place,
//! and what refracts there is the difference between the media before and behind it: `media` has the rules. Transparent
//! objects cast full shadows, and there are no caustics.

mod ambient;
mod antialiasing;
mod bump;
mod called_for;
mod compiled;
mod cutoff;
mod diffuse;
mod field;
mod fog;
mod media;
mod outline;
mod paths;
mod reflection;
mod refraction;
mod set;
mod shading;
mod shading_point;
mod shadow;
mod specular;
mod texture;
mod trace_context;
mod tracer;

pub(crate) use antialiasing::differ;
pub use called_for::EffectError;
pub use compiled::{
    All, Ambient, Antialiasing, Bump, Diffuse, Effects, Fog, Marker, Outline, Reflection, Refraction, Shadows,
    Specular, Texture,
};
pub use cutoff::DEPTH;
pub use set::{Effect, EffectSet, Iter};
pub(crate) use shading::Course;
pub use trace_context::TraceContext;
pub use tracer::Tracer;

use crate::part::Part;
use crate::scalar::Scalar;
use crate::scene::Color;

/// What a ray sees: radiance and first hit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Sample<S: Scalar> {
    /// The radiance.
    pub color: Color<S>,
    /// The index of the object of the first hit and the part of its surface; `None` for the background.
    pub seen: Option<(u32, Part)>,
    /// Bit mask of the first 32 lights: bit `n` is set if light `n` contributes to the shading of the first hit. 0 if
    /// nothing is shaded there, as on a perfect mirror.
    pub lit_by: u32,
}
