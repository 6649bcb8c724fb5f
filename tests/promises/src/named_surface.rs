//! Faults 4 and 11 of the first solver: normals and points are those of the exact hit, not of the rounded `t`; surface
//! coordinates are right for every size.

use crate::named::{any_frame, axes, dot, line_in, ray, ray_in, to_world};
use fixed::types::I16F16;
use raylet::scalar::UnitScalar;
use raylet::tier::{Exact, Fast, Stable, Tier};
use raylet::{
    Affine, Capsule, Cone, Cylinder, Frame, Part, Plane, Primitive, Range, Ray, Scalar, Shape, Sphere, Triangle,
    UnitVec3, Vec3,
};
use support::amount::times;
use support::cases::{direction, n, v};
use support::exact_types::{Exact as Number, exact_line, same_part};
use support::oracle::{self, Dyadic, Root};
use support::random::{Random, add, scale};
use support::subject::Subject;
use support::workload::Workload;

promised!(normals_and_points_are_those_of_the_exact_hit, points_near_the_worlds_origin_have_its_small_units);

/// How far a normal or a point may be off, in units of its type.
const MOST: f64 = 4.0;

/// The unit in which a normal is judged: that of a direction's component in floats; in fixed point that of `t`, from
/// which the hit's point is made, since a direction has 14 bits more than any coordinate.
fn component<S: Number>() -> f64 {
    match S::name().as_str() {
        "f32" => 2.0_f64.powi(-24),
        "f64" => 2.0_f64.powi(-53),
        "I16F16" => 2.0_f64.powi(-16),
        _ => 2.0_f64.powi(-32),
    }
}

fn assert_close(found: [f64; 3], exact: [f64; 3], tolerance: f64, what: &str) {
    let far = found.iter().zip(exact).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max);
    // A NaN is not close.
    assert!(far <= tolerance, "{what}: {found:?} is {far:e} off {exact:?}, and may be {tolerance:e}");
}

/// From 1e7 away (a unit of `t` is 1) at y = .95 of the radius: the normal was (0, 1, 0). The exact one is (-sqrt(1 -
/// y^2), y, 0) of y = .095 / .1 as they are stored, and the point is (-sqrt(r^2 - y^2), y, 0).
#[test]
fn a_small_ball_and_a_thin_can_far_away_have_the_normal_of_the_exact_hit() {
    let (radius, near) = (0.1_f32, 0.095_f32);
    let (normal, point) = ([-0.31224997925758063, 0.9499999739229682], [-0.031224998391046793, 0.0949999988079071]);
    let units = MOST * 2.0_f64.powi(-24);
    let ball = Shape::new(Sphere::new(radius).unwrap());
    let can = Shape::new(Cylinder::capped(radius, 1.0).unwrap());
    let rays = [(ball, [-1e7, near, 0.0], [0, 1, 2]), (can, [-1e7, 0.5, near], [0, 2, 1])];
    for (shape, origin, [x, y, z]) in rays {
        let ray = ray(origin, [1.0, 0.0, 0.0]);
        let found = [
            shape.nearest_at::<Stable>(&ray).expect("Stable meets it"),
            shape.nearest_at::<Exact>(&ray).expect("Exact meets it"),
        ];
        for hit in found.into_iter().chain(shape.nearest_at::<Fast>(&ray)) {
            let surface = shape.surface(&ray, &hit);
            let (n, p) = (surface.normal().to_f64(), surface.point().to_f64());
            assert_close([n[x], n[y], n[z]], [normal[0], normal[1], 0.0], units, "normal");
            // A unit of the point is 2^-27.
            let height = if z == 1 { 0.5 } else { 0.0 };
            let tolerance = if z == 1 { units } else { MOST * 2.0_f64.powi(-27) };
            assert_close([p[x], p[y], p[z]], [point[0], point[1], height], tolerance, "point");
        }
    }
    // The same in `f64`, where the unit of `t` is 1/8.
    let ball = Shape::new(Sphere::new(0.1_f64).unwrap());
    let ray = ray([-1e15, 0.095, 0.0], [1.0, 0.0, 0.0]);
    let hit = ball.nearest(&ray).expect("a hit");
    let normal = ball.surface(&ray, &hit).normal().to_f64();
    assert_close(normal, [-0.31224989991992, 0.95, 0.0], MOST * 2.0_f64.powi(-53), "normal in f64");
}

