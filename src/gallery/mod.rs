//! Built-in scenes, to try a display, a number type or a set of effects with. They are built without allocation.
//!
//! The example `render` draws them on a host, and the firmware on its chips. [`BuiltIn::EVERY`] lists them.
//!
//! ```
//! use raylet::gallery::BuiltIn;
//! use raylet::{Picture, Size, TraceContext};
//!
//! let stage = BuiltIn::StillLife.build::<f32>().expect("every number type holds it");
//! let scene = stage.scene()?;
//! let picture = Picture::new(&scene, Size::new(40, 30));
//! assert_ne!(picture.pixel(20, 15, &mut TraceContext::new(())).color, stage.background);
//! # Ok::<(), raylet::scene::SceneError>(())
//! ```

mod glass;
mod lists;
mod patterns;
mod quadrics;
mod raystones;
mod still_life;
mod water;
mod waves;

pub(crate) use lists::Lists;

use crate::scene::SceneError;
use crate::{
    Affine, Camera, Color, Fog, Frame, Light, Material, Object, Plane, Primitive, Scalar, Scene, Shape, Texture, Vec3,
};
use core::fmt;
use heapless::Vec;

/// A built-in scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BuiltIn {
    /// Solids of revolution, a disc and a pyramid on a plane: diffuse, specular, shadows.
    StillLife,
    /// Solids, a cuboid among them, with different materials on base and top, with procedural textures and an image.
    Patterns,
    /// Glass and mirrors on a chessboard.
    Glass,
    /// Bump-mapped water and solids in front of rows of columns in fog.
    Waves,
    /// A glass of water with a straw: transparent solids that overlap and share faces.
    Water,
    /// Quadrics of revolution: towers with a waist, a dish that mirrors, an hourglass, a dome; a tube, an annulus, a
    /// torus, a round cone, a rounded cuboid, a prism, a polyhedron.
    Quadrics,
    /// Balls of ivory, glass, rubber and a mirror over a board: the scene of the benchmark Raystones.
    Raystones,
}

impl BuiltIn {
    /// All of them.
    pub const EVERY: [Self; 7] =
        [Self::StillLife, Self::Patterns, Self::Glass, Self::Waves, Self::Water, Self::Quadrics, Self::Raystones];

    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::StillLife => "still-life",
            Self::Patterns => "patterns",
            Self::Glass => "glass",
            Self::Waves => "waves",
            Self::Water => "water",
            Self::Quadrics => "quadrics",
            Self::Raystones => "raystones",
        }
    }

    /// A description in one line.
    pub const fn about(self) -> &'static str {
        match self {
            Self::StillLife => "Solids of revolution, a disc and a pyramid on a plane: diffuse, specular, shadows",
            Self::Patterns => "Solids with materials of their own on base and top, and patterns and an image on them",
            Self::Glass => "Glass and mirrors on a chessboard",
            Self::Waves => "Waves on water and on solids, before a hazy row of columns",
            Self::Water => "A glass of water with a straw: transparent solids that overlap and share faces",
            Self::Quadrics => {
                "Quadrics of revolution: towers, a mirroring dish, a dome; a tube, an annulus, round solids"
            }
            Self::Raystones => "Four balls over a board: the scene of the benchmark Raystones",
        }
    }

    /// Builds the scene. `None` if the number type does not hold its numbers, which go up to 200.
    pub fn build<S: Scalar>(self) -> Option<Stage<S>> {
        match self {
            Self::StillLife => still_life::build(),
            Self::Patterns => patterns::build(),
            Self::Glass => glass::build(),
            Self::Waves => waves::build(),
            Self::Water => water::build(),
            Self::Quadrics => quadrics::build(),
            Self::Raystones => raystones::build(),
        }
    }
}

impl fmt::Display for BuiltIn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The lists of a scene with its fog, background and camera. [`Stage::scene`] borrows them.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Stage<S: Scalar> {
    /// The objects; each names its materials by index.
    pub objects: Vec<Object<S>, 20>,
    /// The materials; each names its texture by index.
    pub materials: Vec<Material<S>, 8>,
    /// The lights.
    pub lights: Vec<Light<S>, 3>,
    /// The textures.
    pub textures: Vec<Texture<'static, S>, 6>,
    /// The fog, if there is any.
    pub fog: Option<Fog<S>>,
    /// The background.
    pub background: Color<S>,
    /// The ambient light.
    pub ambient: Color<S>,
    /// The camera.
    pub camera: Camera<S>,
}

impl<S: Scalar> Stage<S> {
    /// The scene, without a hierarchy.
    ///
    /// # Errors
    ///
    /// Those of [`Scene::new`] and [`Scene::with_textures`], if the lists were changed after the stage was built.
    pub fn scene(&self) -> Result<Scene<'_, S>, SceneError> {
        let scene = Scene::new(&self.objects, &self.materials, &self.lights, self.camera)?;
        let scene = scene.with_background(self.background).with_ambient(self.ambient).with_textures(&self.textures)?;
        Ok(self.fog.map_or(scene, |fog| scene.with_fog(fog)))
    }

    /// Objects with lights and the default camera, without fog.
    fn new(
        objects: impl IntoIterator<Item = Object<S>>,
        materials: impl IntoIterator<Item = Material<S>>,
        lights: impl IntoIterator<Item = ([f64; 3], f64)>,
    ) -> Option<Self> {
        let mut placed = Vec::new();
        for ([x, y, z], strength) in lights {
            placed.push(Light::new(point(x, y, z)?, number(strength)?)).ok()?;
        }
        Some(Self {
            objects: all(objects)?,
            materials: all(materials)?,
            lights: placed,
            textures: Vec::new(),
            fog: None,
            background: Color::from_f64([0.30, 0.42, 0.55]),
            ambient: Color::BLACK,
            camera: Camera::new(point(0.2, 3.4, 9.0)?, point(0.0, 0.9, 0.0)?, point(0.0, 1.0, 0.0)?, number(34.0)?)
                .ok()?,
        })
    }
}

/// A list of all items; `None` if they exceed its capacity.
fn all<T, const N: usize>(items: impl IntoIterator<Item = T>) -> Option<Vec<T, N>> {
    let mut list = Vec::new();
    for item in items {
        list.push(item).ok()?;
    }
    Some(list)
}

fn number<S: Scalar>(value: f64) -> Option<S> {
    S::from_f64(value).ok()
}

fn point<S: Scalar>(x: f64, y: f64, z: f64) -> Option<Vec3<S>> {
    Vec3::from_f64([x, y, z]).ok()
}

fn matte<S: Scalar>(color: [f64; 3]) -> Option<Material<S>> {
    Some(Material { diffuse: number(0.8)?, ..Material::matte(Color::from_f64(color)) })
}

/// A solid whose axis points up, with its base at a point.
fn on_y<S: Scalar>(primitive: impl Into<Primitive<S>>, base: Vec3<S>, material: u32) -> Option<Object<S>> {
    Some(Object::new(Shape::new(primitive).placed(Frame::at(base).ok()?), material))
}

/// A plane whose texture repeats every `size` units.
fn floor<S: Scalar>(size: f64, material: u32) -> Option<Object<S>> {
    let stretched = Affine::stretched(Frame::at(point(0.0, 0.0, 0.0)?).ok()?, point(size, 1.0, size)?).ok()?;
    Some(Object::new(Shape::new(Plane::new()).placed(stretched), material))
}
