//! The promise: every entity of the Neutral File Format is read, in every layout, rounded once; and a file that cannot
//! be read says where and why.

use fixed::types::{I16F16, I32F32};
use raylet::scene::nff::{self, Corner, Counts, NffError, Scale, Stores, View, triangulate};
use raylet::scene::{CornerNormals, Full, Store};
use raylet::{Color, Light, Material, Object, Placement, Primitive, Scalar, UnitVec3, Vec3, Visible};

/// A store of fixed capacity, which a test may choose.
struct Room<T>(Vec<T>, usize);

impl<T> Store<T> for Room<T> {
    fn push(&mut self, item: T) -> Result<(), Full> {
        if self.0.len() == self.1 {
            return Err(Full);
        }
        self.0.push(item);
        Ok(())
    }
}

struct Read<S: Scalar> {
    view: View<S>,
    objects: Vec<Object<S>>,
    materials: Vec<Material<S>>,
    lights: Vec<Light<S>>,
    normals: Vec<CornerNormals<S>>,
}

/// Reads with room for so many objects, materials, lights, normals and corners.
fn read_into<S: Scalar>(text: &str, room: [usize; 5]) -> Result<Read<S>, NffError> {
    read_scaled_into(text, room, Scale::ONE)
}

fn read_scaled_into<S: Scalar>(text: &str, [o, m, l, n, c]: [usize; 5], scale: Scale) -> Result<Read<S>, NffError> {
    let (mut objects, mut materials) = (Room(vec![], o), Room(vec![], m));
    let (mut lights, mut normals) = (Room(vec![], l), Room(vec![], n));
    let view = nff::read_scaled(
        text,
        Stores {
            objects: &mut objects,
            materials: &mut materials,
            lights: &mut lights,
            normals: &mut normals,
            corners: &mut vec![Corner::default(); c],
        },
        scale,
    )?;
    Ok(Read { view, objects: objects.0, materials: materials.0, lights: lights.0, normals: normals.0 })
}

fn read<S: Scalar>(text: &str) -> Result<Read<S>, NffError> {
    read_scaled(text, Scale::ONE)
}

/// As much as a text needs.
fn room(text: &str) -> [usize; 5] {
    let counts = Counts::of(text);
    [counts.objects, counts.materials, counts.lights, counts.normals, counts.corners]
}

fn read_scaled<S: Scalar>(text: &str, scale: Scale) -> Result<Read<S>, NffError> {
    read_scaled_into(text, room(text), scale)
}

const VIEW: &str = "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 resolution 32 24\n";

/// A file with a view in line 1; the text under test starts in line 2.
fn scene(rest: &str) -> Read<f64> {
    read(&format!("{VIEW}{rest}")).unwrap()
}

fn message<S: Scalar>(text: &str) -> String {
    read::<S>(text).err().map(|error| error.to_string()).unwrap_or_default()
}

#[test]
fn view_and_background() {
    let read = scene("b 0.25 0.5 1 # sky");
    assert_eq!(read.view.background, Color::new(0.25, 0.5, 1.0));
    assert_eq!(read.view.resolution, [32, 24]);
    assert_eq!(read.view.hither, 0.0);
    assert_eq!(read.view.camera.position(), Vec3::new(0.0, 0.0, 5.0));
    assert_eq!(read.view.camera.forward(), -UnitVec3::Z);
    assert_eq!(scene("").view.background, Color::BLACK);
}

#[test]
fn view_keywords_come_in_any_order_on_any_lines() {
    let text = "v resolution\n32 24 hither 0.5 angle 45\nup\n0 1 0 at 0 0\n0\n\nfrom 0 0 5 s 0 0 0 1";
    let read = read::<f64>(text).unwrap();
    assert_eq!(read.view.hither, 0.5);
    assert_eq!(read.view.camera, scene("").view.camera);
    assert_eq!(read.objects.len(), 1);
}

