//! The promise: an outline is a line around what is seen, and only where a scene has it.

use crate::effects::{matte, number, point, same_with, with_scene};
use fixed::types::{I16F16, I32F32};
use raylet::effect::{Antialiasing, Diffuse, Effect, EffectError, EffectSet, Fog, Outline, Shadows};
use raylet::{
    Camera, Capsule, Color, Cylinder, Frame, Material, Object, Part, Picture, Plane, Scalar, Scene, Shape, Size,
    Sphere, Triangle, Vec3, scene,
};

fn black<S: Scalar>() -> scene::Outline<S> {
    scene::Outline::new(Color::BLACK)
}

#[test]
fn an_outline_that_is_not_compiled_in_is_refused() {
    let size = Size::new(4, 3);
    with_scene::<f32, _>(matte(), true, None, |scene| {
        let outlined = scene.with_outline(black());
        assert_eq!(outlined.effects(), scene.effects().with(Effect::Outline));
        let error = Picture::<f32, (Diffuse, Shadows)>::try_new(&outlined, size).err();
        assert_eq!(error, Some(EffectError::Outline));
        assert_eq!(
            error.map(|error| (error.effect(), error.to_string())),
            Some((
                Effect::Outline,
                "the scene's outline calls for outline, which is not compiled in: name `Outline` among the effects"
                    .into()
            ))
        );
        // What an object needs is said first.
        let error = Picture::<f32, (Diffuse,)>::try_new(&outlined, size).err();
        assert_eq!(error, Some(EffectError::Object { effect: Effect::Shadows, object: 0 }));
        // A line without a width is none.
        assert_eq!(scene.with_outline(black().with_width(0)).effects(), scene.effects());
    });
}

