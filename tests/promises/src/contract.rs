//! Rules 1 to 7 of the contract: over all primitives and over floats and fixed point, at the edges and at random,
//! against exact arithmetic on the same bits.

use raylet::scalar::UnitScalar;
use raylet::{
    Capsule, Cone, Crossing, Cylinder, Disc, Frame, Part, Plane, Range, Ray, Shape, Sphere, Triangle, UnitVec3, Vec3,
};
use support::amount::times;
use support::cases::{
    Case, Kind, Verdict, assert_exact, cases, cases_of, compare, direction, edge_rays, n, random_ray, summary, v,
};
use support::exact_types::{Exact, exact_line};
use support::oracle;
use support::random::Random;

every_type!(
    rule_01_a_bounded_solid_is_closed_and_crossings_pair_up,
    rule_01_no_ray_slips_between_a_cap_and_the_side,
    rule_02_open_surfaces_and_unbounded_solids_report_the_ends_that_they_have,
    rule_03_a_closed_range_drops_the_ends_outside_and_knows_a_start_inside,
    rule_03_a_distance_that_the_type_cannot_hold_is_outside_every_range,
    rule_04_t_is_the_parameter_of_the_direction_as_stored,
    rule_05_the_side_owns_the_rim_the_seam_and_the_apex,
    rule_06_degenerate_rays_have_the_exact_answer,
    rule_07_normals_point_outwards_and_the_flipped_one_towards_the_ray,
);

/// How far apart two ends must be for `Stable` to tell them apart in the workloads of this file (coordinates up to 8);
/// grazing rays, where an error of `e` in the discriminant moves the ends by `sqrt(e)`, decide it.
fn tie<S: Exact>() -> f64 {
    match S::name().as_str() {
        "f32" => 2.0_f64.powi(-9),
        "f64" => 2.0_f64.powi(-23),
        "I16F16" => 2.0_f64.powi(-13),
        _ => 2.0_f64.powi(-29),
    }
}

/// Every ray of the list has the exact hits, but for the ties.
fn assert_like_exact<S: Exact>(case: &Case<S>, rays: impl Iterator<Item = (Ray<S>, bool)>) {
    let (mut all, mut ties) = (0, 0);
    for (ray, exact) in rays {
        let hits = case.shape().hits(&ray);
        all += 1;
        match compare(case, &ray, &hits, if exact { 0.0 } else { tie::<S>() }) {
            Verdict::Same(_) => {}
            Verdict::Tie => ties += 1,
            Verdict::Wrong(message) => panic!("{message}"),
        }
        assert!(hits.windows(2).all(|pair| pair[0].t <= pair[1].t), "{}: unsorted {hits:?}", case.name);
        assert_eq!(case.shape().nearest(&ray), hits.first().copied(), "{}: {ray:?}", case.name);
        assert_eq!(case.shape().occludes(&ray), !hits.is_empty(), "{}: {ray:?}", case.name);
    }
    let random = all == 4000;
    // Edge rays are full of exact ties along rounded diagonals; random rays are not.
    assert!(ties * if random { 100 } else { 8 } <= all, "{} in {}: {ties} of {all} excused", case.name, S::name());
}

pub(crate) fn random_rays<S: Exact>(seed: u64, count: usize) -> impl Iterator<Item = (Ray<S>, bool)> {
    let mut random = Random(seed);
    std::iter::repeat_with(move || (random_ray::<S>(&mut random), false)).take(count)
}

fn crossings<S: Exact>(case: &Case<S>, ray: &Ray<S>) -> Vec<Crossing> {
    case.shape().hits(ray).iter().map(|hit| hit.crossing).collect()
}

