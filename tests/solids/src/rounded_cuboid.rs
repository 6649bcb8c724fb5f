//! Rounded cuboids: random ones beside exact arithmetic, and what they are where the core has no extent. Rows and laws
//! of some of them stand among those of all primitives.

use crate::drawn::{departures_pair_up, is_exact};
use crate::values::n;
use fixed::types::{I8F24, I16F16};
use raylet::{
    Crossing, Exact, Frame, Hit, Part, Ray, RoundedCuboid, Shape, SizeError, Sphere, Tier, UnitVec3, ValueError, Vec3,
};
use support::amount::times;
use support::call_in_every_tier;
use support::cases::{direction, v};
use support::described::Described;
use support::exact_types::{Exact as Number, exact_line, expected_of};
use support::oracle::{self, Solid};
use support::random::Random;

/// A rounded cuboid whose sizes are multiples of a quarter, or any; some without extent along an axis, some nearly
/// sharp.
fn rounded_cuboid<S: Number>(random: &mut Random) -> Option<(Shape<S>, Solid)> {
    let quarters = |x: f64| (x * 4.0).round() / 4.0;
    let half = [(); 3].map(|()| random.between(0.0, 1.25));
    let radius = random.between(0.13, 0.75);
    let (half, radius) = match random.below(4) {
        0 => (half.map(quarters), quarters(radius)),
        1 => (half, radius),
        2 => (half.map(|size| if random.below(2) == 0 { 0.0 } else { quarters(size) }), radius),
        _ => (half, 10.0_f64.powf(random.between(-4.0, -1.0))),
    };
    let described = Described::RoundedCuboid { half, radius };
    let sized = described.try_map(|size| S::from_f64(*size)).ok()?;
    Some((sized.shape().ok()?, sized.solid()))
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_f32() {
    let hits_of = is_exact::<f32, Exact>(rounded_cuboid);
    assert_eq!(hits_of[3..], [0, 0]);
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_fixed_point() {
    let hits_of = is_exact::<I16F16, Exact>(rounded_cuboid);
    assert_eq!(hits_of[3..], [0, 0]);
    let hits_of = is_exact::<I8F24, Exact>(rounded_cuboid);
    assert_eq!(hits_of[3..], [0, 0]);
}

fn leaves<S: Number, T: Tier<S>>() {
    departures_pair_up::<S, T>(rounded_cuboid);
}

#[test]
fn rays_leave_in_every_tier() {
    call_in_every_tier!(leaves);
}

/// A core that is a point makes a ball: the same hits as the sphere's, but for units.
fn of_a_point<S: Number, T: Tier<S>>() {
    let mut random = Random(0xba11);
    let (one, zero) = (S::from_f64(1.0).expect("a size"), S::ZERO);
    let (cuboid, ball) = (RoundedCuboid::new(zero, zero, zero, one).expect("sizes"), Sphere::new(one).expect("a size"));
    for _ in 0..times(2_000) {
        let [from, at] = [4.0, 0.9].map(|reach| random.direction().map(|c| c * reach));
        let Ok(ray) = Ray::towards(v::<S>(from), v(at)) else { continue };
        let (own, other) = (cuboid.hits_at::<T>(&ray), ball.hits_at::<T>(&ray));
        assert_eq!(own.len(), other.len(), "{ray:?}: {own:?} {other:?}");
        let unit = S::unit_at(&(&S::from_f64(4.0).expect("near").exact()).into()).to_f64();
        for (a, b) in own.iter().zip(&other) {
            let is_near = (a.t.to_f64() - b.t.to_f64()).abs() <= 256.0 * unit;
            assert!(is_near && a.crossing == b.crossing, "{ray:?}: {own:?} {other:?}");
        }
    }
}

#[test]
fn a_core_that_is_a_point_makes_a_ball() {
    call_in_every_tier!(of_a_point);
}

/// A core that is a segment makes a capsule, whose balls lie beyond its ends.
#[test]
fn the_surface_of_a_segment_is_that_of_the_capsule() {
    let pill = Shape::new(RoundedCuboid::new(0.0_f64, 1.0, 0.0, 0.5).unwrap());
    let mut random = Random(0x9111);
    for _ in 0..times(2_000) {
        let [from, at] = [4.0, 0.4].map(|reach| random.direction().map(|c| c * reach));
        let Some(hit) = pill.nearest(&Ray::towards(v(from), v(at)).unwrap()) else { continue };
        let surface = pill.surface(&Ray::towards(v(from), v(at)).unwrap(), &hit);
        let (point, normal) = (surface.point(), surface.normal());
        let beyond = (point.y.abs() - 1.0).max(0.0).copysign(point.y);
        let wanted = UnitVec3::new(Vec3 { y: beyond, ..point }).unwrap();
        assert!(normal.dot(wanted) > 1.0 - 1e-12, "{hit:?}: {normal:?} {wanted:?}");
    }
}

/// Along its faces, edges and seams, and touching it.
#[test]
fn rays_in_the_surface() {
    let soap = RoundedCuboid::new(1.0_f32, 0.5, 0.75, 0.25).unwrap();
    let hits = |origin: [f32; 3], direction: [f32; 3]| {
        let ray = Ray::new(origin.into(), UnitVec3::new(direction.into()).unwrap()).unwrap();
        let hits = soap.hits_at::<Exact>(&ray);
        assert_eq!(soap.nearest_at::<Exact>(&ray), hits.first().copied());
        hits.iter().map(|hit| (hit.t, hit.part, hit.crossing)).collect::<Vec<_>>()
    };
    let (enter, exit, touch) = (Crossing::Enter, Crossing::Exit, Crossing::Touch);
    // In the plane of the top: over the core.
    let over = [(2.0, Part::Top, enter), (4.0, Part::Top, exit)];
    assert_eq!(hits([-3.0, 0.75, 0.0], [1.0, 0.0, 0.0]), over);
    // Along the seam between the top and an edge.
    assert_eq!(hits([-3.0, 0.75, 0.75], [1.0, 0.0, 0.0]), over);
    // In the plane of the top, beside the core.
    assert_eq!(hits([-3.0, 0.75, 0.8], [1.0, 0.0, 0.0]), []);
    // Along an edge, in its surface: the excesses are 0.75 and 1.
    let thick = RoundedCuboid::new(1.0_f32, 0.5, 0.75, 1.25).unwrap();
    let ray = Ray::new(Vec3::new(-3.0, 1.25, 1.75), UnitVec3::X).unwrap();
    let along: Vec<_> = thick.hits_at::<Exact>(&ray).iter().map(|hit| (hit.t, hit.part, hit.crossing)).collect();
    assert_eq!(along, [(2.0, Part::Side, enter), (4.0, Part::Side, exit)]);
    // Touching an edge from above, at a seam of the top.
    assert_eq!(hits([1.0, 0.75, -3.0], [0.0, 0.0, 1.0]), [(2.25, Part::Top, enter), (3.75, Part::Top, exit)]);
    assert_eq!(hits([1.25, -3.0, 0.75], [0.0, 1.0, 0.0]), [(2.5, Part::Right, enter), (3.5, Part::Right, exit)]);
    let above = hits([0.0, 0.75, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(above, [(1.0, Part::Top, exit)]);
    assert_eq!(hits([1.0, 0.75, 0.0], [1.0, 0.0, 0.0]), [(0.0, Part::Top, exit)]);
    let flat = RoundedCuboid::new(0.0_f32, 0.5, 0.75, 0.25).unwrap();
    let ray = Ray::new(Vec3::new(-3.0, 0.75, 0.0), UnitVec3::X).unwrap();
    let touches: Vec<_> = flat.hits_at::<Exact>(&ray).iter().map(|hit| (hit.t, hit.part, hit.crossing)).collect();
    assert_eq!(touches, [(3.0, Part::Top, touch)]);
}

/// A combination asks for the normal at the start of a ray that it made a hit of: where the line leaves, it was that
/// of the piece by which it had entered.
#[test]
fn the_normal_at_a_point_is_that_of_its_own_piece() {
    let one = n::<I16F16>(1.0);
    let soap = Shape::new(RoundedCuboid::new(one, one, one, n(0.25)).unwrap());
    let mut random = Random(0x50a9);
    for _ in 0..times(2_000) {
        // A point of an edge or a corner, and a line that leaves there.
        let away = random.direction();
        let core = [0, 1, 2].map(|i| if random.below(3) == 0 { random.between(-1.0, 1.0) } else { away[i].signum() });
        let excess = [0, 1, 2].map(|i| if core[i].abs() == 1.0 { away[i] } else { 0.0 });
        let length = excess.iter().map(|c| c * c).sum::<f64>().sqrt();
        if excess.iter().filter(|c| c.abs() > 0.05).count() < 2 {
            continue;
        }
        let point = v::<I16F16>([0, 1, 2].map(|i| core[i] + 0.25 * excess[i] / length));
        let along: UnitVec3<I16F16> = random.unit_vector();
        let ray = Ray::new(point, along).unwrap();
        let hit = Hit { t: I16F16::ZERO, part: Part::Side, crossing: Crossing::Enter };
        let normal = soap.surface(&ray, &hit).normal().to_f64();
        let off = [0, 1, 2].map(|i| (normal[i] - excess[i] / length).abs());
        // The point is rounded, by more along a line that grazes.
        assert!(off.iter().all(|c| *c < 5e-3), "{ray:?}: {normal:?} {excess:?}");
    }
}

/// Where the radius is small beside the core, the leading digits of coordinates are the core's.
#[test]
fn normals_are_accurate_at_any_radius() {
    let mut random = Random(0x4a22);
    for _ in 0..times(4_000) {
        let radius = 10.0_f64.powf(random.between(-3.5, -0.5));
        let (fine, half) = (n::<f32>(radius), [1.0_f32, 0.75, 0.5]);
        let soap = Shape::new(RoundedCuboid::new(half[0], half[1], half[2], fine).unwrap());
        // At a corner, seen from nearly above it.
        let signs = [(); 3].map(|()| random.sign());
        let out = [0, 1, 2].map(|i| signs[i] * random.between(0.2, 1.0));
        let at = [0, 1, 2].map(|i| signs[i] * f64::from(half[i]) + 0.5 * radius * out[i]);
        let Ok(ray) = Ray::towards(v::<f32>([0, 1, 2].map(|i| at[i] + 3.0 * out[i])), v(at)) else { continue };
        let Some(hit) = soap.nearest(&ray).filter(|hit| hit.part == Part::Side) else { continue };
        let exact = expected_of(&rounded(half, fine), &exact_line(&ray), &ray).hits.remove(0);
        let wanted = oracle::normal(&rounded(half, fine), oracle::Part::Side, &exact.t, &exact_line(&ray));
        for soap in [soap, soap.placed(Frame::at(Vec3::ZERO).unwrap())] {
            let normal = soap.surface(&ray, &hit).normal().to_f64();
            let off = [0, 1, 2].map(|i| (normal[i] - wanted[i].to_f64()).abs() * 2.0_f64.powi(24));
            assert!(off.iter().all(|c| *c <= 16.0), "{radius}: {off:?} units: {soap:?} {ray:?}");
        }
    }
}

fn rounded(half: [f32; 3], radius: f32) -> Solid {
    Described::RoundedCuboid { half, radius }.solid()
}

/// A point of an edge that rounding has put over the top belongs to the side next to it.
#[test]
fn coordinates_next_to_a_seam_are_those_of_the_edge() {
    let soap = Shape::new(RoundedCuboid::new(n::<I16F16>(2.0), n(0.5), n(1.0), n(0.25)).unwrap());
    let unit = 2.0_f64.powi(-16);
    for z in [1.0, 1.0 - unit] {
        for along in [1.3 * unit / 5.0, 0.3 * unit / 5.0, 0.0] {
            let ray = Ray::new(v::<I16F16>([0.0, 5.75, z]), direction([0.0, -1.0, along])).unwrap();
            let Some(hit) = soap.nearest_at::<Exact>(&ray).filter(|hit| hit.part == Part::Side) else { continue };
            let surface = soap.surface(&ray, &hit);
            assert!((surface.uv().0.to_num::<f64>() - 0.5).abs() < 1e-3, "{ray:?}: {:?}", surface.uv());
            assert_eq!(surface.tangents().0, UnitVec3::X, "{ray:?}");
        }
    }
}

#[test]
fn sizes_that_are_none_are_refused() {
    let new = |x: f32, y: f32, radius: f32| RoundedCuboid::new(x, y, 1.0, radius);
    assert_eq!(new(1.0, 1.0, 0.0), Err(SizeError::Radius(ValueError::Zero)));
    assert_eq!(new(1.0, -1.0, 1.0), Err(SizeError::HalfExtent(ValueError::Negative)));
    assert_eq!(new(f32::INFINITY, 1.0, 1.0), Err(SizeError::HalfExtent(ValueError::NotFinite)));
    assert!(new(0.0, -0.0, 1.0).is_ok_and(|cuboid| cuboid.half_extents()[1].is_sign_positive()));
    let most = I16F16::from_num(16383);
    let beyond = RoundedCuboid::new(most, most, most, most);
    assert_eq!(beyond.unwrap_err().to_string(), "a half extent is beyond the number type's budget");
}