#[test]
fn lights_with_and_without_colour() {
    let lights = scene("l 1 2 3  l 4 5 6 0.5 0.25 3\nl 0 0 0 s 0 0 0 1 l 7 8 9").lights;
    assert_eq!(lights.iter().map(|light| light.position.x).collect::<Vec<_>>(), [1.0, 4.0, 0.0, 7.0]);
    // Four lights, 1 / sqrt(4) each.
    assert_eq!(lights[0].strength, [0.5; 3]);
    assert_eq!(lights[1].strength, [0.5, 0.25, 3.0]);
    assert_eq!(lights[3].strength, [0.5; 3]);
}

#[test]
fn materials_hold_for_the_objects_that_follow() {
    let read = scene("f 1 0.5 0 0.8 0.2 30 0 1 s 0 0 0 1 s 0 0 1 1 f 0 0 1 1 0 2 0.5 1.5 s 0 0 2 1");
    assert_eq!(read.objects.iter().map(|object| object.material).collect::<Vec<_>>(), [0, 0, 1]);
    let expected = Material {
        color: Color::new(1.0, 0.5, 0.0),
        diffuse: 0.8,
        specular: 0.2,
        shine: 30.0,
        transmittance: 0.0,
        refraction: 1.0,
        mirror: 0.2,
        texture: None,
        bump: None,
    };
    assert_eq!(read.materials[0], expected);
    assert_eq!(read.materials[1].refraction, 1.5);
}

#[test]
fn objects_before_any_material_are_white_and_matte() {
    let read = scene("s 0 0 0 1 f 1 0 0 1 0 1 0 1 s 0 0 1 1");
    assert_eq!(read.materials[0], Material::default());
    assert_eq!((read.objects[0].material, read.objects[1].material), (0, 1));
}

#[test]
fn spheres_and_their_sides() {
    let objects = scene("s 1 2 3 0.5 s 0 0 0 -2 f 1 1 1 0 0 1 0.5 1 s 0 0 0 1 s 0 0 0 -1").objects;
    let radius = |index: usize| match objects[index].shape.primitive() {
        Primitive::Sphere(sphere) => sphere.radius(),
        other => panic!("{other:?}"),
    };
    assert_eq!((radius(0), radius(1)), (0.5, 2.0));
    let Placement::Frame(frame) = objects[0].shape.placement() else { panic!() };
    assert_eq!(frame.position(), Vec3::new(1.0, 2.0, 3.0));
    let sides = objects.iter().map(|object| object.shape.visible()).collect::<Vec<_>>();
    assert_eq!(sides, [Visible::Outside, Visible::Inside, Visible::Both, Visible::Both]);
}

#[test]
fn cones_in_one_line_and_in_many() {
    let text = "c 0 0 0 2 0 3 0 1\nc\n0 0 0 2\n0 3 0 1\nc 0 0 0 1 0 0 4 1 c 0 0 0 -2 0 3 0 -1 c 0 0 0 0 0 1 0 1 c 0 0 0 -2 0 3 0 0";
    let objects = scene(text).objects;
    assert_eq!(objects[0], objects[1]);
    let radii = |index: usize| match objects[index].shape.primitive() {
        Primitive::Cone(cone) => (cone.base_radius(), cone.top_radius().unwrap(), cone.height().unwrap()),
        Primitive::Cylinder(cylinder) => (cylinder.radius(), cylinder.radius(), cylinder.height().unwrap()),
        other => panic!("{other:?}"),
    };
    assert_eq!(radii(0), (2.0, 1.0, 3.0));
    assert_eq!(radii(2), (1.0, 1.0, 4.0));
    assert!(matches!(objects[2].shape.primitive(), Primitive::Cylinder(_)));
    assert_eq!((radii(3), objects[3].shape.visible()), ((2.0, 1.0, 3.0), Visible::Inside));
    assert_eq!(radii(4), (0.0, 1.0, 1.0));
    assert_eq!((radii(5), objects[5].shape.visible()), ((2.0, 0.0, 3.0), Visible::Inside));
}

