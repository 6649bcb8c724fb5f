//! Scenes: objects, materials, lights, a background and a camera, all borrowed.
//!
//! | module | what it holds |
//! |---|---|
//! | `object` | a shape with its materials and corner normals |
//! | `material`, `color`, `light` | the input of shading |
//! | `levels`, `srgb` | the levels that pictures are stored and shown in |
//! | `texture`, `fog`, `outline` | patterns on surfaces; fog; lines around what is seen |
//! | `camera` | the primary ray of each pixel sample |
//! | `balls` | balls around the objects, in integers, and those that a ray may meet |
//! | `directions`, `candidates` | the rays of a row, and balls and shadows that they may meet; objects in each column |
//! | `queries` | the nearest hit of a ray, occlusion, and which hits have one place |
//! | `storage` | lists that a reader fills |
//! | `stored`, `logged` | how checked parts are stored, for `serde`; how parts are logged, for `defmt` |
//! | `counters`, `observer` | counters of rays and tests; a callback for each test |
//! | [`nff`] | the reader of the Neutral File Format |
//!
//! The bounding volume hierarchy is in [`crate::hierarchy`].

mod balls;
mod camera;
mod candidates;
mod color;
mod counters;
mod directions;
mod fog;
mod levels;
mod light;
#[cfg(feature = "defmt")]
mod logged;
mod material;
pub mod nff;
mod object;
mod observer;
mod outline;
mod queries;
mod srgb;
mod storage;
#[cfg(feature = "serde")]
mod stored;
mod texture;

pub use crate::hierarchy::{Hierarchy, HierarchyError, Node};
pub(crate) use balls::{Ball, BallInWorld, Balls, Candidates, MOST, are_apart, around, around_box, ends, may_shade};
pub use camera::{Camera, CameraError, Raster, Size};
pub(crate) use camera::{RaysOfRow, tangent_of_half};
pub(crate) use candidates::CandidatesOfRow;
pub use color::Color;
pub use counters::Counters;
pub(crate) use directions::{Directions, View};
pub use fog::Fog;
pub(crate) use levels::Levels;
#[cfg(feature = "embedded-graphics")]
pub(crate) use levels::nearest;
pub use light::Light;
pub use material::Material;
pub use object::{CornerNormals, Object};
pub use observer::Observer;
pub use outline::Outline;
pub use queries::SceneHit;
pub(crate) use queries::{MOST_AT_ONE_PLACE, near};
#[cfg(feature = "embedded-graphics")]
pub(crate) use srgb::encoded;
pub use storage::{Full, Store};
pub use texture::{Coordinate, Texture, TextureFault, Waves};

use crate::part::Part;
use crate::scalar::Scalar;
use crate::shape::kinds::{All, Kinds};
use crate::tier::{Stable, Tier};
use core::fmt;
use core::marker::PhantomData;

/// A scene. It borrows its lists, which may be in flash, in a `heapless::Vec` or in a `Vec`.
///
/// [`Scene::new`] and the `with_` methods check all indices once, so that no query can fail.
///
/// Its objects are intersected in the accuracy tier `T`; see [`Scene::at_tier`]. Their shapes are of the kinds `K`; see
/// [`Kinds`].
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a, S: Scalar, T = Stable, K: Kinds = All> {
    objects: &'a [Object<S, K>],
    materials: &'a [Material<S>],
    lights: &'a [Light<S>],
    normals: &'a [CornerNormals<S>],
    textures: &'a [Texture<'a, S>],
    fog: Option<Fog<S>>,
    outline: Option<Outline<S>>,
    background: Color<S>,
    ambient: Color<S>,
    camera: Camera<S>,
    hierarchy: Option<Hierarchy<'a, S>>,
    tier: PhantomData<T>,
}

impl<'a, S: Scalar, K: Kinds> Scene<'a, S, Stable, K> {
    /// A scene with a black background, flat shading, no textures, no fog and no outline; see
    /// [`Scene::with_background`], [`Scene::with_normals`], [`Scene::with_textures`], [`Scene::with_fog`] and
    /// [`Scene::with_outline`].
    ///
    /// # Errors
    ///
    /// [`SceneError`] if an object names a material that is not in the list, or a light is beyond the budget.
    pub fn new(
        objects: &'a [Object<S, K>],
        materials: &'a [Material<S>],
        lights: &'a [Light<S>],
        camera: Camera<S>,
    ) -> Result<Self, SceneError> {
        if u32::try_from(objects.len()).is_err() || u32::try_from(lights.len()).is_err() {
            return Err(SceneError::TooManyObjects);
        }
        for (index, object) in (0_u32..).zip(objects) {
            for material in [object.material, object.base, object.top] {
                if material as usize >= materials.len() {
                    return Err(SceneError::Material { object: index, material });
                }
            }
        }
        for (index, light) in (0_u32..).zip(lights) {
            if !light.position.is_within_budget() {
                return Err(SceneError::Light { light: index });
            }
        }
        Ok(Self {
            objects,
            materials,
            lights,
            normals: &[],
            textures: &[],
            fog: None,
            outline: None,
            background: Color::BLACK,
            ambient: Color::BLACK,
            camera,
            hierarchy: None,
            tier: PhantomData,
        })
    }
}

