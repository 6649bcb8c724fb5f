//! The mistakes of well-known articles on ray tracing cylinders and cones, each with a test of the correct mathematics.
//! `docs/errata.md` lists them in the same order.

use raylet::{Capsule, Cone, Crossing, Cylinder, Part, Range, Ray, Sphere, UnitVec3};
use support::cases::{direction, n, summary, v};
use support::exact_types::Exact;

every_type!(
    cap_planes_are_at_the_height_minus_the_origin_over_the_direction,
    a_cone_met_parallel_to_a_generator_has_one_root,
    a_capped_cylinder_met_along_its_axis_is_met_at_both_caps,
    the_smaller_positive_root_is_not_the_nearest_hit_of_a_bounded_solid,
    the_lateral_normal_of_a_cone_is_unit_and_at_the_apex_the_axis,
    the_cylinder_about_y_is_x_squared_plus_z_squared,
    a_point_is_inside_a_cone_by_its_distance_from_the_axis,
    a_is_one_minus_two_dy_squared_for_unit_directions_only,
    there_is_no_hole_at_the_apex,
    a_ray_in_the_plane_of_the_base_meets_the_rim_twice,
    a_hit_of_the_side_next_to_the_rim_has_the_normal_of_the_side,
    u_starts_at_the_x_axis_and_w_grows_with_z,
    v_is_zero_at_the_tip_of_the_cone,
);

const ENTER: Crossing = Crossing::Enter;
const EXIT: Crossing = Crossing::Exit;

fn ray<S: Exact>(origin: [f64; 3], along: [f64; 3]) -> Ray<S> {
    Ray::new(v(origin), direction(along)).expect("the origin is within the budget")
}

/// One unit of the type near 1.
fn unit<S: Exact>() -> f64 {
    S::unit_at(&support::oracle::Root::from(&1.0_f32.exact())).to_f64()
}

fn cap_planes_are_at_the_height_minus_the_origin_over_the_direction<S: Exact>() {
    // From oy = 4 downwards: the cap at y = 1 is 3 away, -(oy + 1) / dy would be 5; the base is 4 away, oy / dy would
    // be -4.
    let can = Cylinder::capped(n::<S>(1.0), n(1.0)).expect("sizes");
    let down = ray([0.25, 4.0, 0.25], [0.0, -1.0, 0.0]);
    assert_eq!(summary(&can.hits(&down)), [(3.0, Part::Top, ENTER), (4.0, Part::Base, EXIT)]);
    let up = ray([0.25, -2.0, 0.25], [0.0, 1.0, 0.0]);
    assert_eq!(summary(&can.hits(&up)), [(2.0, Part::Base, ENTER), (3.0, Part::Top, EXIT)]);
    let cone = Cone::capped(n::<S>(1.0), n(1.0)).expect("sizes");
    assert_eq!(
        summary(&cone.hits(&ray([0.5, 4.0, 0.0], [0.0, -1.0, 0.0]))),
        [(3.0, Part::Top, ENTER), (3.5, Part::Side, EXIT)]
    );
    let frustum = Cone::frustum(n::<S>(2.0), n(1.0), n(1.0)).expect("sizes");
    assert_eq!(
        summary(&frustum.hits(&ray([0.5, -2.0, 0.0], [0.0, 1.0, 0.0]))),
        [(2.0, Part::Base, ENTER), (3.0, Part::Top, EXIT)]
    );
}

fn a_cone_met_parallel_to_a_generator_has_one_root<S: Exact>() {
    // Slope 1, along (1, 1, 0) exactly in every type, from (4, 0, 0): f = (4 + s)^2 - s^2 = 0 at s = -2, t = -2 sqrt 2.
    // Neither a = 0 nor anything else makes it a miss.
    let double = Cone::double(n::<S>(1.0)).expect("slope");
    for (along, expected, crossing) in [
        ([1.0, 1.0, 0.0], -2.0, EXIT),
        ([-1.0, -1.0, 0.0], 2.0, ENTER),
        ([-1.0, 1.0, 0.0], 2.0, ENTER),
        ([1.0, -1.0, 0.0], -2.0, EXIT),
    ] {
        let line = ray::<S>([4.0, 0.0, 0.0], along).with_range(Range::line());
        let hits = double.hits(&line);
        let [hit] = *hits else { panic!("{}: one root, not {hits:?}", S::name()) };
        let exact = expected * std::f64::consts::SQRT_2;
        assert_eq!(hit.crossing, crossing, "{}: {along:?}", S::name());
        assert!((hit.t.to_f64() - exact).abs() <= 8.0 * unit::<S>(), "{}: {hit:?}, exactly {exact}", S::name());
    }
    // One nappe: only where the root lies on it.
    let nappe = Cone::nappe(n::<S>(1.0)).expect("slope");
    assert_eq!(nappe.hits(&ray([4.0, 0.0, 0.0], [-1.0, 1.0, 0.0])).len(), 1);
    assert!(nappe.hits(&ray([4.0, 0.0, 0.0], [-1.0, -1.0, 0.0])).is_empty());
    // A closed cone: in by the root, out by the cap.
    let cone = Cone::capped(n::<S>(1.0), n(4.0)).expect("sizes");
    let parts: Vec<_> = cone.hits(&ray([4.0, 0.0, 0.0], [-1.0, 1.0, 0.0])).iter().map(|hit| hit.part).collect();
    assert_eq!(parts, [Part::Side, Part::Top]);
}