/// A double cone of which the first hit lies at x = 34,776, beyond `I16F16`: its normal was off by .01, and its point
/// infinite. The normals are (x, -slope^2 y, z) of the exact points, made unit; of the point the other coordinates can
/// be told, and x ends at the type's end.
#[test]
fn a_hit_beyond_the_type_has_its_normal_and_a_finite_point() {
    let cone = Shape::new(Cone::double(I16F16::from_bits(424_213)).unwrap());
    let origin = [1_023_577_785, 194_954_568, 11_444_758].map(I16F16::from_bits);
    let along = [-1_056_807_075, -132_908_000, 135_704_734].map(raylet::scalar::Unit::<I16F16>::from_bits);
    let ray = ray(origin, along).with_range(Range::line());
    let normals = [
        [0.1523485992221374, -0.988276107891181, -0.010011937200725669],
        [-0.11726887317613471, -0.988276107891181, 0.09776679372598014],
    ];
    for hits in [cone.hits_at::<Stable>(&ray), cone.hits_at::<Exact>(&ray)] {
        assert_eq!(hits.len(), 2, "{hits:?}");
        for (hit, normal) in hits.iter().zip(normals) {
            let found = cone.surface(&ray, hit).normal().to_f64();
            assert_close(found, normal, MOST * 2.0_f64.powi(-30), "normal");
        }
        let point = cone.surface(&ray, &hits[0]).point();
        assert!(point.to_array().iter().all(|c| Scalar::is_finite(*c)), "{point:?}");
        let unit = MOST * 2.0_f64.powi(-16);
        assert_close(point.to_f64(), [32768.0, 5384.098051250862, -2285.392861043534], unit, "the first point");
        let point = cone.surface(&ray, &hits[1]).point().to_f64();
        assert_close(point, [-3091.2412766990387, 621.7565405396219, 2577.160844739616], unit, "the second point");
    }
}

/// The floor is met at x = 2^126 (1 + cot), beyond `f32`, at a `t` that the type holds.
#[test]
fn a_hit_beyond_f32_has_a_finite_point() {
    let (most, floor) = (2.0_f32.powi(126), Shape::new(Plane::<f32>::new()));
    let ray = Ray::new(Vec3::new(most, most, 0.0), direction([0.9656, -0.26, 0.0])).unwrap();
    let hit = floor.nearest(&ray).expect("t is 3.85 2^126");
    let point = floor.surface(&ray, &hit).point();
    assert!(point.x.is_finite() && point.x >= 2.0_f32.powi(127), "{point:?}");
    assert!(point.y.abs() < most && point.z == 0.0, "{point:?}");
}

/// Unit vector along an exact vector.
fn unit(vector: [Dyadic; 3]) -> [Dyadic; 3] {
    let length = Root::square_root_of(&dot(&vector, &vector)).approximation(140);
    vector.map(|c| Root::quotient(c.mantissa, length.mantissa.clone(), c.exponent - length.exponent).approximation(140))
}

fn off(found: &Dyadic, exact: &Dyadic) -> f64 {
    (found - exact).to_f64().abs()
}

/// The solids that are judged, of every kind of surface.
const JUDGED: [&str; 7] = ["sphere", "capsule", "cylinder capped", "cone capped", "frustum capped", "disc", "triangle"];

