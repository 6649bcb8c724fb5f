//! The built-in scenes, without allocation: the program `render` draws them on the host, the firmware measures them on its chips.
//!
//! Included by path, so that both have the same scenes to the bit.

mod glass;
mod patterns;
mod still_life;
mod waves;

use core::fmt;
use heapless::Vec;
use raylet::{
    Affine, Camera, Color, Fog, Frame, Light, Material, Object, Plane, Primitive, Scalar, Shape, Texture, Vec3,
};

/// The scenes by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BuiltIn {
    /// Every solid once, on a plane: diffuse, specular, shadows.
    StillLife,
    /// Solids with materials of their own on base and top, and patterns and an image on them.
    Patterns,
    /// Glass and mirrors on a chessboard.
    Glass,
    /// Waves on water and on solids, before a hazy row of columns.
    Waves,
}

impl BuiltIn {
    /// All of them.
    pub const EVERY: [Self; 4] = [Self::StillLife, Self::Patterns, Self::Glass, Self::Waves];

    /// As it is called on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::StillLife => "still-life",
            Self::Patterns => "patterns",
            Self::Glass => "glass",
            Self::Waves => "waves",
        }
    }

    /// The scene in any number type that holds numbers up to 100, which all of `raylet`'s do; otherwise `None`.
    pub fn build<S: Scalar>(self) -> Option<Stage<S>> {
        match self {
            Self::StillLife => still_life::build(),
            Self::Patterns => patterns::build(),
            Self::Glass => glass::build(),
            Self::Waves => waves::build(),
        }
    }
}

impl fmt::Display for BuiltIn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A scene and all that it is made of.
#[derive(Clone, Debug)]
pub struct Stage<S: Scalar> {
    pub objects: Vec<Object<S>, 20>,
    pub materials: Vec<Material<S>, 8>,
    pub lights: Vec<Light<S>, 2>,
    pub textures: Vec<Texture<'static, S>, 5>,
    pub fog: Option<Fog<S>>,
    pub background: Color<S>,
    pub camera: Camera<S>,
}

impl<S: Scalar> Stage<S> {
    /// Objects under two lights before the usual camera, in clear air.
    fn new(
        objects: impl IntoIterator<Item = Object<S>>,
        materials: impl IntoIterator<Item = Material<S>>,
        lights: [([f64; 3], f64); 2],
    ) -> Option<Self> {
        let [first, second] = lights.map(|([x, y, z], strength)| Some(Light::new(point(x, y, z)?, number(strength)?)));
        Some(Self {
            objects: all(objects)?,
            materials: all(materials)?,
            lights: all([first?, second?])?,
            textures: Vec::new(),
            fog: None,
            background: Color::from_f64([0.30, 0.42, 0.55]),
            camera: Camera::new(point(0.2, 3.4, 9.0)?, point(0.0, 0.9, 0.0)?, point(0.0, 1.0, 0.0)?, number(34.0)?)
                .ok()?,
        })
    }
}

/// A list of all items; `None` if there is no room.
fn all<T, const N: usize>(items: impl IntoIterator<Item = T>) -> Option<Vec<T, N>> {
    let mut list = Vec::new();
    for item in items {
        list.push(item).ok()?;
    }
    Some(list)
}

fn number<S: Scalar>(value: f64) -> Option<S> {
    S::from_f64(value)
}

fn point<S: Scalar>(x: f64, y: f64, z: f64) -> Option<Vec3<S>> {
    Vec3::from_f64([x, y, z])
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
