//! Rays that are followed from crossing to crossing by their starts.

use crate::crowd::{Crowd, Of};
use fixed::types::{I16F16, I32F32};
use raylet::solids::{Crossings, Start};
use raylet::{Crossing, Exact as ExactTier, Fast, Plain, Ray, Shape, Stable, Tier, Vec3};
use support::amount::amount;
use support::exact_types::Exact;
use support::random::{Random, add, cross, scale};

type List<S> = Crossings<S, 32>;

/// The crossings that a ray meets one after the other: each time from the point of the last, with the start that it
/// gives.
fn followed<S: Exact, T: Tier<S>>(shapes: &[Shape<S>], ray: &Ray<S>) -> Option<Vec<(u32, Crossing)>> {
    let (mut ray, mut start, mut met) = (*ray, Start::new(), vec![]);
    for _ in 0..64 {
        let crossings = List::with_start::<T>(shapes, &ray, &start).expect("it has room");
        let Some(first) = crossings.iter().next() else { return Some(met) };
        met.extend(crossings.iter().filter(|c| c.hit.t == first.hit.t).map(|c| (c.solid, c.hit.crossing)));
        start = crossings.start_across(0).expect("fewer than nine solids");
        // A point beyond the type ends the path.
        ray = Ray::new(ray.at(first.hit.t), ray.direction()).ok()?;
    }
    panic!("the ray goes on and on: {ray:?}\n{shapes:#?}\n{met:?}");
}

/// What went wrong on the way.
#[derive(Debug, Default, PartialEq)]
struct Wrong {
    lost: usize,
    twice: usize,
    unpaired: usize,
}

/// True if rounding of the path's points cannot decide whether the solid is hit: if rays beside it meet the solid in a
/// chord of some length, too, and the middle of the ray's own chord is as deep inside. (That of a ray in the side of a
/// hyperboloid is not.)
fn is_surely_hit<S: Exact, T: Tier<S>>(shape: &Shape<S>, ray: &Ray<S>, random: &mut Random) -> bool {
    let across = random.perpendicular(ray.direction().to_f64());
    let is_deep = match &shape.hits_at::<T>(ray)[..] {
        [enter, exit] => {
            let middle = ray.at(enter.t.plus(exit.t.minus(enter.t).scaled(-1))).to_f64();
            let around = [across, cross(across, ray.direction().to_f64())];
            around
                .into_iter()
                .flat_map(|across| [0.01, -0.01].map(|shift| add(middle, scale(across, shift))))
                .all(|point| Vec3::from_f64(point).is_ok_and(|point| shape.contains_at::<T>(point)))
        }
        _ => false,
    };
    is_deep
        && [0.0, 0.01, -0.01].into_iter().all(|shift| {
            let origin = Vec3::from_f64(add(ray.origin().to_f64(), scale(across, shift)));
            let beside = origin.ok().and_then(|origin| Ray::new(origin, ray.direction()).ok());
            beside.is_some_and(|ray| match &shape.hits_at::<T>(&ray)[..] {
                [enter, exit] => exit.t.to_f64() - enter.t.to_f64() > 0.05,
                _ => false,
            })
        })
}

fn follow<S: Exact, T: Tier<S>>(crowd: &Crowd<S>, ray: &Ray<S>, wrong: &mut Wrong, random: &mut Random) -> usize {
    let Some(met) = followed::<S, T>(&crowd.shapes, ray) else { return 0 };
    let listed = List::with_start::<T>(crowd.shapes.as_slice(), ray, &Start::new()).expect("it has room");
    for (index, shape) in (0_u32..).zip(&crowd.shapes) {
        if !shape.is_solid() {
            continue;
        }
        let own: Vec<_> =
            met.iter().filter(|(solid, crossing)| *solid == index && *crossing != Crossing::Touch).collect();
        let mut is_inside = listed.inside().contains(index);
        for (_, crossing) in &own {
            wrong.unpaired += usize::from((*crossing == Crossing::Exit) != is_inside);
            is_inside = *crossing == Crossing::Enter;
        }
        let entries = |hits: &[Crossing]| hits.iter().filter(|crossing| **crossing == Crossing::Enter).count();
        let hits = shape.hits_at::<T>(ray);
        let all: Vec<_> = hits.iter().map(|hit| hit.crossing).collect();
        let entered = entries(&own.iter().map(|(_, crossing)| *crossing).collect::<Vec<_>>());
        if is_surely_hit::<S, T>(shape, ray, random) {
            wrong.lost += usize::from(entered < entries(&all));
            wrong.twice += usize::from(entered > entries(&all));
        }
    }
    met.len()
}

fn nothing_is_lost<S: Exact, T: Tier<S>>() {
    nothing_is_lost_of::<S, T>(Of::Others);
    nothing_is_lost_of::<S, T>(Of::All);
    nothing_is_lost_of::<S, T>(Of::Further);
}

fn nothing_is_lost_of<S: Exact, T: Tier<S>>(of: Of) {
    let mut random = Random(0x510e_527f_ade6_82d1);
    let (mut wrong, mut rays, mut met) = (Wrong::default(), 0, 0);
    // In the long form ten million rays in all number types and tiers.
    for _ in 0..amount(1_000, 145_000) {
        let crowd = Crowd::<S>::random(&mut random, of);
        for _ in 0..5 {
            let Some(ray) = crowd.ray(&mut random) else { continue };
            let before = (wrong.lost, wrong.twice, wrong.unpaired);
            rays += 1;
            met += follow::<S, T>(&crowd, &ray, &mut wrong, &mut random);
            assert_eq!(
                (wrong.lost, wrong.twice, wrong.unpaired),
                before,
                "{ray:?}\n{:#?}\n{:?}\n{:#?}",
                crowd.shapes,
                followed::<S, T>(&crowd.shapes, &ray),
                List::with_start::<T>(crowd.shapes.as_slice(), &ray, &Start::new())
            );
        }
    }
    println!("{} {} {of:?}: {rays} rays, {met} crossings, {wrong:?}", S::name(), core::any::type_name::<T>());
    assert_eq!(wrong, Wrong::default());
}

#[test]
fn nothing_is_lost_or_met_twice_f32() {
    nothing_is_lost::<f32, Plain>();
    nothing_is_lost::<f32, Fast>();
    nothing_is_lost::<f32, Stable>();
    nothing_is_lost::<f32, ExactTier>();
}

#[test]
fn nothing_is_lost_or_met_twice_f64() {
    nothing_is_lost::<f64, Plain>();
    nothing_is_lost::<f64, Fast>();
    nothing_is_lost::<f64, Stable>();
}

#[test]
fn nothing_is_lost_or_met_twice_i16f16() {
    nothing_is_lost::<I16F16, Plain>();
    nothing_is_lost::<I16F16, Fast>();
    nothing_is_lost::<I16F16, Stable>();
    nothing_is_lost::<I16F16, ExactTier>();
}

#[test]
fn nothing_is_lost_or_met_twice_i32f32() {
    nothing_is_lost::<I32F32, Plain>();
    nothing_is_lost::<I32F32, Fast>();
    nothing_is_lost::<I32F32, Stable>();
}
