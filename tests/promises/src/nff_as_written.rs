//! The promise: files as others wrote them are read for what they mean: lights as far as the sun, patches that run the
//! wrong way.

use fixed::types::{I16F16, I32F32};
use raylet::scene::nff::{self, Corner, Counts, Scale, Stores, View};
use raylet::scene::{CornerNormals, Full, Store};
use raylet::{Camera, Light, Material, Object, Picture, Primitive, Scalar, Scene, Size, Sphere, UnitVec3, Vec3};

struct Growing<T>(Vec<T>);

impl<T> Store<T> for Growing<T> {
    fn push(&mut self, item: T) -> Result<(), Full> {
        self.0.push(item);
        Ok(())
    }
}

struct Read<S: Scalar> {
    view: View<S>,
    objects: Vec<Object<S>>,
    lights: Vec<Light<S>>,
    normals: Vec<CornerNormals<S>>,
}

const VIEW: &str = "v from 0 0 0 at 0 0 -1 up 0 1 0 angle 5 resolution 32 24\n";

fn read<S: Scalar>(rest: &str, scale: Scale) -> Read<S> {
    let text = format!("{VIEW}{rest}");
    let (mut objects, mut materials) = (Growing(vec![]), Growing(Vec::<Material<S>>::new()));
    let (mut lights, mut normals) = (Growing(vec![]), Growing(vec![]));
    let stores = Stores {
        objects: &mut objects,
        materials: &mut materials,
        lights: &mut lights,
        normals: &mut normals,
        corners: &mut vec![Corner::default(); Counts::of(&text).corners],
    };
    let view = nff::read_scaled(&text, stores, scale).unwrap_or_else(|error| panic!("{error}: {text}"));
    Read { view, objects: objects.0, lights: lights.0, normals: normals.0 }
}

#[test]
fn a_light_far_beyond_all_else_does_not_make_the_scene_small() {
    let power = |text: &str| Scale::fitting::<I16F16>(text).power();
    // Of a ball within 5, and of lights farther than that.
    let ball = "s 0.5 -2 1 0.75 at 5 0 0";
    assert_eq!(power(ball), 10);
    for (light, expected) in [
        ("l 8 0 0", 10),
        ("l 9 0 0", 9),
        ("l 0 1000 0", 3),
        // 2^12 times half of the budget at 2^10.
        ("l 0 0 -32768", -2),
        ("l 0 0 32769", 10),
        ("l 2e6 0 0", 10),
        ("l 2000000.000000000000000000001 0 0", 10),
        ("l 1e30 0 0", 10),
        // Each by itself, whatever comes first.
        ("l 2e6 0 0 l 9 0 0", 9),
        ("l 0 1000 0 l 1e9 1e9 1e9 l 9 0 0", 3),
        // All three coordinates of a light count together.
        ("l 1000 0 2e6", 10),
        ("l 1 2e6 1 l 1 1", 10),
    ] {
        assert_eq!(power(&format!("{ball} {light}")), expected, "{light}");
        assert_eq!(power(&format!("{light} {ball}")), expected, "{light}");
    }
    // Where there is nothing else the lights are all.
    assert_eq!(power("l 2e6 0 0 l 1 1 1"), -8);
}

/// The cosine between a light's direction and the true one, from 1.
fn off<S: Scalar>(light: &Light<S>, expected: [f64; 3]) -> f64 {
    let [x, y, z] = light.position.to_f64();
    let cross =
        [y * expected[2] - z * expected[1], z * expected[0] - x * expected[2], x * expected[1] - y * expected[0]];
    let length = |v: [f64; 3]| v.map(|c| c * c).iter().sum::<f64>().sqrt();
    length(cross) / length([x, y, z]) / length(expected)
}

#[test]
fn a_light_beyond_the_type_has_the_right_direction() {
    fn check<S: Scalar>(scale: Scale) {
        for (text, direction) in [
            ("3e12 0 4e12", [0.6, 0.0, 0.8]),
            ("-2000000000000 1e12 -1.5e12", [-2.0, 1.0, -1.5]),
            ("1 1 1e12", [1e-12, 1e-12, 1.0]),
            ("1e13 12345678901234567890123 0", [1e-9 * 0.81, 1.0, 0.0]),
            ("9.99999999999999999999e20 -9.99999999999999999999e20 0", [1.0, -1.0, 0.0]),
            ("1e30 0 1e9998", [0.0, 0.0, 1.0]),
            ("-00000000000000000000000000000000000000001e30 0.0 0", [-1.0, 0.0, 0.0]),
        ] {
            let read = read::<S>(&format!("l {text} 0.5 0.25 1"), scale);
            assert_eq!((read.view.distant, read.lights[0].distant), (1, true), "{text}");
            let off = off(&read.lights[0], direction);
            assert!(off < 1e-8, "{text}: {off}");
            assert_eq!(read.lights[0].strength.map(S::to_f64), [0.5, 0.25, 1.0]);
        }
        assert!(!read::<S>("l 16384 0 0", Scale::ONE).lights[0].distant);
    }
    check::<I16F16>(Scale::ONE);
    check::<I32F32>(Scale::ONE);
    check::<I16F16>(Scale::power_of_two(9));
    assert!(read::<I16F16>("l 16384.1 0 0", Scale::ONE).lights[0].distant);
    assert!(read::<f32>("l 1e38 0 0", Scale::ONE).lights[0].distant);
    assert_eq!(read::<f32>("l 1e30 0 0", Scale::ONE).view.distant, 0);
}

