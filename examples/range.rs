//! A range sensor: 8 by 8 zones, in 32-bit fixed point, of a yard with posts.

use fixed::types::I16F16;
use raylet::hierarchy::ShapeTree;
use raylet::{Cylinder, Frame, Plane, Ray, Shape, Vec3};

/// The program has code for these kinds alone.
type Obstacle = Shape<I16F16, (Cylinder<I16F16>, Plane<I16F16>, Frame<I16F16>)>;

fn metres(value: f64) -> I16F16 {
    I16F16::from_num(value)
}

fn point(x: f64, y: f64, z: f64) -> Vec3<I16F16> {
    Vec3::new(metres(x), metres(y), metres(z))
}

pub fn main() -> Result<(), raylet::Error> {
    // The ground and six posts; the sensor is half a metre above the ground and looks along -z.
    let mut yard = heapless::Vec::<Obstacle, 7>::new();
    let _ = yard.push(Obstacle::of(Plane::new()));
    for (x, z) in [(-0.6, -2.0), (0.1, -2.5), (0.9, -3.0), (-1.5, -3.5), (0.3, -4.0), (1.8, -4.5)] {
        let post = Cylinder::capped(metres(0.125), metres(1.0))?;
        let _ = yard.push(Obstacle::of(post).placed(Frame::at(point(x, 0.0, z))?));
    }
    let yard = ShapeTree::new(yard)?;

    let sensor = point(0.0, 0.5, 0.0);
    for row in 0..8_u8 {
        for column in 0..8_u8 {
            let [across, up] = [column, row].map(|zone| (f64::from(zone) - 3.5) / 8.0);
            let ray = Ray::towards(sensor, point(across, 0.5 - up, -1.0))?;
            match yard.nearest(&ray).filter(|(_, hit)| hit.t < metres(6.0)) {
                Some((_, hit)) => print!("{:6.2}", hit.t),
                None => print!("     -"),
            }
        }
        println!();
    }
    let ahead = Ray::towards(sensor, point(0.1, 0.5, -2.5))?;
    assert_eq!(yard.nearest(&ahead).map(|(post, hit)| (post, hit.t > metres(2.37))), Some((2, true)));
    Ok(())
}