fn rule_01_a_bounded_solid_is_closed_and_crossings_pair_up<S: Exact>() {
    for case in cases_of::<S>(Kind::Bounded) {
        let edges = edge_rays(&case);
        for (ray, _) in edges.iter().copied().chain(random_rays(1, 20000)) {
            let ray = ray.with_range(Range::line());
            let list = crossings(&case, &ray);
            let paired = matches!(list.as_slice(), [] | [Crossing::Touch] | [Crossing::Enter, Crossing::Exit]);
            assert!(paired, "{} in {}: {list:?} for {ray:?}", case.name, S::name());
        }
        assert_like_exact(&case, edges.into_iter());
        assert_like_exact(&case, random_rays(2, 4000));
    }
    for case in cases_of::<S>(Kind::NotConvex) {
        let edges = edge_rays(&case);
        for (ray, _) in edges.iter().copied().chain(random_rays(1, 20000)) {
            let mut list = crossings(&case, &ray.with_range(Range::line()));
            list.retain(|crossing| *crossing != Crossing::Touch);
            let are_paired = list.chunks(2).all(|pair| *pair == [Crossing::Enter, Crossing::Exit]);
            assert!(are_paired && list.len() <= 4, "{} in {}: {list:?} for {ray:?}", case.name, S::name());
        }
        assert_like_exact(&case, edges.into_iter());
        assert_like_exact(&case, random_rays(2, 4000));
    }
}

fn rule_01_no_ray_slips_between_a_cap_and_the_side<S: Exact>() {
    // From everywhere through points just inside every rim and seam; a unit or so inside is not for the type to decide.
    let inset = 2.0_f64.powi(-12);
    for case in cases_of::<S>(Kind::Bounded) {
        let mut random = Random(3);
        for (seam, radius) in case.seams.iter().zip(case.radii.iter().cycle()) {
            for _ in 0..times(2000) {
                let turn = random.unit() * std::f64::consts::TAU;
                let target = [
                    radius * (1.0 - inset) * turn.cos(),
                    if *seam == 0.0 { inset } else { seam - inset },
                    radius * (1.0 - inset) * turn.sin(),
                ];
                if !case.shape().contains(v(target)) {
                    continue;
                }
                let away = random.unit_vector::<S>().to_f64();
                let distance = random.between(4.0, 30.0);
                let from = [0, 1, 2].map(|i| target[i] - away[i] * distance);
                let ray = Ray::towards(v::<S>(from), v(target)).expect("the points are within the budget");
                let list = crossings(&case, &ray);
                // An inset as small as this may be all that is left of the chord.
                let met = matches!(list.as_slice(), [Crossing::Enter, Crossing::Exit] | [Crossing::Touch]);
                assert!(met, "{} in {}: {list:?} for {ray:?}", case.name, S::name());
            }
        }
    }
}

fn rule_02_open_surfaces_and_unbounded_solids_report_the_ends_that_they_have<S: Exact>() {
    for case in cases_of::<S>(Kind::Open).into_iter().chain(cases_of(Kind::Unbounded)) {
        assert_like_exact(&case, edge_rays(&case).into_iter());
        assert_like_exact(&case, random_rays::<S>(4, 4000).map(|(ray, _)| (ray.with_range(Range::line()), false)));
        for (ray, _) in edge_rays(&case) {
            if case.kind == Kind::Open {
                assert!(!case.shape().hits(&ray).starts_inside(), "{}: an open surface has no inside", case.name);
            }
        }
    }
    // Up through a tube's lower end: the one crossing is of the wall, from inside.
    let tube = Cylinder::open(n::<S>(1.0), n(2.0)).expect("sizes");
    let ray = Ray::new(v::<S>([0.0, -1.0, 0.0]), direction([1.0, 2.0, 0.0])).expect("origin");
    let hits = tube.hits(&ray);
    assert_eq!(hits.iter().map(|hit| (hit.part, hit.crossing)).collect::<Vec<_>>(), [(Part::Side, Crossing::Exit)]);
    // A double cone, across both nappes: out of one, into the other, with no end beyond.
    let double = Cone::double(n::<S>(1.0)).expect("sizes");
    let ray = Ray::new(v::<S>([1.0, -4.0, 0.0]), UnitVec3::Y).expect("origin").with_range(Range::line());
    assert_eq!(summary(&double.hits(&ray)), [(3.0, Part::Side, Crossing::Exit), (5.0, Part::Side, Crossing::Enter)]);
    // Four hits at most, from outside both.
    let nappe = Cone::nappe(n::<S>(1.0)).expect("sizes");
    assert_eq!(summary(&nappe.hits(&ray)), [(5.0, Part::Side, Crossing::Enter)]);
}

