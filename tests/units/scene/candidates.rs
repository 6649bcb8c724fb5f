//! No ray that meets an object is outside of its columns, or passes its ball; and few others are not.

use super::*;
use crate::frame::Frame;
use crate::hit::Hit;
use crate::primitive::{Capsule, Cone, Cuboid, Cylinder, Plane, RoundCone, RoundedCuboid, Sphere, Torus, Triangle};
use crate::random::Random;
use crate::ray::Ray;
use crate::scene::{Camera, Object, Scene, Size};
use crate::shape::{Primitive, Shape};
use crate::vector::{UnitVec3, Vec3};

fn value<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("a value of the type")
}

fn vector<S: Scalar>(random: &mut Random, most: f64) -> Vec3<S> {
    Vec3::from([0; 3].map(|_| value(random.between(-most, most))))
}

/// Solids of about this size, of all hulls.
fn solids<S: Scalar>(size: f64) -> [Primitive<S>; 13] {
    let [a, b, c] = [1.0, 0.6, 0.3].map(|share| value::<S>(share * size));
    let corner = |x, y, z| Vec3::new(x, y, z);
    let zero = S::ZERO;
    [
        Sphere::new(a).expect("a size").into(),
        Cylinder::capped(b, a).expect("sizes").into(),
        Cylinder::infinite(b).expect("sizes").into(),
        Cone::capped(value(0.6), a).expect("sizes").into(),
        Cone::frustum(a, c, b).expect("sizes").into(),
        Capsule::new(c, a).expect("sizes").into(),
        RoundCone::new(a, c, a).expect("sizes").into(),
        RoundCone::new(a, c, b).expect("sizes").into(),
        Cuboid::new(a, b, c).expect("sizes").into(),
        RoundedCuboid::new(a, b, c, c).expect("sizes").into(),
        Torus::new(a, c).expect("sizes").into(),
        Triangle::new(corner(zero, a, zero), corner(b, zero, zero), corner(zero, c, a)).expect("corners").into(),
        Plane::new().into(),
    ]
}

/// A solid with its base there, turned anyhow, and the balls of a scene of it.
fn placed<S: Scalar>(random: &mut Random, solid: Primitive<S>, base: Vec3<S>, camera: Camera<S>) -> (Shape<S>, Balls) {
    let axis = UnitVec3::new(vector(random, 1.0)).expect("it is not zero");
    let shape = Shape::new(solid).placed(Frame::from_base_and_axis(base, axis).expect("a frame"));
    (shape, balls_of(shape, camera))
}

fn balls_of<S: Scalar>(shape: Shape<S>, camera: Camera<S>) -> Balls {
    let (objects, materials) = ([Object::new(shape, 0)], [crate::scene::Material::default()]);
    Balls::of(&Scene::new(&objects, &materials, &[], camera).expect("a scene"))
}

/// Every ray of a picture of one shape; counts the rays, those that may meet it, and those that do.
fn check_picture<S: Scalar>(shape: &Shape<S>, balls: &Balls, raster: &Raster<S>, counts: &mut [u32; 3]) {
    let Size { width, height, .. } = raster.size();
    for y in 0..height {
        let mut row = CandidatesOfRow::new(balls, raster, y);
        for x in 0..width {
            let ray = raster.ray([x, y], [0, 0]).expect("a ray of a pinhole camera");
            let hit: Option<Hit<S>> = shape.nearest(&ray);
            let is_candidate = row.as_mut().is_none_or(|row| row.of(x).contain(0));
            assert!(is_candidate || hit.is_none(), "{shape:?} at {x}, {y} of {width} x {height}: {ray:?}");
            counts[0] += 1;
            counts[1] += u32::from(is_candidate);
            counts[2] += u32::from(hit.is_some());
        }
    }
}

/// Every ray of pictures of one solid in a scene of this scale, this far from the origin; returns the rays, those that
/// may meet it, and those that do.
fn check<S: Scalar>(seed: u64, scale: f64, away: f64) -> [u32; 3] {
    let (mut random, mut counts) = (Random(seed), [0; 3]);
    let away = Vec3::from([away, -0.7 * away, 0.9 * away].map(value::<S>));
    for _ in 0..40 {
        let (eye, up) = (away + vector::<S>(&mut random, 9.0 * scale), vector(&mut random, 1.0));
        let angle = random.between(0.5, 120.0) * random.unit().max(0.05);
        let camera = Camera::new(eye, away + vector(&mut random, 2.0 * scale), up, value(angle)).expect("a camera");
        let [width, height] = [1 + (random.next() % 70) as u16, 1 + (random.next() % 50) as u16];
        let raster = camera.raster(Size::new(width, height));
        let size = scale * random.between(0.02, 3.0);
        for solid in solids::<S>(size) {
            let place = away + vector(&mut random, 5.0 * scale);
            let (shape, balls) = placed(&mut random, solid, place, camera);
            check_picture(&shape, &balls, &raster, &mut counts);
        }
    }
    counts
}

