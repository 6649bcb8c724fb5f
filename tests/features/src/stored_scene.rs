//! The parts of a scene, and all other public values, are stored and come back to the bit; what no constructor makes is
//! refused.

use fixed::types::{I16F16, I32F32};
use raylet::effect::{Effect, EffectSet, Sample};
use raylet::gallery::BuiltIn;
use raylet::scalar::{Budget, UnitScalar};
use raylet::scene::nff::{Corner, Counts, Scale, View};
use raylet::scene::{CameraError, Coordinate, CornerNormals, Raster, SceneHit, Waves};
use raylet::shape::kinds::{Kind, KindSet};
use raylet::tier::Precision;
use raylet::{
    Along, Camera, Color, Counters, Cylinder, Fog, Frame, Hit, Light, Material, Object, Outline, Part, Pixel, Plane,
    Ray, Scalar, Scene, Shape, Size, Sphere, Texture, UnitVec3, ValueError, Vec3,
};
use serde::{Serialize, de::DeserializeOwned};

use crate::interchange::round_trip;

fn read<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    serde_json::from_str(text).map_err(|error| error.to_string())
}

fn written(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("every value can be written")
}

fn refused<T: DeserializeOwned + std::fmt::Debug>(text: &str, message: impl AsRef<str>) {
    let error = read::<T>(text).expect_err("no constructor makes it");
    assert!(error.starts_with(message.as_ref()), "{text}: {error}");
}

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("a number of the type")
}

fn point<S: Scalar>(at: [f64; 3]) -> Vec3<S> {
    Vec3::from_f64(at).expect("numbers of the type")
}

fn cameras<S: Scalar>() -> Vec<Camera<S>> {
    let (eye, up) = (point([0.1, 2.3, -4.7]), point([0.2, 1.0, 0.0]));
    let angles = [0.01, 1.0, 40.0, 90.0, 179.0, 179.9].map(number::<S>);
    let pinholes = angles.map(|angle| Camera::new(eye, Vec3::ZERO, up, angle).expect("a camera"));
    let heights = [S::BUDGET.smallest_size, number(2.4), S::BUDGET.coordinate];
    let parallel = heights.map(|height| Camera::orthographic(eye, Vec3::ZERO, up, height).expect("a camera"));
    pinholes.into_iter().chain(parallel).collect()
}