fn rule_03_a_closed_range_drops_the_ends_outside_and_knows_a_start_inside<S: Exact>() {
    let mut random = Random(5);
    for case in cases::<S>() {
        let rays = random_rays::<S>(6, 2000).chain(edge_rays(&case).into_iter().step_by(5));
        for (ray, _) in rays {
            let whole = case.shape().hits(&ray.with_range(Range::line()));
            // Ends at random, and exactly at hits: the range is closed.
            let mut ends = vec![n::<S>(random.between(-2.0, 6.0)), n(random.between(-2.0, 6.0)), S::ZERO];
            ends.extend(whole.iter().map(|hit| hit.t));
            let (a, b) = (random.pick(&ends), random.pick(&ends));
            let range = if a <= b { Range::new(a, b) } else { Range::new(b, a) }.expect("the ends are in order");
            let hits = case.shape().hits(&ray.with_range(range));
            let kept: Vec<_> = whole.iter().filter(|hit| range.contains(hit.t)).copied().collect();
            assert_eq!(hits.to_vec(), kept, "{} in {}: {range:?} of {ray:?}", case.name, S::name());
            if case.kind == Kind::Bounded {
                let inside = matches!(*whole, [enter, exit] if enter.t < range.start() && range.start() <= exit.t);
                assert_eq!(hits.starts_inside(), inside, "{} in {}: {range:?} of {ray:?}", case.name, S::name());
                let lone_exit = hits.first().is_some_and(|hit| hit.crossing == Crossing::Exit);
                assert!(!lone_exit || inside || hits[0].t == range.start(), "{}: a lone exit", case.name);
            }
            assert_eq!(case.shape().nearest(&ray.with_range(range)), hits.first().copied());
            // And as exact arithmetic has it, where no end is within a tie of the range.
            if let Verdict::Wrong(message) = compare(&case, &ray.with_range(range), &hits, tie::<S>()) {
                panic!("{message}");
            }
        }
    }
    // By default forward: [0, MAX].
    let ball = Sphere::new(n::<S>(1.0)).expect("size");
    let ray = Ray::new(v::<S>([0.0, 0.0, 0.5]), UnitVec3::Z).expect("origin");
    assert_eq!(summary(&ball.hits(&ray)), [(0.5, Part::Side, Crossing::Exit)]);
    assert!(ball.hits(&ray).starts_inside());
    // On the surface: that is a hit at zero, not a start inside.
    let ray = Ray::new(v::<S>([0.0, 0.0, -1.0]), UnitVec3::Z).expect("origin");
    assert_eq!(summary(&ball.hits(&ray)), [(0.0, Part::Side, Crossing::Enter), (2.0, Part::Side, Crossing::Exit)]);
    assert!(!ball.hits(&ray).starts_inside());
    // A range from the last point of the solid on.
    let range = Range::new(n::<S>(2.0), n(3.0)).expect("the ends are in order");
    let hits = ball.hits(&ray.with_range(range));
    assert_eq!(summary(&hits), [(2.0, Part::Side, Crossing::Exit)]);
    assert!(hits.starts_inside());
}

