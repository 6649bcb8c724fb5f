//! The value types go to other crates and come back the same: `mint`, `serde`, `defmt`.

use fixed::types::I16F16;
use raylet::{
    Bounds, Crossing, Departure, Hit, Hits, Leaving, Part, Range, Ray, RayError, Sphere, UnitVec3, ValueError, Vec3,
    Visible,
};
use serde::{Serialize, de::DeserializeOwned};

/// Through JSON and back.
fn round_trip<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug>(value: &T) {
    let text = serde_json::to_string(value).expect("every value can be written");
    let back: T = serde_json::from_str(&text).expect("what was written can be read");
    assert_eq!(&back, value, "{text}");
}

#[test]
fn serde_brings_every_value_type_back() {
    round_trip(&Vec3::new(1.0_f32, -0.0, 1e-30));
    round_trip(&Vec3::new(I16F16::from_bits(1), I16F16::MAX, I16F16::MIN));
    round_trip(&UnitVec3::new(Vec3::new(1.0_f64, 2.0, 3.0)).expect("it has a length"));
    round_trip(&UnitVec3::<I16F16>::new(Vec3::new(I16F16::ONE, I16F16::ONE, I16F16::ZERO)).expect("it has a length"));
    let range = Range::new(-1.5_f32, 2.0).expect("in order");
    round_trip(&range);
    let departure = Departure { object: 7, part: Part::Top, leaving: Leaving::Inwards };
    round_trip(&departure);
    let ray = Ray::new(Vec3::new(0.0_f32, 1.0, 2.0), UnitVec3::Z).expect("inside the budget");
    round_trip(&ray);
    round_trip(&ray.with_range(range).departing(departure));
    round_trip(&Hit { t: 1.25_f32, part: Part::Side, crossing: Crossing::Touch });
    round_trip(&Bounds { low: Vec3::new(0.0_f32, 0.0, 0.0), high: Vec3::new(1.0, 1.0, 1.0) });
    for visible in [Visible::Both, Visible::Outside, Visible::Inside] {
        round_trip(&visible);
    }
}

#[test]
fn serde_writes_a_hit_list() {
    let ray = Ray::new(Vec3::new(0.0_f32, 0.0, -3.0), UnitVec3::Z).expect("inside the budget");
    let hits: Hits<f32> = Sphere::new(1.0).expect("a size").hits(&ray);
    let text = serde_json::to_string(&hits).expect("every value can be written");
    assert!(text.contains(r#"{"t":2.0,"part":"Side","crossing":"Enter"}"#), "{text}");
}

#[test]
fn serde_refuses_what_a_constructor_refuses() {
    let direction = serde_json::from_str::<UnitVec3<f32>>("[1.0, 1.0, 0.0]").expect_err("its length is not 1");
    assert!(direction.to_string().starts_with("the direction has a length that is not 1: normalise it"), "{direction}");
    let range = serde_json::from_str::<Range<f32>>("[2.0, 1.0]").expect_err("its ends are in the wrong order");
    assert!(range.to_string().starts_with(&RayError::Range.to_string()), "{range}");
    let ray = r#"{"origin":{"x":3e38,"y":0,"z":0},"direction":[0,0,1],"range":[0,1],"departure":null}"#;
    let ray = serde_json::from_str::<Ray<f32>>(ray).expect_err("its origin is beyond the budget");
    assert!(ray.to_string().starts_with(&RayError::Origin(ValueError::BeyondBudget).to_string()), "{ray}");
}

#[test]
fn mint_vectors_and_points_convert_both_ways() {
    let v = Vec3::new(1.0_f32, 2.0, 3.0);
    assert_eq!(Vec3::from(mint::Vector3::from(v)), v);
    assert_eq!(Vec3::from(mint::Point3::from(v)), v);
    assert_eq!(mint::Vector3::<f32>::from(UnitVec3::<f32>::Y), mint::Vector3 { x: 0.0, y: 1.0, z: 0.0 });
    let generic: mint::Vector3<I16F16> = Vec3::<I16F16>::ZERO.into();
    assert_eq!(generic.x, I16F16::ZERO);
}

#[test]
fn defmt_formats_every_value_type() {
    fn formats<T: defmt::Format>() {}
    formats::<Vec3<f32>>();
    formats::<UnitVec3<f32>>();
    formats::<Ray<f32>>();
    formats::<Range<f32>>();
    formats::<Departure>();
    formats::<Hit<f32>>();
    formats::<Hits<f32>>();
    formats::<raylet::Shape<f32>>();
    formats::<raylet::FrameError>();
    formats::<raylet::SizeError>();
    formats::<RayError>();
}
