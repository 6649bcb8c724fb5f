//! The order of crossings: consistent in every tier, and that of exact arithmetic in `Exact`.

use crate::crowd::{Crowd, Of};
use fixed::types::{I8F24, I16F16, I32F32};
use raylet::solids::{Crossings, SolidCrossing, SolidSet, Start};
use raylet::{Crossing, Exact as ExactTier, Fast, Part, Plain, Ray, Shape, Stable, Tier};
use support::amount::times;
use support::exact_types::{Exact, expected_of, same_crossing, same_part};
use support::oracle::{ExpectedCrossing, ExpectedHit};
use support::random::Random;

/// More than eight solids can have.
type List<S> = Crossings<S, 32>;

fn crossings<S: Exact, T: Tier<S>>(shapes: &[Shape<S>], ray: &Ray<S>) -> List<S> {
    List::with_start::<T>(shapes, ray, &Start::new()).expect("it has room")
}

/// The crossings of each solid are its hits, in their order; they are sorted; and the set changes by one solid at each
/// crossing of a solid, and by none at others.
fn is_consistent<S: Exact, T: Tier<S>>(shapes: &[Shape<S>], ray: &Ray<S>) {
    let crossings = crossings::<S, T>(shapes, ray);
    let told = || format!("{ray:?}\n{shapes:#?}\n{crossings:#?}");
    let mut inside = crossings.inside();
    let mut last = None;
    for SolidCrossing { solid, hit, before, after } in &crossings {
        assert_eq!(before, inside, "{}", told());
        let is_solid = shapes[solid as usize].is_solid();
        match hit.crossing {
            Crossing::Enter if is_solid => {
                assert!(!before.contains(solid) && after == before.with(solid), "{}", told());
            }
            Crossing::Exit if is_solid => {
                assert!(before.contains(solid) && after == before.without(solid), "{}", told());
            }
            _ => assert_eq!(before, after, "{}", told()),
        }
        assert!(last.is_none_or(|last| last <= hit.t) || T::EXACT_ENDS, "not sorted: {}", told());
        (inside, last) = (after, Some(hit.t));
    }
    let mut count = 0;
    for (index, shape) in (0_u32..).zip(shapes) {
        let hits = shape.hits_at::<T>(ray);
        let own: Vec<_> = crossings.iter().filter(|crossing| crossing.solid == index).map(|c| c.hit).collect();
        assert_eq!(own, hits[..], "{}", told());
        assert_eq!(crossings.inside().contains(index), hits.starts_inside(), "{}", told());
        count += hits.len();
    }
    assert_eq!(crossings.len(), count);
}

fn class(crossing: ExpectedCrossing) -> u8 {
    match crossing {
        ExpectedCrossing::Exit => 0,
        ExpectedCrossing::Touch => 1,
        ExpectedCrossing::Enter => 2,
    }
}

/// The crossings in exact arithmetic, in the order that the rule gives.
fn expected<S: Exact>(crowd: &Crowd<S>, ray: &Ray<S>, start: &Start) -> Vec<(u32, ExpectedHit)> {
    let mut all = vec![];
    for (index, (solid, placed)) in (0_u32..).zip(crowd.solids.iter().zip(&crowd.placed)) {
        let departure = start.departures().iter().find(|departure| departure.object == index);
        let ray = departure.map_or(*ray, |departure| ray.departing(*departure));
        let answer = expected_of(solid, &placed.line(&ray), &ray);
        all.extend(answer.hits.into_iter().map(|hit| (index, hit)));
    }
    // Stable: the crossings of one solid stay in order.
    all.sort_by(|(a, hit), (b, other)| {
        hit.t.cmp(&other.t).then(class(hit.crossing).cmp(&class(other.crossing))).then(a.cmp(b))
    });
    all
}

/// What a test has met.
#[derive(Debug, Default)]
struct Met {
    crossings: usize,
    ties: usize,
    reordered: usize,
}