#[test]
fn tubes_have_no_caps() {
    use raylet::{Crossing, Ray};
    let shape = scene("c 0 0 0 1 0 3 0 1").objects[0].shape.seen_from(Visible::Both);
    let along = Ray::new(Vec3::new(0.5, 9.0, 0.0), -UnitVec3::Y).unwrap();
    assert!(shape.hits(&along).is_empty());
    let across = Ray::new(Vec3::new(-9.0, 1.0, 0.0), UnitVec3::X).unwrap();
    let crossings = shape.hits(&across).iter().map(|hit| (hit.t, hit.crossing)).collect::<Vec<_>>();
    assert_eq!(crossings, [(8.0, Crossing::Enter), (10.0, Crossing::Exit)]);
}

#[test]
fn polygons_and_patches() {
    let read = scene(
        "p 4 0 0 0 1 0 0 1 1 0 0 1 0\npp 3\n0 0 0 0 0 2\n1 0 0 1 0 0\n0 1 0 0 1 0 f 1 1 1 1 0 1 1 1 p 3 0 0 0 1 0 0 0 1 0",
    );
    assert_eq!(read.objects.len(), 4);
    assert_eq!(read.objects[0].shape.visible(), Visible::Outside);
    assert_eq!(read.objects[3].shape.visible(), Visible::Both);
    assert_eq!(read.objects.iter().map(|object| object.smooth).collect::<Vec<_>>(), [None, None, Some(0), None]);
    assert_eq!(read.normals, [[UnitVec3::Z, UnitVec3::X, UnitVec3::Y]]);
}

#[test]
fn what_cannot_be_seen_is_left_out_and_counted() {
    let text =
        format!("{VIEW}p 3 0 0 0 1 1 1 2 2 2 s 0 0 0 0.000001 c 0 0 0 1e-9 0 1 0 0 c 0 0 0 1 0 0 1e-9 1 s 0 0 0 1");
    let fixed = read::<I16F16>(&text).unwrap();
    assert_eq!((fixed.objects.len(), fixed.view.invisible), (1, 4));
    let double = read::<f64>(&text).unwrap();
    assert_eq!((double.objects.len(), double.view.invisible), (4, 1));
}

#[test]
fn counts_are_what_a_scene_needs() {
    let counts = Counts::of("v # s s s\nl 0 0 0 f s 0 0 0 1 c p 5 pp 4 l");
    let expected = Counts { objects: 7, materials: 2, lights: 2, normals: 2, corners: 5 };
    assert_eq!(counts, expected);
    // A lie about the number of corners is no reason to reserve 2^60 of them.
    assert!(Counts::of("p 1152921504606846976").corners < 100);
}

#[test]
fn numbers_are_rounded_once_in_every_type() {
    // Halfway cases, and texts that a detour over f64 or f32 would round twice.
    fn number<S: Scalar>(text: &str) -> S {
        read::<S>(&format!("{VIEW}l {text} 0 0")).unwrap().lights[0].position.x
    }
    // 1 + 2^-24 exactly, and a hair above: f32 rounds to even, then up.
    assert_eq!(number::<f32>("1.000000059604644775390625"), 1.0);
    assert_eq!(number::<f32>("1.000000059604644775390625000000001"), 1.000_000_1);
    assert_eq!(number::<f64>("0.1"), 0.1);
    assert_eq!(number::<f64>("-2.55836e-17"), -2.558_36e-17);
    // Half a unit of 2^-16 above 1 (tie to even), one and a half, and a hair above half.
    assert_eq!(number::<I16F16>("1.00000762939453125").to_bits(), 1 << 16);
    assert_eq!(number::<I16F16>("1.00002288818359375").to_bits(), (1 << 16) + 2);
    assert_eq!(number::<I16F16>("1.000007629394531250000000000000001").to_bits(), (1 << 16) + 1);
    assert_eq!(number::<I16F16>("-2.55836e-17").to_bits(), 0);
    assert_eq!(number::<I16F16>("1.5e2").to_bits(), 150 << 16);
    // Needs more bits than an f64 has: 1000000000 + 2^-32.
    assert_eq!(number::<I32F32>("1000000000.00000000023283064365386962890625").to_bits(), (1_000_000_000 << 32) + 1);
}

