//! The promise: a ray is left out only if it cannot change an output level, and samples are added only where corners
//! differ.

use fixed::types::{I16F16, I32F32};
use raylet::scene::nff::{self, Corner, Counts, Stores};
use raylet::{
    Camera, Color, Counters, Frame, Light, Material, Object, Picture, Pixel, Plane, Scalar, Scene, Shape, Size, Sphere,
    TraceContext, Vec3,
};
use std::fmt::Write;

/// Reads a scene and hands it on.
fn with_scene<S: Scalar, T>(text: &str, then: impl FnOnce(&Scene<'_, S>) -> T) -> T {
    let mut objects = heapless::Vec::<Object<S>, 256>::new();
    let mut materials = heapless::Vec::<Material<S>, 64>::new();
    let mut lights = heapless::Vec::<Light<S>, 16>::new();
    let mut normals = heapless::Vec::<_, 256>::new();
    let stores = Stores {
        objects: &mut objects,
        materials: &mut materials,
        lights: &mut lights,
        normals: &mut normals,
        corners: &mut vec![Corner::default(); Counts::of(text).corners],
    };
    let view = nff::read(text, stores).unwrap();
    let scene = Scene::new(&objects, &materials, &lights, view.camera).unwrap();
    then(&scene.with_background(view.background).with_normals(&normals).unwrap())
}

fn levels<S: Scalar>(picture: &Picture<'_, S>) -> (Vec<[u8; 3]>, Counters) {
    let mut levels = Vec::new();
    let counters = picture.render(|_, _, pixel| levels.push(pixel.color.to_srgb888()));
    (levels, counters)
}

/// Numbers from 0 to 1 that are the same every time.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 40) as f64 / 16_777_216.0
    }
}

/// Balls of all kinds on a floor, by number.
fn generated(seed: u64) -> String {
    let dice = &mut Dice(seed);
    let mut text =
        "v from 0 3 9 at 0 0.7 0 up 0 1 0 angle 34 resolution 40 30\nb 0.3 0.45 0.6\nl 5 8 6 l -7 6 4\n".to_owned();
    text.push_str("f 0.8 0.7 0.6 0.8 0.2 10 0 1 p 4 -9 0 9 9 0 9 9 0 -9 -9 0 -9\n");
    for _ in 0..7 {
        let [red, green, blue, mirror, through] = std::array::from_fn(|_| dice.roll());
        let through = if through < 0.5 { 0.0 } else { (1.0 - mirror) * through };
        let (shine, index) = (1.0 + 60.0 * dice.roll(), 1.0 + dice.roll());
        writeln!(text, "f {red} {green} {blue} 0.3 {mirror} {shine} {through} {index}").unwrap();
        let radius = 0.3 + 0.7 * dice.roll();
        let (x, z) = (5.0 * dice.roll() - 2.5, 5.0 * dice.roll() - 2.5);
        writeln!(text, "s {x} {radius} {z} {radius}").unwrap();
    }
    text
}

/// No level changes, and no more rays are cast; the share that is.
fn check<S: Scalar>(name: &str, text: &str, size: Size) -> f64 {
    with_scene::<S, _>(text, |scene| {
        let picture = Picture::new(scene, size);
        let ((cut, counters), (uncut, all)) = (levels(&picture), levels(&picture.uncut()));
        let differ = cut.iter().zip(&uncut).filter(|(cut, uncut)| cut != uncut).count();
        println!("{name}: {} of {} rays, {differ} pixels differ", counters.rays(), all.rays());
        assert_eq!(differ, 0, "{name}");
        assert!(counters.rays() <= all.rays(), "{name}");
        counters.rays() as f64 / all.rays() as f64
    })
}

#[test]
fn what_is_not_cast_changes_no_level_in_generated_scenes() {
    let mut cast = [1.0; 3];
    for (seed, cast) in (0..).zip(&mut cast) {
        let (text, size) = (generated(seed), Size::new(40, 30));
        *cast = check::<f32>(&format!("f32, scene {seed}"), &text, size);
        check::<I16F16>(&format!("I16F16, scene {seed}"), &text, size);
    }
    // Faint rays last and the strongest of them first: else it is 0.85 of them, and 1 if none is put aside.
    assert!(cast[0] < 0.5, "{cast:?}");
    check::<f64>("f64", &generated(3), Size::new(40, 30));
    check::<I32F32>("I32F32", &generated(4), Size::new(20, 15));
}

