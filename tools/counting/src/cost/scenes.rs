//! Cost against work: rays in scenes of ever more spheres.

use super::{Case, KINDS, Name, QUERIES};
use raylet::scene::{Hierarchy, Node};
use raylet::{Camera, Counters, Frame, Material, Object, Ray, Scalar, Scene, Shape, Sphere, Vec3};
use shared::digest::Random;
use shared::subject::eighths;
use std::hint::black_box;

/// How many spheres.
pub const OBJECTS: [usize; 5] = [1, 4, 16, 64, 256];

/// How many a sphere flake has whose last are a 243rd of the first: too many to be tested one after the other.
pub const FLAKE: usize = 66_430;

/// How a scene goes through its objects.
pub const WALKS: [&str; 2] = ["one after the other", "in boxes"];

/// What a scene is called in a table.
pub fn subject(objects: usize, walk: &str) -> String {
    format!("scene of {objects}, {walk}")
}

/// Small spheres, none further than two from the origin along an axis; the first of a large scene are those of a small
/// one.
///
/// A scene borrows its lists and a case owns what it runs, so the lists live until the program ends.
fn scene<S: Scalar>(objects: usize) -> Option<Scene<'static, S>> {
    let mut random = Random(0x0123_4567_89ab_cdef);
    let sphere = Sphere::new(eighths::<S>(1)).ok()?;
    let objects: Option<Vec<Object<S>>> = (0..objects)
        .map(|_| Some(Object::new(Shape::new(sphere).placed(Frame::at(random.point(2)).ok()?), 0)))
        .collect();
    of_objects(objects?)
}

fn of_objects<S: Scalar>(objects: Vec<Object<S>>) -> Option<Scene<'static, S>> {
    let materials = vec![Material::default()];
    let (eye, up) = (Vec3::new(S::ZERO, S::ZERO, eighths(64)), Vec3::new(S::ZERO, eighths(8), S::ZERO));
    let camera = Camera::new(eye, Vec3::ZERO, up, eighths(360)).ok()?;
    Scene::new(objects.leak(), materials.leak(), &[], camera).ok()
}

/// A ball with nine balls of a third of its radius on it, each with nine of its own, and so on: six on its equator and
/// three above (after the "sphere flake" of Haines, *A Proposal for Standard Graphics Environments*, 1987, who turns
/// each to its own axis).
pub fn flake<S: Scalar>(count: usize) -> Option<Vec<Object<S>>> {
    let directions = || {
        let around = |count: usize, start: f64, rise: f64| {
            let (up, aside) = (libm::sin(rise), libm::cos(rise));
            (0..count).map(move |i| {
                let turn = start + i as f64 * core::f64::consts::TAU / count as f64;
                [aside * libm::cos(turn), up, aside * libm::sin(turn)]
            })
        };
        around(6, 0.0, 0.0).chain(around(3, 0.5, 1.0))
    };
    let mut balls = vec![([0.0; 3], 1.0)];
    for parent in 0..count / 9 {
        let ([x, y, z], radius): ([f64; 3], f64) = balls[parent];
        let away = radius * 4.0 / 3.0;
        balls.extend(directions().map(|[dx, dy, dz]| ([x + away * dx, y + away * dy, z + away * dz], radius / 3.0)));
    }
    let object = |(centre, radius)| {
        let sphere = Shape::new(Sphere::new(S::from_f64(radius).ok()?).ok()?);
        Some(Object::new(sphere.placed(Frame::at(Vec3::from_f64(centre).ok()?).ok()?), 0))
    };
    balls.into_iter().map(object).collect()
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
        .take(QUERIES)
        .collect()
}

/// A query of a scene.
type Query<S> = fn(&Scene<'static, S>, &Ray<S>);

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
        for (walk, scene) in WALKS.into_iter().zip([Some(scene), in_boxes(scene)]) {
            cases.extend(scene.into_iter().flat_map(|scene| of_scene(number, objects, walk, scene)));
        }
    }
    if let Some(flake) = flake::<S>(FLAKE).and_then(of_objects).and_then(in_boxes) {
        cases.extend(of_scene(number, FLAKE, WALKS[1], flake));
    }
    cases
}

/// Both queries, with rays that hit and rays that miss.
fn of_scene<S: Scalar>(
    number: &'static str,
    objects: usize,
    walk: &'static str,
    scene: Scene<'static, S>,
) -> Vec<Case> {
    let mut cases = Vec::new();
    for (hitting, kind) in KINDS {
        let rays = rays(&scene, hitting);
        let queries: [(_, Query<S>); 2] = [("nearest", nearest::<S>), ("occlusion", occlusion::<S>)];
        for (query, run) in queries {
            let name = Name { subject: subject(objects, walk), query, number, tier: "Stable", rays: kind };
            cases.push(Case::new(name, scene, rays.clone(), run));
        }
    }
    cases
}
