//! Round cones: random ones beside exact arithmetic, and what they are where the radii are equal or one ball holds the
//! other. Rows and laws of some of them stand among those of all primitives.

use crate::drawn::{departures_pair_up, is_exact, line};
use crate::values::n;
use fixed::types::{I8F24, I16F16};
use raylet::{
    Capsule, Crossing, Departure, Exact, Frame, Hit, Leaving, Part, Range, Ray, RoundCone, Shape, SizeError, Sphere,
    Tier, UnitVec3, ValueError, Vec3,
};
use support::amount::times;
use support::call_in_every_tier;
use support::cases::{direction, v};
use support::described::Described;
use support::exact_types::{Exact as Number, exact_line, expected_of};
use support::oracle::Solid;
use support::random::Random;

/// A round cone whose sizes are multiples of a quarter, or any; some of them a single ball, some nearly so.
fn round_cone<S: Number>(random: &mut Random) -> Option<(Shape<S>, Solid)> {
    let quarters = |x: f64| (x * 4.0).round() / 4.0;
    let (base, top, height) = (random.between(0.2, 2.0), random.between(0.2, 2.0), random.between(0.0, 2.5));
    let (base, top, height) = match random.below(4) {
        0 => (quarters(base), quarters(top), quarters(height)),
        1 => (base, top, height),
        2 => (base, top, (base - top).abs() * (1.0 + 10.0_f64.powf(random.between(-5.0, -1.0)))),
        _ => (base, base * (1.0 - 10.0_f64.powf(random.between(-6.0, -1.0))), height),
    };
    let described = Described::RoundCone { base, top, height };
    let sized = described.try_map(|size| S::from_f64(*size)).ok()?;
    Some((sized.shape().ok()?, sized.solid()))
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_f32() {
    let hits_of = is_exact::<f32, Exact>(round_cone);
    assert_eq!(hits_of[3..], [0, 0]);
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_fixed_point() {
    let hits_of = is_exact::<I16F16, Exact>(round_cone);
    assert_eq!(hits_of[3..], [0, 0]);
    let hits_of = is_exact::<I8F24, Exact>(round_cone);
    assert_eq!(hits_of[3..], [0, 0]);
}

fn leaves<S: Number, T: Tier<S>>() {
    departures_pair_up::<S, T>(round_cone);
}

#[test]
fn rays_leave_in_every_tier() {
    call_in_every_tier!(leaves);
}

/// Rays at random, departing ones among them, at two shapes that are one solid.
fn are_alike<S: Number, T: Tier<S>>(
    pair: impl Fn(&mut Random) -> Option<[Shape<S>; 2]>,
    same: impl Fn(&Hit<S>, &Hit<S>) -> bool,
) {
    let mut random = Random(0xca95);
    let mut met = 0;
    for _ in 0..times(2_000) {
        let Some(mut pair) = pair(&mut random) else { continue };
        let frame = Frame::looking(v(random.direction()), random.unit_vector(), random.unit_vector());
        if let Ok(frame) = frame
            && random.next() & 1 == 0
        {
            pair = pair.map(|shape| shape.placed(frame));
        }
        let (origin, along) = line(&mut random);
        let Ok(ray) = Ray::new(v::<S>(origin), direction(along)) else { continue };
        let hits = pair.map(|shape| shape.hits_at::<T>(&ray.with_range(Range::line())));
        let are_same = hits[0].len() == hits[1].len() && hits[0].iter().zip(&hits[1]).all(|(a, b)| same(a, b));
        assert!(are_same, "{pair:?} {ray:?}: {hits:?}");
        for hit in &hits[0] {
            let away = Ray::new(ray.at(hit.t), random.unit_vector()).expect("near");
            let away = away.departing(Departure { object: 0, part: hit.part, leaving: Leaving::Inwards });
            let hits = pair.map(|shape| shape.hits_at::<T>(&away));
            let are_same = hits[0].len() == hits[1].len() && hits[0].iter().zip(&hits[1]).all(|(a, b)| same(a, b));
            assert!(are_same, "{pair:?} {away:?}: {hits:?}");
            met += 1;
        }
    }
    assert!(met > times(1_000), "{met}");
}

fn with_equal_radii<S: Number, T: Tier<S>>() {
    are_alike::<S, T>(
        |random| {
            let [radius, height] = [0.5, 0.0].map(|least| n::<S>(least + random.unit()));
            let cone = RoundCone::new(radius, radius, height).ok()?;
            Some([Shape::new(cone), Shape::new(Capsule::new(radius, height).ok()?)])
        },
        |a, b| a == b,
    );
}

#[test]
fn equal_radii_give_the_bits_of_the_capsule() {
    call_in_every_tier!(with_equal_radii);
}

/// The larger ball alone: seen beside a sphere of the same radius at its centre.
fn is_the_larger_ball<S: Number, T: Tier<S>>() {
    let mut random = Random(0xba11);
    for _ in 0..times(2_000) {
        let [small, height] = [0.25, 0.0].map(|least| n::<S>(least + random.unit() / 4.0));
        let large = n::<S>(1.0);
        let (cone, centre, part) = if random.next() & 1 == 0 {
            (RoundCone::new(large, small, height), S::ZERO, Part::Base)
        } else {
            (RoundCone::new(small, large, height), height, Part::Top)
        };
        let cone = cone.expect("sizes");
        let ball = Shape::new(Sphere::new(large).expect("a size"))
            .placed(Frame::at(Vec3::new(S::ZERO, centre, S::ZERO)).expect("near"));
        let Ok(ray) = Ray::towards(v::<S>(random.direction().map(|c| 4.0 * c)), v(random.direction())) else {
            continue;
        };
        let (own, other) = (cone.hits_at::<T>(&ray), ball.hits_at::<T>(&ray));
        assert_eq!(own.len(), other.len(), "{cone:?} {ray:?}: {own:?} {other:?}");
        let unit = S::unit_at(&(&n::<S>(4.0).exact()).into()).to_f64();
        for (a, b) in own.iter().zip(&other) {
            let is_near = (a.t.to_f64() - b.t.to_f64()).abs() <= 256.0 * unit;
            assert!(is_near && a.crossing == b.crossing && a.part == part, "{cone:?} {ray:?}: {own:?} {other:?}");
        }
        assert!(cone.contains_at::<T>(Vec3::new(S::ZERO, centre, S::ZERO)));
        for off in [0.9, 1.1] {
            let point = v::<S>(random.direction().map(|c| c * off)) + Vec3::new(S::ZERO, centre, S::ZERO);
            assert_eq!(cone.contains_at::<T>(point), off < 1.0, "{cone:?} {point:?}");
        }
    }
}

#[test]
fn of_two_balls_one_in_the_other_the_larger_is_left() {
    call_in_every_tier!(is_the_larger_ball);
}

/// The upper ball of a tall capsule or round cone, far from the frame's origin, along directions as long as they may
/// be: `t` was off by up to 25 units of `f32`, and 2^-20 of the height.
#[test]
fn a_tall_capsule_is_accurate_at_its_top() {
    let mut random = Random(0x7a11);
    for height in [8.0, 12.0, 16.0, 24.0, 32.0, 48.0] {
        let mut worst = 0.0_f64;
        for _ in 0..times(4_000) {
            let top = if random.next() & 1 == 0 { 1.0 } else { 1.25 };
            let described = Described::RoundCone { base: 1.0_f32, top, height: height as f32 };
            let [from, at] = [4.0, 0.7].map(|reach| [(); 3].map(|()| random.between(-reach, reach)));
            let (from, at) = ([from[0], height + 5.0 + from[1] / 2.0, from[2]], [at[0], height + 0.3, at[2]]);
            let long = 1.0 + random.between(-0.8, 0.8) * 2.0_f64.powi(-20);
            let along = UnitVec3::<f32>::from_f64([0, 1, 2].map(|i| at[i] - from[i])).expect("a length");
            let along = along.to_array().map(|c| (f64::from(c) * long) as f32);
            let ray = Ray::new(v(from), UnitVec3::from_components(along).expect("nearly unit")).expect("near");
            let Some(hit) = described.shape().expect("sizes").nearest(&ray) else { continue };
            let exact = expected_of(&described.solid(), &exact_line(&ray), &ray).hits.remove(0);
            worst = worst.max(exact.t.error_in(&hit.t.exact(), &f32::unit_at(&exact.t)));
        }
        assert!(worst > 0.0 && worst <= 16.0, "{height}: {worst} units");
    }
}

/// Along a generator: from one circle of touching to the other. With the radii 1.25 and 0.5 at a distance of 1.25 the
/// sine is 0.6 and the cosine 0.8, and all points are exact.
#[test]
fn a_line_along_the_side_runs_from_circle_to_circle() {
    let cone = RoundCone::new(1.25_f64, 0.5, 1.25).unwrap();
    // The circles are at 0.75 and 1.55, with the radii 1 and 0.4.
    let ray = Ray::new(Vec3::new(1.6, -0.05, 0.0), UnitVec3::from_f64([-0.6, 0.8, 0.0]).unwrap()).unwrap();
    let hits = cone.hits(&ray);
    assert!(hits.len() <= 2, "{hits:?}");
    for (x, y, part) in [(1.25, 0.0, Part::Base), (0.7, 1.15, Part::Side), (0.5, 1.55, Part::Top)] {
        let ray = Ray::new(Vec3::new(3.0, y, 0.0), -UnitVec3::X).unwrap();
        let hit = cone.nearest(&ray).unwrap();
        assert_eq!((hit.part, hit.crossing), (part, Crossing::Enter), "{y}");
        assert!(part == Part::Top || (3.0 - hit.t - x).abs() < 1e-12, "{y}: {hit:?}");
    }
    let side = Shape::new(cone);
    let ray = Ray::new(Vec3::new(3.0, 1.15, 0.0), -UnitVec3::X).unwrap();
    let normal = side.surface(&ray, &side.nearest(&ray).unwrap()).normal().to_f64();
    assert!((normal[0] - 0.8).abs() < 1e-15 && (normal[1] - 0.6).abs() < 1e-15, "{normal:?}");
}

/// A round cone of equal radii, and of no height, has the surface of the capsule.
#[test]
fn equal_radii_give_the_surface_of_the_capsule() {
    for height in [0.0_f32, 1e-25, 0.75] {
        let cone = Shape::new(RoundCone::new(1.0, 1.0, height).unwrap());
        let capsule = Shape::new(Capsule::new(1.0, height).unwrap());
        for y in [-0.5, 0.0, 0.25, 1.0] {
            let ray = Ray::new(Vec3::new(-5.0, y, 0.25), UnitVec3::X).unwrap();
            let (Some(hit), other) = (cone.nearest(&ray), capsule.nearest(&ray)) else { continue };
            assert_eq!(Some(hit), other);
            let [a, b] = [cone, capsule].map(|shape| shape.surface(&ray, &hit));
            assert_eq!((a.normal(), a.uv(), a.tangents(), a.uvw()), (b.normal(), b.uv(), b.tangents(), b.uvw()));
        }
    }
}

/// `uvw` is a fraction of the extents, also where one ball holds the other.
#[test]
fn extents_are_those_of_the_hull() {
    for [base, top, height] in [[1.0_f64, 0.5, 1.0], [0.5, 1.0, 1.0], [2.0, 0.25, 0.5], [0.25, 2.0, 0.5]] {
        let cone = Shape::new(RoundCone::new(base, top, height).unwrap());
        let bounds = cone.bounds();
        let mut random = Random(0x9a27);
        for _ in 0..500 {
            let Ok(ray) = Ray::towards(v::<f64>(random.direction().map(|c| 6.0 * c)), v([0.0, height / 2.0, 0.0]))
            else {
                continue;
            };
            let hit = cone.nearest(&ray).unwrap();
            let surface = cone.surface(&ray, &hit);
            let along = (surface.point().y - bounds.low.y) / (bounds.high.y - bounds.low.y);
            assert!((surface.uvw()[1] - along).abs() < 1e-9, "{cone:?} {ray:?}");
        }
    }
}

#[test]
fn sizes_that_are_none_are_refused() {
    let new = |base: f32, top: f32, height: f32| RoundCone::new(base, top, height);
    assert_eq!(new(0.0, 1.0, 1.0), Err(SizeError::Radius(ValueError::Zero)));
    assert_eq!(new(1.0, -1.0, 1.0), Err(SizeError::Radius(ValueError::Negative)));
    assert_eq!(new(1.0, 1.0, -1.0), Err(SizeError::Height(ValueError::Negative)));
    assert_eq!(new(1.0, 1.0, f32::INFINITY), Err(SizeError::Height(ValueError::NotFinite)));
    assert!(new(1.0, 2.0, 0.0).is_ok());
}
