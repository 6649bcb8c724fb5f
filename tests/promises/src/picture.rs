//! The promise: a scene is the same picture in every number type, and only the rays that it calls for are cast.

use fixed::types::{I16F16, I32F32};
use raylet::gallery::BuiltIn;
use raylet::scene::nff::{self, Corner, Counts, Scale, Stores};
use raylet::tier::{Exact, Fast, Plain, Tier};
use raylet::{
    Camera, Color, Counters, Cylinder, Light, Material, Object, Part, Picture, Pixel, Plane, Ray, Scalar, Scene, Shape,
    Size, Sphere, TraceContext, Tracer, Triangle, UnitVec3, Vec3, Visible,
};
use support::amount::amount;

type Lists<S, const N: usize> = (
    heapless::Vec<Object<S>, N>,
    heapless::Vec<Material<S>, N>,
    heapless::Vec<Light<S>, N>,
    heapless::Vec<[UnitVec3<S>; 3], N>,
);

/// Reads a scene and hands it on.
fn with_scaled<S: Scalar, T>(text: &str, scale: Scale, then: impl FnOnce(&Scene<'_, S>) -> T) -> T {
    let (mut objects, mut materials, mut lights, mut normals): Lists<S, 256> = Default::default();
    let view = nff::read_scaled(
        text,
        Stores {
            objects: &mut objects,
            materials: &mut materials,
            lights: &mut lights,
            normals: &mut normals,
            corners: &mut vec![Corner::default(); Counts::of(text).corners],
        },
        scale,
    )
    .unwrap();
    let scene = Scene::new(&objects, &materials, &lights, view.camera).unwrap();
    then(&scene.with_background(view.background).with_normals(&normals).unwrap())
}

fn render<S: Scalar>(text: &str, size: Size) -> (Vec<Pixel<S>>, Counters) {
    render_scaled(text, Scale::ONE, size)
}

fn render_scaled<S: Scalar>(text: &str, scale: Scale, size: Size) -> (Vec<Pixel<S>>, Counters) {
    with_scaled(text, scale, |scene| {
        let mut pixels = Vec::new();
        let counters = Picture::new(scene, size).render(|_, _, pixel| pixels.push(pixel));
        (pixels, counters)
    })
}

/// One character a pixel, from black to white.
fn ascii<S: Scalar>(text: &str, size: Size) -> Vec<String> {
    let (pixels, _) = render::<S>(text, size);
    let shade = |pixel: &Pixel<S>| [' ', '.', ':', '+', '*', '#'][usize::from(pixel.color.to_linear888()[0]) * 5 / 255];
    pixels.chunks(usize::from(size.width)).map(|row| row.iter().map(shade).collect()).collect()
}

const BALL: &str = "v from 0 0 10 at 0 0 0 up 0 1 0 angle 14 resolution 24 12
b 0.2 0.2 0.2
l 10 10 10 1 1 1
f 1 1 1 1 0 1 0 1
s 0 0 0 1";

#[test]
fn a_ball_in_every_number_type() {
    // From the formulas of a sphere and of Lambert, computed apart from this crate.
    let expected = [
        "........................",
        "........................",
        "..........:+***.........",
        "........ .:+****........",
        "........ .:++***........",
        "........ ..:++**........",
        "........  .::+++........",
        "........   ..:::........",
        "........    ............",
        ".........      .........",
        "........................",
        "........................",
    ];
    let size = Size::new(24, 12);
    assert_eq!(ascii::<f64>(BALL, size), expected);
    assert_eq!(ascii::<f32>(BALL, size), expected);
    assert_eq!(ascii::<I16F16>(BALL, size), expected);
    assert_eq!(ascii::<I32F32>(BALL, size), expected);
}

/// Pixels that differ, by more than one level, and of these the ones that no silhouette explains.
fn compare<S: Scalar>(text: &str, scale: Scale, size: Size, reference: &[Pixel<f64>]) -> [usize; 3] {
    let pixels = render_scaled::<S>(text, scale, size).0;
    let (width, mut counts) = (usize::from(size.width), [0; 3]);
    for (index, (a, b)) in pixels.iter().zip(reference).enumerate() {
        let channels = a.color.to_srgb888().into_iter().zip(b.color.to_srgb888());
        let levels = channels.map(|(a, b)| a.abs_diff(b)).max().unwrap();
        let (x, y) = (index % width, index / width);
        let neighbours = (y.saturating_sub(1)..=y + 1)
            .flat_map(|y| (x.saturating_sub(1)..=(x + 1).min(width - 1)).map(move |x| y * width + x))
            .filter_map(|neighbour| reference.get(neighbour));
        // The reference has an edge here, of the very thing and the very shadow that was seen: a hole is no silhouette.
        let (mut same_thing, mut edge, mut changes) = (false, false, 0);
        for neighbour in neighbours {
            same_thing |= neighbour.seen == a.seen;
            edge |= neighbour.seen != b.seen;
            changes |= neighbour.lit_by ^ b.lit_by;
        }
        let silhouette =
            if a.seen == b.seen { (a.lit_by ^ b.lit_by) & !changes == 0 && (edge || changes != 0) } else { same_thing };
        counts[0] += usize::from(levels > 0);
        counts[1] += usize::from(levels > 1);
        counts[2] += usize::from(levels > 1 && !silhouette);
    }
    counts
}

#[test]
fn number_types_agree_but_for_silhouettes() {
    let [width, height] = amount([60, 45], [160, 120]);
    let pixels = usize::from(width) * usize::from(height);
    println!("differing pixels of {pixels}, by more than one level, unexplained");
    for (name, text) in [
        ("tubes", raylet_scenes::TUBES),
        ("star", raylet_scenes::STAR),
        ("dome", raylet_scenes::DOME),
        ("lamps", raylet_scenes::LAMPS),
        ("far", raylet_scenes::FAR),
    ] {
        let size = Size::new(width, height);
        let reference = render::<f64>(text, size).0;
        let single = compare::<f32>(text, Scale::ONE, size, &reference);
        let fixed = compare::<I16F16>(text, Scale::ONE, size, &reference);
        let wide = compare::<I32F32>(text, Scale::ONE, size, &reference);
        println!("{name:6} f32 {single:?}  I16F16 {fixed:?}  I32F32 {wide:?}");
        for [differing, by_more, unexplained] in [single, fixed, wide] {
            assert_eq!(unexplained, 0, "{name}");
            // A thousandth of the pixels on silhouettes, and one in a hundred by a single level, are the worst seen.
            assert!(by_more <= pixels / 960 && differing <= pixels / 100, "{name}: {differing} {by_more}");
        }
        let fitted = compare::<I16F16>(text, Scale::fitting::<I16F16>(text), size, &reference);
        println!("       I16F16 in fitting units {fitted:?}");
        assert_eq!(fitted[1], 0, "{name}: in fitting units every pixel is right to one level");
    }
}

/// A ball with six others on it, a third as large, each with five on it, and again: mirrors in mirrors.
fn flake() -> String {
    fn grow(text: &mut String, [x, y, z]: [f64; 3], radius: f64, from: Option<[f64; 3]>) {
        use std::fmt::Write;
        writeln!(text, "s {x} {y} {z} {radius}").unwrap();
        if radius < 0.02 {
            return;
        }
        let [dx, dy, dz] = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
        for way in [dx, dy, dz].into_iter().flat_map(|way| [way, way.map(|way| -way)]) {
            if from != Some(way.map(|way| -way)) {
                let distance = radius * 4.0 / 3.0;
                grow(
                    text,
                    [x + way[0] * distance, y + way[1] * distance, z + way[2] * distance],
                    radius / 3.0,
                    Some(way),
                );
            }
        }
    }
    let mut text = "v from 1.6 1.1 1.3 at 0 0 0 up 0 0 1 angle 45 resolution 64 48 b 0.08 0.36 0.75
        l 4 3 2 l 1 4 4 l 3 1 5 f 1 0.9 0.7 0.5 0.5 30 0 1 "
        .to_owned();
    grow(&mut text, [0.0; 3], 0.5, None);
    text
}

/// Mirrors magnify what a ball's radius is rounded by; larger units mend it.
#[test]
fn fitting_units_make_mirrors_true_in_16_bit_fractions() {
    let (text, size) = (flake(), Size::new(96, 96));
    let scale = Scale::fitting::<I16F16>(&text);
    assert_eq!(scale.power(), 10);
    let reference = render::<f64>(&text, size).0;
    let plain = compare::<I16F16>(&text, Scale::ONE, size, &reference);
    let fitted = compare::<I16F16>(&text, scale, size, &reference);
    println!("differing pixels of 9216, by more than one level, unexplained: {plain:?}, in fitting units {fitted:?}");
    assert!(plain[1] > 0, "in the file's own units the radii's rounding shows");
    // The bar is one in a hundred by more than a level.
    assert_eq!(fitted[1], 0, "{fitted:?}");
}

/// Units are arbitrary: a float's bits do not change with them.
#[test]
fn powers_of_two_change_no_bit_of_a_float_picture() {
    let (text, size) = (flake(), Size::new(32, 32));
    let seen = |scale| render_scaled::<f32>(&text, scale, size);
    let (pixels, counters) = seen(Scale::ONE);
    for power in [-16, -3, 7, 20] {
        let (scaled, count) = seen(Scale::power_of_two(power));
        assert_eq!((scaled == pixels, count), (true, counters), "2^{power}");
    }
}

fn camera<S: Scalar>() -> Camera<S> {
    let point = |x, y, z| Vec3::from_f64([x, y, z]).unwrap();
    let angle = S::from_f64(30.0).unwrap();
    Camera::new(point(0.0, 3.0, 9.0), point(0.0, 0.0, 0.0), point(0.0, 1.0, 0.0), angle).unwrap()
}

#[test]
fn shadow_rays_go_only_where_they_can_matter() {
    let floor = [Object::new(Shape::new(Plane::new()), 0)];
    let above = Light::new(Vec3::new(0.0_f32, 5.0, 0.0), 1.0);
    let below = Light::new(Vec3::new(0.0_f32, -5.0, 0.0), 1.0);
    let cost = |material: Material<f32>, lights: &[Light<f32>]| {
        let materials = [material];
        let scene = Scene::new(&floor, &materials, lights, camera()).unwrap();
        // The camera looks down: every pixel of this size sees the floor.
        Picture::new(&scene, Size::new(8, 6)).render(|_, _, pixel| assert!(pixel.seen.is_some()))
    };
    let matte = Material::matte(Color::WHITE);
    assert_eq!(cost(matte, &[]).shadow_rays, 0);
    assert_eq!(cost(matte, &[above]).shadow_rays, 48);
    assert_eq!(cost(matte, &[above, above]).shadow_rays, 96);
    assert_eq!(cost(matte, &[below]).shadow_rays, 0, "behind the surface");
    assert_eq!(cost(matte, &[Light::new(above.position, 0.0)]).shadow_rays, 0, "a light that is out");
    assert_eq!(cost(Material::matte(Color::BLACK), &[above]).shadow_rays, 0, "nothing to light");
    let counters = cost(matte, &[above]);
    assert_eq!((counters.primary_rays, counters.rays(), counters.hits_refined), (48, 96, 48));
    assert_eq!(counters.intersection_tests, 96);
}

/// The middle pixel of a picture of some objects on the y axis, lit from above the eye.
fn middle<S: Scalar>(objects: &[Object<S>]) -> Pixel<S> {
    let materials = [Material::matte(Color::WHITE)];
    let lights = [Light::new(Vec3::from_f64([0.0, 4.0, 9.0]).unwrap(), S::from_f64(1.0).unwrap())];
    let scene = Scene::new(objects, &materials, &lights, camera()).unwrap();
    Picture::new(&scene, Size::new(3, 3)).pixel(1, 1, &mut TraceContext::new(()))
}

#[test]
fn one_sided_objects_are_looked_through_from_the_back() {
    let number = |value| I16F16::from_f64(value).unwrap();
    let tube = Shape::new(Cylinder::infinite(number(1.0)).unwrap());
    let ball = Object::new(Shape::new(Sphere::new(number(0.5)).unwrap()), 0);
    // The near wall, seen from outside, hides the ball; seen from inside only, it does not.
    let seen = |visible| middle(&[Object::new(tube.seen_from(visible), 0), ball]).seen.map(|(object, _)| object);
    assert_eq!(seen(Visible::Both), Some(0));
    assert_eq!(seen(Visible::Outside), Some(0));
    assert_eq!(seen(Visible::Inside), Some(1));
}

#[test]
fn the_inside_of_a_surface_is_lit_from_inside() {
    fn check<S: Scalar>() {
        // The eye and the lamp are both inside a ball that is seen from the inside only.
        let room = Shape::new(Sphere::new(S::from_f64(20.0).unwrap()).unwrap()).seen_from(Visible::Inside);
        let pixel = middle(&[Object::new(room, 0)]);
        assert_eq!((pixel.seen, pixel.lit_by), (Some((0, Part::Side)), 1));
        assert!(pixel.color.red > Color::<S>::BLACK.red);
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

#[test]
fn nothing_shadows_itself() {
    // Without the departure, rounding puts about half of the starting points behind the surface.
    fn check<S: Scalar>() {
        let objects = [Object::new(Shape::new(Sphere::new(S::from_f64(1.0).unwrap()).unwrap()), 0)];
        let materials = [Material::matte(Color::WHITE)];
        let eye = camera::<S>().position();
        let lights = [Light::new(eye, S::from_f64(1.0).unwrap())];
        let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
        // The lamp stands at the eye: whatever is seen is lit.
        Picture::new(&scene, Size::new(64, 48)).render(|x, y, pixel| {
            assert_eq!(pixel.lit_by, u32::from(pixel.seen.is_some()), "{x} {y}");
        });
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

#[test]
fn of_two_objects_at_the_same_distance_the_last_is_seen() {
    let ball = Object::new(Shape::new(Sphere::new(1.0_f32).unwrap()), 0);
    assert_eq!(middle(&[ball, ball]).seen.map(|(object, _)| object), Some(1));
}

#[test]
fn a_light_between_two_things_is_not_shadowed_by_the_farther() {
    // The ball stands behind the lamp, as seen from the floor.
    let number = |value| I16F16::from_f64(value).unwrap();
    let point = |x, y, z| Vec3::from_f64([x, y, z]).unwrap();
    let frame = raylet::Frame::at(point(0.0, 5.0, 0.0)).unwrap();
    let objects = [
        Object::new(Shape::new(Plane::new()), 0),
        Object::new(Shape::new(Sphere::new(number(1.0)).unwrap()).placed(frame), 0),
    ];
    let materials = [Material::matte(Color::WHITE)];
    let lit_by = |height| {
        let lights = [Light::new(point(0.0, height, 0.0), number(1.0))];
        let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
        Picture::new(&scene, Size::new(3, 3)).pixel(1, 1, &mut TraceContext::new(())).lit_by
    };
    assert_eq!(lit_by(3.0), 1);
    assert_eq!(lit_by(7.0), 0);
}

#[test]
fn smooth_triangles_interpolate_their_normals() {
    // Corner normals lean outwards by the same angle: in the middle they add up to the flat one, at a corner the
    // corner's own counts.
    let around = [210.0_f64, 330.0, 90.0].map(|degrees| degrees.to_radians().sin_cos());
    let [a, b, c] = around.map(|(sine, cosine)| Vec3::new(2.0 * cosine, 2.0 * sine, 0.0));
    let triangle = Triangle::new(a, b, c).unwrap();
    let normals = [around.map(|(sine, cosine)| UnitVec3::new(Vec3::new(2.0 * cosine, 2.0 * sine, 1.0)).unwrap())];
    let objects = [Object::new(Shape::new(triangle), 0).smooth(0)];
    let materials = [Material::matte(Color::WHITE)];
    let lights = [Light::new(Vec3::new(0.0, 0.0, 1e6), 1.0)];
    let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap().with_normals(&normals).unwrap();
    let red = |x, y| {
        let ray = Ray::new(Vec3::new(x, y, 5.0), -UnitVec3::Z).unwrap();
        Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color.red
    };
    assert!((red(0.0, 0.0) - 1.0).abs() < 1e-9);
    assert!((red(0.0, 1.999_99) - 0.2_f64.sqrt()).abs() < 1e-4);
    assert!((red(a.x + 1e-5, a.y + 0.6e-5) - 0.2_f64.sqrt()).abs() < 1e-4);
    // Halfway between two corners their lean along the edge cancels: (0, -1, 1).
    assert!((red(0.0, -0.999_99) - 0.5_f64.sqrt()).abs() < 1e-4);
    // Near a silhouette a normal that leans away from the viewer still faces the lamp: no black rim.
    let ray = Ray::towards(Vec3::new(0.0, -5.0, 0.5), Vec3::new(0.0, 1.9, 0.0)).unwrap();
    assert!((Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color.red - 0.2_f64.sqrt()).abs() < 0.05);
    // From behind, the normals are turned to the viewer, and a lamp there shines.
    let lights = [Light::new(Vec3::new(0.0, 0.0, -1e6), 1.0)];
    let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap().with_normals(&normals).unwrap();
    let ray = Ray::new(Vec3::new(0.0, 0.0, -5.0), UnitVec3::Z).unwrap();
    assert!((Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color.red - 1.0).abs() < 1e-9);
}

#[test]
fn highlights_follow_phong() {
    // Eye, normal and lamp at 60 degrees from each other in a plane: the mirrored ray meets the eye at 60 degrees less
    // 60.
    let objects = [Object::new(Shape::new(Plane::new()), 0)];
    let cast = |material: Material<f64>, lamp: [f64; 3]| {
        let (materials, lights) = ([material], [Light::new(lamp.into(), 1.0)]);
        let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
        let ray = Ray::towards(Vec3::new(-3.0, 3.0, 0.0), Vec3::ZERO).unwrap();
        Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color.red
    };
    let black = Material { diffuse: 0.0, ..Material::matte(Color::WHITE) };
    assert!((cast(black.with_highlight(0.5, 10.0), [3.0, 3.0, 0.0]) - 0.5).abs() < 1e-12, "in the mirror direction");
    // From straight above, 45 degrees off the mirror direction.
    let expected = 0.5 * 0.5_f64.sqrt().powi(10);
    assert!((cast(black.with_highlight(0.5, 10.0), [0.0, 3.0, 0.0]) - expected).abs() < 1e-12);
    assert_eq!(cast(black.with_highlight(0.5, 10.0), [-3.0, 0.1, 0.0]), 0.0, "mirrored away from the eye");
    assert!((cast(Material::matte(Color::WHITE), [0.0, 3.0, 0.0]) - 1.0).abs() < 1e-12);
}

/// Every number of a material and of a lamp counts, each in its place: two that are 1 could change places unseen.
#[test]
fn scattered_light_has_the_colour_of_surface_and_lamp_and_a_highlight_that_of_the_lamp() {
    fn check<S: Scalar>() {
        let number = |value| S::from_f64(value).unwrap();
        let point = |x, y, z| Vec3::from_f64([x, y, z]).unwrap();
        let objects = [Object::new(Shape::new(Plane::new()), 0)];
        let material = Material { diffuse: number(0.5), ..Material::matte(Color::from_f64([1.0, 0.5, 0.25])) };
        let materials = [material.with_highlight(number(0.25), number(2.0))];
        let strength = [number(1.0), number(0.5), number(2.0)];
        let lights = [Light { position: point(0.0, 8.0, 0.0), strength, distant: false }];
        let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
        let ray = Ray::new(point(0.0, 4.0, 0.0), -UnitVec3::Y).unwrap();
        let color = Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color;
        assert_eq!(color, Color::from_f64([0.5 + 0.25, 0.5 * (0.25 + 0.25), 2.0 * (0.125 + 0.25)]));
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// Two rounded directions may have a cosine a hair above 1, of which a large power would make a glare.
#[test]
fn a_highlight_is_never_brighter_than_its_weight() {
    fn check<S: Scalar>(shine: f64) {
        let number = |value| S::from_f64(value).unwrap();
        let objects = [Object::new(Shape::new(Sphere::new(number(1.0)).unwrap()), 0)];
        let materials =
            [Material { diffuse: S::ZERO, ..Material::default() }.with_highlight(number(0.5), number(shine))];
        let mut brightest = Color::<S>::BLACK.red;
        for i in 0..200 {
            let (sine, cosine) = (f64::from(i) * 0.37).sin_cos();
            let eye = Vec3::from_f64([4.0 * cosine, f64::from(i) * 0.01, 4.0 * sine]).unwrap();
            let lights = [Light::new(eye, number(1.0))];
            let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
            let ray = Ray::towards(eye, Vec3::ZERO).unwrap();
            let red = Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color.red;
            brightest = if red > brightest { red } else { brightest };
        }
        let weight = Color::<S>::from_f64([0.5; 3]).red;
        assert_eq!(brightest, weight, "the lamp stands at the eye");
    }
    check::<f32>(1e6);
    check::<f64>(1e9);
    check::<I16F16>(30000.0);
    check::<I32F32>(1e9);
}

/// The lights that reach what is seen, a bit for each of the first 32, whatever is mirrored in it.
#[test]
fn a_pixel_tells_its_own_object_and_lights() {
    let above = Object::new(Shape::new(Sphere::new(1.0_f32).unwrap()).placed(lifted(4.0)), 1);
    let objects = [Object::new(Shape::new(Plane::new()), 0), above];
    let materials = [Material::matte(Color::WHITE).with_mirror(0.5), Material::matte(Color::WHITE)];
    // Even lamps shine on the floor, odd ones on the ball from above; none on the ball from below, where it is
    // mirrored.
    let light = |i| Light::new(if i % 2 == 0 { Vec3::new(5.0, 9.0, 0.0) } else { Vec3::new(0.0, 9.0, 0.0) }, 0.01);
    let look = |lights: &[Light<f32>]| {
        let scene = Scene::new(&objects, &materials, lights, camera()).unwrap();
        let ray = Ray::towards(Vec3::new(-0.2, 1.0, 0.0), Vec3::ZERO).unwrap();
        let sight = Tracer::new(&scene).look(&ray, &mut TraceContext::new(()));
        (sight.seen, sight.lit_by)
    };
    let floor = Some((0, Part::Side));
    let lights: Vec<_> = (0..34).map(light).collect();
    assert_eq!(look(&lights), (floor, 0x5555_5555));
    assert_eq!(look(&lights[1..]), (floor, 0xAAAA_AAAA));
    let last: Vec<_> = (0..33).map(|i| light(i32::from(i < 32))).collect();
    assert_eq!(look(&last), (floor, 0), "the 33rd has no bit");
}

fn lifted(height: f32) -> raylet::Frame<f32> {
    raylet::Frame::at(Vec3::new(0.0, height, 0.0)).unwrap()
}

/// What is brighter than white counts as white before samples are averaged, and an edge stays as soft as it is.
#[test]
fn an_edge_of_glaring_light_is_a_share_of_white() {
    let objects = [Object::new(Shape::new(Sphere::new(2.0_f32).unwrap()), 0)];
    let materials = [Material { diffuse: 0.0, ..Material::default() }];
    let scene = Scene::new(&objects, &materials, &[], camera()).unwrap().with_background(Color::from_f64([30.0; 3]));
    let mut soft = 0;
    Picture::new(&scene, Size::new(24, 18).with_samples(2)).render(|x, y, pixel| {
        let quarters = pixel.color.red * 4.0;
        assert!(quarters <= 4.0 && quarters == quarters.round(), "{x} {y}: {quarters}");
        soft += u32::from(quarters > 0.0 && quarters < 4.0);
    });
    assert!(soft > 10, "{soft}");
}

/// A column's number may be the largest that its type holds.
#[test]
fn a_picture_may_be_as_wide_as_can_be_said() {
    with_scaled::<f32, _>("v from 0 0 5 at 0 0 0 up 0 1 0 angle 40 resolution 8 6", Scale::ONE, |scene| {
        let mut last = (0, 0);
        Picture::new(scene, Size::new(65535, 1)).render(|x, y, _| last = (x, y));
        assert_eq!(last, (65534, 0));
        Picture::new(scene, Size::new(1, 65535)).render(|x, y, _| last = (x, y));
        assert_eq!(last, (0, 65534));
    });
}

#[test]
fn samples_are_averaged() {
    let coarse = render::<I16F16>(BALL, Size::new(12, 6).with_samples(2)).0;
    let fine = render::<I16F16>(BALL, Size::new(24, 12)).0;
    // The rays of a picture of half the size with 2 x 2 samples differ a little from those of the full size (the
    // angle runs between the centres of the outer rows), and so only the mean brightness is the same.
    let mean = |pixels: &[Pixel<I16F16>]| {
        pixels.iter().map(|pixel| f64::from(pixel.color.to_linear888()[0])).sum::<f64>() / pixels.len() as f64
    };
    assert!((mean(&coarse) - mean(&fine)).abs() < 8.0, "{} {}", mean(&coarse), mean(&fine));
    let (_, counters) = render::<I16F16>(BALL, Size::new(12, 6).with_samples(3));
    // Two corners for each edge of a row, and the grid where corners differ.
    assert!((1..12 * 6).contains(&counters.refined_pixels));
    assert_eq!(counters.primary_rays, 13 * 2 * 6 + 9 * counters.refined_pixels);
}

#[test]
fn scenes_with_wrong_indices_are_refused() {
    let objects = [Object::new(Shape::new(Plane::<f32>::new()), 1)];
    let materials = [Material::default()];
    let error = Scene::new(&objects, &materials, &[], camera()).err().unwrap();
    assert_eq!(error.to_string(), "object 0 names material 1, which is not in the list: add it");
    let objects = [Object::new(Shape::new(Plane::<f32>::new()), 0).smooth(2)];
    let scene = Scene::new(&objects, &materials, &[], camera()).unwrap();
    let error = scene.with_normals(&[]).err().unwrap();
    assert_eq!(error.to_string(), "object 0 names corner normals 2, which are not in the list: add them");
    let lights = [Light::new(Vec3::new(f32::NAN, 0.0, 0.0), 1.0)];
    let error = Scene::<f32>::new(&[], &materials, &lights, camera()).err().unwrap();
    assert_eq!(error.to_string(), "light 0 is beyond the number type's budget: move it closer");
}

/// The nearest of what each object says in the tier, and whether anything lies on the ray.
fn in_tier<S: Scalar, T: Tier<S>>(scene: &Scene<'_, S, T>, ray: &Ray<S>) {
    let hits = scene.objects().iter().filter_map(|object| object.shape.nearest_at::<T>(ray));
    let nearest = hits.min_by(|one, other| one.t.partial_cmp(&other.t).unwrap());
    let counters = &mut Counters::default();
    assert_eq!(scene.nearest(ray, counters).map(|on| on.hit.t), nearest.map(|hit| hit.t), "{ray:?}");
    assert_eq!(scene.occludes(ray, counters), nearest.is_some(), "{ray:?}");
}

#[test]
fn a_scene_meets_its_objects_in_its_own_tier() {
    fn check<S: Scalar>()
    where
        Exact: Tier<S>,
    {
        let stage = BuiltIn::StillLife.build::<S>().unwrap();
        let scene = stage.scene().unwrap();
        let (plain, fast, exact) = (scene.at_tier::<Plain>(), scene.at_tier::<Fast>(), scene.at_tier::<Exact>());
        let size = Size::new(16, 12);
        let raster = scene.camera().raster(size);
        for (x, y) in (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y))) {
            let ray = raster.ray([x, y], [0, 0]).unwrap();
            in_tier(&plain, &ray);
            in_tier(&fast, &ray);
            in_tier(&scene, &ray);
            in_tier(&exact, &ray);
        }
        let mut pictures = [vec![], vec![]];
        Picture::new(&scene, size).render(|_, _, pixel| pictures[0].push(pixel.color.to_srgb888()));
        Picture::new(&exact, size).render(|_, _, pixel| pictures[1].push(pixel.color.to_srgb888()));
        let differ = pictures[0].iter().zip(&pictures[1]).filter(|(stable, exact)| stable != exact).count();
        assert!(differ <= 2, "{differ} pixels differ");
    }
    check::<f32>();
    check::<I16F16>();
}