fn check_exact<S: Exact>(crowd: &Crowd<S>, ray: &Ray<S>, start: &Start, met: &mut Met) -> List<S>
where
    ExactTier: Tier<S>,
{
    let expected = expected(crowd, ray, start);
    let found = List::with_start::<ExactTier>(crowd.shapes.as_slice(), ray, start).expect("it has room");
    let agrees = found.len() == expected.len()
        && found.iter().zip(&expected).all(|(found, (solid, hit))| {
            found.solid == *solid
                && same_part(found.hit.part, hit.part)
                && same_crossing(found.hit.crossing, hit.crossing)
        });
    assert!(agrees, "{ray:?} {start:?}\n{:#?}\nexpected {expected:#?}\nfound {found:#?}", crowd.shapes);
    met.crossings += expected.len();
    met.ties += expected.windows(2).filter(|pair| pair[0].1.t == pair[1].1.t).count();
    let order = |list: &List<S>| list.iter().map(|crossing| crossing.solid).collect::<Vec<_>>();
    let stable = List::with_start::<Stable>(crowd.shapes.as_slice(), ray, start).expect("it has room");
    met.reordered += usize::from(order(&found) != order(&stable));
    found
}

/// The ray that goes on from the first crossing, departing from all surfaces there. Its coordinates decide the rest.
fn onwards<S: Exact>(ray: &Ray<S>, found: &List<S>) -> Option<(Ray<S>, Start)> {
    let first = found.iter().next()?;
    let ray = Ray::new(ray.at(first.hit.t), ray.direction()).ok()?;
    let across = found.start_across(0).ok()?;
    let start = across.departures().iter().try_fold(Start::new(), |start, departure| start.departing(*departure));
    Some((ray, start.ok()?))
}

fn exact_order<S: Exact>(units: &[f64])
where
    ExactTier: Tier<S>,
{
    exact_order_of::<S>(units, Of::Others);
    exact_order_of::<S>(units, Of::All);
    exact_order_of::<S>(units, Of::Further);
}

fn exact_order_of<S: Exact>(units: &[f64], of: Of)
where
    ExactTier: Tier<S>,
{
    let mut random = Random(0x1f83_d9ab_fb41_bd6b);
    let mut met = Met::default();
    for round in 0..times(1_500) {
        let crowd = Crowd::<S>::of_unit(&mut random, units[round as usize % units.len()], of);
        for _ in 0..5 {
            let Some(ray) = crowd.ray(&mut random) else { continue };
            let found = check_exact(&crowd, &ray, &Start::new(), &mut met);
            if let Some((ray, start)) = onwards(&ray, &found) {
                check_exact(&crowd, &ray, &start, &mut met);
            }
        }
    }
    println!("{} {of:?}: {met:?}", S::name());
    assert!(met.ties * 64 > met.crossings && met.reordered > 0, "{met:?}");
}

#[test]
fn the_order_is_that_of_exact_arithmetic_f32() {
    exact_order::<f32>(&[1.0]);
}

/// Integers must hold the polynomials of all exponents.
#[test]
fn the_order_is_that_of_exact_arithmetic_for_tiny_and_huge_solids() {
    exact_order::<f32>(&[2.0_f64.powi(-60), 2.0_f64.powi(60), 2.0_f64.powi(-30)]);
}

#[test]
fn the_order_is_that_of_exact_arithmetic_i16f16() {
    exact_order::<I16F16>(&[1.0]);
}

fn consistent<S: Exact>() {
    let mut random = Random(0x5be0_cd19_137e_2179);
    for round in 0..times(1_000) {
        let crowd = Crowd::<S>::random(&mut random, if round < times(600) { Of::Others } else { Of::All });
        for _ in 0..5 {
            let Some(ray) = crowd.ray(&mut random) else { continue };
            is_consistent::<S, Plain>(&crowd.shapes, &ray);
            is_consistent::<S, Fast>(&crowd.shapes, &ray);
            is_consistent::<S, Stable>(&crowd.shapes, &ray);
        }
    }
}