/// Once: a number that was rounded to the type's steps and then enlarged would show those steps.
#[test]
fn in_other_units_numbers_are_rounded_after_scaling() {
    let text = format!("{VIEW}l 0.1 -3 0.7 s 0.1 0.2 -0.3 0.018518518 p 3 0 0 0 0.1 0 0 0 0.3 0 f 1 1 1 1 0 9 0 1");
    let scale = Scale::power_of_two(9);
    let fixed = read_scaled::<I16F16>(&text, scale).unwrap();
    assert_eq!(fixed.lights[0].position, Vec3::from_f64([51.2, -1536.0, 358.4]).unwrap());
    let Primitive::Sphere(sphere) = fixed.objects[0].shape.primitive() else { panic!("a sphere") };
    assert_eq!(sphere.radius(), I16F16::from_num(512.0 * 0.018_518_518));
    let Primitive::Triangle(triangle) = fixed.objects[1].shape.primitive() else { panic!("a triangle") };
    assert_eq!(triangle.vertices()[2], Vec3::from_f64([0.0, 153.6, 0.0]).unwrap());
    assert_eq!(fixed.view.camera.position().z, 5 * 512);
    // What is no length keeps its value.
    assert_eq!(fixed.materials[1].shine, 9);
    let double = read_scaled::<f64>(&text, Scale::LEAST).unwrap();
    assert_eq!(double.lights[0].position.x, 0.1 / 65536.0);
    // Too small for the type in the file's units.
    let tiny = format!("{VIEW}s 0 0 0 0.000001");
    assert_eq!(read::<I16F16>(&tiny).unwrap().view.invisible, 1);
    assert_eq!(read_scaled::<I16F16>(&tiny, Scale::fitting::<I16F16>(&tiny)).unwrap().view.invisible, 0);
}

#[test]
fn the_fitting_scale_is_the_largest_with_half_the_budget_free() {
    let power = |text: &str| Scale::fitting::<I16F16>(text).power();
    // 8192 is half of the budget: it fits, and what is a hair above does not.
    assert_eq!(["l 8192 0 0", "l 0 -8192.1 0", "l 0 0 4096.1", "l 0 0 -4096"].map(power), [0, -1, 0, 1]);
    // Whatever the entity; colours, normals, angles and counts are no lengths.
    assert_eq!(
        ["from 1 2 3", "at 9 1 1", "s 0 0 0 30", "c 0 0 0 0 0 0 0 99", "p 3 0 0 0 0 0 0 0 0 17"].map(power),
        [11, 9, 8, 5, 8]
    );
    assert_eq!(power("pp 3 1 0 0 900 0 0  0 1 0 900 0 0  0 0 1 900 0 0  b 77 77 77 angle 9000 l 0 0 0 70 70 70"), 13);
    assert_eq!(power("pp 3 1 0 0 900 0 0  0 1 0 900 0 0  0 0 3 900 0 0"), 11);
    // Nothing to fit, and more than can be fitted.
    assert_eq!(
        ["", "s 0 0 0 0", "l x y z", "p", "p 3", "pp 2 1 1", "l 1e-30 0 0", "l 1e30 0 0"].map(power),
        [0, 0, 0, 0, 0, 13, 32, -16]
    );
    assert_eq!(Scale::fitting::<I32F32>("l 3 0 0").power(), 27);
    assert_eq!(Scale::fitting::<f64>("l 3e9 0 0"), Scale::ONE);
    // A count that the text cannot hold costs no more than the text.
    assert_eq!(["pp 4000000000 1 1 1", "p 4294967295", "p 4294967295 1 1"].map(power), [13, 0, 13]);
    // The height of a tube from corner to corner is larger than any coordinate.
    let long = format!("{VIEW}c -5 -5 -5 0.1 5 5 5 0.1");
    assert_eq!(read_scaled::<I16F16>(&long, Scale::fitting::<I16F16>(&long)).unwrap().objects.len(), 1);
}

#[test]
fn a_shine_beyond_the_type_is_the_largest() {
    let text = format!("{VIEW}f 1 1 1 1 0 100000 0 1");
    assert_eq!(read::<I16F16>(&text).unwrap().materials[0].shine, I16F16::BUDGET.distance);
    assert_eq!(read::<f32>(&text).unwrap().materials[0].shine, 100_000.0);
}