/// A distant light lights as one does that is very far, and its shadows do not end.
#[test]
fn a_distant_light_shines_as_one_very_far_away() {
    fn levels<S: Scalar>(light: Light<S>) -> Vec<[u8; 3]> {
        let n = |value: f64| S::from_f64(value).unwrap();
        let point = |x, y, z| Vec3::new(n(x), n(y), n(z));
        let balls = [([0.0, 0.0, 0.0], 1.0), ([1.5, 1.0, 1.0], 0.4)];
        let objects = balls.map(|([x, y, z], radius)| {
            let frame = raylet::Frame::at(point(x, y, z)).unwrap();
            Object::new(raylet::Shape::new(Sphere::new(n(radius)).unwrap()).placed(frame), 0)
        });
        let materials = [Material::default().with_highlight(n(0.25), n(9.0))];
        let camera = Camera::new(point(0.0, 0.0, 5.0), Vec3::ZERO, point(0.0, 1.0, 0.0), n(40.0)).unwrap();
        let lights = [light];
        let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
        let mut levels = Vec::new();
        Picture::new(&scene, Size::new(48, 36)).render(|_, _, pixel| levels.push(pixel.color.to_srgb888()));
        levels
    }
    fn check<S: Scalar>(reference: &[[u8; 3]]) {
        let direction = UnitVec3::new(Vec3::from_f64([3.0, 2.0, 2.0]).unwrap()).unwrap();
        let levels = levels::<S>(Light::distant(direction, S::from_f64(0.8).unwrap()));
        let off = levels.iter().zip(reference).filter(|(a, b)| a[0].abs_diff(b[0]) > 1).count();
        assert!(off <= 3, "{off} pixels");
    }
    let reference = levels::<f64>(Light::new(Vec3::new(3e9, 2e9, 2e9), 0.8));
    assert!(reference.iter().any(|level| level[0] > 100));
    check::<f32>(&reference);
    check::<f64>(&reference);
    check::<I16F16>(&reference);
    check::<I32F32>(&reference);
}

#[test]
fn normals_decide_which_side_of_a_patch_is_its_front() {
    fn check<S: Scalar>() {
        // An arrow, which is cut into two triangles, clockwise as seen from above.
        let corners = ["0 0 0", "4 4 0", "1 0 0", "4 -4 0"];
        let patch = |normals: [&str; 4]| {
            let corners = corners.iter().zip(normals).map(|(at, normal)| format!("{at} {normal}")).collect::<Vec<_>>();
            read::<S>(&format!("pp 4 {}", corners.join(" ")), Scale::ONE)
        };
        // How the triangles run, and the normal of the corner at the origin.
        let runs = |read: &Read<S>| {
            let mut runs = Vec::new();
            for object in &read.objects {
                let Primitive::Triangle(triangle) = object.shape.primitive() else { panic!("a triangle") };
                let [a, b, c] = triangle.vertices().map(Vec3::to_f64);
                runs.push((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0);
                // Every corner keeps its own normal.
                let normals = read.normals[object.smooth.unwrap() as usize];
                for (at, normal) in [a, b, c].into_iter().zip(normals) {
                    let tilted = normal.to_f64()[0] != 0.0;
                    assert_eq!(tilted, at == [1.0, 0.0, 0.0], "{at:?}");
                }
            }
            runs
        };
        let below = patch(["0 0 -1", "0 0 -1", "0.2 0 -1", "0 0 -1"]);
        assert_eq!((below.view.turned, runs(&below)), (0, vec![false; 2]));
        let above = patch(["0 0 1", "0 0 1", "0.2 0 1", "0 0 1"]);
        assert_eq!((above.view.turned, runs(&above)), (1, vec![true; 2]));
        // The mean of them counts; where there is none the corners do.
        assert_eq!(patch(["0 0 1", "0 0 1", "0.2 0 1", "0 0 -1"]).view.turned, 1);
        assert_eq!(patch(["0 0 1", "0 0 -1", "0.2 0 1", "-0.2 0 -1"]).view.turned, 0);
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}
