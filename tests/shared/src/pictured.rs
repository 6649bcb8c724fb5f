//! The tests that the rays of a picture put to objects: through the middles of pixels, to a lamp, mirrored and
//! refracted.

use crate::workload::{QUERIES, Query};
use heapless::Vec;
use raylet::gallery::BuiltIn;
use raylet::scene::Observer;
use raylet::{Counters, Leaving, Ray, Scalar, Scene, Size, Surface, UnitVec3, Vec3};

/// The built-in scenes whose tests are taken, and what that is called: every solid once, and glass, which rays pass
/// through.
pub const BUILT_IN: [(BuiltIn, &str); 2] =
    [(BuiltIn::StillLife, "picture of the still life"), (BuiltIn::Glass, "picture of glass")];

/// Columns and rows of pixels.
pub const SIZE: [u16; 2] = [24, 18];

/// A path ends after so many surfaces that mirror or refract.
const DEPTH: u32 = 3;

/// Tests of a picture.
pub type Tests<S> = Vec<Query<S>, QUERIES>;

/// A scene, the lamp to which rays lead from every point that is seen, and how many mirrors and panes a path passes.
#[derive(Clone, Copy, Debug)]
pub struct View<'a, S: Scalar> {
    /// The scene.
    pub scene: &'a Scene<'a, S>,
    /// The lamp.
    pub lamp: Vec3<S>,
    /// The surfaces.
    pub depth: u32,
}

/// Hands on what is put to the objects.
struct Watched<'a, S: Scalar, F> {
    view: View<'a, S>,
    ray: Ray<S>,
    test: F,
}

impl<S: Scalar, F: FnMut(Query<S>)> Observer for Watched<'_, S, F> {
    fn tested(&mut self, object: u32, _: bool) {
        // A ray departs from one object, and is an ordinary one to the others.
        let own = self.ray.departure().is_some_and(|departure| departure.object == object);
        let ray = if own { self.ray } else { self.ray.without_departure() };
        if let Some(object) = self.view.scene.object(object) {
            (self.test)(Query { shape: object.shape, ray });
        }
    }
}

impl<S: Scalar, F: FnMut(Query<S>)> Watched<'_, S, F> {
    fn follow(&mut self, ray: &Ray<S>, depth: u32) {
        let scene = self.view.scene;
        self.ray = *ray;
        let Some(on) = scene.nearest_for(ray, &mut Counters::default(), self) else { return };
        let Some(object) = scene.object(on.object) else { return };
        let surface = object.shape.surface(ray, &on.hit);
        let (d, n) = (ray.direction().to_f64(), surface.normal().to_f64());
        let along: f64 = (0..3).map(|i| d[i] * n[i]).sum();
        let (before, behind) =
            if along < 0.0 { (Leaving::Outwards, Leaving::Inwards) } else { (Leaving::Inwards, Leaving::Outwards) };

        if let Ok(ray) = Ray::towards(surface.point(), self.view.lamp) {
            self.ray = ray.departing(surface.departure(on.object, before));
            scene.occluder(&self.ray.clone(), &mut Counters::default(), self);
        }
        let Some(material) = scene.material_of(object, on.hit.part).filter(|_| depth != 0) else { return };
        let refracted = if material.transmits() { refracted(d, n, along, material.refraction.to_f64()) } else { None };
        if let Some(ray) = refracted.and_then(|through| leaving(&surface, on.object, through, behind)) {
            self.follow(&ray, depth - 1);
        }
        // All light is mirrored where none passes.
        if material.mirror > S::ZERO || (material.transmits() && refracted.is_none()) {
            let mirrored = [0, 1, 2].map(|i| d[i] - 2.0 * along * n[i]);
            if let Some(ray) = leaving(&surface, on.object, mirrored, before) {
                self.follow(&ray, depth - 1);
            }
        }
    }
}

/// The ray from the surface along `direction`.
fn leaving<S: Scalar>(surface: &Surface<S>, object: u32, direction: [f64; 3], leaving: Leaving) -> Option<Ray<S>> {
    let direction = UnitVec3::new(Vec3::from_f64(direction).ok()?).ok()?;
    Some(Ray::new(surface.point(), direction).ok()?.departing(surface.departure(object, leaving)))
}

/// Where light along `d` goes behind a surface with the normal `n`, `along = d . n`, by Snell's law; `None` if all is
/// reflected.
fn refracted(d: [f64; 3], n: [f64; 3], along: f64, index: f64) -> Option<[f64; 3]> {
    let ratio = if along < 0.0 { 1.0 / index } else { index };
    let square = 1.0 - ratio * ratio * (1.0 - along * along);
    if square <= 0.0 {
        return None;
    }
    let cosine = if along < 0.0 { -libm::sqrt(square) } else { libm::sqrt(square) };
    Some([0, 1, 2].map(|i| ratio * (d[i] - along * n[i]) + cosine * n[i]))
}

/// Some of the tests, evenly, that the rays which begin with these put to the objects.
pub fn tests<S: Scalar>(view: View<'_, S>, rays: &(impl Iterator<Item = Ray<S>> + Clone)) -> Tests<S> {
    let each = |test: &mut dyn FnMut(Query<S>)| {
        for ray in rays.clone() {
            Watched { view, ray, test: &mut *test }.follow(&ray, view.depth);
        }
    };
    let mut count = 0;
    each(&mut |_| count += 1);
    let every = (count / QUERIES).max(1);
    let (mut index, mut tests) = (0, Vec::new());
    each(&mut |test| {
        if index % every == 0 && !tests.is_full() {
            tests.extend([test]);
        }
        index += 1;
    });
    tests
}

/// Some of the tests of the picture of a built-in scene.
pub fn of_built_in<S: Scalar>(scene: BuiltIn) -> Option<Tests<S>> {
    let stage = scene.build::<S>()?;
    let scene = stage.scene().ok()?;
    let lamp = scene.lights().first()?.position;
    let [columns, rows] = SIZE;
    let raster = scene.camera().raster(Size::new(columns, rows));
    let rays = (0..rows)
        .flat_map(|row| (0..columns).map(move |column| [column, row]))
        .filter_map(|pixel| raster.ray(pixel, [0, 0]));
    Some(tests(View { scene: &scene, lamp, depth: DEPTH }, &rays))
}
