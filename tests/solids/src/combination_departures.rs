//! Rays that depart from combinations: as one solid of a list, whose start is known, and as one shape, by the
//! departures that surfaces give.

use crate::crowd::Of;
use crate::random_combinations::Parts;
use fixed::types::{I16F16, I32F32};
use raylet::shape::kinds::Combining;
use raylet::solids::{Crossings, Start};
use raylet::{
    Combination, Crossing, Exact as ExactTier, Fast, Hit, Leaving, Plain, Ray, Shape, Stable, Tier, UnitVec3, Vec3,
};
use support::exact_types::Exact;
use support::random::{Random, add, dot, scale};

type Combined<'a, S> = Shape<S, Combining<'a>>;

/// The hits of rays beside this one, as far as they have the same crossings and no two within 0.05.
fn surely<S: Exact, T: Tier<S>>(shape: &Combined<'_, S>, ray: &Ray<S>, random: &mut Random) -> Option<Vec<Hit<S>>> {
    let across = random.perpendicular(ray.direction().to_f64());
    let mut lists = [0.0, 0.01, -0.01].into_iter().map(|shift| {
        let origin = Vec3::from_f64(add(ray.origin().to_f64(), scale(across, shift))).ok()?;
        let beside = match ray.departure() {
            Some(departure) if shift == 0.0 => Ray::new(origin, ray.direction()).ok()?.departing(departure),
            _ => Ray::new(origin, ray.direction()).ok()?,
        };
        let hits = shape.hits_at::<T>(&beside);
        let is_apart = hits.windows(2).all(|pair| pair[1].t.to_f64() - pair[0].t.to_f64() > 0.05);
        is_apart.then(|| hits.to_vec())
    });
    let first = lists.next().flatten()?;
    let crossings = |hits: &[Hit<S>]| hits.iter().map(|hit| hit.crossing).collect::<Vec<_>>();
    let is_same = lists.all(|list| list.is_some_and(|list| crossings(&list) == crossings(&first)));
    (is_same && first.iter().all(|hit| hit.crossing != Crossing::Touch)).then_some(first)
}

/// What a test has met.
#[derive(Debug, Default)]
struct Met {
    rays: usize,
    sure: usize,
    crossings: usize,
    thin: usize,
}

impl Met {
    /// Compares the crossings on a path with the hits of a shape: they alternate, and where the hits do not hang on the
    /// rounding of the path's points, they are these.
    fn compare<S: Exact, T: Tier<S>>(
        &mut self,
        path: &[(f64, Crossing)],
        mut is_inside: bool,
        shape: &Combined<'_, S>,
        ray: &Ray<S>,
        random: &mut Random,
        told: &impl Fn() -> String,
    ) {
        for (_, crossing) in path.iter().filter(|(_, crossing)| *crossing != Crossing::Touch) {
            assert_eq!(*crossing == Crossing::Exit, is_inside, "{path:?} {}", told());
            is_inside = !is_inside;
            self.crossings += 1;
        }
        if let Some(hits) = surely::<S, T>(shape, ray, random) {
            self.sure += 1;
            let hits: Vec<_> = hits.iter().map(|hit| hit.crossing).collect();
            assert_eq!(without_slivers(path), hits, "{path:?} {}", told());
        }
    }
}

/// The crossings on a path without slivers: faces that coincide are some units apart in most tiers, in the way that
/// they are computed from where the ray is.
fn without_slivers(path: &[(f64, Crossing)]) -> Vec<Crossing> {
    let mut kept: Vec<(f64, Crossing)> = vec![];
    for (t, crossing) in path.iter().filter(|(_, crossing)| *crossing != Crossing::Touch) {
        match kept.last() {
            Some((last, _)) if t - last < 0.01 => {
                kept.pop();
            }
            _ => kept.push((*t, *crossing)),
        }
    }
    kept.into_iter().map(|(_, crossing)| crossing).collect()
}

/// How far along the ray a point is.
fn along<S: Exact>(ray: &Ray<S>, point: Vec3<S>) -> f64 {
    dot(add(point.to_f64(), scale(ray.origin().to_f64(), -1.0)), ray.direction().to_f64())
}

/// A solid, how far along the ray it is crossed, and how.
type Passed = (u32, (f64, Crossing));

