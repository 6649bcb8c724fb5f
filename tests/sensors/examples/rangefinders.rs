//! A scene for MuJoCo and what `raylet` reads in it: of each number type the scene in MJCF, then a line a reading.
//! `.ci/mujoco` runs it.
//!
//! A body's frame in MuJoCo has the axis of a cylinder or a capsule along z and its middle at the origin; here the axis
//! is y, and the base is there. So its axes are z, x, y of the frame.

use fixed::types::{I16F16, I32F32};
use raylet::sensor::{RangeSensor, Reading, Status, Sweep, Zones};
use raylet::{Capsule, Cuboid, Cylinder, Frame, Plane, Ray, Scalar, Shape, Sphere, UnitVec3, Vec3};
use support::random::Random;

/// Solids, beside the ground.
const SOLIDS: usize = 24;

fn n<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("the type holds it")
}

/// A solid of this number, with its geom in MJCF.
fn solid<S: Scalar>(number: usize, random: &mut Random) -> (Shape<S>, String) {
    let position = [random.between(-3.0, 3.0), random.between(0.2, 2.0), random.between(-3.0, 3.0)];
    let [forward, up] = [random.direction(), random.direction()].map(|d| UnitVec3::from_f64(d).expect("a direction"));
    let position = Vec3::from_f64(position).expect("a point");
    let frame = Frame::looking(position, forward, up).expect("a frame");
    let [a, b, c] = [0; 3].map(|_| n::<S>(random.between(0.1, 0.5)));
    let size = |sizes: &[S]| sizes.iter().map(|size| format!("{:.17}", size.to_f64())).collect::<Vec<_>>().join(" ");
    let half = |size: S| n::<f64>(size.to_f64() / 2.0);
    // What the type stores, to the last digit.
    let (at, [x, y, z]) = (position.to_f64(), [frame.left(), frame.up(), frame.forward()].map(UnitVec3::to_f64));
    let (shape, kind, sizes, raised) = match number % 4 {
        0 => (Shape::new(Sphere::new(a).expect("a radius")), "sphere", size(&[a]), 0.0),
        1 => {
            let sizes = format!("{} {:.17}", size(&[a]), half(b));
            (Shape::new(Cylinder::capped(a, b).expect("sizes")), "cylinder", sizes, half(b))
        }
        2 => {
            let sizes = format!("{} {:.17}", size(&[a]), half(b));
            (Shape::new(Capsule::new(a, b).expect("sizes")), "capsule", sizes, half(b))
        }
        // Along z, x, y.
        _ => (Shape::new(Cuboid::new(a, b, c).expect("sizes")), "box", size(&[c, a, b]), 0.0),
    };
    let middle = [0, 1, 2].map(|i| format!("{:.17}", at[i] + raised * y[i])).join(" ");
    let axes = [z, x].concat().iter().map(|c| format!("{c:.17}")).collect::<Vec<_>>().join(" ");
    let geom = format!(r#"<geom type="{kind}" size="{sizes}" pos="{middle}" xyaxes="{axes}"/>"#);
    (shape.placed(frame), geom)
}

/// The rays of zones and sweeps from several places.
fn rays<S: Scalar>(random: &mut Random) -> Vec<Ray<S>> {
    let mut all = Vec::new();
    for _ in 0..8 {
        let eye = Vec3::from_f64([random.between(-5.0, 5.0), random.between(0.5, 3.0), random.between(-5.0, 5.0)]);
        let eye: Vec3<S> = eye.expect("a point");
        let target = Vec3::from_f64([random.between(-1.0, 1.0), 1.0, random.between(-1.0, 1.0)]).expect("a point");
        let forward = UnitVec3::new(target - eye).expect("they are apart");
        let frame = Frame::looking(eye, forward, UnitVec3::Y).expect("a frame");
        let zones = Zones::new(frame, [8, 8], [n(45.0), n(45.0)]).expect("zones");
        all.extend((0..8).flat_map(|row| (0..8).flat_map(move |column| zones.rays(column, row).collect::<Vec<_>>())));
        all.extend(Sweep::new(frame, 61, n(240.0_f64.min(S::BUDGET.coordinate.to_f64()))).expect("a sweep").all());
    }
    all
}

fn print<S: Scalar>(number: &str, unit: f64) {
    let mut random = Random(0x7261_7973);
    let (mut list, mut geoms) = (vec![Shape::new(Plane::new())], Vec::new());
    // In MuJoCo a plane's normal is z; here it is y.
    geoms.push(r#"<geom type="plane" size="0 0 1" xyaxes="0 0 1 1 0 0"/>"#.to_owned());
    for i in 0..SOLIDS {
        let (shape, geom) = solid::<S>(i, &mut random);
        list.push(shape);
        geoms.push(geom);
    }
    let sensor = RangeSensor::new(S::ZERO, n(50.0)).expect("a sensor");
    println!("number {number} {unit:e}");
    println!("{}", geoms.join(" "));
    for ray in rays::<S>(&mut random) {
        let reading: Reading<S, 1> = sensor.read(&list[..], [ray], 0);
        let seen = (reading.status == Status::Measured).then(|| &reading.returns[0]);
        let join = |of: [f64; 3]| of.map(|c| format!("{c:.17}")).join(" ");
        let incidence = seen.map_or(1.0, |seen| seen.incidence(&list[seen.obstacle as usize], &ray).to_f64());
        let (distance, obstacle) = seen.map_or((-1.0, -1), |seen| (seen.distance.to_f64(), i64::from(seen.obstacle)));
        let (origin, direction) = (join(ray.origin().to_f64()), join(ray.direction().to_f64()));
        println!("ray {origin} {direction} {distance:.17} {obstacle} {incidence:.6}");
    }
}

fn main() {
    // The type's unit at a distance of some metres.
    print::<f64>("f64", 2.0_f64.powi(-50));
    print::<f32>("f32", 2.0_f64.powi(-21));
    print::<I16F16>("I16F16", 2.0_f64.powi(-16));
    print::<I32F32>("I32F32", 2.0_f64.powi(-32));
}