#[test]
fn malformed_files_say_where_and_why() {
    let number = "should be a number such as -12.5 or 1.5e-3";
    let budget = "beyond the number type's budget: read the text at a smaller nff::Scale or take a wider type";
    for (text, expected) in [
        ("q 1", "line 2, column 1: this starts no entity: expected one of v, b, l, f, c, s, p, pp or #".to_owned()),
        ("s 0 0", "line 2, column 6: the text ends where the sphere's centre should be: complete the entity".to_owned()),
        ("s 0 0 0\n# radius?\n", "line 4, column 1: the text ends where the sphere's radius should be: complete the entity".to_owned()),
        ("\n  s 0 0 0 one", format!("line 3, column 11: the sphere's radius {number}")),
        ("s 0 0 0 nan", format!("line 2, column 9: the sphere's radius {number}")),
        ("s 0 0 0 inf", format!("line 2, column 9: the sphere's radius {number}")),
        ("s 0 0 0 0x10", format!("line 2, column 9: the sphere's radius {number}")),
        ("s 0 0 0 1_0", format!("line 2, column 9: the sphere's radius {number}")),
        ("s 0 0 0 s", format!("line 2, column 9: the sphere's radius {number}")),
        ("s 0 0 0 0.0", "line 2, column 9: the sphere's radius is zero: give a size, negative to show the inside only".to_owned()),
        ("s 0 0 100000 1", format!("line 2, column 7: the sphere's centre is {budget}")),
        ("l 0 1e99999 0", format!("line 2, column 5: the light's position is {budget}")),
        ("l 0 0 0 1 1", "line 2, column 12: the text ends where the light's colour should be: complete the entity".to_owned()),
        ("l 0 0 0 1 1 -1", "line 2, column 13: the light's colour is negative: give 0 or more".to_owned()),
        ("b 0 1.5 0", "line 2, column 5: the background is outside 0 to 1".to_owned()),
        ("b 0 0 0 b 0 0 0", "line 2, column 9: a second background: a scene has one, remove the other".to_owned()),
        ("f 1 1 -0.5 1 0 1 0 1", "line 2, column 7: the material's colour is outside 0 to 1".to_owned()),
        ("f 1 1 1 -1 0 1 0 1", "line 2, column 9: the material's Kd is negative: give 0 or more".to_owned()),
        ("f 1 1 1 1 -1 1 0 1", "line 2, column 11: the material's Ks is negative: give 0 or more".to_owned()),
        ("f 1 1 1 1 0 -100000 0 1", "line 2, column 13: the material's shine is beyond the number type: give a smaller number or take a wider type".to_owned()),
        ("f 1 1 1 1 0 1 -0.5 1", "line 2, column 15: the material's T is negative: give 0 or more".to_owned()),
        ("f 1 1 1 1 0 1 0", "line 2, column 16: the text ends where the material's index of refraction should be: complete the entity".to_owned()),
        ("c 0 0 0 1 0 0 1 -1", "line 2, column 17: one radius is negative and the other is not: make both negative to show the inside only".to_owned()),
        ("c 0 0 0 1 0 0 0 1", "line 2, column 11: both ends of the cone or cylinder are the same point: move one".to_owned()),
        ("c 0 0 0 0 0 0 1 0", "line 2, column 9: the cone's larger radius is zero: give a size, negative to show the inside only".to_owned()),
        ("p 2 0 0 0 1 0 0", "line 2, column 3: a polygon has at least three corners".to_owned()),
        ("p 4294967295 0 0 0", "line 2, column 3: the text ends before 4294967295 corners: correct their number".to_owned()),
        ("s 0 0 \u{fffd}0 1", "line 2, column 7: this is no UTF-8 text: remove it, or move it into a comment behind a #".to_owned()),
        ("p 3.5", "line 2, column 3: the number of corners should be a whole number, at least 1 and not too large".to_owned()),
        ("p 3 0 0 0 1 0 0 p", format!("line 2, column 17: the corner's position {number}")),
        ("pp 3 0 0 0 0 0 0", "line 2, column 12: a normal has the length zero: give it a direction".to_owned()),
        (VIEW, "line 2, column 1: a second view: a scene has one, remove the other".to_owned()),
    ] {
        assert_eq!(message::<I16F16>(&format!("{VIEW}{text}")), expected, "{text}");
    }
}