/// The crossings that a ray meets one after the other: each time from the point of the last, with the start that it
/// gives.
fn followed<S: Exact, T: Tier<S>>(shapes: &[Combined<'_, S>], first: &Ray<S>) -> Option<Vec<Passed>> {
    let (mut ray, mut start, mut met) = (*first, Start::<1>::new(), vec![]);
    for _ in 0..64 {
        let crossings = Crossings::<S, 96>::with_start::<T>(shapes, &ray, &start).expect("it has room");
        let Some(next) = crossings.iter().next() else { return Some(met) };
        let t = along(first, ray.at(next.hit.t));
        met.extend(crossings.iter().filter(|c| c.hit.t == next.hit.t).map(|c| (c.solid, (t, c.hit.crossing))));
        start = crossings.start_across(0).expect("fewer than nine solids");
        // A point beyond the type ends the path.
        ray = Ray::new(ray.at(next.hit.t), ray.direction()).ok()?;
    }
    panic!("the ray goes on and on: {ray:?}\n{shapes:#?}\n{met:?}");
}

/// Two combinations in one list, followed from crossing to crossing.
fn in_a_list<S: Exact, T: Tier<S>>(of: Of) {
    let mut met = Met::default();
    Parts::<S>::each(of, 0x3c6e_f372_fe94_f82b, 800, |parts, ray, random| {
        let (one, other) = (parts.combination(), Combination::union(&parts.leaves).expect("at most eight solids"));
        let shapes = [one.shape(), other.shape(), parts.leaves[0].beside_combinations()];
        let told = || parts.told(ray);
        let Some(all) = followed::<S, T>(&shapes, ray) else { return };
        met.rays += 1;
        let listed = Crossings::<S, 96>::with_start::<T>(&shapes, ray, &Start::<1>::new()).expect("room");
        for (index, shape) in (0_u32..).zip(&shapes) {
            let path: Vec<_> = all.iter().filter(|(solid, _)| *solid == index).map(|(_, on)| *on).collect();
            let is_inside = listed.inside().contains(index);
            met.compare::<S, T>(&path, is_inside, shape, ray, random, &|| format!("{index} {}", told()));
        }
    });
    println!("{} {}: {met:?}", S::name(), core::any::type_name::<T>());
    assert!(met.sure > 1_000 && met.crossings > 3_000, "{met:?}");
}

#[test]
fn a_followed_ray_loses_nothing_and_meets_nothing_twice() {
    in_a_list::<f32, Plain>(Of::Others);
    in_a_list::<f32, Stable>(Of::Others);
    in_a_list::<f32, ExactTier>(Of::Others);
    in_a_list::<f32, ExactTier>(Of::All);
    in_a_list::<f32, ExactTier>(Of::Further);
    in_a_list::<f64, Fast>(Of::Others);
    in_a_list::<I16F16, Stable>(Of::Others);
    in_a_list::<I16F16, ExactTier>(Of::Others);
    in_a_list::<I32F32, Stable>(Of::Others);
}

/// The crossings of one shape, one after the other: each ray departs from the surface of the last hit.
fn through<S: Exact, T: Tier<S>>(shape: &Combined<'_, S>, first: &Ray<S>) -> Option<Vec<(f64, Crossing)>> {
    let (mut ray, mut met) = (*first, vec![]);
    for _ in 0..64 {
        let Some(hit) = shape.nearest_at::<T>(&ray) else { return Some(met) };
        let surface = shape.surface(&ray, &hit);
        met.push((along(first, surface.point()), hit.crossing));
        let leaving = if hit.crossing == Crossing::Enter { Leaving::Inwards } else { Leaving::Outwards };
        ray = Ray::new(surface.point(), ray.direction()).ok()?.departing(surface.departure(0, leaving));
    }
    panic!("the ray goes on and on: {ray:?}\n{met:?}");
}

fn by_departures<S: Exact, T: Tier<S>>(of: Of) {
    let mut met = Met::default();
    Parts::<S>::each(of, 0xa54f_f53a_5f1d_36f1, 1_500, |parts, ray, random| {
        let combination = parts.combination();
        let shape = combination.shape();
        let Some(all) = through::<S, T>(&shape, ray) else { return };
        let told = || format!("{all:?} {:#?}\n{}", shape.hits_at::<T>(ray), parts.told(ray));
        met.rays += 1;
        let is_inside = shape.hits_at::<T>(ray).starts_inside();
        met.compare::<S, T>(&all, is_inside, &shape, ray, random, &told);
    });
    println!("{} {}: {met:?}", S::name(), core::any::type_name::<T>());
    assert!(met.sure > 500 && met.crossings > 2_000, "{met:?}");
}

#[test]
fn straight_through_by_departures() {
    by_departures::<f32, Plain>(Of::Others);
    by_departures::<f32, Stable>(Of::Others);
    by_departures::<f32, ExactTier>(Of::Others);
    by_departures::<f32, ExactTier>(Of::All);
    by_departures::<f32, ExactTier>(Of::Further);
    by_departures::<f64, Stable>(Of::All);
    by_departures::<f64, Stable>(Of::Further);
    by_departures::<f64, Stable>(Of::Others);
    by_departures::<I16F16, Fast>(Of::Others);
    by_departures::<I16F16, Stable>(Of::Others);
    by_departures::<I32F32, Stable>(Of::Others);
}

/// A ray that is scattered at a hit meets what a ray that begins a little away from the surface meets.
fn scattered<S: Exact, T: Tier<S>>(of: Of) {
    let mut met = Met::default();
    Parts::<S>::each(of, 0x510e_527f_ade6_82d1, 2_000, |parts, ray, random| {
        let combination = parts.combination();
        let shape = combination.shape();
        let Some(hit) = shape.nearest_at::<T>(ray) else { return };
        let (surface, towards) = (shape.surface(ray, &hit), random.direction());
        let Ok(direction) = UnitVec3::<S>::from_f64(towards) else { return };
        // Which way that is is certain.
        let cosine = dot(surface.normal().to_f64(), direction.to_f64());
        if cosine.abs() < 0.1 {
            return;
        }
        let leaving = if cosine > 0.0 { Leaving::Outwards } else { Leaving::Inwards };
        let Ok(departing) = Ray::new(surface.point(), direction) else { return };
        let departing = departing.departing(surface.departure(0, leaving));
        let beyond = add(surface.point().to_f64(), scale(direction.to_f64(), 0.02));
        let Some(plain) = Vec3::from_f64(beyond).ok().and_then(|origin| Ray::new(origin, direction).ok()) else {
            return;
        };
        let hits = shape.hits_at::<T>(&departing);
        assert_eq!(hits.starts_inside(), leaving == Leaving::Inwards);
        met.rays += 1;
        let Some(expected) = surely::<S, T>(&shape, &plain, random) else { return };
        if expected.first().is_some_and(|hit| hit.t.to_f64() < 0.05)
            || shape.hits_at::<T>(&plain).starts_inside() != hits.starts_inside()
        {
            return;
        }
        met.sure += 1;
        met.crossings += expected.len();
        // A gap or a wall may be thinner than the step away from the surface.
        met.thin += usize::from(hits.iter().any(|hit| hit.t.to_f64() < 0.03));
        let hits: Vec<_> = hits.iter().filter(|hit| hit.t.to_f64() >= 0.03).copied().collect();
        // From the surface, and from a step away from it.
        let far = |hits: &[Hit<S>], step: f64| {
            hits.iter().map(|hit| (hit.crossing, ((hit.t.to_f64() + step) * 50.0).round())).collect::<Vec<_>>()
        };
        let (hits, expected) = (far(&hits, 0.0), far(&expected, 0.02));
        let is_near = |(a, b): (&(Crossing, f64), &(Crossing, f64))| a.0 == b.0 && (a.1 - b.1).abs() <= 1.0;
        let is_same = hits.len() == expected.len() && hits.iter().zip(&expected).all(is_near);
        assert!(is_same, "{hits:?} {expected:?} {hit:?} {departing:?}\n{}", parts.told(ray));
    });
    println!("{} {}: {met:?}", S::name(), core::any::type_name::<T>());
    assert!(met.sure > 500 && met.crossings > 300 && met.thin * 50 < met.sure, "{met:?}");
}

#[test]
fn a_scattered_ray_meets_what_lies_ahead() {
    scattered::<f32, Stable>(Of::Others);
    scattered::<f32, ExactTier>(Of::Others);
    scattered::<f32, ExactTier>(Of::All);
    scattered::<f32, ExactTier>(Of::Further);
    scattered::<f64, Stable>(Of::Others);
    scattered::<I16F16, Stable>(Of::Others);
    scattered::<I32F32, Stable>(Of::Others);
}
