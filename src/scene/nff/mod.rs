//! A reader for the Neutral File Format (NFF, Eric Haines, 1988), the format of the Standard Procedural Databases.
//!
//! It allocates nothing: it fills the caller's [`Store`]s, and [`Counts`] tells beforehand which capacities a text
//! needs. Numbers are rounded once, correctly, from the decimal text to the scene's number type.
//!
//! | entity | meaning |
//! |---|---|
//! | `v` with `from`, `at`, `up`, `angle`, `hither`, `resolution` | the camera; keywords in any order, `hither` may be missing |
//! | `b` r g b | the background; black if missing |
//! | `l` x y z \[r g b\] | a light |
//! | `f` r g b Kd Ks shine T refraction | the material of the objects that follow |
//! | `c` base radius apex radius | an open cylinder or cone |
//! | `s` centre radius | a sphere |
//! | `p` n, then n points | a polygon, counterclockwise seen from its front |
//! | `pp` n, then n points with normals | a polygon, shaded with normals interpolated between its corners |
//! | `#` | a comment up to the end of the line |
//!
//! Where the format is not definite, the reader does this:
//!
//! - Line breaks are white space; an entity may take one line or many.
//! - Entities may come in any order (the format requires view and lights first, for the sake of hidden-surface
//!   renderers). A second view or background is an error. Objects before the first `f` are white and matte.
//! - Lights without a colour have the strength [`Light::usual_strength`]: `1 / sqrt(number of lights)`.
//! - An object is seen from its outside only (a polygon from its front), from the inside only if its radii are
//!   negative, and from both sides if its material transmits (T > 0).
//! - A cone may be wider at its apex than at its base. The same radius twice makes a cylinder. None has caps.
//! - Ks is the weight of the highlight and of the mirrored ray, T that of the refracted ray
//!   ([`Material`] says how Fresnel's equations divide it).
//! - A shine beyond the number type's range (100000 in `I16F16`) becomes the largest that it holds: that highlight is
//!   smaller than a pixel in either case.
//! - A file's unit of length is the scene's, unless [`read_scaled`] is given another scale.
//! - The corners of a `pp` run counterclockwise seen from the side that its normals point to. If their order
//!   contradicts the normals, the normals decide; [`View::turned`] counts these polygons.
//! - A light that is too far away for the number type becomes a distant light: see [`View::distant`].
//! - Bytes that are not UTF-8 are accepted in comments if the file is converted with `String::from_utf8_lossy`.
//! - `hither` is read and returned, but there is no clipping: ray tracing needs no near plane.
//! - Polygons may be concave, with any number of corners. Corners on a line are allowed. A polygon without area, or a
//!   sphere, cone or cylinder that is too small for the number type, cannot be seen: it is left out and counted in
//!   [`View::invisible`].
//!
//! ```
//! # fn main() -> Result<(), raylet::scene::nff::NffError> {
//! use raylet::scene::nff::{self, Corner, Stores};
//! let (mut objects, mut materials) = (heapless::Vec::<_, 4>::new(), heapless::Vec::<_, 4>::new());
//! let (mut lights, mut normals) = (heapless::Vec::<_, 4>::new(), heapless::Vec::<_, 4>::new());
//! let view = nff::read::<f32>(
//!     "v from 0 0 5 at 0 0 0 up 0 1 0 angle 40 resolution 64 48
//!      l 5 5 5
//!      s 0 0 0 1 # a sphere",
//!     Stores {
//!         objects: &mut objects,
//!         materials: &mut materials,
//!         lights: &mut lights,
//!         normals: &mut normals,
//!         corners: &mut [Corner::default(); 8],
//!     },
//! )?;
//! assert_eq!((objects.len(), view.resolution), (1, [64, 48]));
//! # Ok(())
//! # }
//! ```

mod decimal;
mod error;
mod lexer;
mod numbers;
mod polygon;
mod reader;
mod scale;

pub use error::{NffError, Place, Reason};
pub use polygon::{Corner, triangulate};
pub use scale::Scale;

use super::{Camera, Color, CornerNormals, Light, Material, Object, Store};
use crate::scalar::Scalar;
use core::fmt;

/// The lists that the reader fills.
///
/// They should be empty, since indices of materials and normals start at 0. After an error they hold the entities that
/// were read before it.
pub struct Stores<'a, S: Scalar> {
    /// Spheres, cones, cylinders and triangles.
    pub objects: &'a mut dyn Store<Object<S>>,
    /// Materials, one for each `f`, and one more if an object comes before the first.
    pub materials: &'a mut dyn Store<Material<S>>,
    /// Lights.
    pub lights: &'a mut dyn Store<Light<S>>,
    /// Corner normals, one set for each triangle of a `pp`.
    pub normals: &'a mut dyn Store<CornerNormals<S>>,
    /// Scratch for one polygon at a time: as long as the largest has corners.
    pub corners: &'a mut [Corner<S>],
}

