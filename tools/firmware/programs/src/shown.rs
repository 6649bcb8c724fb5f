//! The scenes of the gallery, files read on the chip in units that fit, with their hierarchies.

use heapless::Vec;
use raylet::gallery::BuiltIn;
use raylet::scene::nff::{self, Corner, Scale, Stores};
use raylet::scene::{CornerNormals, Hierarchy, Node};
use raylet::{Light, Material, Object, Scalar, Scene};

/// A scene file, in flash.
#[derive(Clone, Copy, Debug)]
pub struct File {
    /// Its name without the extension.
    pub name: &'static str,
    /// What it says.
    pub text: &'static str,
}

impl File {
    /// The scenes of the folder `examples/scenes`.
    pub const EVERY: [Self; 3] = [
        Self { name: "tubes", text: raylet_scenes::TUBES },
        Self { name: "star", text: raylet_scenes::STAR },
        Self { name: "dome", text: raylet_scenes::DOME },
    ];
}

/// The most objects of a scene.
const OBJECTS: usize = 192;
/// Up to this many objects all are tested, as the program `render` does.
const FEW_OBJECTS: usize = 8;

/// Reads a file, in units that fit the number type, and hands its scene on.
///
/// # Panics
///
/// If the file is not well-formed, or it does not fit into the lists that are kept for it.
pub fn with_file<S: Scalar>(file: File, then: impl FnOnce(&Scene<'_, S>)) {
    let (mut objects, mut materials) = (Vec::<Object<S>, OBJECTS>::new(), Vec::<Material<S>, 16>::new());
    let (mut lights, mut normals) = (Vec::<Light<S>, 4>::new(), Vec::<CornerNormals<S>, OBJECTS>::new());
    let stores = Stores {
        objects: &mut objects,
        materials: &mut materials,
        lights: &mut lights,
        normals: &mut normals,
        corners: &mut [Corner::default(); 32],
    };
    let view = nff::read_scaled(file.text, stores, Scale::fitting::<S>(file.text))
        .expect("the files of the gallery are well-formed, and fit into the lists");
    let scene = Scene::new(&objects, &materials, &lights, view.camera).expect("the reader's lists fit together");
    let scene = scene.with_background(view.background).with_normals(&normals).expect("so do the normals");
    with_hierarchy(&scene, then);
}

/// Hands a built-in scene on.
///
/// # Panics
///
/// If the number type cannot hold it.
pub fn with_built_in<S: Scalar>(built_in: BuiltIn, then: impl FnOnce(&Scene<'_, S>)) {
    let stage = built_in.build::<S>().expect("the built-in scenes fit every type");
    with_hierarchy(&stage.scene().expect("the stage's lists fit together"), then);
}

/// Hands a scene on, with a hierarchy if it has more than a few objects.
fn with_hierarchy<S: Scalar>(scene: &Scene<'_, S>, then: impl FnOnce(&Scene<'_, S>)) {
    if scene.objects().len() <= FEW_OBJECTS {
        return then(scene);
    }
    let mut nodes = [const { Node::EMPTY }; Hierarchy::<f32>::nodes_for(OBJECTS)];
    let hierarchy = Hierarchy::build(scene.objects(), &mut nodes).expect("there are nodes enough");
    then(&scene.with_hierarchy(&hierarchy).expect("the hierarchy is of these objects"));
}