fn a_capped_cylinder_met_along_its_axis_is_met_at_both_caps<S: Exact>() {
    let can = Cylinder::capped(n::<S>(1.0), n(2.0)).expect("sizes");
    for (x, z) in [(0.0, 0.0), (0.5, 0.5), (-0.75, 0.5)] {
        let hits = summary(&can.hits(&ray([x, -1.0, z], [0.0, 1.0, 0.0])));
        assert_eq!(hits, [(1.0, Part::Base, ENTER), (3.0, Part::Top, EXIT)]);
    }
    assert!(can.hits(&ray([1.25, -1.0, 0.0], [0.0, 1.0, 0.0])).is_empty());
    let capsule = Capsule::new(n::<S>(1.0), n(2.0)).expect("sizes");
    let hits = summary(&capsule.hits(&ray([0.0, -3.0, 0.0], [0.0, 1.0, 0.0])));
    assert_eq!(hits, [(2.0, Part::Base, ENTER), (6.0, Part::Top, EXIT)]);
}

fn the_smaller_positive_root_is_not_the_nearest_hit_of_a_bounded_solid<S: Exact>() {
    // Down into an open tube from above its near wall: the infinite wall is crossed at y = 2.5, above the rim, and at
    // y = 0.5, inside. The smaller root is positive and is no hit.
    let along = [2.0, -2.0, 0.0];
    let line = ray::<S>([-2.0, 3.5, 0.0], along);
    let tube = Cylinder::open(n::<S>(1.0), n(2.0)).expect("sizes");
    let hits = tube.hits(&line);
    let [hit] = *hits else { panic!("{}: one crossing, not {hits:?}", S::name()) };
    assert_eq!((hit.part, hit.crossing), (Part::Side, EXIT));
    assert!((hit.t.to_f64() - 3.0 * std::f64::consts::SQRT_2).abs() <= 8.0 * unit::<S>(), "{}: {hit:?}", S::name());
    // Closed, the cap takes the place of the lost root.
    let can = Cylinder::capped(n::<S>(1.0), n(2.0)).expect("sizes");
    let hit = can.nearest(&line).expect("the cap is met");
    assert_eq!((hit.part, hit.crossing), (Part::Top, ENTER));
    assert!((hit.t.to_f64() - 1.5 * std::f64::consts::SQRT_2).abs() <= 8.0 * unit::<S>(), "{}: {hit:?}", S::name());
    // A cone's smaller root lies on the other nappe.
    let cone = Cone::capped(n::<S>(1.0), n(2.0)).expect("sizes");
    let hits = summary(&cone.hits(&ray([0.5, -2.0, 0.0], [0.0, 1.0, 0.0])));
    assert_eq!(hits, [(2.5, Part::Side, ENTER), (4.0, Part::Top, EXIT)]);
}

