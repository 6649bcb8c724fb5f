//! Random obstacles and sensors, in numbers that all types hold.

use raylet::sensor::Zones;
use raylet::{Frame, Plane, Primitive, Scalar, Shape, UnitVec3, Vec3};
use shared::borrowed::Borrowed;
use shared::workload::{PLACEMENTS, Rays, SOLIDS_BY_NAME, query};
use support::random::Random;

/// A number type of the tests.
pub trait Number: Borrowed {}
impl<S: Borrowed> Number for S {}

pub fn n<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("the type holds it")
}

pub fn point<S: Scalar>(random: &mut Random, size: f64) -> Vec3<S> {
    Vec3::from_f64([0; 3].map(|_| random.between(-size, size))).expect("the type holds it")
}

/// A frame within so much of the origin, turned anyhow.
pub fn frame<S: Scalar>(random: &mut Random, size: f64) -> Frame<S> {
    let position = point(random, size);
    let [forward, up] = [random.direction(), random.direction()].map(|d| UnitVec3::from_f64(d).expect("a direction"));
    Frame::looking(position, forward, up).expect("a frame")
}

/// So many solids of every kind, placed in every way, within some sizes of the origin; sometimes a plane among them.
pub fn obstacles<S: Number>(random: &mut Random, count: usize) -> Vec<Shape<S>> {
    let mut list = Vec::new();
    while list.len() < count {
        if random.below(12) == 0 {
            list.push(Shape::new(Plane::new()).placed(frame::<S>(random, 6.0)));
            continue;
        }
        let (solid, placed) = (random.pick(&SOLIDS_BY_NAME), random.pick(&PLACEMENTS));
        let Some(test) = query::<S>(solid, placed, Rays::Near, random.below(100)) else { continue };
        // That of the workload, but most frames are anew, and all infinite solids would hide the others.
        let is_infinite = matches!(test.shape.primitive(), Primitive::Plane(_)) || solid.starts_with("cone, ");
        if !is_infinite {
            list.push(if test.shape.frame().is_some() {
                test.shape.placed(frame::<S>(random, 9.0))
            } else {
                test.shape
            });
        }
    }
    list
}

/// Zones of a sensor outside or among the obstacles, of any field of view.
pub fn zones<S: Scalar>(random: &mut Random) -> Zones<S> {
    let (columns, rows) = (1 + random.below(9), 1 + random.below(9));
    // Towards a place among the obstacles.
    let (eye, target) = (point::<S>(random, 14.0), point(random, 4.0));
    let forward = UnitVec3::new(target - eye).expect("they are apart");
    let up = UnitVec3::from_f64(random.direction()).expect("a direction");
    let place = Frame::looking(eye, forward, up).expect("a frame");
    let tangents = [0; 2].map(|_| n(random.pick(&[0.0625, 0.25, 0.5, 1.0, 2.0, 6.0]) * random.between(0.75, 1.25)));
    let zones = Zones::with_tangents(place, [columns as u8, rows as u8], tangents).expect("zones");
    zones.with_rays(1 + random.below(3) as u8)
}
