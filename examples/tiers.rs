//! The accuracy tiers: a ray that grazes a cylinder from far away, in each of them.

use raylet::{Cylinder, Exact, Fast, Frame, Hit, Plain, Ray, Shape, Stable, UnitVec3, Vec3};

fn told(name: &str, hit: Option<Hit<f32>>) {
    match hit {
        Some(hit) => println!("{name:8} t = {}, {:?}", hit.t, hit.part),
        None => println!("{name:8} no hit"),
    }
}

pub fn main() -> Result<(), raylet::Error> {
    let lying = Frame::from_base_and_axis(Vec3::new(0.0_f32, 0.0, 0.0), UnitVec3::from_f64([1.0, 0.3, 0.2])?)?;
    let rod = Shape::new(Cylinder::capped(1.0, 8.0)?).placed(lying);
    // It starts 5,000 away and passes a hundred-thousandth of the radius inside of the surface.
    let axis = lying.up().to_f64();
    let side = UnitVec3::<f32>::from_f64([0.0, axis[2], -axis[1]])?;
    let touch = lying.position() + Vec3::from_f64(axis)? * 4.0 + Vec3::from_f64(side.to_f64())? * 0.99999;
    let [across, _] = side.perpendicular().into();
    let ray = Ray::towards(touch - Vec3::from_f64(across.to_f64())? * 5000.0, touch)?;
    told("Plain", rod.nearest_at::<Plain>(&ray));
    told("Fast", rod.nearest_at::<Fast>(&ray));
    told("Stable", rod.nearest_at::<Stable>(&ray));
    told("Exact", rod.nearest_at::<Exact>(&ray));
    let (stable, exact) = (rod.nearest_at::<Stable>(&ray), rod.nearest_at::<Exact>(&ray));
    assert_eq!(stable.map(|hit| hit.part), exact.map(|hit| hit.part));
    Ok(())
}
