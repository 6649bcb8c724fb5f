//! The nearest crossing and occlusion agree with the list of crossings; a tree with a slice; starts with what they say.

use crate::crowd::{Crowd, Of};
use fixed::types::I16F16;
use raylet::hierarchy::{Hierarchy, Node, Shapes};
use raylet::solids::{self, Crossings, SolidSet, Start};
use raylet::{
    Crossing, Departure, Exact as ExactTier, Leaving, Part, Plain, Range, Ray, Shape, Sphere, Stable, Tier, UnitVec3,
    Vec3, Visible,
};
use support::amount::times;
use support::exact_types::Exact;
use support::random::Random;

type List<S> = Crossings<S, 32>;

/// The first crossing of the list that is seen.
fn agrees<S: Exact, T: Tier<S>>(shapes: &[Shape<S>], ray: &Ray<S>, start: &Start) {
    let told = || format!("{ray:?} {start:?}\n{shapes:#?}");
    let list = List::with_start::<T>(shapes, ray, start).expect("it has room");
    let seen = |solid: u32, crossing| match shapes[solid as usize].visible() {
        Visible::Both => true,
        Visible::Outside => crossing != Crossing::Exit,
        Visible::Inside => crossing != Crossing::Enter,
    };
    let first = list.iter().find(|crossing| seen(crossing.solid, crossing.hit.crossing)).map(|c| (c.solid, c.hit));
    assert_eq!(solids::nearest::<S, T, 1>(shapes, ray, start), first, "{}", told());
    assert_eq!(solids::occludes::<S, T, 1>(shapes, ray, start), first.is_some(), "{}", told());

    let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(shapes.len())];
    let tree = Shapes::new(shapes, &mut nodes).expect("it has room");
    assert_eq!(List::with_start::<T>(&tree, ray, start).expect("it has room"), list, "{}", told());
    assert_eq!(solids::nearest::<S, T, 1>(&tree, ray, start), first, "{}", told());
}

fn queries_agree<S: Exact, T: Tier<S>>() {
    let mut random = Random(0x6a09_e667_f3bc_c908);
    for _ in 0..times(1_000) {
        let mut crowd = Crowd::<S>::random(&mut random, Of::Others);
        for shape in &mut crowd.shapes {
            *shape = shape.seen_from(random.pick(&[Visible::Both, Visible::Both, Visible::Outside, Visible::Inside]));
        }
        for _ in 0..5 {
            let Some(ray) = crowd.ray(&mut random) else { continue };
            let left_out = SolidSet::EMPTY.with(random.below(8) as u32);
            agrees::<S, T>(&crowd.shapes, &ray, &Start::new().leaving_out(left_out));
            let list = List::with_start::<T>(crowd.shapes.as_slice(), &ray, &Start::new()).expect("it has room");
            let Some(first) = list.iter().next() else { continue };
            let Ok(onwards) = Ray::new(ray.at(first.hit.t), ray.direction()) else { continue };
            agrees::<S, T>(&crowd.shapes, &onwards, &list.start_across(0).expect("fewer than nine"));
            let Ok(back) = Ray::new(ray.at(first.hit.t), -ray.direction()) else { continue };
            agrees::<S, T>(&crowd.shapes, &back, &list.start_before(0).expect("fewer than nine"));
        }
    }
}

#[test]
fn queries_agree_with_the_list() {
    queries_agree::<f32, Plain>();
    queries_agree::<f32, Stable>();
    queries_agree::<f32, ExactTier>();
    queries_agree::<I16F16, Stable>();
}

/// A segment to a point that was just seen, from the point that saw it.
fn seen_points<S: Exact, T: Tier<S>>() {
    let mut random = Random(0xbb67_ae85_84ca_a73b);
    let (mut segments, mut hidden_without) = (0, 0);
    for _ in 0..times(2_000) {
        let crowd = Crowd::<S>::random(&mut random, Of::Others);
        let Some(ray) = crowd.ray(&mut random) else { continue };
        let start = Start::<1>::new();
        let Some((solid, hit)) = solids::nearest::<S, T, 1>(crowd.shapes.as_slice(), &ray, &start) else { continue };
        let shape = &crowd.shapes[solid as usize];
        // Chords of rounding errors aside.
        let chord = shape.hits_at::<T>(&ray).iter().map(|hit| hit.t.to_f64()).reduce(|a, b| b - a);
        if hit.crossing == Crossing::Touch || chord.is_none_or(|chord| chord < 0.05) || hit.t.to_f64() < 0.05 {
            continue;
        }
        let surface = shape.surface(&ray, &hit);
        let Ok(segment) = Ray::segment(ray.origin(), surface.point()) else { continue };
        let leaving = if hit.crossing == Crossing::Enter { Leaving::Outwards } else { Leaving::Inwards };
        let others =
            (0..crowd.shapes.len() as u32).filter(|other| *other != solid).fold(SolidSet::EMPTY, SolidSet::with);
        let alone = Start::new().leaving_out(others);
        segments += 1;
        hidden_without += usize::from(solids::occludes::<S, T, 1>(crowd.shapes.as_slice(), &segment, &alone));
        let arriving = alone.arriving(surface.departure(solid, leaving));
        assert!(!solids::occludes::<S, T, 1>(crowd.shapes.as_slice(), &segment, &arriving), "{ray:?}\n{shape:#?}");
    }
    println!("{}: {segments} segments, {hidden_without} hidden by their own surface without arrival", S::name());
    assert!(segments > 300 && hidden_without * 5 > segments);
}