fn all_come_back<S: Scalar>() {
    let unit = <S::Unit as UnitScalar>::from_f64;
    let third = number::<S>(1.0 / 3.0);
    let color = Color::<S>::from_f64([1.0 / 3.0, 0.7, 1.0]);
    let white = Color::WHITE;
    for camera in cameras::<S>() {
        round_trip(&camera);
        let raster = camera.raster(Size::new(64, 48).with_samples(3));
        round_trip(&raster);
        let back: Raster<S> = read(&written(&raster)).expect("what was written can be read");
        assert_eq!(back.ray([3, 47], [1, 2]), raster.ray([3, 47], [1, 2]));
    }
    round_trip(&color);
    round_trip(&Fog::new(color, unit(0.99)));
    round_trip(&Outline::new(color).with_width(3));
    round_trip(&Light::new(point([1.0, 2.0, 1.0 / 3.0]), third));
    round_trip(&Light::distant(UnitVec3::from_f64([1.0, 2.0, 3.0]).expect("a length"), third));
    let waves = Waves { along_u: 3, along_v: 0, slope: third };
    round_trip(&waves);
    let material = Material::matte(color)
        .with_highlight(third, number(30.0))
        .with_mirror(number(0.2))
        .with_refraction(number(0.3), number(1.5));
    round_trip(&material);
    round_trip(&material.with_texture(7).with_bump(waves));
    let can = Shape::new(Cylinder::capped(third, number(2.0)).expect("sizes"));
    let object = Object::new(can.placed(Frame::at(point([0.1, 0.2, 0.3])).expect("near")), 3).with_base(4).with_top(5);
    round_trip(&object);
    round_trip(&object.smooth(6));
    type Few<S> = Object<S, (Cylinder<S>, Frame<S>)>;
    let few: Few<S> = read(&written(&object)).expect("its kinds are among them");
    assert_eq!(written(&few), written(&object));
    round_trip::<CornerNormals<S>>(&[UnitVec3::X, UnitVec3::Y, UnitVec3::from_f64([1.0, 2.0, 3.0]).expect("a length")]);
    for texture in [
        Texture::Checker { columns: 4, rows: 7, colors: [color, white] },
        Texture::Stripes { along: Coordinate::V, count: 9, colors: [color, white] },
        Texture::Cells { counts: [1, 2, 3], colors: [color, white] },
    ] {
        let back: Texture<'static, S> = read(&written(&texture)).expect("what was written can be read");
        assert_eq!(back, texture);
        let bytes = postcard::to_stdvec(&texture).expect("every value can be written");
        assert_eq!(postcard::from_bytes::<Texture<'static, S>>(&bytes), Ok(texture));
    }
    let ray = Ray::new(Vec3::ZERO, UnitVec3::Z).expect("near");
    let hit = Sphere::new(third).expect("a size").nearest(&ray).expect("from inside");
    round_trip(&SceneHit { object: 9, hit });
    round_trip(&Pixel { color, seen: Some((3, Part::Top)), lit_by: 5 });
    round_trip(&Sample { color, seen: None, lit_by: 0 });
    let camera = cameras::<S>()[2];
    let (resolution, hither) = ([640, 480], third);
    round_trip(&View { camera, resolution, hither, background: color, invisible: 1, turned: 2, distant: 3 });
    round_trip(&Corner::<S>::new(point([0.1, 0.2, 0.3]), UnitVec3::Y));
    round_trip::<Budget<S>>(&S::BUDGET);
    let along: Along<S> = Ray::along(Vec3::ZERO, point([0.1, 0.2, 0.3])).expect("a vector");
    round_trip(&along);
}

#[test]
fn serde_brings_the_parts_of_a_scene_back() {
    all_come_back::<f32>();
    all_come_back::<f64>();
    all_come_back::<I16F16>();
    all_come_back::<I32F32>();
    round_trip(&Size::new(3, 4).with_samples(5));
    let objects = [Object::new(Shape::new(Plane::<f32>::new()), 0)];
    let materials = [Material::default()];
    let scene = Scene::new(&objects, &materials, &[], cameras()[0]).expect("a scene");
    let mut counters = Counters::default();
    let _ = scene.nearest(&Ray::new(Vec3::ZERO, UnitVec3::Z).expect("near"), &mut counters);
    assert_eq!(counters.intersection_tests, 1);
    round_trip(&counters);
    round_trip(&Counts::of("s 0 0 0 1"));
    round_trip(&Scale::power_of_two(-3));
    BuiltIn::EVERY.iter().for_each(round_trip);
    [Precision::Filter, Precision::Integers].iter().for_each(round_trip);
    Effect::EVERY.iter().for_each(round_trip);
    Kind::EVERY.iter().for_each(round_trip);
    round_trip(&EffectSet::EMPTY);
    round_trip(&EffectSet::ALL);
    round_trip(&KindSet::ALL);
    assert_eq!(written(&EffectSet::of(Effect::Fog).with(Effect::Shadows)), r#"["Shadows","Fog"]"#);
    assert_eq!(written(&KindSet::of(Kind::Plane)), r#"["Plane"]"#);
}

/// In fixed point too the numbers are those that a person would write.
#[test]
fn a_material_and_a_color_can_be_read_by_people() {
    let half = I16F16::from_num(0.5);
    let color = Color::<I16F16>::from_f64([1.0, 0.5, 0.25]);
    assert_eq!(written(&color), r#"{"red":"1","green":"0.5","blue":"0.25"}"#);
    assert_eq!(
        written(&Light::new(Vec3::new(half, half, half), I16F16::ONE)),
        r#"{"position":{"x":"0.5","y":"0.5","z":"0.5"},"strength":["1","1","1"],"distant":false}"#
    );
    let texture: Texture<'_, I16F16> = Texture::Image { width: 1, height: 1, pixels: &[[255, 128, 64]] };
    assert_eq!(written(&texture), r#"{"Image":{"width":1,"height":1,"pixels":[[255,128,64]]}}"#);
}

#[test]
fn serde_refuses_parts_of_a_scene_that_no_constructor_makes() {
    let camera = |position: &str, forward: &str, height: &str, orthographic: bool| {
        format!(
            r#"{{"position":{{"x":{position},"y":0,"z":0}},"forward":{forward},"right":[1,0,0],"up":[0,1,0],
            "half_height":{height},"is_orthographic":{orthographic}}}"#
        )
    };
    let back = "[0,0,-1]";
    read::<Camera<f32>>(&camera("1", back, "0.5", false)).expect("a camera");
    read::<Camera<I16F16>>(&camera("1", back, "[1,-1]", false)).expect("a camera");
    refused::<Camera<f32>>(&camera("3e38", back, "0.5", false), CameraError::Position.to_string());
    for skew in ["[0,0,1]", "[0,0.6,-0.8]"] {
        refused::<Camera<f32>>(&camera("1", skew, "0.5", false), CameraError::Axes.to_string());
        refused::<Camera<I16F16>>(&camera("1", skew, "[1,-1]", false), CameraError::Axes.to_string());
    }
    for height in ["0", "-0.5"] {
        refused::<Camera<f32>>(&camera("1", back, height, false), CameraError::Angle.to_string());
    }
    refused::<Camera<f32>>(&camera("1", back, "-0.5", true), CameraError::Height.to_string());
    refused::<Camera<f32>>(&camera("1", back, "3e38", true), CameraError::Height.to_string());
    for height in ["[0,0]", "[-1,-1]", "[1,100]", "[1,-100]"] {
        refused::<Camera<I16F16>>(&camera("1", back, height, false), CameraError::Angle.to_string());
    }
    for height in ["[0,0]", "[-1,-1]", "[1,14]"] {
        refused::<Camera<I16F16>>(&camera("1", back, height, true), CameraError::Height.to_string());
    }
    let beyond = "the number is beyond what the library computes with";
    for height in ["[9223372036854775807,-62]", "[1,2147483647]", "[1,-2147483648]"] {
        refused::<Camera<I16F16>>(&camera("1", back, height, false), beyond);
    }

    let colors = r#""colors":[{"red":0,"green":0,"blue":0},{"red":1,"green":1,"blue":1}]"#;
    for empty in [
        format!(r#"{{"Checker":{{"columns":0,"rows":1,{colors}}}}}"#),
        format!(r#"{{"Stripes":{{"along":"U","count":0,{colors}}}}}"#),
        format!(r#"{{"Cells":{{"counts":[1,0,1],{colors}}}}}"#),
    ] {
        let message = "the texture cannot be used: its counts, width and height must be at least 1";
        refused::<Texture<'static, f32>>(&empty, message);
    }
    let image = r#"{"Image":{"width":1,"height":1,"pixels":[[1,2,3]]}}"#;
    refused::<Texture<'static, f32>>(image, "an image borrows its pixels: read these, and make the texture of them");

    let along = |length: &str| {
        let ray = Ray::new(Vec3::<f32>::ZERO, UnitVec3::X).expect("near");
        format!("[{},{length}]", written(&ray))
    };
    refused::<Along<f32>>(&along("0"), raylet::RayError::Direction(ValueError::Zero).to_string());
    refused::<Along<f32>>(&along("-1"), raylet::RayError::Direction(ValueError::Negative).to_string());
    refused::<EffectSet>(r#"["Fog","Mist"]"#, "unknown variant `Mist`");
    refused::<KindSet>("3", "invalid type: integer `3`, expected a list of primitives and placements");
    // What a constructor clamps is clamped.
    assert_eq!(read("100"), Ok(Scale::LARGEST));
    let fog: Fog<f32> = read(r#"{"color":{"red":1,"green":1,"blue":1},"clarity":2}"#).expect("fog");
    assert_eq!(fog.clarity(), 1.0);
}

#[test]
fn defmt_formats_every_value_in_every_number_type() {
    fn formats<T: defmt::Format>() {}
    fn of_type<S: Scalar>() {
        formats::<Hit<S>>();
        formats::<Shape<S>>();
        formats::<raylet::Affine<S>>();
        formats::<Object<S>>();
        formats::<Material<S>>();
        formats::<Light<S>>();
        formats::<Color<S>>();
        formats::<Camera<S>>();
        formats::<Raster<S>>();
        formats::<Fog<S>>();
        formats::<Outline<S>>();
        formats::<Texture<'static, S>>();
        formats::<Waves<S>>();
        formats::<SceneHit<S>>();
        formats::<Pixel<S>>();
        formats::<Sample<S>>();
        formats::<View<S>>();
        formats::<Along<S>>();
    }
    of_type::<f32>();
    of_type::<f64>();
    of_type::<I16F16>();
    of_type::<I32F32>();
    formats::<Size>();
    formats::<Counters>();
    formats::<EffectSet>();
    formats::<KindSet>();
}