fn the_lateral_normal_of_a_cone_is_unit_and_at_the_apex_the_axis<S: Exact>() {
    // At (y, y, 0) of the cone of slope 1 the printed normal (x, -y, z) has the length y sqrt 2.
    let cone = Cone::capped(n::<S>(1.0), n(8.0)).expect("sizes");
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for y in [0.25, 1.0, 4.0] {
        let line = ray::<S>([10.0, y, 0.0], [-1.0, 0.0, 0.0]);
        let hit = cone.nearest(&line).expect("the side is met");
        let normal = cone.surface(&line, &hit).normal().to_f64();
        let error = [half, -half, 0.0].iter().zip(normal).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error <= 2.0_f64.powi(-23), "{}: {normal:?}", S::name());
    }
    let line = ray::<S>([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    let hit = cone.nearest(&line).expect("the apex is met");
    assert_eq!(cone.surface(&line, &hit).normal(), -UnitVec3::Y);
}

fn the_cylinder_about_y_is_x_squared_plus_z_squared<S: Exact>() {
    // Read as X^2 + Y^2 the first ray would miss and the second would hit.
    let can = Cylinder::capped(n::<S>(1.0), n(8.0)).expect("sizes");
    let high = summary(&can.hits(&ray([-3.0, 6.0, 0.0], [1.0, 0.0, 0.0])));
    assert_eq!(high, [(2.0, Part::Side, ENTER), (4.0, Part::Side, EXIT)]);
    assert!(can.hits(&ray([-3.0, 0.5, 6.0], [1.0, 0.0, 0.0])).is_empty());
}

fn a_point_is_inside_a_cone_by_its_distance_from_the_axis<S: Exact>() {
    // x^2 + z^2 < y^2 at the start; with Z^2 on the right the first start would be outside, the second inside.
    let nappe = Cone::nappe(n::<S>(1.0)).expect("slope");
    let line = ray::<S>([0.5, 2.0, 0.0], [1.0, 0.0, 0.0]);
    assert!(nappe.contains(line.origin()) && nappe.hits(&line).starts_inside());
    assert_eq!(summary(&nappe.hits(&line)), [(1.5, Part::Side, EXIT)]);
    let line = ray::<S>([0.5, 0.25, 4.0], [0.0, 0.0, 1.0]);
    assert!(!nappe.contains(line.origin()) && !nappe.hits(&line).starts_inside());
    // Below the apex the equation holds as well; one nappe does not.
    assert!(
        !nappe.contains(v([0.0, -1.0, 0.0])) && Cone::double(n::<S>(1.0)).expect("slope").contains(v([0.0, -1.0, 0.0]))
    );
}

fn a_is_one_minus_two_dy_squared_for_unit_directions_only<S: Exact>() {
    // Stretched threefold along y, the local direction of a unit ray is not unit: the ray along (1, -1, 0) / sqrt 2
    // meets the cone x = y / 3 from (4, 0, 0): 4 - s = -s / 3 on the lower nappe, s = 6, below the double cone's apex.
    let stretch =
        raylet::Affine::new(v([0.0, 0.0, 0.0]), [v::<S>([1.0, 0.0, 0.0]), v([0.0, 3.0, 0.0]), v([0.0, 0.0, 1.0])])
            .expect("the matrix has an inverse");
    let shape = raylet::Shape::new(Cone::double(n::<S>(1.0)).expect("slope")).placed(stretch);
    let hits = shape.hits(&ray([4.0, 0.0, 0.0], [-1.0, -1.0, 0.0]));
    // 4 - s = s / 3 at s = 3; and 4 - s = -s / 3 at s = 6.
    let exact = [3.0, 6.0].map(|s: f64| s * std::f64::consts::SQRT_2);
    assert_eq!(hits.len(), 2, "{}: {hits:?}", S::name());
    for (hit, exact) in hits.iter().zip(exact) {
        assert!((hit.t.to_f64() - exact).abs() <= 16.0 * unit::<S>(), "{}: {hit:?}, exactly {exact}", S::name());
    }
    // Directions as stored, longer than one by 2^-20: t shrinks by as much.
    let line = ray::<S>([8.0, 4.0, 0.0], [-1.0, 0.0, 0.0]);
    let long = line.direction().to_f64().map(|c| raylet::scalar::UnitScalar::from_f64(c * (1.0 + 2.0_f64.powi(-21))));
    let long = UnitVec3::<S>::from_components(long).expect("unit within 2^-20");
    let cone = Cone::nappe(n::<S>(1.0)).expect("slope");
    let hit = cone.nearest(&Ray::new(line.origin(), long).expect("origin")).expect("the side is met");
    let exact = 4.0 / (1.0 + 2.0_f64.powi(-21));
    assert!((hit.t.to_f64() - exact).abs() <= 2.0 * unit::<S>(), "{}: {hit:?}, exactly {exact}", S::name());
}

fn there_is_no_hole_at_the_apex<S: Exact>() {
    // Through the apex and as near to it as the type can say.
    let unit = unit::<S>();
    for cone in [Cone::capped(n::<S>(1.0), n(2.0)).expect("sizes"), Cone::nappe(n::<S>(1.0)).expect("slope")] {
        let hits = cone.hits(&ray([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]));
        assert_eq!((hits[0].t.to_f64(), hits[0].part, hits[0].crossing), (1.0, Part::Side, ENTER));
        let across = summary(&cone.hits(&ray([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0])));
        assert_eq!(across, [(1.0, Part::Side, Crossing::Touch)]);
        for k in [1.0, 2.0, 16.0, 256.0] {
            let near = cone.hits(&ray([-1.0, k * unit, 0.0], [1.0, 0.0, 0.0]));
            assert!(
                near.len() == 2 || near.len() == 1 && near[0].crossing == Crossing::Touch,
                "{}: {near:?}",
                S::name()
            );
            let beside = cone.hits(&ray([k * unit, -1.0, 0.0], [0.0, 1.0, 0.0]));
            assert!(!beside.is_empty() && beside[0].crossing == ENTER, "{}: {beside:?}", S::name());
            assert!((beside[0].t.to_f64() - 1.0 - k * unit).abs() <= 2.0 * unit, "{}: {beside:?}", S::name());
        }
    }
}

fn a_ray_in_the_plane_of_the_base_meets_the_rim_twice<S: Exact>() {
    let cone = Cone::capped(n::<S>(1.0), n(1.0)).expect("sizes");
    let hits = cone.hits(&ray([-3.0, 1.0, 0.0], [1.0, 0.0, 0.0]));
    assert_eq!(summary(&hits), [(2.0, Part::Side, ENTER), (4.0, Part::Side, EXIT)]);
}

fn a_hit_of_the_side_next_to_the_rim_has_the_normal_of_the_side<S: Exact>() {
    let cone = Cone::capped(n::<S>(1.0), n(1.0)).expect("sizes");
    for below in [1.0, 4.0, 64.0] {
        let line = ray::<S>([4.0, 1.0 - below * unit::<S>(), 0.0], [-1.0, 0.0, 0.0]);
        let hit = cone.nearest(&line).expect("the side is met");
        let [x, y, _] = cone.surface(&line, &hit).normal().to_f64();
        let half = std::f64::consts::FRAC_1_SQRT_2;
        assert_eq!(hit.part, Part::Side, "{}: {below} units below the rim", S::name());
        assert!((x - half).abs() < 1e-6 && (y + half).abs() < 1e-6, "{}: {x} {y}", S::name());
    }
}

fn u_starts_at_the_x_axis_and_w_grows_with_z<S: Exact>() {
    let cone = Cone::capped(n::<S>(1.0), n(1.0)).expect("sizes");
    let number = raylet::scalar::UnitScalar::to_f64;
    for (from, u, w) in [([4.0, 0.5, 0.0], 0.0, 0.5), ([0.0, 0.5, -4.0], 0.25, 0.25), ([0.0, 0.5, 4.0], 0.75, 0.75)] {
        let line = ray::<S>(from, [-from[0], 0.0, -from[2]]);
        let hit = cone.nearest(&line).expect("the side is met");
        let surface = cone.surface(&line, &hit);
        assert!((number(surface.uv().0) - u).abs() < 1e-4, "{}: u from {from:?}", S::name());
        assert!((number(surface.uvw()[2]) - w).abs() < 1e-4, "{}: w from {from:?}", S::name());
    }
}

fn v_is_zero_at_the_tip_of_the_cone<S: Exact>() {
    let cone = Cone::capped(n::<S>(1.0), n(4.0)).expect("sizes");
    let at = |y: f64| {
        let line = ray::<S>([8.0, y, 0.0], [-1.0, 0.0, 0.0]);
        let hit = cone.nearest(&line).expect("the side is met");
        raylet::scalar::UnitScalar::to_f64(cone.surface(&line, &hit).uv().1)
    };
    assert_eq!([at(1.0), at(2.0), at(3.0)], [0.25, 0.5, 0.75]);
    let line = ray::<S>([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    let tip = cone.nearest(&line).expect("the apex is met");
    assert_eq!(raylet::scalar::UnitScalar::to_f64(cone.surface(&line, &tip).uv().1), 0.0);
}

#[test]
fn a_sphere_far_away_needs_more_than_the_textbook_formula() {
    // Not a mistake of the articles alone: k^2 - a c has nothing left at 4100 away.
    let ball = Sphere::new(1.0_f32).expect("size");
    let hits = ball.hits(&ray([-4100.0, 0.5, 0.0], [1.0, 0.0, 0.0]));
    assert_eq!((hits[0].t, hits[1].t), (4_099.134_f32, 4_100.866_f32));
}
