//! The tests that the rays of pictures put to objects: of the built-in scenes, and of four larger ones.
//!
//! These are after those of Haines, *A Proposal for Standard Graphics Environments* (1987), made anew and smaller;
//! every surface is a mirror.

use crate::cost::scenes::flake;
use raylet::scene::{Hierarchy, Node};
use raylet::{Camera, Cone, Cylinder, Frame, Material, Object, Ray, Scalar, Scene, Shape, Sphere, Triangle, Vec3};
use shared::pictured::{BUILT_IN, SIZE, View, of_built_in, tests};
use shared::workload::Query;

/// What they are called.
pub const PICTURES: [&str; 6] =
    ["picture of balls", "picture of rings", "picture of tree", "picture of mountains", BUILT_IN[0].1, BUILT_IN[1].1];

type Objects<S> = Vec<Object<S>>;

fn point<S: Scalar>(at: [f64; 3]) -> Option<Vec3<S>> {
    Vec3::from_f64(at).ok()
}

fn ball<S: Scalar>(at: [f64; 3], radius: f64) -> Option<Object<S>> {
    let shape = Shape::new(Sphere::new(S::from_f64(radius).ok()?).ok()?);
    Some(Object::new(shape.placed(Frame::at(point(at)?).ok()?), 0))
}

/// From one point to another, as wide at the ends as given.
fn tube<S: Scalar>(from: [f64; 3], to: [f64; 3], radii: [f64; 2]) -> Option<Object<S>> {
    let (frame, length) = Frame::between(point(from)?, point(to)?).ok()?;
    let [base, top] = radii.map(|radius| S::from_f64(radius).ok());
    let shape = if radii[0] == radii[1] {
        Shape::new(Cylinder::capped(base?, length).ok()?)
    } else {
        Shape::new(Cone::frustum(base?, top?, length).ok()?)
    };
    Some(Object::new(shape.placed(frame), 0))
}

/// Hexagons of cylinders with a ball at each corner.
fn rings<S: Scalar>() -> Option<Objects<S>> {
    let mut objects = vec![];
    for ring in 0..36 {
        let middle = [(ring % 6) as f64 - 2.5, 0.0, (ring / 6) as f64 - 2.5].map(|c| c * 1.2);
        let lean = 0.3 * ring as f64;
        let corner = |i: usize| {
            let turn = i as f64 * std::f64::consts::TAU / 6.0;
            let (x, y) = (0.5 * libm::cos(turn), 0.5 * libm::sin(turn));
            [middle[0] + x, middle[1] + y * libm::cos(lean), middle[2] + y * libm::sin(lean)]
        };
        for i in 0..6 {
            objects.push(tube(corner(i), corner(i + 1), [0.06; 2])?);
            objects.push(ball(corner(i), 0.1)?);
        }
    }
    Some(objects)
}

/// A trunk that forks, and forks again, each branch thinner at its end.
fn tree<S: Scalar>() -> Option<Objects<S>> {
    let mut objects = vec![];
    let mut branches = vec![([0.0, -1.5, 0.0], [0.0, 1.0, 0.0], 1.2, 0.16)];
    for index in 0..127 {
        let (from, along, length, radius): ([f64; 3], [f64; 3], f64, f64) = branches[index];
        let to = [0, 1, 2].map(|i| from[i] + length * along[i]);
        objects.push(tube(from, to, [radius, radius * 0.7])?);
        objects.push(ball(to, radius * 0.7)?);
        for side in [-1.0, 1.0] {
            let turn = 1.3 * index as f64;
            let aside = [side * libm::cos(turn), 0.3, side * libm::sin(turn)];
            let next = [0, 1, 2].map(|i| along[i] + 0.6 * aside[i]);
            let norm = next.iter().map(|c| c * c).sum::<f64>().sqrt();
            branches.push((to, next.map(|c| c / norm), length * 0.75, radius * 0.7));
        }
    }
    Some(objects)
}

/// Two triangles a square of a rough height field, and four balls over it.
fn mountains<S: Scalar>() -> Option<Objects<S>> {
    const SIDE: i32 = 14;
    let corner = |x: i32, z: i32| {
        let (u, v) = (f64::from(x) - 0.5 * f64::from(SIDE), f64::from(z) - 0.5 * f64::from(SIDE));
        let rough = f64::from((x * 7919 + z * 104_729) % 97) / 97.0;
        point([u / 4.0, 0.5 * libm::sin(u / 2.0) * libm::cos(v / 3.0) + 0.2 * rough - 0.5, v / 4.0])
    };
    let mut objects = vec![];
    for (x, z) in (0..SIDE).flat_map(|x| (0..SIDE).map(move |z| (x, z))) {
        let [a, b, c, d] = [corner(x, z)?, corner(x + 1, z)?, corner(x + 1, z + 1)?, corner(x, z + 1)?];
        for [p, q, r] in [[a, c, b], [a, d, c]] {
            objects.push(Object::new(Shape::new(Triangle::new(p, q, r).ok()?), 0));
        }
    }
    for [x, z] in [[-0.7, -0.5], [0.6, -0.8], [-0.5, 0.7], [0.8, 0.6]] {
        objects.push(ball([x, 0.7, z], 0.35)?);
    }
    Some(objects)
}

/// Some of the tests of a picture, evenly.
fn tests_of<S: Scalar>(objects: &[Object<S>]) -> Option<Vec<Query<S>>> {
    let eye = point([2.3, 1.9, 3.1])?;
    let up = point([0.0, 1.0, 0.0])?;
    let materials = [Material::default().with_mirror(S::from_f64(0.5).ok()?)];
    let camera = Camera::new(eye, Vec3::ZERO, up, S::from_f64(45.0).ok()?).ok()?;
    let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(objects.len())];
    let hierarchy = Hierarchy::build(objects, &mut nodes).ok()?;
    let scene = Scene::new(objects, &materials, &[], camera).ok()?.with_hierarchy(&hierarchy).ok()?;
    let [columns, rows] = SIZE.map(i32::from);
    let pixels = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let rays = pixels.filter_map(|(column, row)| {
        // On the plane through the middle of the scene that faces the eye, or nearly so.
        let (u, v) = (f64::from(2 * column + 1 - columns) / 12.0, f64::from(rows - 2 * row - 1) / 12.0);
        Ray::towards(eye, point([u * 0.8, v * 0.9, -u * 0.6])?).ok()
    });
    let view = View { scene: &scene, lamp: point([4.0, 6.0, 1.0])?, depth: 1 };
    Some(tests(view, &rays).into_iter().collect())
}

/// The tests of each picture.
pub fn tests_of_each<S: Scalar>() -> Vec<(&'static str, Vec<Query<S>>)> {
    let own = [flake(820), rings(), tree(), mountains()]
        .map(|objects: Option<Objects<S>>| objects.and_then(|objects| tests_of(&objects)));
    let built_in = BUILT_IN.map(|(scene, _)| of_built_in(scene).map(|tests| tests.into_iter().collect()));
    PICTURES.into_iter().zip(own.into_iter().chain(built_in).map(Option::unwrap_or_default)).collect()
}
