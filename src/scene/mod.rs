//! Floor 7: what is to be seen: objects, materials, lights, a background and a camera, all borrowed.
//!
//! | room | what it holds |
//! |---|---|
//! | `object` | a shape, its material, its corner normals |
//! | `material`, `color`, `light` | what shading needs |
//! | `hierarchy` | boxes in boxes, so that a ray asks few of many objects |
//! | `camera` | the ray of each pixel |
//! | `storage` | where a reader puts what it finds |
//! | [`nff`] | the reader of the Neutral File Format |

mod camera;
mod color;
mod hierarchy;
mod light;
mod material;
pub mod nff;
mod object;
mod storage;

pub use camera::{Camera, CameraError, Raster, Size};
pub use color::Color;
pub use hierarchy::{Hierarchy, HierarchyError, Node};
pub use light::Light;
pub use material::Material;
pub use object::{CornerNormals, Object};
pub use storage::{Full, Store};

use crate::hit::Hit;
use crate::ray::{Range, Ray};
use crate::scalar::Scalar;
use core::fmt;

/// Everything that a picture is made from. Borrows its lists: they may live in flash, in a `heapless::Vec` or in a
/// `Vec`.
///
/// The indices in its objects are checked once, by [`Scene::new`]; no query can fail.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a, S: Scalar> {
    objects: &'a [Object<S>],
    materials: &'a [Material<S>],
    lights: &'a [Light<S>],
    normals: &'a [CornerNormals<S>],
    background: Color<S>,
    camera: Camera<S>,
    hierarchy: Option<Hierarchy<'a, S>>,
}

impl<'a, S: Scalar> Scene<'a, S> {
    /// A black background and flat shading; see [`Scene::with_background`] and [`Scene::with_normals`].
    ///
    /// # Errors
    ///
    /// [`SceneError`] if an object names a material that is not in the list, or a light is beyond the budget.
    pub fn new(
        objects: &'a [Object<S>],
        materials: &'a [Material<S>],
        lights: &'a [Light<S>],
        camera: Camera<S>,
    ) -> Result<Self, SceneError> {
        if u32::try_from(objects.len()).is_err() || u32::try_from(lights.len()).is_err() {
            return Err(SceneError::TooManyObjects);
        }
        for (index, object) in (0_u32..).zip(objects) {
            if object.material as usize >= materials.len() {
                return Err(SceneError::Material { object: index, material: object.material });
            }
        }
        for (index, light) in (0_u32..).zip(lights) {
            if !light.position.is_within_budget() {
                return Err(SceneError::Light { light: index });
            }
        }
        Ok(Self { objects, materials, lights, normals: &[], background: Color::BLACK, camera, hierarchy: None })
    }

    /// The same scene before another background.
    #[must_use]
    pub const fn with_background(self, background: Color<S>) -> Self {
        Self { background, ..self }
    }

    /// The same scene with the corner normals that its smooth triangles name.
    ///
    /// # Errors
    ///
    /// [`SceneError::Normals`] if an object names corner normals that are not in the list.
    pub fn with_normals(self, normals: &'a [CornerNormals<S>]) -> Result<Self, SceneError> {
        for (index, object) in (0_u32..).zip(self.objects) {
            if let Some(smooth) = object.smooth.filter(|smooth| *smooth as usize >= normals.len()) {
                return Err(SceneError::Normals { object: index, normals: smooth });
            }
        }
        Ok(Self { normals, ..self })
    }

    /// The same scene with boxes around its objects: the same answers to the bit, sooner where there are many.
    ///
    /// # Errors
    ///
    /// [`SceneError::Hierarchy`] if it was built for other objects, or for the same in another order or place.
    pub fn with_hierarchy(self, hierarchy: &Hierarchy<'a, S>) -> Result<Self, SceneError> {
        if hierarchy.is_of(self.objects) {
            Ok(Self { hierarchy: Some(*hierarchy), ..self })
        } else {
            let (objects, built_for) = (self.objects.len(), hierarchy.objects());
            Err(SceneError::Hierarchy { objects: objects as u32, built_for: built_for as u32 })
        }
    }

