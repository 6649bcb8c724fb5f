//! The picture that every chip draws: the text of its scene, where the scene is kept, and its rows of pixels.
//!
//! No frame buffer: what is kept is the scene and, for as long as it is written, one row.

use heapless::Vec;
use raylet::scene::nff::{self, Corner, NffError, Stores, View};
use raylet::scene::{CornerNormals, SceneError};
use raylet::{Light, Material, Object, Picture, Scalar, Scene, Size, TraceContext};

/// The scene, as it stands in flash.
const TEXT: &str = include_str!("picture.nff");

/// Columns; the scene has the same.
pub const WIDTH: u16 = 96;
/// Rows.
pub const HEIGHT: u16 = 72;
/// Pixels.
pub const PIXELS: u64 = WIDTH as u64 * HEIGHT as u64;

/// What goes before the pixels in a portable pixmap ("P6").
pub const HEADER: &str = "P6\n96 72\n255\n";

/// One row of a portable pixmap.
pub type Row = [u8; WIDTH as usize * 3];

/// Where the scene is kept: room for what the text holds and no more.
#[derive(Debug)]
pub struct Storage<S: Scalar> {
    objects: Vec<Object<S>, 11>,
    materials: Vec<Material<S>, 9>,
    lights: Vec<Light<S>, 2>,
    /// The scene has no smooth polygons.
    normals: Vec<CornerNormals<S>, 0>,
}

impl<S: Scalar> Storage<S> {
    /// Room for the scene.
    pub const fn new() -> Self {
        Self { objects: Vec::new(), materials: Vec::new(), lights: Vec::new(), normals: Vec::new() }
    }

    /// Reads the scene's text; call it once.
    ///
    /// # Errors
    ///
    /// [`NffError`] if the text is at fault, or there is more in it than there is room for.
    pub fn read(&mut self) -> Result<View<S>, NffError> {
        let stores = Stores {
            objects: &mut self.objects,
            materials: &mut self.materials,
            lights: &mut self.lights,
            normals: &mut self.normals,
            corners: &mut [Corner::default(); 4],
        };
        nff::read(TEXT, stores)
    }

    /// The scene that was read, as `view` sees it.
    ///
    /// # Errors
    ///
    /// [`SceneError`] if the lists do not fit together, which the reader excludes.
    pub fn scene(&self, view: &View<S>) -> Result<Scene<'_, S>, SceneError> {
        let scene = Scene::new(&self.objects, &self.materials, &self.lights, view.camera)?;
        Ok(scene.with_background(view.background))
    }
}

impl<S: Scalar> Default for Storage<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// The picture of a scene in the size of all of them.
pub fn picture<'a, S: Scalar>(scene: &'a Scene<'a, S>) -> Picture<'a, S> {
    Picture::new(scene, Size::new(WIDTH, HEIGHT))
}

/// One row as eight-bit levels of red, green and blue.
pub fn row<S: Scalar>(picture: &Picture<'_, S>, y: u16, context: &mut TraceContext) -> Row {
    let mut row = [0; WIDTH as usize * 3];
    for (pixel, levels) in picture.row(y, context).zip(row.chunks_exact_mut(3)) {
        levels.copy_from_slice(&pixel.color.to_srgb888());
    }
    row
}
