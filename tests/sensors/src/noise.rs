//! The errors of distances: their mean and spread, what is lost, and that they repeat.

use crate::yard::n;
use fixed::types::{I16F16, I32F32};
use raylet::sensor::{Noise, RangeSensor, Status};
use raylet::{Plane, Ray, Scalar, Shape, UnitVec3, Vec3};

const COUNT: u32 = 20_000;

/// Mean and standard deviation of the errors of a distance, and the share of those within one deviation.
fn spread<S: Scalar>(deviation: f64, relative: f64, distance: f64) -> [f64; 3] {
    let noise = Noise::new(n::<S>(deviation), n(relative), 5).expect("deviations");
    let errors: Vec<_> = (0..COUNT).map(|number| noise.of(n::<S>(distance), number, 0).to_f64() - distance).collect();
    let mean = errors.iter().sum::<f64>() / f64::from(COUNT);
    let square = errors.iter().map(|error| (error - mean).powi(2)).sum::<f64>() / f64::from(COUNT);
    let within = errors.iter().filter(|error| error.abs() < square.sqrt()).count();
    [mean, square.sqrt(), within as f64 / f64::from(COUNT)]
}

fn is_normal<S: Scalar>() {
    for (deviation, relative, distance) in [(0.125, 0.0, 4.0), (0.0, 0.0625, 2.0), (0.125, 0.0625, 8.0)] {
        let wanted = deviation + relative * distance;
        let [mean, spread, within] = spread::<S>(deviation, relative, distance);
        assert!(mean.abs() < 0.025 * wanted && (spread / wanted - 1.0).abs() < 0.02, "{mean} {spread} of {wanted}");
        // Of a normal distribution 68.3 % are within one deviation; of twelve uniform numbers 67.9 %.
        assert!((within - 0.681).abs() < 0.01, "{within}");
    }
}

#[test]
fn errors_are_nearly_normal() {
    is_normal::<f32>();
    is_normal::<f64>();
    is_normal::<I16F16>();
    is_normal::<I32F32>();
}

#[test]
fn measurements_are_lost_as_often_as_they_shall_be() {
    for lost in [0, 1, 1_000, 32_768, 65_535] {
        let noise = Noise::new(0.0_f32, 0.0, 9).expect("deviations").losing(lost);
        let count = (0..COUNT * 5).filter(|number| noise.loses(*number)).count() as f64;
        let wanted = f64::from(COUNT) * 5.0 * f64::from(lost) / 65_536.0;
        assert!((count - wanted).abs() <= 4.0 * wanted.sqrt() + 1.0, "{count} of {wanted}");
    }
}

#[test]
fn errors_repeat_and_depend_on_seed_number_and_return() {
    let of = |seed, number, index| Noise::new(0.5_f32, 0.0, seed).expect("a deviation").of(9.0, number, index);
    assert_eq!(of(1, 2, 0), of(1, 2, 0));
    let others = [of(2, 2, 0), of(1, 3, 0), of(1, 2, 1), of(1, 2, 2)];
    assert!(others.iter().all(|other| *other != of(1, 2, 0)), "{others:?}");
    // The errors of neighbours have nothing in common.
    let errors: Vec<_> = (0..COUNT).map(|number| f64::from(of(7, number, 0)) - 9.0).collect();
    for apart in [1, 2, 8, 64] {
        let product = errors.windows(apart + 1).map(|of| of[0] * of[apart]).sum::<f64>() / f64::from(COUNT);
        assert!(product.abs() < 0.25 * 0.03, "{apart}: {product}");
    }
    // No distance is below zero.
    assert!((0..COUNT).all(
        |number| of(3, number, 0) >= 0.0 && Noise::new(9.0, 0.0, 3).is_ok_and(|far| far.of(0.5, number, 0) >= 0.0)
    ));
}

#[test]
fn a_reading_has_the_errors_and_the_true_hit() {
    let wall = [Shape::new(Plane::new())];
    let down = Ray::new(Vec3::new(0.0_f32, 3.0, 0.0), -UnitVec3::Y).expect("a ray");
    let noise = Noise::new(0.01, 0.0, 4).expect("a deviation").losing(6_554);
    let sensor = RangeSensor::new(0.0, 9.0).expect("a sensor").with_noise(noise);
    let mut lost = 0;
    for number in 0..1_000 {
        let reading = sensor.read::<1>(&wall[..], [down], number);
        if reading.status == Status::DroppedOut {
            assert!(reading.returns.is_empty() && noise.loses(number));
            lost += 1;
        } else {
            assert_eq!((reading.returns[0].distance, reading.returns[0].hit.t), (noise.of(3.0, number, 0), 3.0));
        }
    }
    assert!((60..150).contains(&lost), "{lost}");
}
