//! No shaded point is seen in a pixel outside of the place of its shadow, and the places are small.

use super::*;
use crate::random::Random;
use crate::scene::Camera;
use fixed::types::I16F16;

fn value<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("a value of the type")
}

fn vector<S: Scalar>(v: [f64; 3]) -> Vec3<S> {
    Vec3::from(v.map(value))
}

/// A point anywhere in a cube.
fn anywhere(random: &mut Random, most: f64) -> [f64; 3] {
    [0; 3].map(|_| random.between(-most, most))
}

/// A ball around a point, which is inside of it.
fn around<S: Scalar>(random: &mut Random, point: [f64; 3], size: f64) -> BallInWorld<S> {
    let radius = size * random.between(0.02, 0.6);
    let off = anywhere(random, 0.5 * radius);
    (vector(std::array::from_fn(|axis| point[axis] + off[axis])), [value(radius), S::ZERO, S::ZERO])
}

fn is_inside(place: &Place, [x, y]: [i32; 2]) -> bool {
    place.columns(y as u16).is_some_and(|[first, end]| (i32::from(first)..i32::from(end)).contains(&x))
}

/// Places of shadows that fall on points, of this size; returns the share of all pixels that they have.
fn check<S: Scalar>(seed: u64, size: f64) -> f64 {
    let (mut random, picture, mut covered, mut all) = (Random(seed), Size::new(80, 60), 0, 0);
    let pixels = || (0..i32::from(picture.height)).flat_map(|y| (0..i32::from(picture.width)).map(move |x| [x, y]));
    for _ in 0..3_000 {
        let far = size * random.between(1.0, 6.0);
        let [towards, eye] = [6.0 * size, far].map(|most| anywhere(&mut random, most));
        let camera = Camera::new(vector::<S>(eye), Vec3::ZERO, vector(anywhere(&mut random, 1.0)), value(60.0));
        let Ok(camera) = camera else { continue };
        let (raster, pixel) =
            (camera.raster(picture), [picture.width, picture.height].map(|n| random.between(0.0, f64::from(n)) as u16));
        let ray = raster.ray(pixel, [0; 2]).expect("a ray");
        let shaded = ray.at(value(far * random.between(0.1, 2.0))).to_array().map(S::to_f64);
        let share = random.between(0.05, 0.9);
        let between = std::array::from_fn(|axis| shaded[axis] + share * towards[axis]);
        let [ball, on] = [between, shaded].map(|point| around::<S>(&mut random, point, size));
        let lamp = std::array::from_fn(|axis| shaded[axis] + towards[axis]);
        let strength: S = value(1.0);
        let distant = UnitVec3::new(vector::<S>(towards)).map(|towards| Light::distant(towards, strength));
        let light = distant.ok().filter(|_| share < 0.3).unwrap_or(Light::new(vector(lamp), strength));
        // The point is before the plane, on the side of the light.
        let up = if towards[1] > 0.0 { 1.0 } else { -1.0 };
        let below = shaded[1] - up * size * random.between(0.01, 1.0);
        let plane = (vector::<S>([0.0, below, 0.0]), UnitVec3::Y);
        for (on, plane) in [(None, None), (None, Some(plane)), (Some(on), None), (Some(on), Some(plane))] {
            let place = Place::of(&raster, ball, &light, on, plane);
            let is_in_place = is_inside(&place, pixel.map(i32::from));
            assert!(is_in_place, "{place:?} {pixel:?} {ball:?} {on:?} {light:?} {eye:?}");
            if on.is_some() {
                covered += pixels().filter(|pixel| is_inside(&place, *pixel)).count();
                all += pixels().count();
            }
        }
    }
    covered as f64 / all as f64
}

#[test]
fn a_shaded_point_is_seen_in_the_place_of_its_shadow() {
    for share in [check::<f32>(1, 1.0), check::<f64>(2, 1e3), check::<I16F16>(3, 1.0), check::<f32>(4, 1e-8)] {
        assert!(share < 0.5, "{share}");
    }
}

#[test]
fn a_shadow_that_cannot_fall_there_has_no_place() {
    let camera = Camera::new(vector::<f32>([0.0, 0.0, 9.0]), Vec3::ZERO, vector([0.0, 1.0, 0.0]), 40.0);
    let raster = camera.expect("a camera").raster(Size::new(80, 60));
    let ball = |x, y| (vector::<f32>([x, y, 0.0]), [0.5, 0.0, 0.0]);
    let light = Light::new(vector([0.0, 5.0, 0.0]), 1.0);
    let place = |on, plane| Place::of(&raster, ball(0.0, 0.0), &light, on, plane);
    // What is above it, or as far away as it; and behind a plane.
    assert!(place(Some(ball(0.0, 2.0)), None).is_nowhere());
    assert!(!place(Some(ball(0.0, -2.0)), None).is_nowhere());
    assert!(place(Some(ball(0.0, -4.0)), Some((vector([0.0, -1.0, 0.0]), UnitVec3::Y))).is_nowhere());
    // On the plane it is a disc of the radius 0.6, of a pixel an eleventh.
    let [first, end] = place(None, Some((vector([0.0, -1.0, 0.0]), UnitVec3::Y))).columns(34).expect("it is seen");
    assert!(first >= 29 && end <= 51, "{first} {end}");
}
