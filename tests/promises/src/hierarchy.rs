//! The promise: a hierarchy changes no bit of any answer, only how many tests an answer takes.

use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raylet::scene::{Hierarchy, HierarchyError, Node};
use raylet::{
    Color, Cone, Counters, Cylinder, Frame, Light, Material, Object, Picture, Pixel, Plane, Ray, Scalar, Scene, Shape,
    Size, Sphere, UnitVec3, Vec3,
};
use support::amount::amount;
use support::crowd;
use support::random::Random;

fn nodes_of<S: Scalar>(objects: &[Object<S>]) -> Vec<Node<S>> {
    vec![Node::EMPTY; Hierarchy::<S>::nodes_for(objects.len())]
}

/// The same scene without and with a hierarchy.
fn both<S: Scalar, T>(objects: &[Object<S>], then: impl FnOnce([&Scene<'_, S>; 2]) -> T) -> T {
    let materials = [Material::matte(Color::WHITE)];
    let scene = Scene::new(objects, &materials, &[], crowd::camera()).expect("a scene");
    let mut nodes = nodes_of(objects);
    let hierarchy = Hierarchy::build(objects, &mut nodes).expect("as many nodes as it needs");
    then([&scene, &scene.with_hierarchy(&hierarchy).expect("built for these objects")])
}

fn agree<S: Scalar>(plain: &Scene<'_, S>, boxed: &Scene<'_, S>, ray: &Ray<S>) -> Result<bool, TestCaseError> {
    let [nearest, same] = [plain, boxed].map(|scene| scene.nearest(ray, &mut Counters::default()));
    prop_assert_eq!(nearest, same, "nearest of {:?} in {:?}", ray, nearest.and_then(|on| plain.object(on.object)));
    let [occluded, same] = [plain, boxed].map(|scene| scene.occludes(ray, &mut Counters::default()));
    prop_assert_eq!(occluded, same, "occlusion of {:?}", ray);
    Ok(nearest.is_some())
}

/// A crowd, and some rays for it; the number of rays that met something.
fn any_scene<S: Scalar>(seed: u64, count: usize) -> Result<usize, TestCaseError> {
    let mut random = Random(seed);
    let objects = crowd::objects::<S>(count, &mut random);
    both(&objects, |[plain, boxed]| {
        let mut met = 0;
        for _ in 0..60 {
            let Some(ray) = crowd::ray(&objects, plain, &mut random) else { continue };
            met += usize::from(agree(plain, boxed, &ray)?);
        }
        Ok(met)
    })
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: amount(120, 6000),
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x7261_796c_6574),
        ..ProptestConfig::default()
    })]
    #[test]
    fn any_ray_gets_the_same_answers_in_any_scene(seed in any::<u64>(), count in 0_usize..40) {
        any_scene::<f32>(seed, count)?;
        any_scene::<f64>(seed, count)?;
        any_scene::<I16F16>(seed, count)?;
        any_scene::<I32F32>(seed, count)?;
        any_scene::<I8F24>(seed, count)?;
        any_scene::<I20F12>(seed, count)?;
    }
}

#[test]
fn the_rays_of_these_tests_meet_things() {
    let met: usize = (0..50).map(|seed| any_scene::<f32>(seed, 20).expect("the same answers")).sum();
    assert!((500..2_900).contains(&met), "{met} of 3000 rays");
}

