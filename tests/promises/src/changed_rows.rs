//! The promise: the rows of a picture that need not be drawn again are the same to the bit.

use fixed::types::{I16F16, I32F32};
use raylet::effect::All;
use raylet::scene::{Outline, Waves};
use raylet::tier::{Fast, Plain, Stable, Tier};
use raylet::{
    Camera, Color, Cone, Cuboid, Cylinder, Frame, Light, Material, Object, Picture, Pixel, Plane, Scalar, Scene, Shape,
    Size, Sphere, Torus, UnitVec3, Vec3,
};
use support::random::Random;

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).unwrap()
}

fn point<S: Scalar>(v: [f64; 3]) -> Vec3<S> {
    Vec3::from_f64(v).unwrap()
}

fn anywhere<S: Scalar>(random: &mut Random, most: f64) -> Vec3<S> {
    point([0; 3].map(|_| random.between(-most, most)))
}

fn frame<S: Scalar>(random: &mut Random, away: Vec3<S>) -> Frame<S> {
    Frame::from_base_and_axis(away + anywhere(random, 3.0), UnitVec3::new(point(random.direction())).unwrap()).unwrap()
}

/// A floor, and solids in the air over it, some of which mirror or are of glass.
fn objects<S: Scalar>(random: &mut Random, away: Vec3<S>) -> Vec<Object<S>> {
    let below = Frame::at(away + point([0.0, -3.5, 0.0])).unwrap();
    let mut objects = vec![Object::new(Shape::new(Plane::new()).placed(below), 0)];
    for _ in 0..5 {
        let size = random.between(0.1, 1.2);
        let [large, small] = [size, 0.4 * size].map(number);
        let shape = match random.below(5) {
            0 => Shape::new(Cylinder::capped(small, large).unwrap()),
            1 => Shape::new(Cone::capped(small, large).unwrap()),
            2 => Shape::new(Cuboid::new(small, large, small).unwrap()),
            3 => Shape::new(Torus::new(large, small).unwrap()),
            _ => Shape::new(Sphere::new(large).unwrap()),
        };
        // Few mirrors, or every row has one.
        let material = if random.below(5) == 0 { 1 + random.below(2) as u32 } else { 0 };
        objects.push(Object::new(shape.placed(frame(random, away)), material));
    }
    objects
}

fn materials<S: Scalar>() -> [Material<S>; 3] {
    let matte = Material::matte(Color::from_f64([0.9, 0.6, 0.3])).with_highlight(number(0.3), number(20.0));
    [matte, matte.with_mirror(number(0.5)), matte.with_refraction(number(0.6), number(1.5))]
}

fn rows<S: Scalar, T: Tier<S>>(picture: &Picture<'_, S, All, T>) -> Vec<Vec<Pixel<S>>> {
    let mut rows = vec![Vec::new(); usize::from(picture.size().height)];
    picture.render(|_, y, pixel| rows[usize::from(y)].push(pixel));
    rows
}

/// Frames in which one or two objects move, this far from the origin; returns the rows, those that are drawn again, and
/// those that differ.
fn check<S: Scalar, T: Tier<S>>(seed: u64, away: f64, samples: u8, outline: bool) -> [usize; 3] {
    let (mut random, mut counts) = (Random(seed), [0; 3]);
    let away: Vec3<S> = point([away, -0.5 * away, 0.8 * away]);
    let materials = materials::<S>();
    for _ in 0..12 {
        let far = |random: &mut Random, distance: f64| point(random.direction().map(|c| c * distance));
        let lights = [0; 2].map(|_| {
            let distance = random.pick(&[2.0, 9.0, 40.0]);
            match random.below(3) {
                // A vector of any length points to it.
                0 => Light { distant: true, ..Light::new(far(&mut random, distance), number(0.5)) },
                _ => Light::new(away + far(&mut random, distance), number(0.5)),
            }
        });
        let angle = number(random.between(20.0, 90.0));
        let eye = away + far(&mut random, 8.0);
        let camera = Camera::new(eye, away + anywhere(&mut random, 1.0), far(&mut random, 1.0), angle);
        let before = objects::<S>(&mut random, away);
        let mut now = before.clone();
        for _ in 0..=random.below(2) {
            let moved = 1 + random.below(5);
            now[moved].shape = now[moved].shape.placed(frame(&mut random, away));
        }
        if random.below(4) == 0 {
            now.pop();
        }
        let [before, now] = [&before, &now].map(|objects| {
            let scene = Scene::new(objects, &materials, &lights, camera.unwrap()).unwrap().at_tier::<T>();
            if outline { scene.with_outline(Outline::new(Color::BLACK)) } else { scene }
        });
        let size = Size::new(24, 32).with_samples(samples);
        let [before, now] = [&before, &now].map(|scene| Picture::new(scene, size));
        let (was, is) = (rows(&before), rows(&now));
        let changed: Vec<_> = now.changed_rows(&before).collect();
        let mut redrawn = was.clone();
        for y in &changed {
            redrawn[usize::from(*y)].clear();
        }
        let counters = now.render_changed(&before, |_, y, pixel| redrawn[usize::from(y)].push(pixel));
        assert!(redrawn == is, "{seed}: rows other than {changed:?} differ");
        assert!(samples > 1 || counters.primary_rays == 24 * changed.len() as u64);
        let differing = was.iter().zip(&is).filter(|(was, is)| was != is).count();
        counts = [counts[0] + was.len(), counts[1] + changed.len(), counts[2] + differing];
    }
    counts
}

