//! The promise: only the effects that a scene calls for are at work, and one that is missing is refused.
#![expect(clippy::redundant_closure_for_method_calls, reason = "the path of the method would be of one lifetime")]

use fixed::types::{I16F16, I32F32};
use raylet::effect::{
    All, Antialiasing, Bump, Diffuse, Effect, EffectError, EffectSet, Effects, Fog, Reflection, Refraction, Shadows,
    Specular, Texture,
};
use raylet::scalar::UnitScalar;
use raylet::scene::{self, Coordinate, Observer, Waves};
use raylet::{
    Camera, Color, Counters, Cylinder, Frame, Light, Material, Object, Part, Picture, Pixel, Plane, Ray, Scalar, Scene,
    Shape, Size, Sphere, TraceContext, Tracer, UnitVec3, Vec3,
};

pub(crate) fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).unwrap()
}

pub(crate) fn point<S: Scalar>(x: f64, y: f64, z: f64) -> Vec3<S> {
    Vec3::from_f64([x, y, z]).unwrap()
}

fn camera<S: Scalar>() -> Camera<S> {
    Camera::new(point(0.3, 3.0, 9.0), point(0.0, 0.6, 0.0), point(0.0, 1.0, 0.0), number(30.0)).unwrap()
}

pub(crate) fn ball<S: Scalar>(x: f64, y: f64, z: f64, radius: f64, material: u32) -> Object<S> {
    let frame = Frame::at(point(x, y, z)).unwrap();
    Object::new(Shape::new(Sphere::new(number(radius)).unwrap()).placed(frame), material)
}

