//! The promise: many shapes in a hierarchy, without a scene, answer as a loop over their list does, to the bit.

use fixed::types::{I16F16, I32F32};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raylet::hierarchy::{Hierarchy, HierarchyError, Node, ShapeTree, Shapes};
use raylet::shape::kinds::All;
use raylet::{
    Departure, Exact, Fast, Frame, Hit, Leaving, Material, Part, Plain, Plane, Ray, Scalar, Scene, Shape, Shaped,
    Sphere, Stable, Tier, UnitVec3, Vec3,
};
use support::amount::amount;
use support::crowd;
use support::random::Random;

fn nodes_of<S: Scalar, X>(list: &[X]) -> Vec<Node<S>> {
    vec![Node::EMPTY; Hierarchy::<S>::nodes_for(list.len())]
}

/// The ray as the shape of this index sees it.
fn seen_by<S: Scalar>(index: usize, ray: &Ray<S>) -> Ray<S> {
    let departs = ray.departure().is_some_and(|departure| departure.object as usize == index);
    if departs { *ray } else { ray.without_departure() }
}

/// The answer of a loop: of equal hits the first.
fn looped<S: Scalar, T: Tier<S>>(list: &[Shape<S>], ray: &Ray<S>) -> Option<(u32, Hit<S>)> {
    let mut nearest: Option<(u32, Hit<S>)> = None;
    for (index, shape) in list.iter().enumerate() {
        if let Some(hit) = shape.nearest_at::<T>(&seen_by(index, ray))
            && nearest.is_none_or(|(_, best)| hit.t < best.t)
        {
            nearest = Some((index as u32, hit));
        }
    }
    nearest
}

fn agrees<S: Scalar, T: Tier<S>>(shapes: &Shapes<'_, S>, ray: &Ray<S>) -> Result<bool, TestCaseError> {
    let list = shapes.list();
    let expected = looped::<S, T>(list, ray);
    prop_assert_eq!(shapes.nearest_at::<T>(ray), expected, "nearest of {:?}", ray);
    let occludes = list.iter().enumerate().any(|(index, shape)| shape.occludes_at::<T>(&seen_by(index, ray)));
    prop_assert_eq!(shapes.occludes_at::<T>(ray), occludes, "occlusion of {:?}", ray);
    let mut listed = Vec::new();
    shapes.hits_at::<T>(ray, |index, hits| listed.push((index as usize, hits)));
    listed.sort_unstable_by_key(|(index, _)| *index);
    let all = list.iter().enumerate().map(|(index, shape)| (index, shape.hits_at::<T>(&seen_by(index, ray))));
    let some = all.filter(|(_, hits)| !hits.is_empty() || hits.starts_inside() || hits.coincident().is_some());
    prop_assert_eq!(listed, some.collect::<Vec<_>>(), "all hits of {:?}", ray);
    Ok(expected.is_some())
}

/// What a test of many lists has come across.
#[derive(Default)]
struct Met {
    hits: usize,
    departures: usize,
}