fn rule_03_a_distance_that_the_type_cannot_hold_is_outside_every_range<S: Exact>() {
    // Down at a plane so slantwise that the crossing is beyond the type; and one that it still holds.
    let most = S::BUDGET.coordinate;
    let ray = |y: S, rise: f64| {
        let along = [1.0, rise, 0.0].map(<S::Unit as UnitScalar>::from_f64);
        let along = UnitVec3::from_components(along).expect("the direction is unit");
        Ray::new(Vec3::new(S::ZERO, y, S::ZERO), along).expect("the origin is at the budget").with_range(Range::line())
    };
    let plane = Plane::new();
    assert!(plane.hits(&ray(most, -(2.0_f64.powi(-29)))).is_empty(), "{}", S::name());
    assert!(plane.nearest(&ray(most, -(2.0_f64.powi(-29)))).is_none());
    assert!(!plane.occludes(&ray(most, -(2.0_f64.powi(-29))).with_range(Range::FORWARD)), "{}", S::name());
    assert_eq!(plane.hits(&ray(n(0.25), -(2.0_f64.powi(-11)))).len(), 1);
    // A cylinder, left at an end that cannot be held: inside all the same.
    let tube = Cylinder::infinite(most).expect("the radius is at the budget");
    let up = [2.0_f64.powi(-29), 1.0, 0.0].map(<S::Unit as UnitScalar>::from_f64);
    let up = UnitVec3::from_components(up).expect("the direction is unit");
    let ray = Ray::new(Vec3::ZERO, up).expect("origin");
    let hits = tube.hits(&ray);
    assert!(!tube.occludes(&ray), "{}", S::name());
    assert!(hits.is_empty() && hits.starts_inside(), "{}: {hits:?}", S::name());
}

fn rule_04_t_is_the_parameter_of_the_direction_as_stored<S: Exact>() {
    // Longer and shorter than one by nearly 2^-20, as much as is let in: t is that of the bits, not that of the unit
    // vector which they nearly are. With a = 1 the median would be 6 units in `f32`, and 2^6 and more elsewhere.
    let mut random = Random(7);
    for case in cases_of::<S>(Kind::Bounded) {
        for scale in [1.0 - 0.8 * 2.0_f64.powi(-20), 1.0 + 0.8 * 2.0_f64.powi(-20)] {
            let mut errors = vec![];
            for _ in 0..times(400) {
                let ray = random_ray::<S>(&mut random);
                let off = ray.direction().to_f64().map(|c| <S::Unit as UnitScalar>::from_f64(c * scale));
                let stored = UnitVec3::from_components(off).expect("unit within 2^-20");
                let ray = Ray::new(ray.origin(), stored).expect("origin");
                let hits = case.shape().hits(&ray);
                match compare(&case, &ray, &hits, tie::<S>()) {
                    Verdict::Same(error) if !hits.is_empty() => errors.push(error),
                    Verdict::Same(_) | Verdict::Tie => {}
                    Verdict::Wrong(message) => panic!("{message}"),
                }
            }
            errors.sort_by(f64::total_cmp);
            // The worse of the two ends; one alone has 0.25 in fixed point and about 0.4 in floats.
            let (median, bound) = (errors[errors.len() / 2], if S::name().starts_with('I') { 0.5 } else { 1.5 });
            assert!(errors.len() > 100 && median <= bound, "{} in {}: {median} units", case.name, S::name());
        }
    }
}

#[test]
fn rule_04_directions_of_any_length_are_exact_in_floats() {
    for length in [1e-44_f32, 1e-38, 1e-20, 1.0, 1e20, 1e38] {
        let along = UnitVec3::new(Vec3::new(0.0, length, 0.0)).expect("the vector has a length");
        assert_eq!(along, UnitVec3::Y, "{length}");
        let along = UnitVec3::new(Vec3::new(length, -length, 0.0)).expect("the vector has a length");
        let half = std::f32::consts::FRAC_1_SQRT_2;
        assert!((along.x() - half).abs() <= f32::EPSILON / 2.0 && along.y() == -along.x(), "{length}: {along:?}");
    }
    for length in [5e-324_f64, 1e-300, 1e-20, 1e20, 1e300] {
        assert_eq!(UnitVec3::new(Vec3::new(0.0, 0.0, -length)), Ok(-UnitVec3::Z), "{length}");
    }
}