/// Rays from anywhere about one solid of a scene, as shadow rays and mirrored rays are; returns the rays, those that
/// may meet it, and those that do.
fn check_from_anywhere<S: Scalar>(seed: u64, scale: f64, away: f64) -> [u32; 3] {
    let (mut random, mut counts) = (Random(seed), [0; 3]);
    let away = Vec3::from([away, -0.7 * away, 0.9 * away].map(value::<S>));
    for _ in 0..60 {
        let eye = away + vector::<S>(&mut random, 9.0 * scale);
        let camera = Camera::new(eye, away, vector(&mut random, 1.0), value(60.0)).expect("a camera");
        let size = scale * random.between(0.02, 3.0);
        for solid in solids::<S>(size) {
            let place = away + vector(&mut random, 5.0 * scale);
            let (shape, balls) = placed(&mut random, solid, place, camera);
            for number in 0..60 {
                // From the eye, near the solid or inside, as far away as a scene is wide, and beyond.
                let from = match number % 4 {
                    0 => eye,
                    1 => place + vector(&mut random, size),
                    2 => away + vector(&mut random, 9.0 * scale),
                    // So far that the ball is next to the rounding of its distance.
                    _ if S::RELATIVE && number % 8 == 3 => away + vector(&mut random, 3e4 * scale),
                    _ => away + vector(&mut random, 60.0 * scale),
                };
                let aim = place + vector(&mut random, random_reach(number) * size);
                let Ok(mut ray) = Ray::towards(from, aim) else { continue };
                for _ in 0..2 {
                    let hit: Option<Hit<S>> = shape.nearest(&ray);
                    let both = [balls.met_in_integers(&ray, eye), balls.met_in_numbers(&ray, eye)];
                    let is_candidate = both.iter().any(|candidates| candidates.contain(0));
                    let is_in_both = both.iter().all(|candidates| candidates.contain(0));
                    assert!(is_in_both || hit.is_none(), "{shape:?}: {ray:?} from {eye:?}");
                    counts[0] += 1;
                    counts[1] += u32::from(is_candidate);
                    counts[2] += u32::from(hit.is_some());
                    // And on from its surface.
                    let Some(hit) = hit else { break };
                    ray = Ray::towards(ray.at(hit.t), away + vector(&mut random, 9.0 * scale)).unwrap_or(ray);
                }
            }
        }
    }
    counts
}

/// Half of the rays graze.
const fn random_reach(number: u32) -> f64 {
    if number % 8 < 4 { 1.0 } else { 4.0 }
}

#[test]
fn a_ray_from_anywhere_that_meets_an_object_has_it_among_its_candidates() {
    let near = [(1, 1.0), (2, 1e-9), (3, 1e9)].map(|(seed, scale)| check_from_anywhere::<f32>(seed, scale, 0.0));
    let far = [1e3, 1e5].map(|away| check_from_anywhere::<f32>(4, 1.0, away));
    for [rays, candidates, hits] in near.into_iter().chain(far).chain([check_from_anywhere::<f64>(5, 1.0, 0.0)]) {
        assert!(hits > rays / 20 && candidates < rays * 4 / 5, "{hits} {candidates} of {rays}");
    }
    // Where a float has few digits left, or none of its unit.
    for scale in [1e-39, 1e-41, 1e-43] {
        let [rays, candidates, hits] = check_from_anywhere::<f32>(6, scale, 0.0);
        assert!(hits > rays / 40 && candidates >= hits, "{hits} {candidates} of {rays}");
    }
    // Where a unit is as long as a quarter of the largest solid, most balls are in the way.
    let [rays, candidates, hits] = check_from_anywhere::<f32>(4, 1.0, 2e6);
    assert!(hits > rays / 20 && candidates < rays, "{hits} {candidates} of {rays}");
}