/// Whether a ray that a tier answers as a loop does was hit.
type Law<S> = fn(&Shapes<'_, S>, &Ray<S>) -> Result<bool, TestCaseError>;

/// A crowd, and some rays for it, in tiers.
fn any_list<S: Scalar>(seed: u64, count: usize, tiers: &[Law<S>]) -> Result<Met, TestCaseError> {
    let mut random = Random(seed);
    let objects = crowd::objects::<S>(count, &mut random);
    let list: Vec<_> = objects.iter().map(|object| object.shape).collect();
    let mut nodes = nodes_of(&list);
    let shapes = Shapes::new(&list, &mut nodes).expect("as many nodes as it needs");
    // One that owns the same shapes, after every one of them has moved.
    let mut moved = list.clone();
    moved.rotate_left(count / 3);
    let moved = heapless::Vec::<_, 50>::from_slice(&moved).expect("at most 49");
    let mut owned = ShapeTree::new(moved).expect("few");
    if seed & 1 == 0 {
        owned.change_all(|shapes| shapes.copy_from_slice(&list));
    } else {
        for (index, shape) in (0..).zip(&list) {
            owned.change(index, |own| *own = *shape);
        }
    }
    let materials = [Material::default()];
    let scene = Scene::new(&objects, &materials, &[], crowd::camera()).expect("a scene");
    let mut met = Met::default();
    for _ in 0..40 {
        let Some(ray) = crowd::ray(&objects, &scene, &mut random) else { continue };
        met.departures += usize::from(ray.departure().is_some());
        for tier in tiers {
            met.hits += usize::from(tier(&shapes, &ray)?);
            tier(&owned.view(), &ray)?;
        }
    }
    Ok(met)
}

fn of_three_types(seed: u64, count: usize) -> Result<[Met; 3], TestCaseError> {
    Ok([
        any_list::<f32>(
            seed,
            count,
            &[agrees::<_, Plain>, agrees::<_, Fast>, agrees::<_, Stable>, agrees::<_, Exact>],
        )?,
        any_list::<I16F16>(
            seed,
            count,
            &[agrees::<_, Plain>, agrees::<_, Fast>, agrees::<_, Stable>, agrees::<_, Exact>],
        )?,
        any_list::<I32F32>(seed, count, &[agrees::<_, Plain>, agrees::<_, Fast>, agrees::<_, Stable>])?,
    ])
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: amount(100, 6000),
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x7261_796c_6574),
        ..ProptestConfig::default()
    })]
    #[test]
    fn shapes_answer_as_a_loop_in_every_tier(seed in any::<u64>(), count in 0_usize..50) {
        of_three_types(seed, count)?;
    }
}

#[test]
fn the_rays_of_the_shapes_tests_hit_and_depart() {
    let (mut hits, mut departures) = (0, 0);
    for seed in 0..20 {
        for met in of_three_types(seed, 20).expect("the same answers") {
            (hits, departures) = (hits + met.hits, departures + met.departures);
        }
    }
    assert!(hits > 1500 && departures > 200, "{hits} hits, {departures} departures");
}

/// A range that ended at the nearest hit so far once had `Exact` round a hit next to it otherwise than without that
/// range.
#[test]
fn a_hit_is_rounded_in_the_same_way_whatever_was_hit_before() {
    of_three_types(4_861_983_009_410_030_165, 18).expect("the same answers");
}

fn balls(places: &[f32]) -> Vec<Shape<f32>> {
    let ball = Shape::new(Sphere::new(1.0).expect("a size"));
    places.iter().map(|x| ball.placed(Frame::at(Vec3::new(*x, 0.0, 0.0)).expect("near"))).collect()
}

#[test]
fn of_shapes_in_one_place_the_first_is_hit() {
    let list = balls(&[9.0, 0.0, 9.0, 0.0, 0.0]);
    let mut nodes = nodes_of(&list);
    let shapes = Shapes::new(&list, &mut nodes).expect("as many nodes as it needs");
    let down = Ray::new(Vec3::new(0.0, 5.0, 0.0), -UnitVec3::Y).expect("near");
    assert_eq!(shapes.nearest(&down).map(|(index, hit)| (index, hit.t)), Some((1, 4.0)));
    // A departure applies to the shape that it names, even beyond the last: then to none.
    let top = Ray::new(Vec3::new(0.0, 1.0, 0.0), UnitVec3::Y).expect("near");
    for (object, expected) in [(1, Some(3)), (3, Some(1)), (17, Some(1))] {
        let ray = top.departing(Departure { object, part: Part::Side, leaving: Leaving::Outwards });
        assert_eq!(shapes.nearest(&ray).map(|(index, _)| index), expected, "{object}");
    }
}

#[test]
fn no_shape_is_no_hit_and_too_few_nodes_are_refused() {
    let ray = Ray::new(Vec3::<f32>::ZERO, UnitVec3::X).expect("near");
    let none = Shapes::<f32>::new(&[], &mut []).expect("it needs no node");
    assert_eq!((none.nearest(&ray), none.occludes(&ray)), (None, false));
    let list = balls(&[1.0, 2.0, 3.0]);
    let error = Shapes::new(&list, &mut [Node::EMPTY; 4]).map(|_| ()).expect_err("it needs five");
    assert_eq!(error, HierarchyError::Storage { needed: 5, given: 4 });
    // More than it needs is fine.
    assert!(Shapes::new(&list, &mut [Node::EMPTY; 6]).is_ok());
}