#[test]
fn rule_04_a_plane_is_met_as_exactly_far_out_as_near() {
    // A hair above the floor, ten thousand from its origin: the distance is that of the hair.
    let floor = cases::<f32>().into_iter().find(|case| case.name == "plane").expect("a plane");
    for (x, y) in [(1e4, 1e-3), (1e4, 1.0), (-3e6, 1e-6), (0.0, 1e-3)] {
        let ray = Ray::new(v::<f32>([x, y, -x]), direction([-0.6, -0.8, 0.0])).expect("origin");
        let verdict = compare(&floor, &ray, &floor.shape().hits(&ray), 0.0);
        assert!(matches!(verdict, Verdict::Same(error) if error <= 0.5), "{ray:?}: {verdict:?}");
        let placed = floor.shape().placed(Frame::at(Vec3::ZERO).expect("position"));
        assert_eq!(placed.hits(&ray), floor.shape().hits(&ray));
    }
}

#[test]
fn rule_04_hit_or_miss_stays_right_at_ten_thousand_away() {
    // Putting a = 1 gets 4 of 10 of these wrong.
    let (ball, solid) = (Sphere::new(1.0_f32).expect("size"), oracle::Solid::Sphere { radius: 1.0_f32.exact() });
    let mut random = Random(8);
    let mut hit = 0;
    for _ in 0..times(4000) {
        let away = random.unit_vector::<f32>();
        let from = away.to_f64().map(|c| c * 1e4);
        let aim: [f64; 3] = [(); 3].map(|()| random.between(-1.0, 1.0));
        let ray = Ray::new(v::<f32>(from), direction([0, 1, 2].map(|i| aim[i] - from[i]))).expect("origin");
        let margin = oracle::margin(&solid, &exact_line(&ray)).expect("a sphere has a margin");
        if (margin - 1.0).abs() > 1e-5 {
            hit += usize::from(margin < 1.0);
            assert_eq!(ball.occludes(&ray), margin < 1.0, "{ray:?}: margin {margin}");
        }
    }
    let (least, most) = (times(1000) as usize, times(3500) as usize);
    assert!((least..most).contains(&hit), "the workload has both hits and misses: {hit}");
}