/// A floor and three balls, of which the first two have the material; a lamp if wanted.
pub(crate) fn with_scene<S: Scalar, T>(
    material: Material<S>,
    lamp: bool,
    fog: Option<scene::Fog<S>>,
    then: impl FnOnce(&Scene<'_, S>) -> T,
) -> T {
    let objects = [
        Object::new(Shape::new(Plane::new()), 0),
        ball(-1.2, 1.0, 0.0, 1.0, 1),
        ball(1.1, 0.8, 0.8, 0.8, 1),
        ball(0.2, 0.4, 2.2, 0.4, 0),
    ];
    let plain = if lamp { Material::matte(Color::from_f64([0.8, 0.7, 0.6])) } else { black() };
    let materials = [plain, material];
    let lights = [Light::new(point(-4.0, 7.0, 6.0), number(0.9))];
    let lights = if lamp { &lights[..] } else { &[] };
    let textures = [scene::Texture::Stripes {
        along: Coordinate::U,
        count: 6,
        colors: [Color::WHITE, Color::from_f64([0.2, 0.4, 0.9])],
    }];
    let scene = Scene::new(&objects, &materials, lights, camera()).unwrap();
    let scene = scene.with_background(Color::from_f64([0.2, 0.3, 0.5])).with_textures(&textures).unwrap();
    then(&fog.map_or(scene, |fog| scene.with_fog(fog)))
}

pub(crate) fn matte<S: Scalar>() -> Material<S> {
    Material::matte(Color::from_f64([0.9, 0.6, 0.3]))
}

fn black<S: Scalar>() -> Material<S> {
    Material { diffuse: S::ZERO, ..matte() }
}

fn haze<S: Scalar>() -> scene::Fog<S> {
    scene::Fog::new(Color::WHITE, S::Unit::from_f64(0.95))
}

#[test]
fn sets_hold_what_they_are_given() {
    let set = EffectSet::of(Effect::Fog).with(Effect::Diffuse).with(Effect::Fog);
    assert_eq!((set.len(), set.to_string()), (2, "diffuse, fog".to_owned()));
    assert_eq!(set.iter().collect::<Vec<_>>(), [Effect::Diffuse, Effect::Fog]);
    assert_eq!(set.without(Effect::Fog), EffectSet::of(Effect::Diffuse));
    assert_eq!(EffectSet::ALL.difference(set).len(), 9);
    assert_eq!(EffectSet::EMPTY.to_string(), "none");
    assert!(EffectSet::ALL.includes(set) && !set.includes(EffectSet::ALL));
    for effect in Effect::EVERY {
        assert_eq!(Effect::named(effect.name()), Some(effect));
        assert!(EffectSet::ALL.contains(effect) && !EffectSet::EMPTY.contains(effect));
    }
    assert_eq!(All::SET, Effect::EVERY.into_iter().collect());
    const { assert!(<(Fog, Diffuse)>::SET.contains(Effect::Fog) && !<(Fog, Diffuse)>::SET.contains(Effect::Bump)) };
}

/// The materials, one for each effect beyond shading, and what they call for.
fn callers() -> [(Material<f32>, EffectSet); 6] {
    let lit = EffectSet::of(Effect::Diffuse).with(Effect::Shadows);
    let waves = Waves { along_u: 3, along_v: 0, slope: 0.5 };
    [
        (matte(), lit),
        (matte().with_highlight(0.5, 20.0), lit.with(Effect::Specular)),
        (matte().with_mirror(0.3), lit.with(Effect::Reflection)),
        (matte().with_refraction(0.4, 1.5), lit.with(Effect::Refraction)),
        (matte().with_texture(0), lit.with(Effect::Texture)),
        (matte().with_bump(waves), lit.with(Effect::Bump)),
    ]
}

#[test]
fn scenes_say_what_they_call_for_and_objects_what_is_theirs() {
    for (material, expected) in callers() {
        with_scene(material, true, None, |scene| {
            assert_eq!(scene.effects(), expected);
            assert_eq!((scene.effects_of(1), scene.effects_of(3)), (expected, callers()[0].1));
            assert_eq!(scene.effects_of(4), EffectSet::EMPTY);
        });
    }
    let (shiny, _) = callers()[1];
    assert_eq!(with_scene(shiny, false, None, |scene| scene.effects()), EffectSet::EMPTY, "no lamp");
    assert_eq!(with_scene(black::<f32>(), false, Some(haze()), |scene| scene.effects()), EffectSet::of(Effect::Fog));
    let clear = scene::Fog::new(Color::WHITE, 1.0);
    assert_eq!(with_scene(black::<f32>(), false, Some(clear), |scene| scene.effects()), EffectSet::EMPTY, "clear air");
    for still in [Waves { along_u: 3, along_v: 3, slope: 0.0 }, Waves { along_u: 0, along_v: 0, slope: 0.5 }] {
        assert_eq!(with_scene(black::<f32>().with_bump(still), false, None, |scene| scene.effects()), EffectSet::EMPTY);
    }
    let highlights = EffectSet::of(Effect::Specular).with(Effect::Shadows);
    let shiny = black::<f32>().with_highlight(0.5, 20.0);
    assert_eq!(with_scene(shiny, true, None, |scene| scene.effects_of(1)), highlights, "highlights alone");
    // A lamp of any colour is a lamp.
    let floor = [Object::new(Shape::new(Plane::new()), 0)];
    for strength in [[0.5_f32, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]] {
        let (materials, lights) = ([matte()], [Light { position: point(0.0, 5.0, 0.0), strength, distant: false }]);
        assert_eq!(
            Scene::new(&floor, &materials, &lights, camera()).unwrap().effects(),
            callers()[0].1,
            "{strength:?}"
        );
    }
    // The material of a cap counts too.
    let objects = [Object::new(Shape::new(Cylinder::capped(1.0_f32, 1.0).unwrap()), 0).with_top(1)];
    let scene_materials = [black(), black().with_mirror(0.5)];
    let scene = Scene::new(&objects, &scene_materials, &[], camera()).unwrap();
    assert_eq!(scene.effects(), EffectSet::of(Effect::Reflection));
}

#[test]
fn a_missing_effect_is_refused_by_name_and_object() {
    type Lit = (Diffuse, Shadows);
    let size = Size::new(4, 3);
    let refused =
        |material| with_scene::<f32, _>(material, true, None, |scene| Picture::<f32, Lit>::try_new(scene, size).err());
    for (material, calls) in callers() {
        let missing = calls.difference(Lit::SET).iter().next();
        let expected = missing.map(|effect| EffectError::Object { effect, object: 1 });
        assert_eq!(refused(material), expected);
    }
    let several = matte().with_refraction(0.4, 1.5).with_mirror(0.3).with_texture(0);
    assert_eq!(refused(several), Some(EffectError::Object { effect: Effect::Reflection, object: 1 }), "the first");
    assert_eq!(
        refused(matte().with_refraction(0.4, 1.5)).unwrap().to_string(),
        "object 1 calls for refraction, which is not compiled in: name `Refraction` among the effects"
    );
    with_scene::<f32, _>(matte(), true, Some(haze()), |scene| {
        let error = |error: EffectError| (error.effect(), error.to_string());
        let (effect, text) = error(Picture::<f32, (Diffuse,)>::try_new(scene, size).err().unwrap());
        assert_eq!(effect, Effect::Shadows);
        assert!(text.starts_with("object 0 calls for shadows"), "{text}");
        let (_, text) = error(Picture::<f32, Lit>::try_new(scene, size).err().unwrap());
        assert_eq!(text, "the scene's fog calls for fog, which is not compiled in: name `Fog` among the effects");
        let many = size.with_samples(3);
        let (_, text) = error(Picture::<f32, (Diffuse, Shadows, Fog)>::try_new(scene, many).err().unwrap());
        assert!(text.starts_with("the size of 3 x 3 samples a pixel calls for antialiasing, which"), "{text}");
        assert!(Picture::<f32, (Diffuse, Shadows, Fog, Antialiasing)>::try_new(scene, many).is_ok());
    });
}

fn render<S: Scalar, E: Effects>(picture: &Picture<'_, S, E>) -> (Vec<Pixel<S>>, Counters) {
    let mut pixels = Vec::new();
    let counters = picture.render(|_, _, pixel| pixels.push(pixel));
    (pixels, counters)
}

/// The work of each effect that counts its own.
fn work_of(counters: &Counters) -> [(Effect, u64); 8] {
    [
        (Effect::Shadows, counters.shadow_rays),
        (Effect::Reflection, counters.reflection_rays),
        (Effect::Refraction, counters.refraction_rays),
        (Effect::Texture, counters.texture_lookups),
        (Effect::Bump, counters.bumps),
        (Effect::Fog, counters.fogged_rays),
        (Effect::Antialiasing, counters.refined_pixels),
        (Effect::Outline, counters.outline_rays),
    ]
}

/// Compiled with all effects or with those called for: the same bits and the same work, and none for the others.
pub(crate) fn same_with<S: Scalar, E: Effects>(scene: &Scene<'_, S>, size: Size) {
    let small = Picture::<S, E>::try_new(scene, size).unwrap();
    let (pixels, counters) = render(&small);
    let (all_pixels, all_counters) = render(&Picture::new(scene, size));
    assert!(pixels == all_pixels, "{}", E::SET);
    assert_eq!(counters, all_counters);
    assert_eq!(small.effects(), E::SET);
    for (effect, count) in work_of(&counters) {
        assert_eq!(count > 0, E::SET.contains(effect), "{effect}: {count}, of {}", E::SET);
    }
}

#[test]
fn what_is_not_called_for_does_no_work_and_changes_no_bit() {
    fn check<S: Scalar>() {
        let (once, twice) = (Size::new(40, 30), Size::new(20, 15).with_samples(2));
        let half = number::<S>(0.5);
        let waves = Waves { along_u: 9, along_v: 5, slope: half };
        let glass = |material: Material<S>| material.with_refraction(half, number(1.5));
        with_scene(black(), false, None, |scene| same_with::<S, ()>(scene, once));
        with_scene(matte(), true, None, |scene| same_with::<S, (Diffuse, Shadows)>(scene, once));
        with_scene(matte().with_highlight(half, number(20.0)), true, None, |scene| {
            same_with::<S, (Shadows, Specular, Diffuse)>(scene, once);
        });
        with_scene(black().with_mirror(half), false, None, |scene| same_with::<S, (Reflection,)>(scene, once));
        with_scene(glass(black()), false, None, |scene| same_with::<S, (Refraction,)>(scene, once));
        with_scene(glass(matte().with_mirror(half)), true, None, |scene| {
            same_with::<S, (Diffuse, Shadows, Reflection, Refraction)>(scene, once);
        });
        with_scene(matte().with_texture(0), true, None, |scene| {
            same_with::<S, (Diffuse, Shadows, Texture)>(scene, once);
        });
        with_scene(matte().with_bump(waves), true, None, |scene| same_with::<S, (Diffuse, Shadows, Bump)>(scene, once));
        with_scene(black(), false, Some(haze()), |scene| same_with::<S, (Fog,)>(scene, once));
        with_scene(matte(), true, None, |scene| same_with::<S, (Diffuse, Shadows, Antialiasing)>(scene, twice));
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

#[test]
fn what_is_left_off_does_no_work() {
    let material = Material::matte(Color::<f32>::WHITE).with_highlight(0.3, 20.0).with_mirror(0.3).with_texture(0);
    let waves = Waves { along_u: 3, along_v: 0, slope: 0.5 };
    let material = material.with_refraction(0.3, 1.5).with_bump(waves);
    with_scene(material, true, Some(haze()), |scene| {
        let outline = scene::Outline::new(Color::from_f64([0.9, 0.1, 0.5]));
        let scene = &scene.with_ambient(Color::from_f64([0.1; 3])).with_outline(outline);
        let picture = Picture::new(scene, Size::new(24, 18).with_samples(2));
        assert_eq!(picture.effects(), EffectSet::ALL);
        let (whole, counters) = render(&picture);
        for (effect, count) in work_of(&counters) {
            assert!(count > 0, "{effect}");
        }
        for effect in Effect::EVERY {
            let without = picture.only(EffectSet::ALL.without(effect));
            let (pixels, counters) = render(&without);
            assert!(pixels != whole, "{effect} can be seen");
            assert!(!without.effects().contains(effect));
            for (other, count) in work_of(&counters) {
                assert!(other != effect || count == 0, "{effect}: {count}");
            }
        }
        // Left out of the program or at run time, knowingly, is the same.
        let knowingly = Picture::<f32, (Diffuse, Reflection)>::leaving_out(scene, Size::new(24, 18).with_samples(2));
        let set = EffectSet::of(Effect::Diffuse).with(Effect::Reflection);
        assert!(render(&knowingly) == render(&picture.only(set)));
    });
}

#[test]
fn shadow_tests_compute_no_normal_and_unlit_black_things_none_at_all() {
    with_scene::<f32, _>(matte(), true, None, |scene| {
        let (pixels, counters) = render(&Picture::new(scene, Size::new(40, 30)));
        let hits = pixels.iter().filter(|pixel| pixel.seen.is_some()).count() as u64;
        assert!(pixels.iter().any(|pixel| pixel.seen.is_some() && pixel.lit_by == 0), "something is shadowed");
        assert_eq!(counters.hits_refined, hits);
    });
    with_scene::<f32, _>(black(), false, None, |scene| {
        assert_eq!(render(&Picture::new(scene, Size::new(40, 30))).1.hits_refined, 0);
    });
}

#[test]
fn the_memory_of_shadows_saves_tests_and_changes_no_bit() {
    fn check<S: Scalar>() {
        with_scene::<S, _>(matte(), true, None, |scene| {
            let picture = Picture::new(scene, Size::new(40, 30));
            let (mut with, mut without) = (TraceContext::new(()), TraceContext::new(()));
            for y in 0..30 {
                let row: Vec<_> = picture.row(y, &mut with).collect();
                let apart: Vec<_> = (0..40)
                    .map(|x| {
                        without.forget();
                        picture.pixel(x, y, &mut without)
                    })
                    .collect();
                assert!(row == apart, "row {y}");
            }
            assert_eq!(with.counters.shadow_rays, without.counters.shadow_rays);
            assert!(with.counters.intersection_tests < without.counters.intersection_tests);
            // Rows cost the same in whatever order they are traced.
            let mut backwards = TraceContext::new(());
            (0..30).rev().for_each(|y| picture.row(y, &mut backwards).for_each(drop));
            assert_eq!(with.counters, backwards.counters);
            // And after a row that was left in the middle of a shadow.
            let mut other = TraceContext::new(());
            picture.row(20, &mut other).for_each(drop);
            let alone = other.counters;
            let mut shadowed = 0;
            for x in 0..40 {
                let mut left = TraceContext::new(());
                let last = picture.row(20, &mut left).nth(x).unwrap();
                shadowed += u32::from(last.seen.is_some() && last.lit_by == 0);
                left.counters = Counters::default();
                picture.row(20, &mut left).for_each(drop);
                assert_eq!(left.counters, alone, "left at {x}");
            }
            assert!(shadowed > 0);
        });
    }
    check::<f32>();
    check::<I16F16>();
}

#[test]
fn an_observer_hears_of_every_test() {
    #[derive(Default)]
    struct Heard([u64; 4], u64);
    impl Observer for Heard {
        fn tested(&mut self, object: u32, found: bool) {
            self.0[object as usize] += 1;
            self.1 += u64::from(found);
        }
    }
    with_scene::<f32, _>(matte().with_mirror(0.5), true, None, |scene| {
        let picture = Picture::new(scene, Size::new(16, 12));
        let mut context = TraceContext::new(Heard::default());
        (0..12).for_each(|y| picture.row(y, &mut context).for_each(drop));
        assert_eq!(context.observer.0.iter().sum::<u64>(), context.counters.intersection_tests);
        assert!(context.observer.0.iter().all(|tests| *tests > 0) && context.observer.1 > 0);
        assert_eq!(context.counters, render(&picture).1);
        // Whether the first ball stands over the floor, too.
        let (mut heard, up) = (Heard::default(), Ray::new(point(-1.2, 0.0, 0.0), UnitVec3::Y).unwrap());
        assert!(scene.stands_on(1, &up, &mut Counters::default(), &mut heard));
        assert!(!scene.stands_on(2, &up, &mut Counters::default(), &mut heard));
        assert_eq!((heard.0, heard.1), ([0, 1, 1, 0], 1));
    });
}

#[test]
fn counters_add_up_each_by_itself() {
    // A bit for each, so that no two can be mistaken for each other.
    let bits = |low: u64| {
        let mut counters = Counters::default();
        counters.primary_rays = low;
        counters.shadow_rays = low << 1;
        counters.intersection_tests = low << 2;
        counters.box_tests = low << 3;
        counters.hits_refined = low << 4;
        counters.reflection_rays = low << 5;
        counters.refraction_rays = low << 6;
        counters.texture_lookups = low << 7;
        counters.bumps = low << 8;
        counters.fogged_rays = low << 9;
        counters.refined_pixels = low << 10;
        counters
    };
    let mut sum = bits(1);
    sum.add(&bits(1));
    assert_eq!(sum, bits(2));
    assert_eq!(sum.rays(), 2 * (0b11 + 0b110_0000), "from the eye, to lamps, reflected and refracted");
}

#[test]
fn parts_have_materials_of_their_own() {
    let can = Object::new(Shape::new(Cylinder::capped(1.0_f64, 2.0).unwrap()), 0).with_base(1).with_top(2);
    let colors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let (objects, materials) = ([can], colors.map(|color| Material::matte(Color::from_f64(color))));
    for (from, to, part) in [
        ([0.0, 1.0, 5.0], -UnitVec3::Z, Part::Side),
        ([0.0, -5.0, 0.0], UnitVec3::Y, Part::Base),
        ([0.0, 5.0, 0.0], -UnitVec3::Y, Part::Top),
    ] {
        let lights = [Light::new(from.into(), 1.0)];
        let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
        let sight = Tracer::new(&scene).look(&Ray::new(from.into(), to).unwrap(), &mut TraceContext::new(()));
        assert_eq!((sight.seen, sight.color.to_array()), (Some((0, part)), colors[can.material_of(part) as usize]));
    }
    let error = Scene::new(&[can.with_top(3)], &materials, &[], camera()).err().unwrap();
    assert_eq!(error.to_string(), "object 0 names material 3, which is not in the list: add it");
}

#[test]
fn textures_that_cannot_be_used_are_refused() {
    let materials = [Material::matte(Color::<f32>::WHITE).with_texture(1)];
    let scene = Scene::<f32>::new(&[], &materials, &[], camera()).unwrap();
    let pixels = [[0; 3]; 5];
    let image = |width, height| scene::Texture::Image { width, height, pixels: &pixels };
    let error = |textures: &[scene::Texture<'_, f32>]| scene.with_textures(textures).err().unwrap().to_string();
    assert_eq!(error(&[image(5, 1)]), "material 0 names texture 1, which is not in the list: add it");
    assert_eq!(error(&[image(5, 1), image(2, 3)]), "texture 1 cannot be used: its width and height call for 6 pixels");
    let colors = [Color::WHITE; 2];
    let checker = |columns, rows| scene::Texture::Checker { columns, rows, colors };
    let stripes = |count| scene::Texture::Stripes { along: Coordinate::U, count, colors };
    for empty in [checker(0, 1), checker(1, 0), stripes(0), image(0, 5), image(5, 0)] {
        assert!(error(&[empty]).starts_with("texture 0 cannot be used: its counts"), "{empty:?}");
    }
    assert_eq!(error(&[image(0, 0)]), "texture 0 cannot be used: its counts, width and height must be at least 1");
    assert!(scene.with_textures(&[image(5, 1), image(1, 5)]).is_ok());
}