/// A type of a program's own, and shapes of chosen kinds.
#[test]
fn whatever_has_a_shape_is_found() {
    struct Obstacle {
        name: &'static str,
        shape: Shape<f32>,
    }
    impl Shaped<f32> for Obstacle {
        type Kinds = All;
        fn shape(&self) -> &Shape<f32> {
            &self.shape
        }
    }
    let [near, far] = balls(&[3.0, 8.0])[..] else { unreachable!() };
    let list = [Obstacle { name: "far", shape: far }, Obstacle { name: "near", shape: near }];
    let mut nodes = nodes_of(&list);
    let shapes = Shapes::new(&list, &mut nodes).expect("as many nodes as it needs");
    let ray = Ray::new(Vec3::ZERO, UnitVec3::X).expect("near");
    let (index, hit) = shapes.nearest(&ray).expect("two of them");
    assert_eq!((shapes.list()[index as usize].name, hit.t), ("near", 2.0));

    type Few = (Sphere<f32>, Frame<f32>);
    let few = [far, near].map(|shape| shape.among::<Few>().expect("a ball in a frame"));
    let mut nodes = nodes_of(&few);
    let few = Shapes::new(&few, &mut nodes).expect("as many nodes as it needs");
    assert_eq!(few.nearest(&ray), Some((index, hit)));
}

/// A tree that owns its shapes answers as one that is made anew, whether they keep their boxes or not.
#[test]
fn shapes_that_moved_are_found_where_they_are() {
    let list: [Shape<f32>; 5] = balls(&[0.0, 4.0, 8.0, 12.0, 16.0]).try_into().expect("five");
    let mut tree = ShapeTree::new(list).expect("few");
    let down = |x: f32| Ray::new(Vec3::new(x, 5.0, 0.0), -UnitVec3::Y).expect("near");
    assert_eq!(tree.nearest(&down(8.0)).map(|(index, _)| index), Some(2));
    let old = tree.list()[2];
    tree.change(2, |ball| *ball = ball.placed(Frame::at(Vec3::new(40.0, 0.0, 0.0)).expect("near")));
    assert_eq!((tree.nearest(&down(8.0)), tree.nearest(&down(40.0)).map(|(index, _)| index)), (None, Some(2)));
    // A plane has no box: the tree is built anew; and once more as the ball comes back.
    tree.change(2, |ball| *ball = Shape::new(Plane::new()));
    assert_eq!(tree.nearest(&down(8.0)).map(|(index, hit)| (index, hit.t)), Some((2, 5.0)));
    assert_eq!(tree.nearest(&down(4.0)).map(|(index, hit)| (index, hit.t)), Some((1, 4.0)));
    assert!(tree.occludes(&down(-7.0)));
    tree.change(2, |ball| *ball = old);
    tree.change(5, |_| unreachable!("there are five"));
    assert_eq!((tree.nearest(&down(8.0)).map(|(index, _)| index), tree.occludes(&down(-7.0))), (Some(2), false));
    assert_eq!(tree.into_list(), list);
}

/// The lists that a tree owns: arrays, and lists that are not full.
#[test]
fn a_tree_owns_arrays_and_lists() {
    let [near, far] = balls(&[3.0, 8.0])[..] else { unreachable!() };
    let ray = Ray::new(Vec3::ZERO, UnitVec3::X).expect("near");
    let expected = near.nearest(&ray).map(|hit| (1, hit));
    assert_eq!(ShapeTree::new([far, near]).expect("few").nearest(&ray), expected);
    let mut list = heapless::Vec::<Shape<f32>, 5>::new();
    list.extend([far, near]);
    assert_eq!(ShapeTree::new(list).expect("few").nearest(&ray), expected);
    let none = ShapeTree::new(heapless::Vec::<Shape<f32>, 3>::new()).expect("few");
    assert_eq!((none.nearest(&ray), none.occludes(&ray)), (None, false));
}
