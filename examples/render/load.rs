//! Where a scene comes from: a built-in one, a file or standard input, in any number type.

use crate::arithmetic::Number;
use crate::files;
use crate::messages;
use crate::options::{Options, Units};
use crate::progress::Progress;
use crate::suggest;
use raylet::gallery::{BuiltIn, Stage};
use raylet::scene::nff::{self, Corner, Counts, NffError, Scale, Stores};
use raylet::scene::{CornerNormals, Full, Store};
use raylet::{Camera, Color, Fog, Light, Material, Object, Scalar, Scene, Texture, Visible};
use std::error::Error;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// In which size built-in scenes are shown.
const BUILT_IN_SIZE: [u16; 2] = [160, 120];

/// The text of a scene file, or a built-in scene.
#[derive(Debug)]
pub(crate) struct Source {
    name: String,
    content: Content,
}

#[derive(Debug)]
enum Content {
    BuiltIn(BuiltIn),
    Text { text: String, file: String },
}

impl Source {
    /// Reads a file (`-` is standard input), or takes the built-in scene.
    pub(crate) fn new(file: Option<&Path>, built_in: BuiltIn) -> Result<Self, Box<dyn Error>> {
        let Some(path) = file else {
            return Ok(Self { name: built_in.to_string(), content: Content::BuiltIn(built_in) });
        };
        let (name, file, bytes) = if path == Path::new("-") {
            let mut bytes = Vec::new();
            let read = io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes);
            ("stdin".into(), "standard input".to_owned(), read)
        } else {
            let name = path.file_stem().map_or("scene".into(), |stem| stem.to_string_lossy().into_owned());
            (name, path.display().to_string(), fs::read(path))
        };
        let bytes = bytes.map_err(|error| {
            let names = BuiltIn::EVERY.map(BuiltIn::name);
            let meant = if path.extension().is_none() { suggest::nearest(&file, names) } else { None };
            match meant {
                Some(name) => format!("cannot read {file}: {error}; there is a built-in scene, --scene {name}"),
                None => files::unread(Path::new(&file), &error),
            }
        })?;
        // The reader says where bytes are that are no text, and passes over them in comments.
        let text = match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => String::from_utf8_lossy(error.as_bytes()).into_owned(),
        };
        Ok(Self { name, content: Content::Text { text, file } })
    }

    /// The file's name without folder and suffix.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    pub(crate) fn load<S: Scalar>(
        &self,
        options: &Options,
        number: Number,
        progress: &Progress,
    ) -> Result<Loaded<S>, Box<dyn Error>> {
        let mut loaded = match &self.content {
            Content::Text { text, file } => parse(text, options.scale, Some(progress))
                .map_err(|(error, scale)| messages::fault::<S>(file, text, &error, options, number, scale))?,
            Content::BuiltIn(_) if options.scale != Units::Fitting => {
                return Err("only a file is read to scale: name one, or drop --scale".into());
            }
            Content::BuiltIn(scene) => {
                let stage = scene.build::<S>();
                stage.ok_or_else(|| format!("{number} cannot hold the scene {scene}: take -n f32"))?.into()
            }
        };
        if options.both_sides {
            for object in &mut loaded.objects {
                object.shape = object.shape.seen_from(Visible::Both);
            }
        }
        Ok(loaded)
    }
}

/// Reads a text, or says what is wrong with it and at which scale.
pub(crate) fn parse<S: Scalar>(
    text: &str,
    units: Units,
    progress: Option<&Progress>,
) -> Result<Loaded<S>, (NffError, Scale)> {
    let counts = Counts::of(text);
    if let Some(progress) = progress {
        progress.begin(counts.objects, "objects read");
    }
    let (mut objects, mut materials) = (Growing::new(progress), Growing::new(None));
    let (mut lights, mut normals) = (Growing::new(None), Growing::new(None));
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
    let view = nff::read_scaled(text, stores, scale).map_err(|error| (error, scale))?;
    Ok(Loaded {
        objects: objects.items,
        materials: materials.items,
        lights: lights.items,
        normals: normals.items,
        textures: Vec::new(),
        fog: None,
        background: view.background,
        ambient: Color::BLACK,
        camera: view.camera,
        resolution: view.resolution,
        remarks: Remarks { invisible: view.invisible, turned: view.turned, distant: view.distant, scale },
    })
}

/// What became of a file that its picture does not show.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Remarks {
    /// Objects that were left out.
    pub(crate) invisible: u32,
    /// Polygons that were turned round.
    pub(crate) turned: u32,
    /// Lights that count by their direction.
    pub(crate) distant: u32,
    /// Units of the scene in one of the file.
    pub(crate) scale: Scale,
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
    pub(crate) ambient: Color<S>,
    pub(crate) camera: Camera<S>,
    pub(crate) resolution: [u16; 2],
    pub(crate) remarks: Remarks,
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
            ambient: stage.ambient,
            camera: stage.camera,
            resolution: BUILT_IN_SIZE,
            remarks: Remarks { invisible: 0, turned: 0, distant: 0, scale: Scale::ONE },
        }
    }
}

impl<S: Scalar> Loaded<S> {
    pub(crate) fn scene(&self) -> Result<Scene<'_, S>, Box<dyn Error>> {
        let scene = Scene::new(&self.objects, &self.materials, &self.lights, self.camera)?;
        let scene = scene
            .with_background(self.background)
            .with_ambient(self.ambient)
            .with_normals(&self.normals)?
            .with_textures(&self.textures)?;
        Ok(self.fog.map_or(scene, |fog| scene.with_fog(fog)))
    }
}

/// A store that never fills up. The library has its own for `Vec` behind the feature `std`; with this one the example
/// runs with the default features.
struct Growing<'p, T> {
    items: Vec<T>,
    /// Told of every item, if any is.
    progress: Option<&'p Progress>,
}

impl<'p, T> Growing<'p, T> {
    const fn new(progress: Option<&'p Progress>) -> Self {
        Self { items: Vec::new(), progress }
    }
}

impl<T> Store<T> for Growing<'_, T> {
    fn push(&mut self, item: T) -> Result<(), Full> {
        self.items.push(item);
        if let Some(progress) = self.progress {
            progress.step();
        }
        Ok(())
    }
}