#[test]
fn malformed_views_say_where_and_why() {
    for (text, expected) in [
        ("", "line 1, column 1: the text ends without a view: add a \"v\" entity"),
        ("s 0 0 0 1", "line 1, column 10: the text ends without a view: add a \"v\" entity"),
        (
            "v from 0 0 5 at 0 0 0 up 0 1 0 angel 45",
            "line 1, column 32: the view ends here but lacks \"angle\": add it",
        ),
        ("v from 0 0 5", "line 1, column 13: the view ends here but lacks \"at\": add it"),
        ("v from 0 0 5 from 0 0 5", "line 1, column 14: the view has \"from\" twice: remove one"),
        (
            "v from 0 0 5 at 0 0 5 up 0 1 0 angle 45 resolution 9 9",
            "line 1, column 14: the camera looks at its own position, or at a point beyond the number type's budget",
        ),
        (
            "v from 0 0 5 at 0 0 0 up 0 0 1 angle 45 resolution 9 9",
            "line 1, column 23: the camera's up vector is zero or parallel to its line of sight: give another one",
        ),
        (
            "v from 0 0 5 at 0 0 0 up 0 1 0 angle 180 resolution 9 9",
            "line 1, column 32: the camera's angle must lie between 0 and 180 degrees",
        ),
        (
            "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 resolution 9 0",
            "line 1, column 54: the view's resolution should be a whole number, at least 1 and not too large",
        ),
    ] {
        assert_eq!(message::<f32>(text), expected, "{text}");
        assert_eq!(message::<I16F16>(text), expected, "{text}");
    }
}

#[test]
fn full_stores_are_errors_with_a_place() {
    let text = format!("{VIEW}l 0 0 0\nf 1 1 1 1 0 1 0 1\ns 0 0 0 1\npp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1");
    let enough = [2, 1, 1, 1, 3];
    assert!(read_into::<f32>(&text, enough).is_ok());
    for (kind, expected) in [
        (0, "line 5, column 1: no more room for objects: give their store a larger capacity"),
        (1, "line 3, column 1: no more room for materials: give their store a larger capacity"),
        (2, "line 2, column 1: no more room for lights: give their store a larger capacity"),
        (3, "line 5, column 1: no more room for corner normals: give their store a larger capacity"),
        (4, "line 5, column 4: the polygon has more corners than there is room for (2): give more scratch corners"),
    ] {
        let mut room = enough;
        room[kind] -= 1;
        let error = read_into::<f32>(&text, room).err().map(|error| error.to_string());
        assert_eq!(error.as_deref(), Some(expected));
    }
}

/// The triangles of a polygon in the plane z = x + 2 y, seen from above.
fn triangles<S: Scalar>(outline: &[[f64; 2]]) -> Vec<[[f64; 2]; 3]> {
    let corner = |[x, y]: &[f64; 2]| Corner::new(Vec3::from_f64([*x, *y, x + 2.0 * y]).unwrap(), UnitVec3::<S>::Z);
    let mut corners: Vec<_> = outline.iter().map(corner).collect();
    let mut list = Vec::new();
    let count = triangulate(&mut corners, |triangle| {
        list.push(triangle.map(|corner| [corner.point().x.to_f64(), corner.point().y.to_f64()]));
        Ok::<(), ()>(())
    });
    assert_eq!(count, Ok(list.len()));
    list
}

/// Twice the area, by the shoelace formula.
fn area(outline: &[[f64; 2]]) -> f64 {
    (0..outline.len())
        .map(|i| (outline[i], outline[(i + 1) % outline.len()]))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum()
}