/// Balls whose faces touch each other's boxes, and rays that touch both: the answer hangs on the last bit.
#[test]
fn rays_that_touch_a_ball_and_its_box_get_the_same_answers() {
    fn check<S: Scalar>() {
        let number = |value| S::from_f64(value).expect("in the type");
        let ball = Shape::new(Sphere::new(number(0.5)).expect("a size"));
        let mut objects = vec![];
        for i in 0..27 {
            let at = [i % 3, i / 3 % 3, i / 9].map(|i| number(f64::from(i) - 1.0));
            objects.push(Object::new(ball.placed(Frame::at(at.into()).expect("within the budget")), 0));
        }
        let mut met = 0;
        both(&objects, |[plain, boxed]| {
            for i in 0..9 * 9 {
                // Every half unit: through middles, along faces, and along edges of boxes.
                let [a, b] = [i % 9, i / 9].map(|i| number(f64::from(i) * 0.5 - 2.0));
                for (origin, along) in [
                    (Vec3::new(number(-4.0), a, b), UnitVec3::X),
                    (Vec3::new(a, number(4.0), b), -UnitVec3::Y),
                    (Vec3::new(a, b, number(-4.0)), UnitVec3::Z),
                    (Vec3::new(a, b, number(0.5)), UnitVec3::Z),
                    (Vec3::new(a, b, number(0.5)), UnitVec3::X),
                ] {
                    let ray = Ray::new(origin, along).expect("within the budget");
                    met += usize::from(agree(plain, boxed, &ray).expect("the same answers"));
                }
            }
        });
        assert!(met > 100, "{met} of 405 rays");
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// Where the side meets the top at an angle of 1 : 350, two ends round to one `t` up to 60 units beside the rim. A hit
/// there would be outside of the box, and so be lost among boxes only.
#[test]
fn beside_a_sharp_rim_there_is_no_hit() {
    let number = |value| I16F16::from_f64(value).expect("in the type");
    let along = [0.47599643, -0.8794472115, 0.0].map(raylet::scalar::Unit::<I16F16>::from_num::<f64>);
    let along = UnitVec3::from_components(along).expect("a unit vector");
    for top in [1.5491, 1.2, 0.8] {
        let dish = Cone::frustum(number(0.5), number(top), number(0.00298)).expect("sizes");
        let objects = [Object::new(Shape::new(dish), 0); 3];
        both(&objects, |[plain, boxed]| {
            for beside in 1..100 {
                let z = number(top) + I16F16::from_bits(beside);
                let ray = Ray::new(Vec3::new(number(0.00189), number(0.00298), z), along).expect("within the budget");
                assert!(!agree(plain, boxed, &ray).expect("the same answers"), "{beside} beside {top}");
            }
        });
    }
}

#[test]
fn of_two_objects_in_the_same_place_the_first_is_seen() {
    let ball = Object::new(Shape::new(Sphere::new(1.0_f32).expect("a size")), 0);
    let aside = Frame::at(Vec3::new(9.0, 0.0, 0.0)).expect("within the budget");
    let other = Object::new(ball.shape.placed(aside), 0);
    // A plane has no box: it is tested first, and is the same height as the ball.
    let floor = Frame::at(Vec3::new(0.0, 1.0, 0.0)).expect("within the budget");
    let plane = Object::new(Shape::new(Plane::new()).placed(floor), 0);
    let down = Ray::new(Vec3::new(0.0, 5.0, 0.0), -UnitVec3::Y).expect("within the budget");
    let seen = |objects: &[Object<f32>]| {
        both(objects, |scenes| scenes.map(|scene| scene.nearest(&down, &mut Counters::default()).map(|on| on.object)))
    };
    assert_eq!(seen(&[ball, other, ball, other, ball]), [Some(0); 2]);
    assert_eq!(seen(&[other, ball, other, ball, other]), [Some(1); 2]);
    assert_eq!(seen(&[other, ball, plane]), [Some(1); 2]);
    assert_eq!(seen(&[plane, other, ball]), [Some(0); 2]);
}

#[test]
fn no_object_one_and_two() {
    let ball = Object::new(Shape::new(Sphere::new(I16F16::from_num(1)).expect("a size")), 0);
    let plane = Object::new(Shape::new(Plane::<I16F16>::new()), 0);
    let pipe = Object::new(Shape::new(Cylinder::infinite(I16F16::from_num(1)).expect("a size")), 0);
    let nodes = [0, 1, 2, 3].map(Hierarchy::<I16F16>::nodes_for);
    assert_eq!(nodes, [0, 1, 3, 5]);
    let ray = Ray::towards(Vec3::from([3, 4, 5].map(I16F16::from_num)), Vec3::ZERO).expect("within the budget");
    let lists: [&[Object<I16F16>]; 7] =
        [&[], &[ball], &[plane], &[ball, ball], &[ball, plane], &[plane, pipe], &[pipe, ball]];
    for objects in lists {
        both(objects, |[plain, boxed]| {
            let met = agree(plain, boxed, &ray).expect("the same answers");
            assert_eq!(met, !objects.is_empty());
        });
    }
}

/// Rays, intersection tests and box tests of a picture.
fn cost<S: Scalar>(scene: &Scene<'_, S>, size: Size) -> (Vec<Pixel<S>>, [f64; 3]) {
    let mut pixels = vec![];
    let counters = Picture::new(scene, size).render(|_, _, pixel| pixels.push(pixel));
    (pixels, [counters.rays(), counters.intersection_tests, counters.box_tests].map(|count| count as f64))
}

/// The picture of a flake on a floor, without and with a hierarchy.
fn pictures<S: Scalar>(depth: u32) -> [(Vec<Pixel<S>>, [f64; 3]); 2] {
    let number = |value| S::from_f64(value).expect("in the type");
    let point = |x, y, z| Vec3::from_f64([x, y, z]).expect("in the type");
    let mut objects = crowd::flake(depth);
    let floor = Frame::at(point(0.0, -1.5, 0.0)).expect("within the budget");
    objects.push(Object::new(Shape::new(Plane::new()).placed(floor), 0));
    let materials = [Material::matte(Color::WHITE), Material::default().with_highlight(number(0.5), number(20.0))];
    let lights = [Light::new(point(5.0, 9.0, 7.0), number(0.6)), Light::new(point(-6.0, 5.0, 3.0), number(0.4))];
    let scene = Scene::new(&objects, &materials, &lights, crowd::camera()).expect("a scene");
    let mut nodes = nodes_of(&objects);
    let hierarchy = Hierarchy::build(&objects, &mut nodes).expect("as many nodes as it needs");
    let boxed = scene.with_hierarchy(&hierarchy).expect("built for these objects");
    [&scene, &boxed].map(|scene| cost(scene, Size::new(64, 48)))
}

#[test]
fn a_picture_is_the_same_to_the_bit() {
    fn check<S: Scalar>() {
        let [(plain, _), (boxed, _)] = pictures::<S>(2);
        assert!(plain == boxed, "the pictures differ");
        assert!(plain.iter().any(|pixel| pixel.seen.is_some_and(|(object, _)| object > 9)));
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

#[test]
fn a_hundred_times_the_objects_cost_a_few_times_the_tests() {
    let [[few, _], [many, plain]] = [1, 3].map(|depth| {
        let [(_, plain), (_, boxed)] = pictures::<f32>(depth);
        let a_ray = |[rays, tests, boxes]: [f64; 3]| [tests / rays, boxes / rays];
        [a_ray(boxed), a_ray(plain)]
    });
    println!("intersection and box tests a ray: 11 objects {few:?}, 821 {many:?}, without boxes {plain:?}");
    assert_eq!(plain[1], 0.0, "no boxes, no box tests");
    assert!(few[1] > 1.0 && many[1] > few[1], "{few:?} {many:?}");
    assert!(many[0] + many[1] < 4.0 * (few[0] + few[1]), "{few:?} {many:?}");
    assert!(many[0] + many[1] < plain[0] / 10.0, "{many:?} {plain:?}");
    // A ray that has met something tests no box behind it: else it is 1.349 and 10.58.
    assert!(many[0] < 1.34 && many[1] < 10.4, "{many:?}");
}

#[test]
fn too_little_storage_is_refused() {
    let objects = crowd::flake::<f32>(1);
    let mut nodes = [Node::EMPTY; 18];
    let error = Hierarchy::build(&objects, &mut nodes).expect_err("one too few");
    assert_eq!(error, HierarchyError::Storage { needed: 19, given: 18 });
    assert_eq!(
        error.to_string(),
        "the hierarchy needs 19 nodes, and has room for 18: give it Hierarchy::nodes_for(objects) of them"
    );
    assert_eq!(
        HierarchyError::TooManyObjects.to_string(),
        "a hierarchy holds at most 2^30 - 1 objects: divide the scene"
    );
}

#[test]
fn a_hierarchy_of_other_objects_is_refused() {
    let objects = crowd::flake::<f32>(1);
    let mut nodes = nodes_of(&objects);
    let hierarchy = Hierarchy::build(&objects, &mut nodes).expect("as many nodes as it needs");
    assert_eq!(hierarchy.objects(), 10);
    let materials = [Material::default(); 2];
    let refused = |objects: &[Object<f32>]| {
        let scene = Scene::new(objects, &materials, &[], crowd::camera()).expect("a scene");
        scene.with_hierarchy(&hierarchy).err().map(|error| error.to_string())
    };
    assert_eq!(refused(&objects), None);
    assert_eq!(
        refused(&objects[..9]).as_deref(),
        Some("the hierarchy was built for other objects (10) than the scene's (9): build it again from these")
    );
    // As many, but one has moved.
    let mut moved = objects.clone();
    let aside = Frame::at(Vec3::new(0.0, 0.25, 0.0)).expect("within the budget");
    moved[4] = Object::new(moved[4].shape.placed(aside), 0);
    assert!(refused(&moved).is_some());
    // What does not move a box is no other object.
    let mut painted = objects;
    painted[4].material = 0;
    assert_eq!(refused(&painted), None);
}