    /// The objects; a hit names one by its index.
    pub const fn objects(&self) -> &'a [Object<S>] {
        self.objects
    }

    /// The lights.
    pub const fn lights(&self) -> &'a [Light<S>] {
        self.lights
    }

    /// What a ray sees that meets nothing.
    pub const fn background(&self) -> Color<S> {
        self.background
    }

    /// The camera.
    pub const fn camera(&self) -> &Camera<S> {
        &self.camera
    }

    /// The object of this index; `None` beyond the last.
    pub fn object(&self, index: u32) -> Option<&'a Object<S>> {
        self.objects.get(index as usize)
    }

    /// The material of an object.
    pub fn material(&self, object: &Object<S>) -> Material<S> {
        self.materials.get(object.material as usize).copied().unwrap_or_default()
    }

    /// The corner normals of an object; `None` shades it flat.
    pub fn corner_normals(&self, object: &Object<S>) -> Option<&'a CornerNormals<S>> {
        self.normals.get(object.smooth? as usize)
    }

    /// The nearest hit of a ray, and the index of the object it belongs to. Of two objects at the same `t` the one
    /// with the lower index is seen.
    ///
    /// A ray that departs from a surface (see [`Departure`](crate::Departure)) departs from that object only: the
    /// others see an ordinary ray. Counts every test in `counters`.
    pub fn nearest(&self, ray: &Ray<S>, counters: &mut Counters) -> Option<SceneHit<S>> {
        let mut nearest: Option<SceneHit<S>> = None;
        let mut shortened = *ray;
        let mut test = |index: u32, counters: &mut Counters| {
            let object = self.object(index)?;
            counters.intersection_tests += 1;
            if let Some(hit) = object.shape.nearest(&for_object(&shortened, index))
                && nearest.is_none_or(|best| hit.t < best.hit.t || (hit.t == best.hit.t && index < best.object))
            {
                nearest = Some(SceneHit { object: index, hit });
                if let Ok(range) = Range::new(ray.range().start(), hit.t) {
                    shortened = shortened.with_range(range);
                }
            }
            Some(shortened.range().end())
        };
        if let Some(hierarchy) = &self.hierarchy {
            hierarchy.walk(ray, counters, test);
        } else {
            for (index, _) in (0_u32..).zip(self.objects) {
                let _ = test(index, counters);
            }
        }
        nearest
    }

    /// True if anything lies on the ray within its range: for shadows. Stops at the first object found.
    pub fn occludes(&self, ray: &Ray<S>, counters: &mut Counters) -> bool {
        let test = |index: u32, object: &Object<S>, counters: &mut Counters| {
            counters.intersection_tests += 1;
            object.shape.occludes(&for_object(ray, index))
        };
        let Some(hierarchy) = &self.hierarchy else {
            return (0_u32..).zip(self.objects).any(|(index, object)| test(index, object, counters));
        };
        let mut is_occluded = false;
        hierarchy.walk(ray, counters, |index, counters| {
            is_occluded = test(index, self.object(index)?, counters);
            (!is_occluded).then_some(ray.range().end())
        });
        is_occluded
    }
}

/// The ray as the object of this index sees it: only the object that it departs from knows of the departure.
fn for_object<S: Scalar>(ray: &Ray<S>, index: u32) -> Ray<S> {
    match ray.departure() {
        Some(departure) if departure.object == index => *ray,
        _ => ray.without_departure(),
    }
}

/// The nearest hit in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneHit<S> {
    /// Index of the object.
    pub object: u32,
    /// Where the ray meets it.
    pub hit: Hit<S>,
}

/// What was done for a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counters {
    /// Rays from the eye.
    pub primary_rays: u64,
    /// Rays towards lights.
    pub shadow_rays: u64,
    /// Questions put to a shape, nearest hit and occlusion together.
    pub intersection_tests: u64,
    /// Boxes of a [`Hierarchy`] that a ray was asked to miss.
    pub box_tests: u64,
    /// Hits for which a point and a normal were computed.
    pub hits_refined: u64,
}

impl Counters {
    /// Adds what another part of the work cost.
    pub const fn add(&mut self, other: &Self) {
        self.primary_rays += other.primary_rays;
        self.shadow_rays += other.shadow_rays;
        self.intersection_tests += other.intersection_tests;
        self.box_tests += other.box_tests;
        self.hits_refined += other.hits_refined;
    }

    /// All rays.
    pub const fn rays(&self) -> u64 {
        self.primary_rays + self.shadow_rays
    }
}

/// Why a scene cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SceneError {
    /// An object names a material that is not in the list.
    Material {
        /// Index of the object.
        object: u32,
        /// Index that it names.
        material: u32,
    },
    /// An object names corner normals that are not in the list.
    Normals {
        /// Index of the object.
        object: u32,
        /// Index that it names.
        normals: u32,
    },
    /// A light is not finite or beyond the budget.
    Light {
        /// Index of the light.
        light: u32,
    },
    /// More objects than an index can name.
    TooManyObjects,
    /// The hierarchy was built for other objects.
    Hierarchy {
        /// How many objects the scene has.
        objects: u32,
        /// How many the hierarchy was built for.
        built_for: u32,
    },
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Material { object, material } => {
                write!(f, "object {object} names material {material}, which is not in the list: add it")
            }
            Self::Normals { object, normals } => {
                write!(f, "object {object} names corner normals {normals}, which are not in the list: add them")
            }
            Self::Light { light } => {
                write!(f, "light {light} is beyond the number type's budget: move it closer")
            }
            Self::TooManyObjects => f.write_str("a scene holds at most 2^32 - 1 objects: divide it"),
            Self::Hierarchy { objects, built_for } => write!(
                f,
                "the hierarchy was built for other objects ({built_for}) than the scene's ({objects}): build it again from these"
            ),
        }
    }
}

impl core::error::Error for SceneError {}