impl<S: Scalar> fmt::Debug for Stores<'_, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stores").field("corners", &self.corners.len()).finish_non_exhaustive()
    }
}

/// The contents of a file besides its lists.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct View<S: Scalar> {
    /// The camera.
    pub camera: Camera<S>,
    /// The size of the picture in the file: width and height in pixels.
    pub resolution: [u16; 2],
    /// Distance of the near plane, which ray tracing does not need; zero if the file gives none.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub hither: S,
    /// The background.
    pub background: Color<S>,
    /// Objects left out because they cannot be seen: polygons without area, and solids too small for the number type.
    pub invisible: u32,
    /// Polygons whose corners were reversed, since their order contradicted their normals.
    pub turned: u32,
    /// Lights beyond the number type's budget, which became distant lights.
    pub distant: u32,
}

/// Reads a scene.
///
/// # Errors
///
/// [`NffError`] with the line, the column and the reason, if the text is not a scene, if the number type cannot hold
/// it, or if a store is full.
pub fn read<S: Scalar>(text: &str, stores: Stores<'_, S>) -> Result<View<S>, NffError> {
    read_scaled(text, stores, Scale::ONE)
}

/// Reads a scene in other units: every coordinate, size and distance is multiplied by a power of two before it is
/// rounded.
///
/// Use it for fixed-point numbers, with [`Scale::fitting`]: the picture is the same as with [`read`], with smaller
/// rounding errors.
///
/// # Errors
///
/// As [`read`]. A solid that [`read`] leaves out as too small may be an error here, if the number type cannot hold its
/// proportions.
///
/// ```
/// # fn main() -> Result<(), raylet::scene::nff::NffError> {
/// # use raylet::scene::nff::{self, Corner, Scale, Stores};
/// # use fixed::types::I16F16;
/// # let (mut objects, mut materials) = (heapless::Vec::<_, 4>::new(), heapless::Vec::<_, 4>::new());
/// # let (mut lights, mut normals) = (heapless::Vec::<_, 4>::new(), heapless::Vec::<_, 4>::new());
/// # let stores = Stores {
/// #     objects: &mut objects,
/// #     materials: &mut materials,
/// #     lights: &mut lights,
/// #     normals: &mut normals,
/// #     corners: &mut [Corner::default(); 8],
/// # };
/// // Too far away for I16F16, whose coordinates reach 16384.
/// let text = "v from 0 0 50000 at 0 0 0 up 0 1 0 angle 40 resolution 64 48   s 0 0 0 10000";
/// let scale = Scale::fitting::<I16F16>(text);
/// let view = nff::read_scaled::<I16F16>(text, stores, scale)?;
/// assert_eq!((scale.to_string().as_str(), view.camera.position().z.to_num::<f32>()), ("1/8", 6250.0));
/// # Ok(())
/// # }
/// ```
pub fn read_scaled<S: Scalar>(text: &str, stores: Stores<'_, S>, scale: Scale) -> Result<View<S>, NffError> {
    reader::Reader::new(text, stores, scale).read()
}

/// The bytes of ` 0 0 0`.
const SHORTEST_POINT: usize = 6;

/// The capacities that the scene of a text needs at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counts {
    /// Objects: one for each sphere and cone, two less than its corners for each polygon.
    pub objects: usize,
    /// Materials, with one for objects that come before the first.
    pub materials: usize,
    /// Lights.
    pub lights: usize,
    /// Corner normals, one set for each triangle of a patch.
    pub normals: usize,
    /// Corners of the largest polygon.
    pub corners: usize,
}

impl Counts {
    /// Counts the entities of a text without reading its numbers; for a malformed text, those that can be counted.
    ///
    /// ```
    /// let counts = raylet::scene::nff::Counts::of("s 0 0 0 1  p 4  0 0 0  1 0 0  1 1 0  0 1 0");
    /// assert_eq!((counts.objects, counts.corners, counts.lights), (3, 4, 0));
    /// ```
    pub fn of(text: &str) -> Self {
        let mut counts = Self { materials: 1, ..Self::default() };
        let mut words = lexer::Lexer::new(text);
        while let Some(word) = words.next() {
            match word.text {
                "s" | "c" => counts.objects = counts.objects.saturating_add(1),
                "f" => counts.materials = counts.materials.saturating_add(1),
                "l" => counts.lights = counts.lights.saturating_add(1),
                "p" | "pp" => {
                    let corners = words.peek().and_then(|word| word.text.parse().ok()).unwrap_or(0_usize);
                    // A count that is larger than the rest of the text allows is an error in the text; no memory is
                    // reserved for it.
                    let corners = corners.min(text.len() / SHORTEST_POINT);
                    let triangles = corners.saturating_sub(2);
                    counts.corners = counts.corners.max(corners);
                    counts.objects = counts.objects.saturating_add(triangles);
                    if word.text == "pp" {
                        counts.normals = counts.normals.saturating_add(triangles);
                    }
                }
                _ => {}
            }
        }
        counts
    }
}