fn rule_05_the_side_owns_the_rim_the_seam_and_the_apex<S: Exact>() {
    let shoot = |shape: Shape<S>, from: [f64; 3], along: [f64; 3]| {
        let ray = Ray::new(v::<S>(from), direction(along)).expect("origin");
        summary(&shape.hits(&ray))
    };
    let side = |t: f64, crossing| (t, Part::Side, crossing);
    let (x, down) = ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0]);
    let capsule = Shape::new(Capsule::new(n::<S>(1.0), n(2.0)).expect("sizes"));
    let can = Shape::new(Cylinder::capped(n::<S>(1.0), n(2.0)).expect("sizes"));
    let cone = Shape::new(Cone::capped(n::<S>(0.5), n(2.0)).expect("sizes"));
    let frustum = Shape::new(Cone::frustum(n::<S>(1.0), n(0.5), n(2.0)).expect("sizes"));
    for y in [0.0, 2.0] {
        // In a cap's plane, or through the seam with a hemisphere: in and out of the side.
        for shape in [capsule, can] {
            let expected = [side(2.0, Crossing::Enter), side(4.0, Crossing::Exit)];
            assert_eq!(shoot(shape, [-3.0, y, 0.0], x), expected, "y = {y}");
        }
    }
    assert_eq!(shoot(frustum, [-3.0, 0.0, 0.0], x), [side(2.0, Crossing::Enter), side(4.0, Crossing::Exit)]);
    assert_eq!(shoot(frustum, [-3.0, 2.0, 0.0], x), [side(2.5, Crossing::Enter), side(3.5, Crossing::Exit)]);
    assert_eq!(shoot(cone, [-3.0, 2.0, 0.0], x), [side(2.0, Crossing::Enter), side(4.0, Crossing::Exit)]);
    // The apex: a touch across it, an entry along the axis.
    assert_eq!(shoot(cone, [-3.0, 0.0, 0.0], x), [side(3.0, Crossing::Touch)]);
    let through = [(1.0, Part::Top, Crossing::Enter), side(3.0, Crossing::Exit)];
    assert_eq!(shoot(cone, [0.0, 3.0, 0.0], down), through);
    // Down in the wall of a can: the rims at both ends.
    let wall = [side(1.0, Crossing::Enter), side(3.0, Crossing::Exit)];
    assert_eq!(
        shoot(can, [1.0, 3.0, 0.0], down).iter().map(|hit| (hit.0, hit.2)).collect::<Vec<_>>(),
        [(wall[0].0, wall[0].2), (wall[1].0, wall[1].2)]
    );
    // As the oracle has it, with the parts.
    for case in cases_of::<S>(Kind::Bounded) {
        for (ray, exact) in edge_rays(&case) {
            if exact {
                assert_exact(&case, &ray);
            }
        }
    }
    // The apex's normal is the axis, pointing away from the body.
    let ray = Ray::new(v::<S>([0.0, -1.0, 0.0]), UnitVec3::Y).expect("origin");
    let hit = cone.nearest(&ray).expect("the apex is met");
    assert_eq!((hit.t.to_f64(), cone.surface(&ray, &hit).normal()), (1.0, -UnitVec3::Y));
    let spire = Shape::new(Cone::frustum(n::<S>(1.0), S::ZERO, n(2.0)).expect("sizes"));
    let ray = Ray::new(v::<S>([0.0, 3.0, 0.0]), -UnitVec3::Y).expect("origin");
    let hit = spire.nearest(&ray).expect("the apex is met");
    assert_eq!((hit.t.to_f64(), hit.part, spire.surface(&ray, &hit).normal()), (1.0, Part::Side, UnitVec3::Y));
}

