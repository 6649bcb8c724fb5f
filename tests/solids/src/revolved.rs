//! Quadrics of revolution: random ones beside exact arithmetic, in frames too, and what they are built from. Rows and
//! laws of some of them stand among those of all primitives.

use crate::drawn::{departures_pair_up, is_exact, line};
use crate::values::n;
use fixed::types::{I8F24, I16F16};
use raylet::hierarchy::{Hierarchy, Node};
use raylet::{
    Crossing, Departure, Disc, Exact, Frame, Leaving, Part, Plain, Ray, Revolved, Shape, Shapes, SizeError, Stable,
    Tier, UnitVec3, ValueError, Vec3,
};
use support::call_in_every_tier;
use support::cases::{direction, v};
use support::described::Described;
use support::exact_types::Exact as Number;
use support::oracle::Solid;
use support::random::Random;

/// A quadric whose coefficients are multiples of a quarter, or any.
fn quadric<S: Number>(random: &mut Random) -> Option<(Shape<S>, Solid)> {
    let is_round = random.next() & 1 == 0;
    let mut any = |low: f64, high: f64| {
        let value = random.between(low, high);
        if is_round { (value * 4.0).round() / 4.0 } else { value }
    };
    let (a, b, radius) = (any(-2.0, 2.0), any(-1.5, 1.5), any(-0.5, 2.0).max(0.0));
    let (low, height) = (any(-2.0, 1.0), any(0.25, 3.0));
    let capped = !random.next().is_multiple_of(4);
    let described = Described::Revolved { a, b, radius, heights: [low, low + height], capped };
    let sized = described.try_map(|size| S::from_f64(*size)).ok()?;
    Some((sized.shape().ok()?, sized.solid()))
}

/// Next to the apex of a paraboloid `Fast` took the side for a cap, which it does not have.
#[test]
fn a_paraboloid_has_no_cap_at_its_apex() {
    let dish = Revolved::new(0.0_f32, 0.5, 0.0, [0.0, 1.7]).unwrap();
    let along = [0xbf20_8144, 0x3f11_19e1, 0xbf08_d208].map(f32::from_bits);
    let from = [0x4210_7840, 0xc202_9ad4, 0x41f6_4d87].map(f32::from_bits);
    let ray = Ray::new(from.into(), UnitVec3::from_components(along).unwrap()).unwrap();
    let parts = |hits: raylet::Hits<f32>| hits.iter().map(|hit| hit.part).collect::<Vec<_>>();
    let side = [Part::Side; 2];
    assert_eq!([parts(dish.hits_at::<raylet::Fast>(&ray)), parts(dish.hits_at::<raylet::Exact>(&ray))], [side, side]);
    assert_eq!(parts(dish.hits_at::<raylet::Plain>(&ray)), side);
}