impl<'a, S: Scalar, T: Tier<S>, K: Kinds> Scene<'a, S, T, K> {
    /// The same scene with its objects intersected in another accuracy tier.
    ///
    /// Pictures in [`Plain`](crate::tier::Plain) and [`Fast`](crate::tier::Fast) are also shaded from the rounded `t`:
    /// point and normal of a hit are not corrected for its error. Of the built-in scenes that changes no pixel in
    /// `f32`, and few in 32-bit fixed point, by one level.
    ///
    /// ```
    /// # use raylet::{Camera, Material, Object, Picture, Scene, Shape, Size, Sphere, Vec3, tier::Exact};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 40.0)?;
    /// let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
    /// let materials = [Material::default()];
    /// let scene = Scene::new(&objects, &materials, &[], camera)?.at_tier::<Exact>();
    /// let counters = Picture::new(&scene, Size::new(8, 6)).render(|_, _, _| {});
    /// assert_eq!(counters.primary_rays, 48);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    #[must_use]
    pub const fn at_tier<U: Tier<S>>(self) -> Scene<'a, S, U, K> {
        let Self { objects, materials, lights, normals, textures, fog, outline, background, ambient, camera, .. } =
            self;
        let (hierarchy, tier) = (self.hierarchy, PhantomData);
        Scene {
            objects,
            materials,
            lights,
            normals,
            textures,
            fog,
            outline,
            background,
            ambient,
            camera,
            hierarchy,
            tier,
        }
    }

    /// The same scene with another background.
    #[must_use]
    pub const fn with_background(self, background: Color<S>) -> Self {
        Self { background, ..self }
    }

    /// The same scene with ambient light: a white matte surface shows this colour where no other light reaches it.
    /// Surfaces scatter it in proportion to their `diffuse` and colour.
    ///
    /// ```
    /// # use raylet::{Camera, Color, Material, Object, Plane, Scene, Shape, Vec3};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 1.0, 5.0), Vec3::ZERO, y, 40.0)?;
    /// # let objects = [Object::new(Shape::new(Plane::new()), 0)];
    /// # let materials = [Material::matte(Color::WHITE)];
    /// let scene = Scene::new(&objects, &materials, &[], camera)?.with_ambient(Color::from_f64([0.1; 3]));
    /// assert_eq!(scene.effects().to_string(), "ambient");
    /// # Ok::<(), raylet::Error>(())
    /// ```
    #[must_use]
    pub const fn with_ambient(self, ambient: Color<S>) -> Self {
        Self { ambient, ..self }
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

    /// The same scene with the textures that its materials name. Without this call materials have no texture.
    ///
    /// # Errors
    ///
    /// [`SceneError::Texture`] if a texture is empty or an image's length is not its width times its height;
    /// [`SceneError::NoTexture`] if a material names a texture that is not in the list.
    pub fn with_textures(self, textures: &'a [Texture<'a, S>]) -> Result<Self, SceneError> {
        for (index, texture) in (0_u32..).zip(textures) {
            if let Some(fault) = texture.fault() {
                return Err(SceneError::Texture { texture: index, fault });
            }
        }
        for (index, material) in (0_u32..).zip(self.materials) {
            if let Some(texture) = material.texture.filter(|texture| *texture as usize >= textures.len()) {
                return Err(SceneError::NoTexture { material: index, texture });
            }
        }
        Ok(Self { textures, ..self })
    }

    /// The same scene in fog.
    #[must_use]
    pub const fn with_fog(self, fog: Fog<S>) -> Self {
        Self { fog: Some(fog), ..self }
    }

    /// The same scene with a line around whatever is seen.
    ///
    /// ```
    /// # use raylet::{Camera, Color, Material, Object, Outline, Picture, Scene, Shape, Size, Sphere, Vec3};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 30.0)?;
    /// // A white ball, seen before white by nothing but its outline.
    /// let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
    /// let materials = [Material::matte(Color::WHITE)];
    /// let scene = Scene::new(&objects, &materials, &[], camera)?
    ///     .with_background(Color::WHITE)
    ///     .with_ambient(Color::WHITE)
    ///     .with_outline(Outline::new(Color::BLACK));
    /// let mut rows = vec![String::new(); 9];
    /// Picture::new(&scene, Size::new(17, 9)).render(|_, y, pixel| {
    ///     rows[y as usize].push(if pixel.color == Color::WHITE { '.' } else { '#' });
    /// });
    /// assert_eq!(rows, [
    ///     "........#........",
    ///     "......#####......",
    ///     ".....#....#......",
    ///     ".....#....##.....",
    ///     "....##.....#.....",
    ///     ".....#....#......",
    ///     ".....###.##......",
    ///     ".......##........",
    ///     ".................",
    /// ]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    #[must_use]
    pub const fn with_outline(self, outline: Outline<S>) -> Self {
        Self { outline: Some(outline), ..self }
    }

    /// The same scene with a bounding volume hierarchy: the same results to the bit, in less time if there are many
    /// objects.
    ///
    /// # Errors
    ///
    /// [`SceneError::Hierarchy`] if it was built for other objects, or for the same objects in another order or with
    /// other placements.
    pub fn with_hierarchy(self, hierarchy: &Hierarchy<'a, S>) -> Result<Self, SceneError> {
        if hierarchy.is_of(self.objects) {
            Ok(Self { hierarchy: Some(*hierarchy), ..self })
        } else {
            let (objects, built_for) = (self.objects.len(), hierarchy.objects());
            Err(SceneError::Hierarchy { objects: objects as u32, built_for: built_for as u32 })
        }
    }

    /// True if this scene is the other one but for its objects, and for a hierarchy.
    pub(crate) fn differs_only_in_objects(&self, other: &Scene<'_, S, T, K>) -> bool {
        self.materials == other.materials
            && self.lights == other.lights
            && self.normals == other.normals
            && self.textures == other.textures
            && (self.fog, self.outline) == (other.fog, other.outline)
            && (self.background, self.ambient) == (other.background, other.ambient)
            && self.camera == other.camera
    }

    /// The objects; a hit names one by its index.
    pub const fn objects(&self) -> &'a [Object<S, K>] {
        self.objects
    }

    /// The lights.
    pub const fn lights(&self) -> &'a [Light<S>] {
        self.lights
    }

    /// The materials; an object names them by index.
    pub const fn materials(&self) -> &'a [Material<S>] {
        self.materials
    }

    /// The fog, if there is any.
    pub const fn fog(&self) -> Option<&Fog<S>> {
        self.fog.as_ref()
    }

    /// The outline, if there is one.
    pub const fn outline(&self) -> Option<&Outline<S>> {
        self.outline.as_ref()
    }

    /// The radiance of a ray that misses every object.
    pub const fn background(&self) -> Color<S> {
        self.background
    }

    /// The ambient light.
    pub const fn ambient(&self) -> Color<S> {
        self.ambient
    }

    /// The camera.
    pub const fn camera(&self) -> &Camera<S> {
        &self.camera
    }

    /// The object of this index; `None` beyond the last.
    pub fn object(&self, index: u32) -> Option<&'a Object<S, K>> {
        self.objects.get(index as usize)
    }

    /// The material of an object's side.
    pub fn material(&self, object: &Object<S, K>) -> Material<S> {
        self.material_of(object, Part::Side).copied().unwrap_or_default()
    }

    /// The material of a part of an object; `None` only for an object of another scene.
    pub fn material_of(&self, object: &Object<S, K>, part: Part) -> Option<&'a Material<S>> {
        self.materials.get(object.material_of(part) as usize)
    }

    /// The texture of a material; `None` if it has none.
    pub fn texture(&self, material: &Material<S>) -> Option<&'a Texture<'a, S>> {
        self.textures.get(material.texture? as usize)
    }

    /// The corner normals of an object; `None` if it is shaded flat.
    pub fn corner_normals(&self, object: &Object<S, K>) -> Option<&'a CornerNormals<S>> {
        self.normals.get(object.smooth? as usize)
    }
}

/// Why a scene cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
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
    /// A texture cannot be used.
    Texture {
        /// Index of the texture.
        texture: u32,
        /// What is wrong with it.
        fault: TextureFault,
    },
    /// A material names a texture that is not in the list.
    NoTexture {
        /// Index of the material.
        material: u32,
        /// Index that it names.
        texture: u32,
    },
    /// A light is not finite or beyond the budget.
    Light {
        /// Index of the light.
        light: u32,
    },
    /// More objects, or more lights, than an index can name.
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
            Self::Texture { texture, fault } => write!(f, "texture {texture} cannot be used: {fault}"),
            Self::NoTexture { material, texture } => {
                write!(f, "material {material} names texture {texture}, which is not in the list: add it")
            }
            Self::Light { light } => {
                write!(f, "light {light} is beyond the number type's budget: move it closer")
            }
            Self::TooManyObjects => {
                f.write_str("a scene holds at most 2^32 - 1 objects, and as many lights: divide it")
            }
            Self::Hierarchy { objects, built_for } => write!(
                f,
                "the hierarchy was built for other objects ({built_for}) than the scene's ({objects}): build it again \
                 from these"
            ),
        }
    }
}

impl core::error::Error for SceneError {}
