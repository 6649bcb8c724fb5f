//! The rays of zones and sweeps beside doubles.

use crate::yard::{frame, n};
use fixed::types::{I8F24, I16F16, I32F32};
use raylet::sensor::{Sweep, Zones};
use raylet::{Frame, Ray, Scalar, UnitVec3, Vec3};
use support::random::Random;

/// The largest difference of a ray's direction from one along forward, left and up, in doubles.
fn off<S: Scalar>(ray: &Ray<S>, frame: &Frame<S>, along: [f64; 3]) -> f64 {
    let axes = [frame.left(), frame.up(), frame.forward()].map(UnitVec3::to_f64);
    let v: [f64; 3] = [0, 1, 2].map(|c| (0..3).map(|axis| axes[axis][c] * along[axis]).sum());
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let d = ray.direction().to_f64();
    (0..3).map(|c| (d[c] - v[c] / length).abs()).fold(0.0, f64::max)
}

fn zones<S: Scalar>(most: f64) {
    let mut random = Random(3);
    for angles in [[45.0, 45.0], [63.0, 20.0], [1.0, 120.0], [170.0, 5.0]] {
        // Of eight bits before the point.
        let angles = if S::from_f64(170.0).is_ok() { angles } else { angles.map(|angle: f64| angle.min(120.0)) };
        let frame = frame::<S>(&mut random, 50.0);
        for (counts, side) in [([8, 8], 1), ([4, 9], 3), ([1, 1], 1), ([1, 255], 1), ([2, 1], 16)] {
            let zones = Zones::new(frame, counts, angles.map(n)).expect("zones").with_rays(side);
            let half = angles.map(|angle: f64| (angle / 2.0).to_radians().tan());
            for (column, row) in (0..counts[1]).flat_map(|row| (0..counts[0]).map(move |column| (column, row))) {
                let rays: Vec<_> = zones.rays(column, row).collect();
                assert_eq!(rays.len(), usize::from(side) * usize::from(side));
                for (k, ray) in rays.iter().enumerate() {
                    let at = |zone: u8, sample: usize, count: u8| {
                        let place = f64::from(zone) + (sample as f64 + 0.5) / f64::from(side);
                        2.0 * place / f64::from(count) - 1.0
                    };
                    let (i, j) = (k % usize::from(side), k / usize::from(side));
                    let (right, down) = (half[0] * at(column, i, counts[0]), half[1] * at(row, j, counts[1]));
                    let off = off(ray, &frame, [-right, -down, 1.0]);
                    assert!(off < most, "{angles:?} {counts:?} {column} {row} {k}: {off:e}");
                    assert_eq!(ray.origin(), frame.position());
                }
            }
        }
    }
}

#[test]
fn zones_are_equal_rectangles_before_the_sensor() {
    // An angle near 180 degrees has a tangent that loses digits.
    zones::<f32>(4e-6);
    zones::<f64>(1e-14);
    zones::<I16F16>(3e-5);
    zones::<I8F24>(3e-7);
    zones::<I32F32>(1e-9);
}

fn sweeps<S: Scalar>(most: f64) {
    let mut random = Random(4);
    for (beams, angle) in [(2, 30.0), (181, 180.0), (360, 360.0), (1000, 90.0), (65_535, 270.0)] {
        let frame = frame::<S>(&mut random, 50.0);
        let sweep = Sweep::new(frame, beams, n(angle)).expect("a sweep");
        assert_eq!(sweep.all().count(), usize::from(beams));
        assert_eq!(sweep.beam(beams), None);
        let step = angle / f64::from(if angle < 360.0 { beams - 1 } else { beams });
        for number in (0..beams).step_by(usize::from(beams / 50).max(1)) {
            let turn = (angle / 2.0 - step * f64::from(number)).to_radians();
            let ray = sweep.beam(number).expect("a beam");
            let off = off(&ray, &frame, [turn.sin(), 0.0, turn.cos()]);
            assert!(off < most, "{beams} over {angle}, {number}: {off:e}");
        }
    }
}

#[test]
fn beams_of_a_sweep_are_at_equal_angles() {
    sweeps::<f32>(2e-6);
    sweeps::<f64>(1e-14);
    sweeps::<I16F16>(1e-8);
    sweeps::<I32F32>(1e-15);
}

#[test]
fn a_sensor_that_moves_keeps_its_directions() {
    let at = |x| Frame::at(Vec3::new(x, 0.0_f32, 0.0)).expect("a frame");
    let zones = Zones::new(at(0.0), [8, 8], [45.0, 45.0]).expect("zones");
    let moved = zones.moved_to(at(3.0));
    let fan = zones.fan::<64>().expect("room").moved_to(Vec3::new(3.0, 0.0, 0.0));
    for (column, row) in [(0, 0), (7, 7), (3, 5)] {
        assert!(fan.rays(column, row).eq(moved.rays(column, row)));
        let [before, after] = [zones, moved].map(|zones| zones.rays(column, row).next().expect("a ray"));
        assert_eq!(before.direction(), after.direction());
        assert_eq!(after.origin(), Vec3::new(3.0, 0.0, 0.0));
    }
    assert_eq!((fan.rays(8, 0).count(), fan.rays(0, 8).count()), (0, 0));
    // Along the line of sight.
    let ray = zones.rays(0, 0).next().expect("a ray");
    assert!((zones.depth(&ray, 2.0) - 2.0 * ray.direction().z()).abs() < 1e-6);
}