/// Compares normals and points, which may be so many units off, with the exact ones; `frame` is the shape's, if it is
/// placed. Returns how many hits were compared.
///
/// The placed normal is the axes' transpose applied to the local gradient; the point is o + t d.
fn judged<S: Number, T: Tier<S>>(subject: &Subject<S>, frame: Option<Frame<S>>, ray: &Ray<S>, most: [f64; 2]) -> usize {
    let (shape, line) = match frame {
        Some(frame) => (subject.shape.placed(frame), line_in(&frame, &subject.solid, ray)),
        None => (subject.shape, exact_line(ray)),
    };
    // A ball has no axes.
    let rows = frame.filter(|_| !matches!(subject.solid, oracle::Solid::Sphere { .. })).map(|frame| axes(&frame));
    let exact = oracle::hits_in_range(&oracle::solve(&subject.solid, &line), &Dyadic::zero(), None);
    let hits = shape.hits_at::<T>(ray);
    let pairs = hits.iter().zip(&exact.hits).filter(|_| hits.len() == exact.hits.len());
    let mut seen = 0;
    for (hit, exact) in pairs.filter(|(hit, exact)| same_part(hit.part, exact.part)) {
        seen += 1;
        let [x, y, z] = oracle::gradient(&subject.solid, exact.part, &exact.t, &line);
        let gradient = match &rows {
            Some(rows) => [0, 1, 2].map(|i| &(&(&x * &rows[0][i]) + &(&y * &rows[1][i])) + &(&z * &rows[2][i])),
            None => [x, y, z],
        };
        let (surface, world) = (shape.surface(ray, hit), exact_line(ray));
        let told = || format!("{}: {ray:?} at {shape:?}: {hit:?}", S::name());
        for (found, exact) in surface.normal().to_array().into_iter().zip(unit(gradient)) {
            let units = off(&S::exact_unit(found), &exact) / component::<S>();
            assert!(units <= most[0], "a normal {units} units off: {}", told());
        }
        let point = [0, 1, 2].map(|axis| world.coordinate_at(&exact.t, axis));
        let largest = point.iter().map(Root::magnitude).max().expect("three coordinates");
        for (found, exact) in surface.point().to_array().into_iter().zip(&point) {
            let units = exact.error_in(&found.exact(), &S::unit_at(&largest));
            assert!(units <= most[1], "a point {units} units off: {}", told());
        }
    }
    seen
}

/// At any distance, unplaced and placed.
fn normals_and_points_are_those_of_the_exact_hit<S: Number, T: Tier<S>>(_: f64) {
    let mut seen = 0;
    for name in JUDGED {
        let (subject, mut random) = (Subject::<S>::new(name), Random(20));
        for round in 0..times(400) {
            let (away, distance) = (random.pick(&[1e1, 1e3, 1e4, 1e6]), random.pick(&[1.0, 1_000.0]));
            let Some(local) = Workload::Away(away).ray(&subject, &mut random) else { continue };
            let frame = any_frame::<S>(&mut random, distance);
            if round % 2 == 0 {
                seen += judged::<S, T>(&subject, None, &local, [MOST; 2]);
            } else {
                let Ok(_) = Vec3::<S>::from_f64(local.origin().to_f64().map(|c| c.abs() + 1_000.0)) else { continue };
                let ray = ray_in(&frame, local.origin().to_f64(), local.direction().to_f64());
                seen += judged::<S, T>(&subject, Some(frame), &ray, [MOST; 2]);
            }
        }
    }
    assert!(seen > 1_000, "{seen} hits");
}

/// A sea of radius 8,000 below the world's origin was met 931 units off the hit: the point was the image of the local
/// one, whose unit is that of 8,000. Here the frame's position takes a hit of the solid next to the world's origin.
fn points_near_the_worlds_origin_have_its_small_units<S: Number, T: Tier<S>>(_: f64) {
    for name in JUDGED {
        let (subject, mut random, mut seen) = (Subject::<S>::new(name), Random(21), 0);
        for _ in 0..times(200) {
            let Some(local) = Workload::Benign.ray(&subject, &mut random) else { continue };
            let Some(hit) = subject.shape.nearest(&local) else { continue };
            let (axes, size) = (any_frame::<S>(&mut random, 0.0), random.pick(&[1e-1, 1e-3]));
            let near = scale(random.direction(), size);
            let image = to_world(&axes, subject.shape.surface(&local, &hit).point().to_f64());
            let position = v(add(near, scale(image, -1.0)));
            let frame = axes.moved_to(position).expect("a position within the budget");
            let along = to_world(&frame, local.direction().to_f64());
            let start = add(near, scale(along, -size * (0.5 + 3.5 * random.unit())));
            let ray = Ray::new(v(start), direction(along)).expect("a small origin");
            // Of the rounded `t`, on solids larger than their radius of curvature: in floats normals 8.3 units off were
            // seen, and points that are far from the world's origin 4.1.
            let most = if S::RELATIVE { [10.0, 5.0] } else { [MOST; 2] };
            seen += judged::<S, T>(&subject, Some(frame), &ray, most);
        }
        assert!(seen > 40, "{name}: {seen} hits");
    }
}