#[test]
fn a_seen_point_is_not_hidden_by_its_own_surface() {
    seen_points::<f32, Stable>();
    seen_points::<f32, ExactTier>();
    seen_points::<I16F16, Stable>();
}

/// Arrival excuses the crossing at the end alone.
#[test]
fn what_stands_before_the_end_occludes() {
    let ball = Shape::new(Sphere::new(1.0_f32).unwrap());
    let inner = Shape::new(Sphere::new(0.5_f32).unwrap());
    let across = Ray::segment(Vec3::new(-3.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0)).unwrap();
    let at = |object, leaving| Departure { object, part: Part::Side, leaving };
    let occludes = |balls: &[Shape<f32>], start: Start| solids::occludes::<f32, Stable, 1>(balls, &across, &start);
    // It arrives at the far side, from inside: it has entered on the way.
    assert!(occludes(&[ball], Start::new().arriving(at(0, Leaving::Inwards))));
    // From inside of the ball that is so, not otherwise.
    let inside = Start::inside_of(SolidSet::EMPTY.with(0));
    let from_middle = Ray::segment(Vec3::ZERO, Vec3::new(1.0, 0.0, 0.0)).unwrap();
    let arrives = inside.clone().arriving(at(0, Leaving::Inwards));
    assert!(!solids::occludes::<f32, Stable, 1>(&[ball], &from_middle, &arrives));
    // Another solid is excused nothing.
    assert!(solids::occludes::<f32, Stable, 1>(&[ball, inner], &from_middle, &arrives));
}

/// What is known outweighs coordinates, and a departure what is known of its solid.
#[test]
fn what_is_known_outweighs_coordinates() {
    let ball = [Shape::new(Sphere::new(1.0_f32).unwrap())];
    let ray = |x: f32| Ray::new(Vec3::new(x, 0.0, 0.0), UnitVec3::X).unwrap();
    let list = |x: f32, start: &Start| {
        let list = List::with_start::<Stable>(&ball, &ray(x), start).unwrap();
        (list.inside().len(), list.iter().map(|c| (c.hit.t, c.hit.crossing)).collect::<Vec<_>>())
    };
    let inside = Start::inside_of(SolidSet::EMPTY.with(0));
    let outside = Start::inside_of(SolidSet::EMPTY);
    // A little before the entry and behind the exit.
    assert_eq!(list(-1.0625, &inside), (1, vec![(2.0625, Crossing::Exit)]));
    assert_eq!(list(1.0625, &inside), (1, vec![(0.0, Crossing::Exit)]));
    // A little behind the entry and before the exit.
    assert_eq!(list(-0.9375, &outside), (0, vec![(0.0, Crossing::Enter), (1.9375, Crossing::Exit)]));
    assert_eq!(list(0.9375, &outside), (0, vec![]));
    // In the middle nothing contradicts.
    assert_eq!(list(0.0, &inside), (1, vec![(1.0, Crossing::Exit)]));
    let departs = |leaving| Departure { object: 0, part: Part::Side, leaving };
    let inwards = outside.clone().departing(departs(Leaving::Inwards)).unwrap();
    assert_eq!(list(-1.0, &inwards), (1, vec![(2.0, Crossing::Exit)]));
    let outwards = inside.clone().departing(departs(Leaving::Outwards)).unwrap();
    assert_eq!(list(1.0, &outwards), (0, vec![]));
    // A solid that is not seen is in no set.
    let unseen = inside.leaving_out(SolidSet::EMPTY.with(0));
    assert_eq!(list(0.0, &unseen), (0, vec![]));
    // Of a range that begins before the origin too.
    let line = ray(0.0).with_range(Range::line());
    let both = List::of(&ball, &line).unwrap();
    assert_eq!(both.iter().map(|c| c.hit.t).collect::<Vec<_>>(), [-1.0, 1.0]);
}
