//! Surfaces that coincide: slabs that touch, polygons given twice, decals, a block in pieces.

use crate::glass::*;
use crate::values::point;
use fixed::types::{I16F16, I20F12, I32F32};
use raylet::scalar::UnitScalar;
use raylet::scene::nff::{self, Corner, Stores};
use raylet::scene::{Hierarchy, Node};
use raylet::{
    Color, Counters, Cuboid, Exact, Fast, Frame, Light, Material, Object, Picture, Plain, Scalar, Scene, Shape, Size,
    Stable, Tier, UnitVec3,
};
use support::call_in_every_tier;
use support::random::Random;

/// The fraction of light that passes plates of glass at right angles, with all reflections between their faces (Stokes
/// 1862).
fn transmission(plates: f64, index: f64) -> f64 {
    let reflectance = ((index - 1.0) / (index + 1.0)).powi(2);
    (1.0 - reflectance) / (1.0 + (2.0 * plates - 1.0) * reflectance)
}

/// Something black above the eye, so that only light from below is seen.
fn under_a_lid<S: Scalar>(mut objects: Vec<Object<S>>, mut materials: Vec<Material<S>>, lean: [f64; 3]) -> Case<S> {
    objects.push(slab(8.0, 9.0, lean, materials.len() as u32));
    materials.push(Material::matte(Color::BLACK));
    (objects, materials)
}

fn slabs_that_touch<S: Scalar, T: Tier<S>>(tolerance: f64) {
    for lean in [[0.0, 1.0, 0.0], [0.3, 1.0, -0.2], [-0.7, 0.4, 0.1]] {
        let up = lean.map(|c: f64| 6.0 * c);
        let case = |slabs: Vec<Object<S>>| under_a_lid(slabs, vec![glass(1.5), glass(1.5)], lean);
        let one = case(vec![slab(0.0, 2.0, lean, 0)]);
        let two = case(vec![slab(0.0, 1.0, lean, 0), slab(1.0, 2.0, lean, 0)]);
        let other = case(vec![slab(1.0, 2.0, lean, 1), slab(0.0, 1.0, lean, 0)]);
        for target in [[0.0; 3], [0.3, -0.1, 0.2], [1.5, 0.2, -0.7]] {
            let (light, counters) = seen::<S, T, _>(&one, up, target);
            for case in [&two, &other] {
                let (both, counted) = seen::<S, T, _>(case, up, target);
                assert!((light - both).abs() <= tolerance, "{lean:?} {target:?}: {light} {both}");
                assert_eq!(counters.refraction_rays, counted.refraction_rays, "{lean:?} {target:?}");
            }
        }
        let (light, _) = seen::<S, T, _>(&two, up, [0.0; 3]);
        assert!((light - transmission(1.0, 1.5)).abs() <= tolerance, "{light}");
    }
}

/// EGSnrc#462, #28: two slabs that touch were black, with 65,489 rays.
#[test]
fn two_slabs_that_touch_are_one() {
    fn tiers<S: Scalar>(tolerance: f64)
    where
        Plain: Tier<S>,
        Fast: Tier<S>,
        Stable: Tier<S>,
    {
        slabs_that_touch::<S, Plain>(tolerance);
        slabs_that_touch::<S, Fast>(tolerance);
        slabs_that_touch::<S, Stable>(tolerance);
    }
    slabs_that_touch::<f32, Exact>(1e-5);
    slabs_that_touch::<I16F16, Exact>(1e-3);
    tiers::<f32>(1e-5);
    tiers::<f64>(1e-9);
    tiers::<I16F16>(1e-3);
    tiers::<I32F32>(1e-7);
}

#[test]
fn slabs_with_a_gap_are_two() {
    let level = [0.0, 1.0, 0.0];
    let apart = under_a_lid::<f64>(vec![slab(0.0, 1.0, level, 0), slab(1.001, 2.0, level, 0)], vec![glass(1.5)], level);
    let (light, _) = seen::<f64, Stable, _>(&apart, [0.0, 6.0, 0.0], [0.0; 3]);
    assert!((light - transmission(2.0, 1.5)).abs() < 1e-6, "{light}");
}

fn picture<S: Scalar, T: Tier<S>>(text: &str, both_sides: bool) -> Vec<(Option<u32>, [f64; 3])> {
    let (mut objects, mut materials) = (heapless::Vec::<_, 32>::new(), heapless::Vec::<_, 3>::new());
    let (mut lights, mut normals) = (heapless::Vec::<Light<S>, 1>::new(), heapless::Vec::<_, 1>::new());
    let mut corners = [Corner::default(); 4];
    let stores = Stores {
        objects: &mut objects,
        materials: &mut materials,
        lights: &mut lights,
        normals: &mut normals,
        corners: &mut corners,
    };
    let view = nff::read::<S>(text, stores).unwrap();
    if both_sides {
        for object in &mut objects {
            object.shape = object.shape.seen_from(raylet::Visible::Both);
        }
    }
    let scene = Scene::new(&objects, &materials, &lights, view.camera).unwrap().with_background(view.background);
    let scene = scene.at_tier::<T>();
    let mut pixels = Vec::new();
    let counters = Picture::new(&scene, Size::new(32, 24)).render(|_, _, pixel| {
        pixels.push((pixel.seen.map(|(object, _)| object), pixel.color.to_array().map(UnitScalar::to_f64)));
    });
    assert!(counters.rays() < 32 * 24 * 8, "{counters:?}");
    pixels
}