#[cfg(feature = "fixed")]
#[test]
fn a_ray_from_anywhere_that_meets_an_object_has_it_among_its_candidates_in_fixed_point() {
    use fixed::types::{I8F24, I16F16, I20F12, I32F32};
    let near = [check_from_anywhere::<I16F16>(6, 1.0, 0.0), check_from_anywhere::<I32F32>(7, 1.0, 0.0)];
    let coarse = [check_from_anywhere::<I20F12>(8, 0.25, 0.0), check_from_anywhere::<I16F16>(9, 0.02, 0.0)];
    let ends = [check_from_anywhere::<I8F24>(10, 0.8, 0.0), check_from_anywhere::<I16F16>(11, 1.0, 15_900.0)];
    for [rays, candidates, hits] in near.into_iter().chain(coarse).chain(ends) {
        assert!(hits > rays / 20 && candidates < rays * 4 / 5, "{hits} {candidates} of {rays}");
    }
}

/// In few columns the rays that meet a ball may follow those that would meet it backwards.
#[test]
fn a_ball_next_to_the_eye_is_among_the_candidates_of_few_columns() {
    let (mut random, mut counts) = (Random(12), [0; 3]);
    for _ in 0..6_000 {
        let number = |random: &mut Random| random.between(-1.0, 1.0) as f32;
        let angle = random.between(0.0, core::f64::consts::TAU) as f32;
        let height = 1.0 + (0.1_f32).powf(random.between(0.5, 4.5) as f32);
        let (sin, cos) = (angle.sin(), angle.cos());
        let eye = Vec3::new(height * cos, height * sin, 0.1 * number(&mut random));
        // Along the surface, with the ball on either side.
        let side = if random.unit() < 0.5 { 1.0 } else { -1.0 };
        let along = Vec3::new(-side * sin, side * cos, 0.3 * number(&mut random));
        let forward = along + eye * (0.2 * number(&mut random));
        let up = Vec3::new(0.3 * number(&mut random), 0.3 * number(&mut random), 1.0);
        let Ok(camera) = Camera::new(eye, eye + forward, up, random.between(30.0, 110.0) as f32) else { continue };
        let [width, height] = [2 + (random.next() % 12) as u16, 1 + (random.next() % 3) as u16];
        let raster = camera.raster(Size::new(width, height));
        let shape = Shape::new(Sphere::new(1.0_f32).expect("a size"));
        let balls = balls_of(shape, camera);
        check_picture(&shape, &balls, &raster, &mut counts);
    }
    assert!(counts[2] > 10_000, "{counts:?}");
}

/// Whether a ball of this radius at the origin is a candidate of a ray along x from here, as seen from this far: in
/// integers and in numbers.
fn may_meet(radius: f32, from: [f32; 3], eye: f32) -> [bool; 2] {
    let eye = Vec3::new(0.0, 0.0, eye);
    let camera = Camera::new(eye, Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 60.0).expect("a camera");
    let balls = balls_of(Shape::<f32>::new(Sphere::new(radius).expect("a radius")), camera);
    let ray = Ray::new(Vec3::from(from), UnitVec3::X).expect("a ray");
    [balls.met_in_integers(&ray, eye), balls.met_in_numbers(&ray, eye)].map(|met| met.contain(0))
}

#[test]
fn a_ray_that_passes_a_ball_by_little_is_not_a_candidate() {
    for (eye, far) in [(5.0, -3.0), (20.0, -20.0), (1.0, -0.5)] {
        assert_eq!(may_meet(1.0, [far, 0.7, 0.7], eye), [true; 2]);
        assert_eq!(may_meet(1.0, [far, 0.74, 0.75], eye), [false; 2]);
        assert_eq!(may_meet(1.0, [far, 0.0, 1.05], eye), [false; 2]);
        assert_eq!(may_meet(1.0, [0.99, 0.0, 0.0], eye), [true; 2]);
        // It is behind.
        assert_eq!(may_meet(1.0, [1.05, 0.0, 0.0], eye), [false; 2]);
    }
}

#[test]
fn a_line_is_tested_against_what_is_behind_its_point() {
    use crate::ray::Range;
    let eye = Vec3::new(0.0_f32, 0.0, 5.0);
    let camera = Camera::new(eye, Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 60.0).expect("a camera");
    let balls = balls_of(Shape::new(Sphere::new(1.0).expect("a radius")), camera);
    let ray = Ray::new(Vec3::new(3.0, 0.0, 0.0), UnitVec3::X).expect("a ray");
    assert!(!balls.met_by(&ray, eye).contain(0));
    assert!(balls.met_by(&ray.with_range(Range::line()), eye).contain(0));
}