#[test]
fn what_is_not_cast_changes_no_level_in_the_examples() {
    for (name, text) in [
        ("tubes", raylet_scenes::TUBES),
        ("star", raylet_scenes::STAR),
        ("lamps", raylet_scenes::LAMPS),
        ("far", raylet_scenes::FAR),
    ] {
        check::<f32>(name, text, Size::new(80, 60));
        check::<I16F16>(name, text, Size::new(80, 60));
    }
}

/// A surface that sends on one part in 1000 of the light must not be taken for one that sends none: a strong lamp may
/// stand behind it.
#[test]
fn what_a_faint_ray_shows_of_a_strong_lamp_is_not_left_out() {
    let (dim, bright) = (Material { diffuse: 0.0_f32, ..Material::default() }, Material::default());
    let tinted = Material { color: Color::from_f64([0.0, 1.0, 0.0]), ..bright };
    for (faint, behind) in
        [(dim.with_mirror(0.001), [0.0, 1.0, 0.0]), (dim.with_refraction(0.001, 1.0), [0.0, -2.0, 0.0])]
    {
        for shown in [bright, tinted, dim.with_highlight(1.0, 1.0)] {
            let mut objects = ball::<f32>();
            objects[1].shape = Shape::new(Sphere::new(1.0).unwrap()).placed(Frame::at(behind.into()).unwrap());
            let (materials, lights) = ([faint, shown], [Light::new(Vec3::new(3.0, behind[1], 3.0), 100.0)]);
            let camera = Camera::new(Vec3::new(0.0, 6.0, 9.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 30.0).unwrap();
            let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
            let picture = Picture::new(&scene, Size::new(32, 24));
            let ((cut, _), (uncut, _)) = (levels(&picture), levels(&picture.uncut()));
            assert!(cut == uncut, "{shown:?}");
            let mut on_floor = 0;
            picture.render(|_, _, pixel| {
                on_floor +=
                    u32::from(pixel.seen.is_some_and(|(object, _)| object == 0) && pixel.color.to_srgb888()[1] > 9);
            });
            assert!(on_floor > 3, "{on_floor}: something is seen there");
        }
    }
}

/// Between two facing mirrors of one part in eight every ray could go on for ever.
fn with_facing_mirrors<T>(then: impl FnOnce(&Scene<'_, f64>) -> T) -> T {
    let mirror = Material::matte(Color::<f64>::WHITE).with_mirror(0.125);
    let facing = |y: f64, up: f64| {
        let axis = raylet::UnitVec3::new(Vec3::new(0.0, up, 0.0)).unwrap();
        let frame = Frame::from_base_and_axis(Vec3::new(0.0, y, 0.0), axis).unwrap();
        Object::new(Shape::new(Plane::new()).placed(frame), 0)
    };
    let objects = [facing(0.0, 1.0), facing(2.0, -1.0)];
    let (up, target) = (Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
    let camera = Camera::new(Vec3::new(0.0, 1.5, 3.0), target, up, 20.0).unwrap();
    let (materials, lights) = ([mirror], [Light::new(Vec3::new(0.0, 1.9, 0.0), 0.5)]);
    then(&Scene::new(&objects, &materials, &lights, camera).unwrap())
}

#[test]
fn a_weak_mirror_is_followed_as_far_as_it_can_be_seen() {
    with_facing_mirrors(|scene| {
        let picture = Picture::new(scene, Size::new(40, 30));
        let ((cut, few), (uncut, many)) = (levels(&picture), levels(&picture.uncut()));
        assert!(cut == uncut);
        let a_pixel = |counters: &Counters| counters.reflection_rays as f64 / counters.primary_rays as f64;
        assert_eq!(a_pixel(&many), 16.0);
        // Half of 1/255 is the weight of the third reflection.
        assert!((2.0..4.5).contains(&a_pixel(&few)), "{}", a_pixel(&few));
    });
}

/// Where several samples make a pixel, each counts in steps of 1/4080: their mean is off by no more.
#[test]
fn samples_of_a_pixel_are_cut_in_finer_steps() {
    with_facing_mirrors(|scene| {
        let picture = Picture::new(scene, Size::new(40, 30).with_samples(2));
        let channels = |picture: &Picture<'_, f64>| {
            let mut channels = Vec::new();
            picture.render(|_, _, pixel| channels.extend(pixel.color.to_f64s()));
            channels
        };
        let (cut, uncut) = (channels(&picture), channels(&picture.uncut()));
        let farthest = cut.iter().zip(&uncut).map(|(cut, uncut)| (cut - uncut).abs()).fold(0.0, f64::max);
        assert!(farthest > 0.0 && farthest < 1.0 / 4080.0, "{farthest}");
        // A sixteenth of the weight is a reflection and a third later.
        let a_ray = |picture: &Picture<'_, f64>| {
            let counters = picture.render(|_, _, _| {});
            counters.reflection_rays as f64 / counters.primary_rays as f64
        };
        let (fine, coarse) = (a_ray(&picture), a_ray(&Picture::new(scene, Size::new(40, 30))));
        assert!(fine > coarse + 1.0, "{fine} {coarse}");
    });
}

fn ball<S: Scalar>() -> [Object<S>; 2] {
    let number = |value| S::from_f64(value).unwrap();
    let at = Frame::at(Vec3::from_f64([0.0, 1.0, 0.0]).unwrap()).unwrap();
    [Object::new(Shape::new(Plane::new()), 0), Object::new(Shape::new(Sphere::new(number(1.0)).unwrap()).placed(at), 1)]
}

#[test]
fn samples_are_added_where_corners_differ_and_rows_are_the_same_as_pixels() {
    fn check<S: Scalar>() {
        let (objects, number) = (ball::<S>(), |value| S::from_f64(value).unwrap());
        let point = |x, y, z| Vec3::from_f64([x, y, z]).unwrap();
        let camera =
            Camera::new(point(0.0, 3.0, 9.0), point(0.0, 0.6, 0.0), point(0.0, 1.0, 0.0), number(30.0)).unwrap();
        let materials = [Material::default(), Material::default().with_mirror(number(0.3))];
        let lights = [Light::new(point(-4.0, 7.0, 6.0), number(0.6))];
        let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
        let picture = Picture::new(&scene, Size::new(40, 30).with_samples(3));
        let (mut by_rows, mut apart) = (TraceContext::new(()), TraceContext::new(()));
        let (mut refined, mut far) = (0, 0);
        for y in 0..30 {
            let row: Vec<Pixel<S>> = picture.row(y, &mut by_rows).collect();
            let pixels: Vec<_> = (0..40).map(|x| picture.pixel(x, y, &mut apart)).collect();
            assert!(row == pixels, "row {y}");
            for (x, pixel) in (0..40).zip(row) {
                let before = apart.counters.refined_pixels;
                picture.pixel(x, y, &mut apart);
                let is_refined = apart.counters.refined_pixels > before;
                refined += u64::from(is_refined);
                // The samples' own grid, as a picture of three times the size that is cut alike.
                let grid: [f64; 3] = mean(&scene, [x, y], 3);
                let error = pixel.color.to_f64s().into_iter().zip(grid).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                far += u32::from(error > 1e-6 && is_refined) + u32::from(error > 1.0 / 32.0);
                if is_refined {
                    let raster = scene.camera().raster(picture.size());
                    let middle = raylet::Tracer::new(&scene)
                        .look(&raster.ray([x, y], [1, 1]).unwrap(), &mut TraceContext::new(()));
                    assert_eq!((pixel.seen, pixel.lit_by), (middle.seen, middle.lit_by), "{x}, {y}: the middle sample");
                }
            }
        }
        assert_eq!(by_rows.counters.refined_pixels, refined);
        assert_eq!(by_rows.counters.primary_rays, 41 * 2 * 30 + 9 * refined);
        assert!((50..600).contains(&refined), "{refined}");
        assert_eq!(far, 0);
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

trait Channels {
    fn to_f64s(&self) -> [f64; 3];
}

impl<S: Scalar> Channels for Color<S> {
    fn to_f64s(&self) -> [f64; 3] {
        use raylet::scalar::UnitScalar;
        self.to_array().map(UnitScalar::to_f64)
    }
}

/// The mean of a pixel's grid of samples.
fn mean<S: Scalar>(scene: &Scene<'_, S>, [x, y]: [u16; 2], samples: u8) -> [f64; 3] {
    let raster = scene.camera().raster(Size::new(40, 30).with_samples(samples));
    let (tracer, mut context, mut sum) = (raylet::Tracer::new(scene).uncut(), TraceContext::new(()), [0.0; 3]);
    for (row, column) in (0..samples).flat_map(|row| (0..samples).map(move |column| (row, column))) {
        let sight = tracer.look(&raster.ray([x, y], [column, row]).unwrap(), &mut context);
        let channels = sight.color.clamped().to_f64s();
        sum = std::array::from_fn(|i| sum[i] + channels[i] / f64::from(samples).powi(2));
    }
    sum
}
