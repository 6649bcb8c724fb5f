//! Every refusal, with its message.

use raylet::sensor::{Noise, RangeSensor, SensorError, Sweep, Zones};
use raylet::{Error, Frame, Range, Ray, Scalar, Shape, Sphere, UnitVec3, Vec3};

fn frame<S: Scalar>() -> Frame<S> {
    Frame::at(Vec3::ZERO).expect("a frame")
}

fn message<A>(result: Result<A, SensorError>) -> String {
    Error::from(result.err().expect("it is refused")).to_string()
}

#[test]
fn sensors_refuse_with_a_message() {
    let limits = |least, greatest| RangeSensor::new(least, greatest).map(|_: RangeSensor<f32>| ());
    let least = "a sensor's least distance must be zero or more";
    for bad in [-1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(message(limits(bad, 5.0)), least);
    }
    let greatest = "a sensor's greatest distance must be above its least, and within the number type's budget";
    for bad in [1.0, 0.5, f32::NAN, f32::INFINITY] {
        assert_eq!(message(limits(1.0, bad)), greatest);
    }
    assert_eq!(limits(0.0, f32::BUDGET.distance), Ok(()));
    for bad in [-1.0, f32::NAN, f32::INFINITY] {
        let separated = RangeSensor::new(0.0, 5.0_f32).and_then(|sensor| sensor.separating(bad));
        assert_eq!(message(separated), "the separation of a sensor's returns must be zero or more");
        let deviation = "a standard deviation must be zero or more";
        assert_eq!(message(Noise::new(bad, 0.0, 1)), deviation);
        assert_eq!(message(Noise::new(0.0, bad, 1)), deviation);
    }
}

#[test]
fn zones_and_sweeps_refuse_with_a_message() {
    let none = "a sensor must have at least one row and one column of zones";
    assert_eq!(message(Zones::new(frame(), [0, 8], [45.0_f32, 45.0])), none);
    assert_eq!(message(Zones::with_tangents(frame(), [8, 0], [0.5_f32, 0.5])), none);
    let angle = "the angle of a sensor's zones must lie between 0 and 180 degrees";
    for bad in [0.0, -1.0, 180.0, f32::NAN, f32::INFINITY, 1e-44] {
        assert_eq!(message(Zones::new(frame(), [8, 8], [bad, 45.0])), angle, "{bad}");
        assert_eq!(message(Zones::new(frame(), [8, 8], [45.0, bad])), angle, "{bad}");
    }
    for bad in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(message(Zones::with_tangents(frame(), [8, 8], [0.5, bad])), angle, "{bad}");
    }
    let zones = Zones::new(frame(), [8, 8], [45.0_f32, 45.0]).expect("zones");
    assert_eq!(message(zones.fan::<63>()), "the fan has no room for the rays of all zones: give it a larger capacity");
    assert_eq!(message(Sweep::new(frame(), 1, 90.0_f32)), "a sweep must have at least two beams");
    for bad in [0.0, -1.0, 360.1, f32::NAN, f32::INFINITY] {
        let sweep = "the angle of a sweep must be above 0, and at most 360 degrees";
        assert_eq!(message(Sweep::new(frame(), 2, bad)), sweep, "{bad}");
    }
}

#[test]
fn an_undecided_ray_says_what_to_call() {
    let ball = Shape::new(Sphere::new(1.0_f32).expect("a radius"));
    let ray = Ray::new(Vec3::new(0.0, 0.0, 5.0), -UnitVec3::Z).expect("a ray");
    let hit = ball.nearest(&ray).expect("it is met");
    let on = ball.surface(&ray, &hit);
    let departing = ray.with_range(Range::FORWARD).departing(on.departure(0, raylet::Leaving::Outwards));
    let error = ball.try_nearest(&departing).expect_err("it departs");
    let message = "the first numbers of this tier do not decide the ray: call the query that tries them all";
    assert_eq!(Error::from(error).to_string(), message);
}