fn rule_06_degenerate_rays_have_the_exact_answer<S: Exact>() {
    // Each of these is exact in every type, so that nothing is excused; the numbers are those of the rules.
    let shoot = |shape: Shape<S>, from: [f64; 3], along: UnitVec3<S>| {
        let ray = Ray::new(v::<S>(from), along).expect("origin").with_range(Range::line());
        let hits = shape.hits(&ray);
        (summary(&hits), hits.coincident().map(|range| (range.start().to_f64(), range.end().to_f64())))
    };
    let miss = (vec![], None);
    let y = UnitVec3::Y;
    let (enter, exit) = (Crossing::Enter, Crossing::Exit);
    // Parallel to the axis: inside, exactly in the wall, just outside.
    let unit = S::unit_at(&oracle::Root::from(&1.0_f32.exact())).to_f64();
    let can = Shape::new(Cylinder::capped(n::<S>(1.0), n(2.0)).expect("sizes"));
    let tube = Shape::new(Cylinder::open(n::<S>(1.0), n(2.0)).expect("sizes"));
    let pipe = Shape::new(Cylinder::infinite(n::<S>(1.0)).expect("sizes"));
    let capsule = Shape::new(Capsule::new(n::<S>(1.0), n(2.0)).expect("sizes"));
    let caps = vec![(1.0, Part::Base, enter), (3.0, Part::Top, exit)];
    assert_eq!(shoot(can, [0.5, -1.0, 0.0], y), (caps, None));
    assert_eq!(shoot(can, [1.0, -1.0, 0.0], y).0.len(), 2);
    assert_eq!(shoot(can, [1.0 + unit, -1.0, 0.0], y), miss);
    assert_eq!(shoot(tube, [0.5, -1.0, 0.0], y), miss);
    assert_eq!(shoot(tube, [1.0, -1.0, 0.0], y), (vec![], Some((1.0, 3.0))));
    assert_eq!(shoot(tube, [1.0 + unit, -1.0, 0.0], y), miss);
    assert_eq!(shoot(pipe, [0.5, -1.0, 0.0], y), miss);
    let far = S::BUDGET.distance.to_f64();
    assert_eq!(shoot(pipe, [0.0, -1.0, -1.0], y), (vec![], Some((-far, far))));
    let seams = vec![(1.0, Part::Side, enter), (3.0, Part::Side, exit)];
    assert_eq!(shoot(capsule, [1.0, -1.0, 0.0], y), (seams, None));
    assert_eq!(shoot(capsule, [1.0 + unit, -1.0, 0.0], y), miss);
    // In the plane of a cap.
    let across = vec![(2.0, Part::Side, enter), (4.0, Part::Side, exit)];
    assert_eq!(shoot(can, [-3.0, 2.0, 0.0], UnitVec3::X), (across, None));
    assert_eq!(shoot(can, [-3.0, 2.0, 0.0], -UnitVec3::Z), miss);
    // In a plane, a disc, a triangle.
    let z = UnitVec3::Z;
    let plane = Shape::new(Plane::new());
    assert_eq!(shoot(plane, [1.0, 0.0, 1.0], z), (vec![], Some((-far, far))));
    assert_eq!(shoot(plane, [1.0, unit, 1.0], z), miss);
    let disc = Shape::new(Disc::new(n::<S>(1.5)).expect("size"));
    assert_eq!(shoot(disc, [0.0, 0.0, 1.0], z), (vec![], Some((-2.5, 0.5))));
    assert_eq!(shoot(disc, [2.0, 0.0, 1.0], z), miss);
    let [a, b, c] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]].map(v::<S>);
    let triangle = Shape::new(Triangle::new(a, b, c).expect("vertices"));
    assert_eq!(shoot(triangle, [0.5, 0.0, -1.0], z), (vec![], Some((1.0, 2.5))));
    assert_eq!(shoot(triangle, [2.5, 0.0, -1.0], z), miss);
    // Starting on the surface, inwards and outwards.
    let ball = Shape::new(Sphere::new(n::<S>(1.0)).expect("size"));
    let through = vec![(0.0, Part::Side, enter), (2.0, Part::Side, exit)];
    assert_eq!(shoot(ball, [0.0, -1.0, 0.0], y), (through, None));
    let tangent = vec![(0.0, Part::Side, Crossing::Touch)];
    assert_eq!(shoot(ball, [0.0, -1.0, 0.0], z), (tangent, None));
    // Parallel to a generator (3-4-5, to the type's last bit): one root, not none.
    let cone = Shape::new(Cone::double(n::<S>(0.75)).expect("size"));
    let one = Ray::new(v::<S>([1.5, 0.0, 0.0]), direction([3.0, 4.0, 0.0])).expect("origin").with_range(Range::line());
    let hits = cone.hits(&one);
    assert!(hits.iter().any(|hit| (hit.t.to_f64() + 1.25).abs() < 2.0 * unit), "{}: {hits:?}", S::name());
    // Along a diagonal generator, which every type holds exactly as (h, h): the cone of slope 1.
    for case in cases::<S>() {
        for (ray, _) in edge_rays(&case) {
            let [dx, dy, dz] = ray.direction().to_array();
            let zero = <S::Unit as UnitScalar>::ZERO;
            // Two equal components: the ray runs along a generator, or parallel to one, exactly.
            let diagonal = dz == zero && dx != zero && dy != zero || dx == zero && dz != zero && dy != zero;
            if diagonal && matches!(case.name, "nappe" | "open cone") {
                assert_exact(&case, &ray);
            }
            let hits = case.shape().hits(&ray);
            assert!(hits.iter().all(|hit| hit.t.is_finite()), "{}: {hits:?}", case.name);
        }
    }
}

