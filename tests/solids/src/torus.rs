//! Tori: random ones beside exact arithmetic, lines that touch them, rays that depart, and their surface. Rows and laws
//! of some of them stand among those of all primitives.

use crate::drawn::{departures_pair_up, is_exact};
use crate::values::n;
use fixed::types::{I8F24, I16F16, I32F32};
use raylet::shape::kinds::Kind;
use raylet::thick::{ThickError, ThickRay};
use raylet::{
    Combination, Crossing, Cuboid, Departure, Exact, Frame, Hits, Leaving, Part, Range, Ray, Shape, SizeError, Stable,
    Tier, Torus, UnitVec3, ValueError, Vec3,
};
use std::f64::consts::TAU;
use support::amount::times;
use support::call_in_every_tier;
use support::cases::{direction, v};
use support::described::Described;
use support::exact_types::Exact as Number;
use support::oracle::Solid;
use support::random::{Random, cross, dot};

/// A torus whose radii are multiples of a quarter, or any; with a hole down to a ten-thousandth, or as thin as a
/// thousandth.
fn torus<S: Number>(random: &mut Random) -> Option<(Shape<S>, Solid)> {
    let quarters = |x: f64| (x * 4.0).round() / 4.0;
    let major = random.between(0.5, 2.0);
    let (major, minor) = match random.below(4) {
        0 => (quarters(major), quarters(major * random.unit())),
        1 => (major, major * random.unit()),
        2 => (major, major * (1.0 - 10.0_f64.powf(random.between(-4.0, -1.0)))),
        _ => (major, major * 10.0_f64.powf(random.between(-3.0, -1.0))),
    };
    let sized = Described::Torus { major, minor }.try_map(|size| S::from_f64(*size)).ok()?;
    Some((sized.shape().ok()?, sized.solid()))
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_f32() {
    let hits_of = is_exact::<f32, Exact>(torus);
    assert!(hits_of[3] > 9 && hits_of[4] > 99, "{hits_of:?}");
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_fixed_point() {
    let hits_of = is_exact::<I16F16, Exact>(torus);
    assert!(hits_of[3] > 9 && hits_of[4] > 99, "{hits_of:?}");
    let hits_of = is_exact::<I8F24, Exact>(torus);
    assert!(hits_of[3] > 9 && hits_of[4] > 99, "{hits_of:?}");
}

fn leaves<S: Number, T: Tier<S>>() {
    departures_pair_up::<S, T>(torus);
}

#[test]
fn rays_leave_in_every_tier() {
    call_in_every_tier!(leaves);
}

/// The torus of the rows below: its numbers, and those of the rays, are small multiples of a quarter.
fn ring<S: Number>() -> Shape<S> {
    Shape::new(Torus::new(n::<S>(1.0), n(0.25)).expect("sizes"))
}

/// Fails unless these are the hits of a query, and all queries agree about them. `t` may be off by its last bits.
fn assert_told<S: Number, T: Tier<S>>(shape: &Shape<S>, ray: &Ray<S>, want: &[(f64, Crossing)], what: &str) {
    let told = || format!("{what}, in {} of {}: {ray:?}", std::any::type_name::<T>(), S::name());
    let hits: Hits<S> = shape.hits_at::<T>(ray);
    let is_near = |got: S, want: f64| (got.to_f64() - want).abs() < 2e-3;
    let is_same = hits.len() == want.len()
        && hits
            .iter()
            .zip(want)
            .all(|(hit, (t, crossing))| is_near(hit.t, *t) && hit.crossing == *crossing && hit.part == Part::Side);
    assert!(is_same, "{}: {hits:?}, not {want:?}", told());
    assert_eq!(shape.nearest_at::<T>(ray), hits.first().copied(), "{}", told());
    assert_eq!(shape.occludes_at::<T>(ray), !hits.is_empty(), "{}", told());
}

/// The hits of a whole line.
fn assert_on_line<S: Number, T: Tier<S>>(from: [f64; 3], along: [f64; 3], want: &[(f64, Crossing)], what: &str) {
    let ray = Ray::new(v::<S>(from), direction(along)).expect("near").with_range(Range::line());
    assert_told::<S, T>(&ring(), &ray, want, what);
}

use Crossing::{Enter, Exit, Touch};

/// Lines that cross the surface or pass it by.
fn lines_across<S: Number, T: Tier<S>>() {
    let up = |x: f64, want: &[(f64, Crossing)], what| {
        assert_on_line::<S, T>([x, -1.0, 0.0], [0.0, 1.0, 0.0], want, what);
    };
    up(0.0, &[], "along the axis");
    up(0.5, &[], "through the hole");
    up(1.0, &[(0.75, Enter), (1.25, Exit)], "through the middle of the tube");
    up(1.5, &[], "beside the ring");
    let across = |y: f64, z: f64, want: &[(f64, Crossing)], what| {
        assert_on_line::<S, T>([-3.0, y, z], [1.0, 0.0, 0.0], want, what);
    };
    let four = [(1.75, Enter), (2.25, Exit), (3.75, Enter), (4.25, Exit)];
    across(0.0, 0.0, &four, "in the plane of the equators");
    across(0.0, 1.0, &[(2.25, Enter), (3.75, Exit)], "between the equators");
    across(0.0, 1.5, &[], "beside the outer equator");
    across(0.5, 0.0, &[], "above the ring");
    across(-0.5, 0.0, &[], "below the ring");
    assert_on_line::<S, T>([0.0, 1.0, 0.0], [0.6, -0.8, 0.0], &[(1.25, Enter), (1.55, Exit)], "slanted");
}

#[test]
fn lines_across_a_torus_are_met_in_every_tier() {
    call_in_every_tier!(lines_across);
}

/// Lines that touch the surface.
fn lines_that_touch<S: Number, T: Tier<S>>() {
    let up = |x: f64, want: &[(f64, Crossing)], what| {
        assert_on_line::<S, T>([x, -1.0, 0.0], [0.0, 1.0, 0.0], want, what);
    };
    up(0.75, &[(1.0, Touch)], "along the inner equator from within the hole");
    up(1.25, &[(1.0, Touch)], "along the outer equator");
    let across = |y: f64, z: f64, want: &[(f64, Crossing)], what| {
        assert_on_line::<S, T>([-3.0, y, z], [1.0, 0.0, 0.0], want, what);
    };
    across(0.0, 1.25, &[(3.0, Touch)], "touching the outer equator in its plane");
    // The square of the length within the solid is (5/4)^2 - (3/4)^2.
    across(0.0, 0.75, &[(2.0, Enter), (4.0, Exit)], "touching the inner equator from within the solid");
    for y in [0.25, -0.25] {
        across(y, 1.0, &[(3.0, Touch)], "touching the highest or the lowest circle, four times at one point");
        across(y, 0.0, &[(2.0, Touch), (4.0, Touch)], "across that circle");
        across(y, 1.25, &[], "beside that circle in its plane");
    }
}

#[test]
fn lines_that_touch_a_torus_do_in_the_exact_tier() {
    lines_that_touch::<f32, Exact>();
    lines_that_touch::<I16F16, Exact>();
    lines_that_touch::<I8F24, Exact>();
}

#[test]
fn lines_that_touch_a_torus_do_by_default() {
    lines_that_touch::<f32, Stable>();
    lines_that_touch::<f64, Stable>();
    lines_that_touch::<I16F16, Stable>();
    lines_that_touch::<I32F32, Stable>();
}

/// A touch lies at `t` to the bit where that is a small number.
#[test]
fn touches_are_exact_where_their_distance_is() {
    fn check<S: Number, T: Tier<S>>() {
        let told = |from: [f64; 3]| {
            let ray = Ray::new(v::<S>(from), UnitVec3::X).expect("near");
            ring::<S>().hits_at::<T>(&ray).iter().map(|hit| (hit.t.to_f64(), hit.crossing)).collect::<Vec<_>>()
        };
        assert_eq!(told([-3.0, 0.25, 1.0]), [(3.0, Touch)]);
        assert_eq!(told([-3.0, 0.25, 0.0]), [(2.0, Touch), (4.0, Touch)]);
        assert_eq!(told([-3.0, 0.0, 1.25]), [(3.0, Touch)]);
        assert_eq!(told([-3.0, 0.0, 0.0]), [(1.75, Enter), (2.25, Exit), (3.75, Enter), (4.25, Exit)]);
    }
    check::<f32, Exact>();
    check::<I16F16, Exact>();
    check::<I8F24, Exact>();
}

/// From within the solid the first crossing is an exit.
fn from_inside<S: Number, T: Tier<S>>() {
    let from = |along: [f64; 3], want: &[(f64, Crossing)]| {
        let ray = Ray::new(v::<S>([1.0, 0.0, 0.0]), direction(along)).expect("near");
        assert_told::<S, T>(&ring(), &ray, want, "from inside");
        assert!(ring::<S>().hits_at::<T>(&ray).starts_inside());
    };
    from([1.0, 0.0, 0.0], &[(0.25, Exit)]);
    from([-1.0, 0.0, 0.0], &[(0.25, Exit), (1.75, Enter), (2.25, Exit)]);
    from([0.0, 1.0, 0.0], &[(0.25, Exit)]);
    from([0.0, 0.0, 1.0], &[(0.75, Exit)]);
    // In the hole and beside the ring it starts outside.
    for (x, want) in [(0.0, &[(0.75, Enter), (1.25, Exit)][..]), (1.5, &[])] {
        let ray = Ray::new(v::<S>([x, 0.0, 0.0]), UnitVec3::X).expect("near");
        assert_told::<S, T>(&ring(), &ray, want, "from outside");
        assert!(!ring::<S>().hits_at::<T>(&ray).starts_inside());
    }
}

#[test]
fn rays_from_inside_leave_first() {
    call_in_every_tier!(from_inside);
}

/// From the inner equator outwards, which is into the hole, a ray meets the other side of the ring; inwards it leaves by
/// the outer equator; and from there inwards it meets both sides of the hole.
fn departures<S: Number, T: Tier<S>>() {
    let from = |start: [f64; 3], along: [f64; 3], leaving, want: &[(f64, Crossing)]| {
        let ray = Ray::new(v::<S>(start), direction(along)).expect("near");
        let ray = ray.departing(Departure { object: 0, part: Part::Side, leaving });
        assert_told::<S, T>(&ring(), &ray, want, &format!("departing {leaving:?} from {start:?}"));
    };
    use Leaving::{Inwards, Outwards};
    let (left, right) = ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    from([-0.75, 0.0, 0.0], right, Outwards, &[(1.5, Enter), (2.0, Exit)]);
    from([-0.75, 0.0, 0.0], left, Inwards, &[(0.5, Exit)]);
    from([-1.25, 0.0, 0.0], right, Inwards, &[(0.5, Exit), (2.0, Enter), (2.5, Exit)]);
    from([-1.25, 0.0, 0.0], left, Outwards, &[]);
    from([1.0, 0.25, 0.0], [0.0, 1.0, 0.0], Outwards, &[]);
    from([1.0, 0.25, 0.0], [0.0, -1.0, 0.0], Inwards, &[(0.5, Exit)]);
    // Up through the hole from the side of the tube, and down to the other one.
    from([0.75, 0.0, 0.0], [0.0, 1.0, 0.0], Outwards, &[]);
    from([0.0, 0.0, -0.75], [0.0, 0.0, 1.0], Outwards, &[(1.5, Enter), (2.0, Exit)]);
}

#[test]
fn a_ray_that_departs_into_the_hole_meets_the_other_side() {
    call_in_every_tier!(departures);
}

/// Along the plane of the highest circle a ray that departs from it touches it on the other side, and meets nothing
/// behind its start.
#[test]
fn a_ray_that_departs_along_the_surface_touches_the_other_side() {
    fn check<S: Number, T: Tier<S>>() {
        let from = |along: f64, want: &[(f64, Crossing)]| {
            let ray = Ray::new(v::<S>([1.0, 0.25, 0.0]), direction([along, 0.0, 0.0])).expect("near");
            let ray = ray.departing(Departure { object: 0, part: Part::Side, leaving: Leaving::Outwards });
            assert_told::<S, T>(&ring(), &ray, want, "departing along the highest circle's plane");
        };
        from(-1.0, &[(2.0, Touch)]);
        from(1.0, &[]);
    }
    check::<f32, Exact>();
    check::<I16F16, Exact>();
    check::<I8F24, Exact>();
}

#[test]
fn radii_that_leave_no_hole_are_refused() {
    assert_eq!(SizeError::Ring.message(), "the minor radius is not below the major one");
    for minor in [1.0, 2.0] {
        assert_eq!(Torus::new(n::<f32>(1.0), n(minor)), Err(SizeError::Ring));
        assert_eq!(Torus::new(n::<I16F16>(1.0), n(minor)), Err(SizeError::Ring));
    }
    assert_eq!(Torus::new(0.0_f32, 0.5), Err(SizeError::Radius(ValueError::Zero)));
    assert_eq!(Torus::new(1.0_f32, 0.0), Err(SizeError::Radius(ValueError::Zero)));
    assert_eq!(Torus::new(1.0_f32, -0.5), Err(SizeError::Radius(ValueError::Negative)));
    assert_eq!(Torus::new(f32::NAN, 0.5), Err(SizeError::Radius(ValueError::NotFinite)));
    assert_eq!(Torus::new(1.0_f32, f32::INFINITY), Err(SizeError::Radius(ValueError::NotFinite)));
    assert_eq!(Torus::<f32>::const_new(1.0, 1.0), Err(SizeError::Ring));
    let thinnest = Torus::new(1.0_f32, 1.0_f32.next_down()).expect("a hole of one unit");
    assert_eq!((thinnest.major_radius(), thinnest.minor_radius()), (1.0, 1.0_f32.next_down()));
}

/// A torus, an angle around the axis and one around the tube: the point there, and the outward normal.
fn at([major, minor]: [f64; 2], around: f64, tube: f64) -> ([f64; 3], [f64; 3]) {
    let [x, z] = [around.cos(), -around.sin()];
    let normal = [x * tube.cos(), tube.sin(), z * tube.cos()];
    let from_axis = major + minor * tube.cos();
    ([x * from_axis, minor * tube.sin(), z * from_axis], normal)
}

/// Normal, surface coordinates and tangents of points all over the surface, as the angles there say.
#[test]
fn the_surface_is_known_by_two_angles() {
    let mut random = Random(0x7025);
    for _ in 0..times(2_000) {
        let major = random.between(0.5, 2.0);
        let minor = major * random.between(0.05, 0.95);
        let (around, tube) = (random.unit() * TAU, random.unit() * TAU);
        let (point, normal) = at([major, minor], around, tube);
        let shape = Shape::new(Torus::new(major, minor).expect("sizes"));
        // From just outside: nothing else is before it.
        let off = minor * 1e-3;
        let from = [0, 1, 2].map(|i| point[i] + normal[i] * off);
        let ray = Ray::new(v::<f64>(from), direction(normal.map(|c| -c))).expect("near");
        let hit = shape.nearest(&ray).expect("it leads to the surface");
        assert!((hit.t - off).abs() < 1e-12 && hit.crossing == Enter, "{shape:?} {ray:?}: {hit:?}");
        let surface = shape.surface(&ray, &hit);
        let is_near = |a: [f64; 3], b: [f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-9);
        assert!(is_near(surface.point().to_f64(), point), "{shape:?}: {:?}, not {point:?}", surface.point());
        assert!(is_near(surface.normal().to_f64(), normal), "{shape:?}: {:?}, not {normal:?}", surface.normal());
        let (u, v) = surface.uv();
        let is_near_turn = |a: f64, b: f64| ((a - b / TAU + 0.5).rem_euclid(1.0) - 0.5).abs() < 1e-9;
        assert!(is_near_turn(u, around) && is_near_turn(v, tube), "{shape:?} {point:?}: {u} {v}");
        let (along_u, along_v) = surface.tangents();
        let (along_u, along_v) = (along_u.to_f64(), along_v.to_f64());
        // Where `u` and `v` grow: the derivatives of the point by the angles.
        let upwards = [-around.cos() * tube.sin(), tube.cos(), around.sin() * tube.sin()];
        assert!(is_near(along_u, [-around.sin(), 0.0, -around.cos()]), "{shape:?} {point:?}: {along_u:?}");
        assert!(is_near(along_v, upwards), "{shape:?} {point:?}: {along_v:?}, not {upwards:?}");
        assert!(is_near(cross(along_u, along_v), normal), "not right-handed");
    }
}

#[test]
fn the_outer_equator_is_where_v_begins() {
    let seen = |from: [f64; 3], along: [f64; 3]| {
        let ray = Ray::new(v::<f64>(from), direction(along)).expect("near");
        let hit = ring::<f64>().nearest(&ray).expect("it leads to the surface");
        let surface = ring().surface(&ray, &hit);
        (surface.normal(), surface.uv())
    };
    assert_eq!(seen([3.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), (UnitVec3::X, (0.0, 0.0)));
    assert_eq!(seen([1.0, 3.0, 0.0], [0.0, -1.0, 0.0]), (UnitVec3::Y, (0.0, 0.25)));
    assert_eq!(seen([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]), (-UnitVec3::X, (0.0, 0.5)));
    assert_eq!(seen([1.0, -3.0, 0.0], [0.0, 1.0, 0.0]), (-UnitVec3::Y, (0.0, 0.75)));
    assert_eq!(seen([0.0, 0.0, -3.0], [0.0, 0.0, 1.0]), (-UnitVec3::Z, (0.25, 0.0)));
}

/// Points of the surface and of the circle in the middle of the tube belong to it, those of the hole do not.
fn contains<S: Number, T: Tier<S>>() {
    let ring = ring::<S>();
    let inside = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.125, 0.0], [0.6, 0.0, 0.8]];
    let on = [[1.25, 0.0, 0.0], [-0.75, 0.0, 0.0], [0.0, 0.25, 1.0], [0.0, -0.25, -1.0]];
    for point in inside.into_iter().chain(on) {
        assert!(ring.contains_at::<T>(v(point)), "{point:?}");
    }
    for point in [[0.0; 3], [0.5, 0.0, 0.0], [1.5, 0.0, 0.0], [1.0, 0.5, 0.0], [0.0, 0.25, 0.0], [1.25, 0.25, 0.0]] {
        assert!(!ring.contains_at::<T>(v(point)), "{point:?}");
    }
}

#[test]
fn the_hole_does_not_belong_to_it() {
    call_in_every_tier!(contains);
}

/// Every point of a turned torus is within its bounds, and they are no larger than its points need.
#[test]
fn bounds_are_those_of_the_points() {
    let bounds = ring::<f32>().bounds();
    assert_eq!((bounds.low, bounds.high), (Vec3::new(-1.25, -0.25, -1.25), Vec3::new(1.25, 0.25, 1.25)));
    let mut random = Random(0xb0c5);
    for _ in 0..times(100) {
        let frame = Frame::looking(v::<f64>(random.direction()), random.unit_vector(), random.unit_vector());
        let (major, minor) = (1.0, random.between(0.1, 0.9));
        let shape = Shape::new(Torus::new(major, minor).expect("sizes")).placed(frame.expect("axes"));
        let frame = frame.expect("axes");
        let bounds = shape.bounds();
        let (low, high) = (bounds.low.to_f64(), bounds.high.to_f64());
        for _ in 0..100 {
            let (point, _) = at([major, minor], random.unit() * TAU, random.unit() * TAU);
            let point = frame.point_to_world(v(point)).to_f64();
            assert!((0..3).all(|i| low[i] - 1e-9 < point[i] && point[i] < high[i] + 1e-9), "{shape:?}: {point:?}");
        }
        // Across each axis of the world the farthest point is that whose normal points along it.
        for i in 0..3 {
            let row = frame.axes().map(|axis| axis.to_f64()[i]);
            let reach = major * row[0].hypot(row[2]) + minor * dot(row, row).sqrt();
            let centre = frame.position().to_f64()[i];
            assert!((high[i] - centre - reach).abs() < 1e-9 && (centre - low[i] - reach).abs() < 1e-9, "{shape:?}");
        }
    }
}

/// A cuboid less a torus is met six times along a line through both.
#[test]
fn a_ring_is_cut_from_a_cuboid() {
    fn check<S: Number, T: Tier<S>>() {
        let cuboid = Shape::new(Cuboid::new(n::<S>(2.0), n(1.0), n(2.0)).expect("sizes"));
        let leaves = [cuboid, ring()];
        let less = Combination::difference(&leaves).expect("two solids");
        let ray = Ray::new(v::<S>([-3.0, 0.0, 0.0]), UnitVec3::X).expect("near");
        let hits = less.shape().hits_at::<T>(&ray);
        let met: Vec<_> = hits.iter().map(|hit| ((hit.t.to_f64() * 4.0).round() / 4.0, hit.crossing)).collect();
        let want = [(1.0, Enter), (1.75, Exit), (2.25, Enter), (3.75, Exit), (4.25, Enter), (5.0, Exit)];
        assert_eq!(met, want[..hits.len()]);
        let all: Vec<_> = less.leaf_hits_at::<T>(&ray).map(|on| on.hit.t.to_f64()).collect();
        assert_eq!(all.len(), want.len(), "{all:?}");
    }
    check::<f32, Stable>();
    check::<f64, Stable>();
    check::<I16F16, Exact>();
    check::<I32F32, Stable>();
}

/// What grows out of a torus is one only while there is a hole: the contact of a ball with it is not known.
#[test]
fn a_ball_does_not_touch_a_torus() {
    let ray = Ray::new(Vec3::new(0.0_f32, 3.0, 0.0), -UnitVec3::Y).unwrap();
    let ball = ThickRay::new(ray, 0.5).unwrap();
    assert_eq!(ball.contact_at::<Stable, _>(&ring()), Err(ThickError::Primitive(Kind::Torus)));
}

/// Both crossings of each pair are equal, which the tiers without exact roots find in equal numbers.
#[test]
fn a_ring_less_itself_is_nothing() {
    fn check<S: Number, T: Tier<S>>() {
        let mut random = Random(0x1e55);
        let mut crossed = 0;
        for _ in 0..times(500) {
            let Some((shape, _)) = torus::<S>(&mut random) else { continue };
            let frame = Frame::looking(v(random.direction()), random.unit_vector(), random.unit_vector());
            let Ok(frame) = frame else { continue };
            let leaves = [shape.placed(frame); 2];
            let nothing = Combination::difference(&leaves).expect("two solids");
            for _ in 0..8 {
                let (from, to) = (random.direction().map(|c| 3.0 * c), random.direction());
                let along = direction([0, 1, 2].map(|i| to[i] - from[i]));
                let ray = Ray::new(v(from), along).expect("near").with_range(Range::line());
                crossed += leaves[0].hits_at::<T>(&ray).len();
                assert_eq!(nothing.shape().hits_at::<T>(&ray).len(), 0, "{leaves:?} {ray:?}");
            }
        }
        assert!(crossed > 500, "{crossed}");
    }
    check::<f32, Exact>();
    check::<I16F16, Exact>();
    check::<f32, Stable>();
    check::<I16F16, Stable>();
}
