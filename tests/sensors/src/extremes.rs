//! The smallest and the largest sensors and obstacles: bounds hide nothing, and nothing overflows.

use crate::yard::n;
use fixed::types::{I8F24, I16F16, I32F32};
use raylet::sensor::{Bounded, RangeSensor, Status, Zones};
use raylet::{Capsule, Cylinder, Frame, Scalar, Shape, Sphere, UnitVec3, Vec3};
use support::random::Random;

/// Sensors among obstacles of these sizes and distances: readings by bounds are those of the list.
fn bounds_hide_nothing<S: Scalar>(scales: &[f64]) {
    let mut random = Random(8);
    let [mut seen, mut all] = [0; 2];
    for &scale in scales {
        for tangent in [1e-2, 0.3, 1.0, 1.2, 3.0, 20.0, 60.0, 90.0] {
            for counts in [[1, 1], [255, 1], [1, 255], [16, 16]] {
                let mut list = Vec::new();
                for _ in 0..3 {
                    let [position, axis] = [random.direction(), random.direction()];
                    let place = Vec3::<S>::from_f64(position.map(|c| c * scale * random.between(0.0, 1.0)));
                    let axis = UnitVec3::<S>::from_f64(axis).expect("a direction");
                    let Ok(frame) = place.map(|place| Frame::from_base_and_axis(place, axis).expect("a frame")) else {
                        continue;
                    };
                    let [size, height] =
                        [random.between(1e-3, 0.3), random.between(0.01, 0.6)].map(|size| S::from_f64(size * scale));
                    let (Ok(size), Ok(height)) = (size, height) else { continue };
                    list.extend(Sphere::new(size).map(|solid| Shape::new(solid).placed(frame)));
                    list.extend(Cylinder::capped(size, height).map(|solid| Shape::new(solid).placed(frame)));
                    list.extend(Capsule::new(size, height).map(|solid| Shape::new(solid).placed(frame)));
                }
                let [forward, up] = [0; 2].map(|_| UnitVec3::from_f64(random.direction()).expect("a direction"));
                let eye = Vec3::from_f64(random.direction().map(|c| c * scale * 0.8)).expect("the type holds it");
                let Ok(place) = Frame::looking(eye, forward, up) else { continue };
                let Ok(zones) = Zones::with_tangents(place, counts, [n(tangent), n(tangent / 2.0)]) else { continue };
                let sensor = RangeSensor::new(S::ZERO, S::BUDGET.distance).expect("a sensor");
                let bounded = Bounded::new(&list);
                let bounds = bounded.seen_by(&zones);
                for (column, row) in (0..counts[1]).flat_map(|row| (0..counts[0]).map(move |column| (column, row))) {
                    let reading = sensor.read::<2>(&list[..], zones.rays(column, row), 0);
                    let same = sensor.read::<2>(&bounds.in_zone(column, row), zones.rays(column, row), 0);
                    assert_eq!(reading, same, "{scale:e} {tangent} {counts:?} {column} {row}");
                    seen += usize::from(reading.status == Status::Measured);
                    all += 1;
                }
            }
        }
    }
    assert!(seen > all / 200, "{seen} of {all}");
}

#[test]
fn bounds_hide_nothing_at_any_scale() {
    bounds_hide_nothing::<f32>(&[1e-42, 1e-36, 1e-15, 1e-3, 1.0, 1e3, 1e12, 1e30]);
    bounds_hide_nothing::<f64>(&[1e-100, 1.0, 1e100]);
    bounds_hide_nothing::<I16F16>(&[0.01, 1.0, 100.0, 12_000.0]);
    bounds_hide_nothing::<I8F24>(&[1e-3, 0.1, 1.0, 60.0]);
    bounds_hide_nothing::<I32F32>(&[1e-3, 1.0, 1e6]);
}