/// x was .3000249: the hit on a ball sheared flat was projected along its surface. With u = 1000 y the ball is
/// (x - u)^2 + u^2 + z^2 = 1, and the ray has x = .3 and z = .1.
#[test]
fn the_point_of_a_sheared_ball_lies_on_the_ray() {
    let columns = [[1.0_f32, 0.0, 0.0], [1.0, 0.001, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
    let ball = Shape::new(Sphere::new(1.0).unwrap()).placed(Affine::new(Vec3::ZERO, columns).unwrap());
    let ray = Ray::new(Vec3::new(0.3, 5.0, 0.1), -UnitVec3::Y).unwrap();
    let hits = ball.hits(&ray);
    assert_eq!(hits.len(), 2, "{hits:?}");
    for (hit, y) in hits.iter().zip([0.0008373863985684883, -0.0005373863723983234]) {
        let point = ball.surface(&ray, hit).point().to_f64();
        // A unit at .3.
        assert_close(point, [0.30000001192092896, y, 0.10000000149011612], MOST * 2.0_f64.powi(-25), "point");
    }
}

/// Coordinates of the ray's first hit, and how far they are from these; u = 0 is u = 1.
fn assert_uv<S: Number>(shape: &Shape<S>, ray: &Ray<S>, [u, v]: [f64; 2], what: &str) {
    let hit = shape.nearest(ray).unwrap_or_else(|| panic!("{what} in {}: no hit", S::name()));
    assert_eq!(hit.part, Part::Side);
    let (found_u, found_v) = shape.surface(ray, &hit).uv();
    let (off_u, off_v) = (found_u.to_f64() - u, found_v.to_f64() - v);
    let close = (off_u - off_u.round()).abs() <= 1e-6 && off_v.abs() <= 1e-6;
    assert!(close, "{what} in {}: ({found_u:?}, {found_v:?}), not ({u}, {v})", S::name());
}

/// v was wrong below 1e-22 and above 1e20. At half the radius above the middle it is (90 + 30) / 180 from pole to pole.
fn a_ball_of_any_size_has_its_coordinates<S: Number>(exponents: &[i32]) {
    for &exponent in exponents {
        let r = n::<S>(libm::ldexp(1.0, exponent));
        let half = n::<S>(libm::ldexp(0.5, exponent));
        let ray = Ray::new(Vec3::new(r, half, S::ZERO), -UnitVec3::X).unwrap();
        let ball = Shape::new(Sphere::new(r).unwrap());
        let what = format!("a ball of 2^{exponent}");
        assert_uv(&ball, &ray, [0.0, 2.0 / 3.0], &what);
        // The upper hemisphere of a capsule without a side.
        let capsule = Primitive::from(Capsule::new(r, S::ZERO).unwrap());
        let hit = Shape::new(capsule).nearest(&ray).expect("a hit");
        let v = Shape::new(capsule).surface(&ray, &hit).uv().1.to_f64();
        assert!((v - 2.0 / 3.0).abs() <= 1e-6, "a capsule of 2^{exponent}: v = {v}");
    }
}

#[test]
fn a_ball_of_any_size_has_its_coordinates_in_floats() {
    a_ball_of_any_size_has_its_coordinates::<f32>(&[-120, -100, -80, -74, -60, -20, 0, 20, 60, 66, 80, 100, 126]);
    a_ball_of_any_size_has_its_coordinates::<f64>(&[-1000, -700, -520, -500, -100, 0, 100, 500, 520, 700, 1022]);
}

/// Was NaN in an affine at 2^126. The corners are (-1, 0, -1), (1, 0, -1) and (-1, 0, 1), so that u = (x + 1) / 2 and v
/// = (z + 1) / 2; a line along the local y axis meets x = -.5, z = 0, however the columns stretch, turn or shear it.
#[test]
fn a_triangle_of_any_size_has_its_coordinates_in_any_placement() {
    let columns = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        [[0.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.125]],
        [[0.5, 0.0, 0.5], [0.0, 1.0, 0.0], [-0.5, 0.0, 0.5]],
        [[0.5, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.25, 0.5]],
    ];
    for exponent in [-100, -40, 0, 40, 100, 126] {
        let p = |[x, y, z]: [f64; 3]| v::<f32>([x, y, z].map(|c| libm::ldexp(c, exponent)));
        let [a, b, c] = [[-1.0, 0.0, -1.0], [1.0, 0.0, -1.0], [-1.0, 0.0, 1.0]].map(p);
        let triangle = Shape::new(Triangle::new(a, b, c).unwrap());
        let (what, down) =
            (format!("a triangle of 2^{exponent}"), Ray::new(p([-0.5, 0.25, 0.0]), -UnitVec3::Y).unwrap());
        assert_uv(&triangle, &down, [0.25, 0.5], &what);
        assert_uv(&triangle.placed(Frame::at(Vec3::ZERO).unwrap()), &down, [0.25, 0.5], &format!("{what} in a frame"));
        for [x, y, z] in columns {
            let start = [0, 1, 2].map(|i| -0.5 * x[i] + 0.25 * y[i]);
            let ray = Ray::new(p(start), direction(y.map(|c| -c))).unwrap();
            let placed = triangle.placed(Affine::new(Vec3::ZERO, [v(x), v(y), v(z)]).unwrap());
            assert_uv(&placed, &ray, [0.25, 0.5], &format!("{what} on {x:?}, {y:?}, {z:?}"));
        }
    }
}

/// Was turned a quarter on flat parts, so that waves on water ran across each other. A solid half as large again has
/// the tangents of the solid itself.
fn tangents_of_an_evenly_stretched_solid_are_its_own<S: Number>() {
    let mut random = Random(31);
    for name in ["sphere", "capsule", "cylinder capped", "cone capped", "frustum capped", "plane", "disc", "triangle"] {
        let (subject, mut seen) = (Subject::<S>::new(name), 0);
        let larger = Affine::stretched(Frame::at(Vec3::ZERO).unwrap(), v([1.5; 3])).unwrap();
        let placed = subject.shape.placed(larger);
        for _ in 0..200 {
            let Some(own) = Workload::Benign.ray(&subject, &mut random) else { continue };
            let Ok(origin) = Vec3::from_f64(own.origin().to_f64().map(|c| 1.5 * c)) else { continue };
            let ray = Ray::new(origin, own.direction()).unwrap();
            let (Some(hit), Some(same)) = (placed.nearest(&ray), subject.shape.nearest(&own)) else { continue };
            if hit.part != same.part {
                continue;
            }
            seen += 1;
            let (found, wanted) =
                (placed.surface(&ray, &hit).tangents(), subject.shape.surface(&own, &same).tangents());
            for (found, wanted) in [(found.0, wanted.0), (found.1, wanted.1)] {
                let apart = found.to_f64().into_iter().zip(wanted.to_f64()).map(|(a, b)| (a - b).abs());
                assert!(apart.fold(0.0, f64::max) < 1e-2, "{name} in {}: {found:?} {wanted:?} at {hit:?}", S::name());
            }
        }
        assert!(seen > 50, "{name}: {seen}");
    }
}

#[test]
fn tangents_of_evenly_stretched_solids_are_their_own() {
    tangents_of_an_evenly_stretched_solid_are_its_own::<f32>();
    tangents_of_an_evenly_stretched_solid_are_its_own::<f64>();
    tangents_of_an_evenly_stretched_solid_are_its_own::<I16F16>();
}