fn covers_exactly<S: Scalar>(outline: &[[f64; 2]]) {
    // From every corner on, since the first corner decides how the cutting goes.
    for start in 0..outline.len() {
        let mut turned = outline.to_vec();
        turned.rotate_left(start);
        let list = triangles::<S>(&turned);
        assert!(list.iter().all(|triangle| area(triangle) > 0.0), "{list:?}");
        // All positive and together as large as the polygon: none overlaps or sticks out.
        assert_eq!(list.iter().map(|triangle| area(triangle)).sum::<f64>(), area(outline), "{turned:?}");
        assert!(list.len() <= outline.len() - 2);
    }
}

#[test]
fn triangles_cover_the_polygon_exactly() {
    let square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let corners_on_lines = vec![[0.0, 0.0], [1.0, 0.0], [4.0, 0.0], [4.0, 2.0], [4.0, 4.0], [2.0, 4.0], [0.0, 4.0]];
    let arrow = vec![[0.0, 0.0], [4.0, -4.0], [1.0, 0.0], [4.0, 4.0]];
    let ell = vec![[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
    let comb: Vec<_> = (0..9)
        .flat_map(|i| {
            let x = f64::from(8 - i);
            if i % 2 == 0 { [[x, 5.0], [x, 5.0]] } else { [[x, 1.0], [x, 1.0]] }
        })
        .chain([[0.0, 0.0], [8.0, 0.0]])
        .collect();
    let spike = vec![[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let ring = vec![
        [0.0, 0.0],
        [9.0, 0.0],
        [9.0, 9.0],
        [0.0, 9.0],
        [0.0, 0.0],
        [3.0, 3.0],
        [3.0, 6.0],
        [6.0, 6.0],
        [6.0, 3.0],
        [3.0, 3.0],
    ];
    let spiral = vec![
        [0.0, 0.0],
        [7.0, 0.0],
        [7.0, 7.0],
        [1.0, 7.0],
        [1.0, 2.0],
        [5.0, 2.0],
        [5.0, 5.0],
        [3.0, 5.0],
        [3.0, 4.0],
        [4.0, 4.0],
        [4.0, 3.0],
        [2.0, 3.0],
        [2.0, 6.0],
        [6.0, 6.0],
        [6.0, 1.0],
        [0.0, 1.0],
    ];
    for outline in [square, corners_on_lines, arrow, ell, comb, spike, ring, spiral] {
        covers_exactly::<f32>(&outline);
        covers_exactly::<f64>(&outline);
        covers_exactly::<I16F16>(&outline);
        covers_exactly::<I32F32>(&outline);
    }
}

#[test]
fn a_polygon_faces_the_way_it_runs() {
    // Clockwise seen from above: its triangles run clockwise, too.
    let clockwise = [[0.0, 0.0], [0.0, 3.0], [1.0, 3.0], [1.0, 1.0], [3.0, 1.0], [3.0, 0.0]];
    let list = triangles::<f64>(&clockwise);
    assert_eq!(list.iter().map(|triangle| area(triangle)).sum::<f64>(), area(&clockwise));
    assert!(list.iter().all(|triangle| area(triangle) < 0.0));
}

#[test]
fn polygons_without_area_give_no_triangle() {
    assert!(triangles::<f32>(&[]).is_empty());
    assert!(triangles::<f32>(&[[0.0, 0.0], [1.0, 1.0]]).is_empty());
    assert!(triangles::<f32>(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]).is_empty());
    assert!(triangles::<f32>(&[[1.0, 1.0]; 5]).is_empty());
}

#[test]
fn a_polygon_that_crosses_itself_ends() {
    // No promise but that it ends, without a panic, with triangles of the polygon's own corners.
    let pentagram = [[0.0, 3.0], [-2.0, -3.0], [3.0, 1.0], [-3.0, 1.0], [2.0, -3.0]];
    assert!(triangles::<f32>(&pentagram).len() <= 3);
    assert!(triangles::<f32>(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 3.0]]).len() <= 2);
}

#[test]
fn a_line_may_end_in_any_of_the_three_ways() {
    for end in ["\n", "\r\n", "\r"] {
        let text = [VIEW.trim_end(), "# a comment", "s 0 0 0 1", "s 0 0 zero 1"].join(end);
        let error = read::<f32>(&text).err().expect("zero is no number");
        assert_eq!((error.place.line, error.place.column), (4, 7), "{end:?}: {error}");
    }
}
