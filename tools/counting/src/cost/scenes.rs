//! Cost against work: rays in scenes of ever more spheres.

use super::{Case, KINDS, Name, QUESTIONS};
use raylet::scene::{Hierarchy, Node};
use raylet::{Camera, Counters, Frame, Material, Object, Ray, Scalar, Scene, Shape, Sphere, Vec3};
use shared::digest::Random;
use shared::subject::eighths;
use std::hint::black_box;

/// How many spheres.
pub const OBJECTS: [usize; 5] = [1, 4, 16, 64, 256];

/// How a scene goes through its objects.
pub const WALKS: [&str; 2] = ["one after the other", "in boxes"];

/// What a scene is called in a table.
pub fn subject(objects: usize, walk: &str) -> String {
    format!("scene of {objects}, {walk}")
}

/// Small spheres, none further than two from the origin along an axis; the first of a large scene are those of a small one.
///
/// A scene borrows its lists and a case owns what it asks, so the lists live until the program ends.
fn scene<S: Scalar>(objects: usize) -> Option<Scene<'static, S>> {
    let mut random = Random(0x0123_4567_89ab_cdef);
    let sphere = Sphere::new(eighths::<S>(1)).ok()?;
    let objects: Option<Vec<Object<S>>> = (0..objects)
        .map(|_| Some(Object::new(Shape::new(sphere).placed(Frame::at(random.point(2)).ok()?), 0)))
        .collect();
    let materials = vec![Material::default()];
    let (eye, up) = (Vec3::new(S::ZERO, S::ZERO, eighths(64)), Vec3::new(S::ZERO, eighths(8), S::ZERO));
    let camera = Camera::new(eye, Vec3::ZERO, up, eighths(360)).ok()?;
    Scene::new(objects?.leak(), materials.leak(), &[], camera).ok()
}

/// The same scene with a hierarchy of boxes.
fn in_boxes<S: Scalar>(scene: Scene<'static, S>) -> Option<Scene<'static, S>> {
    let nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(scene.objects().len())].leak();
    let hierarchy = Hierarchy::build(scene.objects(), nodes).ok()?;
    scene.with_hierarchy(Box::leak(Box::new(hierarchy))).ok()
}

/// From 2 to 6 away towards a point among the spheres; all hit one, or none does.
fn rays<S: Scalar>(scene: &Scene<'static, S>, hitting: bool) -> Vec<Ray<S>> {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    std::iter::repeat_with(|| (random.point::<S>(6), random.point(2)))
        .filter(|(origin, _)| origin.to_array().iter().any(|c| c.to_f64().abs() > 2.25))
        .filter_map(|(origin, target)| Ray::towards(origin, target).ok())
        .filter(|ray| scene.occludes(ray, &mut Counters::default()) == hitting)
        .take(QUESTIONS)
        .collect()
}

/// What is asked of a scene.
type Question<S> = fn(&Scene<'static, S>, &Ray<S>);

#[inline(never)]
fn nearest<S: Scalar>(scene: &Scene<'static, S>, ray: &Ray<S>) {
    black_box(scene.nearest(ray, &mut Counters::default()));
}

#[inline(never)]
fn occlusion<S: Scalar>(scene: &Scene<'static, S>, ray: &Ray<S>) {
    black_box(scene.occludes(ray, &mut Counters::default()));
}

/// Every scene in one number type.
pub fn cases<S: Scalar>(number: &'static str) -> Vec<Case> {
    let mut cases = Vec::new();
    for objects in OBJECTS {
        let Some(scene) = scene::<S>(objects) else { continue };
        for (hitting, kind) in KINDS {
            let rays = rays(&scene, hitting);
            let questions: [(_, Question<S>); 2] = [("nearest", nearest::<S>), ("occlusion", occlusion::<S>)];
            for (query, question) in questions {
                for (walk, scene) in WALKS.into_iter().zip([Some(scene), in_boxes(scene)]) {
                    let name = Name { subject: subject(objects, walk), query, number, tier: "Stable", rays: kind };
                    cases.extend(scene.map(|scene| Case::new(name, scene, rays.clone(), question)));
                }
            }
        }
    }
    cases
}