fn rule_07_normals_point_outwards_and_the_flipped_one_towards_the_ray<S: Exact>() {
    for case in cases::<S>() {
        let shape = case.shape();
        for (ray, _) in random_rays::<S>(9, 5000) {
            for hit in &shape.hits(&ray) {
                let normal = shape.surface(&ray, hit).normal();
                let [x, y, z] = normal.to_f64();
                assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6, "{}: {normal:?}", case.name);
                let along = ray.direction().dot(normal);
                // Rays from outside meet the outward normal, rays from inside run along it; a grazing one may do
                // either.
                let [dx, dy, dz] = ray.direction().to_f64();
                let cosine = dx * x + dy * y + dz * z;
                if cosine.abs() > 0.02 {
                    let against = cosine < 0.0;
                    assert_eq!(
                        hit.crossing == Crossing::Enter,
                        against,
                        "{} in {}: {ray:?} {hit:?}",
                        case.name,
                        S::name()
                    );
                }
                let flipped = shape.surface(&ray, hit).normal_towards_ray();
                let zero = <S::Real as raylet::scalar::Ring>::ZERO;
                assert!(ray.direction().dot(flipped) <= zero, "{}: {along:?}", case.name);
                assert!(flipped == normal || flipped == -normal);
            }
        }
    }
}

/// A hit on the case somewhere, from outside or from inside; its shape placed or not.
pub(crate) fn some_hits<S: Exact>(
    case: &Case<S>,
    random: &mut Random,
    count: usize,
    mut each: impl FnMut(&Shape<S>, &Ray<S>, &raylet::Hit<S>, &mut Random),
) {
    let frame = Frame::from_base_and_axis(v([2.0, -1.0, 3.0]), direction([1.0, 2.0, -2.0])).expect("position");
    let placed = case.shape().placed(frame);
    let mut found = 0;
    for _ in 0..count * 10 {
        let ray = random_ray::<S>(random);
        let turned = Ray::new(frame.point_to_world(ray.origin()), frame.direction_to_world(ray.direction()));
        for (shape, ray) in [(case.shape(), ray), (placed, turned.expect("origin"))] {
            for hit in &shape.hits(&ray) {
                each(&shape, &ray, hit, random);
                found += 1;
            }
        }
        if found >= count {
            return;
        }
    }
    panic!("{} in {}: too few hits", case.name, S::name());
}

/// A direction, and the cosine to a normal.
pub(crate) fn off<S: Exact>(normal: UnitVec3<S>, random: &mut Random) -> (UnitVec3<S>, f64) {
    let ([x, y, z], any) = (normal.to_f64(), random.unit_vector::<S>());
    // Every fourth nearly along the surface, where an epsilon would fail.
    let squash = if random.below(4) == 0 { random.between(0.99, 1.0) } else { 0.0 };
    let [dx, dy, dz] = any.to_f64();
    let along = (dx * x + dy * y + dz * z) * squash;
    let any = direction::<S>([dx - along * x, dy - along * y, dz - along * z]);
    let [dx, dy, dz] = any.to_f64();
    (any, dx * x + dy * y + dz * z)
}

#[test]
fn rule_07_where_a_ray_touches_the_normal_towards_it_is_the_outward_one() {
    let ball = Sphere::new(1.0_f32).expect("a size");
    let ray = Ray::new(Vec3::new(-5.0, 1.0, 0.0), UnitVec3::X).expect("inside the budget");
    let hits = ball.hits(&ray);
    assert_eq!(hits.iter().map(|hit| hit.crossing).collect::<Vec<_>>(), [Crossing::Touch]);
    assert_eq!(ball.surface(&ray, &hits[0]).normal_towards_ray(), UnitVec3::Y);
}