#[test]
fn every_order_is_consistent() {
    consistent::<f32>();
    consistent::<f64>();
    consistent::<I16F16>();
    consistent::<I32F32>();
}

/// Two unit cuboids that share a face: the ray is inside of neither there.
#[test]
fn at_a_shared_face_the_exit_comes_first() {
    use raylet::{Cuboid, Frame, UnitVec3, Vec3};
    let block = Shape::new(Cuboid::new(0.5_f32, 0.5, 0.5).unwrap());
    let at = |x: f32| block.placed(Frame::at(Vec3::new(x, 0.0, 0.0)).unwrap());
    let ray = Ray::new(Vec3::new(-2.0, 0.25, 0.0), UnitVec3::X).unwrap();
    // The farther one is listed first.
    let crossings = List::of(&[at(1.0), at(0.0)], &ray).unwrap();
    let sets: Vec<_> = crossings.iter().map(|c| (c.solid, c.hit.t, c.hit.part, c.after)).collect();
    let (none, far, near) = (SolidSet::EMPTY, SolidSet::EMPTY.with(0), SolidSet::EMPTY.with(1));
    assert_eq!(
        sets,
        [
            (1, 1.5, Part::Left, near),
            (1, 2.5, Part::Right, none),
            (0, 2.5, Part::Left, far),
            (0, 3.5, Part::Right, none)
        ]
    );
}

/// A ray in a face of a cuboid leaves it by an edge that the face owns, and the plane of the other face ends it. The
/// stretched cylinder ends less than a unit before.
#[test]
fn an_end_on_an_edge_is_where_the_other_face_is() {
    use raylet::{Affine, Cuboid, Cylinder, Frame, UnitVec3, Vec3};
    let n = |x: f64| I16F16::from_num(x);
    let v = |x, y, z| Vec3::new(n(x), n(y), n(z));
    let block =
        Shape::new(Cuboid::new(n(0.25), n(0.25), n(1.0)).unwrap()).placed(Frame::at(v(0.0, -1.0, -0.5)).unwrap());
    let stretched = Affine::stretched(Frame::at(v(-2.0, -1.5, 0.0)).unwrap(), v(30.0, 3.0, 2.0)).unwrap();
    let drum = Shape::new(Cylinder::capped(n(2.0), n(0.25)).unwrap()).placed(stretched);
    let ray = Ray::new(v(-0.25, -1.0, -1.5), UnitVec3::Y).unwrap();
    let list = List::with_start::<ExactTier>(&[block, drum], &ray, &Start::new()).unwrap();
    let order: Vec<_> = list.iter().map(|c| (c.solid, c.hit.t, c.hit.part)).collect();
    assert_eq!(order, [(1, n(0.25), Part::Top), (0, n(0.25), Part::Left)]);
}

#[test]
fn messages_say_what_to_do() {
    use raylet::{Sphere, UnitVec3, Vec3};
    let balls = [Shape::new(Sphere::new(1.0_f32).unwrap()); 33];
    let ray = Ray::new(Vec3::new(-2.0, 0.0, 0.0), UnitVec3::X).unwrap();
    let error = Crossings::<f32, 66>::of(&balls, &ray).unwrap_err();
    assert_eq!(error.to_string(), "a set holds 32 solids, and the list has 33: give the set more words of 32");
    let error = Crossings::<f32, 65, 2>::of(&balls, &ray).unwrap_err();
    assert_eq!(error.to_string(), "the ray has more than 65 crossings: give their list more room");
    assert_eq!(Crossings::<f32, 66, 2>::of(&balls, &ray).unwrap().len(), 66);
    let error = Crossings::<f32, 66, 2>::of(&balls, &ray).unwrap().start_across(0).unwrap_err();
    assert_eq!(error.to_string(), "a ray departs from at most 8 surfaces at once");
}

/// Small numbers, in which every coordinate is coarse.
#[test]
fn the_order_is_that_of_exact_arithmetic_i8f24() {
    exact_order::<I8F24>(&[0.125]);
}