const VIEW: &str = "v from 0 3 6 at 0 0 0 up 0 1 0 angle 40 hither 0.1 resolution 32 24 b .2 .3 .5 l 3 8 4\n";

/// A square about a point of a plane through the origin that leans.
fn square(size: f64, lean: f64) -> String {
    let corner = |x: f64, z: f64| format!("{} {} {}\n", x * size, x * size * lean + z * size * 0.3 * lean, z * size);
    format!("p 4\n{}{}{}{}", corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0))
}

/// ray-optics#230, povray#209: a polygon of glass given twice did not finish; an opaque one was black.
#[test]
fn a_polygon_given_twice_is_one() {
    fn check<S: Scalar, T: Tier<S>>() {
        for lean in [0.0, 0.31, -0.17] {
            for (fill, both_sides) in [("f 1 1 1 .1 0 1 .9 1.5\n", false), ("f 1 .8 .6 1 0 1 0 1\n", true)] {
                let polygon = square(2.0, lean);
                let once = picture::<S, T>(&format!("{VIEW}{fill}{polygon}"), both_sides);
                let twice = picture::<S, T>(&format!("{VIEW}{fill}{polygon}{polygon}"), both_sides);
                for (pixel, (once, twice)) in once.iter().zip(&twice).enumerate() {
                    assert_eq!(once.1, twice.1, "pixel {pixel}, lean {lean}, {fill}");
                }
            }
        }
    }
    call_in_every_tier!(check);
}

#[test]
fn a_decal_in_the_plane_of_a_wall_is_seen_and_lit() {
    fn check<S: Scalar, T: Tier<S>>() {
        for lean in [0.0, 0.31, -0.17, 0.05, 0.6] {
            let (wall, decal) = (square(2.0, lean), square(1.0, lean));
            let scene = |decal: &str| format!("{VIEW}f 1 .8 .6 1 0 1 0 1\n{wall}f .2 .9 .3 1 0 1 0 1\n{decal}");
            let without = picture::<S, T>(&scene(""), true);
            let alone = picture::<S, T>(&format!("{VIEW}f .2 .9 .3 1 0 1 0 1\n{decal}"), true);
            let both = picture::<S, T>(&scene(&decal), true);
            for ((without, alone), both) in without.iter().zip(&alone).zip(&both) {
                let right = if alone.0.is_some() { alone } else { without };
                assert_eq!(right.1, both.1, "lean {lean}");
            }
        }
    }
    call_in_every_tier!(check);
    check::<I20F12, Fast>();
}

/// A block in 27 pieces of one glass is one block, for rays from outside and from inside.
#[test]
fn a_block_in_pieces_is_one_block() {
    fn check<S: Scalar, T: Tier<S>>(tolerance: f64) -> [usize; 3] {
        let mut random = Random(0x5EED_B10C);
        let (mut wrong, mut more, mut rays) = (0, 0, 0);
        for turn in 0..12 {
            let axis = UnitVec3::new(point::<S>(random.direction())).unwrap();
            let turned = |at: Vector| {
                let frame = Frame::turned_about(point(at), axis, number(f64::from(turn) * 29.0)).unwrap();
                assert!(turn > 0 || frame.left() == UnitVec3::X);
                frame
            };
            let whole = turned([0.0; 3]);
            let cuboid = |half: f64| Shape::new(Cuboid::new(number(half), number(half), number(half)).unwrap());
            let mut pieces = Vec::new();
            for index in 0..27 {
                let at = [index % 3, index / 3 % 3, index / 9].map(|i| 1.25 * (f64::from(i) - 1.0));
                let place = whole.moved_to(whole.point_to_world(point(at))).unwrap();
                pieces.push(Object::new(cuboid(0.625).placed(place), 0));
            }
            let one = (vec![Object::new(cuboid(1.875).placed(whole), 0)], vec![glass::<S>(1.5)]);
            let many = (pieces, vec![glass::<S>(1.5)]);
            for _ in 0..80 {
                let away = if random.below(3) == 0 { 0.4 } else { 6.0 };
                let from = random.direction().map(|c| c * away);
                let to = random.direction().map(|c| c * 1.2 * random.unit());
                let ((light, counters), (other, counted)) =
                    (seen_over::<S, T>(&one, from, to), seen_over::<S, T>(&many, from, to));
                rays += 1;
                wrong += usize::from((light - other).abs() > tolerance);
                more += usize::from(counters.refraction_rays != counted.refraction_rays);
            }
        }
        [rays, wrong, more]
    }
    // Rays that meet a shared face at less than 1/16, and those that pass within a rounding of a silhouette.
    let most = [10, 20];
    let counted = [
        check::<f32, Plain>(1e-4),
        check::<f32, Stable>(1e-4),
        check::<f32, Exact>(1e-4),
        check::<f64, Stable>(1e-9),
        check::<I16F16, Stable>(1e-2),
        check::<I16F16, Exact>(1e-2),
        check::<I32F32, Fast>(1e-6),
    ];
    for [rays, wrong, more] in counted {
        assert!(rays == 960 && wrong <= most[0] && more <= most[1], "{counted:?}");
    }
}