/// The side's end, which follows from a start that is rounded off the side, lies seven units beyond the apex.
#[test]
fn a_ray_that_departs_towards_an_apex_ends_at_the_plane_of_the_apex() {
    let raw = I16F16::from_bits;
    let dish = Revolved::new(raw(0), raw(512), raw(0), [raw(0), raw(1 << 17)]).unwrap();
    let along = UnitVec3::new(Vec3::new(raw(-1 << 12), raw(-8 << 12), raw(0))).unwrap();
    let departure = Departure { object: 0, part: Part::Side, leaving: Leaving::Inwards };
    let ray = Ray::new(Vec3::new(raw(8192), raw(65529), raw(0)), along).unwrap().departing(departure);
    let exit = |hit: Option<raylet::Hit<I16F16>>| hit.map(|hit| (hit.t, hit.part));
    let expected = Some((raw(66039), Part::Base));
    assert_eq!(exit(dish.nearest_at::<Exact>(&ray)), expected);
    assert_eq!(exit(dish.nearest_at::<Stable>(&ray)), expected);
    assert_eq!(exit(dish.nearest_at::<raylet::Fast>(&ray)), expected);
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_f32() {
    let hits_of = is_exact::<f32, Exact>(quadric);
    assert!(hits_of[3] > 1 && hits_of[4] > 9, "{hits_of:?}");
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_fixed_point() {
    let hits_of = is_exact::<I16F16, Exact>(quadric);
    assert!(hits_of[3] > 1 && hits_of[4] > 9, "{hits_of:?}");
    let hits_of = is_exact::<I8F24, Exact>(quadric);
    assert!(hits_of[3] > 1 && hits_of[4] > 9, "{hits_of:?}");
}

fn leaves<S: Number, T: Tier<S>>() {
    departures_pair_up::<S, T>(quadric);
}

#[test]
fn rays_leave_in_every_tier() {
    call_in_every_tier!(leaves);
}

/// A parabolic mirror: rays along its axis meet in the focus. (optiland #559: a division by zero at a conic constant of
/// -1; #753 and #787: the wrong root.)
fn reflects_to_its_focus<S: Number, T: Tier<S>>() {
    let (focus, unit) = (n::<S>(1.5), S::unit_at(&(&1.0_f32.exact()).into()));
    let most = 16.0 * unit.to_f64();
    let mirror = Revolved::optical(focus.plus(focus), n(-1.0), n(3.0)).expect("sizes").open();
    assert_eq!(mirror.coefficients(), (S::ZERO, n(3.0), S::ZERO));
    let mut random = Random(0xf0c5);
    for _ in 0..200 {
        let (x, z) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let ray = Ray::new(v::<S>([x, 4.0, z]), -UnitVec3::Y).expect("near");
        let hit = mirror.nearest_at::<T>(&ray).expect("it is within the rim");
        assert_eq!((hit.part, hit.crossing), (Part::Side, Crossing::Exit));
        let surface = mirror.surface(&ray, &hit);
        let (p, d, n) = (surface.point().to_f64(), ray.direction().to_f64(), surface.normal().to_f64());
        let along: f64 = (0..3).map(|i| d[i] * n[i]).sum();
        let d = [0, 1, 2].map(|i| d[i] - 2.0 * along * n[i]);
        let to_focus = [-p[0], 1.5 - p[1], -p[2]];
        let t: f64 = (0..3).map(|i| d[i] * to_focus[i]).sum();
        let off = (0..3).map(|i| (to_focus[i] - t * d[i]).abs()).fold(0.0, f64::max);
        assert!(off <= most, "{off} {ray:?}");
    }
}

#[test]
fn a_paraboloid_reflects_to_its_focus() {
    reflects_to_its_focus::<f32, Stable>();
    reflects_to_its_focus::<f32, Plain>();
    reflects_to_its_focus::<f64, Stable>();
    reflects_to_its_focus::<I16F16, Stable>();
    reflects_to_its_focus::<I16F16, Exact>();
}

/// Conic constants on both sides of -1 have the same limit, and each surface is that of the sag.
#[test]
fn conic_constants_next_to_each_other_give_neighbouring_surfaces() {
    for (radius, conic) in
        [(2.0_f64, -1.0), (2.0, -1.000_000_1), (2.0, -0.999_999_9), (2.0, 0.0), (2.0, -3.0), (2.0, 0.5)]
    {
        let lens = Revolved::optical(radius, conic, 2.0).expect("sizes").open();
        for step in 0..8 {
            let x = f64::from(step) / 8.0;
            let ray = Ray::new(Vec3::new(x, -3.0, 0.0), UnitVec3::Y).expect("near");
            let hit = lens.nearest(&ray).expect("it is within the rim");
            let sag = x * x / radius / (1.0 + (1.0 - (1.0 + conic) * x * x / radius / radius).sqrt());
            assert!((hit.t - 3.0 - sag).abs() < 1e-15, "{conic} {x}: {} {sag}", hit.t - 3.0);
        }
    }
}

/// A lens between two surfaces of their own curvatures is the intersection of two such solids, which face each other; a
/// plane surface is a disc.
#[test]
fn constructors_give_the_surfaces_that_they_name() {
    let zone = Revolved::ball_zone(2.0_f64, [-1.0, 1.5]).expect("within the ball");
    assert_eq!((zone.coefficients(), zone.heights()), ((-1.0, 0.0, 2.0), [-1.0, 1.5]));
    assert_eq!(zone, Revolved::spheroid(2.0, 2.0, [-1.0, 1.5]).expect("within the ball"));
    assert_eq!((zone.radius_at(0.0), zone.radius_at(2.0), zone.radius_at(3.0)), (2.0, 0.0, 0.0));
    let cone = Revolved::cone(0.5_f64, [-2.0, 4.0]).expect("sizes");
    assert_eq!((cone.radius_at(-2.0), cone.radius_at(0.0), cone.radius_at(4.0)), (1.0, 0.0, 2.0));
    let tower = Revolved::tower(5.0_f64, 4.0, 4.0, 3.0).expect("sizes");
    assert_eq!((tower.heights(), tower.coefficients()), ([-3.0, 0.0], (1.0, 0.0, 4.0)));
    let bowl = Revolved::optical(2.0_f64, 0.0, 4.0).expect("a hemisphere");
    assert_eq!((bowl.heights(), bowl.radius_at(2.0)), ([0.0, 2.0], 2.0));
    // The line of a mirror's axis: one hit of an open surface, at its vertex.
    let up = Ray::new(Vec3::new(0.0, -1.0, 0.0), UnitVec3::Y).expect("near");
    let seen: Vec<_> = bowl.open().hits(&up).iter().map(|hit| (hit.t, hit.crossing)).collect();
    assert_eq!(seen, [(1.0, Crossing::Enter)]);
    assert_eq!(Disc::new(2.0_f64).expect("a size").hits(&up)[0].t, 1.0);
}

/// A line through a waist crosses an open side twice, first from within; no start is inside of it.
#[test]
fn an_open_waist_has_no_inside() {
    let side = Revolved::hyperboloid(0.5_f32, 1.0, [-2.0, 2.0]).expect("sizes").open();
    let ray = Ray::new(Vec3::new(0.75, -3.0, 0.0), UnitVec3::Y).expect("near");
    let hits = side.hits(&ray);
    let seen: Vec<_> = hits.iter().map(|hit| (hit.part, hit.crossing)).collect();
    assert_eq!(seen, [(Part::Side, Crossing::Exit), (Part::Side, Crossing::Enter)]);
    for y in [-3.0, -2.25, 0.0, 2.25, 3.0] {
        let ray = Ray::new(Vec3::new(0.75, y, 0.0), UnitVec3::Y).expect("near");
        assert!(!side.hits(&ray).starts_inside(), "{y}");
    }
    // A ray that leaves the throat outwards meets the side above it.
    let throat = Ray::new(Vec3::new(0.5, 0.0, 0.0), UnitVec3::from_f64([0.5, 1.0, 0.0]).expect("a length"));
    let departure = Departure { object: 0, part: Part::Side, leaving: Leaving::Outwards };
    let throat = throat.expect("near").departing(departure);
    assert_eq!(side.hits(&throat).iter().map(|hit| hit.crossing).collect::<Vec<_>>(), [Crossing::Enter]);
    assert_eq!(side.nearest(&throat).map(|hit| hit.crossing), Some(Crossing::Enter));
}

/// Points of the side are in the box, whatever the frame.
#[test]
fn boxes_hold_the_side() {
    let mut random = Random(0xb0c5);
    let mut points = 0;
    for _ in 0..2000 {
        let Some((shape, _)) = quadric::<f32>(&mut random) else { continue };
        let frame = Frame::looking(v(random.direction()), random.unit_vector(), random.unit_vector());
        let shape = frame.map_or(shape, |frame| shape.placed(frame));
        let (origin, along) = line(&mut random);
        let Ok(ray) = Ray::new(v::<f32>(origin), direction(along)) else { continue };
        let bounds = shape.bounds();
        for hit in &shape.hits(&ray) {
            let point = shape.surface(&ray, hit).point().to_array();
            let (low, high) = (bounds.low.to_array(), bounds.high.to_array());
            assert!((0..3).all(|i| low[i] - 1e-6 <= point[i] && point[i] <= high[i] + 1e-6), "{shape:?} {ray:?}");
            points += 1;
        }
    }
    assert!(points > 500, "{points}");
}

/// Lines in the side: rulings of a hyperboloid and of both nappes of a cone. (Their directions have two equal
/// components to the bit, and `a` is 1.)
fn lines_in_the_side<S: Number, T: Tier<S>>() {
    let ruling = direction::<S>([0.0, 1.0, 1.0]);
    for (waist, from) in [(0.5, [0.5, -2.0, -2.0]), (0.0, [0.0, -2.0, -2.0])] {
        let solid = Revolved::hyperboloid(n::<S>(waist), n(1.0), [n(-1.0), n(1.0)]).expect("sizes");
        let ray = Ray::new(v::<S>(from), ruling).expect("near");
        let hits = solid.hits_at::<T>(&ray);
        let seen: Vec<_> = hits.iter().map(|hit| (hit.part, hit.crossing)).collect();
        assert_eq!(seen, [(Part::Side, Crossing::Enter), (Part::Side, Crossing::Exit)], "{solid:?}");
        assert!(solid.open().hits_at::<T>(&ray).coincident().is_some(), "{solid:?}");
        let start = Ray::new(v::<S>([from[0], 0.5, 0.5]), ruling).expect("near");
        let away = |leaving| start.departing(Departure { object: 0, part: Part::Side, leaving });
        let inwards = solid.hits_at::<T>(&away(Leaving::Inwards));
        assert_eq!(inwards.iter().map(|hit| hit.crossing).collect::<Vec<_>>(), [Crossing::Exit], "{solid:?}");
        let outwards = solid.hits_at::<T>(&away(Leaving::Outwards));
        assert!(outwards.is_empty() && !outwards.starts_inside(), "{solid:?}: {outwards:?}");
        let outwards = solid.open().hits_at::<T>(&away(Leaving::Outwards));
        assert!(outwards.is_empty() && outwards.coincident().is_none(), "{solid:?}: {outwards:?}");
    }
}

#[test]
fn lines_in_the_side_run_from_plane_to_plane() {
    lines_in_the_side::<f32, Stable>();
    lines_in_the_side::<f32, Exact>();
    lines_in_the_side::<f64, Stable>();
    lines_in_the_side::<I16F16, Stable>();
    lines_in_the_side::<I16F16, Exact>();
}

/// Both sheets of a hyperboloid, so close to each other that rounding excuses the gap: a ray that leaves one outwards
/// meets the other.
#[test]
fn a_ray_from_one_sheet_meets_the_other() {
    for b in [1e-12_f32, -1e-12, 0.0] {
        let both = Revolved::new(1.0, b, 0.0, [-1.0, 1.0]).expect("a gap of some roundings");
        let departure = Departure { object: 0, part: Part::Side, leaving: Leaving::Outwards };
        for (from, along) in [(-0.5, 1.0), (0.5, -1.0)] {
            let ray = Ray::new(Vec3::new(0.5_f32, from, 0.0), UnitVec3::from_f64([0.0, along, 0.0]).expect("a length"));
            let ray = ray.expect("near").departing(departure);
            let crossings: Vec<_> = both.hits_at::<Exact>(&ray).iter().map(|hit| hit.crossing).collect();
            assert_eq!(crossings, [Crossing::Enter, Crossing::Exit], "{b}: {ray:?}");
        }
    }
}

/// A shallow dish has a sharp rim: what a list answers beside it, a hierarchy answers too.
fn beside_a_sharp_rim<S: Number, T: Tier<S>>() {
    let mut random = Random(0x5a4b);
    let mut met = 0;
    for _ in 0..200 {
        let (radius, sag) = (random.between(0.5, 1.6), 10.0_f64.powf(random.between(-5.0, -1.0)));
        let Ok(focus) = S::from_f64(radius * radius / (4.0 * sag)) else { continue };
        let Ok(dish) = Revolved::paraboloid(focus, n(sag)) else { continue };
        let other = Shape::new(dish).placed(Frame::at(v([9.0, 0.0, 0.0])).expect("near"));
        let list = [Shape::new(dish), other, other, other, Shape::new(dish)];
        let mut nodes = [Node::<S>::EMPTY; Hierarchy::<f32>::nodes_for(5)];
        let shapes = Shapes::new(&list, &mut nodes).expect("few");
        for _ in 0..50 {
            let beside = random.between(-1.0, 1.0) * 10.0_f64.powf(random.between(-7.0, -2.0));
            let turn = random.between(0.0, std::f64::consts::TAU);
            let rim = [(radius + beside) * turn.cos(), sag, (radius + beside) * turn.sin()];
            let flat = random.direction();
            let along = direction::<S>([flat[0], flat[1] * 10.0_f64.powf(random.between(-6.0, 0.0)), flat[2]]);
            let start = along.to_f64();
            let Ok(ray) = Ray::new(v::<S>([0, 1, 2].map(|i| rim[i] - 3.0 * start[i])), along) else { continue };
            let first = list.iter().filter_map(|shape| shape.nearest_at::<T>(&ray).map(|hit| hit.t));
            let first = first
                .fold(None, |first: Option<S>, t| Some(first.map_or(t, |first| if t < first { t } else { first })));
            assert_eq!(shapes.nearest_at::<T>(&ray).map(|(_, hit)| hit.t), first, "{dish:?} {ray:?}");
            met += usize::from(first.is_some());
        }
    }
    assert!(met > 500, "{met}");
}

#[test]
fn a_hierarchy_loses_no_hit_beside_a_sharp_rim() {
    call_in_every_tier!(beside_a_sharp_rim);
}

#[test]
fn what_is_no_quadric_between_planes_is_refused() {
    let new = |a: f32, b: f32, radius: f32, heights| Revolved::new(a, b, radius, heights).map(|_| ());
    let large = f32::MAX;
    for (refused, error) in [
        (new(f32::NAN, 0.0, 1.0, [0.0, 1.0]), SizeError::Coefficient(ValueError::NotFinite)),
        (new(large, 0.0, 1.0, [0.0, 1.0]), SizeError::Coefficient(ValueError::BeyondBudget)),
        (new(0.0, -large, 1.0, [0.0, 1.0]), SizeError::Coefficient(ValueError::BeyondBudget)),
        (new(0.0, 0.0, -1.0, [0.0, 1.0]), SizeError::Radius(ValueError::Negative)),
        (new(0.0, 0.0, 1.0, [0.0, large]), SizeError::Height(ValueError::BeyondBudget)),
        (new(0.0, 0.0, 1.0, [1.0, 1.0]), SizeError::Heights),
        (new(0.0, 0.0, 0.0, [0.0, 1.0]), SizeError::Outline),
        (new(-1.0, 0.0, 1.0, [0.0, 1.5]), SizeError::Outline),
        // Both sheets of a hyperboloid.
        (new(1.0, 2.0, 1.0, [-5.0, 1.0]), SizeError::Outline),
    ] {
        assert_eq!(refused, Err(error));
    }
    assert_eq!(SizeError::Heights.to_string(), "the lower height is not below the upper one");
    assert_eq!(SizeError::Outline.to_string(), "there is no radius at a height between the ends, or none above zero");
    assert!(SizeError::Coefficient(ValueError::BeyondBudget).to_string().starts_with("a coefficient "));
    let refused = |made: Result<Revolved<f32>, SizeError>| made.expect_err("it is none");
    assert_eq!(refused(Revolved::tower(1.0, 2.0, 3.0, 1.0)), SizeError::Outline);
    assert_eq!(refused(Revolved::tower(1.0, 1.0, 1.0, 1.0)), SizeError::Outline);
    assert_eq!(refused(Revolved::optical(1.0, 0.0, 2.5)), SizeError::Outline);
    assert!(matches!(refused(Revolved::paraboloid(0.0, 1.0)), SizeError::Radius(_)));
    assert!(matches!(refused(Revolved::hyperboloid(1.0, 0.0, [0.0, 1.0])), SizeError::Slope(_)));
}