#[test]
fn an_outline_does_the_same_whatever_else_is_compiled_in() {
    fn check<S: Scalar>() {
        let (once, twice) = (Size::new(40, 30), Size::new(20, 15).with_samples(2));
        with_scene::<S, _>(matte(), true, None, |scene| {
            let outlined = scene.with_outline(black());
            same_with::<S, (Diffuse, Shadows, Outline)>(&outlined, once);
            same_with::<S, (Outline, Antialiasing, Diffuse, Shadows)>(&outlined, twice);
            // It changes the colour of a pixel and nothing else of it, and of the others nothing.
            let (mut with, mut without, mut changed) = (vec![], vec![], 0);
            let counters = Picture::new(&outlined, once).render(|_, _, pixel| with.push(pixel));
            let before = Picture::new(scene, once).render(|_, _, pixel| without.push(pixel));
            for (with, without) in with.iter().zip(&without) {
                assert_eq!((with.seen, with.lit_by), (without.seen, without.lit_by));
                assert!(with.color == without.color || with.color == Color::BLACK);
                changed += u64::from(with.color != without.color);
            }
            assert!((60..300).contains(&changed), "{changed}");
            // The second ray is cast only where the first sees no edge.
            assert!((2 * 1200 - changed..2400).contains(&counters.outline_rays), "{counters:?}");
            assert_eq!(counters.rays(), before.rays() + counters.outline_rays);
        });
        let haze = scene::Fog::new(Color::WHITE, <S::Unit as raylet::scalar::UnitScalar>::from_f64(0.9));
        with_scene::<S, _>(matte(), true, Some(haze), |scene| {
            same_with::<S, (Diffuse, Shadows, Fog, Outline)>(&scene.with_outline(black()), once);
        });
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// White things before white: only the line is seen.
fn drawn<S: Scalar>(objects: &[Object<S>], camera: Camera<S>, size: Size, outline: scene::Outline<S>) -> Vec<String> {
    let materials = [Material::matte(Color::WHITE); 2];
    let scene = Scene::new(objects, &materials, &[], camera).unwrap().with_ambient(Color::WHITE);
    let scene = scene.with_background(Color::WHITE).with_outline(outline);
    assert_eq!(scene.effects(), EffectSet::of(Effect::Ambient).with(Effect::Outline));
    let mut rows = vec![String::new(); size.height.into()];
    Picture::new(&scene, size).render(|_, y, pixel| {
        rows[usize::from(y)].push(if pixel.color == Color::WHITE { '.' } else { '#' });
    });
    rows
}

fn at<S: Scalar>(x: f64, y: f64, z: f64) -> Frame<S> {
    Frame::at(point(x, y, z)).unwrap()
}

/// The line is on the left of a thing and above it, and is the last pixel of it on its right and below.
#[test]
fn a_ball_has_a_line_around_it_in_every_number_type() {
    fn check<S: Scalar>() {
        let camera = Camera::new(point(0.0, 0.0, 5.0), Vec3::ZERO, point(0.0, 1.0, 0.0), number(30.0)).unwrap();
        let ball = [Object::new(Shape::new(Sphere::new(number(1.0)).unwrap()), 0)];
        let size = Size::new(24, 14);
        assert_eq!(
            drawn::<S>(&ball, camera, size, black()),
            [
                "........................",
                "..........####..........",
                "........##...###........",
                ".......#.......#........",
                ".......#.......##.......",
                "......#.........#.......",
                "......#.........#.......",
                "......#.........#.......",
                "......##........#.......",
                ".......#.......#........",
                ".......###....##........",
                ".........#####..........",
                "........................",
                "........................",
            ]
        );
        let thick = drawn::<S>(&ball, camera, size, black().with_width(2));
        assert_eq!(thick[6], ".....##........##.......", "{thick:#?}");
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// How many pixels of a line lie between two things, each an object and a part: the pixel's own, and the one to the
/// right or below.
fn between<S: Scalar>(objects: &[Object<S>], [one, other]: [(u32, Part); 2]) -> [u32; 2] {
    let materials = [Material::matte(Color::WHITE); 2];
    let camera = Camera::new(point(0.3, 3.0, 7.0), point(0.0, 0.6, 0.0), point(0.0, 1.0, 0.0), number(30.0)).unwrap();
    let scene = Scene::new(objects, &materials, &[], camera).unwrap().with_ambient(Color::WHITE);
    let scene = scene.with_background(Color::WHITE).with_outline(black());
    let (mut pixels, size) = (vec![], Size::new(100, 60));
    Picture::new(&scene, size).render(|_, _, pixel| pixels.push(pixel));
    let (mut pairs, mut lines) = (0, 0);
    let width = usize::from(size.width);
    for (index, pixel) in pixels.iter().enumerate() {
        let beside = [Some(index + 1).filter(|next| next % width != 0), Some(index + width)];
        let seen: Vec<_> = beside.into_iter().flatten().filter_map(|index| pixels.get(index)?.seen).collect();
        let is_pair = |a, b| pixel.seen == Some(a) && seen.contains(&b) && seen.iter().all(|it| [a, b].contains(it));
        if is_pair(one, other) || is_pair(other, one) {
            pairs += 1;
            lines += u32::from(pixel.color == Color::BLACK);
        }
    }
    [pairs, lines]
}

/// A line is where a surface ends or bends, not where its description changes.
#[test]
fn a_line_is_where_a_surface_ends_or_bends() {
    fn check<S: Scalar>() {
        let triangle = |a: [f64; 3], b: [f64; 3], c: [f64; 3], material| {
            let [a, b, c] = [a, b, c].map(|corner| Vec3::from_f64(corner).unwrap());
            Object::new(Shape::new(Triangle::new(a, b, c).unwrap()), material)
        };
        let (lying, length) = Frame::between(point(1.6, 0.4, 0.0), point(2.6, 0.4, 0.8)).unwrap();
        let objects: [Object<S>; 8] = [
            // A little lower than the triangles, which would else lie in it.
            Object::new(Shape::new(Plane::new()).placed(at(0.0, -0.02, 0.0)), 0),
            Object::new(Shape::new(Cylinder::capped(number(0.7), number(1.4)).unwrap()).placed(at(-0.6, 0.0, 0.0)), 0),
            Object::new(Shape::new(Capsule::new(number(0.4), length).unwrap()).placed(lying), 0),
            // A square of two triangles, a leaf that bends by 45 degrees from it, and one of another material.
            triangle([0.0, 0.0, 3.0], [1.0, 0.0, 3.0], [1.0, 0.0, 2.0], 0),
            triangle([0.0, 0.0, 3.0], [1.0, 0.0, 2.0], [0.0, 0.0, 2.0], 0),
            triangle([0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.5, 0.5, 1.5], 0),
            triangle([1.0, 0.0, 3.0], [1.5, 0.0, 2.5], [1.0, 0.0, 2.0], 1),
            Object::new(Shape::new(Cylinder::open(number(0.8), number(1.4)).unwrap()).placed(at(-2.8, 0.0, 0.0)), 0),
        ];
        let all_or_none = |things: [(u32, Part); 2], expected: bool| {
            let [pairs, lines] = between(&objects, things);
            assert!(pairs >= 4 && lines == if expected { pairs } else { 0 }, "{things:?}: {lines} of {pairs}");
        };
        let side = |object| (object, Part::Side);
        all_or_none([side(0), side(1)], true);
        all_or_none([side(1), (1, Part::Top)], true);
        all_or_none([side(0), (1, Part::Top)], true);
        all_or_none([side(0), side(2)], true);
        all_or_none([side(2), (2, Part::Top)], false);
        all_or_none([side(3), side(4)], false);
        all_or_none([side(4), side(5)], true);
        all_or_none([side(3), side(6)], true);
        // The near rim of a tube before its own inside: one object, one part, and two sides of it.
        let camera = Camera::new(point(0.3, 3.0, 7.0), point(-2.8, 0.6, 0.0), point(0.0, 1.0, 0.0), number(20.0));
        let size = Size::new(41, 41);
        let rows = drawn(&objects[7..], camera.unwrap(), size, black());
        let middle: String = rows.iter().map(|row| char::from(row.as_bytes()[20])).collect();
        assert_eq!(middle.split('.').filter(|line| !line.is_empty()).count(), 3, "{rows:#?}");
    }
    check::<f32>();
    check::<I16F16>();
}