/// As [`seen`], over a floor of black and white, so that what is seen depends on the path.
fn seen_over<S: Scalar, T: Tier<S>>((objects, materials): &Case<S>, from: Vector, to: Vector) -> (f64, Counters) {
    let (mut objects, mut materials) = (objects.clone(), materials.clone());
    let material = materials.len() as u32;
    materials.push(Material::matte(Color::BLACK));
    objects.push(ball_of([3.0, -4.0, 1.0], 2.0, material));
    objects.push(ball_of([-4.0, 2.0, 2.0], 2.0, material));
    objects.push(ball_of([0.0, 1.0, -5.0], 2.0, material));
    seen::<S, T, _>(&(objects, materials), from, to)
}

/// A scene of glass pieces and balls gives the same light to the bit with a hierarchy, and shows what `Scene::seen`
/// says.
#[test]
fn a_hierarchy_changes_no_light_among_coincident_surfaces() {
    fn check<S: Scalar, T: Tier<S>>() {
        let (mut random, mut doubled) = (Random(0x0B0C_5EED), 0);
        for turn in 0..8 {
            let axis = UnitVec3::new(point::<S>(random.direction())).unwrap();
            let whole = Frame::turned_about(point([0.0; 3]), axis, number(f64::from(turn) * 31.0)).unwrap();
            let half = number(0.625);
            let piece = Shape::new(Cuboid::new(half, half, half).unwrap());
            let mut objects = Vec::new();
            for index in 0..18 {
                let at = [index % 3, index / 3 % 3, index / 9].map(|i| 1.25 * (f64::from(i) - 1.0));
                let frame = whole.moved_to(whole.point_to_world(point(at))).unwrap();
                // Two glasses, and an opaque one that is given twice.
                let material = if index < 16 { index % 2 } else { 2 };
                objects.push(Object::new(piece.placed(frame), material as u32));
            }
            objects.push(objects[17]);
            let clear = |index| Material { diffuse: number::<S>(0.05), ..glass(index) };
            let materials = [clear(1.5), clear(1.25), Material::matte(Color::WHITE)];
            let lights = [Light::new(point([6.0, 9.0, 4.0]), number(1.0))];
            let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap().at_tier::<T>();
            let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(objects.len())];
            let boxed = scene.with_hierarchy(&Hierarchy::build(&objects, &mut nodes).unwrap()).unwrap();
            let size = Size::new(24, 18);
            let pixels = |scene| {
                let mut pixels = Vec::new();
                Picture::new(scene, size).render(|x, y, pixel| pixels.push((x, y, pixel)));
                pixels
            };
            let (plain, fast) = (pixels(&scene), pixels(&boxed));
            assert_eq!(plain, fast, "turn {turn}");
            doubled += plain.iter().filter(|(_, _, pixel)| pixel.seen.is_some_and(|(object, _)| object == 18)).count();
            // Between equal media nothing is seen; elsewhere a picture shows what the query says.
            let raster = scene.camera().raster(size);
            for (x, y, pixel) in plain {
                let ray = raster.ray([x, y], [0, 0]).unwrap();
                let seen = scene.seen(&ray, &mut Counters::default());
                assert_eq!(pixel.seen.map(|(object, _)| object), seen.map(|on| on.object), "turn {turn}, {x} {y}");
            }
        }
        assert!(doubled > 50, "{doubled} pixels of the cube that is given twice");
    }
    call_in_every_tier!(check);
}

/// Six copies are one; of more than a path remembers, the picture is finished all the same.
#[test]
fn a_polygon_given_many_times_is_one() {
    for copies in 2..=6 {
        let polygon = square(2.0, 0.31);
        for (fill, both_sides) in [("f 1 1 1 .1 0 1 .9 1.5\n", false), ("f 1 .8 .6 1 0 1 0 1\n", true)] {
            let once = picture::<f32, Stable>(&format!("{VIEW}{fill}{polygon}"), both_sides);
            let many = picture::<f32, Stable>(&format!("{VIEW}{fill}{}", polygon.repeat(copies)), both_sides);
            let colors =
                |picture: Vec<(Option<u32>, Vector)>| picture.into_iter().map(|(_, color)| color).collect::<Vec<_>>();
            assert_eq!(colors(once), colors(many), "{copies} copies, {fill}");
        }
    }
    picture::<f32, Stable>(&format!("{VIEW}f 1 .8 .6 1 0 1 0 1\n{}", square(2.0, 0.31).repeat(14)), true);
}