#[test]
fn rows_that_are_not_drawn_again_are_the_same_to_the_bit() {
    let checked = [
        check::<f32, Stable>(1, 0.0, 1, false),
        check::<f64, Stable>(2, 0.0, 1, false),
        check::<I16F16, Stable>(3, 0.0, 1, false),
        check::<I32F32, Fast>(4, 0.0, 1, false),
        check::<I16F16, Plain>(5, 0.0, 1, false),
    ];
    for [all, drawn, differing] in checked {
        println!("{all} rows, {drawn} drawn again, {differing} differ");
        // The shadows of distant lights have no end.
        assert!(drawn < all && differing > drawn / 8);
    }
}

#[test]
fn so_they_are_far_away_with_an_outline_and_with_several_samples() {
    let checked = [
        check::<f32, Stable>(6, 1e5, 1, false),
        check::<f32, Stable>(7, 0.0, 1, true),
        check::<I16F16, Stable>(8, 0.0, 2, false),
        check::<f32, Fast>(9, 0.0, 3, true),
    ];
    for [all, drawn, _] in checked {
        assert!(drawn < all);
    }
}

/// A ball over a floor, moved by a length, in this light.
fn ball(x: f32) -> [Object<f32>; 2] {
    let place = Frame::at(Vec3::new(x, 1.0, 0.0)).unwrap();
    [Object::new(Shape::new(Plane::new()), 0), Object::new(Shape::new(Sphere::new(0.5).unwrap()).placed(place), 0)]
}

fn picture_of<'a>(scene: &'a Scene<'_, f32>) -> Picture<'a, f32> {
    Picture::new(scene, Size::new(64, 48))
}

#[test]
fn few_rows_change_if_a_ball_moves_and_all_if_anything_else_does() {
    let up = Vec3::new(0.0, 1.0, 0.0);
    let camera = Camera::new(Vec3::new(0.0_f32, 2.0, 8.0), up, up, 40.0).unwrap();
    let materials = [Material::default()];
    let lights = [Light::new(Vec3::new(2.0, 9.0, 4.0), 0.9)];
    let (first, second) = (ball(0.0), ball(0.25));
    let scene = |objects| Scene::new(objects, &materials, &lights, camera).unwrap();
    let [before, now] = [scene(&first), scene(&second)];
    let changed: Vec<_> = picture_of(&now).changed_rows(&picture_of(&before)).collect();
    // The ball covers the rows from 20 to 27, its shadow on the floor 30 and 31; that would go on below the floor.
    assert_eq!(changed, (20..39).collect::<Vec<_>>());
    let all = |now: &Scene<'_, f32>| picture_of(now).changed_rows(&picture_of(&before)).count() == 48;
    assert_eq!(picture_of(&before).changed_rows(&picture_of(&before)).count(), 0);
    assert!(all(&before.with_background(Color::WHITE)));
    let brighter = [Light::new(Vec3::new(2.0, 9.0, 4.0), 1.0)];
    assert!(all(&Scene::new(&first, &materials, &brighter, camera).unwrap()));
    let wavy = [Material { bump: Some(Waves { along_u: 1, along_v: 1, slope: 0.1 }), ..Material::default() }];
    assert!(all(&Scene::new(&first, &wavy, &lights, camera).unwrap()));
    let nearer = Camera::new(Vec3::new(0.0_f32, 2.0, 7.0), up, up, 40.0).unwrap();
    assert!(all(&Scene::new(&first, &materials, &lights, nearer).unwrap()));
    assert_eq!(picture_of(&now).changed_rows(&picture_of(&before).uncut()).count(), 48);
    let sunk = [Object::new(Shape::new(Plane::new()).placed(Frame::at(-up).unwrap()), 0), first[1]];
    assert!(all(&scene(&sunk)));
}

/// The rows that change as a ball moves before its shadow in a distant light, to which a vector of this length points.
fn changed_in_distant_light<S: Scalar>(length: f64) -> Vec<usize> {
    let up = point([0.0, 1.0, 0.0]);
    let camera = Camera::new(point([0.0, 3.0, 9.0]), up, up, number::<S>(60.0)).unwrap();
    let (materials, size) = ([Material::default()], Size::new(64, 48));
    let lights = [Light { distant: true, ..Light::new(point([0.0, 0.8 * length, -0.6 * length]), number(0.9)) }];
    let ball = |x: f64| {
        let place = Frame::at(point([x, 1.0, 0.0])).unwrap();
        let ball = Shape::new(Sphere::new(number(0.5)).unwrap()).placed(place);
        [Object::new(Shape::new(Plane::new()), 0), Object::new(ball, 0)]
    };
    let (first, second) = (ball(-2.0), ball(-1.75));
    let scene = |objects| Scene::new(objects, &materials, &lights, camera).unwrap();
    let [before, now] = [scene(&first), scene(&second)];
    let [before, now] = [&before, &now].map(|scene| Picture::new(scene, size));
    let (was, is) = (rows(&before), rows(&now));
    let changed: Vec<_> = now.changed_rows(&before).map(usize::from).collect();
    assert!((0..48).all(|y| was[y] == is[y] || changed.contains(&y)), "{length}: other rows than {changed:?}");
    changed
}

#[test]
fn a_distant_light_shades_in_its_direction_whatever_the_length_of_its_vector() {
    let long = changed_in_distant_light::<f32>(1_000.0);
    assert!(long.len() < 24 && long == changed_in_distant_light::<f32>(0.01), "{long:?}");
    assert_eq!(changed_in_distant_light::<I16F16>(100.0), long);
    // So short that it points elsewhere.
    changed_in_distant_light::<I16F16>(0.001);
}