#[test]
fn the_largest_balls_and_the_farthest_rays_overflow_nowhere() {
    let extremes = [1e-38, 1e-20, 1e-3, 1.0, 1e9, 1e30, 5e37];
    for radius in extremes {
        for eye in extremes {
            for length in extremes {
                for signs in 0..8 {
                    let sign = |bit: u32| if signs >> bit & 1 == 0 { length } else { -length };
                    may_meet(radius, [sign(0), sign(1), sign(2)], eye);
                }
                assert_eq!(may_meet(radius, [-length, 0.0, 0.0], eye), [true; 2]);
            }
        }
    }
}

#[test]
fn a_ray_that_meets_an_object_has_it_among_its_candidates() {
    let near = [check::<f32>(1, 1.0, 0.0), check::<f64>(2, 1.0, 0.0), check::<f32>(3, 1e-9, 0.0)];
    let far = [1e3, 1e5, 2e6].map(|away| check::<f32>(4, 1.0, away));
    for [rays, candidates, hits] in near.into_iter().chain(far) {
        assert!(hits > rays / 20 && candidates < rays / 2, "{hits} {candidates} of {rays}");
    }
}

#[cfg(feature = "fixed")]
#[test]
fn a_ray_that_meets_an_object_has_it_among_its_candidates_in_fixed_point() {
    use fixed::types::{I8F24, I16F16, I20F12, I32F32};
    let near = [check::<I16F16>(5, 1.0, 0.0), check::<I32F32>(6, 1.0, 0.0), check::<I8F24>(7, 1.0, 0.0)];
    // Of units in which the smallest solids are a few long; and at the end of the budget.
    let coarse = [check::<I20F12>(8, 0.25, 0.0), check::<I16F16>(9, 0.02, 0.0), check::<I16F16>(10, 1.0, 16_000.0)];
    for [rays, candidates, hits] in near.into_iter().chain(coarse) {
        assert!(hits > rays / 20 && candidates < rays / 2, "{hits} {candidates} of {rays}");
    }
}

/// Those of a ball at this distance before the eye, or behind it.
fn columns_of_ball(distance: f32, radius: f32, size: Size, y: u16) -> [u16; 2] {
    columns_from(Vec3::new(0.0, 0.0, distance), distance, radius, size, y)
}

/// Those of a ball at the origin, as seen from there if the distance is positive; otherwise from there on.
fn columns_from(eye: Vec3<f32>, distance: f32, radius: f32, size: Size, y: u16) -> [u16; 2] {
    let up = Vec3::new(0.0, 1.0, 0.0);
    let target = if distance > 0.0 { Vec3::ZERO } else { eye + eye };
    let camera = Camera::new(eye, target, up, 60.0).expect("a camera");
    let raster = camera.raster(size);
    let ball = View::of(&raster).ball(&Shape::<f32>::new(Sphere::new(radius).expect("a radius")));
    // Pixels of a picture of one row are as wide as the view.
    let all = [0, size.width];
    Directions::of_row(&raster, u32::from(y)).zip(ball).map_or(all, |(row, ball)| row.columns(&ball, all))
}

#[test]
fn a_ball_has_hardly_more_columns_than_it_covers() {
    // Its outline is at a radius of 100 tan(asin(0.1)) / tan(30) = 17.4 pixels about the middle.
    let size = Size::new(256, 200);
    assert_eq!(columns_of_ball(10.0, 1.0, size, 100), [110, 146]);
    assert_eq!(columns_of_ball(10.0, 1.0, size, 116), [122, 134]);
    assert_eq!(columns_of_ball(10.0, 1.0, size, 118), [0, 0]);
    // From the inside, and behind the eye.
    assert_eq!(columns_of_ball(0.5, 1.0, size, 118), [0, 256]);
    assert_eq!(columns_of_ball(-10.0, 1.0, size, 100), [0, 0]);
}

#[test]
fn the_largest_pictures_and_the_smallest_overflow_nowhere() {
    for [width, height] in [[1, 1], [1, 8191], [8191, 1], [16383, 3]] {
        for y in [0, height / 2, height - 1] {
            for (distance, radius) in [(10.0, 1.0), (1e-3, 9.99e-4), (1e9, 9.9e8), (3.0, 1e-20)] {
                // Along an axis, and along a diagonal, on which the coordinates of a camera are longer.
                for axis in [[0.0, 0.0, 1.0], [1.0; 3], [-1.0, 1.0, -1.0], [1.0, 0.1, 0.0]] {
                    let eye = Vec3::from(axis.map(|c| c * distance));
                    let [first, end] = columns_from(eye, distance, radius, Size::new(width, height), y);
                    assert!(first <= end && end <= width);
                }
            }
        }
    }
}
