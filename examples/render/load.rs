//! Where a scene comes from: the built-in scene or an NFF file, in any number type.

use crate::options::Units;
use raylet::gallery::{BuiltIn, Stage};
use raylet::scene::nff::{self, Corner, Counts, Scale, Stores};
use raylet::scene::{CornerNormals, Full, Store};
use raylet::{Camera, Color, Fog, Light, Material, Object, Scalar, Scene, Texture};
use std::error::Error;
use std::fs;
use std::path::Path;

/// In which size built-in scenes are shown.
const BUILT_IN_SIZE: [u16; 2] = [160, 120];

/// The text of a scene file, or a built-in scene.
#[derive(Debug)]
pub(crate) struct Source {
    name: String,
    text: std::result::Result<String, BuiltIn>,
}

impl Source {
    pub(crate) fn new(file: Option<&Path>, built_in: BuiltIn) -> Result<Self, Box<dyn Error>> {
        let Some(file) = file else { return Ok(Self { name: built_in.to_string(), text: Err(built_in) }) };
        let text = fs::read_to_string(file).map_err(|error| format!("cannot read {}: {error}", file.display()))?;
        let name = file.file_stem().map_or("scene".into(), |stem| stem.to_string_lossy().into_owned());
        Ok(Self { name, text: Ok(text) })
    }

    /// The file's name without folder and extension.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    pub(crate) fn load<S: Scalar>(&self, units: Units) -> Result<Loaded<S>, Box<dyn Error>> {
        let text = match &self.text {
            Ok(text) => text,
            Err(_) if units != Units::Fitting => {
                return Err("only a file is read to scale: name one, or drop --scale".into());
            }
            Err(built_in) => {
                let stage = built_in.build().ok_or("the number type cannot hold the built-in scene")?;
                return Ok(stage.into());
            }
        };
        let counts = Counts::of(text);
        let (mut objects, mut materials) = (Growing(Vec::new()), Growing(Vec::new()));
        let (mut lights, mut normals) = (Growing(Vec::new()), Growing(Vec::new()));
        let stores = Stores {
            objects: &mut objects,
            materials: &mut materials,
            lights: &mut lights,
            normals: &mut normals,
            corners: &mut vec![Corner::default(); counts.corners],
        };
        let scale = match units {
            Units::Fitting => Scale::fitting::<S>(text),
            Units::Chosen(scale) => scale,
        };
        let view = nff::read_scaled(text, stores, scale).map_err(|error| format!("{}.nff, {error}", self.name))?;
        Ok(Loaded {
            objects: objects.0,
            materials: materials.0,
            lights: lights.0,
            normals: normals.0,
            textures: Vec::new(),
            fog: None,
            background: view.background,
            camera: view.camera,
            resolution: view.resolution,
            invisible: view.invisible,
            scale,
        })
    }
}

/// A scene and the lists that it borrows.
#[derive(Debug)]
pub(crate) struct Loaded<S: Scalar> {
    pub(crate) objects: Vec<Object<S>>,
    pub(crate) materials: Vec<Material<S>>,
    pub(crate) lights: Vec<Light<S>>,
    pub(crate) normals: Vec<CornerNormals<S>>,
    pub(crate) textures: Vec<Texture<'static, S>>,
    pub(crate) fog: Option<Fog<S>>,
    pub(crate) background: Color<S>,
    pub(crate) camera: Camera<S>,
    pub(crate) resolution: [u16; 2],
    pub(crate) invisible: u32,
    /// Units of the scene in one of the file.
    pub(crate) scale: Scale,
}

impl<S: Scalar> From<Stage<S>> for Loaded<S> {
    fn from(stage: Stage<S>) -> Self {
        Self {
            objects: stage.objects.to_vec(),
            materials: stage.materials.to_vec(),
            lights: stage.lights.to_vec(),
            normals: Vec::new(),
            textures: stage.textures.to_vec(),
            fog: stage.fog,
            background: stage.background,
            camera: stage.camera,
            resolution: BUILT_IN_SIZE,
            invisible: 0,
            scale: Scale::ONE,
        }
    }
}

impl<S: Scalar> Loaded<S> {
    pub(crate) fn scene(&self) -> Result<Scene<'_, S>, Box<dyn Error>> {
        let scene = Scene::new(&self.objects, &self.materials, &self.lights, self.camera)?;
        let scene =
            scene.with_background(self.background).with_normals(&self.normals)?.with_textures(&self.textures)?;
        Ok(self.fog.map_or(scene, |fog| scene.with_fog(fog)))
    }
}

/// A store that never fills up. The library has its own for `Vec` behind the feature `std`; with this one the example
/// runs with the default features.
struct Growing<T>(Vec<T>);

impl<T> Store<T> for Growing<T> {
    fn push(&mut self, item: T) -> Result<(), Full> {
        self.0.push(item);
        Ok(())
    }
}
