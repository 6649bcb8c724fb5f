//! Solids, placements and directions are those of the library's constructors.

use super::super::csv;
use super::super::decimal::Decimal;
use super::super::{placement, solid};
use fixed::types::{I16F16, I32F32};
use raylet::{
    Affine, Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Frame, Plane, Rectangle, Revolved, RoundCone,
    RoundedCuboid, Shape, Sphere, Torus, Triangle, Tube, UnitVec3, Vec3,
};
use support::exact_types::Exact;
use support::placed::Placed;

fn shape(text: &str) -> Shape<f64> {
    solid::parse(text).unwrap().try_map(Decimal::rounded::<f64>).unwrap().shape().unwrap()
}

#[test]
fn solids() {
    let v = |x, y, z| Vec3::new(x, y, z);
    let wanted: [Shape<f64>; 23] = [
        Shape::new(Sphere::new(1.0).unwrap()),
        Shape::new(Cylinder::infinite(1.0).unwrap()),
        Shape::new(Cylinder::open(1.0, 2.0).unwrap()),
        Shape::new(Cylinder::capped(1.0, 2.0).unwrap()),
        Shape::new(Cone::double(0.5).unwrap()),
        Shape::new(Cone::nappe(0.5).unwrap()),
        Shape::new(Cone::open(0.5, 2.0).unwrap()),
        Shape::new(Cone::capped(0.5, 2.0).unwrap()),
        Shape::new(Cone::frustum_open(1.0, 0.5, 2.0).unwrap()),
        Shape::new(Cone::frustum(1.0, 0.5, 2.0).unwrap()),
        Shape::new(Capsule::new(1.0, 2.0).unwrap()),
        Shape::new(Revolved::new(-0.5, 1.0, 0.0, [0.0, 2.0]).unwrap().open()),
        Shape::new(Revolved::new(-0.5, 1.0, 0.0, [0.0, 2.0]).unwrap()),
        Shape::new(RoundCone::new(1.0, 0.5, 2.0).unwrap()),
        Shape::new(Tube::new(0.75, 1.0, 2.0).unwrap()),
        Shape::new(Torus::new(1.0, 0.25).unwrap()),
        Shape::new(Plane::new()),
        Shape::new(Disc::new(1.0).unwrap()),
        Shape::new(Annulus::new(0.25, 1.0).unwrap()),
        Shape::new(Cuboid::new(1.0, 0.5, 2.0).unwrap()),
        Shape::new(RoundedCuboid::new(1.0, 0.5, 2.0, 0.25).unwrap()),
        Shape::new(Rectangle::new(1.0, 2.0).unwrap()),
        Shape::new(Triangle::new(v(-1.0, 0.0, -1.0), v(1.0, 0.0, -1.0), v(0.0, 0.0, 1.0)).unwrap()),
    ];
    for (text, wanted) in solid::EXAMPLES.into_iter().zip(wanted) {
        assert_eq!(shape(text), wanted, "{text}");
    }
    assert_eq!(shape("frustum capped height 2 top .5 base 1"), wanted[9], "sizes in any order");
    assert_eq!(shape("capsule radius 1 height 0"), Shape::new(Capsule::new(1.0, 0.0).unwrap()));
}

#[test]
fn placements() {
    let at = Vec3::new(1.0, 2.0, 3.0);
    let d = |components| UnitVec3::from_f64(components).unwrap();
    let (x, y, z) = (d([1.0, 0.0, 0.0]), d([0.0, 0.0, 1.0]), d([0.0, -1.0, 0.0]));
    let along_z = Frame::from_base_and_axis(at, UnitVec3::Z).unwrap();
    let factors = Vec3::new(2.0, 1.0, 0.5);
    let columns = [Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 0.5)];
    let sphere = shape("sphere radius 1");
    let wanted = [
        sphere.placed(Frame::at(at).unwrap()),
        sphere.placed(along_z),
        sphere.placed(Frame::looking(at, x, d([0.0, 1.0, 1.0])).unwrap()),
        sphere.placed(Frame::from_left_up_forward(at, x, y, z).unwrap()),
        sphere.placed(Affine::stretched(Frame::at(at).unwrap(), factors).unwrap()),
        sphere.placed(Affine::stretched(along_z, factors).unwrap()),
        sphere.placed(Affine::new(at, columns).unwrap()),
    ];
    let solid = solid::parse("sphere radius 1").unwrap().try_map(Decimal::rounded::<f64>).unwrap().solid();
    for (text, wanted) in placement::EXAMPLES.into_iter().zip(wanted) {
        let placement = placement::parse(text).unwrap().unwrap().rounded::<f64>().unwrap();
        assert_eq!(Placed::by(&sphere, &solid, placement).unwrap().shape, wanted, "{text}");
    }
}

/// A direction that a type has stored comes back to the bit; one with fewer digits than that is normalised.
#[test]
fn directions() {
    fn check<S: Exact>(texts: [&str; 3], is_kept: bool) {
        let text = format!("0,0,0,{}", texts.join(","));
        let ray = csv::parse("my.csv", &text).unwrap()[0].ray::<S>().unwrap();
        let components = texts.map(|text| S::parse_unit(text).unwrap());
        assert_eq!(ray.direction().to_array() == components, is_kept, "{} {text}", S::name());
        let length: f64 = ray.direction().to_f64().iter().map(|c| c * c).sum();
        assert!((length - 1.0).abs() < 4e-7, "{} {text}", S::name());
    }
    // As `f32` stores it, from the test of a known ray, and the same in more digits.
    let stored = [".37017453", "-.1486167", "-.91699713"];
    check::<f32>(stored, true);
    check::<f32>(["0.3701745271682739", "-0.1486167013645172", "-0.9169971346855164"], true);
    check::<f64>(stored, false);
    check::<I16F16>(stored, false);
    check::<I32F32>(stored, false);
    // Two thirds, two thirds and one, in all digits of 62 fraction bits.
    let fine = ["0.666666666666666666739", "-0.666666666666666666739", "0.333333333333333333369"];
    check::<I32F32>(fine, true);
    check::<I16F16>(fine, true);
    check::<f64>(fine, true);
    check::<f32>(["1", "1", "1"], false);
}
